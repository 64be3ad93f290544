"""Angular momentum and torque: the planner's balances, written out and solved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rbpsym.chapters.methods.balances import TURNING, Balance, Plan, outer_forces, plan, silent_forces
from rbpsym.errors import LimitError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Scalar, Space, Vector, at_most, derivative, is_zero, same, short, substitute, symbol
from rbpsym.field.calculus import names_in
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.system import Force
from rbpsym.present.signs import positive_first
from rbpsym.proof.draft import Draft, acceleration_symbol, length
from rbpsym.proof.step import FULL, BodyRef, PhraseRef, Step, StepRef, bodies_named

NAME = "torque"
MOST_PRODUCTS = 150_000  # what takes more can't be read either; of what a method may spend it leaves enough for the other way


def write(draft: Draft) -> Mapping[str, Scalar] | None:
    """The steps; returns the accelerations that they give, None if the method does not apply."""
    draft.chapter, before = "motion", len(draft.steps)
    try:
        with at_most(MOST_PRODUCTS):
            found = plan(draft.study)
            if found is not None:
                return _solve(draft, found, _balances(draft, found))
    except LimitError:
        draft.forget(before)
    draft.skip(NAME, "skipped.planner")
    _projected(draft)
    return None


def _projected(draft: Draft) -> None:
    """The equations of motion along the velocities that the constraints allow, where no balances were found."""
    dynamics, system = draft.study.dynamics, draft.study.system
    for name, row, force in zip(system.independent, dynamics.mass_matrix, dynamics.forcing, strict=True):
        left = sum((m * symbol(a) for m, a in zip(row, system.accelerations, strict=True)), NOTHING)
        draft.add(f"motion.{name}", "balance", t.equation(draft.show(left), draft.show(force)), "torque.projected",
                  coordinate=t.Sym(name), is_result=True)  # fmt: skip


def _balances(draft: Draft, found: Plan) -> list[Step]:
    """The balances one after the other; an acceleration that one says is zero is left out of the next."""
    steps: list[Step] = []
    settled: dict[str, Step] = {}
    for balance in found.balances:
        steps.append(_balance(draft, balance, settled))
        settled.update({n: steps[-1] for n in balance.unknowns if len(balance.unknowns) == 1 and _vanishes(draft, n)})
    return steps


def _balance(draft: Draft, balance: Balance, settled: Mapping[str, Step]) -> Step:
    if balance.kind == "force":
        pushed = _push(draft, balance)
        is_used = len(balance.unknowns) > 1 or draft.study.momentum_speeds
        if balance.left and not balance.right and is_used and not balance.label.startswith(TURNING):
            _kept_momentum(draft, balance, pushed)
        return pushed
    whole = _rate(draft, balance, _net_torque(draft, balance), settled)
    if balance.kind == "fixed" and len(balance.bodies) > 1 and not _is_rigid(draft, balance.bodies):
        by_bodies(draft, balance, settled)
    return whole


def _is_rigid(draft: Draft, bodies: tuple[str, ...]) -> bool:
    """Whether the bodies turn with one angular velocity about the same point (welded together)."""
    states = [draft.study.system.bodies[name] for name in bodies]
    return all(same(states[0].omega, state.omega) for state in states[1:])


def _point(draft: Draft, balance: Balance) -> t.Sym:
    """What the point is called: a fixed one as it is, the centre of mass, or a letter that no thing has."""
    letters = draft.study.letters
    return t.Sym({"fixed": balance.label, "center": "cm"}.get(balance.kind) or letters.free("C", taken=letters.things))


def _subscript(draft: Draft, balance: Balance) -> str:
    return "_".join([_point(draft, balance).name, *balance.bodies])


def _net_torque(draft: Draft, balance: Balance) -> Step:
    """The net torque on the set, force by force."""
    forces = outer_forces(draft.study.system, balance.bodies)
    name = draft.free(f"tau_{_subscript(draft, balance)}" if not draft.is_single else f"tau_{_point(draft, balance).name}")
    parts = [short(f.torque(balance.where)) for f in forces]
    shown = t.add(*positive_first([draft.show(part) for part in parts if part]))
    draft.context.vectors[name] = Space(z=balance.right)
    together = draft.show(balance.right, factor=True)
    shorter = length(together) < 0.8 * length(shown)
    items = [t.Vec(name), along_k(shown)] + ([along_k(together)] if shorter and len(parts) > 1 else [])
    left = names_in(balance.right)  # a normal force may have no torque, and yet stay in that of its friction
    silent = [f for f in forces if f.unknowns and not left & set(f.unknowns)]
    return draft.add(f"torque.{balance.kind}.{'.'.join(balance.bodies)}", "torque", t.equation(*items),
                     f"torque.net.{_manner(draft, balance)}", premises=[f"force.{f.name}.{f.on}" for f in forces],
                     point=_point(draft, balance), bodies=bodies_named(balance.bodies), silent=silent_forces(silent),
                     place=draft.show_vector(balance.where), variant="some" if balance.right else "zero",
                     data={"forces": tuple(forces), "origin": balance.where, "value": balance.right})  # fmt: skip


def _manner(draft: Draft, balance: Balance) -> str:
    """How the point is spoken of: a moving one is where a round body touches, or a joint."""
    touching = balance.kind == "moving" and balance.label in draft.study.problem.body_names
    return "contact" if touching else balance.kind


def _rate(draft: Draft, balance: Balance, net: Step, settled: Mapping[str, Step]) -> Step:
    """Rate of change of angular momentum = net torque."""
    momenta, used = _momenta(draft, balance), {n: step for n, step in settled.items() if derivative(balance.left, n)}
    statement = t.equation(_left(draft, balance, used), draft.show(balance.right, factor=True))
    return draft.add(
        f"balance.{'.'.join(balance.bodies)}",
        "balance",
        statement,
        f"torque.balance.{balance.kind if momenta or balance.kind != 'fixed' else 'fixed_unseen'}",
        premises=[net.id, *(ref.id for ref in momenta if ref.id.endswith(f".{balance.label}")), *(s.id for s in used.values())],
        settled=_settled(used),
        point=_point(draft, balance),
        bodies=bodies_named(balance.bodies),
        net=StepRef(net.id),
        momenta=momenta,
        variant="some" if balance.right else "zero",
        data={"origin": balance.where},
    )


def _momenta(draft: Draft, balance: Balance) -> list[StepRef]:
    """The steps that gave the angular momentum whose rate of change is balanced."""
    whole = set(balance.bodies) == set(draft.study.system.bodies) and len(balance.bodies) > 1
    ids = [f"momentum.total.{balance.label}"] if whole else [f"momentum.{b}.{balance.label}" for b in balance.bodies]
    spins = [s.id for b in balance.bodies for s in draft.steps if s.id.startswith(f"momentum.{b}.")][:1]
    return [StepRef(id) for id in [id for id in ids if draft.has(id)] or spins]


def _left(draft: Draft, balance: Balance, settled: Mapping[str, Step]) -> t.Node:
    """The inertial side, without what is `settled`; about a moving point the two parts stand separately."""
    if balance.kind in ("moving", "crossing"):
        orbital, spin = NOTHING, NOTHING
        for name in balance.bodies:
            state = draft.study.system.bodies[name]
            orbital = orbital + state.mass * (state.center - balance.where).cross(state.acceleration)
            spin = spin + state.moment * state.alpha
        return t.add(*(draft.show_brief(short(_without(part, settled))) for part in (orbital, spin) if not is_zero(part)))
    return draft.show_brief(_without(balance.left, settled))


def _push(draft: Draft, balance: Balance) -> Step:
    """Mass times acceleration along a direction; where nothing accelerates, the forces balance."""
    axis = {"x": t.Unit("x"), "y": t.Unit("y")}.get(balance.label, draft.show_vector(balance.where))
    way = balance.label.split(" ")[0]
    manner = "rest" if is_zero(balance.left) else "push" if balance.right else "free"
    whole = len(balance.bodies) > 1
    return draft.add(f"push.{balance.label}.{'.'.join(balance.bodies)}", "balance",
                     t.equation(draft.show_brief(balance.left), draft.show(balance.right, factor=not whole)),
                     f"torque.{manner}.{way}", bodies=bodies_named(balance.bodies), axis=axis,
                     variant="whole" if whole else "one", data={"along": balance.where, "bodies": balance.bodies})  # fmt: skip


def _kept_momentum(draft: Draft, balance: Balance, pushed: Step) -> None:
    """The momentum along a direction in which no outer force acts, by its name."""
    states = (draft.study.system.bodies[name] for name in balance.bodies)
    value = short(sum((state.mass * state.velocity.dot(balance.where) for state in states), NOTHING))
    letter = draft.define(draft.free(f"P_{balance.label.split(' ')[0]}", "tot"), value)
    draft.add(f"kept.{balance.label}.{'.'.join(balance.bodies)}", "conservation", t.equation(letter, draft.show(value)),
              "torque.kept", premises=[pushed.id], letter=letter, data={"value": value})  # fmt: skip


def _solve(draft: Draft, found: Plan, steps: list[Step]) -> dict[str, Scalar]:
    """The accelerations, from one equation each where that is enough; first those that vanish, which the others rest on."""
    solution = solve_linear([b.row for b in found.balances], found.unknowns)
    values = {n: solution.values[n] for n in draft.study.system.accelerations}
    zeros: dict[str, Step] = {}
    for name in sorted(values, key=lambda name: bool(values[name])):
        value, coordinate = values[name], name.removesuffix("_ddot")
        premises = _sources(found, steps, name, zeros)
        step = draft.add(
            f"motion.{coordinate}",
            "solution",
            t.equation(t.Sym(name), *_as_second_rate(draft, coordinate), draft.show(value, factor=True)),
            "torque.solved" if value else "torque.solved_zero",
            premises=premises,
            is_result=bool(value) or not any(values.values()),
            sources=[StepRef(p) for p in premises],
            count=len(premises),
            coordinate=t.Sym(coordinate),
            acceleration=acceleration_symbol(coordinate),
        )
        if not value:  # what says it alone is cited, rather than its solution
            pairs = zip(steps, found.balances, strict=True)
            zeros[name] = next((own for own, balance in pairs if balance.unknowns == {name}), step)
    return values


def _as_second_rate(draft: Draft, coordinate: str) -> tuple[t.Node, ...]:
    """d²θ/dt² where the acceleration has a letter of its own, so that one sees the differential equation."""
    has_letter = f"{coordinate}_ddot" in draft.study.problem.notation
    return (t.Deriv(t.Sym(coordinate), "t", 2),) if has_letter else ()


def _sources(found: Plan, steps: list[Step], name: str, zeros: Mapping[str, Step]) -> list[str]:
    """Those equations that say it, none of which can be left out, and what says of accelerations in them that they vanish."""
    kept = dict(enumerate(found.balances))
    for k in reversed(range(len(steps))):
        fewer = [_without(balance.row, zeros) for other, balance in kept.items() if other != k]
        if _gives(fewer, found.unknowns, name):
            del kept[k]
    told = {k: {*steps[k].premises, *steps[k].cites} for k in kept}  # with what is left out of a balance
    said = [step.id for zero, step in zeros.items()
            if any(zero in balance.unknowns and step.id not in told[k] for k, balance in kept.items())]  # fmt: skip
    own = [step.id for k, step in enumerate(steps) if k in kept or step.id in said]
    return own + [id for id in said if id not in own]


def _gives(rows: list[Scalar], unknowns: Sequence[str], name: str) -> bool:
    """Whether the equations determine the unknown."""
    value = solve_linear(rows, unknowns, keep_free=True).values.get(name)
    return value is not None and not names_in(value) & set(unknowns)


def _vanishes(draft: Draft, name: str) -> bool:
    return is_zero((draft.study.dynamics.accelerations or {}).get(name, UNITY))


# --- balance about a fixed point for several bodies: one by one with the torques of the inner forces, then added


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
    return draft.add(f"balance.{'.'.join(balance.bodies)}", "combination", statement, "torque.added", level=FULL,
                     premises=[s.id for s in steps], equations=[StepRef(s.id) for s in steps], torques=names, count=len(names),
                     data={"terms": [(1, step) for step in steps]})  # fmt: skip


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
    return draft.add(f"balance.{name}", "balance", t.equation(draft.show(left), right),
                     f"torque.one.{'seen' if momenta else 'unseen'}", level=FULL,
                     premises=[net.id, *(ref.id for ref in momenta), *(step.id for step in used.values())], momenta=momenta,
                     settled=_settled(used))  # fmt: skip


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
    return draft.add(f"torque.one.{name}", "torque", t.equation(letter, t.add(*parts)), "torque.alone", level=FULL,
                     premises=[f"force.{f.name}.{f.on}" for f in forces], body=BodyRef(name), point=t.Sym(balance.label),
                     data={"forces": tuple(forces), "origin": balance.where, "value": total})  # fmt: skip


def _momenta_of(draft: Draft, balance: Balance, name: str) -> list[StepRef]:
    id = f"momentum.{name}.{balance.label}"
    return [StepRef(id)] if draft.has(id) else []
