"""Motions that drives alone lead: no coordinate is free, the time says where each one is."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, Scalar, atoms, depends_on, derivative, names_in, short, substitute, symbol
from rbpsym.field.normal import angles_apart
from rbpsym.mechanics.arrivals import ArrivalState, of_coordinate
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.mechanics.tying import placed_by
from rbpsym.statement.scope import CLOCK


def tie_to_time(system: System, name: str) -> Scalar | None:
    """What vanishes of a coordinate and the time alone; None where nothing ties it so."""
    others = {n: value for n, value in system.dependent.items() if n != name}
    known = {"pi", *(quantity.name for quantity in system.problem.parameters)}
    own = [system.dependent[name] - symbol(name)] if name in system.dependent else []
    for tie in (*(one.value for one in (*system.implicit, *(() if system.independent else system.conditions))), *own):
        with suppress(Undecided):  # of an angle with a sum below
            if depends_on(tie, name) and names_in(value := substitute(tie, others)) - known == {name, CLOCK}:
                return value
    return None


def led_to(study: Study, known: Mapping[str, Scalar]) -> dict[str, Scalar]:
    """What is known of a moment, with the places to which drives put other coordinates then, by their ranges."""
    system = study.system
    if system.independent or not system.implicit:
        return dict(known)
    return {**placed_by(system.implicit, system.coordinates, known, study.assumptions), **known}


def put(value: Scalar, image: Mapping[str, Scalar]) -> Scalar:
    """The value there; where a place is an inverse function, its angle apart from others: cos(q - atan x) has a plain form."""
    inverse = any(atoms.atom(index).kind in ("acos", "asin", "atan") for place in image.values() for index in place.atoms())
    return short(substitute(angles_apart(value) if inverse else value, image))


def led_by(study: Study, name: str, value: Scalar) -> dict[str, Scalar] | None:
    """The first time at which a coordinate has a value, and where the others are then; None where that is not told: its tie has
    then one zero in its range, and one time ahead of the start, or the first one, is known."""
    tie, given = tie_to_time(study.system, name), study.assumptions
    if tie is None:
        return None
    times = [neat(time, given) for time in zeros(substitute(tie, {name: value}), CLOCK)]
    ahead = [time for time in times if sign(time, given).kind != "negative"]
    first = next((one for one in ahead if all(sign(other - one, given).is_nonnegative for other in ahead)), None)
    is_one = first is not None and sign(substitute(derivative(tie, name), {CLOCK: first}), given).is_nonzero
    if first is None or not (is_one or way_from_start(study, name, value, first)):
        return None
    return led_to(study, {name: value, CLOCK: first})


def way_from_start(study: Study, name: str, value: Scalar, time: Scalar) -> int:
    """1 or -1 where a coordinate that drives lead goes from its start in that sense, and comes to the value, if that lies
    ahead, at a time without turning round: between, no slope of its tie vanishes, so that each time has one place; else 0."""
    tie, start, given = tie_to_time(study.system, name), study.system.scope.start.get(name), study.assumptions
    if tie is None or start is None:
        return 0
    slopes, begun = (derivative(tie, name), derivative(tie, CLOCK)), {name: start, CLOCK: NOTHING}
    first = [sign(neat(substitute(slope, begun), given), given).sense for slope in slopes]
    way = -first[0] * first[1]
    within = given.with_range(name, *((start, value) if way > 0 else (value, start))).with_range(CLOCK, NOTHING, time)
    return way if way and first == [sign(slope, within).sense for slope in slopes] else 0


def state_reached(study: Study, name: str, value: Scalar) -> ArrivalState | None:
    """The state when a coordinate that drives lead first has a value; None where that is not told, or lies before the start."""
    image = led_by(study, name, value)
    if image is None:
        return None
    pairs = {c.name: of_coordinate(study, c.name) for c in study.problem.coordinates}
    places, speeds = ({n: put(pair[k], image) for n, pair in pairs.items()} for k in (0, 1))
    ends = zip(study.assumptions.range_of(name), (1, -1), strict=True)
    within = (Demand((value - end) * side, ">=") for end, side in ends if end is not None)
    start = study.system.scope.start.get(name)
    way = 0 if start is None else sense_to(study, name, (start, value)) or way_from_start(study, name, value, image[CLOCK])
    ahead = Demand(image[CLOCK] if start is None or not way else (value - start) * way)
    valid = settle([ahead, *within], study.assumptions)
    return None if valid is None else ArrivalState(image[CLOCK], {**places, name: value}, speeds, valid)


def sense_to(study: Study, name: str, ends: tuple[Scalar, Scalar]) -> int:
    """1 or -1 where the time grows, or falls, with the coordinate all the way between two places; else 0."""
    tie = tie_to_time(study.system, name)
    if tie is None:
        return 0
    slope = -(derivative(tie, name) / derivative(tie, CLOCK))
    signs = {sign(slope, study.assumptions.with_range(name, *pair)).sense for pair in (ends, ends[::-1])}
    return signs.pop() if len(signs) == 1 else 0
