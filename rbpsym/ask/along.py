"""A quantity along the motion as a function of one coordinate, or of the time."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.algebra import Scalar, names_in, substitute, symbol
from rbpsym.ask.question import Question
from rbpsym.errors import StatementError
from rbpsym.mechanics.arrivals import followed
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.roots import zeros
from rbpsym.quantity.problem import ProblemWorld

if TYPE_CHECKING:
    from rbpsym.ask.answer import Found


def moving_in(world: ProblemWorld, values: tuple[Scalar, ...]) -> set[str]:
    """What moves in the values."""
    return {n for value in values for n in names_in(value)} & {*world.motion.scope.rates, *world.motion.speeds}


def of_one(world: ProblemWorld, found: Found, question: Question) -> Found:
    """The values as functions of one quantity. Raises StatementError if they are not."""
    name, rates = question.of, world.motion.scope.rates
    if name not in (*rates, *world.coordinates, *world.names, "t"):
        world.bound(name)
    moving = moving_in(world, found.values)
    if name in world.dependent and moving:
        found, moving = _inverted(world, found, name, moving), {name}
    places = {other: followed(world.study, name, other) for other in moving - {name} if other in world.study.system.independent}
    places = {other: place for other, place in places.items() if place is not None} if name in rates else {}
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
    """The values as functions of a coordinate that is tied to the one that moves."""
    way, *others = moving
    places = [] if others else zeros(world.dependent[name] - symbol(name), way)
    if len(places) != 1:
        raise StatementError(f"“{name}” is tied to {min(moving)}", instead=f"ask for it as a function of {min(moving)}.")
    return replace(found, values=tuple(short(substitute(value, {way: places[0]})) for value in found.values))
