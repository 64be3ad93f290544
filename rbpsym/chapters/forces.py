"""The ledger: every force on every body, with its torque about the centre of mass and the origins."""

from __future__ import annotations

from rbpsym.chapters.conditions import as_taken
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Space, Vector, is_zero, short
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.pushing import kept_sense
from rbpsym.mechanics.system import Force
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef
from rbpsym.statement.paths import round_size


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "forces"
    for force in draft.study.system.forces:
        _entry(draft, force)


def force_node(draft: Draft, force: Force) -> t.Node:
    """The vector as it is named: N on the second body, -N on the first, W_rod for one of several weights."""
    same = draft.study.system.named(force.name)
    if not force.vector:
        return t.neg(t.Sym(force.name)) if draft.study.system.is_reaction(force) else t.Sym(force.name)
    if draft.study.system.is_reaction(force):
        return t.neg(t.Vec(force.name))
    if len(same) > 1 and not any(draft.study.system.is_reaction(f) for f in same):
        return t.Vec(draft.free(f"{force.name}_{force.on}", taken=()))
    return t.Vec(force.name)


def name_node(draft: Draft, name: str) -> t.Node:
    """What is called so on all bodies together: a vector, or a couple."""
    vector = any(force.vector for force in draft.study.system.named(name))
    return t.Vec(name) if vector else t.Sym(name)


def tag(draft: Draft, force: Force) -> str:
    """Name by which works and torques of the force on its body are told apart."""
    same = {f.on for f in draft.study.system.named(force.name)}
    return force.name if len(same) == 1 else f"{force.name}_{force.on}"


def torque(force: Force, origin: Vector) -> Scalar:
    """Torque about a fixed point, the couple included."""
    return short(force.torque(origin))


def torque_node(draft: Draft, force: Force, origin: Vector) -> t.Node:
    """The torque of a force about a point: of the vector with its arm, and of the couple beside it."""
    arm = short((force.point - origin).cross(force.vector))
    return t.add(*(draft.show(part) for part in (arm, force.couple) if part))


def _entry(draft: Draft, force: Force) -> None:
    state, rows = draft.study.system.bodies[force.on], []
    node = force_node(draft, force)
    if force.vector:
        _define_vector(draft, node, force)
        rows.append(t.equation(node, draft.show_vector(force.vector)))
    center = short(torque_about_center(force, state))
    name = draft.free(f"tau_cm_{tag(draft, force)}")
    rows.append(t.equation(draft.define(name, center), torque_node(draft, force, state.center)))
    for label, origin in draft.study.origins.items():
        value = torque(force, origin)
        letter = draft.define(draft.free(f"tau_{label}_{tag(draft, force)}"), value)
        rows.append(t.equation(letter, torque_node(draft, force, origin)))
    draft.add(
        f"force.{force.name}.{force.on}",
        "torque",
        t.system(rows),
        f"forces.{force.law}",
        body=BodyRef(force.on),
        by=_party(draft, force),
        where=_place(draft, force),
        force=node,
        data={"forces": (force,), "origin": state.center, "value": center},
        obligations=() if draft.study.system.is_reaction(force) else _presupposed(draft, force.name),
    )


def _presupposed(draft: Draft, name: str) -> tuple[t.Chain, ...]:
    """Where the formula of a force holds: on the side that is taken, and while what is resisted keeps its sense."""
    element = draft.study.system.element(name)
    return (*as_taken(draft, element), *draft.asked(kept_sense(draft.study, element)))


BETWEEN = {"spring": "spring", "torsion-spring": "spring", "damper": "damper", "rotary-damper": "damper"}


def _party(draft: Draft, force: Force) -> str:
    """What exerts the force: a string or a spring that is taut between two bodies, else the other body."""
    if not _is_tension(draft, force):
        return BETWEEN.get(force.law, force.by)
    return "link" if draft.study.system.element(force.name).values.get("rigid") else "string"


def _is_tension(draft: Draft, force: Force) -> bool:
    return bool(force.unknowns) and draft.study.system.element(force.name).kind == "string"


def _place(draft: Draft, force: Force) -> str:
    """Where it acts: on the rim of a round body that a string leaves, or on what is smaller, on which it is wound."""
    path = draft.study.system.element(force.name)["path"] if _is_tension(draft, force) else ()
    turn = next((turn for turn in path if turn.sense and turn.grips and turn.center.label == force.where), None)
    if turn is None:
        return force.where
    size = round_size(draft.study.problem.body(force.on))
    return "rim" if size is not None and is_zero(scalar(size) - scalar(turn.radius)) else "wound"


def _define_vector(draft: Draft, node: t.Node, force: Force) -> None:
    if isinstance(node, t.Vec):
        draft.context.vectors[node.name] = Space(force.vector)
