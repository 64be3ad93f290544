"""Steps that are proved like all others, but that a page does better without."""

from __future__ import annotations

from rbpsym.derivation.step import Derivation, Step
from rbpsym.notation import tree as t

AT_ONCE = "at once"
ALONG_MOTION = ("first_integral", "substitution", "stays", "work_done")


def needless(derivation: Derivation) -> frozenset[str]:
    """Ids of steps that tell a reader nothing.

    Newton's and Euler's equations of each body where no force is unknown and the accelerations are known already;
    the square of a speed that is zero all the time; velocities where nothing can move; what holds along a motion
    that ends before it begins, because of a blow at the start.
    """
    still, struck = is_still(derivation), _is_struck(derivation)
    return frozenset(
        step.id
        for step in derivation.steps
        if _repeats_motion(step, derivation)
        or _is_rest(step)
        or (still and _is_velocity(step))
        or (struck and _is_along_motion(step))
    )


def is_still(derivation: Derivation) -> bool:
    """Can nothing move?"""
    system = derivation.study.system
    return not system.independent and not system.has_clock


def _is_velocity(step: Step) -> bool:
    return step.chapter == "kinematics" and step.rule in ("differentiation", "identity")


def _is_struck(derivation: Derivation) -> bool:
    """Does the next phase begin where this one does?"""
    phases = derivation.study.problem.phases
    return bool(phases) and phases[0].event == AT_ONCE


def _is_along_motion(step: Step) -> bool:
    return step.rule in ALONG_MOTION or step.chapter == "contact"


def _repeats_motion(step: Step, derivation: Derivation) -> bool:
    known = any(found.rule == "solution" for found in derivation.chapter("motion"))
    return step.chapter == "reactions" and known and not derivation.study.system.unknowns


def _is_rest(step: Step) -> bool:
    found = step.statement
    return step.rule == "first_integral" and isinstance(found, t.Chain) and found.items[-1] == t.ZERO
