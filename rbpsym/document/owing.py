"""Under which conditions the formulas on a page hold: their own open obligations, and those of what is not shown."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set

from rbpsym.derivation.step import Step
from rbpsym.notation.tree import Node


def owed_by(steps: Iterable[Step], shown: Set[str]) -> Mapping[str, tuple[Node, ...]]:
    """For each shown step what is open of it; for a result also what is open of the hidden steps that it rests on."""
    by_id = {step.id: step for step in steps}
    found = {id: tuple(dict.fromkeys(_open(by_id, by_id[id], shown))) for id in shown if id in by_id}
    return {id: nodes for id, nodes in found.items() if nodes}


def _open(by_id: Mapping[str, Step], step: Step, shown: Set[str]) -> list[Node]:
    found = [duty.relation for duty in step.certificate.verdict.open_obligations] if step.certificate else []
    if step.is_result:
        hidden, seen = [id for id in step.premises if id in by_id and id not in shown], set()
        while hidden:
            id = hidden.pop()
            if id not in seen:
                seen.add(id)
                verdict = by_id[id].certificate.verdict
                found += [duty.relation for duty in verdict.open_obligations]
                hidden += [more for more in by_id[id].premises if more in by_id and more not in shown]
    return found
