"""Small parts of questions and answers, each by what it states: ways, limits, conditions that always hold, vectors."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered, ask
from rbpsym.ask.integrated import _lasting
from rbpsym.ask.lasting import held, kept_from_start
from rbpsym.ask.limits import leading
from rbpsym.ask.seen import scene, way_to
from rbpsym.ask.special import _term
from rbpsym.ask.telling import latex_of
from rbpsym.ask.wanted import Wanted
from rbpsym.ask.yesno import _always
from rbpsym.ask.zeros import _by_phase
from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import depends_on
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.pushing import ways_kept
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from tests.ask.test_answers import asked

NEAR = 1e-6
HUMP = """
[parameters]
m = "mass"
p = "length"
g = "acceleration"
v = "speed"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v"
[bodies.bead]
shape = "particle"
mass = "m"
center = ["x", "-x**2/(2*p)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "bead.center"
curve = "y = -x**2/(2*p)"
"""
DRUM = """
[parameters]
m = "mass: of the load"
I = "moment of inertia: of the wheel"
r = "length: radius"
h = "length"
M_f = "torque: of the bearing"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "-h"
[coordinates.phi]
start = "0"
[bodies.wheel]
shape = "given"
mass = "m"
moment = "I"
center = "O"
angle = "phi"
[bodies.load]
shape = "particle"
mass = "m"
center = ["-r", "y"]
[interactions.W]
type = "gravity"
[interactions.B]
type = "resisting-couple"
size = "M_f"
between = ["ground", "wheel"]
sense = "ccw"
[constraints.F]
type = "pivot"
point = "wheel.center"
[constraints.T]
type = "string"
path = [{ around = "wheel", radius = "r", sense = "ccw" }, "load.center"]
"""


def test_of_what_does_not_begin_as_it_is_stated_nothing_else_is_said():
    """N has the sign of g p - v² all along: with a greater v the bead flies off at once; with v² = g p, N is zero at once."""
    [found] = ask(load_text(HUMP), "does N vanish")
    assert found.verdict.is_proved and found.says == "no where this is met"
    [condition] = found.valid
    assert condition.ops == (">",)
    gap = scalar(t.add(condition.items[0], t.neg(condition.items[-1])))
    assert is_zero(gap - scalar(read_infix("g*p - v**2", {*"gpv"})))


def test_no_condition_is_told_that_the_motion_keeps_from_its_start():
    """A load that only goes down stays below its drum, whose bearing's friction it overcomes: it goes on in its sense."""
    study = Study(load_text(DRUM))
    assert [kept_from_start(study, Demand(value)) for _, value in ways_kept(study)] == [True]
    speed = symbol("phi_dot")
    assert kept_from_start(study, Demand(speed, ">=")) and not kept_from_start(study, Demand(-speed, ">="))
    assert not kept_from_start(study, Demand(-symbol("y") - symbol("h") * 2))  # not at the start


LIMITS = {
    "(3*x + 1)/(x**2 + x)": [("0", 1), ("0", -1), (None, 1)],
    "x**3 - x": [("1", 1), ("1", -1), (None, 1), (None, -1)],
    "sqrt(x + x**2)": [("0", 1), (None, 1)],
    "1/sqrt(x - 1)": [("1", 1), (None, 1)],
    "1/sqrt(1 - x)": [("1", -1), (None, -1)],
}


@pytest.mark.parametrize("text", LIMITS)
def test_near_a_limit_a_quantity_is_its_leading_term(text):
    value = scalar(read_infix(text, {"x"}))
    for to, side in LIMITS[text]:
        place = None if to is None else scalar(read_infix(to, ()))
        there = {"x": side / NEAR if to is None else float(to) + side * NEAR}
        term = _term(leading(value, "x", place, NONE, side), "x", place, side)
        assert number(term, there) == pytest.approx(number(value, there), rel=0.01), (to, side)


def test_a_coordinate_does_not_come_to_where_it_starts_but_to_the_other_side():
    world, begin = scene(asked("rod-pendulum")), symbol("theta_0")
    with pytest.raises(StatementError, match="starts there"):
        way_to(world, "theta", begin, world.motion.assumptions)
    way, _ = way_to(world, "theta", -begin, world.motion.assumptions)
    assert way.sense < 0


@pytest.mark.parametrize(("sign", "closed"), [("positive", True), ("positive", False), ("nonnegative", True)])
def test_what_holds_for_the_sign_of_a_quantity_always_holds(sign, closed):
    assert _always(Wanted((symbol("x"),), Assumptions({"x": sign}), closed=closed))


@pytest.mark.parametrize(("sign", "closed"), [("nonnegative", False), ("real", True)])
def test_what_may_vanish_is_not_always_positive(sign, closed):
    assert not _always(Wanted((symbol("x"),), Assumptions({"x": sign}), closed=closed))


@pytest.mark.parametrize(("quantity", "parts"), [("velocity of stick.cm", 2), ("N", 1)])
def test_a_vector_stands_in_brackets(quantity, parts):
    found = answered(asked("falling-stick"), quantity)
    assert len(found.nodes) == parts and latex_of(found).startswith(r"\left(") is (parts > 1)


@pytest.mark.parametrize(("friction", "grips"), [(1.0, True), (-1.0, True), (3.0, False), (-3.0, False)])
def test_a_grip_lasts_as_long_as_friction_is_within_its_limit(friction, grips):
    study = Study(asked("disk-on-incline").problem)
    [need] = study.friction_needs
    left = [value for value in _lasting(study) if depends_on(value, need.friction)]
    assert (min(number(value, {"N": 2.0, "mu": 1.0, need.friction: friction}) for value in left) >= 0) is grips


@pytest.mark.parametrize("sign", ["", "-"])
@pytest.mark.parametrize("text", ["a*cos(x) + b*sin(x) - c", "a*cos(2*x + k) - b*sin(2*x + k) + c"])
def test_two_waves_of_one_angle_are_one_wave_with_a_phase(sign, text):
    numbers = {"a": 2.0, "b": 3.0, "c": 1.5, "k": 0.3}
    factor = scalar(read_infix(f"{sign}({text})", {*numbers, "x"}))
    found = _by_phase(factor, "x", Assumptions(dict.fromkeys(numbers, "positive")))
    assert len(found) == 2
    assert all(number(factor, {**numbers, "x": number(place, numbers)}) == pytest.approx(0, abs=1e-12) for place in found)


def test_a_grip_along_the_motion_is_asked_for_without_dividing_by_what_may_vanish():
    study = Study(asked("rod-falling-on-rough-floor").problem)
    along, demands = study.reactions_along_motion, held(study)
    for side in (-1, 1):
        left = along["N"] * symbol("mu") + along["f"] * side
        assert any(is_zero(demand.value - left) for demand in demands)
