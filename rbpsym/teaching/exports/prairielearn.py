"""PrairieLearn: a folder for each question with info.json, question.html and a server.py that holds data only."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any
from uuid import UUID, uuid5

from markupsafe import Markup, escape

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.document.writers.page import shell
from rbpsym.frozen import Frozen
from rbpsym.statement.units import read_unit
from rbpsym.teaching import model as m
from rbpsym.teaching.exports import question as q
from rbpsym.teaching.exports.bench import Drawn, ExportDesk, Missing, Platform
from rbpsym.teaching.exports.names import sympy_text
from rbpsym.teaching.exports.page import between, slug
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.wording import feedback, left_out
from rbpsym.typeset.latex import to_latex

OURS = UUID("6f0a1a5e-6a0e-5f6c-9a39-2d0c5b7f9d11")  # the space in which the ids of questions are made


class OrderBlocks(Frozen):
    """Blocks with the graph of what they depend on (text, places): every order that keeps it is right."""

    blocks: tuple[tuple[str, str], ...]


def export_prairielearn(worksheets: tuple[m.Worksheet, ...], options: Options) -> Exported:
    """The folders of all questions of all students, under `questions`."""
    files: dict[str, str | bytes] = {}
    missing: Missing = []
    drawn: Drawn = {}
    for sheet in worksheets:
        for item in sheet.items:
            folder = f"questions/{slug(sheet.code)}/{slug(item.id)}"
            desk = ExportDesk(sheet, PRAIRIELEARN, missing, drawn)
            files |= {f"{folder}/{path}": content for path, content in question(item, desk).items()}
    return Exported(files, left_out("PrairieLearn", missing))


def question(item: m.Item, desk: ExportDesk) -> dict[str, str | bytes]:
    """The files of one question by path."""
    text, form = desk.question(item), q.asked_as(item, desk)
    kind, answers = SHELLS[type(form)](form, item, desk)
    page = shell(
        "lms/prairielearn.html",
        autoescape=True,
        kind=kind,
        form=form,
        item=item,
        desk=desk,
        text=Markup(text),
        solution=Markup(desk.solution(item)) if item.solution else "",
        label=lambda *inlines: attribute(inlines, desk),
        told=lambda option: attribute(feedback(option.slip, desk.worksheet), desk),
        left=(Math(item.key.left), Text(" =")) if hasattr(item.key, "left") else (),
        legend=Markup(q.legend(form.names, desk)) if isinstance(form, q.TypedFormulas) else "",
        has_reason=isinstance(item.key, m.ExplanationKey) or bool(isinstance(item.key, m.ComparisonKey) and item.rubric),
        is_pure=isinstance(form, q.Number) and not read_unit(form.key.measure.unit).dimension,
    )
    files: dict[str, str | bytes] = {
        "info.json": json.dumps(info(item, desk), ensure_ascii=False, indent=2) + "\n",
        "question.html": page.replace("{{", "{ {").replace("}}", "} }"),  # not a place to be filled there
        "server.py": server(answers),
    }
    return files | {f"clientFilesQuestion/{name}": data for name, data in desk.pictures.items()}


def info(item: m.Item, desk: ExportDesk) -> dict[str, object]:
    """What a question says of itself."""
    sheet = desk.worksheet
    found: dict[str, object] = {
        "uuid": str(uuid5(OURS, f"{sheet.code} {item.id}")),
        "title": f"{desk.plain(sheet.title)} {item.id}",
        "topic": desk.plain(sheet.part_of(item.id).title),
        "tags": [item.kind, sheet.language],
        "type": "v3",
        "singleVariant": True,
    }
    return found | ({"gradingMethod": "Manual"} if isinstance(item.key, m.ExplanationKey) else {})


def server(answers: Mapping[str, object]) -> str:
    """A server.py that enters the right answers, written as literals; it computes nothing."""
    rows = "".join(f'    data["correct_answers"][{name!r}] = {value!r}\n' for name, value in answers.items())
    return f"def generate(data):\n{rows or '    pass' + chr(10)}"


def attribute(inlines: Inlines, desk: ExportDesk) -> str:
    """Inlines within an attribute: text and formulas between dollars."""
    shown = (
        f"${to_latex(part.node, desk.worksheet.notation)}$" if isinstance(part, Math) else desk.plain((part,)) for part in inlines
    )
    return "".join(shown)


def dropdown(field: q.DropDown) -> str:
    """A drop-down within text."""
    options = "".join(
        f'<pl-answer correct="{"true" if place == field.right else "false"}">{escape(word)}</pl-answer>'
        for place, word in enumerate(field.words)
    )
    return f'<pl-dropdown answers-name="{field.name}">{options}</pl-dropdown>'


def picture(path: str, alt: str) -> str:
    """A picture of the question."""
    return f'<pl-figure file-name="{escape(path)}" alt="{escape(alt)}"></pl-figure>'


def order(key: m.OrderKey, item: m.Item, desk: ExportDesk) -> OrderBlocks:
    """The graph of an order."""
    needs = (",".join(f"step{i}" for i, j in sorted(key.before) if j == place) for place in range(len(key.pieces)))
    return OrderBlocks(tuple(zip((q.line_of(piece, desk) for piece in key.pieces), needs, strict=True)))


def _number(form: q.Number, item: m.Item, desk: ExportDesk) -> tuple[str, dict[str, object]]:
    unit = form.key.measure.unit.replace("^", "**")
    return "number", {"number": f"{form.exact:.10g} {unit}" if read_unit(form.key.measure.unit).dimension else form.exact}


def _formulas(form: q.TypedFormulas, item: m.Item, desk: ExportDesk) -> tuple[str, dict[str, object]]:
    names = ("formula",) if form.left is not None else (f"blank{entry.number}" for entry in form.entries)
    return "formulas", {n: sympy_text(e.value, form.names) for n, e in zip(names, form.entries, strict=True)}


SHELLS: Mapping[type, Callable[[Any, m.Item, ExportDesk], tuple[str, dict[str, object]]]] = {
    q.Number: _number,
    q.TypedFormulas: _formulas,
    q.Choice: lambda form, item, desk: ("choice", {}),
    q.Fields: lambda form, item, desk: ("fields", {}),
    q.Essay: lambda form, item, desk: ("essay", {}),
    OrderBlocks: lambda form, item, desk: ("order", {}),
}
NO_COMMENT = "a number or formula takes no feedback on misconceptions, since server.py holds data only"
LACKS: Mapping[str, str] = {
    "slips of numbers": NO_COMMENT,
    "slips of formulas": NO_COMMENT,
    "figures": "significant figures are not marked",
    "reason": "the reason of a comparison is asked in a field that the teacher marks",
    "rubric": "the rubric is not carried: it stands in the key",
}
PRAIRIELEARN = Platform(
    "PrairieLearn",
    between("$", "$", ("$$", "$$")),
    picture,
    kinds={m.FormulaKey: q.typed_formula, m.BlanksKey: q.typed_blanks, m.OrderKey: order},
    lacks=LACKS,
    dropdown=dropdown,
)
