"""All answers of one worksheet, judged item by item, with the student's own earlier answers at hand."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from rbpsym.document.writers.page import plain_text as bare
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Problem
from rbpsym.teaching import model as m
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.choices import LETTERS, judge_choice, judge_order, judge_signs, place_of
from rbpsym.teaching.grading.formula import Sought, judge_formula
from rbpsym.teaching.grading.ground import GradingGround, book, ground_of
from rbpsym.teaching.grading.judgement import Judgement, Remark, Status
from rbpsym.teaching.grading.number import judge_number, wanted
from rbpsym.teaching.grading.own_answers import own_formula, own_number, with_numbers_put_in
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.grading.verdicts import are_equal
from rbpsym.teaching.ranges import number_text

Answers = Mapping[str, str]


class Mark(Frozen):
    """The points of one item, out of `most`, with what was found and the answer as it was given."""

    item: str
    answer: str
    judgement: Judgement
    points: Fraction
    most: Fraction


class Desk(Frozen):
    """The grounds of problems, made once and kept for all students."""

    language: str = "en"
    grounds: dict[int, tuple[Problem, GradingGround]] = field(default_factory=dict)
    wider: dict[tuple[int, frozenset[str]], GradingGround] = field(default_factory=dict)

    def ground(self, problem: Problem, names: frozenset[str] = frozenset()) -> GradingGround:
        """The ground of a problem, with further names that an item uses."""
        if id(problem) not in self.grounds:
            self.grounds[id(problem)] = (problem, ground_of(Study(problem), self.language))
        ground = self.grounds[id(problem)][1]
        more = names - ground.book.names - {"pi"}
        if not more:
            return ground
        key = (id(problem), more)
        if key not in self.wider:
            called = problem.names_in(self.language)
            wide = book(ground.book.names | more, problem.notation, self.language, called)
            self.wider[key] = replace(ground, book=wide)
        return self.wider[key]


class Case(Frozen):
    """One worksheet with its answers, and what was judged so far."""

    worksheet: m.Worksheet
    answers: Answers
    desk: Desk
    judged: dict[str, Judgement] = field(default_factory=dict)

    def problem(self, item: m.Item) -> Problem:
        """The problem that an item is about."""
        return self.worksheet.problems[item.asked.problem]

    def ground(self, item: m.Item, *nodes: t.Node | None) -> GradingGround:
        """The ground of an item; names in its key may be typed too."""
        names = frozenset().union(*(t.names(node) for node in nodes if node is not None))
        return self.desk.ground(self.problem(item), names)


def grade_worksheet(worksheet: m.Worksheet, answers: Answers, desk: Desk) -> tuple[Mark, ...]:
    """The marks of one worksheet, item by item in the printed order. No answer raises an error."""
    case = Case(worksheet, answers, desk)
    return tuple(_marked(item, case) for item in worksheet.items)


def _marked(item: m.Item, case: Case) -> Mark:
    text = case.answers.get(item.id, "")
    text = "" if j.GIVES_UP.fullmatch(text) else text
    if isinstance(item.key, m.BlanksKey):
        typed = blank_texts(text, item.key, item.id, case.answers)
        text = text if text.strip() else "; ".join(typed[number] for number in sorted(typed)).strip("; ")
    found = JUDGES[type(item.key)](text, item.key, item, case)
    case.judged[item.id] = found
    return Mark(item.id, text, found, found.credit * item.points, item.points)


def decided(mark: Mark, told: str) -> Mark:
    """The mark with the points that the teacher gave. Raises RbpsymError for what are no points of this item."""
    points = Fraction(told.replace(",", ".")) if re.fullmatch(r"\d{1,6}(?:[.,]\d{1,6})?", told) else None
    if points is None or points > mark.most:
        raise RbpsymError(f"item {mark.item} earns 0 to {number_text(mark.most)} points, not “{told[:20]}”")
    status = Status.RIGHT if points == mark.most else Status.PARTLY if points else Status.WRONG
    found = Judgement(status, points / mark.most if mark.most else j.NONE, (Remark("decided"),))
    return replace(mark, judgement=found, points=points)


# --- one judge for each kind of key


def _formula(text: str, key: m.FormulaKey, item: m.Item, case: Case) -> Judgement:
    ground = case.ground(item, key.value, key.left)
    carried = tuple(own for follow in key.follows if (own := own_formula(follow, case)) is not None)
    return _sought(text, Sought(key.value, ground, key.left, frozenset(key.names), key.anticipated, carried), item, case)


def _sought(text: str, sought: Sought, item: m.Item, case: Case) -> Judgement:
    """The judgement on a formula; one in which numbers of the paper stand for letters goes to the teacher."""
    found = judge_formula(text, sought)
    if found.status is Status.WRONG and found.slip is None and with_numbers_put_in(text, sought.value, item, case):
        return Judgement(Status.UNDECIDED, remarks=(Remark("numbers put in"),))
    return found


def _choice(text: str, key: m.ChoiceKey, item: m.Item, case: Case) -> Judgement:
    """An option by its letter, else by what it says: the one formula that is equal, or words that no other option has."""
    found = judge_choice(text, key)
    if found.status is not Status.INVALID:
        return found
    said = [set(re.findall(r"\w+", bare(option.content, case.worksheet.notation).lower())) for option in key.options]
    own = set(re.findall(r"\w+", text.lower()))
    told = [k for k, words in enumerate(said) if own & words.difference(*(said[:k] + said[k + 1 :]))]
    if isinstance(key, m.ComparisonKey):
        return replace(judge_choice(LETTERS[told[0]], key).with_remark("open"), teacher=True) if len(told) == 1 else found
    formulas = [(k, option.formula) for k, option in enumerate(key.options) if option.formula is not None]
    same = [(k, f) for k, f in formulas if judge_formula(text, Sought(f, case.ground(item, f), item.asked.name)).credit == 1]
    return judge_choice(LETTERS[same[0][0]], key).with_remark("read as", formula=same[0][1]) if len(same) == 1 else found


def _number(text: str, key: m.NumberKey, item: m.Item, case: Case) -> Judgement:
    carried = [own for follow in key.follows if (own := own_number(follow, key, case)) is not None]
    return judge_number(text, wanted(key, carried, case.desk.language))


def _comparison(text: str, key: m.ComparisonKey, item: m.Item, case: Case) -> Judgement:
    """The choice earns the first line of the rubric; the reasons are the teacher's to mark."""
    found = _choice(text, key, item, case)
    if not item.rubric or not item.points:
        return found
    share = min(item.rubric[0].points / item.points, Fraction(1))
    status = Status.PARTLY if found.status is Status.RIGHT and share < 1 else found.status
    return replace(found, credit=found.credit * share, status=status)


