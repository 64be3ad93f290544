"""Typed infix -> display tree: a Pratt parser for problem files and answers.

Nothing is evaluated; a name means what the problem says, never a constant or function of some
library. Products may be implied (`2 ell`, `m g ell`, `3(x + 1)`); what can be read in two ways
(`g/4 ell`) is refused with a sentence.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType

from rbpsym.errors import Place, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix_grammar import expression
from rbpsym.expr.infix_names import FUNCTIONS, InfixReader, tokenize
from rbpsym.expr.source import SourceText
from rbpsym.frozen import Frozen, replace

MOST_WAYS = 32
RELATION_SIGNS = ("=", "<", ">", "<=", ">=", "!=", "~")


def read_infix(
    text: str,
    symbols: Iterable[str],
    *,
    functions: Mapping[str, Callable[[t.Node], t.Node]] = FUNCTIONS,
    aliases: Mapping[str, str] = MappingProxyType({}),
    place: Place | None = None,
) -> t.Node:
    """The tree of a typed expression; every node has its `span` in `text`.

    `symbols` are the names of the problem (pi is always known); `aliases` gives other names for
    them (`omega` for `theta_dot`); `place` is where the text stands in a file. Raises ReadError
    with a caret, LimitError.
    """
    reader = _reader(text, symbols, functions, aliases, place)
    node = expression(reader)
    if reader.token.kind != "end":
        raise _left_over(reader)
    return reader.source.bounded(node, len(text))


def read_relation(
    text: str,
    symbols: Iterable[str],
    *,
    functions: Mapping[str, Callable[[t.Node], t.Node]] = FUNCTIONS,
    aliases: Mapping[str, str] = MappingProxyType({}),
    place: Place | None = None,
) -> t.Chain:
    """The chain of a typed relation `a = b`, `a < b <= c`. Raises as `read_infix`."""
    reader = _reader(text, symbols, functions, aliases, place)
    found = _whole(reader)
    if not isinstance(found, t.Chain):
        raise reader.error("a relation is expected here", "Write left = right, or <, >, <=, >=.")
    return reader.source.bounded(replace(found, span=(0, len(text))), len(text))


class Ways(Frozen):
    """The trees that a text can be read as, the usual one first, and the error of the first place that is not clear.

    parted: for each tree, what was chosen at the places that decide what is multiplied and what divided.
    """

    trees: tuple[t.Node, ...]
    error: RbpsymError | None
    parted: tuple[tuple[bool, ...], ...]


def read_ways(text: str, symbols: Iterable[str], *, functions: Mapping[str, Callable[[t.Node], t.Node]] = FUNCTIONS) -> Ways:
    """All readings of a typed expression or relation that can be read in several ways. Raises as `read_infix`.

    Where these are too many, only what has no usual reading is read in several.
    """
    for plain in (False, True):
        trees: list[t.Node] = []
        waiting: list[tuple[bool, ...]] = [()]
        error, parted = None, list[tuple[bool, ...]]()
        while waiting and len(trees) + len(waiting) <= MOST_WAYS:
            script = waiting.pop(0)
            reader = _reader(text, symbols, functions, MappingProxyType({}), None)
            reader.script, reader.plain = script, plain
            trees.append(reader.source.bounded(_whole(reader), len(text)))
            error = error or next(iter(reader.met), None)
            parted.append(reader.parted)
            chosen = (*script, *(False,) * (len(reader.met) - len(script)))
            waiting += [(*chosen[:place], True) for place in range(len(script), len(chosen))]
        if not waiting:
            return Ways(tuple(trees), error, tuple(parted))
    assert error is not None  # there were several ways
    raise error


def _whole(reader: InfixReader) -> t.Node:
    """The expression or relation that a text is."""
    items, ops = [expression(reader)], list[str]()
    while reader.sees(*RELATION_SIGNS):
        ops.append(reader.take().text)
        items.append(expression(reader))
    if reader.token.kind != "end":
        raise _left_over(reader)
    return t.Chain(tuple(items), tuple(ops)) if ops else items[0]


def _reader(
    text: str,
    symbols: Iterable[str],
    functions: Mapping[str, Callable[[t.Node], t.Node]],
    aliases: Mapping[str, str],
    place: Place | None,
) -> InfixReader:
    source = SourceText(text, place)
    known = frozenset(symbols) | {"pi"}
    return InfixReader(source, tokenize(source), symbols=known, functions=functions, aliases=aliases)


def _left_over(reader: InfixReader) -> RbpsymError:
    token = reader.token
    if reader.sees(*RELATION_SIGNS):
        return reader.error(f"“{token.text}” makes a relation, but an expression is expected")
    if reader.sees(")"):
        return reader.error("this parenthesis was never opened", "Remove it, or add a “(”.")
    return reader.error(f"“{token.text}” is not expected here")
