"""What a model answers: parts that add up, works that are the energies, numbers, steps, looks; docstrings and types."""

from __future__ import annotations

import doctest
import importlib
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols

import rbpsym
from rbpsym.face.model import SymbolicModel
from tests.architecture.source import ROOT
from tests.library.derived import FOLLOWED, derived

t = dynamicsymbols._t
SHOWN = sorted(path.relative_to(ROOT) for path in (ROOT / "rbpsym").rglob("*.py") if ">>> " in path.read_text(encoding="utf-8"))


@cache
def model(name: str) -> SymbolicModel:
    return rbpsym.model(derived(name).study)


@pytest.mark.parametrize("name", FOLLOWED)
def test_every_problem_of_the_library_answers(name: str) -> None:
    """Energies and momenta are the sums of their parts; the power of the works is the rate of the kinetic energy."""
    ours = model(name)
    signs = ours.study.assumptions
    kinetic = ours.kinetic_energies
    assert rbpsym.equal(kinetic.total, ours.kinetic_energy, signs).is_proved
    assert rbpsym.equal(sum(each.total for each in kinetic.on.values()), ours.kinetic_energy, signs).is_proved
    total = ours.angular_momentum()
    assert rbpsym.equal(total.orbital + total.spin, total.total, signs).is_proved
    assert set(ours.works) == {force.name for force in ours.study.system.forces}
    assert len(ours.equations_of_motion) == ours.mass_matrix.rows == ours.forcing.rows == len(ours.speeds)
    assert set(ours.reactions) == set(ours.study.system.unknowns)
    assert ours.study.problem.name in repr(ours) and ours._repr_latex_().startswith("$")
    assert all(each.A.shape == (2 * len(ours.speeds),) * 2 for each in ours.linearize())


def test_a_place_of_rest_says_where_it_exists() -> None:
    """Upside down, a spring that is soft can not bear the weight."""
    m, k, rest, g = sympy.symbols("m k L g", positive=True)
    r, theta = dynamicsymbols("r theta")
    bob = {"bob": rbpsym.particle(mass=m, center=(r * sympy.sin(theta), -r * sympy.cos(theta)))}
    spring = rbpsym.spring(["bob.center", (0, 0)], k, rest)
    stated = rbpsym.problem("bob", coordinates=[r, theta], assumptions=[r > 0], bodies=bob,
                            interactions={"W": rbpsym.gravity(g), "S": spring})  # fmt: skip
    hanging, upside_down = rbpsym.model(stated).linearize()
    assert hanging.valid_where == () and hanging.stable
    [condition] = upside_down.valid_where
    assert sympy.expand(condition.lhs - (k * rest - m * g)) == 0 and condition.rel_op == ">"


def test_works_of_the_ladder() -> None:
    ladder = model("sliding-ladder")
    M, ell, g, theta_0 = (each for each in ladder.parameters)
    [theta] = ladder.coordinates
    wall = ladder.works["N_w"]
    assert sympy.simplify(wall.translational + wall.rotational) == 0 != wall.translational
    assert sympy.expand(ladder.works["W"].total - M * g * ell * (sympy.sin(theta_0) - sympy.sin(theta))) == 0
    assert wall.on["ladder"].translational == wall.translational
    assert [str(each) for each in (M, ell, g, theta_0)] == ["M", "ell", "g", "theta_0"] and M.is_positive


def test_works_without_closed_form_are_integrals_over_the_time() -> None:
    found = model("double-compound-pendulum").works
    assert any(half.has(sympy.Integral) for each in found.values() for half in (each.translational, each.rotational))


