"""Points that are led along smooth curves: what books print, the same track stated in other ways, wrong curves."""

from __future__ import annotations

from types import SimpleNamespace as Told

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.equal import scalars_equal
from rbpsym.derive import derive
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.field.scalar import symbol
from rbpsym.field.vector import cartesian
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.pushing import begins
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Problem

NAMES = ("m", "p", "g", "q", "q_dot", "q_0", "pi")


def led(center: str, curve: str, kind: str = "guide", dimension: str = "length", more: str = "") -> Problem:
    """A bead at a place, on a curve."""
    return load_text(
        f"""
[parameters]
m = "mass: m"
p = "length: p"
g = "acceleration: g"
[coordinates.q]
dimension = "{dimension}"
start = "q_0"
{more}
[bodies.bead]
shape = "particle"
mass = "m"
center = [{center}]
[interactions.W]
type = "gravity"
[constraints.N]
type = "{kind}"
point = "bead.center"
{curve}
""",
        name="led",
    )


PARABOLA = led('"q", "q**2/(2*p)"', 'curve = "y = x**2/(2*p)"')
CATENARY = led('"q", "p*(exp(q/p) + exp(-q/p))/2"', 'curve = "y = p*(exp(x/p) + exp(-x/p))/2"')
CYCLOID = '"p*(q + sin(q))", "p*(1 - cos(q))"'
CIRCLE = '"p*sin(q)", "-p*cos(q)"'
SAID = [
    (PARABOLA, "N where q = 0", "m*g*(1 + q_0**2/p**2)"),
    (PARABOLA, "acceleration of q", "-(g*p + q_dot**2)*q/(p**2 + q**2)"),
    (PARABOLA, "period of q", "2*pi*sqrt(p/g)"),
    (CATENARY, "period of q", "2*pi*sqrt(p/g)"),
    (led(CYCLOID, f"curve = [{CYCLOID}]", dimension="angle", more='range = ["-pi", "pi"]'), "period of q", "4*pi*sqrt(p/g)"),
    (led('"q**2/(2*p)", "q"', 'curve = "x = y**2/(2*p)"'), "acceleration of q", "-(g*p**2 + q*q_dot**2)/(p**2 + q**2)"),
]


@pytest.mark.parametrize(("problem", "question", "expected"), SAID)
def test_what_books_print(problem: Problem, question: str, expected: str) -> None:
    asked = f"{question} as a function of the state" if question.startswith("acc") else question
    [found] = ask(problem, asked)
    assert found.verdict.is_proved
    assert scalars_equal(found.value, scalar(read_infix(expected, NAMES)), Study(problem).assumptions).is_proved, found.text


@pytest.mark.parametrize("problem", [PARABOLA, CATENARY])
def test_all_roads_agree(problem: Problem) -> None:
    summary = derive(problem).summary()
    assert summary["proved"] == summary["steps"] and summary["methods_agree"] and summary["lagrange"] == "PROVED"
    assert summary["simulation"]["max_relative_error"] <= 1e-8


WAYS = [
    (led(CIRCLE, f"curve = [{CIRCLE}]", dimension="angle"), led(CIRCLE, 'circle = "O"\nradius = "p"', dimension="angle"), -1),
    (led('"q", "q/2"', 'curve = "y = x/2"'), led('"q", "q/2"', 'line = "y = x/2"'), 1),
    (led('"q", "q/2"', 'curve = "x = 2*y"'), led('"q", "q/2"', 'line = "y = x/2"'), 1),
    (led('"q", "q/2"', 'curve = "y = x/2"', "contact"), led('"q", "q/2"', 'line = "y = x/2"', "contact"), 1),
]


@pytest.mark.parametrize(("curve", "other", "side"), WAYS)
def test_a_circle_and_a_line_are_curves(curve: Problem, other: Problem, side: int) -> None:
    """The motion is the same, and so is the force, but for the side to which it is positive."""
    one, two = Study(curve), Study(other)
    force = scalars_equal(one.dynamics.reactions["N"], two.dynamics.reactions["N"] * side, one.assumptions)
    moved = scalars_equal(one.dynamics.accelerations["q_ddot"], two.dynamics.accelerations["q_ddot"], one.assumptions)
    assert force.is_proved and moved.is_proved


def test_a_condition_of_the_parameters_alone_is_asked_and_not_promised() -> None:
    """Over a hump it is the start that tells whether the bead stays on it, or never is (N > 0 was said, and undecided)."""
    hump = 'curve = "y = -x**2/(2*p)"\nside = "positive"'
    study = Study(led('"q", "-q**2/(2*p)"', hump, "contact", more='speed = "v_0"'))
    [side] = study.sides
    assert side.state == "asked" and side.valid == begins(study) != ()


WRONG = [
    ('curve = "z = p"', "must be “y = ...” or “x = ...”"),
    ('curve = "y = x**2/(2*p) = p"', "must be “y = ...” or “x = ...”"),
    ('curve = "y = "', "a side of the equation is empty"),
    ('curve = "y = x/p"', "must be a length"),
    ('curve = "y = q"', "q"),
    ('curve = ["p", "p"]', "functions of one coordinate"),
    ('curve = "y = x**2/(2*p) + p"', "does not touch the curve"),
    ('curve = "y = x**2/(2*p)"\nline = "y = 0"', "has both a line and a curve"),
    ('curve = "y = x**2/(2*p)"\nof = "bead"', "moves with a body"),
]


@pytest.mark.parametrize(("curve", "told"), WRONG)
def test_wrong_curves_get_a_sentence(curve: str, told: str) -> None:
    with pytest.raises(RbpsymError, match=told):
        Study(led('"q", "q**2/(2*p)"', curve)).dynamics


@pytest.mark.parametrize(("along", "across"), ["xy", "yx"])
def test_beside_a_curve_the_gap_is_along_the_other_axis(along, across):
    height = f"{along}**2/(2*p)"
    places = {along: "q", across: "q**2/(2*p)"}
    [element] = led(f'"{places["x"]}", "{places["y"]}"', f'curve = "{across} = {height}"').constraints
    beside = Told(where=lambda ref: cartesian(symbol("x"), symbol("y")))
    assert same(meeting(element, beside).gap, scalar(read_infix(f"{across} - {height}", {"x", "y", "p"})))
