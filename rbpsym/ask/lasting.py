"""How far the motion that is stated lasts: no contact is lost on the way to a place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.scalar import Scalar
from rbpsym.errors import StatementError
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.endings import State
from rbpsym.mechanics.study import Study
from rbpsym.quantity.path import sense
from rbpsym.quantity.problem import ProblemWorld


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