def test_numbers() -> None:
    ladder = model("sliding-ladder")
    M, ell, g, _ = ladder.parameters
    theta = ladder.coordinates[0]
    numbers = {M: 10, "ell": 2.5, g: sympy.Rational(981, 100)}
    fall = ladder.lambdify(numbers)
    assert fall(0, [1.0, 0.0]) == pytest.approx([0, -3 * 9.81 / 10 * np.cos(1.0)])
    assert ladder.lambdify()(0, [1.0, 0.0], 10, 2.5, 9.81) == pytest.approx(fall(0, [1.0, 0.0]))
    solution = solve_ivp(fall, (0, 1), [1.0, 0.0], rtol=1e-10, atol=1e-10)
    energy = ladder.lambdify(numbers, of=ladder.kinetic_energy + ladder.potential_energy)(solution.t, solution.y)
    assert energy == pytest.approx(energy[0])
    push, alpha = ladder.lambdify(numbers, of=[ladder.reactions["N_w"], theta.diff(t, 2)])(solution.t, solution.y)
    assert alpha == pytest.approx(-3 * 9.81 / 10 * np.cos(solution.y[0]))
    assert push[0] == pytest.approx(10 * 0.75 * 9.81 * np.sin(1) * np.cos(1))
    assert ladder.lambdify(numbers, of=g)(solution.t, solution.y).shape == solution.t.shape
    plain = sympy.lambdify([theta, M, ell, g], ladder.accelerations[theta.diff(t, 2)])
    assert plain(1.0, 10, 2.5, 9.81) == pytest.approx(alpha[0])


def bob() -> SymbolicModel:
    """On a string, in two coordinates that a condition ties."""
    m, ell, g = sympy.symbols("m ell g", positive=True)
    x, y = dynamicsymbols("x y")
    return rbpsym.model(rbpsym.problem(
        "bob",
        coordinates=[x, y],
        assumptions=[x > 0, x < ell / 2, y > -ell, y < -ell / 2],
        bodies={"bob": rbpsym.particle(mass=m, center=(x, y))},
        interactions={"W": rbpsym.gravity(g)},
        constraints={"T": rbpsym.string(["O", "bob.center"], ell)},
    ))  # fmt: skip


TIED = {"cart-and-rod": model, "bead-on-turning-hoop": model, "elastic-pendulum": model, "bob": lambda name: bob()}


@pytest.mark.parametrize("name", list(TIED))
def test_numbers_are_those_of_the_equations(name: str) -> None:
    """M q̈ = f holds for ẏ at a sample, also where coordinates are tied; there the conditions keep their value."""
    ours = TIED[name](name)
    numbers = {each: 0.5 + 0.1 * place for place, each in enumerate(ours.parameters)}
    y = np.array([0.3 + 0.2 * place for place, _ in enumerate(ours.state)])
    places = len(ours.coordinates)
    rates = ours.lambdify(numbers)
    mass, force = (ours.lambdify(numbers, of=list(matrix))(0.7, y) for matrix in (ours.mass_matrix, ours.forcing))
    assert mass.reshape(len(ours.speeds), -1) @ rates(0.7, y)[places:] == pytest.approx(force)
    for condition in ours.conditions:
        value, step = ours.lambdify(numbers, of=condition), 1e-6
        assert value(0.7, y + step * rates(0.7, y)) == pytest.approx(value(0.7, y), abs=1e-9)


def test_steps() -> None:
    pendulum = model("rod-pendulum")
    step = pendulum.steps["motion.theta"]
    theta = pendulum.coordinates[0]
    assert isinstance(step.relation, sympy.And) and step.relations[-1].lhs == theta.diff(t, 2)
    assert step.verdict.is_proved and step.latex and step._repr_latex_().startswith("$") and step.premises
    assert pendulum.steps["frequency.1"].relation.subs(pendulum.parameters[1], 1).free_symbols
    duties = model("sliding-ladder").steps["motion.from_energy"].obligations
    assert sympy.Ne(theta.diff(t), 0, evaluate=False) in duties
    assert any(id.startswith("phase2.") for id in model("bowling-with-overspin").steps)


def test_what_a_notebook_completes() -> None:
    names = set(dir(model("rod-pendulum")))
    assert {"kinetic_energy", "works", "equations_of_motion", "lambdify", "rigid_bodies", "steps", "linearize"} <= names
    assert {"model", "quantity", "problem"} <= set(dir(rbpsym))


@pytest.mark.parametrize("path", SHOWN, ids=str)
def test_docstrings_say_what_happens(path: Path) -> None:
    found = doctest.testmod(importlib.import_module(".".join(path.with_suffix("").parts)))
    assert found.attempted and not found.failed
