"""The whole derivation of a problem: shared chapters, every method, and the independent roads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from rbpsym.chapters import contact, course, forces, given_motion, inertia, instant, kinematics, moments, momentum, oscillations
from rbpsym.chapters.methods import work_energy
from rbpsym.chapters.methods.registry import METHODS
from rbpsym.errors import LimitError, NotApplicable
from rbpsym.field import Scalar, at_most, granted, in_all
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.pushing import check_start
from rbpsym.mechanics.study import Study
from rbpsym.oracles.lagrange import agreement, lagrange_verdict, start_verdict
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Derivation, DerivedPhase, Skipped, Step
from rbpsym.statement.model import Problem

MOST_PRODUCTS = 250_000  # of a method, beside the proofs of its steps
MOST_IN_ALL = 4_000_000  # of all chapters and proofs of a phase, some fifteen seconds: twice the longest of the library
BEFORE: tuple[Callable[[Draft], None], ...] = (kinematics.write, inertia.write, momentum.write, forces.write)
THERE: tuple[Callable[[Draft], None], ...] = (kinematics.write, inertia.write, forces.write, instant.write)
GIVEN: tuple[Callable[[Draft], None], ...] = (kinematics.write, given_motion.write)
AFTER: tuple[Callable[[Draft], None], ...] = (contact.write, work_energy.write_done, oscillations.write, course.write)


def derive(problem: Problem, *, simulation: bool = True, study: Study | None = None) -> Derivation:
    """The derivation of a problem, each step with its certificate.

    With `simulation`, the numerical oracle is run as well; `study` is its mechanics, if it was made. Raises StatementError if the
    statement does not determine the motion.
    """
    first = _derived(study or study_of(problem), simulation)
    if not problem.phases:
        return first
    try:
        phases = _phases(problem, first.steps)
        left_out = [Skipped("phases", "skipped.phases")] if len(phases) < len(problem.phases) else []
    except LimitError:
        phases, left_out = (), [Skipped("phases", "skipped.too_long", {"method": "phases"})]
    return replace(first, phases=phases, skipped=(*first.skipped, *left_out))


WORDS: Mapping[str, Any] = {  # what only the words and the drawing of a problem depend on
    "title": {}, "source": "", "notation": {}, "meanings": {}, "claims": (), "level": "", "topic": "", "example": {},
}  # fmt: skip


def physics_of(problem: Problem) -> Problem:
    """What a derivation depends on: the problem without its words and questions (but those that ask for impulses)."""
    asked: dict[str, dict[str, str]] = {text: {} for text in problem.questions if "impulse" in text.split()}
    parameters = tuple(replace(q, meaning="") for q in problem.parameters)
    coordinates = tuple(replace(c, quantity=replace(c.quantity, meaning="")) for c in problem.coordinates)
    return replace(problem, **WORDS, questions=asked, parameters=parameters, coordinates=coordinates)


def _derived(study: Study, simulation: bool, before: tuple[Step, ...] = ()) -> Derivation:
    """The derivation of one phase."""
    study.solved  # noqa: B018  what grows too long is refused before anything is written
    with suppress(LimitError):  # the signs at the start: told by the methods that can't do without the forces
        check_start(study)
    draft = Draft(study, before)
    with in_all(MOST_IN_ALL):
        found = _chapters(draft)
    return _with_oracles(draft, found, simulation)


def _chapters(draft: Draft) -> dict[str, Mapping[str, Scalar] | None]:
    """What each method finds; the letters of the first chapters are those of all others, which are left out without them."""
    if draft.study.problem.is_at_rest:
        _written(draft, moments.write)
        return {}
    if draft.study.problem.unstated:
        all(_written(draft, write) for write in GIVEN)
        return {}
    if draft.study.at_start:
        all(_written(draft, write) for write in THERE)
        return {}
    if not all(_written(draft, write) for write in BEFORE):
        for name in METHODS:
            draft.skip(name, "skipped.too_long", method=name)
        return dict.fromkeys(METHODS)
    found = {name: _carried_out(draft, name, method) for name, method in METHODS.items()}
    for write in AFTER:
        _written(draft, write)
    return found


def _written(draft: Draft, write: Callable[[Draft], None]) -> bool:
    """Whether a chapter came to its end; if not, the steps that it has are kept, and it is told that others are missing.

    Where nothing is left of the whole work, nobody on the way takes that for a refusal, which the study would keep.
    """
    try:
        with granted(MOST_IN_ALL):
            write(draft)
        return True
    except LimitError:
        draft.skip(draft.chapter, "skipped.cut", method=draft.chapter)
        return False


def _phases(problem: Problem, before: tuple[Step, ...]) -> tuple[DerivedPhase, ...]:
    """The later phases, as far as the ends of those before them are known. Raises LimitError where they grow too long."""
    from rbpsym.chapters.impulses import hand_overs

    with granted(MOST_IN_ALL):
        found = hand_overs(problem)
    return tuple(
        DerivedPhase(phase.name, phase.event, tuple(draft.steps), _derived(stage.study, False, before), draft.context)
        for phase, stage, draft in found
    )


def _carried_out(draft: Draft, name: str, method: Callable[[Draft], Mapping[str, Scalar] | None]) -> Mapping[str, Scalar] | None:
    """What a method finds; None, with its steps left out, if its formulas grow beyond the limits."""
    before = len(draft.steps)
    try:
        with granted(MOST_IN_ALL), at_most(MOST_PRODUCTS):
            return method(draft)
    except LimitError:
        draft.forget(before)
        draft.skip(name, "skipped.too_long", method=name)
        return None


def _with_oracles(draft: Draft, found: Mapping[str, Mapping[str, Scalar] | None], simulation: bool) -> Derivation:
    study = draft.study
    if study.problem.unstated:  # of forces nothing is said that could be looked at on another road
        return Derivation(study, tuple(draft.steps), tuple(draft.skipped), {}, letters=draft.context)
    report = _simulated(draft) if simulation and not study.problem.is_at_rest else None
    lagrange = start_verdict(study) if study.at_start else lagrange_verdict(study.system, study.dynamics, study.assumptions)
    agreed, letters = agreement(study, found) if found else {}, draft.context
    return Derivation(study, tuple(draft.steps), tuple(draft.skipped), agreed, report, lagrange, letters=letters)


def _simulated(draft: Draft) -> Any:
    """The report of the numerical oracle; None where it gave up, which is told."""
    from rbpsym.oracles.simulation_phases import simulate_problem

    try:
        return simulate_problem(draft.study)
    except NotApplicable as error:
        draft.skip("simulation", "skipped.simulation", reason=error.what)
        return None
