"""Motions as functions of the time, as textbooks give them.

Kleppner & Kolenkow, Introduction to Mechanics, 2 and 11; Taylor, Classical Mechanics, 2 and 5; Marion & Thornton, 2 and 3;
Meriam & Kraige, Dynamics, 8; Beer & Johnston, Dynamics, 11 and 19; Morin, Introduction to Classical Mechanics, 3 and 4.
"""

from __future__ import annotations

import math

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered, ask
from rbpsym.ask.numbers import value_at
from rbpsym.decide.equal import equal
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import number
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.text import to_text
from tests.ask.lines import on_line

AHEAD, AWAY = 'v_0 = "speed: v_0"', 'x_0 = "length: x_0"'
REST = {"start": "0", "speed": "0"}
GOES = {"start": "0", "more": AHEAD}
# where one number is greater than another, so that what is asked for is met
NUMBERS = {"m": 2.0, "k": 8.0, "b": 1.5, "c": 0.3, "g": 9.8, "F": 3.0, "Omega": 1.3, "v_1": 1.1, "d": 0.2, "mu": 0.4,
           "x_0": 0.7, "v_0": 1.9, "t": 0.37, "x": 0.1, "x_1": 0.5}  # fmt: skip

LINES = [
    # oscillations: Kleppner & Kolenkow 11.2, Taylor 5.2, Meriam & Kraige 8/2
    ("-k*x", {}, "x as a function of t", "x_0*cos(sqrt(k/m)*t) + v_0*sqrt(m/k)*sin(sqrt(k/m)*t)"),
    ("-k*x", {}, "speed of x as a function of t", "v_0*cos(sqrt(k/m)*t) - x_0*sqrt(k/m)*sin(sqrt(k/m)*t)"),
    ("m*g - k*x", REST, "x as a function of t", "m*g/k*(1 - cos(sqrt(k/m)*t))"),
    ("-k*x", {}, "amplitude of x", "sqrt(x_0^2 + m*v_0^2/k)"),
    ("-k*x", {}, "greatest speed of x", "sqrt(v_0^2 + k*x_0^2/m)"),
    ("-k*x", {"speed": "0", "more": AWAY}, "time until x = 0", "pi/2*sqrt(m/k)"),
    ("-k*x", {"speed": "0", "more": AWAY}, "time until x = -x_0", "pi*sqrt(m/k)"),
    ("m*g - k*x", REST, "time until x = 2*m*g/k", "pi*sqrt(m/k)"),
    ("-k*x", GOES, "time until x = v_0*sqrt(m/k)", "pi/2*sqrt(m/k)"),
    ("-k*x", {"speed": "0", "more": AWAY}, "time until x = x_0/2", "pi/3*sqrt(m/k)"),
    ("-k*x", GOES, "time until x = d", "sqrt(m/k)*asin(d*sqrt(k/m)/v_0)"),
    ("-k*x", GOES, "time until x comes to rest", "pi/2*sqrt(m/k)"),
    ("k*x", {}, "x as a function of t", "(exp(sqrt(k/m)*t)*(x_0 + v_0*sqrt(m/k)) + exp(-sqrt(k/m)*t)*(x_0 - v_0*sqrt(m/k)))/2"),
    # damped ones: Marion & Thornton 3.5, Taylor 5.4
    ("-k*x - b*x_dot", {"speed": "0"}, "x as a function of t, underdamped",
     "x_0*exp(-b*t/(2*m))*(cos(sqrt(k/m - b^2/(4*m^2))*t) + b/(2*m)/sqrt(k/m - b^2/(4*m^2))*sin(sqrt(k/m - b^2/(4*m^2))*t))"),
    ("-k*x - b*x_dot", {}, "x as a function of t for critical damping", "(x_0 + (v_0 + sqrt(k/m)*x_0)*t)*exp(-sqrt(k/m)*t)"),
    ("-k*x - b*x_dot", {"start": "0"}, "x as a function of t, overdamped",
     "m*v_0/sqrt(b^2 - 4*k*m)*(exp((sqrt(b^2 - 4*k*m) - b)*t/(2*m)) - exp(-(sqrt(b^2 - 4*k*m) + b)*t/(2*m)))"),
    ("-k*x - b*x_dot", {"start": "0"}, "time until x comes to rest, underdamped",
     "atan(2*m*sqrt(k/m - b^2/(4*m^2))/b)/sqrt(k/m - b^2/(4*m^2))"),
    # driven ones: Marion & Thornton 3.6, Taylor 5.5, Meriam & Kraige 8/3
    ("F*cos(Omega*t) - k*x - b*x_dot", REST, "amplitude of x", "F/sqrt((k - m*Omega^2)^2 + (b*Omega)^2)"),
    ("F*cos(Omega*t) - k*x - b*x_dot", REST, "x as a function of t in the steady state",
     "F*((k - m*Omega^2)*cos(Omega*t) + b*Omega*sin(Omega*t))/((k - m*Omega^2)^2 + (b*Omega)^2)"),
    ("F*cos(Omega*t) - k*x", REST, "x as a function of t", "F/(k - m*Omega^2)*(cos(Omega*t) - cos(sqrt(k/m)*t))"),
    # resistance in proportion to the speed: Taylor 2.2, Marion & Thornton 2.4, Beer & Johnston 11
    ("-b*x_dot", GOES, "speed of x as a function of t", "v_0*exp(-b*t/m)"),
    ("-b*x_dot", GOES, "x as a function of t", "m*v_0/b*(1 - exp(-b*t/m))"),
    ("-b*x_dot", GOES, "speed of x as a function of x", "v_0 - b*x/m"),
    ("-b*x_dot", GOES, "total way of x", "m*v_0/b"),
    ("-b*x_dot", GOES, "time until x_dot = v_1", "m/b*ln(v_0/v_1)"),
    ("-b*x_dot", GOES, "time until x = d", "m/b*ln(m*v_0/(m*v_0 - b*d))"),
    ("-b*x_dot", GOES, "x when x_dot = v_1", "m*(v_0 - v_1)/b"),
    ("m*g - b*x_dot", REST, "speed of x as a function of t", "m*g/b*(1 - exp(-b*t/m))"),
    ("m*g - b*x_dot", REST, "x as a function of t", "m*g/b*(t - m/b*(1 - exp(-b*t/m)))"),
    ("m*g - b*x_dot", REST, "terminal speed of x", "m*g/b"),
    ("m*g - b*x_dot", REST, "time constant of x", "m/b"),
    ("m*g - b*x_dot", REST, "time until x_dot = m*g/(2*b)", "m/b*ln(2)"),
    # resistance in proportion to its square: Taylor 2.4, Morin 3.3, Marion & Thornton 2.4
    ("-c*x_dot**2", GOES, "speed of x as a function of t", "v_0/(1 + c*v_0*t/m)"),
    ("-c*x_dot**2", GOES, "x as a function of t", "m/c*ln(1 + c*v_0*t/m)"),
    ("-c*x_dot**2", GOES, "speed of x as a function of x", "v_0*exp(-c*x/m)"),
    ("-k*x - c*x_dot**2", GOES, "speed of x as a function of x",
     "sqrt(v_0**2*exp(-2*c*x/m) + k*m/(2*c**2)*(1 - 2*c*x/m - exp(-2*c*x/m)))"),
    ("-c*x_dot**2", GOES, "time until x = d", "m/(c*v_0)*(exp(c*d/m) - 1)"),
    ("-c*x_dot**2", GOES, "time until x_dot = v_1", "m/c*(1/v_1 - 1/v_0)"),
    ("m*g - c*x_dot**2", REST, "terminal speed of x", "sqrt(m*g/c)"),
    ("m*g - c*x_dot**2", REST, "speed of x as a function of t",
     "sqrt(m*g/c)*(1 - exp(-2*sqrt(c*g/m)*t))/(1 + exp(-2*sqrt(c*g/m)*t))"),
    ("m*g - c*x_dot**2", REST, "x as a function of t", "m/c*ln((exp(sqrt(c*g/m)*t) + exp(-sqrt(c*g/m)*t))/2)"),
    ("m*g - c*x_dot**2", REST, "speed of x as a function of x", "sqrt(m*g/c*(1 - exp(-2*c*x/m)))"),
    ("-m*g - c*x_dot**2", GOES, "x when x comes to rest", "m/(2*c)*ln(1 + c*v_0^2/(m*g))"),
    ("-m*g - c*x_dot**2", GOES, "time until x comes to rest", "sqrt(m/(c*g))*atan(v_0*sqrt(c/(m*g)))"),
    # a constant power
    ("F*v_1/x_dot", {"start": "0", "speed": "0"}, "x as a function of t", "2/3*t*sqrt(2*F*v_1*t/m)"),
    ("F*v_1/x_dot", GOES, "x as a function of t", "m/(3*F*v_1)*((v_0^2 + 2*F*v_1*t/m)*sqrt(v_0^2 + 2*F*v_1*t/m) - v_0^3)"),
    # dry friction until rest
    ("-mu*m*g", GOES, "time until x comes to rest", "v_0/(mu*g)"),
    ("-mu*m*g", GOES, "x when x comes to rest", "v_0^2/(2*mu*g)"),
]  # fmt: skip


