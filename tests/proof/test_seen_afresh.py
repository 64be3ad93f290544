"""Systems that nobody had stated before: what is said of them holds of them, whatever was seen in the library."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.equal import scalars_equal
from rbpsym.derive import derive
from rbpsym.document import notes as document_notes
from rbpsym.document.needless import owed_by
from rbpsym.document.telling import Teller
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.study import Study
from rbpsym.pictures.plots.following import motion
from rbpsym.proof.step import Derivation
from rbpsym.solve import results
from rbpsym.statement.loader import load_text
from tests.library.derived import derived
from tests.proof.test_assertions import said_in

PULLED = """
[parameters]
M = "mass"
R = "length"
beta = "angle, acute"
mu = "number"
g = "acceleration"
k = "stiffness"
[coordinates.s]
dimension = "length"
start = "0"
[coordinates.phi]
start = "0"
[bodies.disk]
shape = "disk"
mass = "M"
radius = "R"
center = ["s*cos(beta) + R*sin(beta)", "R*cos(beta) - s*sin(beta)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = [["R*sin(beta)","R*cos(beta)"], "disk.center"]
stiffness = "k"
[constraints.N]
type = "rolling"
body = "disk"
line = "y = -x*tan(beta)"
limit = "mu"
[[phases]]
name = "slipping"
event = "slips"
of = "N"
constraints = { N = { type = "touch", coefficient = "mu", slip = "forward" } }
"""  # friction is greatest at the start, and falls: a grip that begins never ends
BACKSPIN = """
[parameters]
M = "mass"
R = "length"
mu = "number"
g = "acceleration"
v_0 = "speed"
omega_0 = "angular speed"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.phi]
start = "0"
speed = "-omega_0"
[bodies.ball]
shape = "ball"
mass = "M"
radius = "R"
center = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "touch"
body = "ball"
line = "y = 0"
coefficient = "mu"
[[phases]]
name = "rolling"
event = "no slip"
of = "N"
constraints = { N = { type = "rolling" } }
"""
TURNED = """
[parameters]
m = "mass"
M = "mass"
k = "stiffness"
a = "length"
Omega = "angular speed"
ell = "length"
[coordinates.r]
dimension = "length"
start = "r_0"
range = ["0", ""]
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
start = "O"
angle = "Omega*t"
[bodies.bead]
shape = "particle"
mass = "m"
center = ["r*cos(Omega*t)", "r*sin(Omega*t)"]
[interactions.S]
type = "spring"
between = ["O", "bead.center"]
stiffness = "k"
natural_length = "a"
[constraints.F]
type = "pivot"
point = "rod.start"
[constraints.D]
type = "prescribed-angle"
body = "rod"
angle = "Omega*t"
[constraints.N]
type = "guide"
point = "bead.center"
line = "y = 0"
of = "rod"
"""
CORNER = """
[parameters]
M = "mass"
R = "length"
mu = "number"
g = "acceleration"
[coordinates.phi]
start = "0"
speed = "omega_0"
range = ["0", "pi/2"]
[bodies.ball]
shape = "ball"
mass = "M"
radius = "R"
center = ["R*sin(phi)", "R*cos(phi)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "ball"
circle = "O"
radius = "0"
limit = "mu"
"""
MOVED = """
[parameters]
M = "mass"
ell = "length"
A = "length"
Omega = "angular speed"
g = "acceleration"
[coordinates.theta]
start = "0"
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
start = ["A*sin(Omega*t)", "0"]
angle = "theta - pi/2"
[interactions.W]
type = "gravity"
[constraints.D]
type = "pivot"
point = "rod.start"
at = ["A*sin(Omega*t)", "0"]
"""
LEANING = """
[parameters]
M = "mass"
ell = "length"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
range = ["0","pi/2"]
[bodies.left]
shape = "rod"
mass = "M"
length = "ell"
center = ["-ell/2*cos(theta)", "ell/2*sin(theta)"]
angle = "theta"
[bodies.right]
shape = "rod"
mass = "M"
length = "ell"
center = ["ell/2*cos(theta)", "ell/2*sin(theta)"]
angle = "-theta"
[interactions.W]
type = "gravity"
[constraints.P]
type = "pin"
points = ["left.end", "right.start"]
[constraints.A]
type = "contact"
point = "left.start"
line = "y = 0"
[constraints.B]
type = "contact"
point = "right.end"
line = "y = 0"
"""


@cache
def stated(text: str) -> Derivation:
    """The derivation of a statement."""
    return derive(load_text('title = "Seen afresh"' + text), simulation=False)


def test_what_slips_at_once_does_not_slip_later():
    """At μ < tan β/3 it slips from the start; above that friction only falls: no place is told at which it reaches its limit."""
    [phase] = results(Study(load_text('title = "Pulled"' + PULLED)))["phases"]
    assert phase.keys() == {"name", "reason"}


def test_a_speed_that_is_kept_has_the_sense_of_the_start():
    """The ball comes back where 2 R ω₀ > 5 v₀, and stops where they are equal."""
    problem = load_text('title = "Backspin"' + BACKSPIN)
    speed, spin = ask(problem, "speed of x in phase rolling", "omega_0 for which speed of x in phase rolling = 0")
    names = {quantity.name: quantity.name for quantity in problem.parameters}
    for found, value in ((speed, "(5*v_0 - 2*R*omega_0)/7"), (spin, "5*v_0/(2*R)")):
        assert found.verdict.is_proved and not found.valid
        assert scalars_equal(found.value, scalar(read_infix(value, names)), found.study.assumptions).is_proved


@pytest.mark.parametrize("detail", ["standard", "full"])
def test_an_equilibrium_is_told_with_what_it_asks_for(detail):
    """r = ka/(k - mΩ²) is no place of the bead but for k > mΩ²."""
    found = stated(TURNED)
    [linear] = [step for step in found.steps if step.id == "linear.1"]
    [equilibrium] = [step for step in found.steps if step.id == "equilibrium.1"]
    assert equilibrium.obligations and set(equilibrium.obligations) <= set(linear.obligations)
    text = said_in(found, detail)
    assert "k > mΩ²" in text[text.index("the forces balance") : text.index("This equilibrium is stable")]


def test_curves_end_where_static_friction_does():
    """On the corner friction reaches its limit before the normal force is gone: the motion that is drawn ends there."""
    moving = motion(stated(CORNER))
    moment, name = moving.loss
    numbers = moving.way.legs[-1].at(moment)
    assert name == "f_N" and numbers["N"] > 0
    assert abs(numbers["f_N"]) == pytest.approx(numbers["mu"] * numbers["N"], rel=1e-6)


@pytest.mark.parametrize("name", ["rod-caught-at-end", "falling-rod-hooked"])
def test_an_end_keeps_its_name_in_later_phases(name):
    """The ends are called as the one figure shows them."""
    text = said_in(derived(name))
    assert "left end of the rod" in text and "upper end" not in text and "lower end" not in text


def test_a_force_that_does_no_work_is_not_its_opposite():
    """The friction on the lever does none, that on the drum takes the energy."""
    text = said_in(derived("brake-drum"), "standard")
    assert "on the lever does no work" in text and "It is not constant: it changes at the rate at which" in text


@pytest.mark.parametrize("detail", ["standard", "full"])
@pytest.mark.parametrize("found", [lambda: stated(TURNED), lambda: derived("rod-over-rim-of-bowl")], ids=["turned", "rim"])
def test_each_open_condition_is_told_somewhere(found, detail, monkeypatch):
    """What is not said again because the page has said it, the page has said."""
    owed, told, tell = [], [], Teller._owed

    def noted(steps, shown, given):
        conditions = owed_by(steps, shown, given)
        owed.extend(node for nodes in conditions.values() for node in nodes)
        return conditions

    def telling(teller, steps, nodes):
        nodes = list(nodes)
        told.extend(nodes)
        yield from tell(teller, steps, nodes)

    monkeypatch.setattr(document_notes, "owed_by", noted)
    monkeypatch.setattr(Teller, "_owed", telling)
    document_notes.notes(found(), "en", detail)
    assert owed and set(owed) <= set(told)


def test_what_is_moved_is_not_said_to_be_held():
    text = said_in(stated(MOVED))
    assert "which is moved: it is at (A sin(Ω t), 0)" in text.replace("Ωt", "Ω t")


def test_a_coordinate_with_which_two_bodies_turn_apart_has_no_sense_of_its_own():
    """θ grows as the left rod turns counter-clockwise and the right one clockwise."""
    assert "grows in this positive sense" not in said_in(stated(LEANING))
