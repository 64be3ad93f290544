"""Moodle XML: numerical, multichoice, cloze and essay questions, and STACK questions for formulas.

Questions lie in a category for each item, one question a student, so that a quiz can draw at random.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from xml.etree.ElementTree import Element

from rbpsym.teaching.exports.bench import Desk, free_pairs, nearest_pairs
from rbpsym.teaching.exports.moodle_stack import stack_blanks, stack_formula
from rbpsym.teaching.exports.page import Paper
from rbpsym.teaching.exports.telling import left_out, name_of
from rbpsym.teaching.exports.xml import element, written
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import (
    BlanksKey,
    ChoiceKey,
    ComparisonKey,
    ExplanationKey,
    FormulaKey,
    Item,
    Measure,
    NumberKey,
    Option,
    OrderKey,
    SignsKey,
    SlipKey,
    Worksheet,
)
from rbpsym.teaching.units import unit_text

FOLDER = "@@PLUGINFILE@@/"
FIELD = "\ue000"  # marks our own fields until the text is written; no text of an author holds it


def export_moodle(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One file of Moodle XML with all questions of all students."""
    quiz, missing, number = element("quiz"), [], 0
    drawn: dict = {}
    for place in range(max((len(sheet.items) for sheet in worksheets), default=0)):
        for first, sheet in enumerate(worksheets):
            if place >= len(sheet.items):
                continue
            desk = Desk(sheet, Paper(folder=FOLDER, drawn=drawn), missing)
            if not first:
                quiz.append(_category(sheet.items[place], desk))
            quiz.append(question(sheet.items[place], desk))
            number += 1
    return Exported({"moodle.xml": written(quiz)}, left_out("Moodle", missing))


def _category(item: Item, desk: Desk) -> Element:
    title = re.sub(r"/+", "-", desk.plain(desk.worksheet.title))
    path = element("category", None, element("text", f"$course$/top/{title}/{item.id} {item.kind}"))
    return element("question", None, path, type="category")


def question(item: Item, desk: Desk) -> Element:
    """The question of one item, with its name, text, points and pictures."""
    made = KINDS[type(item.key)](item, desk)
    if made.get("type") == "cloze":
        _hide_braces(made.find("questiontext/text"))
    text = made.find("questiontext")
    for name, data in desk.paper.pictures.items():
        encoded = base64.b64encode(data).decode()
        text.append(element("file", encoded, name=name, path="/", encoding="base64"))
    return made


def _hide_braces(text: Element) -> None:
    """Only our own fields are fields, whatever an author wrote."""
    text.text = re.sub(r"\{(?!" + FIELD + ")", "&#123;", text.text).replace(FIELD, "")


def start(kind: str, item: Item, desk: Desk, more: str = "") -> Element:
    """A question with what all kinds have."""
    return element(
        "question", None,
        element("name", None, element("text", name_of(item, desk.worksheet))),
        html("questiontext", desk.question(item) + more),
        html("generalfeedback", desk.solution(item)),
        element("defaultgrade", f"{float(item.points):.7f}"),
        element("penalty", "0.3333333"),
        element("hidden", "0"),
        type=kind,
    )  # fmt: skip


def html(tag: str, markup: str, **attributes: str) -> Element:
    """An element that holds HTML as text."""
    return element(tag, None, element("text", markup), format="html", **attributes)


def answer(fraction: str, text: str, feedback: str, form: str = "html") -> Element:
    """An answer with the percentage that it earns."""
    return element("answer", None, element("text", text), html("feedback", feedback), fraction=fraction, format=form)


# --- kinds


def _number(item: Item, desk: Desk) -> Element:
    key: NumberKey = item.key
    made = start("numerical", item, desk)
    made.append(_numerical(key.measure, "100", float(key.tolerance.relative), f"<p>{desk.word('right')}</p>"))
    for known in key.anticipated:
        if known.number is not None:
            wrong = _numerical(known.number, "0", float(key.tolerance.relative) / 4, desk.feedback(known.slip))
            made.append(wrong)
    if key.measure.unit:
        made.append(element("units", None, *_units(key)))
    graded = "1" if key.measure.unit else "0"
    made.append(element("unitgradingtype", graded))
    made.append(element("unitpenalty", "0.2000000"))
    made.append(element("showunits", "0" if key.measure.unit else "3"))
    made.append(element("unitsleft", "0"))
    desk.lacks(item, "significant figures are not marked")
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    return made


def _numerical(measure: Measure, fraction: str, relative: float, feedback: str) -> Element:
    value = float(measure.value)
    made = answer(fraction, decimal(measure.value), feedback, "moodle_auto_format")
    made.append(element("tolerance", f"{max(abs(value) * relative, 1e-12):.6g}"))
    return made


def decimal(value: Fraction) -> str:
    """A number without rounding where it ends, with 15 digits where it does not."""
    return f"{float(value):.15g}"


def _units(key: NumberKey) -> list[Element]:
    """The units that are accepted, each with its factor to the printed one."""
    from rbpsym.teaching.grading.units import read_unit

    own, found = read_unit(key.measure.unit), []
    for name in dict.fromkeys((key.measure.unit, *key.units)):
        ways = dict.fromkeys((unit_text(name), name, name.replace("*", " "), name.replace("*", "·")))
        factor = own.factor / read_unit(name).factor
        found += [
            element("unit", None, element("multiplier", f"{factor:.15g}"), element("unit_name", way)) for way in ways
        ]
    return found