@pytest.mark.parametrize(("force", "line", "question", "told"), LINES, ids=lambda value: str(value)[:50])
def test_answers_in_time_are_those_of_the_books(force: str, line: dict, question: str, told: str) -> None:
    found = answered(Asked(on_line(force, **line)), question)
    assert found.verdict.is_proved, found.verdict
    assert found.steps and all(step.certificate.verdict.is_proved for step in found.steps)
    expected = scalar(read_infix(told, list(NUMBERS)))
    numbers = {**NUMBERS, "b": 12.0} if "over" in question else NUMBERS
    assert number(found.value, numbers) == pytest.approx(number(expected, numbers), rel=1e-12)


LIBRARY = [
    ("torsion-pendulum", "theta as a function of t", "theta_0*cos(sqrt(2*kappa/(M*R^2))*t)"),
    ("disk-with-spring", "phi as a function of t", "x_0/R*cos(sqrt(2*k/(3*m))*t)"),
    ("disk-with-spring", "f as a function of t", "k*x_0/3*cos(sqrt(2*k/(3*m))*t)"),
    ("plank-on-two-rollers", "x as a function of t", "x_0*cos(sqrt(mu*g/a)*t)"),
    ("bead-on-rotating-rod", "r as a function of t", "r_0*(exp(Omega*t) + exp(-Omega*t))/2"),
    ("rod-pendulum", "theta as a function of t for small oscillations", "theta_0*cos(sqrt(3*g/(2*ell))*t)"),
    ("rod-pendulum", "time until theta = 0 for small oscillations", "pi/2*sqrt(2*ell/(3*g))"),
    ("rod-with-damper", "theta as a function of t for small oscillations, critically damped",
     "theta_0*(1 + sqrt(3*g/(2*ell))*t)*exp(-sqrt(3*g/(2*ell))*t)"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "question", "told"), LIBRARY, ids=lambda value: str(value)[:50])
