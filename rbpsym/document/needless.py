"""What a page does better without, and under which conditions the formulas that it shows hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import suppress
from itertools import chain
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import IMPLIED
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.study import Study
from rbpsym.proof.duties import merged
from rbpsym.proof.step import Derivation, Step

AT_ONCE = "at once"
OF_A_CASE = ("contact", "oscillations", "course")  # chapters whose conditions are those of a place, or of one of several courses
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


def owed_by(steps: Iterable[Step], shown: Set[str], given: Assumptions) -> Mapping[str, tuple[Any, ...]]:
    """For each shown step what is open of it; for a result also what is open of the hidden steps that it rests on. What follows
    from what the page has said, of the whole motion or of what it rests on or cites, is not said again."""
    by_id = {step.id: step for step in steps}
    found, told = dict[str, tuple[Any, ...]](), dict[str, tuple[Any, ...]]()
    for id in (id for id in by_id if id in shown):
        ground = _ground(by_id, id, cited=True)
        said = (nodes for other, nodes in told.items() if other in ground or by_id[other].chapter not in OF_A_CASE)
        known = (*_in_its_words(by_id[id]), *chain.from_iterable(said))
        found[id] = unsaid(merged(_open(by_id, by_id[id], shown)), known, given)
        told[id] = (*found[id], *_in_its_words(by_id[id]))
    return {id: nodes for id, nodes in found.items() if nodes}


def unsaid(nodes: tuple[Any, ...], known: Iterable[Any], given: Assumptions) -> tuple[Any, ...]:
    """The conditions that do not follow from those that are known."""
    known = list(known)
    met = assuming(given, (demand for _, demand in _read(known)), tighter=True)
    implied = {node for node, demand in _read(nodes) if IMPLIED[demand.op](sign(demand.value, met))}
    return tuple(node for node in nodes if node not in known and node not in implied)


def _read(nodes: Iterable[Any]) -> Iterator[tuple[Any, Demand]]:
    """Conditions with what they say, as far as their letters alone tell it."""
    for node in nodes:
        with suppress(RbpsymError):
            yield node, Demand(scalar(node.items[0]), node.ops[0])


def _ground(by_id: Mapping[str, Step], id: str, *, cited: bool = False) -> set[str]:
    """The steps that a step rests on; with those that are `cited` for the reader's sake."""
    found, open_ = set[str](), [id]
    while open_:
        step = by_id[open_.pop()]
        new = [one for one in (*step.premises, *(step.cites if cited else ())) if one in by_id and one not in found]
        found.update(new)
        open_ += new
    return found


def _in_its_words(step: Step) -> tuple[Node, ...]:
    """“As long as N pushes”, says the sentence of its friction."""
    normal = step.slots.get("normal")
    return (t.relation(normal, ">=", t.ZERO),) if step.phrase.startswith("work.dissipated.friction") and normal else ()


def _open(by_id: Mapping[str, Step], step: Step, shown: Set[str]) -> list[Node]:
    hidden = {id: one for id, one in by_id.items() if id not in shown} if step.is_result else {}
    ground = [step, *(hidden[id] for id in hidden if id in _ground({**hidden, step.id: step}, step.id))]
    return [duty.relation for one in ground if one.certificate for duty in one.certificate.verdict.open_obligations]
