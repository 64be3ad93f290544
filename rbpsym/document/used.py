"""What of a derivation a page needs: what it concludes, and what leads there. All else is shown at full detail only."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from rbpsym.derivation.step import Derivation, Step
from rbpsym.document.needless import is_struck
from rbpsym.notation import tree as t

# by chapter, the rules of steps that are conclusions though they stand in no box: what ties the coordinates, the motion,
# the forces, whether contacts last
CONCLUSIONS: Mapping[str, Collection[str]] = {
    "kinematics": ("constraint", "no_slip", "taut", "tied"),
    "forces": ("torque", "force"),
    "motion": ("solution", "conservation"),
    "reactions": ("solution",),
    "contact": ("substitution", "stays", "inequality", "vanishing", "value_there", "asked", "identity"),
    "oscillations": ("normal_modes", "mode_shape", "hurwitz", "motion_of_mode", "open_balance"),
}
# of the works, where a force works on the translation of a body and on its rotation: else the two halves show nothing that
# the energy of the whole does not
IN_HALVES = ("work_energy", "work_together", "work_integral", "conservation", "work_done", "power")
REPEATED = ("work.alone",)  # works body by body lead to the energy of the whole, which has a chapter of its own


def used(derivation: Derivation) -> frozenset[str]:
    """Ids of the steps that are conclusions, or from which the next phase begins, and of all that they rest on or refer to."""
    ends = [step.id for step in _ends(derivation)]
    ends += [id for phase in derivation.phases[:1] for step in phase.begins for id in step.reasons]
    return led_to(derivation.steps, ends)


def _ends(derivation: Derivation) -> list[Step]:
    """The conclusions: where a blow at the start ends the motion there are none, where the whole motion is given its energy,
    from which no speed follows, is none."""
    if is_struck(derivation):
        return derivation.chapter("inertia")
    system, both = derivation.study.system, _in_both_parts(derivation)
    without = "energy" if system.has_clock and not system.independent else ""
    found = (step for step in derivation.steps if step.chapter != without)
    return [step for step in found if step.is_result or _concludes(step, both)]


# of the works, what the chapter on the energy says once more of the whole
OF_THE_WHOLE = ("work.together.", "work.alone", "work.theorem.whole", "work.axis")


def retold(derivation: Derivation) -> frozenset[str]:
    """Ids of steps that say what others on the page do: the energy of the whole in terms of works, the rate at which it is
    lost, the balances of a body from which the motion was found."""
    ends = {row.items[-1] for step in derivation.chapter("energy") if step.is_result for row in t.rows(step.statement)}
    is_kept = any(step.id == "energy" for step in derivation.steps)
    phrases = (*OF_THE_WHOLE, "work.theorem.") if is_kept else OF_THE_WHOLE
    works = derivation.chapter("work") if derivation.chapter("energy") else ()
    again = [s.id for s in works if s.phrase.startswith(phrases) or (s.rule == "power" and s.statement.items[-1] in ends)]
    balanced = (s.id for s in derivation.chapter("reactions") if _is_balanced(s, derivation))
    return frozenset((*again, *balanced))


ABOUT_CENTRE = ("torque.balance.center", "torque.balance.center.some", "torque.balance.level")


def _is_balanced(step: Step, derivation: Derivation) -> bool:
    """Are Newton's and Euler's equations of a body those from which the motion was found?"""
    body = step.id.partition(".")[2]
    found = (s for s in derivation.chapter("motion") if s.id.startswith(("push.", "balance.")) and s.id.endswith(f".{body}"))
    own = [s for s in found if s.id.startswith("push.") or s.phrase in ABOUT_CENTRE]
    return step.phrase == "newton_euler.body" and len(own) == len(t.rows(step.statement))


def led_to(steps: Iterable[Step], ends: Iterable[str]) -> frozenset[str]:
    """Ids of the steps with which one ends, and of all those of the given ones that they rest on or refer to."""
    by_id, found, left = {step.id: step for step in steps}, set(), [*ends]
    while left:
        id = left.pop()
        if id in by_id and id not in found:
            found.add(id)
            left += by_id[id].reasons
    return frozenset(found)


def _concludes(step: Step, both: Collection[str]) -> bool:
    if step.chapter != "work":
        return step.rule in CONCLUSIONS.get(step.chapter, ())
    if step.rule == "work_done":
        return step.id.split(".", 2)[2] in both
    return bool(both) and step.rule in IN_HALVES and not step.phrase.startswith(REPEATED) and not _is_nothing(step)


def _in_both_parts(derivation: Derivation) -> frozenset[str]:
    """The forces on bodies that work on the translation and on the rotation."""
    works = (step for step in derivation.chapter("work") if step.rule == "work")
    return frozenset(s.id.partition(".")[2] for s in works if len(t.rows(s.statement)) > 1 and not _is_nothing(s, any))


def _is_nothing(step: Step, of: Callable[[Iterable[bool]], bool] = all) -> bool:
    """Something is zero, in each row, or in any."""
    return of(t.ZERO in row.items for row in t.rows(step.statement))
