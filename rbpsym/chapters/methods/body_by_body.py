"""A balance about a fixed point for several bodies: one by one with the torques of the inner forces, then added."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.chapters.methods.balances import Balance
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, Space, Vector, derivative, short, substitute
from rbpsym.mechanics.system import Force
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL, BodyRef, PhraseRef, Step, StepRef


def along_k(node: t.Node) -> t.Node:
    """The vector along the axis of rotation that has this component."""
    return t.mul(node, t.Unit("z")) if node != t.ZERO else t.ZERO


def by_bodies(draft: Draft, balance: Balance, settled: Mapping[str, Step]) -> Step:
    """Body by body with the torque of the inner forces as an unknown, then added: at full detail, after the whole."""
    _name_inner_torques(draft, balance)
    steps = [_of_one(draft, balance, name, settled) for name in balance.bodies]
    left = _without(balance.left, settled)
    statement = t.equation(draft.show_brief(left), draft.show(balance.right, factor=True))
    names = [t.Sym(n) for n in _inner_names(draft, balance)]
    return draft.add(
        f"balance.{'.'.join(balance.bodies)}",
        "combination",
        statement,
        "torque.added",
        level=FULL,
        premises=[s.id for s in steps],
        equations=[StepRef(s.id) for s in steps],
        torques=names,
        count=len(names),
        data={"terms": [(1, step) for step in steps]},
    )


def _without(side: Scalar, settled: Mapping[str, Step]) -> Scalar:
    """One side of a balance without the accelerations that are known to be zero."""
    return substitute(side, dict.fromkeys(settled, NOTHING)) if settled else side


def _inner(draft: Draft, balance: Balance) -> list[Force]:
    return [f for f in draft.study.system.forces if f.on in balance.bodies and f.by in balance.bodies]


def _inner_names(draft: Draft, balance: Balance) -> list[str]:
    inner = [f for f in _inner(draft, balance) if f.unknowns]
    return list(dict.fromkeys(_letter(draft, f) for f in inner))


def _letter(draft: Draft, force: Force) -> str:
    """τ_N for the torque of the force N; an unknown couple keeps its own letter."""
    return draft.free(f"tau_{force.name}") if force.vector or not force.unknowns else force.name


def _name_inner_torques(draft: Draft, balance: Balance) -> None:
    for force in _inner(draft, balance):
        if not draft.study.system.is_reaction(force):
            value = short(force.torque(balance.where))
            letter = _letter(draft, force)
            if letter != force.name:
                draft.define(letter, value)
            draft.context.vectors[letter] = Space(z=value)


def _of_one(draft: Draft, balance: Balance, name: str, settled: Mapping[str, Step]) -> Step:
    """The balance of one body: the torques that are known, and those of the inner forces by their symbols."""
    state = draft.study.system.bodies[name]
    whole = short(state.mass * (state.center - balance.where).cross(state.acceleration) + state.moment * state.alpha)
    left, known = _without(whole, settled), _outer_torque(draft, balance, name)
    used = {n: step for n, step in settled.items() if derivative(whole, n)}
    net, momenta = _net_of_one(draft, balance, name, known), _momenta_of(draft, balance, name)
    right = t.add(*([draft.show(known)] if known else []), *_inner_torques(draft, balance, name, t.Sym))
    return draft.add(
        f"balance.{name}",
        "balance",
        t.equation(draft.show(left), right),
        f"torque.one.{'seen' if momenta else 'unseen'}",
        level=FULL,
        premises=[net.id, *(ref.id for ref in momenta), *(step.id for step in used.values())],
        momenta=momenta,
        settled=_settled(used),
    )


def _settled(used: Mapping[str, Step]) -> PhraseRef:
    """The accelerations that were left out, and what says that they vanish."""
    if not used:
        return PhraseRef("torque.none", {})
    zeros = [t.equation(t.Sym(name), t.ZERO) for name in used]
    return PhraseRef("torque.settled", {"zeros": zeros, "sources": [StepRef(step.id) for step in used.values()]})


def _outer_torque(draft: Draft, balance: Balance, name: str) -> Scalar:
    """The torque on a body of the set of all forces from outside the set."""
    outer = [f for f in draft.study.system.on(name) if f.by not in balance.bodies]
    return short(sum((f.torque(balance.where) for f in outer), NOTHING))


def _inner_torques(draft: Draft, balance: Balance, name: str, letter: type[t.Sym | t.Vec]) -> list[t.Node]:
    """Those of the forces between the bodies of the set, as symbols or as vectors."""
    inner = [f for f in draft.study.system.on(name) if f.by in balance.bodies]
    symbols = [(f, letter(_letter(draft, f))) for f in inner]
    return [t.neg(node) if draft.study.system.is_reaction(force) else node for force, node in symbols]


def _net_of_one(draft: Draft, balance: Balance, name: str, known: Scalar) -> Step:
    """The net torque on one body of the set."""
    forces = draft.study.system.on(name)
    total = sum((f.torque(balance.where) for f in forces), NOTHING)
    letter = draft.define_vector(draft.free(f"tau_{balance.label}_{name}"), Vector({}), short(total))
    parts = ([along_k(draft.show(known))] if known else []) + _inner_torques(draft, balance, name, t.Vec)
    return draft.add(
        f"torque.one.{name}",
        "torque",
        t.equation(letter, t.add(*parts)),
        "torque.alone",
        level=FULL,
        premises=[f"force.{f.name}.{f.on}" for f in forces],
        body=BodyRef(name),
        point=t.Sym(balance.label),
        data={"forces": tuple(forces), "origin": balance.where, "value": total},
    )


def _momenta_of(draft: Draft, balance: Balance, name: str) -> list[StepRef]:
    id = f"momentum.{name}.{balance.label}"
    return [StepRef(id)] if draft.has(id) else []
