"""Which unknown forces a result of the motion does not need, and because of which pair they drop out."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.algebra import Vector, is_zero, names_in
from rbpsym.derivation.step import BodyRef
from rbpsym.equality.verdict import proved
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t
from rbpsym.remarks.made import Made
from rbpsym.remarks.result import CAUSED, Result


def drops_out(result: Result) -> Iterator[Made]:
    """The forces of ideal constraints, together where they drop out for one reason."""
    study = result.study
    if result.step.rule not in CAUSED or names_in(result.value) & set(study.system.unknowns):
        return
    ideal = [name for name, is_ideal in study.dynamics.workless.items() if is_ideal and not _is_needed(name, result)]
    found: dict[tuple[str, ...], list[str]] = {}
    for name in ideal:
        found.setdefault(_reason(study.system.named(name), result), []).append(name)
    for reason in sorted(filter(None, found), key=lambda reason: ORDER.index(reason[0])):
        (key, *bodies), names = reason, found[reason]
        slots = {"forces": [t.Sym(name) for name in names], "bodies": [BodyRef(b) for b in bodies], "count": len(names)}
        yield Made(f"remark.{key}", slots, proved("its power vanishes, whatever it is"), ("silent", key, *names))


ORDER = ("pair_turning", "pair", "across", "fixed_point")  # what holds bodies together before what holds them up


def _is_needed(name: str, result: Result) -> bool:
    """Does another force go by it, as sliding friction goes by the normal force?"""
    own = {unknown for force in result.study.system.named(name) for unknown in force.unknowns}
    others = (force for force in result.study.system.forces if force.name != name)
    return any(own & names_in(part) for force in others for part in (force.vector.x, force.vector.y, force.couple))


def _reason(parts: list[Force], result: Result) -> tuple[str, ...]:
    """Why a force does no work: (what is said, its bodies); () where no short reason is found."""
    speeds = [_speed(part, result) for part in parts]
    bodies = [result.study.system.bodies[part.on] for part in parts]
    pushes = [part.vector for part in parts if part.vector]
    if len(parts) == 1 and not is_zero(parts[0].couple):
        return ()
    if len(parts) == 1:
        if _is_nothing(speeds[0]):
            return ("fixed_point",)
        return ("across",) if is_zero(parts[0].vector.dot(speeds[0])) else ()
    if len(parts) != 2 or not is_zero(parts[0].couple + parts[1].couple):
        return ()
    if not pushes:
        return ("pair_turning", *sorted({p.on for p in parts})) if is_zero(bodies[0].omega - bodies[1].omega) else ()
    is_pair = _is_nothing(parts[0].vector + parts[1].vector) and is_zero(parts[0].couple)
    return ("pair", *sorted({p.on for p in parts})) if is_pair and _is_nothing(speeds[0] - speeds[1]) else ()


def _speed(part: Force, result: Result) -> Vector:
    """The velocity of the point of the body at which it acts."""
    state = result.study.system.bodies[part.on]
    return state.velocity + (part.point - state.center).turned() * state.omega


def _is_nothing(vector: Vector) -> bool:
    return is_zero(vector.x) and is_zero(vector.y)
