"""QTI 2.1: one package a student, with an item for each question, a test and a manifest."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from markupsafe import Markup

from rbpsym.frozen import Frozen
from rbpsym.teaching import model as m
from rbpsym.teaching.exports import question as q
from rbpsym.teaching.exports.bench import ExportDesk, Platform, in_packages, orders
from rbpsym.teaching.exports.page import identifier, mathml, written
from rbpsym.teaching.formats import Exported, Options


class OrderSteps(Frozen):
    """Steps to be put in order: what each says, and the orders that are right, the printed one first."""

    steps: tuple[str, ...]
    sample: tuple[int, ...]
    right: tuple[tuple[int, ...], ...]


class Signs(Frozen):
    """Rows with two inline choices each: head of the row, and (name, word, sign) of its fields."""

    rows: tuple[tuple[str, tuple[tuple[str, str, str], ...]], ...]
    each: float


def export_qti(worksheets: tuple[m.Worksheet, ...], options: Options) -> Exported:
    """A zip package for each student. Formulas are MathML, pictures SVG files."""
    return in_packages(worksheets, QTI, package)


def package(desk: ExportDesk) -> dict[str, bytes]:
    """The files of one package: the items, their pictures, the test and the manifest."""
    sheet = desk.worksheet
    title, names = desk.plain(sheet.title), {item.id: identifier(f"item {item.id}") for item in sheet.items}
    files = {f"{names[item.id]}.xml": question(item, desk, names[item.id], title) for item in sheet.items}
    files["test.xml"] = written("qti-test.xml", code=sheet.code, own=identifier(sheet.code), title=title, names=names.values())
    files |= desk.pictures
    files["imsmanifest.xml"] = written(
        "qti-manifest.xml", own=identifier(f"package {sheet.code}"), names=names.values(), pictures=desk.pictures
    )
    return files


def question(item: m.Item, desk: ExportDesk, name: str, title: str) -> bytes:
    """One item: declarations, body, processing, feedback."""
    form = q.asked_as(item, desk)
    return written(
        "qti-item.xml",
        kind=SHELLS[type(form)],
        form=form,
        item=item,
        desk=desk,
        own=name,
        title=title,
        text=Markup(desk.question(item)),
        rubric=Markup(q.rubric(item, desk)),
    )


SHELLS: Mapping[type, str] = {q.Number: "number", q.Choice: "choice", OrderSteps: "order", Signs: "signs", q.Essay: "text"}


def order(key: m.OrderKey, item: m.Item, desk: ExportDesk) -> OrderSteps:
    """All orders that keep the graph are right, as far as they can be listed."""
    right = orders(key)
    if right is None:
        desk.lacks(item, "orders")
    return OrderSteps(tuple(q.line_of(piece, desk) for piece in key.pieces), key.sample, tuple(right or [key.sample]))


def signs(key: m.SignsKey, item: m.Item, desk: ExportDesk) -> Signs:
    """A paragraph for each force."""
    q.note_cancelling(key, item, desk)
    rows = []
    for place, row in enumerate(key.rows, start=1):
        works = (("translational", row.translational), ("rotational", row.rotational))
        fields = tuple((f"{work[0].upper()}{place}", desk.word(work), SIGN_NAMES[sign]) for work, sign in works)
        rows.append((desk.inlines(row.label), fields))
    return Signs(tuple(rows), float(item.points) / (2 * len(rows)))


SIGN_NAMES = {"+": "plus", "-": "minus", "0": "zero"}
KINDS: Mapping[type, Any] = {m.OrderKey: order, m.SignsKey: signs, m.ExplanationKey: q.essay_with_sample}
LACKS: Mapping[str, str] = {
    "figures": "the unit is printed beside the field; unit and significant figures are not marked",
    "orders": "more than 24 orders are right: those that differ from the printed one are marked wrong",
}
QTI = Platform("QTI 2.1", mathml, kinds=KINDS, lacks=LACKS)
