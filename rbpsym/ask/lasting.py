"""How far the motion that is stated lasts: no contact is lost on the way to a place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.algebra.calculus import names_in, substitute
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.errors import RbpsymError, StatementError, Undecided
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.endings import State
from rbpsym.mechanics.sides import grips
from rbpsym.mechanics.study import Study
from rbpsym.quantity.path import sense
from rbpsym.quantity.problem import ProblemWorld

if TYPE_CHECKING:
    from rbpsym.ask.moments import Moment


def contacts_last(study: Study, places: Mapping[str, Scalar]) -> Iterator[tuple[str, Demand]]:
    """(force, what it asks) for each contact that is lost on the way: a place lies not beyond that; where the contact is
    lost under conditions only, its force still pushes there."""
    motion = ProblemWorld(study).motion
    for loss in study.losses:
        if loss.valid or not loss.at:
            yield loss.force, Demand(short(substitute(study.reactions_along_motion[loss.force], places)), ">=")
        elif loss.coordinate in places:
            name, there = loss.coordinate, loss.at[loss.coordinate]
            way = sense(motion, name) or there - study.system.scope.start[name]
            yield loss.force, Demand((there - places[name]) * way, ">=")


def clear(study: Study, state: State) -> State:
    """The state, if no contact is lost on the way to it; what that asks of the parameters is a condition."""
    asked = list(contacts_last(study, state.places))
    for force, demand in asked:
        if settle([demand], study.assumptions) is None:
            raise StatementError(f"“{force}” vanishes before, and with it the motion that is stated ends")
    demands = [demand for _, demand in asked]
    # what the place itself asks for stays beside it: a check of a strict sign takes strict conditions only
    return replace(state, valid=(*state.valid, *(settle(demands, study.assumptions) or demands)))


def held(study: Study) -> list[Demand]:
    """What contacts and friction ask for on the motion where they are not sure to hold, as functions of the state."""
    along = study.reactions_along_motion or {}
    kept = [demand for side in study.sides if side.state in ("asked", "open") for demand in side.valid]
    for need in study.friction_needs:
        if need.constraint in along and need.needed is None and need.limit is not None:
            most, friction = sum((along[n] for n in need.normals), NOTHING) * need.limit, along[need.friction]
            kept += [Demand(short(most + friction * side), ">=") for side in (-1, 1)]
        else:
            kept += grips((need,))
    return kept


def lasts_to(study: Study, moment: Moment) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """What the same ask of the parameters at a moment and on the whole way to it, and what of that is not decided. Raises
    StatementError where they surely do not last so far."""
    from rbpsym.ask.moments import value_in

    if moment.how in ("start", "rest"):
        return tuple(Demand(value_in(study, demand.value, moment.state), demand.op) for demand in held(study)), ()
    is_place = moment.how != "time" or (moment.watched is not None and moment.watched[0] in study.system.coordinates)
    try:
        return tuple(_on_way(study, moment.state.places if is_place else None)), ()
    except Undecided as error:
        return (), (f"whether the contacts and the friction last so far is not decided: {error.what}",)


def _on_way(study: Study, places: Mapping[str, Scalar] | None) -> Iterator[Demand]:
    """Least values on the way from the start to some places (None: on the whole motion). Raises Undecided, StatementError."""
    for demand in held(study):
        names = names_in(demand.value) & {*study.system.coordinates, *study.system.speeds, "t"}
        if len(names) > 1 or names - study.squares.keys():
            raise Undecided("their forces are not known on the way")
        found = _least(study, demand, *names, places=places) if names else [demand]
        if settle(found, study.assumptions) is None:
            raise StatementError("a contact is lost, or friction reaches its limit, before: the motion that is stated ends there")
        yield from found


def _least(study: Study, demand: Demand, name: str, *, places: Mapping[str, Scalar] | None) -> list[Demand]:
    from rbpsym.ask.seen import Scene, to_and_fro, way_to
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    world, given = Scene(study), study.assumptions
    try:
        ways = to_and_fro(world, name, given) if places is None else [way_to(world, name, places[name], given)]
        found = [] if places is None else [Demand(way.ahead(places[name])) for way, _ in ways]
        for way, within in ways:
            found += least_values(world, Wanted((demand.value,), within, name, asked=way.asked))
    except RbpsymError as error:
        raise Undecided(error.what) from None
    return found
