"""LaTeX tokens -> relations: a = b = c, 0 < x, and what they are called."""

from __future__ import annotations

from rbpsym.notation import tree as t
from rbpsym.notation.latex_grammar import expression
from rbpsym.notation.latex_table import Reader

SIGNS = {
    "=": "=", "<": "<", ">": ">", r"\le": "<=", r"\ge": ">=", r"\ne": "!=", r"\approx": "~",
    r"\to": "->",
}  # fmt: skip


def relation(reader: Reader) -> t.Node:
    """A chain, or an expression alone."""
    start = reader.token.start
    return reader.spanned(chained(reader, [expression(reader)], []), start)


def chained(reader: Reader, items: list[t.Node], ops: list[str]) -> t.Node:
    """The chain that goes on with the signs that follow."""
    while reader.sees_sign(*SIGNS):
        ops.append(SIGNS[reader.take().text])
        items.append(expression(reader))
    return t.Chain(tuple(items), tuple(ops)) if ops else items[0]
