"""A quantity along the motion as a function of one coordinate, or of the time; places and the time as functions of what is
told as functions of them."""

from __future__ import annotations

import re
from dataclasses import replace

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Found, shortest
from rbpsym.ask.question import Question
from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, Scalar, depends_on, names_in, short, substitute, symbol
from rbpsym.mechanics.arrivals import followed, of_coordinate
from rbpsym.mechanics.led import led_by, tie_to_time
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solutions import given
from rbpsym.mechanics.solved import speed_along
from rbpsym.present.forms import present
from rbpsym.quantities import TIME, Quantity
from rbpsym.quantity.path import even, first_push
from rbpsym.quantity.problem import ProblemWorld


def moving_in(world: ProblemWorld, values: tuple[Scalar, ...]) -> set[str]:
    """What moves in the values."""
    return {n for value in values for n in names_in(value)} & {*world.motion.scope.rates, *world.motion.speeds}


def resisted_in(world: ProblemWorld, values: tuple[Scalar, ...]) -> dict[str, Scalar]:
    """The speeds in the values that a resistance gives as functions of the place."""
    left = (name for name in world.study.system.independent if any(depends_on(value, f"{name}_dot") for value in values))
    known = ((name, given(world.study, name)) for name in left)
    found = ((name, speed_along(one, name)) for name, one in known if one is not None)
    return {name: speed for name, speed in found if speed is not None}


def of_one(world: ProblemWorld, found: Found, question: Question) -> Found:
    """The values as functions of one quantity. Raises StatementError if they are not."""
    name, rates = question.of, world.motion.scope.rates
    if name not in (*rates, *world.coordinates, *world.names, "t"):
        world.bound(name)
    moving = moving_in(world, found.values)
    if moving - {name} and (name in world.dependent or tie_to_time(world.study.system, name) is not None):
        found = _inverted(world, found, name, moving)
        moving = moving_in(world, found.values)
    others = moving & {*world.study.system.independent} - {name} if name in rates else ()
    places = {other: place for other in others if (place := followed(world.study, name, other)) is not None}
    if places:
        values = tuple(short(substitute(value, places)) for value in found.values)
        found, moving = replace(found, values=values, places=places, of="position"), moving_in(world, values)
    speed = f"{name}_dot"
    is_repeated = any(value in (symbol(speed), -symbol(speed)) for value in found.values)
    stays = speed in moving and (is_repeated or name in world.motion.scope.start)
    left = sorted(moving - {name, *(() if stays else (speed,))})
    if left:
        why = "it is not known how it moves" if name == "t" else f"{left[0]} is no known function of {name}"
        what = f"“{question.quantity}” depends on {left[0]}, and {why}"
        raise StatementError(what, instead="ask for it “as a function of the state”.")
    return found


def _inverted(world: ProblemWorld, found: Found, name: str, moving: set[str]) -> Found:
    """The values as functions of a coordinate that is tied to the one that moves, or to the time, by which it is led."""
    led, (way, *others) = led_by(world.study, name, symbol(name)), moving
    own = world.dependent.get(name, NOTHING) - symbol(name)
    places = [led["t"]] if led else [] if others else zeros(own, way)
    if len(places) != 1:
        raise StatementError(f"“{name}” is tied to {min(moving)}", instead=f"ask for it as a function of {min(moving)}.")
    if "t" in names_in(places[0]):
        said = f"{way} is tied to {name} and to the time"
        raise StatementError(f"“{way}” is no function of {name} alone: {said}", instead="ask for both “as a function of t”.")
    values = (even(substitute(value, {"t" if led else way: places[0]})) for value in found.values)
    told = tuple(shortest(short(value), world.study) for value in values)
    return replace(found, values=told, of="position" if led else found.of)


CONVERSE = re.compile(r"(.+) as a function of ((?:speed|velocity) of )?(\w+)")


def converse(asked: Asked, text: str, *, last: bool = False) -> tuple[Asked, str, str, str] | None:
    """For “t as a function of x”, “x as a function of speed of x” (as the `last` resort for any quantity): the problem with a
    letter for what it is a function of, the question when, or where, that has this value, the letter, and what it is; None for
    another question."""
    said = CONVERSE.fullmatch(text)
    if said is None or said[3] == "t":
        return None
    world = asked.world(asked.lasting)
    moves = names_in(world.dependent.get(said[3], symbol(said[3]))) & {*world.motion.scope.rates}
    if {*moves} not in ({said[3]}, {"t"}):
        return None
    if said[1] not in ("t", "time") and not (said[2] and said[1] in world.coordinates) and not last:
        return None
    name, speed, known = said[3], bool(said[2]), {quantity.name for quantity in asked.problem.parameters}
    begun, first = (substitute(one, world.motion.scope.start) for one in of_coordinate(world.study, name))
    way = sign(first or first_push(world.motion, name), world.motion.assumptions).sense
    letter = world.study.letters.free("v" if speed else f"{name}_1")
    end = present(begun) if not speed and names_in(begun) <= known else None
    is_positive = (speed and way) or (way > 0 and sign(begun, world.motion.assumptions).is_nonnegative)
    dimension = asked.problem.dimensions[name] / TIME**int(speed)
    kind, lower, upper = "positive" if is_positive else "real", end if way > 0 else None, end if way < 0 else None
    added = Quantity(letter, dimension, said[0], kind, lower=lower, upper=upper)
    problem = replace(asked.problem, parameters=(*asked.problem.parameters, added))
    phases = (replace(one, problem=replace(one.problem, parameters=problem.parameters)) for one in problem.phases)
    what = f"speed of {name}" if speed else name
    where = f"{what} = {'-' if speed and way < 0 else ''}{letter}"
    size = "the magnitude of the " if speed and way < 0 else "the " if speed else ""
    asking = f"time until {where}" if said[1] in ("t", "time") else f"{said[1]} where {where}"
    return Asked(replace(problem, phases=tuple(phases))), asking, letter, f"{size}{what}"
