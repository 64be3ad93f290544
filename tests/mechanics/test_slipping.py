"""A motion in time under kinetic friction is told as far as the slip keeps its sense."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import depends_on, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.solutions import courses, given
from rbpsym.mechanics.study import Study
from rbpsym.solve import results
from rbpsym.statement import load_text
from rbpsym.typeset.text import to_text
from tests.library.derived import FOLLOWED, problem

BLOCK = """
[parameters]
m = "mass"
k = "stiffness"
c = "damping < 2*sqrt(k*m)"
g = "acceleration"
mu = "number"
L = "length"
v = "speed"
[coordinates.x]
dimension = "length"
start = "{start}"
speed = "{speed}"
[bodies.block]
shape = "particle"
mass = "m"
center = ["L + x", "0"]
[interactions.W]
type = "gravity"
{more}
[constraints.N]
type = "contact"
point = "block.center"
line = "y = 0"
side = "positive"
coefficient = "mu"
slip = "{slip}"
"""
SPRING = '[interactions.S]\ntype = "spring"\nbetween = ["O", "block.center"]\nstiffness = "k"\nnatural_length = "L"\n'
DAMPER = '[interactions.D]\ntype = "damper"\nbetween = ["O", "block.center"]\ncoefficient = "c"\n'
THROWN = {"start": "0", "speed": "v", "slip": "forward"}
DRAWN = {"start": "x_0", "speed": "0", "slip": "backward"}
SYSTEMS = {
    "thrown": ({**THROWN, "more": ""}, "v/(mu*g) - t >= 0"),
    "drawn": ({**DRAWN, "more": SPRING}, "pi*sqrt(m/k) - t >= 0"),
    "drawn and damped": ({**DRAWN, "more": SPRING + DAMPER}, "2*pi*m/sqrt(4*m*k - c**2) - t >= 0"),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_first_stop_ends_it(name):
    put, told = SYSTEMS[name]
    [found] = results(Study(load_text(BLOCK.format(**put))))["solutions"]["x"]
    assert found["valid_where"] == [told]


@pytest.mark.parametrize(
    ("asked", "told"),
    [("x at t = 3*v/g", ["1 − 3μ ≥ 0"]), ("x at t = v/(2*mu*g)", []), ("x as a function of t", ["v − μgt ≥ 0"])],
)
def test_answers_in_time_ask_for_it_too(asked, told):
    [found] = ask(load_text(BLOCK.format(**SYSTEMS["thrown"][0])), asked)
    assert [to_text(node) for node in found.valid] == told


def test_what_comes_after_the_first_stop_is_refused():
    with pytest.raises(RbpsymError):
        ask(load_text(BLOCK.format(**SYSTEMS["thrown"][0])), "x at t = 2*v/(mu*g)")


TIMES = [0.05 * k for k in range(1, 80)]
ROUGH = [name for name in FOLLOWED if any(e.values.get("coefficient") is not None for e in problem(name).constraints)]


@pytest.mark.parametrize("name", [*ROUGH, *SYSTEMS])
def test_where_a_solution_is_told_nothing_slips_the_other_way(name):
    stated = problem(name) if name in FOLLOWED else load_text(BLOCK.format(**SYSTEMS[name][0]))
    study = Study(stated)
    known = {n: one for n in study.system.independent if (one := given(study, n)) is not None}
    found = {n: list(courses(one)) for n, one in known.items()}
    if any(len(cases) != 1 for cases in found.values()) or set(known) != set(study.system.independent):
        return
    at = {n: cases[0].whole for n, cases in found.items()} | {f"{n}_dot": cases[0].speed for n, cases in found.items()}
    demands = [demand for cases in found.values() for demand in cases[0].valid]
    numbers = {**sample(study.problem), **({} if name in FOLLOWED else {"mu": 0.01})}  # so that the spring begins to pull it
    for slip in slips(study.system).values():
        moving = substitute(slip, at)
        for time in TIMES if depends_on(moving, "t") else ():
            there = {**numbers, "t": time}
            if not all(number(demand.value, there) >= 0 for demand in demands):
                break  # as long as: what comes later is not told
            assert number(moving, there) >= -1e-9, time


def test_nothing_is_told_of_the_whole_of_a_motion_that_ends():
    """With kinetic friction the energy does not stay what it is: no amplitude, but a speed that is greatest where the forces
    balance, if it comes there; it was said that it never does, by numbers of which it does not."""
    sliding = {"start": "x_0", "speed": "-v", "slip": "backward", "more": SPRING}
    with pytest.raises(RbpsymError, match="no amplitude"):
        ask(load_text(BLOCK.format(**sliding)), "amplitude of x")
    [fastest] = ask(load_text(BLOCK.format(**sliding)), "greatest speed of x")
    names = {"m", "k", "v", "mu", "g", "x_0"}
    square = scalar(read_infix("v**2 + k*(x_0 - mu*m*g/k)**2/m", names))
    assert fastest.verdict.is_proved and is_zero(fastest.value**2 - square)
    assert [to_text(node) for node in fastest.valid] == ["kx₀ − μmg > 0"]
    smooth = BLOCK.format(**sliding).replace('coefficient = "mu"\nslip = "backward"\n', "")
    assert ask(load_text(smooth), "amplitude of x") and ask(load_text(smooth), "greatest speed of x")
