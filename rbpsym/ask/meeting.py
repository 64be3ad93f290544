"""Where two bodies meet, or a spring is as long as is said: the moment at which a coordinate has the value that makes it so."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rbpsym.ask.asked import Asked
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import Scalar, depends_on, derivative, is_zero, names_in, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import short
from rbpsym.present.forms import present
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.typeset.machine import to_machine

MEETS = re.compile(r"\b(until|when|where) (\w+) (?:meets|hits|catches(?: up with)?|overtakes|passes) (\w+)$")


LENGTH = re.compile(
    r"\b(until|when|where) (?:(elongation|compression) of (\w+) (?:=|is|reaches) (.+)"
    r"|(\w+) (?:(?:has|reaches|is at) its natural length|(?:is|gets|becomes) (?:relaxed|unstretched|unstressed)))$"
)


MOVES = re.compile(
    r"\b(until|when|where|once) ((angular )?(?:speed|velocity) of (\w+)) "
    r"(?:=|reaches|is|equals|is equal to) (.+)$"
)
TOGETHER = re.compile(
    r"\b(until|when|where|once) (\w+) and (\w+) (?:have|(?:turn|rotate) (?:with|at)) (?:same|equal) "
    r"angular (?:velocity|speed|velocities|speeds)$"
)


def met(asked: Asked, text: str) -> str:
    """The question with “where x = VALUE” for “where BODY meets BODY”, “where elongation of S = VALUE” or “where angular velocity
    of BODY = VALUE”; as it is if it says no such thing."""
    if text.rsplit(" ", 1)[-1] in SUPERLATIVES:  # “where speed of block is greatest” names no value
        return text
    world = asked.world(asked.lasting)
    text = TOGETHER.sub(r"\1 angular velocity of \2 = angular velocity of \3", text)
    if (said := MOVES.search(text)) and said[4] in {body.name for body in asked.problem.bodies} - {*world.coordinates}:
        before = f"{text[: said.start()]}{said[1]} "
        if said[3] is None:  # of a body that is the magnitude of its velocity, of a coordinate its rate
            return f"{before}magnitude of velocity of {said[4]} = {said[5]}"
        sides = [world.bound(side).number for side in (said[2], said[5])]
        return f"{before}{equation(world, (sides[0] - sides[1],), f'“{said[2]}” has this value')}"
    if (said := MEETS.search(text)) and {said[2], said[3]} <= {body.name for body in asked.problem.bodies}:
        apart, what = world.centre(said[2]) - world.centre(said[3]), f"“{said[2]}” and “{said[3]}” are at one place"
        return f"{text[: said.start()]}{said[1]} {equation(world, (apart.x, apart.y), what)}"
    spring = (said := LENGTH.search(text)) and (said[3] or said[5])
    if said and spring in {element.name for element in asked.problem.of_kind("spring")}:
        gap = world.bound(f"{said[2] or 'elongation'} of {spring}").number
        gap = gap - scalar(read_infix(said[4] or "0", world.names))
        return f"{text[: said.start()]}{said[1]} {equation(world, (gap,), f'“{spring}” is as long')}"
    return text


def equation(world: ProblemWorld, values: Iterable[Scalar], what: str) -> str:
    """“x = VALUE” for the one coordinate in which a value, that vanishes with the others, is linear. Raises StatementError."""
    tied = world.study.system.dependent
    gaps = [gap for part in values if not is_zero(gap := short(substitute(part, tied)))]
    names = (*world.study.system.independent, *world.study.system.speeds, *([] if world.study.system.independent else ["t"]))
    free = [name for name in names if gaps and depends_on(gaps[0], name)]
    ways = [name for name in free if not names_in(derivative(gaps[0], name)) & {*world.motion.scope.rates, "t"}]
    if not ways or any(names_in(short(gap / gaps[0])) & {*world.motion.scope.rates, "t"} for gap in gaps[1:]):
        raise StatementError(
            f"where {what} is no equation for one coordinate",
            instead="ask where a coordinate has the value that makes it so.",
        )
    value = short(symbol(ways[0]) - gaps[0] / derivative(gaps[0], ways[0]))
    return f"{ways[0]} = {to_machine(present(value))}"