def test_the_library_is_answered_in_time(name: str, question: str, told: str) -> None:
    asked = Asked(load_problem(find_problem(name)))
    found = answered(asked, question)
    letters = [q.name for q in asked.problem.parameters] + [f"{c.name}_0" for c in asked.problem.coordinates]
    numbers = {name: 0.4 + 0.17 * k for k, name in enumerate(letters)} | {"t": 0.6}
    assert found.verdict.is_proved, found.verdict
    assert number(found.value, numbers) == pytest.approx(number(scalar(read_infix(told, list(numbers))), numbers), rel=1e-12)


WRONG = [
    ("k*x - b*x_dot", {}, "x as a function of t, underdamped", "found for “x” as a function of the time"),
    ("-k*x", {}, "x as a function of t, overdamped", "found for “x” as a function of the time"),
    ("-k*x - 3*sqrt(m*k)*x_dot", {}, "x as a function of t, underdamped", "found for “x” as a function of the time"),
    ("-b*x_dot", GOES, "time until x comes to rest", "never has this value"),
    ("-b*x_dot", GOES, "terminal speed of x", "has no terminal speed"),
    ("-k*x", {}, "total way of x", "has no total way"),
    ("-k*x - b*x_dot", {}, "amplitude of x", "has no amplitude"),
    ("-k*x", {}, "x as a function of t in the steady state", "found for “x” as a function of the time"),
    ("-k*x**3", GOES, "x as a function of t", "found for “x” as a function of the time"),
    ("-k*x**3", GOES, "amplitude of x", "has no amplitude"),
    ("-k*x - c*x_dot**2 - b*x_dot", GOES, "speed of x as a function of x", "is no known function of x"),
    ("-b*x_dot - m*g", GOES, "time until x = 0", "no closed form was found for the moment"),
    ("-c*x_dot*sqrt(x_dot**2)", GOES, "x as a function of t", "found for “x” as a function of the time"),
]  # fmt: skip


@pytest.mark.parametrize(("force", "line", "question", "told"), WRONG, ids=lambda value: str(value)[:50])
def test_what_has_no_answer_in_time_gets_a_sentence(force: str, line: dict, question: str, told: str) -> None:
    force = force.replace("k*x**3", "k*x**3/d**2")
    with pytest.raises(RbpsymError, match=told):
        answered(Asked(on_line(force, **line)), question)


def test_an_unknown_that_is_only_repeated_is_no_answer() -> None:
    """“speed of x as a function of x” is never “x_dot”."""
    for force in ("-k*x - c*x_dot**2 - b*x_dot", "-c*x_dot**2 - b*x_dot"):
        with pytest.raises(RbpsymError, match="no known function of x"):
            answered(Asked(on_line(force)), "speed of x as a function of x")


