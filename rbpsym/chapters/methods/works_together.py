"""All forces on one body at once: the works of the ideal ones together, w_c, are in W_T and with the opposite sign in W_θ.

Both halves of the work–energy theorem are then told with that one unknown, which goes away when they are added.
"""

from __future__ import annotations

from typing import Any

from rbpsym.chapters.forces import force_node
from rbpsym.chapters.methods.known_works import gained, is_of_position, show_gained, since_start, start_of, started
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ONE, Coefficient, Monomial, Poly, Scalar, Vector, short
from rbpsym.frozen import Frozen
from rbpsym.mechanics import energy
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.motion import ForceWork, Work
from rbpsym.mechanics.system import BodyState, Force
from rbpsym.present.style import PLAIN, split
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import BodyRef, StepRef

FEWEST = 2  # ideal forces: for a single one the two works are told already
LONGEST = 70  # nodes of the integral by components, which is left out where it is longer


class Together(Frozen):
    """The body, its one coordinate, the ideal forces that do work on it, and the works of all others."""

    name: str
    state: BodyState
    coordinate: str
    ideal: tuple[ForceWork, ...]
    known: tuple[ForceWork, ...]


def found(draft: Draft) -> Together | None:
    """What is to be told together; None where it is not one body, or another work is not known as a function of position."""
    study = draft.study
    if not draft.is_single or len(study.system.independent) != 1 or study.system.has_clock or not started(draft):
        return None
    ideal = tuple(i for i in study.works if study.dynamics.workless.get(i.force) and _halves(i))
    known = tuple(i for i in study.works if i not in ideal)
    if len(ideal) < FEWEST or study.dynamics.accelerations is None or not all(_is_known(draft, i) for i in known):
        return None
    [(name, state)] = study.system.bodies.items()
    return Together(name, state, study.system.independent[0], ideal, known)


def _halves(item: ForceWork) -> bool:
    return bool(item.translational.parts and item.rotational.parts)


def _is_known(draft: Draft, item: ForceWork) -> bool:
    halves = (item.translational, item.rotational)
    return all(half.value is not None and is_of_position(draft, half) for half in halves)


def write(draft: Draft, these: Together) -> None:
    """The steps: W_T, the work of the ideal forces in it, W_θ, what it changes, and their sum."""
    work = t.Sym(draft.free("cal_w_c"))
    draft.context.works[work.name] = _push(draft, these).dot(these.state.velocity)
    steps = [_translation(draft, these, work), _rotation(draft, these, work)]
    _sum(draft, these, work, steps)


def _forces(draft: Draft, items: tuple[ForceWork, ...]) -> list[Force]:
    names = [(item.force, item.on) for item in items]
    return sorted((f for f in draft.study.system.forces if (f.name, f.on) in names), key=lambda f: names.index((f.name, f.on)))


def _push(draft: Draft, these: Together) -> Vector:
    return sum((force.vector for force in _forces(draft, these.ideal)), Vector({}))


# --- the translational half


def _translation(draft: Draft, these: Together, work: t.Sym) -> list[str]:
    """W_T from the net force to ½ M V², and solved for the work of the ideal forces."""
    letter = t.Sym(draft.free("cal_W_T"))
    forces = _forces(draft, (*these.ideal, *these.known))
    whole = sum((force.vector for force in forces), Vector({}))
    draft.context.works[letter.name] = whole.dot(these.state.velocity)
    nodes = [force_node(draft, force) for force in forces if force.vector]
    path = t.PathIntegral(t.Group(t.add(*nodes)), t.Vec(draft.of_body("R", these.name)))
    kinetic = _kinetic(draft, these, "translational")
    changes = _changes(draft, these, "translational")
    parts = _integral(draft, these, [item.translational.parts.get(these.coordinate, NOTHING) for item in these.ideal])
    spelled = _by_components(draft, these, forces)
    between = [spelled] if length(spelled) <= LONGEST else []
    items = [letter, path, *between, t.add(parts, *changes), t.add(work, *changes), kinetic]
    slots = _slots(draft, these, work)
    first = draft.add("together.T", "work_together", t.equation(*items), "work.together.translational", **slots)
    back = [t.neg(change) for change in changes]
    second = draft.add(
        "together.solved",
        "work_together",
        t.equation(work, t.add(kinetic, *back)),
        "work.together.solved",
        **{**slots, "premises": [first.id]},
        source=StepRef(first.id),
    )
    return [first.id, second.id]


def _slots(draft: Draft, these: Together, work: t.Sym) -> dict[str, Any]:
    return {
        "premises": [f"work.{i.force}.{i.on}" for i in draft.study.works]
        + [f"workless.{i.force}" for i in these.ideal],
        "work": work,
        "body": BodyRef(these.name),
        "ideal": [force_node(draft, force) for force in _forces(draft, these.ideal)],
    }


