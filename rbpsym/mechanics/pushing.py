"""A contact pushes and a string pulls: a statement in which one would have to do the opposite gets a sentence."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.equality.signs import sign
from rbpsym.errors import StatementError
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.study import Study
from rbpsym.notation.machine import to_machine
from rbpsym.statement.model import Element

LARGEST = 400  # terms: signs of what is longer are not looked for


def check_pushes(study: Study) -> None:
    """Raises StatementError where a force that can only push (or pull) is surely negative at the start."""
    start, reactions = _start(study), study.dynamics.reactions
    for element in study.problem.constraints:
        for name in pushes(element):
            value = _at_start(reactions[name], start)
            if value is not None and sign(value, study.assumptions, factoring=False).kind == "negative":
                raise _wrong_way(element, name, value)


def _start(study: Study) -> Mapping[str, Scalar]:
    return {**dict.fromkeys(study.system.speeds, NOTHING), **study.system.scope.start}


def _at_start(value: Scalar, start: Mapping[str, Scalar]) -> Scalar | None:
    if len(value.num) * len(value.den) > LARGEST:
        return None
    try:
        return short(substitute(value, start))
    except ZeroDivisionError:
        return None


def _wrong_way(element: Element, name: str, value: Scalar) -> StatementError:
    size = to_machine(present(value))
    if element.kind == "string":
        return StatementError(
            f"the string “{element.name}” would have to push at the start: its tension {name} is {size}",
            instead="check its path and what else holds the bodies; a light rod that may push is a body of its own.",
            place=element.place,
        )
    return StatementError(
        f"the {element.kind} “{element.name}” would have to pull at the start: its force {name} is {size}",
        instead="check the start (the sense in which things move or turn), the side, and whether it touches at all; "
        'what holds to both sides is type = "guide" for a point.',
        place=element.place,
    )
