"""QTI 1.2 packages for Canvas: one zip a student, to be imported as a quiz.

Canvas marks numbers between bounds, choices, and drop-downs; a formula is beyond it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from xml.etree.ElementTree import Element

from rbpsym.document.model import Math, Text
from rbpsym.teaching.exports.bench import Desk, free_pairs, nearest_pairs
from rbpsym.teaching.exports.canvas_package import package
from rbpsym.teaching.exports.packing import slug, zipped
from rbpsym.teaching.exports.page import Paper
from rbpsym.teaching.exports.qti_items import as_options
from rbpsym.teaching.exports.telling import left_out
from rbpsym.teaching.exports.xml import element
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

FOLDER = "%24IMS-CC-FILEBASE%24/images/"
Fields = Mapping[str, tuple[tuple[str, ...], int]]


def export_canvas(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """A zip package for each student."""
    files, missing, drawn = {}, [], {}
    for sheet in worksheets:
        desk = Desk(sheet, Paper(folder=FOLDER, drawn=drawn), missing)
        items = [KINDS[type(item.key)](item, desk) for item in sheet.items]
        files[f"{slug(sheet.code)}.canvas.zip"] = zipped(package(desk, items))
    return Exported(files, left_out("Canvas", missing))


# --- pieces of an item


def material(markup: str) -> Element:
    """HTML as material."""
    return element("material", None, element("mattext", markup, texttype="text/html"))


def item_element(
    item: Item, kind: str, presentation: list[Element], processing: list[Element], feedback: Mapping[str, str]
) -> Element:
    """One item with its type, points, text, processing and feedback."""
    fields = {"question_type": kind, "points_possible": f"{float(item.points):g}"}
    told = (
        element("qtimetadatafield", None, element("fieldlabel", key), element("fieldentry", value))
        for key, value in fields.items()
    )
    score = element("decvar", None, maxvalue="100", minvalue="0", varname="SCORE", vartype="Decimal")
    notes = [
        element("itemfeedback", None, element("flow_mat", None, material(markup)), ident=f"{name}_fb")
        for name, markup in feedback.items()
    ]
    return element(
        "item", None, element("itemmetadata", None, element("qtimetadata", None, *told)),
        element("presentation", None, *presentation),
        element("resprocessing", None, element("outcomes", None, score), *processing), *notes,
        ident=f"item{item.id}", title=item.id,
    )  # fmt: skip


def condition(test: Element, *then: Element, goes_on: bool = False) -> Element:
    """One rule of processing."""
    return element(
        "respcondition", None, element("conditionvar", None, test), *then, continue_="Yes" if goes_on else "No"
    )


def score(value: str, action: str = "Set") -> Element:
    """Set the score, or add to it (out of 100)."""
    return element("setvar", value, action=action, varname="SCORE")


def note(name: str) -> Element:
    """Show a feedback."""
    return element("displayfeedback", None, feedbacktype="Response", linkrefid=f"{name}_fb")


def answered(text: str, name: str = "response1") -> Element:
    """Is this the response?"""
    return element("varequal", text, respident=name)


# --- kinds


def choice(item: Item, desk: Desk, options: tuple[Option, ...], right: int, before: str = "") -> Element:
    """One of several options."""
    names = [f"{item.id}{place + 1:03d}" for place in range(len(options))]
    labels = [
        element("response_label", None, material(desk.inlines(option.content)), ident=name)
        for name, option in zip(names, options, strict=True)
    ]
    field = element(
        "response_lid", None, element("render_choice", None, *labels), ident="response1", rcardinality="Single"
    )
    notes = {
        name: desk.feedback(o.slip)
        for place, (name, o) in enumerate(zip(names, options, strict=True))
        if place != right and o.slip
    }
    rules = [condition(answered(name), note(name), goes_on=True) for name in notes]
    rules.append(condition(answered(names[right]), score("100")))
    text = material(desk.question(item) + before)
    return item_element(item, "multiple_choice_question", [text, field], rules, notes)


def _choice(item: Item, desk: Desk) -> Element:
    if isinstance(item.key, ComparisonKey) and item.rubric:
        desk.lacks(item, "the reason of a comparison is not asked in a second field")
    return choice(item, desk, item.key.options, item.key.right)


def _number(item: Item, desk: Desk) -> Element:
    key: NumberKey = item.key
    desk.lacks(item, "the unit is printed in the question; unit and significant figures are not marked")
    if key.anticipated:
        desk.lacks(item, "a number takes no feedback on misconceptions")
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    exact = key.exact / read_unit(key.measure.unit).factor
    reach = float(key.tolerance.relative)
    low, high = sorted((exact * (1 - reach), exact * (1 + reach)))
    bounds = element(
        "and",
        None,
        element("vargte", f"{low:.10g}", respident="response1"),
        element("varlte", f"{high:.10g}", respident="response1"),
    )
    test = element("or", None, answered(f"{float(key.measure.value):.15g}"), bounds)
    unit = f"<p>[{desk.word('unit')}: {unit_text(key.measure.unit)}]</p>" if key.measure.unit else ""
    box = element("render_fib", None, element("response_label", None, ident="answer1"), fibtype="Decimal")
    field = element("response_str", None, box, ident="response1", rcardinality="Single")
    return item_element(
        item, "numerical_question", [material(desk.question(item) + unit), field], [condition(test, score("100"))], {}
    )


def dropdowns(item: Item, desk: Desk, markup: str, fields: Fields) -> Element:
    """Fields [name] in the text, each with its options and the place of the right one."""
    shown, rules = [material(desk.question(item) + markup)], []
    for name, (options, right) in fields.items():
        labels = [
            element("response_label", None, element("material", None, element("mattext", text)), ident=f"{name}{place}")
            for place, text in enumerate(options)
        ]
        inner = (element("material", None, element("mattext", name)), element("render_choice", None, *labels))
        shown.append(element("response_lid", None, *inner, ident=f"response_{name}"))
        rules.append(
            condition(answered(f"{name}{right}", f"response_{name}"), score(f"{100 / len(fields):.4f}", "Add"))
        )
    return item_element(item, "multiple_dropdowns_question", shown, rules, {})


SIGNS = ("+", "−", "0")


def _signs(item: Item, desk: Desk) -> Element:
    key: SignsKey = item.key
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "which works cancel is not asked")
    fields: dict[str, tuple[tuple[str, ...], int]] = {}
    rows = ""
    for place, row in enumerate(key.rows, start=1):
        for work, sign in (("T", row.translational), ("R", row.rotational)):
            fields[f"{work}{place}"] = (SIGNS, SIGNS.index(sign.replace("-", "−")))
        rows += f"<tr><td>{desk.formula(row.force)} ({desk.inlines(row.label)})</td><td>[T{place}]</td><td>[R{place}]</td></tr>"
    head = "".join(f"<th>{desk.word(name)}</th>" for name in ("row", "translational", "rotational"))
    return dropdowns(item, desk, f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>", fields)


def _order(item: Item, desk: Desk) -> Element:
    key: OrderKey = item.key
    desk.lacks(item, "the order is asked pair by pair, since several orders may be right")
    lines = "".join(f"<li>{desk.formula(piece.statement)} {desk.inlines(piece.reason)}</li>" for piece in key.pieces)
    words = tuple(desk.word(name) for name in ("before", "after", "either"))
    fields: dict[str, tuple[tuple[str, ...], int]] = {}
    asked = ""
    for number, (i, j, right) in enumerate(
        [*((i, j, 0) for i, j in nearest_pairs(key)), *((i, j, 2) for i, j in free_pairs(key))]
    ):
        fields[f"P{number + 1}"] = (words, right)
        asked += f"<li>{desk.word('step')} {i + 1} [P{number + 1}] {desk.word('step').lower()} {j + 1}</li>"
    return dropdowns(item, desk, f"<ol>{lines}</ol><p>{desk.word('pair')}</p><ul>{asked}</ul>", fields)


def _slip(item: Item, desk: Desk) -> Element:
    key: SlipKey = item.key
    desk.lacks(item, "the corrected formula is not asked")
    options = tuple(
        Option((Text(f"{desk.word('line')} {place + 1}: "), Math(line.statement)))
        for place, line in enumerate(key.lines)
    )
    return choice(item, desk, options, key.wrong)


def _formula(item: Item, desk: Desk) -> Element:
    key: FormulaKey = item.key
    options = as_options(key.value, key.anticipated)
    if len(options) < 3:
        desk.lacks(item, "a formula can't be compared: it is asked as a text that the teacher marks")
        return essay(item, desk, f"<p>{desk.formula(key.left)} = …</p>")
    desk.lacks(item, "a formula can't be compared: it is asked as a choice among the known wrong results")
    return choice(item, desk, options, next(i for i, option in enumerate(options) if option.slip is None))


def _blanks(item: Item, desk: Desk) -> Element:
    desk.lacks(item, "a formula can't be compared: the blanks are asked as a text that the teacher marks")
    return essay(item, desk, "")


def _explanation(item: Item, desk: Desk) -> Element:
    desk.lacks(item, "the rubric and the sample answer are not shown to who marks it: they stand in the key")
    return essay(item, desk, "")


def essay(item: Item, desk: Desk, before: str) -> Element:
    """A field for words."""
    box = element("render_fib", None, element("response_label", None, ident="answer1", rshuffle="No"))
    field = element("response_str", None, box, ident="response1", rcardinality="Single")
    rule = condition(element("other"))
    return item_element(item, "essay_question", [material(desk.question(item) + before), field], [rule], {})


KINDS: Mapping[type, Callable[[Item, Desk], Element]] = {
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
