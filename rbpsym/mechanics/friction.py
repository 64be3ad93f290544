"""Friction: which way things slip at the start, and how much static friction is needed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.elements.interactions import LETTERS
from rbpsym.field import NOTHING, Scalar, is_zero, short, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.contacts import meeting, slip_sense, slip_speed
from rbpsym.mechanics.geometry import Geometry, start_numbers, unsaid
from rbpsym.mechanics.interactions import Resisted, resisted_by
from rbpsym.mechanics.placing import where_in
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element


def geometry_of(system: System) -> Geometry:
    """The geometry of an assembled system, its states of motion included."""
    placed = {name: state.pose for name, state in system.bodies.items()}
    return Geometry(where_in(system), placed, start_numbers(system.problem), system.bodies, unsaid(system.problem))


def slip_senses(system: System) -> dict[str, int]:
    """By constraint with kinetic friction: 1 if what touches slips forward at the start, else -1."""
    geometry = geometry_of(system)
    rough = [e for e in system.problem.constraints if e.values.get("coefficient") is not None]
    return {element.name: slip_sense(element, geometry, meeting(element, geometry)) for element in rough}


def resistances(system: System) -> dict[str, Resisted]:
    """By interaction that is against a motion: what it resists."""
    setting = setting_of(system, geometry_of(system).where)
    return {e.name: resisted_by(e, setting) for e in system.problem.of_kind(*LETTERS)}


def stops(system: System) -> bool:
    """Whether dry friction acts, or another resistance that is there at rest too: its sense is that of the motion."""
    rough = any(element.values.get("coefficient") is not None for element in system.problem.constraints)
    still = dict.fromkeys(system.speeds, NOTHING)
    with suppress(ZeroDivisionError):
        return rough or any(found.sense and substitute(found.push, still) for found in resistances(system).values())
    return True


def senses(system: System) -> dict[str, int | Scalar]:
    """The senses of slips, and by interaction that is against a motion of one sense: that sense for a couple, for a point
    the speed in that sense."""
    against = {name: found for name, found in resistances(system).items() if found.sense}
    return slip_senses(system) | {n: found.slip if found.way else found.sense for n, found in against.items()}


def slips(system: System) -> dict[str, Scalar]:
    """By constraint with kinetic friction, and interaction that is against a motion of one sense: the speed of the slip,
    positive in the sense that it has at the start."""
    geometry = geometry_of(system)
    speeds = {n: slip_speed(geometry, meeting(system.element(n), geometry)) * way for n, way in slip_senses(system).items()}
    speeds |= {name: found.slip for name, found in resistances(system).items() if found.sense}
    return {name: substitute(speed, system.dependent) for name, speed in speeds.items()}


def slips_on(system: System, name: str) -> bool:
    """Whether something slips still, or may, where this coordinate comes to rest: what else slips moves by itself."""
    return any(not is_zero(substitute(slip, {f"{name}_dot": NOTHING})) for slip in slips(system).values())


def spare(element: Element, value: Callable[[str], Scalar]) -> tuple[Scalar, ...]:
    """μ N - f and μ N + f of a contact whose static friction has a limit, from the values of forces by their names."""
    if element.values.get("limit") is None:
        return ()
    most = scalar(element["limit"]) * sum(map(value, element.normals), NOTHING)
    return most - value(element["friction"]), most + value(element["friction"])


class FrictionNeed(Frozen):
    """Static friction keeps a contact from slipping as long as |ratio| = |f|/N ≤ the coefficient.

    `ratio` is f/N as a function of the state (of the position alone, where the speed is known), N being the sum of
    `normals`; `needed` is |f|/N if its sign is decided, where N > 0. `limit` is the declared coefficient, `holds` whether it
    is enough (None: it depends, or no coefficient is declared).
    """

    constraint: str
    normals: tuple[str, ...]
    friction: str
    ratio: Scalar
    needed: Scalar | None
    limit: Scalar | None
    holds: bool | None


def friction_needs(system: System, reactions: Mapping[str, Scalar], assumptions: Assumptions) -> tuple[FrictionNeed, ...]:
    """For every contact that static friction holds, from the unknown forces as functions of the state."""
    held = [e for e in system.problem.constraints if "limit" in e.values and e["friction"] in reactions]
    return tuple(_need(e, reactions, assumptions) for e in held if reactions[e.name])


SIZES = {"positive": 1, "nonnegative": 1, "zero": 1, "negative": -1, "nonpositive": -1}
ENOUGH = {"positive": True, "nonnegative": True, "zero": True, "negative": False}


def _need(element: Element, reactions: Mapping[str, Scalar], assumptions: Assumptions) -> FrictionNeed:
    ratio = short(reactions[element["friction"]] / sum((reactions[name] for name in element.normals), NOTHING))
    sides = (sign(value, assumptions).kind for value in (ratio, reactions[element["friction"]]))  # where the contact pushes
    way = next((SIZES[side] for side in sides if side in SIZES), None)
    needed = None if way is None else ratio * way
    limit = None if element["limit"] is None else scalar(element["limit"])
    holds = None if needed is None or limit is None else ENOUGH.get(sign(limit - needed, assumptions).kind or "")
    return FrictionNeed(element.name, element.normals, element["friction"], ratio, needed, limit, holds)
