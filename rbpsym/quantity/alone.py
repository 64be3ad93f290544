"""A noun alone, such as “tension”, where the problem has only one thing that it can mean."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING

from rbpsym.algebra.normal import is_zero
from rbpsym.errors import StatementError
from rbpsym.quantities import LENGTH
from rbpsym.quantity.bound import Bound
from rbpsym.statement.paths import tensions

if TYPE_CHECKING:
    from rbpsym.quantity.problem import ProblemWorld

HELD = {"tension": ("string", "link"), "normal force": ("contact", "touch", "rolling", "sticking", "slider")}


def _holds(noun: str, world: ProblemWorld) -> Iterator[str]:
    for element in world.study.problem.constraints:
        if element.kind in HELD[noun]:
            yield from (f"{noun} {name}" for name in (tensions(element) if element.kind == "string" else (element.name,)))


def _rubs(world: ProblemWorld) -> Iterator[str]:
    named = (e.values.get("friction") for e in world.study.problem.constraints)
    yield from (f"friction {name}" for name in named if name in world.forces_known)


def _coordinates(noun: str, world: ProblemWorld) -> Iterator[str]:
    yield from (f"{noun} of {name}" for name in world.study.system.independent)


def _moves(noun: str, world: ProblemWorld) -> Iterator[str]:
    """Of a coordinate that is a length; where there is none, of the bodies that have no size."""
    free = [world.study.problem.coordinate(name) for name in world.study.system.independent]
    found = [one.name for one in free if one.quantity.dimension == LENGTH]
    points = [f"{body.name}.cm" for body in world.study.problem.bodies if body.shape.kind == "particle"]
    yield from (f"{noun} of {name}" for name in found or points or [*(one.name for one in free), *world.study.system.bodies])


def _turns(noun: str, world: ProblemWorld) -> Iterator[str]:
    yield from (f"{noun} of {name}" for name, state in world.study.system.bodies.items() if not is_zero(state.omega))


NOUNS: Mapping[str, Callable[[ProblemWorld], Iterator[str]]] = {
    **{noun: partial(_holds, noun) for noun in HELD},
    "friction": _rubs,
    "friction force": _rubs,
    **{noun: partial(_moves, noun) for noun in ("speed", "velocity", "acceleration")},
    **{noun: partial(_turns, noun) for noun in ("angular velocity", "angular acceleration")},
    **{noun: partial(_coordinates, noun) for noun in ("period", "frequency", "amplitude", "decay rate", "damped frequency")},
}


def alone(world: ProblemWorld, noun: str) -> Bound:
    """The one quantity that the noun can mean. Raises StatementError with those that it could mean."""
    if noun in world.names:
        return world.expression(noun)
    found = list(NOUNS[noun](world))
    if len(found) == 1:
        return world.bound(found[0])
    if not found:
        raise StatementError(f"the problem has no {noun}", instead="name a quantity of the problem.")
    raise StatementError(f"which {noun} is meant?", instead=f"write {' or '.join(f'“{phrase}”' for phrase in found)}.")
