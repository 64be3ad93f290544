"""LaTeX -> display tree, driven by the symbols of a problem.

It reads what our own printer and physics papers write, and stops with an error, with a caret, at
the first thing that it doesn't know: no character is ever passed over.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from rbpsym.errors import LimitError, Place
from rbpsym.notation import latex_calculus, latex_calls, latex_functions
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.infix import Ways
from rbpsym.notation.latex_grammar import BELOW
from rbpsym.notation.latex_readings import Reading, best_reading, every_reading
from rbpsym.notation.latex_relations import relation
from rbpsym.notation.latex_rows import GAP, laid_out
from rbpsym.notation.latex_table import Reader
from rbpsym.notation.latex_tokens import CONDITION, Token, tokenize
from rbpsym.notation.limits import check_degree, check_size
from rbpsym.notation.source import Source
from rbpsym.notation.symbol_table import SymbolTable, symbol_table

GRAMMAR = (latex_calculus, latex_calls, latex_functions)  # enter their commands into the table when they are imported


def read_latex(
    text: str,
    symbols: SymbolTable | Iterable[str] | Mapping[str, str],
    *,
    notation: Notation = DEFAULT,
    spellings: Mapping[str, str] = MappingProxyType({}),
    place: Place | None = None,
) -> t.Node:
    """The tree of a LaTeX formula: an expression, a Chain, or a System of several relations.

    `symbols` are the names of the problem, drawn as `notation` says, or {LaTeX: name}, or a
    `SymbolTable`; `spellings` adds other LaTeX for a name. A full stop or comma at the end of
    the formula is punctuation. Raises ReadError with line, column and caret, LimitError.
    """
    if not isinstance(symbols, SymbolTable):
        symbols = symbol_table(symbols, notation, spellings)
    source = Source(text, place)
    tokens = _formula_tokens(text, source)
    return _checked(best_reading(source, tokens, symbols, _rows), source)


def latex_ways(text: str, symbols: SymbolTable) -> Ways:
    """All readings of a formula that can be read in several ways. Raises as `read_latex`."""
    source = Source(text)
    tokens = _formula_tokens(text, source)
    readings = every_reading(source, tokens, symbols, _rows)
    met = [question for reading in readings for question in reading.met]
    what, instead, token = met[0] if met else ("", "", tokens[0])
    error = source.error(what, token.start, token.end, instead) if met else None
    trees = tuple(_checked(reading.node, source) for reading in readings)
    return Ways(trees, error, tuple(_parted(reading) for reading in readings))


def _parted(reading: Reading) -> tuple[bool, ...]:
    """What was chosen where this changes what is multiplied and what divided."""
    pairs = zip(reading.met, reading.script, strict=False)
    return tuple(chosen for question, chosen in pairs if question[0] == BELOW)


_FRAME = re.compile(r"\s*\\(?:boxed|fbox|shrunk)\s*\{")


def _formula_tokens(text: str, source: Source) -> tuple[Token, ...]:
    """The tokens of the relations; a frame round all of it is made blank, so that places are kept."""
    frame, end = _FRAME.match(text), len(text.rstrip()) - 1
    while frame and text[end] == "}":
        text = " " * frame.end() + text[frame.end() : end] + " " * (len(text) - end)
        frame, end = _FRAME.match(text), len(text.rstrip()) - 1
    return laid_out(source, tokenize(Source(text, source.place), gaps=True))


def _checked(node: t.Node, source: Source) -> t.Node:
    """The node, if it keeps the bounds. Raises LimitError."""
    try:
        check_size(node)
        check_degree(node)
    except LimitError as error:
        raise error.at(source.at(0, 1)) from None
    return node


def _rows(reader: Reader) -> t.Node:
    """One formula, or several relations, perhaps with the conditions under which they hold."""
    rows, conditions = [relation(reader)], []
    while reader.token.kind == "row":
        parting = reader.take().text
        row = relation(reader)
        (conditions if _is_condition(row, parting, rows, conditions) else rows).append(row)
    if reader.token.kind != "end":
        raise reader.error(f"“{reader.token.text}” is not expected here")
    if len(rows) == 1 and not conditions:
        return rows[0]
    alone = next((row for row in (*rows, *conditions) if not isinstance(row, t.Chain)), None)
    if alone is not None:
        hint = "Begin it with the sign by which it goes on, or write a whole relation."
        raise reader.source.error("this is no relation, and nothing says how it goes on", *alone.span, hint)
    return t.System(tuple(rows), tuple(conditions), span=(0, reader.previous_end))


def _is_condition(row: t.Node, parting: str, rows: list[t.Node], conditions: list[t.Node]) -> bool:
    """Does it say when the others hold: behind “if”, or an inequality of a symbol behind a gap or another condition?"""
    if parting == CONDITION or not isinstance(row, t.Chain):
        return parting == CONDITION
    stated = any(isinstance(found, t.Chain) and {"=", "~"}.intersection(found.ops) for found in rows)
    bare = any(isinstance(item, t.Sym) for item in row.items) and not {"=", "~", "->"}.intersection(row.ops)
    return bare and stated and (parting == GAP or bool(conditions))
