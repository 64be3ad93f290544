"""Grading is fair: numbers put in, the teacher's decisions, a slip that is punished once."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.field import symbol
from rbpsym.frozen import replace
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_problem
from rbpsym.statement.units import read_unit
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.grading.choices import judge_choice
from rbpsym.teaching.grading.desk import Desk, grade_worksheet
from rbpsym.teaching.grading.formula import Sought, judge_formula
from rbpsym.teaching.grading.marking import grade
from rbpsym.teaching.grading.quantity import read_quantity
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.model import ChoiceKey, ExplanationKey, FormulaKey, NumberKey, Option, Student
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.sheet import sheet_of_text
from rbpsym.teaching.situations import scenery
from rbpsym.teaching.spreadsheets import parse_answers
from rbpsym.typeset.machine import to_machine

CHAIN = """
title = "Chain"
[[problem]]
name = "rod-pendulum"
[[problem.task]]
kind = "formula"
about = "acceleration.theta"
[[problem.task]]
kind = "number"
about = "acceleration.theta"
[[problem.task]]
kind = "number"
about = "speed.theta"
"""


@pytest.fixture
def chain(tmp_path):
    path = tmp_path / "chain.toml"
    path.write_text(CHAIN)
    return plan_of(path).worksheet(Student("ana"), "s")


def marked(sheet, **answers):
    return {m.item: m for m in grade_worksheet(sheet, {k[1:]: v for k, v in answers.items()}, Desk())}


def test_a_wrong_acceleration_is_carried_into_the_speed(chain):
    """Twice the acceleration, so √2 times the speed: the slip is punished once."""
    acceleration, speed = (item for item in chain.items if isinstance(item.key, NumberKey))
    unit = speed.key.measure.unit
    factor = read_unit(unit).factor
    own = f"{2 * float(acceleration.key.measure.value):.6g} {acceleration.key.measure.unit}"
    follows = f"{speed.key.exact * 2**0.5 / factor:.3g} {unit}"
    found = marked(chain, **{f"q{acceleration.id}": own, f"q{speed.id}": follows})
    assert found[acceleration.id].points < found[acceleration.id].most
    assert found[speed.id].judgement.status.value == "carried forward" and found[speed.id].points == found[speed.id].most
    alone = marked(chain, **{f"q{speed.id}": follows})[speed.id]
    assert alone.points < alone.most


def test_numbers_of_the_paper_put_in_are_left_to_the_teacher(chain):
    [item] = [item for item in chain.items if isinstance(item.key, FormulaKey)]
    given = {name: float(m.value) * read_unit(m.unit).factor for name, m in chain.parts[0].given.items()}
    text = to_machine(item.key.value)
    for name, value in given.items():
        text = text.replace(name, f"({value:.4f})") if name != "theta" else text
    found = marked(chain, **{f"q{item.id}": text})[item.id].judgement
    assert [remark.key for remark in found.remarks] == ["numbers put in"] and found.is_for_teacher, (text, found)
    assert not marked(chain, **{f"q{item.id}": f"1.3*({text})"})[item.id].judgement.is_for_teacher


def rows(graded):
    return list(csv.reader(io.StringIO(graded.marks)))


def test_the_teacher_decides_what_is_left_open():
    sheet = plan_of("sliding-ladder").worksheet(Student("ana"))
    [item] = [item for item in sheet.items if isinstance(item.key, ExplanationKey)][:1]
    most = float(item.points)
    table = f"student,{item.id},{item.id} points\nana,No torque.,\nbob,No torque.,{most - 1:g}\ncleo,No torque.,99\n"
    graded = grade("sliding-ladder", parse_answers(table), pages=True, processes=1)
    head, ana, bob, cleo = rows(graded)
    at, teacher = head.index(item.id), head.index("teacher")
    assert item.id in ana[teacher].split() and bob[teacher] == "" and bob[at] == f"{most - 1:g}"
    assert bob[at + 1] == "Marked by the teacher." and float(bob[head.index("total")]) == most - 1
    assert "Marked by the teacher." in graded.pages["bob.html"]
    assert cleo[teacher] == "all" and any("earns 0 to" in sentence for sentence in graded.told)
    assert not any("passed over" in sentence for sentence in graded.told)


@pytest.fixture(scope="module")
def ladder():
    return plan_of("sliding-ladder").worksheet(Student("ana"), "s")


def asked(sheet, kind: type, quantity: str = ""):
    return next(item for item in sheet.items if isinstance(item.key, kind) and item.asked.quantity.startswith(quantity))


def test_a_value_rounded_too_far_is_told_so_and_is_no_slip(ladder):
    """One figure of 1.13 lies near what a forgotten half would give."""
    item = asked(ladder, NumberKey, "speed")
    measure = item.key.measure
    found = marked(ladder, **{f"q{item.id}": f"{float(measure.value):.1g} {measure.unit}"})[item.id]
    assert found.judgement.slip is None and {r.key for r in found.judgement.remarks} == {"too few figures"}


@pytest.mark.parametrize("typed", ["arcsin(2/3 sin {0}°)", "arcsin(2/3 sin({0}°))", "{1:.1f}°", "{2:.3f} rad", "{2:.3f}"])
def test_an_angle_at_the_numbers_of_the_paper_is_left_to_the_teacher(ladder, typed):
    item = asked(ladder, FormulaKey, "question")
    start = float(ladder.parts[0].given["theta_0"].value)
    value = math.asin(2 / 3 * math.sin(math.radians(start)))
    found = marked(ladder, **{f"q{item.id}": typed.format(start, math.degrees(value), value)})[item.id]
    assert found.judgement.is_for_teacher and found.judgement.status.value == "undecided"


def test_degrees_of_a_function_are_read_in_a_number_worked_out_on_paper():
    assert read_quantity("2*(sin 54° - cos 60 deg) m").si == pytest.approx(2 * (math.sin(math.radians(54)) - 0.5))
    with pytest.raises(RbpsymError, match="direction in words"):
        read_quantity("23.3 N to the right")


def test_a_power_divided_is_read_by_its_dimension(ladder):
    """ℓ^(2/3) has no value here, which is not the same as the value zero."""
    ground = Desk().ground(ladder.problems["sliding-ladder"])
    key = read_formula("-(M*ell^2/3)*theta_ddot", ground.book)
    assert judge_formula("-M l^2/3 α", Sought(key, ground)).credit == 1


@pytest.mark.parametrize(("typed", "place"), [("I think b", 1), ("the answer is (c)", 2), ("it's a", 0), ("creo que b", 1)])
def test_words_before_a_letter_are_no_hindrance(typed, place):
    options = tuple(Option(()) for _ in range(4))
    assert judge_choice(typed, ChoiceKey(options, place)).credit == 1
    assert judge_choice("in between", ChoiceKey(options, place)).is_for_teacher


SLOPE = """
title = "Slope"
[[problem]]
name = "ring-on-incline"
[[problem.task]]
kind = "choose"
about = "acceleration.s"
[[problem.task]]
kind = "formula"
about = "reaction.f"
"""


def test_an_option_may_be_told_by_its_formula_and_a_is_the_acceleration():
    sheet = plan_of(sheet_of_text(SLOPE)).worksheet(Student("ana"), "s")
    choice, _ = sheet.items
    right = choice.key.options[choice.key.right].formula
    found = marked(sheet, q1=to_machine(right), q2="M a")
    assert found["1"].points == found["1"].most  # as if its letter stood there
    assert found["2"].judgement.status.value == "unfinished"  # F = m a is true, and a is not what f shall be told in
    other = next(option for option in choice.key.options if option.slip)
    assert marked(sheet, q1=to_machine(other.formula))["1"].judgement.slip == other.slip


def test_places_that_are_asked_about_lie_in_their_own_phase():
    """A weight that falls freely for 20 cm is not looked at after a metre of it."""
    problem = load_problem(Path(__file__).parents[2] / "docs/examples/events/begins.toml")
    study = Study(replace(problem, phases=()))
    sight = scenery(study, {}, False, {"y": symbol("L")})
    for _, situation in zip(range(20), sight.situations(Draws(b"seed", "places")), strict=False):
        assert situation.numbers["h"] < situation.numbers["y"] < situation.numbers["L"]
