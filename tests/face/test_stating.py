"""Problems stated with sympy: what they are, and the sentence for each that is wrong."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Eq, Function, Matrix, Symbol, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rbpsym as rb
from rbpsym.errors import RbpsymError
from rbpsym.face.reading import tree_of

m, ell, g, R, k = symbols("m ell g R k", positive=True)
theta, phi = dynamicsymbols("theta phi")
t = dynamicsymbols._t
bare = Symbol("ell")


def pendulum(length: Any = 2 * ell, angle: Any = theta - pi / 2, **others: Any) -> rb.Problem:
    sections = {
        "coordinates": [theta],
        "bodies": {"rod": rb.rod(length=length, mass=m, start=(0, 0), angle=angle)},
        "interactions": {"W": rb.gravity(g)},
        "constraints": {"F": rb.pivot("rod.start")},
    }
    return rb.problem("pendulum", **{**sections, **others})


def told(problem: rb.Problem) -> dict[str, tuple[str, str]]:
    return {each.name: (str(each.dimension), each.sign) for each in problem.parameters}


def test_the_slot_gives_the_dimension_and_the_symbol_the_sign() -> None:
    assert told(pendulum()) == {
        "m": ("mass", "positive"), "ell": ("length", "positive"), "g": ("acceleration", "positive"),
    }  # fmt: skip
    start = coordinates_from(Symbol("theta_0", real=True))
    assert start.implicit == ("theta_0",)
    assert coordinates_from(Symbol("theta_0", positive=True)).implicit == ()


def coordinates_from(start: Symbol) -> rb.Problem:
    return pendulum(coordinates={theta: rb.coordinate("angle", start=start, range=(0, pi / 2))})


def test_it_is_the_problem_from_text() -> None:
    text = rb.problem(
        "pendulum",
        parameters={"g": "acceleration", "ell": "length", "m": "mass"},
        coordinates={"theta": {}},
        bodies={"rod": rb.rod("2*ell", mass="m", start=["0", "0"], angle="theta - pi/2")},
        interactions={"W": rb.gravity()},
        constraints={"F": rb.pivot("rod.start")},
    )
    symbolic = pendulum()
    assert {q.name: q for q in symbolic.parameters} == {q.name: q for q in text.parameters}
    assert rb.solve(symbolic, simulation=False)["accelerations"] == rb.solve(text, simulation=False)["accelerations"]


def test_dimensions_follow_from_sums_roots_and_other_slots() -> None:
    a, b, mu, c = symbols("a b mu c", positive=True)
    found = pendulum(
        length=sympy.sqrt(a**2 + b * R) + R,
        interactions={"W": rb.gravity(g), "D": rb.couple("rod", -c * theta.diff(t)), "S": rb.couple("rod", k * sin(mu * theta))},
    )
    assert {name: dimension for name, (dimension, _) in told(found).items()} == {
        "a": "length", "g": "acceleration", "m": "mass", "c": "rotary damping", "k": "torque", "mu": "number",
        "b": "length", "R": "length",
    }  # fmt: skip


def test_coordinates_that_are_lengths_are_seen() -> None:
    s = dynamicsymbols("s")
    sliding = rb.problem(
        "block", coordinates=s, interactions={"W": rb.gravity(g)},
        bodies={"block": rb.particle(mass=m, center=Matrix([s, 0]))},
        constraints={"N": rb.guide("block.center", Eq(Symbol("y"), 0))},
    )  # fmt: skip
    assert str(sliding.coordinate("s").quantity.dimension) == "length"


def test_driven_by_functions_of_the_time() -> None:
    Omega, A = symbols("Omega A", positive=True)
    held = {"F": rb.pivot("rod.start", at=(A * cos(Omega * t), 0))}
    driven = pendulum(bodies={"rod": rb.rod(ell, mass=m, angle=theta - pi / 2)}, constraints=held)
    assert told(driven)["Omega"] == ("angular speed", "positive") and told(driven)["A"] == ("length", "positive")
    forcing = rb.model(driven).forcing[0]
    assert forcing.has(cos(Omega * t)) and rb.derive(driven, simulation=False).summary()["methods_agree"]


def test_assumptions_go_both_ways() -> None:
    a, b = symbols("a b", positive=True)
    beta, n = Symbol("beta", real=True), Symbol("n", nonnegative=True)
    w = Symbol("w", real=True, nonzero=True)
    problem = pendulum(
        length=a + b + n * ell,
        angle=theta - pi / 2 + beta + w,
        parameters=rb.quantity(n, "number"),
        assumptions=[a > b, sympy.And(theta > 0, theta < pi / 2), beta < pi / 3, beta > -1, ell > 0],
    )
    ours = rb.model(problem)
    assert {each.name: each.sign for each in problem.parameters} == {
        "a": "positive", "b": "positive", "ell": "positive", "n": "nonnegative", "beta": "real", "w": "nonzero",
        "m": "positive", "g": "positive",
    }  # fmt: skip
    assert {theta > 0, theta < pi / 2, beta < pi / 3, beta > -1, a > b} <= set(ours.assumptions)
    assert sympy.Ne(w, 0, evaluate=False) in ours.assumptions and sympy.Ge(n, 0, evaluate=False) in ours.assumptions
    assert {a, b, n, beta, w, m, g, ell} == set(ours.parameters)
    again = pendulum(length=a + b + n * ell, angle=theta - pi / 2 + beta + w, parameters=rb.quantity(n, "number"),
                     assumptions=[each for each in ours.assumptions if not isinstance(each, (sympy.Ne, sympy.Ge))])  # fmt: skip
    assert again == problem


SIGN = "the sign of “ell” is not said"
WRONG: dict[str, tuple[Callable[[], object], str, str]] = {
    "no sign": (lambda: pendulum(2 * bare), SIGN, 'Symbol("ell", positive=True)'),
    "negative": (lambda: pendulum(-2 * Symbol("ell", negative=True)), "assumes what has no place", "positive=True"),
    "integer": (lambda: pendulum(Symbol("ell", positive=True, integer=True)), "assumes what has no place", "positive"),
    "two symbols of one name": (lambda: pendulum(ell + Symbol("ell", real=True)), "“ell” stands for two things", "same symbol"),
    "start without sign": (lambda: coordinates_from(Symbol("theta_0")), "the sign of “theta_0”", "real=True"),
    "declared otherwise": (
        lambda: pendulum(parameters={"ell": "length, nonnegative"}), "is positive, but declared to be nonnegative", "same"),
    "function that is no coordinate": (lambda: pendulum(angle=phi), "“phi(t)” is none of the coordinates", "[phi, ...]"),
    "function of something else": (lambda: pendulum(angle=Function("theta")(m)), "no function of t alone", "dynamicsymbols"),
    "function with assumptions": (
        lambda: pendulum(angle=Function("theta", real=True)(t)), "no function of t alone", "without assumptions"),
    "time with assumptions": (
        lambda: pendulum(angle=Function("theta")(Symbol("t", real=True))), "no function of t alone", "dynamicsymbols"),
    "acceleration in a pose": (lambda: pendulum(angle=theta.diff(t, 2)), "unknown symbol “theta_ddot”", ""),
    "third derivative": (lambda: pendulum(angle=theta.diff(t, 3)), "no speed or acceleration", ".doit()"),
    "derivative by a symbol": (lambda: pendulum(sympy.Derivative(ell**2, ell)), "no speed or acceleration", ".doit()"),
    "coordinate as a symbol": (lambda: pendulum(coordinates={Symbol("theta"): {}}), "changes with time", "dynamicsymbols"),
    "coordinate as a sum": (lambda: pendulum(coordinates=[theta + 1]), "is no symbol", "dynamicsymbols"),
    "unknown head": (lambda: pendulum(sympy.gamma(ell)), "(gamma) has no meaning here", "known are"),
    "hyperbolic": (lambda: pendulum(ell * sympy.cosh(1)), "(cosh) has no meaning here", "known are"),
    "piecewise": (lambda: pendulum(sympy.Piecewise((ell, ell > 1), (2, True))), "(Piecewise) has no meaning", "known are"),
    "imaginary": (lambda: pendulum(sympy.I * ell), "(ImaginaryUnit) has no meaning here", "known are"),
    "infinite": (lambda: pendulum(sympy.oo), "(Infinity) has no meaning here", "known are"),
    "no number": (lambda: pendulum(sympy.nan * ell), "(NaN) has no meaning here", "known are"),
    "integral": (lambda: pendulum(sympy.Integral(ell, (ell, 0, 1))), "(Integral) has no meaning here", "known are"),
    "dummy": (lambda: pendulum(sympy.Dummy("ell", positive=True)), "is no plain symbol", "sympy.Symbol"),
    "matrix symbol": (lambda: pendulum(sympy.MatrixSymbol("A", 2, 2)), "(MatrixElement) has no meaning", "known are"),
    "name with a backslash": (lambda: pendulum(Symbol(r"\ell", positive=True)), r"“\ell” can't be a name", "a letter first"),
    "name of an axis": (lambda: pendulum(Symbol("x", positive=True)), "“x” is reserved", "another name"),
    "length plus mass": (lambda: pendulum(ell + m), "must be", ""),
    "mass where a length belongs": (lambda: pendulum(ell, parameters=rb.quantity(ell, "mass")), "must be a length", ""),
    "dimension that does not follow": (lambda: pendulum(ell * sin(theta * 0 + 1) ** (k / R)), "does not follow", "quantity(R"),
    "unknown dimension": (lambda: rb.quantity(ell, "lenght"), "unknown dimension “lenght”", "did you mean “length”?"),
    "quantity without a sign": (lambda: rb.quantity(bare, "length"), SIGN, "positive=True"),
    "quantity of no symbol": (lambda: rb.quantity(2 * ell, "length"), "is no symbol", "write sympy.Symbol"),
    "speed in a length": (lambda: pendulum(ell * theta.diff(t)), "would be L T, which has no name", "mend the formula"),
    "closed bound": (lambda: pendulum(assumptions=[theta <= pi]), "can't be assumed", "ranges are open"),
    "equation assumed": (lambda: pendulum(assumptions=[Eq(theta, 1)]), "can't be assumed", "a < b"),
    "no relation assumed": (lambda: pendulum(assumptions="theta > 0"), "can't be assumed", "a < b"),
    "bound of a sum": (lambda: pendulum(assumptions=[2 * theta < 1]), "bounds nothing", "declared"),
    "bound of a sine": (lambda: pendulum(assumptions=[sin(theta) < 1]), "bounds nothing", "declared"),
    "slip in a declaration": (lambda: pendulum(parameters={"ell": "lenght: half"}), "unknown dimension", "did you mean"),
    "coordinate that is no table": (lambda: pendulum(coordinates={theta: "angle"}), "must be a table", ""),
    "symbol called pi": (lambda: pendulum(Symbol("pi", positive=True)), "is no plain symbol", "sympy.pi"),
    "time with a sign": (lambda: pendulum(ell * Symbol("t", positive=True)), "is no plain symbol", "dynamicsymbols._t"),
    "formula as a name": (lambda: pendulum(Symbol("2*m", positive=True)), "“2*m” can't be a name", "a letter first"),
    "bounded twice": (lambda: pendulum(assumptions=[theta < 1, theta < 2]), "bounds nothing", "declared"),
    "number too long": (lambda: pendulum(ell * sympy.Integer(10) ** 40), "more than 30 digits", "shorter"),
    "power too high": (lambda: pendulum(ell**100 / ell**99 * (ell / R) ** 200), "200 is beyond 64", ""),
    "too large": (lambda: pendulum(sum((Symbol(f"a_{i}", positive=True) for i in range(2100)), ell)), "more than 2000 parts", ""),
    "too deep": (lambda: pendulum(nested(40)), "nested deeper than 60 levels", ""),
}  # fmt: skip


def nested(depth: int) -> sympy.Expr:
    found = theta
    for _ in range(depth):
        found = sin(found) + 1
    return ell * found


@pytest.mark.parametrize("name", list(WRONG))
def test_wrong_inputs_get_a_sentence(name: str) -> None:
    make, what, instead = WRONG[name]
    with pytest.raises(RbpsymError) as found:
        make()
    assert what in str(found.value) and instead in str(found.value), str(found.value)
    assert found.value.exit_code == 2


ANSWERS: dict[str, tuple[Callable[[Any], object], str]] = {
    "text for an expression": (lambda model: model.lambdify(of="theta"), "a text is no expression of sympy"),
    "number missing": (lambda model: model.lambdify({g: 1}), "need a number for ell, m"),
    "number of a coordinate": (lambda model: model.lambdify({theta: 1}), "“theta” is no parameter"),
    "no number": (lambda model: model.lambdify({g: theta}), "no number is known for 'theta'"),
    "moving point": (lambda model: model.angular_momentum((theta, 0)), "is no fixed point"),
    "unknown point": (lambda model: model.angular_momentum("Q"), "“Q” is no fixed point"),
    "unknown body": (lambda model: model.angular_momentum("O", "rob"), "there is no body “rob”"),
    "foreign symbol": (lambda model: model.lambdify({g: 1, ell: 1, m: 1}, of=R), "need a number for R"),
    "no problem": (lambda model: rb.model(3), "is a number"),
}


@pytest.mark.parametrize("name", list(ANSWERS))
def test_wrong_questions_get_a_sentence(name: str) -> None:
    ask, what = ANSWERS[name]
    with pytest.raises(RbpsymError) as found:
        ask(rb.model(pendulum()))
    assert what in str(found.value), str(found.value)


@given(st.text(max_size=8))
def test_any_name(name: str) -> None:
    """A symbol of any name is a parameter or gets a sentence; nothing of it is run."""
    try:
        assert pendulum(Symbol(name, positive=True)).parameters
    except RbpsymError as error:
        assert error.what


def test_names_that_are_words_of_python() -> None:
    found = pendulum(Symbol("lambda", positive=True))
    assert "lambda" in told(found)
    assert Symbol("lambda", positive=True) in rb.model(found).kinetic_energy.free_symbols


def test_what_is_bounded_in_text_bounds_the_other() -> None:
    found = pendulum(parameters={"ell": "length > 0"}, assumptions=[ell > R])
    assert told(found)["R"] == ("length", "positive") and sympy.Lt(R, ell) in rb.model(found).assumptions


def test_a_float_is_what_is_written() -> None:
    assert tree_of(0.1 * ell) == tree_of(ell / 10)


def test_sympy_waits_until_it_is_asked_for() -> None:
    code = (
        "import sys, rbpsym; rbpsym.problem, rbpsym.quantity, rbpsym.rod, rbpsym.equal('a', 'a');"
        "rbpsym.problem('p', parameters={'m': 'mass'}, coordinates={'s': {'dimension': 'length'}},"
        " bodies={'b': rbpsym.particle(mass='m', center=['s', '0'])});"
        "rbpsym.model, rbpsym.model('rod-pendulum');"
        "print([name for name in sys.modules if name.startswith('sympy')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
