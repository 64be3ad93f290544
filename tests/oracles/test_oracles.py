"""The oracles: they agree with what is derived, and refuse what is wrong."""

from dataclasses import replace
from functools import cache

import pytest

from rbpsym.decide.verdict import PROVED, REFUTED
from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.study import Study
from rbpsym.oracles.lagrange import agreement, lagrange_verdict
from rbpsym.oracles.simulation import Derived, simulate
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files, problem_files
from rbpsym.statement.loader import load_text
from tests.library.derived import derived

# The rest of the library is put to the oracles in tests/library.
NAMES = [part.name for part in load_course(course_files()["paper"]).parts if part.kind == "problem"]


@cache
def study(name: str) -> Study:
    return derived(name).study


def scaled(values: dict[str, Scalar], name: str, factor) -> dict[str, Scalar]:
    """The values, one of them multiplied."""
    return {**values, name: values[name] * factor}


@pytest.mark.parametrize("name", NAMES)
def test_simulation_agrees(name: str) -> None:
    it = study(name)
    report = simulate(
        Derived(it.system, it.dynamics, it.first_integral, it.squares, it.reactions_along_motion or {})
    )
    assert report.max_relative_error <= 1e-8
    assert report.drift is None or report.drift <= 1e-8
    assert {error.split()[0] for error in report.errors} >= {"acceleration", "force"}


@pytest.mark.parametrize("name", NAMES)
def test_lagrange_agrees(name: str) -> None:
    assert lagrange_verdict(study(name).system, study(name).dynamics).kind is PROVED


def _wrong(name: str) -> list[Dynamics]:
    """The dynamics with one acceleration wrong: its sign, a factor, a term too much."""
    right, found = study(name).dynamics, []
    for acceleration, value in right.accelerations.items():
        for bad in (-value, value * 2, value + symbol("theta_dot") ** 2):
            if bad != value:
                found.append(replace(right, accelerations={**right.accelerations, acceleration: bad}))
    return found


@pytest.mark.parametrize("name", NAMES)
def test_a_wrong_acceleration_is_refused(name: str) -> None:
    wrong = _wrong(name)
    assert len(wrong) >= 3
    for dynamics in wrong:
        verdict = lagrange_verdict(study(name).system, dynamics)
        assert verdict.kind is REFUTED
        assert verdict.witness is not None
        assert simulate(Derived(study(name).system, dynamics)).max_relative_error > 1e-3


@pytest.mark.parametrize("name", NAMES)
def test_a_wrong_force_is_refused(name: str) -> None:
    """The simulation has its own multipliers: no unknown force may be off by a little."""
    right = study(name).dynamics
    for force in right.reactions:
        for factor in (-1, 1 + symbol("theta_dot")):
            dynamics = replace(right, reactions=scaled(dict(right.reactions), force, factor))
            assert simulate(Derived(study(name).system, dynamics)).max_relative_error > 1e-3, force


@pytest.mark.parametrize("name", ["sliding-ladder", "rod-and-disk-fixed"])
def test_a_wrong_integral_is_refused(name: str) -> None:
    it = study(name)
    report = simulate(Derived(it.system, it.dynamics, it.kinetic[0]))
    assert report.drift > 1e-3
    assert report.max_relative_error > 1e-3
    squares = {n: value * 2 for n, value in it.squares.items()}
    assert simulate(Derived(it.system, it.dynamics, squares=squares)).max_relative_error > 1e-3


@pytest.mark.parametrize("name", NAMES)
def test_methods_that_differ_do_not_agree(name: str) -> None:
    it = study(name)
    right = dict(it.dynamics.accelerations)
    wrong = {n: value + 1 for n, value in right.items()}
    found = agreement(it, {"right": right, "wrong": wrong, "silent": None})
    assert {n: verdict.kind for n, verdict in found.items()} == {"right": PROVED, "wrong": REFUTED}


def test_a_mass_left_out_is_seen() -> None:
    """A wrong moment of inertia in the equations: Lagrange's equations take theirs from the poses."""
    it = study("rod-and-disk-fixed")
    light = {n: it.system.bodies[n] for n in it.system.bodies}
    disk = light["disk"]
    light["disk"] = replace(disk, inertia=replace(disk.inertia, moment=disk.moment * 0))
    other = Study(it.problem)
    other.__dict__["system"] = replace(it.system, bodies=light)
    assert lagrange_verdict(it.system, other.dynamics).kind is REFUTED
    assert simulate(Derived(it.system, other.dynamics)).max_relative_error > 1e-3


@pytest.mark.parametrize(("name", "of"), [("movable-pulley", '["R", "z"]'), ("cylinder-rolled-by-weight", '["d + r", "y"]')])
def test_what_a_slanting_string_would_pull_aside_is_refused(name, of):
    """Nothing holds the load on its upright way; the equation that says so has a root, which not all numbers have."""
    text = problem_files()[name].read_text(encoding="utf-8")
    with pytest.raises(StatementError, match="the body “weight” says more than its constraints hold"):
        derive(load_text(text.replace(f"center = {of}", f"center = {of.replace('R', 'R/3').replace('+ r', '+ r/3')}")))
