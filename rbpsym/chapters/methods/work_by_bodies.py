"""The work–energy theorem of each body alone, with the whole work of the forces between them as an unknown.

What such a force does on one body it does with the opposite sign on the other, so that in the sum it goes away.
"""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.chapters.inertia import turning_together
from rbpsym.chapters.methods.known_works import carried_out, gained, show_gained, since_start, started, steady
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, short
from rbpsym.frozen import Frozen
from rbpsym.mechanics import energy, motion
from rbpsym.mechanics.system import Force
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD, BodyRef, Step, StepRef

FAR_SHORTER = 0.5
MOST_AT_THE_BOARD = 2  # bodies; with more of them it is a matter for full detail


class Parts(Frozen):
    """The ideal forces between two bodies by name, and the known works on each body."""

    inner: Mapping[str, Force]
    known: Mapping[str, list[Scalar]]

    @property
    def level(self) -> int:
        """From which detail on they are shown."""
        return STANDARD if len(self.known) <= MOST_AT_THE_BOARD else FULL


def found(draft: Draft) -> Parts | None:
    """What each body alone is told with; None where another work is not a known function of position."""
    system = draft.study.system
    if len(system.bodies) < 2 or system.has_clock or not started(draft) or draft.study.dynamics.accelerations is None:
        return None
    if any(turning_together(draft, label) for label in draft.study.origins):
        return None
    inner = _inner(draft)
    known = {name: _known(draft, name, inner) for name in system.bodies}
    whole = {name: works for name, works in known.items() if works is not None}
    if any(depends_on(_growth(draft, name), f"{q}_dot") for name in whole for q in steady(draft)):
        return None  # a constant speed beside others: much to write, and nothing new
    return Parts(inner, whole) if inner and len(whole) == len(known) else None


def _inner(draft: Draft) -> dict[str, Force]:
    """Ideal forces between two bodies that do work on each of them, by name: the action, not the reaction."""
    found = {}
    for force in draft.study.system.forces:
        same = draft.study.system.named(force.name)
        pair = len({f.on for f in same}) == 2 and all(f.by in draft.study.system.bodies for f in same)
        if pair and draft.study.dynamics.workless.get(force.name) and not draft.study.system.is_reaction(force):
            found[force.name] = force
    return {name: force for name, force in found.items() if not is_zero(_power(draft, name, force.on))}


def _power(draft: Draft, name: str, on: str) -> Scalar:
    """The rate of both works of a force on a body."""
    return short(motion.net_power(draft.study.system, [f for f in draft.study.system.on(on) if f.name == name]))


def _known(draft: Draft, body: str, inner: Mapping[str, Force]) -> list[Scalar] | None:
    """The works of the other forces on a body, force by force; None if one of them is not known yet."""
    found = []
    for item in (i for i in draft.study.works if i.on == body and i.force not in inner):
        if is_zero(_power(draft, item.force, body)):
            continue
        value = carried_out(draft, [item])
        if value is None:
            return None
        found.append(value)
    return found


def write(draft: Draft, parts: Parts) -> None:
    """A step for each body and their sum."""
    letters = {name: t.Sym(draft.free(f"cal_w_{name}")) for name in parts.inner}
    for name, force in parts.inner.items():
        draft.context.works[letters[name].name] = _power(draft, name, force.on)
    acted_on = {force.on for force in parts.inner.values()}
    order = sorted(parts.known, key=lambda body: body not in acted_on)
    _sum(draft, parts, [_of_body(draft, body, parts, letters) for body in order], letters)


def _of_body(draft: Draft, body: str, parts: Parts, letters: Mapping[str, t.Sym]) -> Step:
    """± the works of the inner forces, and those that are known: the change of the kinetic energy of the body."""
    inner, known = parts.inner, parts.known[body]
    parties = {name: {f.on for f in draft.study.system.named(name)} for name in inner}
    unknown = [n if inner[k].on == body else t.neg(n) for k, n in letters.items() if body in parties[k]]
    growth = _growth(draft, body)
    acting = [k for k in letters if inner[k].on == body]
    return draft.add(
        f"alone.{body}",
        "work_energy",
        t.equation(t.add(*unknown, *(since_start(draft, work) for work in known)), show_gained(draft, growth)),
        "work.alone",
        premises=draft.those(
            *(f"work.{i.force}.{i.on}" for i in draft.study.works if i.on == body), f"theorem.T.{body}", f"theorem.theta.{body}"
        ),
        body=BodyRef(body),
        works=[letters[k] for k in acting],
        forces=[t.Vec(k) for k in acting or [k for k in letters if body in parties[k]]],
        variant={0: "other", 1: "one"}.get(len(acting), "many"),
        level=parts.level,
        data={"growth": growth},
    )


def _growth(draft: Draft, body: str) -> Scalar:
    state = draft.study.system.bodies[body]
    return gained(draft, energy.translational_energy(state) + energy.rotational_energy(state))


def _shown(draft: Draft, growth: Scalar) -> t.Node:
    """The inertias of the bodies side by side, unless that is far too long."""
    plain, brief = draft.show(growth), show_gained(draft, growth)
    return brief if length(brief) <= FAR_SHORTER * length(plain) else plain


def _sum(draft: Draft, parts: Parts, steps: list[Step], letters: Mapping[str, t.Sym]) -> None:
    """Added over all bodies."""
    total = short(sum((work for works in parts.known.values() for work in works), NOTHING))
    growth = short(sum((step.data["growth"] for step in steps), NOTHING))
    draft.add(
        "alone.added",
        "work_sum",
        t.equation(since_start(draft, total), _shown(draft, growth)),
        "work.added",
        premises=[step.id for step in steps],
        equations=[StepRef(step.id) for step in steps],
        works=list(letters.values()),
        count=len(letters),
        level=parts.level,
        data={"terms": [(1, step) for step in steps]},
    )
