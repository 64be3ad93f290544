"""Problems that are asked in one position: what holds at the start, against textbooks, the simulation and by hand."""

from __future__ import annotations

from itertools import islice

import pytest

from rbpsym.ask.asking import ask
from rbpsym.errors import StatementError
from rbpsym.explorer.page import explorer
from rbpsym.field.calculus import substitute
from rbpsym.field.normal import same
from rbpsym.mechanics.at_start import StartStudy, study_of
from rbpsym.mechanics.numbers import samples
from rbpsym.mechanics.phases import stages
from rbpsym.oracles.simulation import simulate_study
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.mechanics.textbook import Textbook, answer, derivation, differences, read

SETS = 20  # of numbers for the parameters


def _bar(size: str, start: str, points: str, length: str = "L") -> str:
    """A bar with all three coordinates, on two strings from A and B."""
    x, y, phi = start.split(";")
    a, b = points.split(";")
    return f"""
[parameters]
m = "mass"
L = "length"
h = "length"
g = "acceleration"
[coordinates.x]
dimension = "length"
start = "{x}"
[coordinates.y]
dimension = "length"
start = "{y}"
[coordinates.phi]
start = "{phi}"
[bodies.bar]
{size}
mass = "m"
center = ["x", "y"]
angle = "phi"
[points]
A = {a}
B = {b}
[interactions.W]
type = "gravity"
[constraints.T_A]
type = "string"
path = ["A", "bar.start"]
[constraints.T_B]
type = "string"
path = ["B", "bar.end"]
"""


CUT = '[[phases]]\nname = "cut"\nevent = "at once"\nwithout = ["T_B"]\n'
ROD = 'shape = "rod"\nlength = "L"'
PLANK = _bar(ROD, "0;-h;0", '["-L/2", "0"];["L/2", "0"]')
SLANTING = _bar(ROD, "0;-h;0", '["-L/2 - h", "0"];["L/2 + h", "0"]')
SWINGING = _bar(ROD, "h/2;-sqrt(3)*h/2;0", '["-L/2", "0"];["L/2", "0"]')
LINKS = """
[parameters]
m = "mass: of each link"
M = "mass: of the plank"
L = "length"
b = "length"
g = "acceleration"
[coordinates.alpha]
start = "-pi/3"
[coordinates.beta]
start = "-pi/3"
[coordinates.gamma]
start = "0"
[bodies.left]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "alpha"
[bodies.plank]
shape = "rod"
mass = "M"
length = "b"
start = "left.end"
angle = "gamma"
[points]
Q = ["b", "0"]
[bodies.right]
shape = "rod"
mass = "m"
length = "L"
start = "Q"
angle = "beta"
[interactions.W]
type = "gravity"
[constraints.A]
type = "pivot"
point = "left.start"
[constraints.B]
type = "pivot"
point = "right.start"
[constraints.C]
type = "pin"
points = ["left.end", "plank.start"]
[constraints.D]
type = "pin"
points = ["plank.end", "right.end"]
"""
THIRD = """
[coordinates.delta]
start = "-pi/3"
[bodies.middle]
shape = "rod"
mass = "m"
length = "L"
start = ["b/2", "0"]
angle = "delta"
[constraints.E]
type = "pivot"
point = "middle.start"
[constraints.F]
type = "pin"
points = ["plank.center", "middle.end"]
"""
FOUR_BAR = """
[parameters]
m = "mass"
a = "length"
omega_0 = "angular speed"
[coordinates.alpha]
start = "atan(4/3)"
speed = "omega_0"
[coordinates.beta]
start = "0"
[coordinates.gamma]
start = "pi/2"
[bodies.crank]
shape = "rod"
mass = "m"
length = "5*a"
start = "O"
angle = "alpha"
[bodies.coupler]
shape = "rod"
mass = "m"
length = "6*a"
start = "crank.end"
angle = "beta"
[bodies.rocker]
shape = "rod"
mass = "m"
length = "4*a"
start = ["9*a", "0"]
angle = "gamma"
[constraints.A]
type = "pivot"
point = "crank.start"
[constraints.B]
type = "pin"
points = ["crank.end", "coupler.start"]
[constraints.C]
type = "pin"
points = ["coupler.end", "rocker.end"]
[constraints.D]
type = "pivot"
point = "rocker.start"
"""
ON_FLOOR = """
[parameters]
m = "mass"
L = "length"
g = "acceleration"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.y]
dimension = "length"
start = "L/4"
[coordinates.phi]
start = "pi/6"
[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
center = ["x", "y"]
angle = "phi"
[points]
A = ["sqrt(3)*L/4", "L"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "rod.start"
line = "y = 0"
[constraints.T]
type = "string"
path = ["A", "rod.end"]
"""

