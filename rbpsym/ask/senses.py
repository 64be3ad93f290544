"""What holds in whichever sense the motion sets out: the same answer is asked of the motion of the other sense.

Where the sense is that of a start (sin θ₀ > 0), the other motion is the same problem with the start on the other side. Both
answers are certified; that they are one is exact algebra.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Answer, Found, shortest
from rbpsym.ask.question import Question
from rbpsym.ask.units import with_letters
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError, StatementError, there
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, PI, Scalar, depends_on, is_zero, names_in, short, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics.arrivals import followed, of_coordinate
from rbpsym.mechanics.demands import Demand, assuming, settle
from rbpsym.mechanics.led import led_by, tie_to_time
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solutions import given
from rbpsym.mechanics.solved import speed_along
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft
from rbpsym.quantities import TIME, Quantity
from rbpsym.quantity.path import even, first_push
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.completing import courses
from rbpsym.statement.model import Problem
from rbpsym.statement.own_text import letters_of


def whichever(asked: Asked, found: Answer, again: Callable[[Asked], Answer]) -> Answer:
    """The answer without the condition on the sense of the motion, if that of the other sense (asked `again`) is the same and
    asks for nothing more; where nothing sets the motion going, nothing is said."""
    for sense in of_sense(asked, demands_of(found)) if found.verdict.is_proved else ():
        with suppress(RbpsymError):
            problem = _turned(asked.problem, asked.first.assumptions, sense)
            rest = [demand for demand in demands_of(found) if not is_zero(demand.value - sense.value)]
            if problem is not None and _is_same(found, again(Asked(problem)), rest):
                nodes = Draft(found.study).asked([Demand(sense.value, "!=")])
                kept = (node for node in found.valid if not any(is_zero(d.value - sense.value) for d in _read(found.study, node)))
                found = replace(found, valid=(*nodes, *kept))
    return found


def turned(asked: Asked, stated: Sequence[Demand], name: str) -> Asked | None:
    """The same with a start on the other side, from which the motion sets out in the other sense; None if it does not tell."""
    for sense in of_sense(asked, [one for one in stated if depends_on(one.value, name)]):
        problem = _turned(asked.problem, asked.first.assumptions, sense)
        if problem is not None and name in {*asked.problem.implicit} - {*problem.implicit}:
            return Asked(problem)
    return None


def of_sense(asked: Asked, stated: Sequence[Demand]) -> Iterator[Demand]:
    """The conditions of an answer that tell the sense in which a coordinate sets out."""
    with suppress(RbpsymError):
        motion = asked.world(0).motion
        pushes = [first_push(motion, name) for name in motion.squares if name in motion.scope.start]
        either = (settle([Demand(push * way)], motion.assumptions) for push in pushes for way in (1, -1))
        told = [one for open_ in either if open_ is not None for one in open_]
        yield from (one for one in stated if one.op == ">" and any(is_zero(one.value - other.value) for other in told))


def demands_of(found: Answer) -> list[Demand]:
    """The conditions of an answer, each as a value that is positive, or does not vanish."""
    return [demand for node in found.valid for demand in _read(found.study, node)]


def _read(study: Study, node: t.Node) -> list[Demand]:
    rows = ((scalar(t.add(left, t.neg(right)), study.system.scope), op) for left, op, right in t.relations(node))
    return [Demand(gap if op in OPS else -gap, OPS.get(op, TURNED.get(op, op))) for gap, op in rows]


OPS, TURNED = {">": ">", ">=": ">=", "!=": "!="}, {"<": ">", "<=": ">="}


def _turned(problem: Problem, given: Assumptions, sense: Demand) -> Problem | None:
    """The problem in which the range of a start, or of another letter, says the contrary; None if no range does."""
    for quantity in problem.parameters:
        name = quantity.name
        is_round = name in problem.implicit and given.range_of(name) == (None, None)
        here = given.with_range(name, -PI, PI) if is_round else given  # what repeats itself starts in its first turn
        ends = assuming(here, [Demand(-sense.value)], tighter=True).range_of(name)
        if ends not in (here.range_of(name), (None, None)):
            lower, upper = (None if end is None else present(end) for end in ends)
            return narrowed(problem, replace(quantity, lower=lower, upper=upper))
    return None


def narrowed(problem: Problem, quantity: Quantity) -> Problem:
    """The problem, and all its phases, with another declaration of a parameter; of a start it is then a declared one."""
    parameters = tuple(quantity if each.name == quantity.name else each for each in problem.parameters)
    implicit = tuple(name for name in problem.implicit if name != quantity.name)
    phases = tuple(replace(phase, problem=narrowed(phase.problem, quantity)) for phase in problem.phases)
    return replace(problem, parameters=parameters, implicit=implicit, phases=phases)


def under(asked: Asked, found: Answer) -> Asked:
    """The problem with what the conditions of an answer say of single parameters as their bounds."""
    problem, given = asked.problem, asked.first.assumptions
    known = assuming(given, demands_of(found), tighter=True)
    for quantity in problem.parameters:
        if (ends := known.range_of(quantity.name)) != given.range_of(quantity.name):
            lower, upper = (None if end is None else present(end) for end in ends)
            problem = narrowed(problem, replace(quantity, lower=lower, upper=upper))
    return Asked(problem)


def _is_same(found: Answer, other: Answer, rest: list[Demand]) -> bool:
    """Whether the other answer is proved to be the same, under no further condition."""
    given = assuming(other.study.assumptions, rest)
    told = (found.relation, found.says, found.holds_so, found.each, found.equation, found.at, len(found.values))
    return (
        other.verdict.is_proved
        and told == (other.relation, other.says, other.holds_so, other.each, other.equation, other.at, len(other.values))
        and all(is_zero(neat(a - b, given)) for a, b in zip(found.values, other.values, strict=True))
        and all(one in rest or settle([one], given) == () for one in demands_of(other))
    )


def taken_for_kept(found: Answer, again: Callable[[Problem], Answer]) -> Answer:
    """The answer with the speeds that it takes to be kept: those with whose accelerations, if there were any, it would be another
    one, as is found when it is asked `again`."""
    problem, values = found.study.problem, None
    gains = {c.name: letters_of(problem).free(f"gain_{c.name}") for c in problem.kept}
    coordinates = tuple(replace(c, acceleration=t.Sym(gains[c.name])) if c.name in gains else c for c in problem.coordinates)
    added = tuple(Quantity(gains[c.name], c.quantity.dimension / TIME**2, sign="real") for c in problem.kept)
    doubted = replace(problem, coordinates=coordinates, parameters=(*problem.parameters, *added), led=courses(coordinates))
    with suppress(RbpsymError):
        values = again(doubted).values
    speeds = {c.name: t.equation(t.Sym(f"{c.name}_dot"), there(c.speed)) for c in problem.kept}
    told = (name for name in speeds if values is None or any(depends_on(value, gains[name]) for value in values))
    return replace(found, kept=tuple(speeds[name] for name in told))


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
    problem = with_letters(asked.problem, added)
    what = f"speed of {name}" if speed else name
    where = f"{what} = {'-' if speed and way < 0 else ''}{letter}"
    size = "the magnitude of the " if speed and way < 0 else "the " if speed else ""
    asking = f"time until {where}" if said[1] in ("t", "time") else f"{said[1]} where {where}"
    return Asked(problem), asking, letter, f"{size}{what}"
