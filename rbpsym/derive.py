"""The whole derivation of a problem: shared chapters, every method, and the independent roads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.algebra.effort import at_most
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.chapters import contact, forces, inertia, kinematics, momentum, oscillations
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import Derivation, DerivedPhase, Skipped
from rbpsym.equality.verdict import Verdict
from rbpsym.errors import LimitError, NotApplicable
from rbpsym.mechanics.pushing import check_start
from rbpsym.mechanics.study import Study
from rbpsym.methods import work_energy
from rbpsym.methods.registry import METHODS
from rbpsym.statement.model import Problem
from rbpsym.verify.lagrange import agreement

MOST_PRODUCTS = 250_000
BEFORE: tuple[Callable[[Draft], None], ...] = (kinematics.write, inertia.write, momentum.write, forces.write)
AFTER: tuple[Callable[[Draft], None], ...] = (contact.write, work_energy.write_done, oscillations.write)


def derive(problem: Problem, *, simulation: bool = True) -> Derivation:
    """The derivation of a problem, each step with its certificate.

    With `simulation`, the numerical oracle is run as well. Raises StatementError if the
    statement does not determine the motion.
    """
    first = _derived(Study(problem), simulation)
    if not problem.phases:
        return first
    try:
        return replace(first, phases=_phases(problem))
    except NotApplicable:
        return replace(first, skipped=(*first.skipped, Skipped("phases", "skipped.phases")))


def _derived(study: Study, simulation: bool) -> Derivation:
    """The derivation of one phase."""
    study.dynamics  # noqa: B018  what grows too long is refused before anything is written
    with suppress(LimitError):  # the signs at the start: told by the methods that can't do without the forces
        check_start(study)
    draft = Draft(study)
    for write in BEFORE:
        write(draft)
    found = {name: _carried_out(draft, name, method) for name, method in METHODS.items()}
    for write in AFTER:
        write(draft)
    return _with_oracles(draft, found, simulation)


def _phases(problem: Problem) -> tuple[DerivedPhase, ...]:
    """The later phases. Raises NotApplicable where the end of one has no closed form."""
    from rbpsym.derivation.phases import hand_overs

    return tuple(
        DerivedPhase(phase.name, phase.event, tuple(draft.steps), _derived(stage.study, simulation=False))
        for phase, stage, draft in hand_overs(problem)
    )


def _carried_out(draft: Draft, name: str, method: Callable) -> Mapping[str, Scalar] | None:
    """What a method finds; None, with its steps left out, if its formulas grow beyond the limits."""
    before = len(draft.steps)
    try:
        with at_most(MOST_PRODUCTS):
            return method(draft)
    except LimitError:
        draft.forget(before)
        draft.skip(name, "skipped.too_long", method=name)
        return None


def _with_oracles(draft: Draft, found: Mapping[str, Mapping[str, Scalar] | None], simulation: bool) -> Derivation:
    from rbpsym.verify.lagrange import lagrange_verdict

    study = draft.study
    report = _simulated(study) if simulation else None
    lagrange: Verdict = lagrange_verdict(study.system, study.dynamics, study.assumptions)
    agreed, letters = agreement(study, found), draft.context
    return Derivation(study, tuple(draft.steps), tuple(draft.skipped), agreed, report, lagrange, letters=letters)


def _simulated(study: Study):
    """The report of the numerical oracle; None where it does not know a kind of the statement."""
    from rbpsym.errors import NotApplicable
    from rbpsym.verify.simulation_phases import simulate_problem

    try:
        return simulate_problem(study)
    except NotApplicable:
        return None
