"""What is asked in other words: quantities put together, places named by a quantity, changes, what is conserved.

Answers worked out by hand: Kleppner & Kolenkow 5-7 (rod let go as a pendulum, ball that slips and rolls), Taylor 5 (damping).
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.text import to_text
from tests.ask.lines import on_line

ASKED = (
    ("rod-pendulum", "ratio of F_y to M*g where theta = 0", "(5 - 3*cos(theta_0))/2"),
    ("rod-pendulum", "F_y at the start / (M*g)", "1 - 3*sin(theta_0)**2/4"),
    ("rod-pendulum", "F_y where theta = 0 - F_y at the start", "3*M*g/2*(1 - cos(theta_0)) + 3*M*g*sin(theta_0)**2/4"),
    ("rod-pendulum", "rotational kinetic energy of rod where theta = 0", "M*g*ell*(1 - cos(theta_0))/8"),
    ("rod-pendulum", "translational kinetic energy of rod where theta = 0", "3*M*g*ell*(1 - cos(theta_0))/8"),
    ("rod-pendulum", "change of kinetic energy until theta = 0", "M*g*ell*(1 - cos(theta_0))/2"),
    ("rod-pendulum", "is energy conserved", True),
    ("rod-pendulum", "is the angular momentum of rod about O conserved", False),
    ("ball-slipping-to-rolling", "ratio of energy lost until rolling to kinetic energy at the start", "2/7"),
    ("ball-slipping-to-rolling", "is angular momentum of ball about O conserved", True),
    ("ball-slipping-to-rolling", "time until it rolls", "2*v_0/(7*mu*g)"),
    ("ball-slipping-to-rolling", "heat produced until rolling", "M*v_0**2/7"),
    ("spring-coupled-pendulums", "highest frequency of theta_1 / lowest frequency of theta_1", None),
    ("bead-on-rotating-rod", "time until r = 2*r_0", "ln(2 + sqrt(3))/Omega"),
    ("bead-on-rotating-rod", "time until r = ell", "ln((ell + sqrt(ell**2 - r_0**2))/r_0)/Omega"),
    ("sliding-ladder", "theta where N_w = 0", "asin(2*sin(theta_0)/3)"),
    ("rod-pendulum", "frequency of theta for small oscillations", "sqrt(3*g/(2*ell))"),
    ("rod-pendulum", "natural frequency of theta", "sqrt(3*g/(2*ell))"),
    ("rod-pendulum", "magnitude of the reaction at F where theta = 0", None),
    ("bullet-in-a-rod", "energy lost in the collision", None),
    ("elastic-pendulum", "spring force at the start - force of S at the start", "0"),
    ("bullet-in-a-rod", "d for which impulse of F_x when embedded begins = 0", "2*ell/3"),
    ("bullet-in-a-rod", "v_0 for which theta where theta comes to rest = pi/3",
     "sqrt(g*(M*ell + 2*m*d)*(M*ell**2 + 3*m*d**2)/6)/(m*d)"),
    ("bullet-in-a-rod", "v_0 for which theta comes to rest where theta = pi/3",
     "sqrt(g*(M*ell + 2*m*d)*(M*ell**2 + 3*m*d**2)/6)/(m*d)"),
)


@pytest.mark.parametrize(("name", "question", "worked_out"), ASKED, ids=lambda value: str(value)[:60])
def test_other_words_get_the_answer(name: str, question: str, worked_out: str | bool | None) -> None:
    asked = Asked(load_problem(find_problem(name)))
    found = answered(asked, question)
    assert found.verdict.is_proved, found.verdict
    if isinstance(worked_out, bool):
        assert found.holds_so is worked_out
    elif worked_out:
        world = asked.world(0)
        assert scalars_equal(found.value, scalar(read_infix(worked_out, world.names)), world.motion.assumptions).is_proved


PRINTED = (
    ("-k*x", {"speed": "0"}, "magnitude of force P on block", "k|x|"),
    ("-k*x - b*x_dot", {"start": "0"}, "speed of x as a function of t", "√(4mk − b²)"),
    ("-k*x", {}, "amplitude of x", "√((mv₀² + kx₀²)/k)"),
)


@pytest.mark.parametrize(("force", "start", "question", "part"), PRINTED, ids=lambda value: str(value)[:40])
def test_roots_are_printed_as_in_books(force: str, start: dict[str, str], question: str, part: str) -> None:
    found = answered(Asked(on_line(force, **start)), question)
    text = "; ".join(map(to_text, found.nodes))
    assert part in text, text


IN_TIME = (
    ("x as a function of t with b = 2*sqrt(k*m)", "x_0*(1 + sqrt(k/m)*t)*exp(-sqrt(k/m)*t)"),
    ("x as a function of time with b = 0", "x_0*cos(sqrt(k/m)*t)"),
)


@pytest.mark.parametrize(("question", "worked_out"), IN_TIME)
def test_a_special_value_chooses_the_case_of_damping(question: str, worked_out: str) -> None:
    asked = Asked(on_line("-k*x - b*x_dot", speed="0"))
    found, world = answered(asked, question), asked.world(0)
    assert found.verdict.is_proved and found.question.text == question
    wanted = scalar(read_infix(worked_out, [*world.names, "t"]))
    assert scalars_equal(found.value, wanted, world.motion.assumptions).is_proved


REFUSED = (
    ("rod-pendulum", "ratio of F_y to foo", "means nothing"),
    ("rod-pendulum", "ratio of F_y to F_x", "still depends on theta"),
    ("rod-pendulum", "theta where velocity of rod.tip = 0", "is not understood"),
)


@pytest.mark.parametrize(("name", "question", "told"), REFUSED, ids=lambda value: str(value)[:40])
def test_what_is_put_together_of_nothing_gets_a_sentence(name: str, question: str, told: str) -> None:
    with pytest.raises(RbpsymError, match=told):
        answered(Asked(load_problem(find_problem(name))), question)


COUNTERWEIGHT = """
title = "A bob and a counterweight that is heavier"
[parameters]
m = "mass: bob"
M = "mass > 4*m: counterweight"
a = "length: arm"
g = "acceleration: gravity"
[coordinates.phi]
meaning = "angle of the bob from the downward vertical"
start = "pi/2"
[bodies.arm]
shape = "rod"
mass = "m"
length = "2*a"
center = "O"
angle = "phi - pi/2"
[bodies.bob]
shape = "particle"
mass = "m"
center = "arm.end"
[bodies.heavy]
shape = "particle"
mass = "M"
center = "arm.start"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "arm.center"
[constraints.K]
type = "pin"
points = ["arm.end", "bob.center"]
[constraints.L]
type = "pin"
points = ["arm.start", "heavy.center"]
"""


def test_the_lowest_point_is_that_of_the_body_that_is_named():
    """Where the system is lowest, the bob is highest; of all of them together there is no such place."""
    asked = Asked(load_text(COUNTERWEIGHT, "problem.toml"))
    assert not answered(asked, "speed of bob at its lowest point").verdict.is_proved
    heavy = answered(asked, "speed of heavy at its lowest point")
    assert heavy.verdict.is_proved and heavy.text == answered(asked, "speed of bob where phi = pi").text
    with pytest.raises(RbpsymError):
        answered(asked, "F at the lowest point")


@pytest.mark.parametrize("question", ["stopping distance", "distance travelled by weight until it stops"])
def test_an_angle_is_no_distance_and_nobody_else_travels(question):
    with pytest.raises(RbpsymError):
        answered(Asked(load_problem(find_problem("disk-on-rough-table"))), question)
