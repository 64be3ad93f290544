"""Questions without a platform: how an item is asked, and what of it can't be carried.

A platform names the kinds of keys for which it has a way of its own (`Platform.kinds`); all others are asked in the ways
of `KINDS`: a formula as a choice among known wrong ones, an order pair by pair, signs as a table of drop-downs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from markupsafe import escape

from rbpsym.document.model import Math, Text
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, replace
from rbpsym.statement.units import read_unit, unit_text
from rbpsym.teaching import model as m
from rbpsym.teaching.exports.bench import Asking, ExportDesk, free_pairs, nearest_pairs
from rbpsym.teaching.exports.names import RESERVED, exported_names

FEWEST = 3  # options of a choice that stands for a formula


class Choice(Frozen):
    """One of several options, `right` by its place; `before` stands above them, `praise` is told of the right one."""

    options: tuple[m.Option, ...]
    right: int
    before: str = ""
    praise: str = ""
    shuffled: bool = True

    @property
    def slips(self) -> tuple[tuple[int, m.Option], ...]:
        """The wrong options whose slip is known, with their places from 1."""
        places = enumerate(self.options, start=1)
        return tuple((place, option) for place, option in places if option.slip and place != self.right + 1)


class Number(Frozen):
    """A number: in its unit `exact` and `printed`, which may be off by the share `reach`, and known wrong ones."""

    key: m.NumberKey
    exact: float
    printed: float
    unit: str
    wrong: tuple[tuple[float, m.Slip], ...]

    @property
    def reach(self) -> float:
        """The share by which an answer may be off."""
        return float(self.key.tolerance.relative)

    def bounds(self, value: float, reach: float) -> list[float]:
        """The least and the greatest number that is taken for a value."""
        return sorted(value * (1 + side * reach) for side in (-1, 1))


class DropDown(Frozen):
    """A drop-down: its words and the place of the right one."""

    name: str
    words: tuple[str, ...]
    right: int


class Fields(Frozen):
    """Text with drop-downs in it, as the platform shows each (`Platform.dropdown`)."""

    markup: str
    fields: tuple[DropDown, ...]


class TypedFormulas(Frozen):
    """Formulas to be typed, their points as shares, with the names that are typed for ours; `left` is what stands before
    a single one."""

    entries: tuple[m.Blank, ...]
    names: Mapping[str, str]
    left: t.Node | None = None


class Essay(Frozen):
    """Words that the teacher marks; `sample` shows a full answer. `before` stands above the field."""

    before: str = ""
    sample: str = ""


# --- how each kind is asked where the platform has no way of its own


def number(key: m.NumberKey, item: m.Item, desk: ExportDesk) -> Number:
    """A number in the unit that is printed."""
    desk.lacks(item, "figures")
    if key.anticipated:
        desk.lacks(item, "slips of numbers")
    if key.follows:
        desk.lacks(item, "carried")
    wrong = tuple((float(a.number.value), a.slip) for a in key.anticipated if a.number)
    unit = key.measure.unit
    return Number(key, key.exact / read_unit(unit).factor, float(key.measure.value), unit_text(unit), wrong)


def choice(key: m.ChoiceKey, item: m.Item, desk: ExportDesk) -> Choice:
    """One of the options as they are."""
    if isinstance(key, m.ComparisonKey) and item.rubric:
        desk.lacks(item, "reason")
    return Choice(key.options, key.right)


def choice_of_lines(key: m.SlipKey, item: m.Item, desk: ExportDesk) -> Choice:
    """Which line is wrong."""
    desk.lacks(item, "correction")
    numbered = enumerate(key.lines, start=1)
    options = (m.Option((Text(f"{desk.word('line')} {place}: "), Math(line.statement))) for place, line in numbered)
    return Choice(tuple(options), key.wrong)


def formula_as_choice(key: m.FormulaKey, item: m.Item, desk: ExportDesk) -> Choice | Essay:
    """A formula among its known wrong ones, in an order that tells nothing: by their length, then by their text."""
    pairs = sorted([(key.value, None), *m.wrong_formulas(key.anticipated)], key=lambda pair: (len(str(pair[0])), str(pair[0])))
    if len(pairs) < FEWEST:
        desk.lacks(item, "formula as text")
        return Essay(f"<p>{desk.formula(key.left)} = …</p>", f"<p>{desk.formula(key.value)}</p>")
    desk.lacks(item, "formula")
    options = tuple(m.Option((Math(formula),), slip, formula) for formula, slip in pairs)
    return Choice(options, next(place for place, option in enumerate(options) if option.slip is None))


def blanks_as_text(key: m.BlanksKey, item: m.Item, desk: ExportDesk) -> Essay:
    """All blanks in one field."""
    desk.lacks(item, "blanks")
    right = (f"<p>{blank.number}: {desk.formula(blank.value)}</p>" for blank in key.blanks)
    return Essay(sample="".join(right))


def essay(key: m.Key, item: m.Item, desk: ExportDesk) -> Essay:
    """An open question, without its answer."""
    desk.lacks(item, "rubric")
    return Essay()


def essay_with_sample(key: m.ExplanationKey, item: m.Item, desk: ExportDesk) -> Essay:
    """An open question for a platform that shows a full answer to who marks it."""
    return Essay(sample=desk.html(key.sample))


def rubric(item: m.Item, desk: ExportDesk) -> str:
    """What earns points, as a list; "" if nothing is said."""
    rows = "".join(f"<li>{desk.inlines(row.text)} ({float(row.points):g})</li>" for row in item.rubric)
    return f"<ul>{rows}</ul>" if rows else ""


def signs(key: m.SignsKey, item: m.Item, desk: ExportDesk) -> Fields:
    """A table with two drop-downs for each force."""
    note_cancelling(key, item, desk)
    fields, rows = [], ""
    for place, row in enumerate(key.rows, start=1):
        own = [
            DropDown(f"{work}{place}", SIGNS, m.SIGNS.index(sign))
            for work, sign in (("T", row.translational), ("R", row.rotational))
        ]
        cells = "".join(f"<td>{desk.platform.dropdown(field)}</td>" for field in own)
        rows += f"<tr><td>{desk.inlines(row.label)}</td>{cells}</tr>"
        fields += own
    head = "".join(f"<th>{desk.word(name)}</th>" for name in ("row", "translational", "rotational"))
    return Fields(f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>", tuple(fields))


SIGNS = tuple(sign.replace("-", "−") for sign in m.SIGNS)


def note_cancelling(key: m.SignsKey, item: m.Item, desk: ExportDesk) -> None:
    """No platform asks which works cancel."""
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "cancelling")


def order_in_pairs(key: m.OrderKey, item: m.Item, desk: ExportDesk) -> Fields:
    """An order asked pair by pair, since more than one order may be right."""
    desk.lacks(item, "pairs")
    words = tuple(desk.word(name) for name in ("before", "after", "either"))
    pairs = [*((pair, 0) for pair in nearest_pairs(key)), *((pair, 2) for pair in free_pairs(key))]
    fields, asked, step = [], "", desk.word("step")
    for place, ((first, second), right) in enumerate(pairs, start=1):
        fields.append(DropDown(f"P{place}", words, right))
        asked += f"<li>{step} {first + 1} {desk.platform.dropdown(fields[-1])} {step.lower()} {second + 1}</li>"
    return Fields(f"{lines(key.pieces, desk)}<p>{desk.word('pair')}</p><ul>{asked}</ul>", tuple(fields))


def lines(pieces: Iterable[m.LinePiece], desk: ExportDesk) -> str:
    """Pieces of a derivation as a numbered list."""
    return f"<ol>{''.join(f'<li>{line_of(piece, desk)}</li>' for piece in pieces)}</ol>"


def line_of(piece: m.LinePiece, desk: ExportDesk) -> str:
    """A piece with its reason."""
    return f"{desk.formula(piece.statement)} {desk.inlines(piece.reason)}"


# --- for platforms that compare formulas


def typed_formula(key: m.FormulaKey, item: m.Item, desk: ExportDesk) -> TypedFormulas:
    """One formula."""
    if key.follows:
        desk.lacks(item, "carried")
    return _formulas(key.names, item, desk, (m.Blank(1, key.value, anticipated=key.anticipated),), key.left)


def typed_blanks(key: m.BlanksKey, item: m.Item, desk: ExportDesk) -> TypedFormulas:
    """A formula for each blank."""
    blanks = key.blanks
    whole = sum((blank.points for blank in blanks), Fraction(0)) or Fraction(1)
    return _formulas(key.names, item, desk, tuple(replace(blank, points=blank.points / whole) for blank in blanks))


def _formulas(
    names: Iterable[str], item: m.Item, desk: ExportDesk, entries: tuple[m.Blank, ...], left: t.Node | None = None
) -> TypedFormulas:
    if any(entry.anticipated for entry in entries):
        desk.lacks(item, "slips of formulas")
    formulas = [e.value for e in entries] + [formula for e in entries for formula, _ in m.wrong_formulas(e.anticipated)]
    used = set(names).union(*map(t.names, formulas)) - {"pi"}
    return TypedFormulas(entries, exported_names(used, desk.worksheet.problems[item.asked.problem], RESERVED), left)


def legend(names: Mapping[str, str], desk: ExportDesk) -> str:
    """What is typed for each letter."""
    pairs = (f"{desk.formula(t.Sym(name))}: <code>{escape(typed)}</code>" for name, typed in sorted(names.items()))
    return f"<p>{desk.word('type')} {', '.join(pairs)}</p>"


KINDS: Mapping[type, Asking] = {
    m.FormulaKey: formula_as_choice,
    m.NumberKey: number,
    m.ChoiceKey: choice,
    m.ComparisonKey: choice,
    m.OrderKey: order_in_pairs,
    m.SlipKey: choice_of_lines,
    m.SignsKey: signs,
    m.BlanksKey: blanks_as_text,
    m.ExplanationKey: essay,
}


def asked_as(item: m.Item, desk: ExportDesk) -> Any:
    """How the platform asks an item."""
    kind = type(item.key)
    return desk.platform.kinds.get(kind, KINDS[kind])(item.key, item, desk)
