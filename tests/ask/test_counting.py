"""What is counted between two moments: works, times and losses through all phases between; and values told, not names."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import LimitError, StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import names_in
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import NOTHING
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text

SLOPE = """
[parameters]
m = "mass: block"
beta = "angle, acute: slope"
mu = "number < tan(beta): friction"
v_0 = "speed: first speed"
g = "acceleration: gravity"
[coordinates.s]
dimension = "length"
start = "0"
speed = "v_0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["s*cos(beta)", "s*sin(beta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "block.center"
line = "y = x*tan(beta)"
side = "positive"
coefficient = "mu"
slip = "forward"
[[phases]]
name = "down"
event = "rests"
of = "s"
constraints = { N = { slip = "backward" } }
[[phases]]
name = "home"
event = "reaches"
of = "s"
at = "0"
"""
LOST = "m*mu*v_0**2*cos(beta)/(sin(beta) + mu*cos(beta))"
COUNTED = (
    ("work of f_N until home", f"-{LOST}"),
    ("work of f_N from the start to home", f"-{LOST}"),
    ("work of f_N from down to home", f"-{LOST}/2"),
    ("work of f_N in phase down until home", f"-{LOST}/2"),
    ("work of W until home", "0"),
    ("work of W from down to home", "m*v_0**2*sin(beta)/(sin(beta) + mu*cos(beta))/2"),
    ("net work on block until home", f"-{LOST}"),
    ("energy lost until home", LOST),
    ("time from the start to down", "v_0/(g*(sin(beta) + mu*cos(beta)))"),
)
PHASED = [name for name, path in problem_files().items() if "[[phases]]" in path.read_text(encoding="utf-8")]


@cache
def slope() -> Asked:
    return Asked(load_text(SLOPE, file="slope.toml", name="slope"))


@cache
def shipped(name: str) -> Asked:
    return Asked(load_problem(problem_files()[name]))


@pytest.mark.parametrize(("question", "value"), COUNTED)
def test_what_is_counted_goes_through_all_phases(question: str, value: str) -> None:
    found = answered(slope(), question)
    stated = scalar(read_infix(value, {name: name for name in ("m", "mu", "v_0", "g", "beta")}))
    assert found.verdict.is_proved
    assert scalars_equal(found.value, stated, found.study.assumptions).is_proved


def test_times_of_phases_add_up() -> None:
    whole, first, second = (answered(slope(), f"time {when}") for when in ("until home", "until down", "from down to home"))
    assert scalars_equal(whole.value, first.value + second.value, whole.study.assumptions).is_proved


def test_a_force_does_no_work_before_it_acts() -> None:
    asked = shipped("billiard-ball-struck-high")
    whole, last = (answered(asked, f"work of f_N {when} rolling") for when in ("until", "from slipping to"))
    assert whole.verdict.is_proved and whole.value == last.value


@pytest.mark.parametrize("counted", ["time", "work of W", "kinetic energy"])
def test_moments_are_told_in_their_order(counted: str) -> None:
    with pytest.raises(StatementError, match="comes after the second"):
        answered(slope(), f"{counted} from home to down")


@pytest.mark.parametrize("name", PHASED)
def test_net_works_until_a_phase_are_what_the_kinetic_energy_gains(name: str) -> None:
    asked = shipped(name)
    for phase in asked.problem.phases:
        try:
            done = [answered(asked, f"net work on {body} until {phase.name}") for body in asked.problem.body_names]
        except LimitError:
            continue
        except StatementError as error:
            assert any(told in str(error) for told in ("no closed form", "a blow between")), error
            continue
        energies = [answered(asked, f"kinetic energy {when}").value for when in (f"just before {phase.name}", "at the start")]
        gained = sum((found.value for found in done), NOTHING)
        assert scalars_equal(gained, energies[0] - energies[1], done[0].study.assumptions).is_proved


@pytest.mark.parametrize("name", PHASED)
def test_the_value_of_an_impulse_is_not_its_name(name: str) -> None:
    asked = shipped(name)
    for phase in asked.problem.phases:
        for blow in (blow for blow in phase.impulses if blow.kind == "collision"):
            for question in (f"impulse of {blow.name}", f"impulse of {blow.name} when {phase.name} begins"):
                found = answered(asked, question)
                assert {name for node in found.nodes for name in t.names(node)} <= names_in(found.value)


def test_what_a_struck_contact_does_in_the_blow_is_no_part_of_its_work() -> None:
    asked = Asked(load_problem(problem_files()["bullet-in-a-rod"]))
    with pytest.raises(StatementError, match="a blow between"):
        answered(asked, "work of P on bullet until theta = pi/6")
    assert answered(asked, "work of P on bullet until theta = pi/6 in phase embedded").verdict.is_proved


@pytest.mark.parametrize(("name", "phase"), [("bullet-in-a-rod", "embedded"), ("box-against-ridge", "tipping")])
def test_what_is_lost_until_a_phase_is_lost_in_the_blow_with_which_it_begins_too(name: str, phase: str) -> None:
    asked = Asked(load_problem(name))
    until, then = (answered(asked, f"energy lost {when}") for when in (f"until {phase}", f"when {phase} begins"))
    assert until.verdict.is_proved and not scalars_equal(until.value, NOTHING, asked.first.assumptions).is_proved
    assert scalars_equal(until.value, then.value, asked.first.assumptions).is_proved