def _by_components(draft: Draft, these: Together, forces: list[Force]) -> t.Node:
    """∫ (F_x i + F_y j) · (dx/dq i + dy/dq j) dq, what both components of the path share in front."""
    path = these.state.velocity.derivative(f"{these.coordinate}_dot")
    common = _shared([path.x, path.y])
    ideal = _forces(draft, these.ideal)
    rows = []
    for axis in ("x", "y"):
        unknown = [getattr(f.vector, axis) for f in ideal]
        others = [getattr(f.vector, axis) for f in forces if f not in ideal]
        rows.append(t.add(*(draft.show(short(sum(part, NOTHING))) for part in (unknown, others) if any(part))))
    push = t.add(*(t.mul(row, t.Unit(axis)) for row, axis in zip(rows, "xy", strict=True)))
    way = draft.show_vector(path * common.inverse())
    return _over(draft, these, t.Dot(t.mul(draft.show(common), t.Group(push)), t.Group(way)))


def _integral(draft: Draft, these: Together, parts: list[Scalar]) -> t.Node:
    """∫ of the integrands one by one, in their order, what they share in front."""
    common = _shared(parts)
    terms = [draft.show(short(part / common)) for part in parts if part]
    negative = all(isinstance(term, t.Neg) for term in terms)
    inside = t.mul(draft.show(common), t.add(*(t.neg(term) if negative else term for term in terms)))
    found = _over(draft, these, inside)
    return t.neg(found) if negative else found


def _over(draft: Draft, these: Together, integrand: t.Node) -> t.Node:
    name = these.coordinate
    return t.Integral(integrand, name, start_of(draft, name), t.Sym(name))


def _shared(values: list[Scalar]) -> Scalar:
    """The parameters that all terms share, and their number if it is the same for all of them."""
    polys = [value.num for value in values if value]
    if not polys or any(value.den is not ONE for value in values):
        return Scalar(ONE)
    numbers: set[Coefficient] = {c if c > 0 else -c for poly in polys for c in poly.terms.values()}
    return Scalar(Poly({_lowest([m for p in polys for m in p.terms]): numbers.pop() if len(numbers) == 1 else 1}))


def _lowest(monomials: list[Monomial]) -> Monomial:
    """The power of each parameter that can be taken out of all of them, above or below the bar."""
    fixed = [dict(split(m, PLAIN)[0]) for m in monomials]
    powers = {i: [f.get(i, 0) for f in fixed] for i in fixed[0]}
    above = {i: min(e) for i, e in powers.items() if min(e) > 0}
    below = {i: max(e) for i, e in powers.items() if max(e) < 0}
    return tuple(sorted({**above, **below}.items()))


# --- the rotational half


def _rotation(draft: Draft, these: Together, work: t.Sym) -> list[str]:
    """W_θ, in which the work of the ideal forces has the opposite sign, and what it changes."""
    letter = t.Sym(draft.free("cal_W_theta"))
    turn = sum((torque_about_center(f, these.state) for f in draft.study.system.forces), NOTHING)
    draft.context.works[letter.name] = turn * these.state.omega
    changes = _changes(draft, these, "rotational")
    parts = _integral(draft, these, [item.rotational.parts.get(these.coordinate, NOTHING) for item in these.ideal])
    slots = _slots(draft, these, work)
    other = t.add(t.neg(work), *changes)
    statement = t.equation(letter, t.add(parts, *changes), other)
    first = draft.add("together.theta", "work_integral", statement, "work.together.rotational", **slots)
    second = draft.add(
        "together.turned",
        "work_together",
        t.equation(other, _kinetic(draft, these, "rotational")),
        "work.together.turned",
        **{**slots, "premises": [first.id]},
    )
    return [first.id, second.id]


# --- both


def _changes(draft: Draft, these: Together, half: str) -> list[t.Node]:
    """The works of the other forces, carried out."""
    works: list[Work] = [getattr(item, half) for item in these.known]
    return [since_start(draft, work.value) for work in works if work.value]


def _kinetic(draft: Draft, these: Together, half: str) -> t.Node:
    """½ M V² as it is named, ½ I ω² worked out; as a change where the body moves at the start."""
    of = {"translational": energy.translational_energy, "rotational": energy.rotational_energy}[half]
    value = gained(draft, of(these.state))
    if half == "rotational":
        return show_gained(draft, value)
    velocity, mass = t.Vec(draft.of_body("V", these.name)), draft.show(these.state.mass)
    named = t.half_square(mass, velocity)
    return named if value == short(of(these.state)) else t.Delta(t.Group(named))


def _sum(draft: Draft, these: Together, work: t.Sym, steps: list[list[str]]) -> None:
    """Rotational and translational energy and the potential energies are constant together."""
    study = draft.study
    if study.potential is None or study.first_integral is None:
        return
    named = _kinetic(draft, these, "translational")
    if isinstance(named, t.Delta) and isinstance(named.arg, t.Group):
        named = named.arg.arg
    potentials = [draft.show(value, factor=True) for value in energy.potentials(study.system).values() if value]
    letter = draft.define(draft.free("E", "tot"), study.first_integral)
    turning = draft.show_brief(energy.rotational_energy(these.state))
    draft.add(
        "together.energy",
        "conservation",
        t.equation(t.add(turning, named, *potentials), letter),
        "work.together.energy",
        premises=[step for half in steps for step in half],
        equations=[StepRef(half[-1]) for half in steps],
        work=work,
        letter=letter,
        data={"value": study.first_integral},
    )
