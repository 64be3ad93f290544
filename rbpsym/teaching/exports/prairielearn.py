"""PrairieLearn: a folder for each question with info.json, question.html and a server.py that holds data only."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from uuid import UUID, uuid5

from markupsafe import escape

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.notation import tree as t
from rbpsym.notation.latex import to_latex
from rbpsym.teaching.exports.bench import Desk
from rbpsym.teaching.exports.names import RESERVED, exported_names, sympy_text
from rbpsym.teaching.exports.packing import slug
from rbpsym.teaching.exports.page import Paper, between
from rbpsym.teaching.exports.telling import feedback, left_out
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.grading.units import read_unit
from rbpsym.teaching.model import (
    Anticipated,
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

OURS = UUID("6f0a1a5e-6a0e-5f6c-9a39-2d0c5b7f9d11")  # the space in which the ids of questions are made
DOLLARS = between("$", "$", ("$$", "$$"))


@dataclass(frozen=True)
class Made:
    """The fields of one question and the right answers, as data."""

    fields: str
    answers: dict[str, object] = field(default_factory=dict)
    manual: bool = False


def export_prairielearn(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """The folders of all questions of all students, under `questions`."""
    files: dict[str, str | bytes] = {}
    missing: list = []
    drawn: dict = {}
    for sheet in worksheets:
        for item in sheet.items:
            folder = f"questions/{slug(sheet.code)}/{slug(item.id)}"
            desk = Desk(sheet, Paper(DOLLARS, _picture, drawn=drawn), missing)
            files |= {f"{folder}/{path}": content for path, content in question(item, desk).items()}
    return Exported(files, left_out("PrairieLearn", missing))


def _picture(path: str, alt: str) -> str:
    return f'<pl-figure file-name="{escape(path)}" alt="{escape(alt)}"></pl-figure>'


def question(item: Item, desk: Desk) -> dict[str, str | bytes]:
    """The files of one question by path."""
    text, made = desk.question(item), KINDS[type(item.key)](item, desk)
    page = f"<pl-question-panel>\n{text}\n</pl-question-panel>\n{made.fields}\n"
    if item.solution:
        page += f"<pl-answer-panel>\n{desk.solution(item)}\n</pl-answer-panel>\n"
    files: dict[str, str | bytes] = {
        "info.json": json.dumps(_info(item, desk, made), ensure_ascii=False, indent=2) + "\n",
        "question.html": page.replace("{{", "{ {").replace("}}", "} }"),  # not a place to be filled there
        "server.py": server(made.answers),
    }
    return files | {f"clientFilesQuestion/{name}": data for name, data in desk.paper.pictures.items()}


def _info(item: Item, desk: Desk, made: Made) -> dict[str, object]:
    sheet = desk.worksheet
    info: dict[str, object] = {
        "uuid": str(uuid5(OURS, f"{sheet.code} {item.id}")),
        "title": f"{desk.plain(sheet.title)} {item.id}",
        "topic": desk.plain(sheet.part_of(item.id).title),
        "tags": [item.kind, sheet.language],
        "type": "v3",
        "singleVariant": True,
    }
    return {**info, "gradingMethod": "Manual"} if made.manual else info


def server(answers: Mapping[str, object]) -> str:
    """A server.py that enters the right answers, written as literals; it computes nothing."""
    rows = "".join(f'    data["correct_answers"][{name!r}] = {value!r}\n' for name, value in answers.items())
    return f"def generate(data):\n{rows or '    pass' + chr(10)}"


# --- kinds


def _attribute(inlines: Inlines, desk: Desk) -> str:
    """Inlines within an attribute: text and formulas between dollars."""
    shown = (
        f"${to_latex(part.node, desk.worksheet.notation)}$" if isinstance(part, Math) else desk.plain((part,))
        for part in inlines
    )
    return str(escape("".join(shown)))


def _options(item: Item, desk: Desk, options: tuple[Option, ...], right: int) -> Made:
    lines = []
    for place, option in enumerate(options):
        told = "" if place == right else f' feedback="{_attribute(feedback(option.slip, desk.worksheet), desk)}"'
        truth = "true" if place == right else "false"
        lines.append(f'  <pl-answer correct="{truth}"{told}>{desk.inlines(option.content)}</pl-answer>')
    return Made(
        f'<pl-multiple-choice answers-name="choice" order="fixed">\n{chr(10).join(lines)}\n</pl-multiple-choice>'
    )


def _choice(item: Item, desk: Desk) -> Made:
    made = _options(item, desk, item.key.options, item.key.right)
    if not (isinstance(item.key, ComparisonKey) and item.rubric):
        return made
    desk.lacks(item, "the reason of a comparison is asked in a field that the teacher marks")
    return Made(f"{made.fields}\n{_words(desk)}", made.answers)


def _words(desk: Desk) -> str:
    return f'<p>{desk.word("explain")}</p>\n<pl-rich-text-editor file-name="answer.html"></pl-rich-text-editor>'


def _number(item: Item, desk: Desk) -> Made:
    key: NumberKey = item.key
    if key.anticipated:
        desk.lacks(item, "a number or formula takes no feedback on misconceptions, since server.py holds data only")
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    reach = f'comparison="relabs" rtol="{float(key.tolerance.relative):g}" atol="1e-12"'
    label = f'label="{_attribute((Math(key.left), Text(" =")), desk)}"'
    desk.lacks(item, "significant figures are not marked")
    exact = key.exact / read_unit(key.measure.unit).factor
    if not read_unit(key.measure.unit).dimension:
        suffix = f' suffix="{escape(key.measure.unit)}"' if key.measure.unit else ""
        return Made(
            f'<pl-number-input answers-name="number" {reach} {label}{suffix}></pl-number-input>', {"number": exact}
        )
    unit = key.measure.unit.replace("^", "**")
    shown = f'<pl-units-input answers-name="number" grading-mode="with-units" {reach} {label}></pl-units-input>'
    return Made(shown, {"number": f"{exact:.10g} {unit}"})


def _symbolic(name: str, label: Inlines, names: Mapping[str, str], desk: Desk) -> str:
    typed = ", ".join(sorted(names.values()))
    return (
        f'<pl-symbolic-input answers-name="{name}" variables="{escape(typed)}"'
        f' label="{_attribute(label, desk)}"></pl-symbolic-input>'
    )


def _names(item: Item, desk: Desk, *formulas: t.Node) -> dict[str, str]:
    used = set(item.key.names).union(*map(t.names, formulas)) - {"pi"}
    return exported_names(used, desk.worksheet.problems[item.asked.problem], RESERVED)


def _note_slips(item: Item, desk: Desk, anticipated: tuple[Anticipated, ...]) -> None:
    if anticipated:
        desk.lacks(item, "a number or formula takes no feedback on misconceptions, since server.py holds data only")


def _formula(item: Item, desk: Desk) -> Made:
    key: FormulaKey = item.key
    _note_slips(item, desk, key.anticipated)
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    names = _names(item, desk, key.value)
    legend = f"<p>{desk.word('type')} {_legend(names, desk)}</p>\n"
    shown = _symbolic("formula", (Math(key.left), Text(" =")), names, desk)
    return Made(legend + shown, {"formula": sympy_text(key.value, names)})


def _legend(names: Mapping[str, str], desk: Desk) -> str:
    return ", ".join(
        f"{desk.formula(t.Sym(name))}: <code>{escape(typed)}</code>" for name, typed in sorted(names.items())
    )


def _blanks(item: Item, desk: Desk) -> Made:
    key: BlanksKey = item.key
    names = _names(item, desk, *(blank.value for blank in key.blanks))
    fields, answers = [f"<p>{desk.word('type')} {_legend(names, desk)}</p>"], {}
    for blank in key.blanks:
        _note_slips(item, desk, blank.anticipated)
        fields.append(_symbolic(f"blank{blank.number}", (Text(f"{desk.word('blank')} {blank.number}:"),), names, desk))
        answers[f"blank{blank.number}"] = sympy_text(blank.value, names)
    return Made("\n".join(fields), answers)


def _order(item: Item, desk: Desk) -> Made:
    """Blocks with the graph of what they depend on: every order that keeps it is right."""
    key: OrderKey = item.key
    lines = []
    for place, piece in enumerate(key.pieces):
        needs = ",".join(f"step{i}" for i, j in sorted(key.before) if j == place)
        shown = f"{desk.formula(piece.statement)} {desk.inlines(piece.reason)}"
        lines.append(f'  <pl-answer correct="true" tag="step{place}" depends="{needs}">{shown}</pl-answer>')
    opening = '<pl-order-blocks answers-name="order" grading-method="dag" indentation="false">'
    return Made("\n".join((opening, *lines, "</pl-order-blocks>")))


def _slip(item: Item, desk: Desk) -> Made:
    key: SlipKey = item.key
    desk.lacks(item, "the corrected formula is not asked")
    options = tuple(
        Option((Text(f"{desk.word('line')} {place + 1}: "), Math(line.statement)))
        for place, line in enumerate(key.lines)
    )
    return _options(item, desk, options, key.wrong)


def _signs(item: Item, desk: Desk) -> Made:
    key: SignsKey = item.key
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "which works cancel is not asked")
    rows = ""
    for place, row in enumerate(key.rows, start=1):
        cells = "".join(
            f"<td>{_dropdown(f'{work}{place}', sign)}</td>"
            for work, sign in (("T", row.translational), ("R", row.rotational))
        )
        rows += f"<tr><td>{desk.formula(row.force)} ({desk.inlines(row.label)})</td>{cells}</tr>\n"
    head = "".join(f"<th>{desk.word(name)}</th>" for name in ("row", "translational", "rotational"))
    return Made(f'<table class="table">\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>')


def _dropdown(name: str, right: str) -> str:
    options = "".join(
        f'<pl-answer correct="{"true" if sign == right else "false"}">{sign.replace("-", "−")}</pl-answer>'
        for sign in "+-0"
    )
    return f'<pl-dropdown answers-name="{name}">{options}</pl-dropdown>'


def _explanation(item: Item, desk: Desk) -> Made:
    desk.lacks(item, "the rubric is not carried: it stands in the key")
    return Made(_words(desk), manual=True)


KINDS: Mapping[type, Callable[[Item, Desk], Made]] = {
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
