"""Angular momentum and torque: the planner's balances, written out and solved."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.effort import at_most
from rbpsym.algebra.normal import is_zero, same
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar, symbol
from rbpsym.algebra.vector import Space
from rbpsym.derivation.chapters.forces import is_reaction, tag
from rbpsym.derivation.chapters.momentum import momentum_name
from rbpsym.derivation.draft import Draft, acceleration_symbol
from rbpsym.derivation.step import BodyRef, PhraseRef, Step, StepRef
from rbpsym.errors import LimitError
from rbpsym.mechanics.elimination import short, solve_linear
from rbpsym.methods.balances import Balance, outer_forces
from rbpsym.methods.planner import Plan, plan
from rbpsym.methods.solving import isolated, solved_for
from rbpsym.notation import tree as t

NAME = "torque"
MOST_PRODUCTS = 600_000  # some seconds: what takes more can't be read either


def write(draft: Draft) -> Mapping[str, Scalar] | None:
    """The steps; returns the accelerations that they give, None if the method does not apply."""
    draft.chapter = "motion"
    try:
        with at_most(MOST_PRODUCTS):
            found = plan(draft.study)
            if found is not None:
                return _solve(draft, found, [_balance(draft, balance) for balance in found.balances])
    except LimitError:
        draft.steps[:] = [step for step in draft.steps if step.chapter != draft.chapter]
    draft.skip(NAME, "skipped.planner")
    _projected(draft)
    return None


def _projected(draft: Draft) -> None:
    """The equations of motion along the velocities that the constraints allow, where no balances were found."""
    dynamics, system = draft.study.dynamics, draft.study.system
    for name, row, force in zip(system.independent, dynamics.mass_matrix, dynamics.forcing, strict=True):
        left = sum((m * symbol(a) for m, a in zip(row, system.accelerations, strict=True)), NOTHING)
        draft.add(
            f"motion.{name}",
            "balance",
            t.equation(draft.show(left), draft.show(force)),
            "torque.projected",
            coordinate=t.Sym(name),
            is_result=True,
            data={"row": left - force},
        )


def _balance(draft: Draft, balance: Balance) -> Step:
    if balance.kind == "force":
        return _push(draft, balance)
    if balance.kind == "fixed" and len(balance.bodies) > 1 and not _is_rigid(draft, balance.bodies):
        return _by_bodies(draft, balance)
    net = _net_torque(draft, balance)
    return _rate(draft, balance, net)


def _is_rigid(draft: Draft, bodies: tuple[str, ...]) -> bool:
    """Whether the bodies turn with one angular velocity about the same point (welded together)."""
    states = [draft.study.system.bodies[name] for name in bodies]
    return all(same(states[0].omega, state.omega) for state in states[1:])


def _point(draft: Draft, balance: Balance) -> t.Node:
    return t.Sym(balance.label if balance.kind == "fixed" else "cm" if balance.kind == "center" else "C")


def _subscript(balance: Balance) -> str:
    body = "_".join(balance.bodies)
    return {"fixed": f"{balance.label}_{body}", "center": f"cm_{body}"}.get(balance.kind, f"C_{body}")


def _net_torque(draft: Draft, balance: Balance) -> Step:
    """The net torque on the set, force by force."""
    forces = outer_forces(draft.study.system, balance.bodies)
    name = draft.free(f"tau_{_subscript(balance)}" if not draft.is_single else f"tau_{_point(draft, balance).name}")
    parts = [short((f.point - balance.where).cross(f.vector) + f.couple) for f in forces]
    shown = t.add(*(draft.show(part) for part in parts if part))
    draft.context.vectors[name] = Space(z=balance.right)
    together = draft.show(balance.right, factor=True)
    shorter = len(list(t.walk(together))) < 0.8 * len(list(t.walk(shown)))
    items = [t.Vec(name), _along_k(shown)] + ([_along_k(together)] if shorter and len(parts) > 1 else [])
    silent = [f for f, part in zip(forces, parts, strict=True) if not part and f.unknowns]
    return draft.add(
        f"torque.{balance.kind}.{'.'.join(balance.bodies)}",
        "torque",
        t.equation(*items),
        f"torque.net.{_manner(draft, balance)}",
        premises=[f"force.{f.name}.{f.on}" for f in forces],
        point=_point(draft, balance),
        bodies=_bodies(balance),
        silent=_silent(silent),
        place=draft.show_vector(balance.where),
        variant="some" if balance.right else "zero",
        data={"forces": tuple(forces), "origin": balance.where, "value": balance.right},
    )


def _manner(draft: Draft, balance: Balance) -> str:
    """How the point is spoken of: a moving one is where a round body touches, or a joint."""
    touching = balance.kind == "moving" and balance.label in draft.study.problem.body_names
    return "contact" if touching else balance.kind


def _silent(forces) -> PhraseRef:
    """The unknown forces that have no torque about the point."""
    names = [t.Vec(name) for name in dict.fromkeys(f.name for f in forces)]
    return PhraseRef("torque.silent", {"forces": names, "count": len(names)}) if names else PhraseRef("torque.none", {})


def _bodies(balance: Balance) -> PhraseRef:
    refs = [BodyRef(name) for name in balance.bodies]
    return PhraseRef("bodies", {"bodies": refs, "count": len(refs)})


def _along_k(node: t.Node) -> t.Node:
    return t.mul(node, t.Unit("z")) if node != t.ZERO else t.ZERO


def _rate(draft: Draft, balance: Balance, net: Step) -> Step:
    """Rate of change of angular momentum = net torque."""
    momenta = _momenta(draft, balance)
    premises = [net.id, *(f"momentum.{b}.{balance.label}" for b in balance.bodies), f"momentum.total.{balance.label}"]
    statement = t.equation(_left(draft, balance), draft.show(balance.right, factor=True))
    return draft.add(
        f"balance.{'.'.join(balance.bodies)}",
        "balance",
        statement,
        f"torque.balance.{balance.kind if momenta or balance.kind != 'fixed' else 'fixed_unseen'}",
        premises=premises,
        point=_point(draft, balance),
        bodies=_bodies(balance),
        net=StepRef(net.id),
        momenta=momenta,
        variant="some" if balance.right else "zero",
        data={"row": balance.row},
    )


def _momenta(draft: Draft, balance: Balance) -> list[StepRef]:
    """The steps that gave the angular momentum whose rate of change is balanced."""
    whole = set(balance.bodies) == set(draft.study.system.bodies) and len(balance.bodies) > 1
    ids = [f"momentum.total.{balance.label}"] if whole else [f"momentum.{b}.{balance.label}" for b in balance.bodies]
    spins = [s.id for b in balance.bodies for s in draft.steps if s.id.startswith(f"momentum.{b}.")][:1]
    return [StepRef(id) for id in [id for id in ids if draft.has(id)] or spins]


def _left(draft: Draft, balance: Balance) -> t.Node:
    """The inertial side; about a moving point the two parts stand separately."""
    if balance.kind in ("moving", "crossing"):
        orbital, spin = NOTHING, NOTHING
        for name in balance.bodies:
            state = draft.study.system.bodies[name]
            orbital = orbital + state.mass * (state.center - balance.where).cross(state.acceleration)
            spin = spin + state.moment * state.alpha
        return t.add(*(draft.show_brief(short(part)) for part in (orbital, spin) if not is_zero(part)))
    return draft.show_brief(balance.left)


def _by_bodies(draft: Draft, balance: Balance) -> Step:
    """Body by body with the torque of the inner forces as an unknown, then added."""
    _name_inner_torques(draft, balance)
    steps = [_of_one(draft, balance, name) for name in balance.bodies]
    statement = t.equation(draft.show_brief(balance.left), draft.show(balance.right, factor=True))
    names = [t.Sym(n) for n in _inner_names(draft, balance)]
    return draft.add(
        f"balance.{'.'.join(balance.bodies)}",
        "combination",
        statement,
        "torque.added",
        premises=[s.id for s in steps],
        equations=[StepRef(s.id) for s in steps],
        torques=names,
        count=len(names),
        data={"terms": [(1, step) for step in steps], "row": balance.row},
    )


def _inner(draft: Draft, balance: Balance) -> list:
    return [f for f in draft.study.system.forces if f.on in balance.bodies and f.by in balance.bodies]


def _inner_names(draft: Draft, balance: Balance) -> list[str]:
    inner = [f for f in _inner(draft, balance) if f.unknowns]
    return [draft.free(f"tau_{name}") for name in dict.fromkeys(f.name for f in inner)]


def _name_inner_torques(draft: Draft, balance: Balance) -> None:
    for force in _inner(draft, balance):
        if not is_reaction(draft, force):
            draft.define(
                draft.free(f"tau_{force.name}"), short((force.point - balance.where).cross(force.vector) + force.couple)
            )


def _of_one(draft: Draft, balance: Balance, name: str) -> Step:
    state = draft.study.system.bodies[name]
    left = short(state.mass * (state.center - balance.where).cross(state.acceleration) + state.moment * state.alpha)
    known, inner = NOTHING, []
    for force in draft.study.system.on(name):
        if force.by in balance.bodies:
            letter = t.Sym(draft.free(f"tau_{force.name}"))
            inner.append(t.neg(letter) if is_reaction(draft, force) else letter)
        else:
            known = known + (force.point - balance.where).cross(force.vector) + force.couple
    right = t.add(*([draft.show(short(known))] if known else []), *inner)
    momentum = t.Vec(momentum_name(draft, name, balance.label))
    return draft.add(
        f"balance.{name}",
        "balance",
        t.equation(draft.show(left), right),
        "torque.one_of_several",
        premises=[f"momentum.{name}.{balance.label}"],
        body=BodyRef(name),
        point=_point(draft, balance),
        momentum=momentum,
        forces=[t.Vec(f.name) for f in draft.study.system.on(name) if f.by in balance.bodies],
        tags=tag(draft, draft.study.system.on(name)[0]),
    )


def _push(draft: Draft, balance: Balance) -> Step:
    """Mass times acceleration along a direction; where nothing accelerates, the forces balance."""
    axis = {"x": t.Unit("x"), "y": t.Unit("y")}.get(balance.label, draft.show_vector(balance.where))
    way = balance.label.split(" ")[0]
    manner = "rest" if is_zero(balance.left) else "push" if balance.right else "free"
    whole = len(balance.bodies) > 1
    return draft.add(
        f"push.{balance.label}.{'.'.join(balance.bodies)}",
        "balance",
        t.equation(draft.show_brief(balance.left), draft.show(balance.right, factor=not whole)),
        f"torque.{manner}.{way}",
        bodies=_bodies(balance),
        axis=axis,
        variant="whole" if whole else "one",
        data={"row": balance.row},
    )


def _solve(draft: Draft, found: Plan, steps: list[Step]) -> dict[str, Scalar]:
    """The accelerations, from one equation each where that is enough."""
    solution = solve_linear([b.row for b in found.balances], found.unknowns)
    values = {n: solution.values[n] for n in draft.study.system.accelerations}
    for name, value in values.items():
        source = next((s for s, b in zip(steps, found.balances, strict=True) if b.unknowns == {name}), None)
        shown, premises = _shown(draft, found, steps, name, value, source)
        coordinate = name.removesuffix("_ddot")
        rows, known = [b.row for b in found.balances], {n: solution.values[n] for n in found.unknowns}
        draft.add(
            f"motion.{coordinate}",
            "solution",
            solved_for(draft, name, shown, value),
            "torque.solved" if value else "torque.solved_zero",
            premises=premises,
            is_result=True,
            sources=[StepRef(p) for p in premises],
            count=len(premises),
            coordinate=t.Sym(coordinate),
            acceleration=acceleration_symbol(coordinate),
            data={"rows": rows, "values": known},
        )
    return values


def _shown(draft: Draft, found: Plan, steps: list[Step], name: str, value: Scalar, source: Step | None):
    """The isolated form from one equation, with what the others say of its further unknowns if that is zero."""
    if source is not None:
        balance = found.balances[steps.index(source)]
        return isolated(draft, balance.left, balance.right, name), [source.id]
    zeros = {n: NOTHING for n in draft.study.system.accelerations if n != name and _vanishes(draft, n)}
    for balance in found.balances:
        if balance.unknowns - set(zeros) == {name}:
            left, right = substitute(balance.left, zeros), substitute(balance.right, zeros)
            used = [
                s.id for s, b in zip(steps, found.balances, strict=True) if b is balance or b.unknowns <= set(zeros)
            ]
            return isolated(draft, left, right, name), used
    return draft.show(value), [s.id for s in steps]


def _vanishes(draft: Draft, name: str) -> bool:
    return is_zero((draft.study.dynamics.accelerations or {}).get(name, UNITY))
