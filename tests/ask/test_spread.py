"""How mass is spread, asked of bodies that do not move: what tables print, and the integral over the mass in numbers."""

from __future__ import annotations

import pytest
from pytest import approx

from rbpsym.ask.asking import ask
from rbpsym.derive import derive
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.roots import without_even_roots
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.numbers import number
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Problem
from tests.statement.numeric import moments

NUMBERS = {"M": 3.0, "m": 0.7, "a": 1.5, "b": 2.5, "c": 0.5, "h": 1.1, "ell": 2.0, "r": 0.4, "R": 1.2, "n": 5.0, "beta": 0.6}
DIMENSIONS = {"M": "mass", "m": "mass", "beta": "angle", "n": "number > 2"}
NAMES = [*NUMBERS, "pi"]
PARTS = "shape = 'composite'\nparts = [%s]"
ROD, DISK = "{ shape = 'rod', mass = 'm', length = 'ell'%s }", "{ shape = 'disk', mass = 'M', radius = 'R'%s }"

SPOKE = "{ shape = 'rod', mass = 'm', length = 'R', at = ['R/2', '0'], repeat = 5 }"
BODIES = {
    "rod": "shape = 'rod'\nmass = 'M'\nlength = 'ell'",
    "denser": "shape = 'rod'\nlength = 'ell'\ndensity = 'm*s/ell**2'",
    "heavier": "shape = 'rod'\nmass = 'M'\nlength = 'ell'\ndensity = '1 + s/ell'",
    "rectangle": "shape = 'rectangle'\nmass = 'M'\nwidth = 'a'\nheight = 'b'",
    "disk": "shape = 'disk'\nmass = 'M'\nradius = 'R'\npoints = { rim = ['R', '0'] }",
    "half": "shape = 'half-disk'\nmass = 'M'\nradius = 'R'",
    "triangle": "shape = 'triangle'\nmass = 'M'\nbase = 'b'\nheight = 'h'",
    "sector": "shape = 'sector'\nmass = 'M'\nradius = 'R'\nopening = 'beta'",
    "arc": "shape = 'arc'\nmass = 'M'\nradius = 'R'\nopening = 'beta'",
    "dome": "shape = 'hemisphere'\nmass = 'M'\nradius = 'R'",
    "bowl": "shape = 'half-shell'\nmass = 'M'\nradius = 'R'",
    "ellipse": "shape = 'ellipse'\nmass = 'M'\nhalf_width = 'a'\nhalf_height = 'b'",
    "polygon": "shape = 'polygon'\nmass = 'M'\nvertices = [['0', '0'], ['a', '0'], ['0', 'b']]",
    "spokes": PARTS % ("{ shape = 'ring', mass = 'M', radius = 'R' }, " + SPOKE),
    "shared": "mass = 'M'\n" + PARTS % "{ shape = 'rod', length = 'ell', at = ['ell/2', '0'], repeat = 'n' }",
    "two": PARTS % (ROD % "" + ", " + DISK % ", at = ['ell/2', '0']"),
    "pierced": "mass = 'M'\n" + PARTS % "{ shape = 'disk', radius = 'R' }, { shape = 'disk', radius = 'r', removed = true }",
}
ASKED = [
    ("rod", "moment of inertia of it about end", "M*ell**2/3"),
    ("rod", "radius of gyration of it", "ell/(2*sqrt(3))"),
    ("rectangle", "moment of inertia of it about top_left", "M*(a**2 + b**2)/3"),
    ("rectangle", "moment of inertia of it about left", "M*a**2/3 + M*b**2/12"),
    ("disk", "moment of inertia of it about rim", "3*M*R**2/2"),
    ("half", "centre of mass of it", "0; 4*R/(3*pi)"),
    ("half", "moment of inertia of it about center", "M*R**2/2"),
    ("triangle", "moment of inertia of it", "M*b**2/24 + M*h**2/18"),
    ("denser", "mass of it", "m/2"),
    ("denser", "moment of inertia of it about start", "m*ell**2/4"),
    ("heavier", "mass of it", "M"),
    ("heavier", "centre of mass of it", "ell/18; 0"),
    ("heavier", "moment of inertia of it about start", "7*M*ell**2/18"),
    ("sector", "centre of mass of it", "4*R*sin(beta/2)/(3*beta); 0"),
    ("sector", "moment of inertia of it about center", "M*R**2/2"),
    ("arc", "moment of inertia of it about middle", "2*M*R**2*(1 - 2*sin(beta/2)/beta)"),
    ("dome", "moment of inertia of it about top", "2*M*R**2/5 - 2*M*R*3*R/8 + M*R**2"),
    ("bowl", "moment of inertia of it", "5*M*R**2/12"),
    ("ellipse", "moment of inertia of it about right", "M*(a**2 + b**2)/4 + M*a**2"),
    ("polygon", "centre of mass of it", "a/3; b/3"),
    ("polygon", "moment of inertia of it about origin", "M*(a**2 + b**2)/6"),
    ("spokes", "moment of inertia of it", "(M + 5*m/3)*R**2"),
    ("spokes", "mass of it", "M + 5*m"),
    ("shared", "moment of inertia of it about O", "M*ell**2/3"),
    ("shared", "centre of mass of it", "0; 0"),
    ("two", "moment of inertia of it about O", "m*ell**2/12 + M*R**2/2 + M*ell**2/4"),
    ("two", "centre of mass of it", "M*ell/2/(m + M); 0"),
    ("pierced", "moment of inertia of it about cm", "M*(R**2 + r**2)/2"),
]


