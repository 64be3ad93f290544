"""STACK questions: a formula is compared by Maxima; the response tree asks for each misconception in turn.

Each question brings tests of its own: the right answer, and every anticipated wrong one, with the
note at which the tree must arrive.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from xml.etree.ElementTree import Element

from markupsafe import escape

from rbpsym.notation import tree as t
from rbpsym.teaching.exports.bench import Desk
from rbpsym.teaching.exports.names import RESERVED, exported_names, maxima
from rbpsym.teaching.exports.xml import element
from rbpsym.teaching.model import Anticipated, BlanksKey, FormulaKey, Item

VERSION = "2023121100"
SETTINGS = (
    ("questionsimplify", "1"), ("assumepositive", "0"), ("assumereal", "1"), ("decimals", "."), ("multiplicationsign", "dot"),
    ("sqrtsign", "1"), ("complexno", "i"), ("inversetrig", "cos-1"), ("logicsymbol", "lang"), ("matrixparens", "["),
)  # fmt: skip
INPUT = (
    ("type", "algebraic"), ("tans", ""), ("boxsize", "40"), ("strictsyntax", "1"), ("insertstars", "1"), ("syntaxhint", ""),
    ("syntaxattribute", "0"), ("forbidwords", ""), ("allowwords", ""), ("forbidfloat", "0"), ("requirelowestterms", "0"),
    ("checkanswertype", "0"), ("mustverify", "1"), ("showvalidation", "2"), ("options", ""),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Entry:
    """One field: its number, the right formula, known wrong ones, and its share of the points."""

    number: int
    value: t.Node
    anticipated: tuple[Anticipated, ...]
    share: Fraction

    @property
    def wrong(self) -> tuple[Anticipated, ...]:
        """The known wrong formulas."""
        return tuple(known for known in self.anticipated if known.formula is not None)


def stack_formula(item: Item, desk: Desk, made: Element) -> Element:
    """A question with one field, completed."""
    key: FormulaKey = item.key
    entry = Entry(1, key.value, key.anticipated, Fraction(1))
    return _completed(made, item, desk, (entry,), f"<p>{desk.formula(key.left)} = {_field(1)}</p>")


def stack_blanks(item: Item, desk: Desk, made: Element) -> Element:
    """A question with a field for each blank."""
    key: BlanksKey = item.key
    whole = sum((blank.points for blank in key.blanks), Fraction(0)) or Fraction(1)
    entries = tuple(Entry(b.number, b.value, b.anticipated, b.points / whole) for b in key.blanks)
    rows = "".join(f"<li>{desk.word('blank')} {entry.number}: {_field(entry.number)}</li>" for entry in entries)
    return _completed(made, item, desk, entries, f"<ul>{rows}</ul>")


def _field(number: int) -> str:
    return f"[[input:ans{number}]] [[validation:ans{number}]]"


def _completed(made: Element, item: Item, desk: Desk, entries: tuple[Entry, ...], fields: str) -> Element:
    problem = desk.worksheet.problems[item.asked.problem]
    formulas = [e.value for e in entries] + [known.formula for e in entries for known in e.wrong]
    used = set(item.key.names).union(*map(t.names, formulas)) - {"pi"}
    names = exported_names(used, problem, RESERVED)
    text = made.find("questiontext/text")
    text.text = (text.text or "") + fields + _legend(names, desk)
    variables = "".join(f"ta{e.number}: {maxima(e.value, names)};\n" for e in entries)
    variables = _assumptions(names, problem) + variables
    made.append(element("stackversion", None, element("text", VERSION)))
    made.append(element("questionvariables", None, element("text", variables)))
    shown = "".join(f"[[feedback:prt{e.number}]]" for e in entries)
    made.append(_html("specificfeedback", f"<p>{shown}</p>"))
    made.append(_html("questionnote", str(escape(desk.worksheet.code))))
    for name, value in SETTINGS:
        made.append(element(name, value))
    for name, key in (("prtcorrect", "right"), ("prtpartiallycorrect", "wrong"), ("prtincorrect", "wrong")):
        made.append(_html(name, f"<p>{desk.word(key)}</p>"))
    made.extend(_input(entry) for entry in entries)
    made.extend(_tree(entry, names, desk) for entry in entries)
    made.extend(_tests(entries, names))
    return made


def _html(tag: str, markup: str) -> Element:
    return element(tag, None, element("text", markup), format="html")


def _legend(names: dict[str, str], desk: Desk) -> str:
    """What is typed for each letter."""
    pairs = ", ".join(
        f"{desk.formula(t.Sym(name))}: <code>{escape(typed)}</code>" for name, typed in sorted(names.items())
    )
    return f"<p>{desk.word('type')} {pairs}</p>"


def _assumptions(names: dict[str, str], problem: object) -> str:
    """assume(m>0) for what is positive, so that roots are compared as we compare them."""
    positive = [q.name for q in problem.parameters if q.sign == "positive" and q.name in names]
    return f"assume({', '.join(f'{names[name]}>0' for name in positive)});\n" if positive else ""


def _input(entry: Entry) -> Element:
    given = {"tans": f"ta{entry.number}"}
    parts = [element(name, given.get(name, value)) for name, value in INPUT]
    return element("input", None, element("name", f"ans{entry.number}"), *parts)


def _tree(entry: Entry, names: dict[str, str], desk: Desk) -> Element:
    """The response tree: right? else each misconception; a node that fails leads to the next."""
    count = len(entry.wrong)
    nodes = [_node(0, entry, f"ta{entry.number}", "1", f"<p>{desk.word('right')}</p>", count > 0, desk)]
    for place, known in enumerate(entry.wrong, start=1):
        formula = maxima(known.formula, names)
        nodes.append(_node(place, entry, formula, "0", desk.feedback(known.slip), place < count, desk))
    return element(
        "prt", None,
        element("name", f"prt{entry.number}"), element("value", f"{float(entry.share):.7f}"),
        element("autosimplify", "1"), element("feedbackstyle", "1"),
        element("feedbackvariables", None, element("text", "")), *nodes,
    )  # fmt: skip


def _node(place: int, entry: Entry, against: str, score: str, feedback: str, goes_on: bool, desk: Desk) -> Element:
    parts = [
        ("name", str(place)), ("description", ""), ("answertest", "AlgEquiv"), ("sans", f"ans{entry.number}"),
        ("tans", against), ("testoptions", ""), ("quiet", "1"), ("truescoremode", "="), ("truescore", score),
        ("truepenalty", ""), ("truenextnode", "-1"), ("trueanswernote", f"prt{entry.number}-{place + 1}-T"),
    ]  # fmt: skip
    after = [
        ("falsescoremode", "="), ("falsescore", "0"), ("falsepenalty", ""),
        ("falsenextnode", str(place + 1) if goes_on else "-1"), ("falseanswernote", f"prt{entry.number}-{place + 1}-F"),
    ]  # fmt: skip
    return element(
        "node", None,
        *(element(name, value) for name, value in parts), _html("truefeedback", feedback),
        *(element(name, value) for name, value in after), _html("falsefeedback", "" if goes_on else desk.feedback(None)),
    )  # fmt: skip


def _tests(entries: tuple[Entry, ...], names: dict[str, str]) -> Iterable[Element]:
    """Tests that STACK runs: the right answers, then each wrong one in its field."""
    yield _test(1, entries, {}, names)
    number = 1
    for entry in entries:
        for place in range(len(entry.wrong)):
            number += 1
            yield _test(number, entries, {entry.number: place}, names)


def _test(number: int, entries: tuple[Entry, ...], wrong: dict[int, int], names: dict[str, str]) -> Element:
    found = element("qtest", None, element("testcase", str(number)))
    for entry in entries:
        place = wrong.get(entry.number)
        value = f"ta{entry.number}" if place is None else maxima(entry.wrong[place].formula, names)
        found.append(element("testinput", None, element("name", f"ans{entry.number}"), element("value", value)))
    for entry in entries:
        place = wrong.get(entry.number)
        node = 1 if place is None else place + 2
        found.append(element(
            "expected", None, element("name", f"prt{entry.number}"),
            element("expectedscore", "1.0000000" if place is None else "0.0000000"), element("expectedpenalty", ""),
            element("expectedanswernote", f"prt{entry.number}-{node}-T"),
        ))  # fmt: skip
    return found
