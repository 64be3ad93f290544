"""LaTeX -> display tree, driven by the symbols of a problem.

It reads what our own printer and physics papers write, and stops with an error, with a caret, at
the first thing that it doesn't know: no character is ever passed over.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any

from rbpsym.errors import Place, RbpsymError, ReadError, UnknownName
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.infix import Ways
from rbpsym.expr.latex import calculus as latex_calculus
from rbpsym.expr.latex import formal as latex_formal
from rbpsym.expr.latex import functions as latex_functions
from rbpsym.expr.latex import packages as latex_packages
from rbpsym.expr.latex import sums as latex_sums
from rbpsym.expr.latex.functions import relation
from rbpsym.expr.latex.grammar import BELOW, UNKNOWN_COMMAND
from rbpsym.expr.latex.names import as_words
from rbpsym.expr.latex.rows import GAP, laid_out
from rbpsym.expr.latex.small import differentials, is_balanced
from rbpsym.expr.latex.tokens import CONDITION, CONDITIONS, EQUIVALENT, IMPLIED, MAX_LENGTH, Token, tokenize
from rbpsym.expr.source import SourceText, behind_brace
from rbpsym.expr.symbol_table import LatexReader, Question, SymbolTable, equally, symbol_table
from rbpsym.frozen import Frozen, replace

MOST_READINGS, MOST_TOKENS = 128, 12_000  # readings, and tokens read in all of them
Read = Callable[[LatexReader], t.Node]


class Reading(Frozen):
    """A formula as it was read with some choices: the tree or the error, the questions met, how unusual it is."""

    script: tuple[bool, ...]
    met: tuple[Question, ...]
    cost: int
    node: Any
    error: RbpsymError | None


def best_reading(source: SourceText, tokens: tuple[Token, ...], table: SymbolTable, read: Read) -> t.Node:
    """The tree that is meant. Raises ReadError if none or more than one can be meant."""
    first = _reading(source, tokens, table, read, ())
    if not first.met:
        return _tree(first)
    readings = _all(source, tokens, table, read, first)
    sound = [reading for reading in readings if reading.node is not None]
    if not sound:
        return _tree(first)
    count = table.faults or equally
    faults = {reading.script: count(reading.node) for reading in sound}
    ranked = sorted(sound, key=lambda reading: (faults[reading.script], reading.cost))
    best = ranked[0]
    rank = (faults[best.script], best.cost)
    rivals = [r for r in ranked if (faults[r.script], r.cost) == rank and r.node != best.node]
    if rivals:
        raise _asked(source, _parting(best, rivals[0]))
    return _tree(best)


def every_reading(source: SourceText, tokens: tuple[Token, ...], table: SymbolTable, read: Read) -> tuple[Reading, ...]:
    """All readings that make a formula, the first without any unusual choice. Raises ReadError if there is none."""
    free = replace(table, faults=equally)
    first = _reading(source, tokens, free, read, ())
    readings = _all(source, tokens, free, read, first)
    sound = tuple(reading for reading in readings if reading.node is not None)
    if not sound and first.error is not None:
        raise first.error
    even = tuple(one for one in sound if is_balanced(one.node, source.text))
    if even or not sound:
        return even
    if any(_stands_alone(tokens, place) for place in range(len(tokens) - 1)):
        return every_reading(source, tokens, replace(table, has_length=True), read)
    raise source.error("is this d a differential, or a symbol?", *differentials(sound[0].node, source.text)[0], _D_MEANT)


_D_MEANT = r"Write \mathrm{d}x for a differential; for a product, say in the symbols what d means, or write d \cdot x."


def _stands_alone(tokens: tuple[Token, ...], place: int) -> bool:
    """Is it a d that nobody takes for a differential, as in d = 2r, x/d, d^2 ≪ x?"""
    before, token, behind = tokens[place - 1], tokens[place], tokens[place + 1]
    ends = behind.kind in ("row", "end") or behind.text in ("=", "+", "-", ")", "_", r"\cdot", ",", r"\ll", r"\gg", r"\approx")
    return token.text == "d" and token.kind == "letter" and before.text not in ("_", "^", "{") and ends


def _tree(reading: Reading) -> t.Node:
    if reading.error is not None:
        raise reading.error
    node: t.Node = reading.node
    return node


def _reading(source: SourceText, tokens: tuple[Token, ...], table: SymbolTable, read: Read, script: tuple[bool, ...]) -> Reading:
    reader = LatexReader(source, tokens, table=table, script=script)
    node, error = None, None
    try:
        node = read(reader)
    except RbpsymError as found:
        error = found
    chosen = (*script, *(False,) * (len(reader.met) - len(script)))
    return Reading(chosen, tuple(reader.met), reader.cost, node, error)


def _all(source: SourceText, tokens: tuple[Token, ...], table: SymbolTable, read: Read, first: Reading) -> list[Reading]:
    """Every reading: of each, those that choose otherwise at one of the questions behind its script."""
    found, waiting = [first], [(first, 0)]
    most = min(MOST_READINGS, max(MOST_TOKENS // len(tokens), 2))
    while waiting:
        reading, fixed = waiting.pop()
        for place in range(fixed, len(reading.met)):
            if len(found) >= most:
                raise _asked(source, reading.met[place])
            other = _reading(source, tokens, table, read, (*reading.script[:place], True))
            found.append(other)
            waiting.append((other, place + 1))
    return found


def _asked(source: SourceText, question: Question) -> RbpsymError:
    what, instead, token = question
    return source.error(what, token.start, token.end, instead)


def _parting(one: Reading, other: Reading) -> Question:
    """The question that the two readings answer differently."""
    pairs = zip(one.script, other.script, strict=False)
    place = next((k for k, (a, b) in enumerate(pairs) if a != b), 0)
    return one.met[place]


# loaded: they enter their commands into the table
GRAMMAR = (latex_calculus, latex_formal, latex_functions, latex_packages, latex_sums)


def read_latex(
    text: str,
    symbols: SymbolTable | Iterable[str] | Mapping[str, str],
    *,
    notation: Notation = DEFAULT,
    spellings: Mapping[str, str] = MappingProxyType({}),
    place: Place | None = None,
    whole: bool = False,
) -> t.Node:
    """The tree of a LaTeX formula: an expression, a Chain, or a System of several relations.

    `symbols` are the names of the problem, drawn as `notation` says, or {LaTeX: name}, or a
    `SymbolTable`; `spellings` adds other LaTeX for a name. A full stop or comma at the end of
    the formula is punctuation. `whole`: parts without a value (`tree.Formal`) are read too. Raises ReadError with line,
    column and caret, LimitError.
    """
    if not isinstance(symbols, SymbolTable):
        symbols = symbol_table(symbols, notation, spellings)
    source = SourceText(text, place)
    tokens = _formula_tokens(text, source, symbols)
    found = source.bounded(best_reading(source, tokens, symbols, _rows))
    return found if whole else latex_formal.refuse(found, source)


def latex_ways(text: str, symbols: SymbolTable, *, whole: bool = False) -> Ways:
    """All readings of a formula that can be read in several ways. Raises as `read_latex`."""
    source = SourceText(text)
    tokens = _formula_tokens(text, source, symbols)
    readings = every_reading(source, tokens, symbols, _rows)
    met = [question for reading in readings for question in reading.met]
    what, instead, token = met[0] if met else ("", "", tokens[0])
    error = source.error(what, token.start, token.end, instead) if met else None
    trees = tuple(source.bounded(reading.node) for reading in readings)
    for tree in () if whole else trees:
        latex_formal.refuse(tree, source)
    return Ways(trees, error, tuple(_parted(reading) for reading in readings))


def _parted(reading: Reading) -> tuple[bool, ...]:
    """What was chosen where this changes what is multiplied and what divided."""
    pairs = zip(reading.met, reading.script, strict=False)
    return tuple(chosen for question, chosen in pairs if question[0] == BELOW)


_FRAME = re.compile(
    r"\\(?:textcolor\s*\{[^{}]*\}|A?boxed|fbox|shrunk|small|large|underline|lefteqn)\s*\{|\{(?=\s*\\color(?![A-Za-z]))"
    r"|(?:(?<=quad)|(?<=quad )|(?<=\\ )|(?<=~)|\A\s*)\{"
)
_RELATES = re.compile(r"=|<|>|&|\\(?:approx|[lg]eq?|to)(?![A-Za-z])")


_UPRIGHT_D = re.compile(r"(?<![\d_^~])(?<!\\,)(?<!_\{)\\(?:mathrm|rm|text|textrm)\s*\{\s*d\s*([a-z])\s*\}")  # \mathrm{dt}


def _formula_tokens(text: str, source: SourceText, table: SymbolTable) -> tuple[Token, ...]:
    """The tokens of the relations; a frame round a relation, or round all, is made blank, so that places are kept."""
    text = _UPRIGHT_D.sub(lambda found: (r"\dd " + found[1]).ljust(len(found[0])), text)
    for frame in _FRAME.finditer(text[:MAX_LENGTH]):
        end = behind_brace(text, frame.end() - 1) - 1
        if end > 0 and (_RELATES.search(text, frame.end(), end) or not (text[: frame.start()] + text[end + 1 :]).strip()):
            text = f"{text[: frame.start()]}{' ' * len(frame[0])}{text[frame.end() : end]} {text[end + 1 :]}"
    own = {row[0] for row in table.spellings if len(row) == 1}  # commands that are names: \\th
    tokens = tokenize(SourceText(text, source.place), gaps=True)
    named = (replace(one, kind="letter") if one.kind == "command" and one.text in own else one for one in tokens)
    return laid_out(source, tuple(as_words(text, [*named]) if table.open else named))


def _rows(reader: LatexReader) -> t.Node:
    """One formula, or several relations, each perhaps with the conditions behind it under which it holds, and with what stands
    in its line before an arrow from which it follows."""
    groups: list[tuple[list[t.Node], list[t.Node]]] = [([_row(reader)], [])]
    line = [*groups[0][0]]
    while reader.token.kind == "row":
        parting, (rows, conditions) = reader.take(), groups[-1]
        row = _row(reader)
        if parting.text in (IMPLIED, EQUIVALENT) and isinstance(row, (t.Chain, t.Formal)):
            rows[:] = map(_as_small, rows)
            if parting.text == EQUIVALENT:
                rows[-1] = t.Relations((rows[-1],), sources=(row,))
            row = t.Relations((row,), sources=tuple(map(_as_small, line)), span=row.span)
        elif reader.source.text.startswith("\\\\", parting.start):
            line = []
        alone = rows and not (conditions or isinstance(rows[-1], (t.Chain, t.Formal, t.Relations, t.Word)))
        alone = alone and parting.text != CONDITION and reader.source.text[parting.start] == ","
        if alone and isinstance(row, t.Chain):  # x, y = 0
            row = replace(row, items=(t.Formal("list", (rows.pop(), row.items[0]), span=row.span), *row.items[1:]))
        line += row.rows if isinstance(row, t.Relations) else () if _is_text(row) else (row,)
        if _is_condition(row, parting.text, rows, conditions):
            conditions.append(row)
        elif conditions and not _is_text(row):  # a = b if x > 0, a = c if x < 0
            groups.append(([row], []))
        else:
            rows.append(row)
    if reader.token.kind != "end":
        hint, kind = (UNKNOWN_COMMAND, UnknownName) if reader.token.kind == "command" else ("", ReadError)
        raise reader.error(f"“{reader.token.text}” is not expected here", hint, kind=kind)
    found = [_asserted(rows, conditions, reader) for rows, conditions in groups]
    return found[0] if len(found) == 1 else t.Relations(tuple(found), span=(0, reader.previous_end))


def _asserted(rows: list[t.Node], conditions: list[t.Node], reader: LatexReader) -> t.Node:
    """A formula alone, or relations that hold under the same conditions."""
    rows = [_as_condition(row, reader) for row in rows if not _is_text(row)] or rows
    if len(rows) == 1 and not conditions:
        return rows[0]
    conditions = [_as_condition(_as_small(row), reader) for row in conditions]
    alone = next((row for row in (*rows, *conditions) if not isinstance(row, (t.Chain, t.Formal, t.Relations))), None)
    if alone is not None:
        hint = "Begin it with the sign by which it goes on, or write a whole relation."
        start, end = alone.span or (0, 1)
        raise reader.source.error("this is no relation, and nothing says how it goes on", start, end, hint)
    return t.Relations(tuple(rows), tuple(conditions), span=(0, reader.previous_end))


def _row(reader: LatexReader) -> t.Node:
    """A relation; a word that stands alone is a remark, and no name."""
    token, behind = reader.token, reader.ahead().kind
    row = relation(reader)
    return t.Word(token.text, span=row.span) if token.kind == "text" and behind in ("row", "end") else row


def _words(row: t.Node) -> list[t.Word]:
    return [part for part in t.walk(row) if isinstance(part, t.Word)]


def _is_text(row: t.Node) -> bool:
    """Is it a remark in words, that can be no condition?"""
    words = all(isinstance(part, (t.Mul, t.Group, t.Word)) for part in t.walk(row))
    return words and not any(CONDITIONS.search(word.text) for word in _words(row))


_EXTREMA = frozenset((r"\min", r"\max", r"\argmin", r"\argmax", r"\sup", r"\inf"))
_SAYING = re.compile(rf"{CONDITIONS.pattern}|[^\W\d_]{{2,}}\s+[^\W\d_]{{2,}}", re.I)  # or several words, whatever they say


def _as_condition(row: t.Node, reader: LatexReader) -> t.Node:
    """The row; words with what they are about are a condition that nothing can be computed of."""
    has_words = "text" in {token.kind for token in reader.tokens}
    if isinstance(row, (t.Chain, t.Formal)):
        return row
    said = "condition" if has_words and any(_SAYING.search(word.text) for word in _words(row)) else ""
    least = _EXTREMA.intersection(token.text for token in reader.tokens)
    kinds = [part.kind for part in t.walk(row) if isinstance(part, t.Formal) and rf"\{part.kind}" in least] if least else []
    kind = kinds[0] if kinds else said
    return t.Formal(kind, (row,), span=row.span) if kind else row


_SMALL = re.compile(
    r"(?:(?:for|if|when|with|para|für|per|pour) )?(?:very )?(?:small|pequeñ[oa]s?|kleine[ns]?|piccol[oiae]|petite?s?)", re.I
)


def _as_small(row: t.Node) -> t.Node:
    """x → 0 for x ≪ a and for “small x”; any other row as it is."""
    small = row.parts[row.kind == "≫"] if isinstance(row, t.Formal) and row.kind in _MUCH else None
    if isinstance(row, t.Mul) and len(row.factors) == 2 and isinstance(row.factors[0], t.Word):
        small = row.factors[1] if _SMALL.fullmatch(row.factors[0].text) else None
    return t.Chain((small, t.ZERO), ("->",), span=row.span) if isinstance(small, t.Sym) else row


_MUCH = ("≪", "≫")


def _is_condition(row: t.Node, parting: str, rows: list[t.Node], conditions: list[t.Node]) -> bool:
    """Does it say when the others hold: behind “if”, or, behind a gap or another condition, an inequality of a symbol, or that it
    is small?"""
    tends = isinstance(_as_small(row), t.Chain) and not isinstance(row, t.Chain)
    if parting == CONDITION or not isinstance(row, t.Chain):
        return parting == CONDITION or (tends and (parting == GAP or bool(conditions)))
    stated = any(isinstance(found, t.Chain) and {"=", "~"}.intersection(found.ops) for found in rows)
    bare = any(isinstance(item, t.Sym) for item in row.items) and not {"=", "~", "->"}.intersection(row.ops)
    return bare and stated and (parting == GAP or bool(conditions))
