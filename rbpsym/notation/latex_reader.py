"""LaTeX -> display tree, driven by the symbols of a problem.

It reads what our own printer and physics papers write, and stops with an error, with a caret, at
the first thing that it doesn't know: no character is ever passed over.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from rbpsym.errors import LimitError, Place
from rbpsym.notation import latex_calculus, latex_functions
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.infix import Ways
from rbpsym.notation.latex_grammar import BELOW
from rbpsym.notation.latex_readings import Reading, best_reading, every_reading
from rbpsym.notation.latex_relations import SIGNS, chained, relation
from rbpsym.notation.latex_table import Reader
from rbpsym.notation.latex_tokens import Token, tokenize
from rbpsym.notation.limits import check_degree, check_size
from rbpsym.notation.source import Source
from rbpsym.notation.symbol_table import SymbolTable, symbol_table

GRAMMAR = (latex_calculus, latex_functions)  # enter their commands into the table when they are imported


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
    tokens = _formula_tokens(tokenize(Source(_unbroken(text), place)))
    return _checked(best_reading(source, tokens, symbols, _rows), source)


def latex_ways(text: str, symbols: SymbolTable) -> Ways:
    """All readings of a formula that can be read in several ways. Raises as `read_latex`."""
    source = Source(text)
    tokens = _formula_tokens(tokenize(Source(_unbroken(text))))
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
_BROKEN = re.compile(r"(?:\\right\s*\.\s*)+\\\\.*?(?:\\left\s*\.\s*)+", re.DOTALL)
_EMPTY = re.compile(r"\\(?:left|right)\s*\.|\\\\(?:\[[^\]]*\])?\s*&?|(?<=[\s&d])\{\}")
_GOES_ON = re.compile(r"\\\\\s*&?\s*\\q?quad\b\s*(?:\{\})?")
_CUT = re.compile(rf"(?:\\right\s*\.\s*)*{_GOES_ON.pattern}\s*[-+]?\s*(?:\\left\s*\.\s*)*")


def _unbroken(text: str) -> str:
    """The text with a frame round all of it, and the breaks of a sum that goes on, made blank; places are kept."""
    frame, end = _FRAME.match(text), len(text.rstrip()) - 1
    while frame and text[end] == "}":
        text = " " * frame.end() + text[frame.end() : end] + " " * (len(text) - end)
        frame, end = _FRAME.match(text), len(text.rstrip()) - 1
    return _GOES_ON.sub(_blank, _BROKEN.sub(_mended, _CUT.sub(_without_empty, text)))


def _without_empty(found: re.Match[str]) -> str:
    """Any number of delimiters that are cut where a sum goes on in the next line."""
    return re.sub(r"\\(?:left|right)\s*\.", lambda empty: " " * len(empty[0]), found[0])


def _blank(found: re.Match[str]) -> str:
    return re.sub(r"[^\n]", " ", found[0])


def _mended(found: re.Match[str]) -> str:
    """Delimiters that go on in the next line: `\\left( a \\right. \\\\ & \\left. + b \\right)`."""
    return _EMPTY.sub(_blank, found[0])


def _checked(node: t.Node, source: Source) -> t.Node:
    """The node, if it keeps the bounds. Raises LimitError."""
    try:
        check_size(node)
        check_degree(node)
    except LimitError as error:
        raise error.at(source.at(0, 1)) from None
    return node


def _formula_tokens(tokens: tuple[Token, ...]) -> tuple[Token, ...]:
    """The tokens without alignment marks, environments and the final punctuation."""
    kept = [
        token
        for before, token, after in zip((None, *tokens), tokens, tokens[1:], strict=False)
        if not (token.kind == "begin" or (token.text == "&" and _aligns(before, after)))
    ]
    while kept and (kept[-1].text in (".", ",") or kept[-1].kind == "row"):
        kept.pop()
    return (*kept, tokens[-1])


def _aligns(before: Token | None, after: Token) -> bool:
    """Does an & stand where rows are aligned: beside a relation or sign, or at a row's end?"""
    beside = (before, after)
    return any(token is None or token.kind in _EDGES or token.text in _ALIGNED for token in beside)


_EDGES = frozenset({"row", "begin", "end"})
_ALIGNED = frozenset({*SIGNS, "+", "-"})


def _rows(reader: Reader) -> t.Node:
    """Relations under each other; a row that begins with a relation sign goes on with a chain."""
    rows: list[t.Node] = []
    while True:
        if rows and reader.sees_sign(*SIGNS):
            rows[-1] = _continued(reader, rows[-1])
        else:
            rows.append(relation(reader))
        if not _next_row(reader, rows[-1]):
            break
    if reader.token.kind != "end":
        raise reader.error(f"“{reader.token.text}” is not expected here")
    return rows[0] if len(rows) == 1 else t.System(tuple(rows), span=(0, reader.previous_end))


def _next_row(reader: Reader, row: t.Node) -> bool:
    """Pass the end of a row, or a comma behind a relation (`a = b, c = d`); was it there?"""
    comma = reader.sees_sign(",", ".") and (reader.ahead().kind == "row" or isinstance(row, t.Chain))
    reader.position += comma
    found = comma
    while reader.token.kind == "row":
        reader.take()
        found = True
    return found


def _continued(reader: Reader, row: t.Node) -> t.Node:
    whole = isinstance(row, t.Chain)
    items, ops = (list(row.items), list(row.ops)) if whole else ([row], [])
    start = row.span[0] if row.span else 0
    return reader.spanned(chained(reader, items, ops), start)