SYSTEMS = [
    Textbook(
        "plank on two upright strings, one cut (Kleppner & Kolenkow, ch. 6)",
        PLANK + CUT,
        {
            "reactions/T_A": "m*g/2",
            "phases/0/reactions/T_A": "m*g/4",
            "phases/0/accelerations/y": "-3*g/4",
            "phases/0/accelerations/phi": "-3*g/(2*L)",
        },
    ),
    Textbook(
        "bar on two strings at 45 degrees, one cut (Beer & Johnston, ch. 16)",
        SLANTING + CUT,
        {
            "reactions/T_A": "m*g/sqrt(2)",
            "phases/0/reactions/T_A": "sqrt(2)*m*g/5",
            "phases/0/accelerations/phi": "-6*g/(5*L)",
        },
    ),
    Textbook(
        "bar that is let go on two parallel strings (Beer & Johnston, ch. 16: translation along circles)",
        SWINGING,
        {"reactions/T_A": "sqrt(3)*m*g/4", "accelerations/x": "-sqrt(3)*g/4", "accelerations/phi": "0"},
    ),
    Textbook(
        "the same as it runs through its lowest place",
        PLANK.replace('start = "0"', 'start = "0"\nspeed = "sqrt(g*h)"', 1),
        {"reactions/T_A": "m*g", "accelerations/y": "g", "at_start/speeds/phi": "0"},
    ),
    Textbook(
        "plank on two heavy links (Meriam & Kraige, ch. 6)",
        LINKS,
        {"accelerations/alpha": "-3*g*(m + M)/(2*L*(2*m + 3*M))", "accelerations/gamma": "0"},
    ),
    Textbook(
        "four-bar linkage with a crank as 3 : 4 : 5, by hand",
        FOUR_BAR,
        {
            "at_start/speeds/beta": "-omega_0/2",
            "at_start/speeds/gamma": "omega_0",
            "accelerations/beta": "45*omega_0**2/196",
        },
    ),
    Textbook(
        "rod with one end on a smooth floor, the other on an upright string",
        ON_FLOOR,
        {"accelerations/x": "0", "reactions/N": "m*g/2", "reactions/T": "m*g/2"},
    ),
]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_textbook(system: Textbook) -> None:
    assert not differences(system)
    assert answer(system.text)["at_start"]["reason"]
    found = derivation(system.text)
    assert not [step.id for step in found.all_steps if not step.certificate.verdict.is_proved]
    assert found.simulation.max_relative_error < 1e-9


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_the_simulation_agrees_at_many_sets_of_parameters(system: Textbook) -> None:
    for stage in stages(load_problem(system.text)):
        for numbers in islice(samples(stage.study.problem), SETS):
            own = {q.name: numbers[q.name] for q in stage.study.problem.parameters}
            assert simulate_study(stage.study, own).max_relative_error < 1e-8


@pytest.mark.parametrize("name", ["sliding-ladder", "rod-on-two-strings", "ladder-in-equilibrium"])
def test_what_is_told_for_every_position_is_told_at_the_start_too(name: str) -> None:
    """The accelerations and forces of the long road, with the start put in, are those of the short one."""
    problem = load_problem(problem_files()[name])
    study = study_of(problem)
    assert not study.at_start
    start = study.system.scope.start
    there = StartStudy(problem).instant
    for force, value in study.dynamics.reactions.items():
        assert same(substitute(study.on_motion(value), start), there.reactions[force])


WRONG = {
    "contradict the constraint “C” (pin)": FOUR_BAR.replace('start = "0"', 'start = "pi/4"', 1),
    "the start speed": FOUR_BAR.replace('start = "0"', 'start = "0"\nspeed = "omega_0"', 1),
    "singular position": FOUR_BAR.replace("atan(4/3)", "0").replace('"pi/2"', '"pi"').replace('["9*a", "0"]', '["15*a", "0"]'),
    "“F” asks of the speeds what others ask already": LINKS + THIRD,
    "would have to push at the start": PLANK.replace('start = "-h"', 'start = "h"'),
}


@pytest.mark.parametrize("said", WRONG)
def test_a_start_that_can_not_be_gets_a_sentence(said: str) -> None:
    with pytest.raises(StatementError, match=said.replace("(", r"\(").replace(")", r"\)")):
        derivation(WRONG[said])


def test_what_is_cut_loose_is_told_for_every_position() -> None:
    begun, loose = stages(load_problem(PLANK + CUT.replace('["T_B"]', '["T_A", "T_B"]')))
    assert begun.study.at_start and not loose.study.at_start


def test_another_event_than_at_once_is_refused() -> None:
    found = answer(PLANK + CUT.replace('"at once"', '"reaches"\nof = "phi"\nat = "1"'))
    assert "known at its start alone" in found["phases"][0]["reason"]


def test_a_body_may_be_placed_by_a_point_of_another() -> None:
    plain = LINKS.replace('start = "left.end"', 'start = ["L*cos(alpha)", "L*sin(alpha)"]').replace('"Q"', '["b", "0"]')
    assert [body.placed for body in load_problem(LINKS).bodies] == [body.placed for body in load_problem(plain).bodies]


@pytest.mark.parametrize("point", ["right.end", "plank.end", "left.middle"])
def test_only_by_a_point_of_one_that_stands_before(point: str) -> None:
    with pytest.raises(StatementError, match="no point of a body that is placed before it"):
        load_problem(LINKS.replace('start = "left.end"', f'start = "{point}"'))


def test_what_holds_at_the_start_can_be_asked_for() -> None:
    [found] = ask(load_problem(SLANTING + CUT), "T_A when cut begins")
    assert found.verdict.is_proved
    assert same(found.values[0], read(SLANTING, "sqrt(2)*m*g/5"))
    laws = {"instant.second.T_A", "instant.force.bar", "instant.torque.bar"}
    assert {step.id for step in found.steps} == {"held.T_A", *laws, "instant.force.T_A", "answer"}  # nothing of what is not asked
    with pytest.raises(StatementError, match="only the start is known"):
        ask(load_problem(SLANTING), "T_A")


def test_a_motion_of_which_only_the_start_is_known_is_not_explored() -> None:
    with pytest.raises(StatementError, match="known at its start alone"):
        explorer((load_problem(SLANTING + CUT),), "en")
