"""The kinds of QTI 2.1 items: choices, orders, numbers, fields of signs, texts for the teacher."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from xml.etree.ElementTree import Element

from rbpsym.teaching.exports.bench import Desk, orders
from rbpsym.teaching.exports.xml import element, fragment
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
    Slip,
    SlipKey,
)
from rbpsym.teaching.units import unit_text

Parts = list[Element]
FEEDBACK = "FEEDBACK"


# --- declarations and processing


def response(name: str, cardinality: str, base: str, right: Iterable[str] = ()) -> Element:
    """The declaration of a response with its right values."""
    values = [element("value", text) for text in right]
    correct = [element("correctResponse", None, *values)] if values else []
    return element("responseDeclaration", None, *correct, identifier=name, cardinality=cardinality, baseType=base)


def outcomes(item: Item) -> Parts:
    """SCORE, MAXSCORE and the feedback to show."""
    most = element("defaultValue", None, element("value", f"{float(item.points):g}"))
    return [
        element("outcomeDeclaration", None, element("defaultValue", None, element("value", "0")),
                identifier="SCORE", cardinality="single", baseType="float"),
        element("outcomeDeclaration", None, most, identifier="MAXSCORE", cardinality="single", baseType="float"),
        element("outcomeDeclaration", None, identifier=FEEDBACK, cardinality="single", baseType="identifier"),
    ]  # fmt: skip


def body(item: Item, desk: Desk, *interactions: Element) -> Element:
    """The body: statement, what is asked, and the interactions."""
    statement = fragment(desk.question(item))
    return element("itemBody", None, *statement, *interactions)


def value(base: str, text: str) -> Element:
    """A constant."""
    return element("baseValue", text, baseType=base)


def variable(name: str) -> Element:
    """What was answered."""
    return element("variable", None, identifier=name)


def assign(name: str, expression: Element) -> Element:
    """Set an outcome."""
    return element("setOutcomeValue", None, expression, identifier=name)


def cases(tests: list[tuple[Element, Parts]], otherwise: Parts) -> Element:
    """if, else if, else."""
    (first, then), *rest = tests
    parts = [element("responseIf", None, first, *then)]
    parts += [element("responseElseIf", None, test, *then) for test, then in rest]
    return element("responseCondition", None, *parts, element("responseElse", None, *otherwise))


def processing(*rules: Element) -> Element:
    """The processing of the responses."""
    return element("responseProcessing", None, *rules)


def scored(points: float, feedback: str) -> Parts:
    """Points and the feedback to show."""
    return [assign("SCORE", value("float", f"{points:g}")), assign(FEEDBACK, value("identifier", feedback))]


def modal(name: str, markup: str) -> Element:
    """Feedback that is shown where FEEDBACK has this value."""
    return element(
        "modalFeedback", None, *fragment(markup), outcomeIdentifier=FEEDBACK, showHide="show", identifier=name
    )


def feedbacks(desk: Desk, slips: Mapping[str, Slip | None]) -> Parts:
    """The feedback for right answers, for each slip, and for any other answer."""
    told = [modal("right", f"<p>{desk.word('right')}</p>"), modal("wrong", f"<p>{desk.word('wrong')}</p>")]
    return told + [modal(name, desk.feedback(slip)) for name, slip in slips.items()]


# --- kinds


def _choice(item: Item, desk: Desk) -> Parts:
    key: ChoiceKey | ComparisonKey = item.key
    if isinstance(key, ComparisonKey) and item.rubric:
        desk.lacks(item, "the reason of a comparison is not asked in a second field")
    return choice(item, desk, key.options, key.right)


def choice(item: Item, desk: Desk, options: tuple[Option, ...], right: int, before: str = "") -> Parts:
    """One of several options; each wrong one with the feedback of its slip."""
    names = [f"option{place + 1}" for place in range(len(options))]
    shown = [
        element("simpleChoice", None, *fragment(f"<p>{desk.inlines(option.content)}</p>"), identifier=name)
        for name, option in zip(names, options, strict=True)
    ]
    field = element("choiceInteraction", None, *shown, responseIdentifier="RESPONSE", shuffle="false", maxChoices="1")
    slips = {f"slip{place + 1}": o.slip for place, o in enumerate(options) if place != right and o.slip}
    tests = [(_is("identifier", names[right]), scored(float(item.points), "right"))]
    tests += [(_is("identifier", names[int(name[4:]) - 1]), scored(0, name)) for name in slips]
    return [
        response("RESPONSE", "single", "identifier", [names[right]]), *outcomes(item),
        body(item, desk, *fragment(before), field), processing(cases(tests, scored(0, "wrong"))), *feedbacks(desk, slips),
    ]  # fmt: skip


def _is(base: str, text: str, name: str = "RESPONSE") -> Element:
    return element("match", None, variable(name), value(base, text))


def _number(item: Item, desk: Desk) -> Parts:
    key: NumberKey = item.key
    desk.lacks(item, "the unit is printed beside the field; unit and significant figures are not marked")
    if key.follows:
        desk.lacks(item, "an error carried forward from an earlier answer is not recognised")
    unit, percent = unit_text(key.measure.unit), float(key.tolerance.relative) * 100
    exact = key.exact / read_unit(key.measure.unit).factor
    field = element(
        "p",
        f"{desk.plain(())}",
        element("textEntryInteraction", None, responseIdentifier="RESPONSE", expectedLength="12"),
    )
    field[0].tail = f" {unit}"
    wrong = {f"slip{place + 1}": known for place, known in enumerate(key.anticipated) if known.number is not None}
    tests = [(_near(exact, percent), scored(float(item.points), "right"))]
    tests += [(_near(float(known.number.value), percent / 4), scored(0, name)) for name, known in wrong.items()]
    right = f"{float(key.measure.value):.15g}"
    return [
        response("RESPONSE", "single", "float", [right]), *outcomes(item), body(item, desk, field),
        processing(cases(tests, scored(0, "wrong"))), *feedbacks(desk, {name: known.slip for name, known in wrong.items()}),
    ]  # fmt: skip


def _near(number: float, percent: float) -> Element:
    """Within so many percent: between two bounds, which every player compares alike."""
    low, high = sorted(number * (1 + side * percent / 100) for side in (-1, 1))
    bounds = (("gte", low), ("lte", high))
    tests = (element(name, None, variable("RESPONSE"), value("float", f"{end:.12g}")) for name, end in bounds)
    return element("and", None, *tests)


def _order(item: Item, desk: Desk) -> Parts:
    key: OrderKey = item.key
    names = [f"step{place + 1}" for place in range(len(key.pieces))]
    shown = [
        element(
            "simpleChoice",
            None,
            *fragment(f"<p>{desk.formula(p.statement)} {desk.inlines(p.reason)}</p>"),
            identifier=name,
        )
        for name, p in zip(names, key.pieces, strict=True)
    ]
    field = element("orderInteraction", None, *shown, responseIdentifier="RESPONSE", shuffle="false")
    right = orders(key)
    if right is None:
        desk.lacks(item, "more than 24 orders are right: those that differ from the printed one are marked wrong")
    accepted = right or [key.sample]
    tests = [
        (element("match", None, variable("RESPONSE"), _ordered(names, order)), scored(float(item.points), "right"))
        for order in accepted
    ]
    return [
        response("RESPONSE", "ordered", "identifier", [names[place] for place in key.sample]), *outcomes(item),
        body(item, desk, field), processing(cases(tests, scored(0, "wrong"))), *feedbacks(desk, {}),
    ]  # fmt: skip


def _ordered(names: list[str], order: tuple[int, ...]) -> Element:
    return element("ordered", None, *(value("identifier", names[place]) for place in order))


def _slip(item: Item, desk: Desk) -> Parts:
    key: SlipKey = item.key
    desk.lacks(item, "the corrected formula is not asked")
    from rbpsym.document.model import Math, Text

    options = tuple(
        Option((Text(f"{desk.word('line')} {place + 1}: "), Math(line.statement)))
        for place, line in enumerate(key.lines)
    )
    return choice(item, desk, options, key.wrong)


def _signs(item: Item, desk: Desk) -> Parts:
    key: SignsKey = item.key
    if any(row.cancels for row in key.rows):
        desk.lacks(item, "which works cancel is not asked")
    names, rows, rules = [], [], []
    each = float(item.points) / (2 * len(key.rows))
    for place, row in enumerate(key.rows, start=1):
        line = fragment(f"<p>{desk.formula(row.force)} ({desk.inlines(row.label)})</p>")[0]
        for work, sign in (("translational", row.translational), ("rotational", row.rotational)):
            name = f"{work[0].upper()}{place}"
            names.append(response(name, "single", "identifier", [SIGN_NAMES[sign]]))
            line.append(_sign_field(name, desk.word(work)))
            rules.append(_sign_rule(name, sign, each))
        rows.append(line)
    return [*names, *outcomes(item), body(item, desk, *rows), processing(*rules)]


SIGN_NAMES = {"+": "plus", "-": "minus", "0": "zero"}


def _sign_field(name: str, label: str) -> Element:
    options = [element("inlineChoice", sign.replace("-", "−"), identifier=key) for sign, key in SIGN_NAMES.items()]
    found = element(
        "span",
        f" {label}: ",
        element("inlineChoiceInteraction", None, *options, responseIdentifier=name, shuffle="false"),
    )
    found.tail = " "
    return found


def _sign_rule(name: str, sign: str, points: float) -> Element:
    more = element("sum", None, variable("SCORE"), value("float", f"{points:.6g}"))
    test = _is("identifier", SIGN_NAMES[sign], name)
    return element("responseCondition", None, element("responseIf", None, test, assign("SCORE", more)))


def as_options(right: object, anticipated: tuple[Anticipated, ...]) -> tuple[Option, ...]:
    """A formula among its known wrong ones, in an order that tells nothing: by their length, then by their text."""
    from rbpsym.document.model import Math

    pairs = [(right, None), *((known.formula, known.slip) for known in anticipated if known.formula is not None)]
    pairs.sort(key=lambda pair: (len(str(pair[0])), str(pair[0])))
    return tuple(Option((Math(formula),), slip, formula) for formula, slip in pairs)


def _formula(item: Item, desk: Desk) -> Parts:
    key: FormulaKey = item.key
    options = as_options(key.value, key.anticipated)
    if len(options) < 3:
        desk.lacks(item, "a formula can't be compared: it is asked as a text that the teacher marks")
        return text_field(item, desk, f"<p>{desk.formula(key.left)} = …</p>", f"<p>{desk.formula(key.value)}</p>")
    desk.lacks(item, "a formula can't be compared: it is asked as a choice among the known wrong results")
    return choice(item, desk, options, next(i for i, option in enumerate(options) if option.slip is None))


def _blanks(item: Item, desk: Desk) -> Parts:
    key: BlanksKey = item.key
    desk.lacks(item, "a formula can't be compared: the blanks are asked as a text that the teacher marks")
    right = "".join(f"<p>{blank.number}: {desk.formula(blank.value)}</p>" for blank in key.blanks)
    return text_field(item, desk, "", right)


def _explanation(item: Item, desk: Desk) -> Parts:
    return text_field(item, desk, "", desk.html(item.key.sample))


def text_field(item: Item, desk: Desk, before: str, sample: str) -> Parts:
    """A field for words, with the rubric and a sample for who marks it."""
    lines = "".join(f"<li>{desk.inlines(line.text)} ({float(line.points):g})</li>" for line in item.rubric)
    told = f"<p>{desk.word('sample')}</p>{sample}" + (f"<ul>{lines}</ul>" if lines else "")
    rubric = element("rubricBlock", None, *fragment(told), view="scorer")
    field = element("extendedTextInteraction", None, responseIdentifier="RESPONSE", expectedLines="6")
    return [
        response("RESPONSE", "single", "string"),
        *outcomes(item),
        body(item, desk, rubric, *fragment(before), field),
    ]


KINDS: Mapping[type, Callable[[Item, Desk], Parts]] = {
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