def _choice(item: Item, desk: Desk) -> Element:
    key: ChoiceKey | ComparisonKey = item.key
    if isinstance(key, ComparisonKey) and item.rubric:
        desk.lacks(item, "the reason of a comparison is asked in no second field: add an essay question for it")
    return _multichoice(item, desk, key.options, key.right)


def _multichoice(item: Item, desk: Desk, options: tuple[Option, ...], right: int) -> Element:
    made = start("multichoice", item, desk)
    for tag, text in (("single", "true"), ("shuffleanswers", "true"), ("answernumbering", "abc")):
        made.append(element(tag, text))
    for place, option in enumerate(options):
        is_right = place == right
        told = f"<p>{desk.word('right')}</p>" if is_right else desk.feedback(option.slip)
        made.append(answer("100" if is_right else "0", f"<p>{desk.inlines(option.content)}</p>", told))
    return made


def _slip(item: Item, desk: Desk) -> Element:
    key: SlipKey = item.key
    lines = "".join(f"<li>{desk.formula(line.statement)} {desk.inlines(line.reason)}</li>" for line in key.lines)
    made = start("multichoice", item, desk, f"<ol>{lines}</ol>")
    for tag, text in (("single", "true"), ("shuffleanswers", "false"), ("answernumbering", "none")):
        made.append(element(tag, text))
    for place in range(len(key.lines)):
        is_right = place == key.wrong
        told = desk.feedback(key.slip) + f"<p>{desk.formula(key.corrected)}</p>" if is_right else desk.feedback(None)
        made.append(answer("100" if is_right else "0", f"<p>{desk.word('line')} {place + 1}</p>", told))
    desk.lacks(item, "the corrected formula is shown as feedback, not asked")
    return made


def cloze(options: Mapping[str, bool], feedback: str = "") -> str:
    """A drop-down field: each text with whether it is right."""
    parts = (
        ("=" if right else "") + cloze_text(text) + _cloze_feedback(feedback, right) for text, right in options.items()
    )
    return "{" + FIELD + "1:MULTICHOICE:" + "~".join(parts) + "}"


def _cloze_feedback(feedback: str, right: bool) -> str:
    return "" if right or not feedback else "#" + cloze_text(feedback)


def cloze_text(text: str) -> str:
    """Text within a field, its control characters escaped."""
    return re.sub(r"([}~#\"\\])", r"\\\1", text.replace("\n", " "))


def _signs(item: Item, desk: Desk) -> Element:
    key: SignsKey = item.key
    rows = "".join(
        f"<tr><td>{desk.formula(row.force)} ({desk.inlines(row.label)})</td>"
        f"<td>{_sign_field(row.translational)}</td><td>{_sign_field(row.rotational)}</td></tr>"
        for row in key.rows
    )
    head = "".join(f"<th>{desk.word(name)}</th>" for name in ("row", "translational", "rotational"))
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "which works cancel is not asked")
    return start("cloze", item, desk, f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>")


def _sign_field(right: str) -> str:
    return cloze({shown: sign == right for sign, shown in (("+", "+"), ("-", "−"), ("0", "0"))})


def _order(item: Item, desk: Desk) -> Element:
    """Asked pair by pair, since more than one order may be right."""
    key: OrderKey = item.key
    lines = "".join(f"<li>{desk.formula(piece.statement)} {desk.inlines(piece.reason)}</li>" for piece in key.pieces)
    pairs = [(i, j, "before") for i, j in nearest_pairs(key)] + [(i, j, "either") for i, j in free_pairs(key)]
    asked = "".join(
        f"<li>{desk.word('step')} {i + 1} {_pair_field(right, desk)} {desk.word('step').lower()} {j + 1}</li>"
        for i, j, right in pairs
    )
    desk.lacks(item, "the order is asked pair by pair, since several orders may be right")
    return start("cloze", item, desk, f"<ol>{lines}</ol><p>{desk.word('pair')}</p><ul>{asked}</ul>")


def _pair_field(right: str, desk: Desk) -> str:
    return cloze({desk.word(key): key == right for key in ("before", "after", "either")})


def _essay(item: Item, desk: Desk) -> Element:
    made = start("essay", item, desk)
    rubric = "".join(f"<li>{desk.inlines(line.text)} ({float(line.points):g})</li>" for line in item.rubric)
    sample = desk.html(item.key.sample) if isinstance(item.key, ExplanationKey) else ""
    for tag, text in (
        ("responseformat", "editor"),
        ("responserequired", "1"),
        ("responsefieldlines", "10"),
        ("attachments", "0"),
    ):
        made.append(element(tag, text))
    heading = f"<p>{desk.word('rubric')}</p><ul>{rubric}</ul>" if rubric else ""
    made.append(html("graderinfo", f"{heading}<p>{desk.word('sample')}</p>{sample}"))
    return made


def _formula(item: Item, desk: Desk) -> Element:
    if item.key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    return stack_formula(item, desk, start("stack", item, desk))


def _blanks(item: Item, desk: Desk) -> Element:
    return stack_blanks(item, desk, start("stack", item, desk))


KINDS: Mapping[type, Callable[[Item, Desk], Element]] = {
    FormulaKey: _formula,
    NumberKey: _number,
    ChoiceKey: _choice,
    ComparisonKey: _choice,
    OrderKey: _order,
    SlipKey: _slip,
    SignsKey: _signs,
    BlanksKey: _blanks,
    ExplanationKey: _essay,
}
