"""Conservation of energy: the first integral, the squares of the speeds, and the equation of motion again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.chapters import momentum
from rbpsym.chapters.forces import force_node, name_node
from rbpsym.chapters.methods.net_work import is_kinetic, net_power, work_symbols
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, short, substitute, symbol, tidy
from rbpsym.mechanics import energy
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL, STANDARD, StepRef

NAME = "energy"


def write(draft: Draft) -> Mapping[str, Scalar] | None:
    """The steps; returns the acceleration that energy gives, None if the method does not apply."""
    if not draft.study.system.independent and not draft.study.system.has_clock:
        draft.skip(NAME, "skipped.no_freedom")
        return None
    draft.chapter = "energy"
    _kinetic(draft)
    kept = draft.study.first_integral
    if kept is None:
        _not_conserved(draft)
        return None
    _potentials(draft)
    _splits(draft)
    _conserved(draft, kept)
    _speeds(draft)
    return _acceleration(draft, kept)


def _not_conserved(draft: Draft) -> None:
    """Why, and how fast the energy changes."""
    forces = [*_without_potential(draft), *_rough(draft)]
    nodes = [force_node(draft, draft.study.system.named(name)[0]) for name in forces]
    if forces:
        draft.skip(NAME, "skipped.not_conserved", forces=nodes, count=len(forces))
    else:
        draft.skip(NAME, "skipped.driven" if draft.study.system.has_clock else "skipped.no_integral")
    _potentials(draft)
    _changes(draft, forces, nodes)


def _without_potential(draft: Draft) -> list[str]:
    """The interactions without a potential energy."""
    return [name for name, value in energy.potentials(draft.study.system).items() if value is None]


def _rough(draft: Draft) -> list[str]:
    """The forces of kinetic friction."""
    names = dict.fromkeys(force.name for force in draft.study.system.forces)
    return [name for name in names if is_kinetic(draft.study.system.element(name), name)]


def _changes(draft: Draft, forces: list[str], nodes: list[t.Node]) -> None:
    """dE/dt is the power of the forces that are neither ideal nor conservative."""
    driving = [n for n, fine in draft.study.dynamics.workless.items() if not fine and n not in forces]
    powers = [value for name in (*forces, *driving) if (value := net_power(draft, name))]
    if not powers or draft.study.dynamics.accelerations is None:
        return
    known = {n: v for n, v in energy.potentials(draft.study.system).items() if v and _varies(draft, v)}
    total = sum(draft.study.kinetic, NOTHING) + sum(known.values(), NOTHING)
    letters = [t.Sym(draft.free("K", "tot")), *(t.Sym(draft.free(f"U_{name}")) for name in known)]
    letter, source = letters[0], "kinetic"
    if known:
        letter, source = draft.define(draft.free("E", "tot"), total), "energy.letter"
        draft.add(source, "identity", t.equation(letter, t.add(*letters)), "energy.total", count=len(letters),
                  premises=["kinetic", *(f"potential.{name}" for name in known)])  # fmt: skip
    more = [t.Sym(name) if name in draft.study.system.unknowns else t.Vec(name) for name in driving]
    draft.add("energy.change", "balance",
              t.equation(t.Deriv(letter), t.add(*(draft.show(short(value), factor=True) for value in powers))), "energy.changes",
              forces=[*nodes, *more], count=len(powers),
              premises=[source, *draft.those(*(f"dissipation.{name}" for name in forces))], is_result=True)  # fmt: skip


def _varies(draft: Draft, value: Scalar) -> bool:
    """Does a potential energy change as the system moves?"""
    return any(depends_on(value, name) for name in (*draft.study.system.coordinates, "t"))


def _kinetic(draft: Draft) -> None:
    """T as the sum of translational and rotational parts of all bodies."""
    bodies = draft.study.system.bodies
    terms, shown = [], []
    for name, state in bodies.items():
        velocity, omega = t.Vec(draft.of_body("V", name)), t.Sym(draft.of_body("omega", name))
        if state.velocity:
            terms.append(t.half_square(draft.show(state.mass), velocity))
            shown.append(draft.show_brief(energy.translational_energy(state)))
        if state.omega and state.moment:
            terms.append(t.half_square(t.Sym(draft.of_body("I", name)), omega))
            shown.append(draft.show_brief(energy.rotational_energy(state)))
    total = sum(draft.study.kinetic, NOTHING)
    letter = draft.define(draft.free("K", "tot"), total)
    together = draft.show_brief(total)
    items = [letter, t.add(*terms), t.add(*shown)] + ([together] if together != t.add(*shown) else [])
    draft.add("kinetic", "kinetic_energy", t.equation(*items), "energy.kinetic", count=len(terms),
              premises=draft.those(*(f"{kind}.{n}" for kind in ("speed", "moment") for n in bodies)),
              data={"bodies": tuple(bodies), "value": total})  # fmt: skip


def _potentials(draft: Draft) -> None:
    """The potential energy of each conservative interaction."""
    for name, value in energy.potentials(draft.study.system).items():
        if not value:
            continue
        letter = draft.define(draft.free(f"U_{name}"), value)
        element = draft.study.system.element(name)
        forces = draft.study.system.named(name)
        draft.add(
            f"potential.{name}",
            "potential",
            t.equation(letter, draft.show(value, factor=True)),
            f"energy.potential.{element.kind}",
            premises=[f"force.{f.name}.{f.on}" for f in forces],
            data={"forces": forces, "value": value},
            force=t.Vec(name),
            level=STANDARD if _varies(draft, value) else FULL,
        )


def _splits(draft: Draft) -> None:
    """How a conservative force shares its potential energy out: W_T + W_θ = -ΔU, half each if they are equal."""
    for name, value in energy.potentials(draft.study.system).items():
        items = [i for i in draft.study.works if i.force == name and i.translational.parts and i.rotational.parts]
        if value is None or not items or name not in {i.force for i in draft.study.works}:
            continue
        works = list(work_symbols(draft, [i for i in draft.study.works if i.force == name]))
        gain = t.Delta(t.Sym(draft.free(f"U_{name}")))
        equal = len(works) == 2 and items[0].translational.parts == items[0].rotational.parts
        if equal:
            statement = t.equation(*works, t.neg(t.mul(t.Div(t.ONE, t.TWO), gain)))
        else:
            statement = t.equation(t.add(*works), t.neg(gain))
        draft.add(f"split.{name}", "work", statement, "energy.halves" if equal else "energy.split", force=t.Vec(name),
                  premises=[f"potential.{name}", *(f"work.{i.force}.{i.on}" for i in items)], is_result=equal)  # fmt: skip


def _conserved(draft: Draft, value: Scalar) -> None:
    """E = T + U is constant."""
    letters = [t.Sym(draft.free("K", "tot"))]
    letters += [t.Sym(draft.free(f"U_{n}")) for n, v in energy.potentials(draft.study.system).items() if v]
    shown = _as_sum(draft)
    letter = draft.define(_letter(draft), value)
    items = [letter, t.add(*letters), shown] if _is_whole(draft) else [letter, draft.show(value)]
    whole = "energy.conserved" if draft.study.potential is not None else "energy.effective"
    phrase = "energy.relative" if draft.study.system.has_clock else whole
    ideal = list(dict.fromkeys(force.name for force in draft.study.system.forces if force.unknowns))
    none = "none" if draft.study.system.forces else "free"
    draft.add(
        "energy",
        "conservation",
        t.equation(*items),
        phrase,
        is_result=True,
        premises=["kinetic", *(s.id for s in draft.steps if s.id.startswith(("potential.", "workless."))), *_works_beside(draft)],
        data={"value": value},
        ideal=[name_node(draft, name) for name in ideal],
        variant={0: none, 1: "one"}.get(len(ideal), "many"),
    )


def _is_whole(draft: Draft) -> bool:
    """Is what is kept the energy K + U of all bodies?"""
    return draft.study.potential is not None and not draft.study.system.has_clock


def _letter(draft: Draft) -> str:
    """What is kept by a letter of its own: E is K + U alone."""
    return draft.free("E", "tot") if _is_whole(draft) else draft.free("E_rel" if draft.study.system.has_clock else "E_eff")


def _works_beside(draft: Draft) -> Iterator[str]:
    """The works that stand in the energy as their forces have no potential one and do not drop out: of a friction couple."""
    told = {name for name, value in energy.potentials(draft.study.system).items() if value is not None}
    told |= {name for name, is_ideal in draft.study.dynamics.workless.items() if is_ideal}
    return (f"work.{i.force}.{i.on}" for i in draft.study.works if i.force not in told)


def _as_sum(draft: Draft) -> t.Node:
    """T + U with each part in its own form."""
    total = [draft.show_brief(sum(draft.study.kinetic, NOTHING))]
    known = [v for v in energy.potentials(draft.study.system).values() if v]
    return t.add(*total, *(draft.show(v, factor=True) for v in known))


def _speeds(draft: Draft) -> None:
    """Momenta that are kept, the speeds that they give, and with these the squares of the others as functions of position."""
    speeds = draft.study.momentum_speeds
    momentum.kept_speeds(draft, speeds)
    known = draft.those(*(f"speed_at.{speed.removesuffix('_dot')}" for speed in speeds))
    is_energy = len(draft.study.system.independent) == 1 or bool(speeds)
    for name, value in draft.study.squares.items():
        draft.context.scalars.pop(f"{name}_dot", None)
        statement = t.equation(t.Pow(t.Sym(f"{name}_dot"), t.TWO), _from_start(draft, name, value))
        draft.add(f"square.{name}", "first_integral", statement, "energy.square" if is_energy else "energy.square_alone",
                  premises=["energy", *known] if is_energy else draft.those(f"motion.{name}"),
                  is_result=any(depends_on(value, other) for other in draft.study.system.coordinates),
                  data={"name": name, "value": value}, source=StepRef("energy"), coordinate=t.Sym(name))  # fmt: skip


def _from_start(draft: Draft, name: str, value: Scalar) -> t.Node:
    """The part that the start speed brings, and what is gained since."""
    start = draft.context.scope.start.get(f"{name}_dot", NOTHING)
    if not start:
        return draft.show(value, factor=True)
    gained = tidy(short(value - start * start))
    begun = tidy(start * start)
    return t.add(draft.show(begun, factor=True), *([draft.show(gained, factor=True)] if gained else []))


def _acceleration(draft: Draft, kept: Scalar) -> Mapping[str, Scalar] | None:
    """dE/dt = 0 divided by the speed, where one coordinate is left to be found."""
    system = draft.study.system
    accelerations = draft.study.dynamics.accelerations or {}
    open_ = [n for n in system.independent if not is_zero(accelerations.get(f"{n}_ddot", symbol("open")))]
    if len(open_) != 1:
        if open_:
            draft.skip(NAME, "skipped.one_equation", method=NAME, count=len(system.independent))
        return None
    [name] = open_
    resting = {f"{n}_ddot": NOTHING for n in system.independent if n != name}
    rate = substitute(draft.context.rate_of(kept), resting)
    inner = short(rate / symbol(f"{name}_dot"))
    if inner.num.atoms() and any(derivative(inner, f"{n}_dot") for n in system.independent if n != name):
        return None
    speed = t.Sym(f"{name}_dot")
    slope, rest = derivative(inner, f"{name}_ddot"), substitute(inner, {f"{name}_ddot": NOTHING})
    inside = t.add(draft.show_brief(slope * symbol(f"{name}_ddot")), *([draft.show(rest, factor=True)] if rest else []))
    statement = t.equation(t.Deriv(t.Sym(_letter(draft))), t.mul(speed, t.Group(inside, "[")), t.ZERO)
    draft.add("energy.rate", "balance", statement, "energy.rate", premises=["energy"], source=StepRef("energy"), speed=speed)
    value = short(-(rest / slope))
    found = t.equation(t.Sym(f"{name}_ddot"), draft.show(value, factor=True))
    draft.add("motion.from_energy", "solution", found, "energy.motion",
              premises=["energy.rate"], source=StepRef("energy.rate"), known=StepRef(f"motion.{name}"), speed=speed)  # fmt: skip
    return {f"{name}_ddot": value} | {n: accelerations[n] for n in resting}
