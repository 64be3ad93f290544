"""GIFT: one text file with choices, numbers, matchings and essays. It carries no pictures."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from decimal import Decimal

from rbpsym.document.model import FigureBlock, Math, Text
from rbpsym.teaching.exports.bench import Desk, orders
from rbpsym.teaching.exports.page import Paper
from rbpsym.teaching.exports.qti_items import as_options
from rbpsym.teaching.exports.telling import left_out, name_of
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.grading.units import read_unit
from rbpsym.teaching.model import (
    BlanksKey,
    ChoiceKey,
    ComparisonKey,
    ExplanationKey,
    FormulaKey,
    Item,
    NumberKey,
    Option,
    OrderKey,
    SignsKey,
    SlipKey,
    Worksheet,
)
from rbpsym.teaching.units import unit_text


def export_gift(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One GIFT file with the questions of all students, item by item in categories."""
    lines, missing, drawn = [], [], {}
    for place in range(max((len(sheet.items) for sheet in worksheets), default=0)):
        sheets = [sheet for sheet in worksheets if place < len(sheet.items)]
        item = sheets[0].items[place]
        title = Desk(sheets[0], _paper(drawn), missing).plain(sheets[0].title).replace("/", "-")
        lines.append(f"$CATEGORY: $course$/{' '.join(title.split())}/{item.id} {item.kind}")
        lines += [question(sheet.items[place], Desk(sheet, _paper(drawn), missing)) for sheet in sheets]
    return Exported({"questions.gift": "\n\n".join(lines) + "\n"}, left_out("GIFT", missing))


def _paper(drawn: dict) -> Paper:
    return Paper(tag=lambda path, alt: f"<em>[{alt}]</em>", drawn=drawn)


def question(item: Item, desk: Desk) -> str:
    """The question of one item."""
    part = desk.worksheet.part_of(item.id)
    if any(isinstance(block, FigureBlock) for block in (*part.statement, *item.prompt)):
        desk.lacks(item, "pictures can't be carried: what they show is told in words")
    more, answers = KINDS[type(item.key)](item, desk)
    return f"::{escaped(name_of(item, desk.worksheet))}::[html]{escaped(desk.question(item) + more)}{{{answers}}}"


def escaped(text: str) -> str:
    """Text with its control characters escaped, on one line."""
    return re.sub(r"([\\~=#{}:])", r"\\\1", " ".join(text.split()))


Pair = tuple[str, str]


def _options(desk: Desk, options: tuple[Option, ...], right: int) -> str:
    lines = []
    for place, option in enumerate(options):
        mark = "=" if place == right else "~"
        told = f"<p>{desk.word('right')}</p>" if place == right else desk.feedback(option.slip)
        lines.append(f"{mark}{escaped(desk.inlines(option.content))}#{escaped(told)}")
    return "\n" + "\n".join(lines) + "\n"


def _choice(item: Item, desk: Desk) -> Pair:
    if isinstance(item.key, ComparisonKey) and item.rubric:
        desk.lacks(item, "the reason of a comparison is not asked in a second field")
    return "", _options(desk, item.key.options, item.key.right)


def plain(value: float) -> str:
    """A number without a power of ten, which GIFT does not know: 0.0000715.

    >>> plain(7.15e-5), plain(1.2e12), plain(-0.1)
    ('0.0000715', '1200000000000', '-0.1')
    """
    return format(Decimal(f"{value:.10g}"), "f")


def _number(item: Item, desk: Desk) -> Pair:
    key: NumberKey = item.key
    desk.lacks(item, "the unit is printed in the question; unit and significant figures are not marked")
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    exact, reach = key.exact / read_unit(key.measure.unit).factor, float(key.tolerance.relative)
    lines = [f"={plain(exact)}:{plain(abs(exact) * reach)}#{escaped(desk.word('right'))}"]
    for known in key.anticipated:
        if known.number is not None:
            value = float(known.number.value)
            near = plain(abs(value) * reach / 4)
            lines.append(f"=%0%{plain(value)}:{near}#{escaped(desk.feedback(known.slip))}")
    unit = f"<p>[{desk.word('unit')}: {unit_text(key.measure.unit)}]</p>" if key.measure.unit else ""
    return unit, "#\n" + "\n".join(lines) + "\n"


def _formula(item: Item, desk: Desk) -> Pair:
    key: FormulaKey = item.key
    options = as_options(key.value, key.anticipated)
    if len(options) < 3:
        desk.lacks(item, "a formula can't be compared: it is asked as an essay that the teacher marks")
        return f"<p>{desk.formula(key.left)} = …</p>", ""
    desk.lacks(item, "a formula can't be compared: it is asked as a choice among the known wrong results")
    right = next(place for place, option in enumerate(options) if option.slip is None)
    return "", _options(desk, options, right)


def _order(item: Item, desk: Desk) -> Pair:
    """A matching of steps with places, where only one order is right."""
    key: OrderKey = item.key
    if len(orders(key, 1) or ()) != 1:
        desk.lacks(item, "more than one order is right, which a matching can't say: it is asked as an essay")
        return _lines(item, desk), ""
    places = {piece: place for place, piece in enumerate(key.sample)}
    pairs = (f"={escaped(desk.formula(piece.statement))} -> {places[at] + 1}" for at, piece in enumerate(key.pieces))
    return "", "\n" + "\n".join(pairs) + "\n"


def _lines(item: Item, desk: Desk) -> str:
    pieces = item.key.pieces if isinstance(item.key, OrderKey) else item.key.lines
    return (
        "<ol>"
        + "".join(f"<li>{desk.formula(piece.statement)} {desk.inlines(piece.reason)}</li>" for piece in pieces)
        + "</ol>"
    )


def _slip(item: Item, desk: Desk) -> Pair:
    key: SlipKey = item.key
    desk.lacks(item, "the corrected formula is not asked")
    options = tuple(
        Option((Text(f"{desk.word('line')} {place + 1}: "), Math(line.statement)))
        for place, line in enumerate(key.lines)
    )
    return "", _options(desk, options, key.wrong)


def _signs(item: Item, desk: Desk) -> Pair:
    key: SignsKey = item.key
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "which works cancel is not asked")
    pairs = []
    for row in key.rows:
        name = f"{desk.formula(row.force)} ({desk.inlines(row.label)})"
        for work, sign in (("translational", row.translational), ("rotational", row.rotational)):
            pairs.append(f"={escaped(f'{name}, {desk.word(work)}')} -> {sign.replace('-', '−')}")
    return "", "\n" + "\n".join(pairs) + "\n"


def _blanks(item: Item, desk: Desk) -> Pair:
    desk.lacks(item, "a formula can't be compared: the blanks are asked as an essay that the teacher marks")
    return "", ""


def _explanation(item: Item, desk: Desk) -> Pair:
    desk.lacks(item, "the rubric and the sample answer are not carried: they stand in the key")
    return "", ""


KINDS: Mapping[type, Callable[[Item, Desk], Pair]] = {
    FormulaKey: _formula,
    NumberKey: _number,
    ChoiceKey: _choice,
    ComparisonKey: _choice,
    OrderKey: _order,
    SlipKey: _slip,
    SignsKey: _signs,
    BlanksKey: _blanks,
    ExplanationKey: _explanation,
}
