"""Statics as a teacher does it: one balance after the other, each with one force that is not known yet."""

from __future__ import annotations

from collections.abc import Iterable

from rbpsym.chapters.methods.balances import Balance, all_balances, outer_forces, silent_forces
from rbpsym.errors import LimitError
from rbpsym.expr import tree as t
from rbpsym.field import is_zero, short
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.present.signs import positive_first
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Step, bodies_named


def write(draft: Draft) -> list[Step]:
    """The balances, where nothing can move; none if no order determines one force each."""
    try:
        chosen = one_by_one(draft.study)
    except LimitError:
        return []
    return [_stated(draft, place, balance) for place, balance in enumerate(chosen, 1)]


def one_by_one(study: Study) -> list[Balance]:
    """Balances of which each holds one unknown force that those before do not: what is asked as soon as it can be, what holds
    the whole before what acts between its bodies, the fewest unknown forces first, about the points where most of them meet."""
    if study.system.independent or study.system.has_clock:
        return []
    held = {name for force in outer_forces(study.system, tuple(study.system.bodies)) for name in force.unknowns}
    asked = {word for text in study.problem.questions for word in text.split()}
    left, known, found = [b for b in all_balances(study) if _can_be_told(b, study)], set[str](), list[Balance]()

    def rank(balance: Balance) -> tuple[float, ...]:
        new, silent = balance.unknowns - known, _silent(balance, study)
        return not new <= asked, not new <= held, len(balance.unknowns), -len(balance.bodies), -len(silent), balance.cost

    while known != {*study.system.unknowns}:
        ready = [balance for balance in left if len(balance.unknowns - known) == 1]
        if not ready:
            return []
        found.append(min(ready, key=rank))
        known |= found[-1].unknowns
    return found


def _silent(balance: Balance, study: Study) -> set[str]:
    """The unknown forces that drop out of a balance."""
    return {name for force in outer_forces(study.system, balance.bodies) for name in force.unknowns} - balance.unknowns


def _can_be_told(balance: Balance, study: Study) -> bool:
    """Is there something to balance, about a point or along a direction that has a name?"""
    body, _, point = balance.label.partition(".")
    is_named = bool(point) and body in study.problem.body_names
    return bool(balance.unknowns) and (balance.kind in ("fixed", "center") or balance.label in ("x", "y") or is_named)


def _stated(draft: Draft, place: int, balance: Balance) -> Step:
    is_push = balance.kind == "force"
    forces = outer_forces(draft.study.system, balance.bodies)
    gone = [f for f in forces if f.unknowns and not balance.unknowns & {*f.unknowns}]
    silent = [] if is_push else gone
    return draft.add(
        f"static.{place}",
        "balance",
        t.equation(_sum(draft, balance, forces), t.ZERO),
        f"statics.{balance.label}" if is_push else f"statics.{'fixed' if balance.kind == 'fixed' else 'point'}",
        premises=[f"force.{f.name}.{f.on}" for f in forces],
        bodies=bodies_named(balance.bodies),
        point=t.Sym(balance.label) if balance.kind == "fixed" else [balance.label],
        silent=silent_forces(silent),
        data={"forces": tuple(forces), "origin": balance.where},
    )


def _sum(draft: Draft, balance: Balance, forces: Iterable[Force]) -> t.Node:
    """The parts of the forces along the direction, or their torques about the point, one by one."""
    if balance.kind == "force":
        parts = [f.vector.dot(balance.where) for f in forces]
    else:
        parts = [f.torque(balance.where) for f in forces]
    return t.add(*positive_first([draft.show(value) for part in parts if not is_zero(value := short(part))]))
