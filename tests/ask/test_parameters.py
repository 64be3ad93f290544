"""Questions about parameters: published answers, special forms, and sentences for wrong ones."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.telling import record
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.statement.loader import load_problem
from tests.ask.textbook import INCLINE, ON_ROD, ON_STRING, QUESTIONS, ROLLING, TALL_BOX


@cache
def asked(problem: str) -> Asked:
    return Asked(load_problem(problem))


def value(problem: str, text: str):
    world = asked(problem).world(0)
    return scalar(read_infix(text, world.names)), world.motion.assumptions


NUMBERED = [f"{k}-{row[1]}" for k, row in enumerate(QUESTIONS)]


@pytest.mark.parametrize(("problem", "question", "published", "source"), QUESTIONS, ids=NUMBERED)
def test_it_finds_what_the_book_says(problem, question, published, source):
    found = answered(asked(problem), question)
    assert found.verdict.is_proved, found.verdict
    if published in ("yes", "no"):
        assert found.holds_so is (published == "yes")
    elif published.startswith("there is"):
        assert published in found.says
    else:
        wanted, given = value(problem, published)
        assert any(scalars_equal(one, wanted, given).is_proved for one in found.values)


def test_a_bound_tells_whether_it_is_reached():
    assert "never reached" in answered(asked(ON_ROD), "smallest v_0 for which theta reaches pi").says
    assert not answered(asked(ON_STRING), "smallest v_0 for which theta reaches pi").says
    assert not answered(asked(ON_ROD), "smallest v_0 for which theta reaches pi/2").says


def test_what_has_no_closed_form_is_the_zero_of_an_equation():
    found = answered(asked("falling-stick"), "least N over theta")
    assert found.verdict.is_proved and found.equation is not None and not found.values


def test_json_tells_of_a_parameter():
    told = record(answered(asked(INCLINE), "beta for which it does not slip"))
    assert (told["symbol"], told["relation"], told["answer"]) == ("beta", "<=", "beta <= atan(mu)")
    assert record(answered(asked(INCLINE), "does it slip"))["answer"] is None
    assert record(answered(asked(ROLLING), "does acceleration of s depend on m"))["answer"] == "False"


def test_the_sense_of_a_speed_is_a_condition():
    found = answered(asked("rod-pendulum"), "largest angular velocity of rod")
    assert found.verdict.is_proved and record(found)["valid_where"] == ["sin(theta_0) != 0"]  # on the way back too


YES_OR_NO = [
    ("ball-in-a-loop", "does theta reach pi", None),
    ("sliding-ladder", "does N_w vanish", True),
    ("sliding-ladder", "does N_f vanish", False),
    ("sliding-ladder", "does theta reach 0", False),
    ("ball-on-incline", "does it slip", False),
    ("half-disk-rocking", "is theta = 0 stable", True),
    ("rod-pendulum", "does period of theta depend on M", False),
    ("rod-pendulum", "is period of theta independent of g", False),
    ("sliding-ladder", "is N_f >= 0", True),
    (ROLLING, "is acceleration of s independent of R", True),
]


@pytest.mark.parametrize(("problem", "question", "holds"), YES_OR_NO)
def test_yes_or_no(problem, question, holds):
    found = answered(asked(problem), question)
    assert found.verdict.is_proved and found.holds_so is holds
    assert holds is not None or found.valid


WRONG = [
    ("rod-pendulum", "largest F_y over theta between pi/2 and 0", "not surely less"),
    (ON_ROD, "smallest v_1 for which theta reaches pi", "no parameter of the problem"),
    (ON_ROD, "smallest theta for which theta reaches pi", "is a coordinate"),
    (ON_ROD, "smallest v_0 for which phi reaches pi", "is no coordinate"),
    (ON_ROD, "smallest v_0 for which theta reaches -1", "never comes there"),
    (ON_ROD, "smallest v_0 for which theta reaches 0", "starts there"),
    (ON_ROD, "smallest v_0 for which theta reaches M", "is a mass"),
    (ON_ROD, "smallest v_0 for which theta reaches foo", "unknown symbol"),
    (ON_ROD, "smallest v_0 for which it flies", "no condition"),
    (ON_ROD, "smallest v_0 for which it does not slip", "no contact is held by static friction"),
    (ON_ROD, "v_0 for which T = 3*m*g", "depends on theta"),
    (ON_ROD, "m for which theta reaches pi", "does not depend on m"),
    (ON_ROD, "v_0 for which T where theta = pi = L", "is a force, but"),
    (ON_ROD, "v_0 for which foo vanishes", "means nothing"),
    (ON_ROD, "R for which T where theta = pi vanishes", "does not depend on R"),
    (ON_ROD, "v_0 for which velocity of bob.cm vanishes", "still depends on theta"),
    (ON_ROD, "largest T over phi", "no parameter of the problem"),
    (ON_ROD, "largest T over R", "depends on theta"),
    (ON_ROD, "largest m", "is constant on the motion"),
    (ON_ROD, "largest foo over theta", "means nothing"),
    (ON_ROD, "R for which T at the start is least", "does not depend on R"),
    (ON_ROD, "v_0 for which theta = 1 is stable", "no place of rest"),
    (ON_ROD, "v_0 for which T stays positive until phi = 1", "is no coordinate"),
    (ON_ROD, "v_0 for which T where phi = 0 vanishes", "is no coordinate"),
    (ON_ROD, "smallest v_0 for which it stays in contact", "no contact or string"),
    (ROLLING, "acceleration of s with c", "is not understood"),
    (ROLLING, "acceleration of s with foo = 2", "no parameter"),
    (ROLLING, "acceleration of s with m = 2", "does not depend on m"),
    (ROLLING, "acceleration of s with c = R", "is a length"),
    (ROLLING, "acceleration of s with c = -1", "outside of what is declared"),
    (ROLLING, "acceleration of s with beta = pi", "outside of what is declared"),
    (ROLLING, "acceleration of s with c = 2/5 and then", "gives no value"),
    (ROLLING, "acceleration of s in the limit foo -> 0", "no parameter"),
    (ROLLING, "acceleration of s in the limit c -> R", "is a length"),
    (ROLLING, "acceleration of s in the limit c -> -1", "outside of what is declared"),
    (ROLLING, "acceleration of s for m >> R", "is a length"),
    (ROLLING, "acceleration of s for R >> m", "is a mass"),
    (ROLLING, "acceleration of s for s >> R", "is a coordinate"),
    (ROLLING, "does acceleration of s depend on foo", "no quantity of the problem"),
    (ROLLING, "does foo depend on m", "means nothing"),
    (ROLLING, "c and c_2 with equal foo", "means nothing"),
    (ROLLING, "m and m_2 with equal acceleration of s", "does not depend on m"),
    (ROLLING, "c and beta with equal acceleration of s", "depends on both"),
    (ROLLING, "x and y with equal acceleration of s", "no parameter"),
    (ROLLING, "smallest mu for which M does not slip", "static friction does not hold"),
    (ROLLING, "smallest R for which it does not slip", "does not depend on R"),
    (ROLLING, "does f = 0", "means nothing"),
    (ROLLING, "is f = 0", "means nothing"),
    (ON_ROD, "smallest v_0 for which theta reaches 7", "outside of what is declared"),
    (TALL_BOX, "smallest g for which it does not slip", "does not depend on g"),
    (INCLINE, "does theta reach 1", "is no coordinate"),
    ("disk-off-center", "period of theta with d = 0", "no value there"),
    ("disk-off-center", "period of theta with d = 2", "is a length"),
]  # fmt: skip

SAID = [
    (ROLLING, "acceleration of s in the limit m -> 0", "does not depend on m"),
    ("disk-off-center", "smallest M for which period of theta >= 0", "holds for all values"),
    ("disk-off-center", "largest period of theta over d", "has no bound as d goes to 0"),
    ("disk-off-center", "R for which period of theta is least", "no least value is reached"),
    ("disk-off-center", "largest d for which period of theta >= 0", "holds for all"),
    ("ball-off-sphere", "theta for which N = 5*m*g", "there is no such theta"),
    (INCLINE, "smallest beta for which it does not slip", "every smaller beta does"),
    ("sliding-ladder", "largest theta_0 for which N_f stays positive", "holds for"),
]


@pytest.mark.parametrize(("problem", "question", "said"), WRONG, ids=[f"{k}-{w[1]}" for k, w in enumerate(WRONG)])
def test_a_wrong_question_gets_its_sentence(problem, question, said):
    with pytest.raises(RbpsymError) as told:
        answered(asked(problem), question)
    assert said in str(told.value)


@pytest.mark.parametrize(("problem", "question", "said"), SAID)
def test_what_does_not_exist_is_said_with_proof(problem, question, said):
    found = answered(asked(problem), question)
    assert found.verdict.is_proved and said in found.says
