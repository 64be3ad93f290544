"""QTI 1.2 packages for Canvas: one zip a student, to be imported as a quiz.

Canvas marks numbers between bounds, choices, and drop-downs; a formula is beyond it.
"""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.teaching.exports import question as q
from rbpsym.teaching.exports.bench import ExportDesk, Platform, in_packages
from rbpsym.teaching.exports.page import identifier, written
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet

SHELLS = {q.Number: "numerical", q.Choice: "multiple_choice", q.Fields: "multiple_dropdowns", q.Essay: "essay"}


def export_canvas(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """A zip package for each student."""
    return in_packages(worksheets, CANVAS, package)


def package(desk: ExportDesk) -> dict[str, bytes]:
    """The files of the package by path: the quiz, its settings, its pictures, and what says so."""
    sheet = desk.worksheet
    about = {"name": identifier(sheet.code), "title": f"{desk.plain(sheet.title)} {sheet.code}", "points": sheet.points}
    items = [(item, q.asked_as(item, desk), desk.question(item)) for item in sheet.items]
    pictures = {f"images/{path}": data for path, data in desk.pictures.items()}
    shown = {path: identifier(path) for path in pictures}
    return {
        f"{about['name']}/{about['name']}.xml": written("canvas.xml", items=items, desk=desk, kinds=SHELLS, **about),
        f"{about['name']}/assessment_meta.xml": written("canvas-settings.xml", **about),
        **pictures,
        "imsmanifest.xml": written("canvas-manifest.xml", pictures=shown, **about),
    }


LACKS: Mapping[str, str] = {
    "slips of numbers": "a number takes no feedback on misconceptions",
    "rubric": "the rubric and the sample answer are not shown to who marks it: they stand in the key",
}
CANVAS = Platform("Canvas", folder="%24IMS-CC-FILEBASE%24/images/", lacks=LACKS)