def _explanation(text: str, key: m.ExplanationKey, item: m.Item, case: Case) -> Judgement:
    return Judgement(Status.OPEN, remarks=(Remark("open"),)) if text.strip() else j.EMPTY


def _blanks(text: str, key: m.BlanksKey, item: m.Item, case: Case) -> Judgement:
    typed = blank_texts(text, key, item.id, case.answers)
    found = [_blank(typed.get(blank.number, ""), blank, key.names, item, case) for blank in key.blanks]
    if all(one.status is Status.EMPTY for one in found):
        return j.EMPTY
    whole = sum((blank.points for blank in key.blanks), Fraction(0))
    credit = sum((one.credit * blank.points for one, blank in zip(found, key.blanks, strict=True)), Fraction(0)) / whole
    status = Status.RIGHT if credit == 1 else Status.PARTLY if credit else Status.WRONG
    remarks: list[Remark] = []
    for one, blank in zip(found, key.blanks, strict=True):
        if one.remarks:
            remarks += [Remark("blank", {"number": str(blank.number)}), *one.remarks]
    parts = tuple((str(blank.number), one.credit) for one, blank in zip(found, key.blanks, strict=True))
    slip = next((one.slip for one in found if one.slip), None)
    return Judgement(status, credit, tuple(remarks), slip, parts=parts, teacher=any(one.is_for_teacher for one in found))


def _blank(text: str, blank: m.Blank, names: tuple[str, ...], item: m.Item, case: Case) -> Judgement:
    ground = case.ground(item, blank.value)
    return _sought(text, Sought(blank.value, ground, None, frozenset(names), blank.anticipated), item, case)


def blank_texts(text: str, key: m.BlanksKey, id: str, answers: Answers) -> dict[int, str]:
    """What stands in each blank: from columns “3.1”, “3.2”, or from one cell, separated by semicolons or lines, or by as many
    commas as it takes."""
    numbers = [blank.number for blank in key.blanks]
    own = {number: answers[f"{id}.{number}"] for number in numbers if f"{id}.{number}" in answers}
    if own:
        return own
    by_commas = re.split(r",\s", text)
    parts = by_commas if len(by_commas) == len(numbers) > 1 else re.split(r"[;\n]", text)
    return dict(zip(numbers, parts, strict=False))


def _slip(text: str, key: m.SlipKey, item: m.Item, case: Case) -> Judgement:
    if not text.strip():
        return j.EMPTY
    found = re.match(r"\s*(?:line|línea|linea)?\s*[(\[]?([A-Za-z]|\d{1,3})[)\].:,]?(?:\s+|$|(?<=[:)\].,]))", text, re.IGNORECASE)
    place = place_of(found[1], len(key.lines)) if found else None
    if found is None or place is None:
        options = f"1 – {len(key.lines)}"
        return Judgement(Status.INVALID, remarks=(Remark("not an option", {"text": text[:40], "options": options}),))
    if place != key.wrong:
        return j.wrong("wrong line")
    rest = text[found.end() :].strip()
    return _correction(rest, key.corrected, case.ground(item, key.corrected)) if rest else j.RIGHT


def _correction(text: str, corrected: t.Node, ground: GradingGround) -> Judgement:
    """The corrected formula beside the line: its last side is compared."""
    sides = corrected.items if isinstance(corrected, t.Chain) else (corrected,)
    found = judge_formula(text, Sought(sides[-1], ground, sides[0] if len(sides) > 1 else None))
    if found.credit == 1 or _says_the_same(text, sides, ground):
        return j.RIGHT
    if found.is_for_teacher:
        return replace(found, credit=j.HALF, remarks=(Remark("right line"), *found.remarks))
    return Judgement(Status.PARTLY, j.HALF, (Remark("wrong correction"), *found.remarks))


def _says_the_same(text: str, sides: tuple[t.Node, ...], ground: GradingGround) -> bool:
    """Is it an equation whose sides are, one by one, sides of the corrected line?"""
    try:
        read = read_formula(text, ground.book)
    except RbpsymError:
        return False
    if not isinstance(read, t.Chain) or len(read.items) < 2:
        return False
    return all(any(are_equal(own, side, ground).is_proved for side in sides) for own in read.items)


JUDGES: Mapping[type, Callable[[str, Any, m.Item, Case], Judgement]] = {
    m.FormulaKey: _formula,
    m.NumberKey: _number,
    m.ChoiceKey: _choice,
    m.ComparisonKey: _comparison,
    m.OrderKey: lambda text, key, item, case: judge_order(text, key),
    m.SignsKey: lambda text, key, item, case: judge_signs(text, key),
    m.BlanksKey: _blanks,
    m.SlipKey: _slip,
    m.ExplanationKey: _explanation,
}
