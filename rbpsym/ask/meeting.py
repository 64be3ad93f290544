"""Where two bodies meet: the moment at which a coordinate has the value that brings their centres of mass to one place."""

from __future__ import annotations

import re

from rbpsym.algebra import Scalar, depends_on, derivative, is_zero, names_in, substitute, symbol
from rbpsym.algebra.normal import short
from rbpsym.algebra.present import present
from rbpsym.ask.moments import Asked
from rbpsym.errors import StatementError
from rbpsym.notation.machine import to_machine

MEETS = re.compile(
    r"\b(until|when|where) (?:the )?(\w+) (?:meets|hits|catches(?: up with)?|overtakes|passes) (?:the )?(\w+)$"
)


def met(asked: Asked, text: str) -> str:
    """The question with “where x = VALUE” for “where BODY meets BODY”; as it is if it says no such thing."""
    said = MEETS.search(text)
    if said is None or not {said[2], said[3]} <= {body.name for body in asked.problem.bodies}:
        return text
    return f"{text[: said.start()]}{said[1]} {_equation(asked, said[2], said[3])}"


def _equation(asked: Asked, first: str, second: str) -> str:
    world = asked.world(asked.lasting)
    apart, tied = world.centre(first) - world.centre(second), world.study.system.dependent
    gaps = [gap for part in (apart.x, apart.y) if not is_zero(gap := short(substitute(part, tied)))]
    free = [name for name in world.study.system.independent if gaps and depends_on(gaps[0], name)]
    ways = [name for name in free if not names_in(derivative(gaps[0], name)) & {*world.motion.scope.rates, "t"}]
    if not ways or any(names_in(short(gap / gaps[0])) & {*world.motion.scope.rates, "t"} for gap in gaps[1:]):
        raise StatementError(
            f"where “{first}” and “{second}” are at one place is no equation for one coordinate",
            instead="ask where a coordinate has the value that brings them together.",
        )
    return f"{ways[0]} = {_solved(gaps[0], ways[0])}"


def _solved(gap: Scalar, name: str) -> str:
    return to_machine(present(short(symbol(name) - gap / derivative(gap, name))))
