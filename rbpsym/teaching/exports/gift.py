"""GIFT: one text file with choices, numbers, matchings and essays. It carries no pictures."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any

from rbpsym.document.model import FigureBlock
from rbpsym.frozen import Frozen
from rbpsym.teaching import model as m
from rbpsym.teaching.exports import question as q
from rbpsym.teaching.exports.bench import ExportDesk, Missing, Platform, by_items, orders
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.wording import left_out, name_of


class Matching(Frozen):
    """Pairs to be put together."""

    pairs: tuple[tuple[str, str], ...]


def export_gift(worksheets: tuple[m.Worksheet, ...], options: Options) -> Exported:
    """One GIFT file with the questions of all students, item by item in categories."""
    lines: list[str] = []
    missing: Missing = []
    for row in by_items(worksheets, GIFT, missing):
        item, desk = row[0]
        title = " ".join(desk.plain(desk.worksheet.title).replace("/", "-").split())
        lines.append(f"$CATEGORY: $course$/{title}/{item.id} {item.kind}")
        lines += [question(item, desk) for item, desk in row]
    return Exported({"questions.gift": "\n\n".join(lines) + "\n"}, left_out("GIFT", missing))


def question(item: m.Item, desk: ExportDesk) -> str:
    """The question of one item."""
    part = desk.worksheet.part_of(item.id)
    if any(isinstance(block, FigureBlock) for block in (*part.statement, *item.prompt)):
        desk.lacks(item, "pictures")
    form = q.asked_as(item, desk)
    more, answers = SHELLS[type(form)](form, desk)
    return f"::{escaped(name_of(item, desk.worksheet))}::[html]{escaped(desk.question(item) + more)}{{{answers}}}"


def escaped(text: str) -> str:
    """Text with its control characters escaped, on one line."""
    return re.sub(r"([\\~=#{}:])", r"\\\1", " ".join(text.split()))


def plain(value: float) -> str:
    """A number without a power of ten, which GIFT does not know: 0.0000715.

    >>> plain(7.15e-5), plain(1.2e12), plain(-0.1)
    ('0.0000715', '1200000000000', '-0.1')
    """
    return format(Decimal(f"{value:.10g}"), "f")


# --- keys for which it has a way of its own


def order(key: m.OrderKey, item: m.Item, desk: ExportDesk) -> Matching | q.Essay:
    """A matching of steps with places, where only one order is right."""
    if len(orders(key, 1) or ()) != 1:
        desk.lacks(item, "orders")
        return q.Essay(q.lines(key.pieces, desk))
    pieces = enumerate(key.pieces)
    return Matching(tuple((desk.formula(piece.statement), str(key.sample.index(at) + 1)) for at, piece in pieces))


def signs(key: m.SignsKey, item: m.Item, desk: ExportDesk) -> Matching:
    """A matching of works with their signs."""
    q.note_cancelling(key, item, desk)
    pairs = []
    for row in key.rows:
        for work, sign in (("translational", row.translational), ("rotational", row.rotational)):
            pairs.append((f"{desk.inlines(row.label)}, {desk.word(work)}", sign.replace("-", "−")))
    return Matching(tuple(pairs))


# --- each form: (what stands below the question, the answers)


def _choice(form: q.Choice, desk: ExportDesk) -> tuple[str, str]:
    lines = []
    for place, option in enumerate(form.options):
        is_right = place == form.right
        told = f"<p>{desk.word('right')}</p>" if is_right else desk.feedback(option.slip)
        lines.append(f"{'=' if is_right else '~'}{escaped(desk.inlines(option.content))}#{escaped(told)}")
    return "", _below_each_other(lines)


def _number(form: q.Number, desk: ExportDesk) -> tuple[str, str]:
    lines = [f"={plain(form.exact)}:{plain(abs(form.exact) * form.reach)}#{escaped(desk.word('right'))}"]
    for value, slip in form.wrong:
        lines.append(f"=%0%{plain(value)}:{plain(abs(value) * form.reach / 4)}#{escaped(desk.feedback(slip))}")
    unit = f"<p>[{desk.word('unit')}: {form.unit}]</p>" if form.unit else ""
    return unit, "#" + _below_each_other(lines)


def _below_each_other(lines: list[str]) -> str:
    return "\n" + "\n".join(lines) + "\n"


SHELLS: Mapping[type, Callable[[Any, ExportDesk], tuple[str, str]]] = {
    q.Choice: _choice,
    q.Number: _number,
    Matching: lambda form, desk: ("", _below_each_other([f"={escaped(left)} -> {right}" for left, right in form.pairs])),
    q.Essay: lambda form, desk: (form.before, ""),
}
LACKS: Mapping[str, str] = {
    "pictures": "pictures can't be carried: what they show is told in words",
    "orders": "more than one order is right, which a matching can't say: it is asked as an essay",
    "formula as text": "a formula can't be compared: it is asked as an essay that the teacher marks",
    "blanks": "a formula can't be compared: the blanks are asked as an essay that the teacher marks",
    "rubric": "the rubric and the sample answer are not carried: they stand in the key",
}
GIFT = Platform("GIFT", tag=lambda path, alt: f"<em>[{alt}]</em>", kinds={m.OrderKey: order, m.SignsKey: signs}, lacks=LACKS)
