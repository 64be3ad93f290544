"""What of a derivation a page needs: what it concludes, and what leads there. All else is shown at full detail only."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping

from rbpsym.derivation.step import Derivation, Step
from rbpsym.notation import tree as t

# by chapter, the rules of steps that are conclusions though they stand in no box: what ties the coordinates, the motion,
# the forces, the works in their two parts, whether contacts last
CONCLUSIONS: Mapping[str, Collection[str]] = {
    "kinematics": ("constraint", "no_slip", "taut", "tied"),
    "forces": ("torque", "force"),
    "motion": ("solution",),
    "reactions": ("solution",),
    "work": ("work_energy", "work_together", "work_integral", "work_done", "power"),
    "contact": ("substitution", "stays", "inequality", "vanishing", "value_there", "asked"),
    "oscillations": ("normal_modes", "mode_shape", "hurwitz", "motion_of_mode", "open_balance"),
}
REPEATED = ("work.alone",)  # works body by body lead to the energy of the whole, which has a chapter of its own


def used(derivation: Derivation) -> frozenset[str]:
    """Ids of the steps that are conclusions, and of all that they rest on or refer to."""
    by_id, found = {step.id: step for step in derivation.steps}, set()
    both = _in_both_parts(derivation)
    left = [step.id for step in derivation.steps if step.is_result or _concludes(step, both)]
    while left:
        id = left.pop()
        if id in by_id and id not in found:
            found.add(id)
            left += by_id[id].reasons
    return frozenset(found)


def _concludes(step: Step, both: Collection[str]) -> bool:
    if step.rule == "work_done":
        return step.id.split(".", 2)[2] in both
    return step.rule in CONCLUSIONS.get(step.chapter, ()) and not _is_nothing(step) and not step.phrase.startswith(REPEATED)


def _in_both_parts(derivation: Derivation) -> frozenset[str]:
    """The forces on bodies that do work on the translation and on the rotation: of others the split shows nothing."""
    found = Counter(step.id.split(".", 2)[2] for step in derivation.chapter("work") if step.rule == "work_done")
    return frozenset(whose for whose, parts in found.items() if parts > 1)


def _is_nothing(step: Step) -> bool:
    """Something is zero, in each row."""
    return step.chapter == "work" and all(t.ZERO in row.items for row in t.rows(step.statement))
