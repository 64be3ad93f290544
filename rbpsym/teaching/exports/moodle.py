"""Moodle XML: numerical, multichoice, cloze and essay questions, and STACK questions for formulas.

Questions lie in a category for each item, one question a student, so that a quiz can draw at random.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Iterator, Mapping

from markupsafe import Markup

from rbpsym.document.model import Text
from rbpsym.frozen import Frozen
from rbpsym.statement.model import Problem
from rbpsym.statement.units import read_unit, unit_text
from rbpsym.teaching import model as m
from rbpsym.teaching.exports import question as q
from rbpsym.teaching.exports.bench import ExportDesk, Missing, Platform, by_items
from rbpsym.teaching.exports.names import maxima
from rbpsym.teaching.exports.page import filled, written
from rbpsym.teaching.exports.question import TypedFormulas
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Item
from rbpsym.teaching.wording import left_out, name_of

# --- STACK questions: a formula is compared by Maxima; the response tree asks for each misconception in turn
# Each question brings tests of its own: the right answer, and every anticipated wrong one, with the
# note at which the tree must arrive.


class ResponseNode(Frozen):
    """A node of the response tree: what the answer is compared with, what it then earns, and what is told."""

    against: str
    score: int
    told: str


class Tree(Frozen):
    """The field of a number with its right formula, its share of the points, and the tree: the right answer first."""

    number: int
    right: str
    share: float
    nodes: tuple[ResponseNode, ...]


class Stack(Frozen):
    """What a question of STACK has beyond others. tests: for each the node (from 0) at which each tree arrives."""

    variables: str
    trees: tuple[Tree, ...]
    tests: tuple[Mapping[int, int], ...]


def stack(form: TypedFormulas, item: Item, desk: ExportDesk) -> Stack:
    """The trees of all fields, and the tests: the right answers, then each wrong one in its field."""
    trees = tuple(_tree(entry, form.names, desk) for entry in form.entries)
    right = dict.fromkeys((tree.number for tree in trees), 0)
    wrong = ({**right, tree.number: place} for tree in trees for place in range(1, len(tree.nodes)))
    values = "".join(f"ta{tree.number}: {tree.right};\n" for tree in trees)
    return Stack(_assumptions(form.names, desk.worksheet.problems[item.asked.problem]) + values, trees, (right, *wrong))


def _tree(entry: m.Blank, names: Mapping[str, str], desk: ExportDesk) -> Tree:
    """Right? else each misconception; a node that fails leads to the next."""
    wrong = m.wrong_formulas(entry.anticipated)
    known = (ResponseNode(maxima(formula, names), 0, desk.feedback(slip)) for formula, slip in wrong)
    first = ResponseNode(f"ta{entry.number}", 1, f"<p>{desk.word('right')}</p>")
    return Tree(entry.number, maxima(entry.value, names), float(entry.points), (first, *known))


def _assumptions(names: Mapping[str, str], problem: Problem) -> str:
    """assume(m>0) for what is positive, so that roots are compared as we compare them."""
    positive = [names[q.name] for q in problem.parameters if q.sign == "positive" and q.name in names]
    return f"assume({', '.join(f'{name}>0' for name in positive)});\n" if positive else ""


# ---


OWN = "\ue000"  # marks our own fields until the text is written; no text of an author holds it
SHELLS = {q.Number: "numerical", q.Choice: "multichoice", q.Fields: "cloze", q.TypedFormulas: "stack", q.Essay: "essay"}


def export_moodle(worksheets: tuple[m.Worksheet, ...], options: Options) -> Exported:
    """One file of Moodle XML with all questions of all students."""
    parts: list[str] = []
    missing: Missing = []
    for row in by_items(worksheets, MOODLE, missing):
        item, desk = row[0]
        title = re.sub(r"/+", "-", desk.plain(desk.worksheet.title))
        parts.append(filled("moodle-category.xml", path=f"$course$/top/{title}/{item.id} {item.kind}"))
        parts += [question(item, desk) for item, desk in row]
    return Exported({"moodle.xml": written("moodle.xml", parts=map(Markup, parts))}, left_out("Moodle", missing))


def question(item: m.Item, desk: ExportDesk) -> str:
    """The question of one item, with its name, text, points and pictures."""
    form = q.asked_as(item, desk)
    text, told = desk.question(item) + above(form, desk), desk.solution(item)
    if isinstance(form, q.Fields):  # only our own fields are fields, whatever an author wrote
        text = re.sub(r"\{(?!" + OWN + ")", "&#123;", text).replace(OWN, "")
    return filled(
        "moodle-question.xml",
        kind=SHELLS[type(form)],
        form=form,
        item=item,
        desk=desk,
        called=name_of(item, desk.worksheet),
        text=text,
        told=told,
        pictures={name: base64.b64encode(data).decode() for name, data in desk.pictures.items()},
        units=list(units(form.key)) if isinstance(form, q.Number) else [],
        rubric=q.rubric(item, desk),
        stack=stack(form, item, desk) if isinstance(form, q.TypedFormulas) else None,
    )


def above(form: object, desk: ExportDesk) -> str:
    """What stands between the question and the fields."""
    if not isinstance(form, q.TypedFormulas):
        return getattr(form, "before", "") or getattr(form, "markup", "")
    fields = {e.number: f"[[input:ans{e.number}]] [[validation:ans{e.number}]]" for e in form.entries}
    if form.left is not None:
        return f"<p>{desk.formula(form.left)} = {fields[1]}</p>{q.legend(form.names, desk)}"
    rows = "".join(f"<li>{desk.word('blank')} {number}: {field}</li>" for number, field in fields.items())
    return f"<ul>{rows}</ul>{q.legend(form.names, desk)}"


def units(key: m.NumberKey) -> Iterator[tuple[str, float]]:
    """The spellings of units that are accepted, each with its factor to the printed one."""
    own = read_unit(key.measure.unit)
    for name in dict.fromkeys((key.measure.unit, *key.units)) if key.measure.unit else ():
        ways = dict.fromkeys((unit_text(name), name, name.replace("*", " "), name.replace("*", "·")))
        yield from ((way, own.factor / read_unit(name).factor) for way in ways)


def slip(key: m.SlipKey, item: m.Item, desk: ExportDesk) -> q.Choice:
    """The line with the slip, by its number; the corrected one is told with the right answer."""
    desk.lacks(item, "correction")
    options = (m.Option((Text(f"{desk.word('line')} {place + 1}"),)) for place in range(len(key.lines)))
    praise = f"{desk.feedback(key.slip)}<p>{desk.formula(key.corrected)}</p>"
    return q.Choice(tuple(options), key.wrong, q.lines(key.lines, desk), praise, shuffled=False)


def dropdown(field: q.DropDown) -> str:
    """A field of a cloze."""
    words = (("=" if place == field.right else "") + escaped(word) for place, word in enumerate(field.words))
    return "{" + OWN + "1:MULTICHOICE:" + "~".join(words) + "}"


def escaped(text: str) -> str:
    """Text within a field, its control characters escaped."""
    return re.sub(r"([}~#\"\\])", r"\\\1", text.replace("\n", " "))


LACKS: Mapping[str, str] = {
    "figures": "significant figures are not marked",
    "reason": "the reason of a comparison is asked in no second field: add an essay question for it",
    "correction": "the corrected formula is shown as feedback, not asked",
}
MOODLE = Platform(
    "Moodle",
    folder="@@PLUGINFILE@@/",
    kinds={m.FormulaKey: q.typed_formula, m.BlanksKey: q.typed_blanks, m.SlipKey: slip, m.ExplanationKey: q.essay_with_sample},
    lacks=LACKS,
    dropdown=dropdown,
)
