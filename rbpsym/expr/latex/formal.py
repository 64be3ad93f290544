"""LaTeX tokens -> what is read and has no value: differentials, sums between numbers, matrices, operators, loose relations.

A formula that holds any of these is read whole, so that nothing in it passes unseen; whoever needs a value gets the
sentence of its kind, which says what to write instead (`refuse`).
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from fractions import Fraction as Rational
from functools import cache
from pathlib import Path

from rbpsym.errors import Incomplete, RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.directed import is_vector
from rbpsym.expr.latex.functions import SIGNS, relation
from rbpsym.expr.latex.grammar import argument, between, term_of
from rbpsym.expr.latex.scripts import label_after
from rbpsym.expr.latex.spelled import by_command, commands
from rbpsym.expr.latex.tokens import COLUMN, END_COLUMN, NEXT, closed
from rbpsym.expr.source import SourceText
from rbpsym.expr.symbol_table import COMMANDS, LatexReader, begins

Sentence = tuple[str, str]
_BARS = ("|", r"\lvert", r"\rvert")
_STATES, _DOTTED, _MEASURED, _BINOMIALS, _OPERATORS, _GRADIENTS = map(commands, (
    "states", "dotted", "measured", "binomials", "operators", "gradients",
))  # fmt: skip
_SUMMED, _QUANTIFIERS, _SIGNS = map(by_command, ("summed", "quantifiers", "signs"))
_SHAPES = {"vmatrix": "determinant", "cases": "cases"}


@cache
def sentences() -> Mapping[str, Sentence]:
    """What is asked of a part without a value, and what to write instead, by its kind."""
    rows = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))["asked"]
    return {kind: (row["what"], row["instead"]) for row in rows for kind in row["kinds"]}


def refuse(node: t.Node, source: SourceText) -> t.Node:
    """The tree, in which all has a value. Raises ReadError with the sentence of what has none."""
    for part in t.walk(node):
        if isinstance(part, t.Formal):
            what, instead = sentences().get(part.kind) or sentences()["operator"]
            kind = Incomplete if part.kind == "continued" else ReadError
            begin, end = part.span or (0, len(source.text))
            shown = source.text[begin:end].strip()
            raise source.error(f"“{shown}”: {what}" if len(shown) <= 12 and what[-1] != "?" else what, begin, end, instead, kind)
    return node


def formal(reader: LatexReader, start: int, kind: str, *parts: t.Node) -> t.Node:
    """A part without a value, from `start` to here."""
    return reader.spanned(t.Formal(kind, parts), start)


@begins(*_DOTTED, *_SIGNS, *_GRADIENTS)
def _sign(reader: LatexReader) -> t.Node:
    token = reader.take()
    kind = "…" if token.text in _DOTTED else _SIGNS.get(token.text, "∇")
    label = (t.Word(label_after(reader)),) if kind == "∇" and reader.sees_sign("_") else ()
    label = label or ((t.Word(token.text[1:]),) if token.text in _GRADIENTS else ())
    return formal(reader, token.start, kind, *label)


@begins(r"\?")
def _asked(reader: LatexReader) -> t.Node:
    """What a reader is to find: p = ?"""
    start = reader.token.start
    while reader.pass_sign(r"\?"):
        pass
    return formal(reader, start, "asked")


@begins(*_BINOMIALS)
def _binomial(reader: LatexReader) -> t.Node:
    return formal(reader, reader.take().start, "binomial", argument(reader), argument(reader))


@begins(*_QUANTIFIERS)
def _quantified(reader: LatexReader) -> t.Node:
    """∀ x, y ∈ M"""
    token, found = reader.take(), list[t.Node]()
    while not found or (reader.pass_sign(",") and reader.token.kind != "row"):  # ∀ x, \quad a = b
        found.append(relation(reader))
    return formal(reader, token.start, _QUANTIFIERS[token.text], *found)


@begins(*_MEASURED)
def _measured(reader: LatexReader) -> t.Node:
    r"""\SI{9.8}{m/s^2}: the numbers, and the unit as it is written; \si{m} is a unit alone."""
    head = reader.take()
    groups: list[t.Node] = []
    alone = head.text in (r"\si", r"\unit")
    if alone and reader.sees_sign("["):  # \unit[9.8]{m} of units
        groups.append(COMMANDS["["](reader))
    numbers = 0 if alone else 2 if head.text.endswith("range") else 1
    while reader.sees_sign("{") and len(groups) < (1 + bool(groups) if alone else 3):
        begin = reader.position
        try:
            groups.append(numeral(reader) if len(groups) < numbers else _word(reader, begin))
        except RbpsymError:
            groups, reader.position = [*groups, _word(reader, begin)], reader.position
    if len(groups) == 1 and not alone:
        return groups[0]
    return formal(reader, head.start, "measured", *groups)


_NUMERAL = re.compile(r"\s*([-+]?)(\d{0,20}(?:[.,]\d{0,20})?)(?:[eEdD]([-+]?\d{1,2}))?\s*")


def numeral(reader: LatexReader) -> t.Node:
    """What stands in the braces of a number of siunitx: 8.3e-5 is 0.000083, and e no symbol."""
    begin = reader.position
    if reader.sees_sign("{"):
        found = _NUMERAL.fullmatch(_word(reader, begin).text)
        if found and found[2].strip(".,"):
            value = Rational(found[2].replace(",", ".")) * Rational(10) ** int(found[3] or 0)
            number = t.Num(int(value) if value.denominator == 1 else value)
            return t.Neg(number) if found[1] == "-" else number
    reader.position = begin
    return argument(reader)


def _word(reader: LatexReader, begin: int) -> t.Word:
    """What stands in the braces at a place, as it is written."""
    opening, end = reader.tokens[begin], closed(reader.tokens, begin)
    if end >= len(reader.tokens) - 1:
        raise reader.error("this “{” is never closed", "", opening)
    reader.position = end + 1
    return t.Word(reader.source.text[opening.start + 1 : reader.previous_end - 1].strip())


@begins(*_SUMMED)
def _product_over(reader: LatexReader) -> t.Node:
    token = reader.take()
    return over_an_index(reader, _SUMMED[token.text], token.start)


def over_an_index(reader: LatexReader, kind: str, start: int) -> t.Node:
    """A sum (or product) of what follows, from what stands below the sign to what stands above."""
    ends, begin = list[t.Node](), reader.position
    while reader.sees_sign("_", "^") and len(ends) < 2:
        reader.take()
        ends.append(_end(reader))
    return formal(reader, start, kind, bounded(reader, term_of(reader), begin), *ends)


def bounded(reader: LatexReader, term: t.Node, begin: int) -> t.Node:
    """What is summed. Raises ReadError where the index below the sign, at `begin`, stands below a further term too."""
    index = next((one for one in reader.tokens[begin + 1 : begin + 4] if one.kind == "letter"), None)
    depth, read = 0, max(token.end for token in reader.tokens[: reader.position])  # a subscript may stand behind a power
    end = read
    for token in reader.tokens[reader.position :] if index and reader.sees_sign("+", "-") else ():
        depth += (token.text in ("(", "[", "{")) - (token.text in (")", "]", "}"))
        if depth < 0 or token.kind in ("row", "end") or token.text in (",", r"\sum", *SIGNS):
            break
        end = token.end
    if index and is_below(reader, reader.source.text[index.start : index.end], slice(read, end)):
        raise reader.error("does this belong to the sum?", "Put what is summed in parentheses, or use another index.")
    return term


def is_below(reader: LatexReader, index: str, where: slice = slice(None)) -> bool:
    """Does the index stand below a letter?"""
    letter = re.escape(index.strip())
    inner = rf"(?:[a-z]?{letter}|{letter}[a-z])(?![A-Za-z])"  # r_{ij}, but no F_{kin}
    return bool(re.search(rf"_\s*(?:{inner}|\{{(?:[^{{}}]*[^{{}}A-Za-z\\])?{inner}[^{{}}]*\}})", reader.source.text[where]))


def _end(reader: LatexReader) -> t.Node:
    """i = 1, i < j, or several of them, in braces."""
    if not reader.sees_sign("{"):
        return argument(reader)
    begin, opening, found = reader.position, reader.take(), list[t.Node]()
    try:
        while not found or reader.pass_sign(","):
            found.append(relation(reader))
        reader.expect("}", opening)
    except RbpsymError:
        return _word(reader, begin)
    return found[0] if len(found) == 1 else t.Formal("list", tuple(found), span=(opening.start, reader.previous_end))


@begins(*_OPERATORS)
def _operator(reader: LatexReader) -> t.Node:
    """tr, det, min: a sign in front of a product, of which it is not said how much it is of."""
    token = reader.take()
    below = [_end(reader)] if reader.pass_sign("_") else []
    if reader.sees_sign("+", "-"):
        raise reader.error("of what is this operator?", "Write it in parentheses.")
    return formal(reader, token.start, token.text[1:], *below)


@begins(*_STATES)
def _state(reader: LatexReader) -> t.Node:
    """\\ket{ψ}, \\braket{φ|ψ}: the words in the braces."""
    head, words = reader.take(), []
    while reader.sees_sign("{"):
        words.append(_word(reader, reader.position))
    return formal(reader, head.start, "state", *words)


@begins(r"\drawn")
def _drawn(reader: LatexReader) -> t.Node:
    """What a Typst text draws by code of its own."""
    start = reader.take().start
    return formal(reader, start, "drawn", _word(reader, reader.position))


@begins("⟨")
def _mean(reader: LatexReader) -> t.Node:
    start = reader.token.start
    if (state := _written_state(reader)) is not None:
        return state
    found = between(reader, "⟩")
    several = isinstance(found, t.Formal) and found.kind == "list"
    return found if several else formal(reader, start, "mean", found)


@begins("|⟩")
def _written_state(reader: LatexReader) -> t.Node | None:
    """|ψ⟩, ⟨ψ|, ⟨φ|A|ψ⟩ as it is written, if it stands here; else nothing is passed."""
    start, rest = reader.token, []
    for token in reader.tokens[reader.position + 1 :]:
        if token.kind in ("row", "end") or token.text in SIGNS:
            break
        rest.append(token.text)
    closing = "⟩" if start.text != "⟨" or "⟩" in rest else "|"
    inner = rest.index(closing) if closing in rest else -1
    barred = any(text in _BARS for text in rest[:inner])
    if inner < 0 or barred != (start.text == "⟨" and closing == "⟩") or "⟨" in rest[:inner]:
        return None
    reader.position += inner + 2
    return formal(reader, start.start, "state", t.Word(reader.source.text[start.start : reader.previous_end]))


@begins(r"\cancel", r"\bcancel", r"\xcancel")
def _crossed_out(reader: LatexReader) -> t.Node:
    return formal(reader, reader.take().start, "cancelled", argument(reader))


@begins(r"\underbrace", r"\overbrace")
def _braced(reader: LatexReader) -> t.Node:
    """What stands over or under the brace; its name is in words, or another formula."""
    start, mark = reader.token.start, "_" if reader.take().text == r"\underbrace" else "^"
    found = argument(reader)
    if not reader.pass_sign(mark):
        return found
    name = _end(reader)
    words = all(isinstance(part, (t.Word, t.Mul)) for part in t.walk(name))
    return found if words else formal(reader, start, "named", found, name)


@begins("(")
def _parenthesis(reader: LatexReader) -> t.Node:
    """(expression), or a vector by its components where none can be multiplied with what is before."""
    before = reader.tokens[reader.position - 1] if reader.position else None
    start = reader.token.start
    if not reader.table.open and (before is None or before.kind == "row" or before.text in _BEFORE_VECTOR):
        found = between(reader, ")")
        several = isinstance(found, t.Formal) and found.kind == "list" and len(found.parts) < 4
        return reader.spanned(_vector(found.parts), start) if several and isinstance(found, t.Formal) else found
    return between(reader, ")")


_BEFORE_VECTOR = frozenset(("=", r"\approx", "+", "-"))


@begins(COLUMN)
def _column(reader: LatexReader) -> t.Node:
    """A column or row of two or three components, a vector; a matrix, a determinant, or values by cases."""
    opening = reader.take()
    waiting, rows = (reader.integrals, reader.bars), [list[t.Node]()]
    reader.integrals, reader.bars = 0, False
    while not reader.sees_sign(END_COLUMN):
        reader.position += reader.token.kind == "row"  # “if”
        empty = reader.sees_sign("&", NEXT)
        rows[-1].append(t.Word("") if empty else relation(reader))
        apart = reader.pass_sign(",", ".", ";")
        if reader.sees_sign("&", NEXT):
            rows += [[]] if reader.take().text == NEXT else []
            rows[-1] += [t.Word("")] * bool(rows[-1] and reader.sees_sign(END_COLUMN))
        elif not (apart or reader.token.kind == "row" or reader.sees_sign(END_COLUMN)):
            raise reader.error(*sentences()["matrix"], opening)
    reader.integrals, reader.bars = waiting
    reader.take()
    before, begun = reader.source.text[: opening.start], reader.source.text[opening.start : opening.end]
    kind = next((kind for word, kind in _SHAPES.items() if word in begun), "matrix")
    braced = re.search(r"\\(?:\{|lbrace)\s*$", before) and re.search(r"array|\{matrix|aligned", begun)
    kind = "cases" if braced else kind
    cells = [cell for row in rows for cell in row]
    line = 1 in (len(rows), len(rows[0])) and 1 < len(cells) <= 3 and not any(map(is_vector, cells))
    if kind == "matrix" and line and not reader.table.open:
        return reader.spanned(_vector(cells), opening.start)
    return reader.spanned(t.Formal(kind, tuple(t.Formal("row", tuple(row)) for row in rows)), opening.start)


def _vector(cells: Sequence[t.Node]) -> t.Node:
    along = (t.mul(part, t.Unit(axis)) for part, axis in zip(cells, "xyz", strict=False))
    return cells[0] if len(cells) == 1 else t.Add(tuple(along))


def taken_at(reader: LatexReader, node: t.Node, start: int) -> t.Node:
    """What is taken where the subscript (and superscript) behind the bar say."""
    reader.expect("_")
    if reader.sees_sign("{"):
        opening = reader.take()
        where = relation(reader)
        while reader.pass_sign(","):
            where = t.Relations((*t.rows(where), relation(reader)))
        reader.expect("}", opening)
    else:
        where = argument(reader)
    if reader.pass_sign("^"):
        return reader.spanned(t.Formal("between", (node, where, argument(reader))), start)
    return reader.spanned(t.At(node, where) if isinstance(where, t.Chain) else t.Formal("at", (node, where)), start)


COMMANDS["at"] = taken_at
