"""What a page does better without, and under which conditions the formulas that it shows hold."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.mechanics.study import Study
from rbpsym.proof.duties import merged
from rbpsym.proof.step import Derivation, Step

AT_ONCE = "at once"
ALONG_MOTION = ("first_integral", "substitution", "stays", "work_done")


def needless(derivation: Derivation) -> frozenset[str]:
    """Ids of steps that tell a reader nothing.

    Newton's and Euler's equations of each body where no force is unknown and the accelerations are known already;
    the square of a speed that is zero all the time; velocities where nothing can move; what holds along a motion
    that ends before it begins, because of a blow at the start.
    """
    still, struck = is_still(derivation), is_struck(derivation.study)
    return frozenset(
        step.id
        for step in derivation.steps
        if _repeats_motion(step, derivation)
        or _is_rest(step)
        or (still and step.chapter == "kinematics" and step.rule in ("differentiation", "identity", "no_slip", "taut"))
        or (struck and (step.rule in ALONG_MOTION or step.chapter == "contact"))
    )


def is_still(derivation: Derivation) -> bool:
    """Can nothing move?"""
    system = derivation.study.system
    return not system.independent and not system.has_clock


def is_struck(study: Study) -> bool:
    """Does the next phase begin where this one does?"""
    phases = study.problem.phases
    return bool(phases) and phases[0].event == AT_ONCE


def _repeats_motion(step: Step, derivation: Derivation) -> bool:
    known = any(found.rule == "solution" for found in derivation.chapter("motion"))
    return step.chapter == "reactions" and known and not derivation.study.system.unknowns


def _is_rest(step: Step) -> bool:
    found = step.statement
    return step.rule == "first_integral" and isinstance(found, t.Chain) and found.items[-1] == t.ZERO


# --- under which conditions the formulas on a page hold: their own open obligations, and those of what is not shown


def owed_by(steps: Iterable[Step], shown: Set[str]) -> Mapping[str, tuple[Any, ...]]:
    """For each shown step what is open of it; for a result also what is open of the hidden steps that it rests on. What the
    page has said is not said again, but where it was said of another case."""
    by_id = {step.id: step for step in steps}
    found: dict[str, tuple[Any, ...]] = {}
    told: list[tuple[tuple[Node, ...], set[Node]]] = []
    for id in (id for id in by_id if id in shown):
        own = merged(_open(by_id, by_id[id], shown))
        told.append((own, _in_its_words(by_id[id])))
        known = set().union(*(said for case, said in told if not _are_cases(case, own)))
        found[id] = tuple(node for node in own if node not in known)
        told[-1][1].update(t.relation(node.items[0], op, t.ZERO) for node in found[id] for op in SAYS.get(node.ops[0], node.ops))
    return {id: nodes for id, nodes in found.items() if nodes}


def _are_cases(one: tuple[Any, ...], other: tuple[Any, ...]) -> bool:
    """Whether something is positive in the one that is negative in the other."""
    signs = {node.items[0] for node in one if node.ops == (">",)}
    return any(t.neg(node.items[0]) in signs for node in other if node.ops == (">",))


SAYS: Mapping[str, tuple[str, ...]] = {">": (">", ">=", "!=")}  # what is positive is neither zero nor negative


def _in_its_words(step: Step) -> set[Node]:
    """“As long as N pushes”, says the sentence of its friction."""
    normal = step.slots.get("normal")
    return {t.relation(normal, ">=", t.ZERO)} if step.phrase.startswith("work.dissipated.friction") and normal else set()


def _open(by_id: Mapping[str, Step], step: Step, shown: Set[str]) -> list[Node]:
    found = [duty.relation for duty in step.certificate.verdict.open_obligations]
    if step.is_result:
        hidden, seen = [id for id in step.premises if id in by_id and id not in shown], set[str]()
        while hidden:
            id = hidden.pop()
            if id not in seen and (certificate := by_id[id].certificate):
                seen.add(id)
                found += [duty.relation for duty in certificate.verdict.open_obligations]
                hidden += [more for more in by_id[id].premises if more in by_id and more not in shown]
    return found