def stated(body: str, more: str = "") -> Problem:
    """One body and nothing else."""
    told = "\n".join(f'{name} = "{DIMENSIONS.get(name, "length")}: {name}"' for name in NUMBERS)
    bound = told.replace('R = "length', 'R = "length > r')
    return load_text(f"[parameters]\n{bound}\n[bodies.it]\n{body}\n{more}", name="it")


@pytest.mark.parametrize(("body", "question", "expected"), ASKED)
def test_tables_of_moments(body: str, question: str, expected: str) -> None:
    [found] = ask(stated(BODIES[body]), question)
    wanted = [scalar(read_infix(text, NAMES)) for text in expected.split("; ")]
    gaps = (short(a - b) for a, b in zip(found.values, wanted, strict=True))
    assert all(is_zero(without_even_roots(gap)) for gap in gaps), found.text
    assert found.verdict.is_proved and found.steps


@pytest.mark.parametrize("body", BODIES)
def test_the_integral_over_the_mass_in_numbers(body: str) -> None:
    """The second road: mass, place and moment by quadrature; the moment about a place off the body by Steiner."""
    problem = stated(BODIES[body], "[points]\nQ = ['a', 'b']")
    answers = ask(problem, "mass of it", "centre of mass of it", "moment of inertia of it", "moment of inertia of it about Q")
    mass, x, y, second = moments(problem.body("it").shape.elements, NUMBERS)
    told = [number(value, NUMBERS) for found in answers for value in found.values]
    square = (x - NUMBERS["a"]) ** 2 + (y - NUMBERS["b"]) ** 2
    assert told == [approx(v, abs=1e-7) for v in (mass, x, y, second, second + mass * square)]


REPEATED = [
    ("{ shape = 'rod', mass = 'm', length = 'R', repeat = 1 }", "less than twice"),
    ("{ shape = 'rod', mass = 'm', length = 'R', repeat = '-n' }", "negative|positive"),
    ("{ shape = 'rod', mass = 'm', length = 'R', repeat = 'R' }", "must be"),
    ("{ shape = 'composite', repeat = 3, parts = [{ shape = 'rod', mass = 'm', length = 'R' }] }", "repeat its parts"),
]


@pytest.mark.parametrize(("part", "told"), REPEATED)
def test_wrong_repetitions_get_a_sentence(part: str, told: str) -> None:
    with pytest.raises(RbpsymError, match=told):
        stated(PARTS % part)


def test_bodies_alone_are_a_problem() -> None:
    derivation = derive(stated(BODIES["two"]))
    assert {step.chapter for step in derivation.steps} == {"inertia"} and not derivation.skipped
    assert derivation.summary()["proved"] == len(derivation.steps) > 3
    assert any(step.rule == "mass_center" for step in derivation.steps)


WRONG = [
    ("moment of inertia of it about corner", "has no point"),
    ("moment of inertia of planet", "there is no body"),
    ("acceleration of it.end", "no point"),
]


@pytest.mark.parametrize(("question", "told"), WRONG)
def test_wrong_questions_get_a_sentence(question: str, told: str) -> None:
    with pytest.raises(RbpsymError, match=told):
        ask(stated(BODIES["disk"]), question)


def test_what_acts_needs_something_that_moves() -> None:
    with pytest.raises(RbpsymError, match="no coordinates"):
        stated(BODIES["rod"], "[interactions.W]\ntype = 'couple'\non = 'it'\ncouple = '0'")