def test_cases_of_damping_are_told_with_their_conditions() -> None:
    asked = Asked(on_line("-k*x - b*x_dot"))
    conditions = {
        "underdamped": ["4mk − b² > 0"],
        "critically damped": ["b = 2 √(mk)"],
        "overdamped": ["b² − 4mk > 0"],
    }
    for case, told in conditions.items():
        assert [to_text(node) for node in answered(asked, f"x as a function of t, {case}").valid] == told
        assert [to_text(node) for node in answered(asked, f"x where t = m/b, {case}").valid] == told
    edge, found = NUMBERS | {"m": 1.0, "k": 1.0, "b": 2.0}, answered(asked, "x where t = m/b, underdamped")
    with pytest.raises(RbpsymError, match="another case: this one needs 4mk − b² > 0"):
        value_at(found.study, found.values, found.valid, edge)
    sure = Asked(on_line("-k*x - 3*sqrt(m*k)*x_dot"))
    assert answered(sure, "x as a function of t").valid == ()


def test_a_wrong_solution_is_not_proved() -> None:
    """The checkers notice a solution that is spoiled: another frequency, another start, a later root."""
    from dataclasses import replace

    from rbpsym.chapters import course
    from rbpsym.expr import tree as t
    from rbpsym.field.scalar import symbol
    from rbpsym.mechanics import solutions
    from rbpsym.mechanics.study import Study
    from rbpsym.proof.draft import Draft
    from rbpsym.proof.rules import certify

    study = Study(on_line("-k*x - b*x_dot", more=AWAY))
    known = solutions.given(study, "x")
    for one in solutions.courses(known):
        for spoiled in (one.place * 2, one.place + symbol("t"), one.place + 1, one.place * symbol("t")):
            draft = Draft(study)
            id = course.told(draft, "x", replace(one, place=spoiled))
            assert not draft.context.steps[id].certificate.verdict.is_proved
        draft = Draft(study)
        step = draft.context.steps[course.told(draft, "x", one)]
        assert certify(draft.context, step).verdict.is_proved
        for letter in ("k", "x_dot"):  # the same formula of something else
            other = replace(step, statement=t.equation(t.Sym(letter), step.statement.items[-1]))
            assert not certify(draft.context, other).verdict.is_proved
    assert math.isclose(number(solutions.course(known).whole, {**NUMBERS, "t": 0.0}), NUMBERS["x_0"])


SLIPPING = """
[parameters]
m = "mass"
R = "length"
mu = "number"
g = "acceleration"
v_0 = "speed"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.phi]
start = "0"
speed = "0"
[bodies.ball]
shape = "ball"
mass = "m"
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
slip = "forward"
friction = "f"
"""


@pytest.mark.parametrize(
    ("question", "told"),
    [("angular momentum of ball about O", "-R*m*v_0"), ("x_dot - R*phi_dot", "v_0 - 7*mu*g*t/2")],
)
def test_places_that_only_the_time_ties_are_told_by_the_time(question: str, told: str) -> None:
    """x and phi are no functions of each other: what holds both is told as a function of the time, or is constant."""
    [found] = ask(load_text(SLIPPING), question)
    names = ("m", "R", "mu", "g", "v_0", "t")
    assert found.verdict.is_proved and equal(*(read_infix(text, names) for text in (found.text, told))).is_proved


TURNED_BEAD = """
[parameters]
m = "mass: bead"
k = "stiffness: spring"
a = "length: natural length"
L = "length: rod"
J = "moment of inertia: rod"
Omega = "angular speed: of the rod"
[coordinates.r]
dimension = "length"
start = "a"
[bodies.rod]
shape = "given"
mass = "m"
moment = "J"
center = "O"
angle = "Omega*t"
[bodies.bead]
shape = "particle"
mass = "m"
center = ["r*cos(Omega*t)","r*sin(Omega*t)"]
[interactions.S]
type = "spring"
between = ["O","bead.center"]
stiffness = "k"
natural_length = "a"
[constraints.P]
type = "pivot"
point = "rod.center"
[constraints.C]
type = "prescribed-angle"
body = "rod"
angle = "Omega*t"
[constraints.N]
type = "guide"
point = "bead.center"
line = "y = 0"
of = "rod"
"""


def test_an_amplitude_is_told_with_the_condition_under_which_it_swings() -> None:
    found, at = ask(load_text(TURNED_BEAD), "amplitude of r", "Omega for which amplitude of r = a")
    assert found.verdict.is_proved and [to_text(node) for node in found.valid] == ["k − mΩ² > 0"]
    names = ("k", "m")
    assert at.verdict.is_proved and equal(*(read_infix(text, names) for text in (at.text, "sqrt(k/(2*m))"))).is_proved
