"""Every problem of the library asks what its textbook asks, and gets the textbook's answer, proved."""

import pytest

from rbpsym.ask.found import Answer
from rbpsym.decide.equal import scalars_equal
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from tests.library.derived import NAMES, answers_to, problem, unsimulated
from tests.library.published import ANSWERS

MOST = 3
YES = {"yes": True, "no": False}


def test_the_published_answers_are_those_of_the_questions_that_are_asked():
    asked = {(name, text) for name in NAMES for text in problem(name).questions}
    assert asked == {(name, text) for name, text, _ in ANSWERS}


@pytest.mark.parametrize("name", NAMES)
def test_a_problem_asks_and_is_answered_with_proof(name):
    questions = problem(name).questions
    assert 1 <= len(questions) <= MOST
    published = {text: answer for problem_, text, answer in ANSWERS if problem_ == name}
    for found in answers_to(unsimulated(name).study):
        assert isinstance(found, Answer), found.reason
        assert found.verdict.is_proved, (found.question.text, found.verdict.reason)
        _is_published(found, published[found.question.text])


def _is_published(found: Answer, wanted: str):
    if wanted in YES:
        assert found.holds_so is YES[wanted]
        return
    names = {*found.study.letters.quantities, "t"}
    expected = scalar(read_infix(wanted, names), found.study.system.scope)
    assert scalars_equal(found.value, expected, found.study.assumptions).is_proved, (found.text, wanted)
