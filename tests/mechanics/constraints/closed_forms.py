"""Comparing what the engine derives with the closed forms of a textbook."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.decide.verdict import PROVED
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.study import Study
from rbpsym.oracles.lagrange import lagrange_verdict
from rbpsym.oracles.simulation import Derived, simulate
from rbpsym.solve import text
from rbpsym.statement import build as rb
from rbpsym.statement.model import Problem

GRAVITY = {"W": rb.gravity()}
TOLERANCE = 1e-6


def stated(parameters: str, **sections: object) -> Problem:
    """A problem; `parameters` as "M: mass, R: length"; gravity acts if g is among them."""
    pairs = [part.split(":") for part in parameters.split(",")]
    known = {name.strip(): dimension.strip() for name, dimension in pairs}
    if "g" in known:
        sections["interactions"] = {**GRAVITY, **sections.get("interactions", {})}
    return rb.problem("test", parameters=known, **sections)


def value(expression: str, study: Study) -> Scalar:
    """The value of a closed form in the study's own names."""
    problem = study.problem
    names = {q.name for q in problem.parameters} | set(study.system.unknowns) | {"t"}
    for coordinate in problem.coordinates:
        names |= {coordinate.name, f"{coordinate.name}_dot"}
    return scalar(read_infix(expression, names))


def assert_same(found: Scalar | None, expected: str, study: Study, what: str = "") -> None:
    """Equal by exact algebra."""
    assert found is not None, what
    assert same(found, value(expected, study)), f"{what}: {text(found, study)} is not {expected}"


def check(problem: Problem, expected: Mapping[str, str], simulated: bool = True) -> Study:
    """Accelerations ("x_ddot") and unknown forces as expected; Lagrange and the simulation agree."""
    study = Study(problem)
    dynamics = study.dynamics
    for name, formula in expected.items():
        found = {**dynamics.reactions, **(dynamics.accelerations or {})}
        assert name in found, f"{name} is not among {sorted(found)}"
        assert_same(found[name], formula, study, name)
    verdict = lagrange_verdict(study.system, dynamics, study.assumptions)
    assert verdict.kind is PROVED, verdict
    if simulated:
        report = simulate(Derived(study.system, dynamics, study.first_integral, study.squares))
        assert report.max_relative_error < TOLERANCE, report
    return study


def work_of(study: Study, force: str, on: str) -> tuple[Scalar | None, Scalar | None]:
    """(translational, rotational) work of a force on a body since the start."""
    item = next(w for w in study.works if (w.force, w.on) == (force, on))
    return item.translational.value, item.rotational.value
