"""The impulses with which a phase begins, as places in the list of numbers that the browser computes.

Each impulse on a body is an arrow at its point; what is named in a table are its components. Their values
are those of `mechanics.phases`, at the state in which the phase begins.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rbpsym.algebra.calculus import depends_on, substitute
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.document.explorer.labels import label
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.impulse import impulsive
from rbpsym.mechanics.phases import HandOver, Stage
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.statement.model import Phase

Put = Callable[[Scalar], int]


def strikes(stage: Stage, begins: Phase, put: Put, notation: Notation) -> dict[str, Any] | None:
    """Arrows, components and the kinetic energy that is lost; None where nothing strikes."""
    if not stage.began.is_blow:
        return None
    return {
        "arrows": list(arrows(stage, begins, put, notation)),
        "parts": [{**label(node, notation), "value": put(value)} for node, value in components(stage, begins)],
        "lost": put(stage.began.energy_lost),
    }


def arrows(stage: Stage, begins: Phase, put: Put, notation: Notation) -> Iterator[dict[str, Any]]:
    """The impulses that are known and not zero, on all bodies."""
    for force in impulsive(stage.study.system, begins.impulses):
        vector, point, couple = (put_in(stage.began, value) for value in (force.vector, force.point, force.couple))
        unknown = any(depends_on(part, n) for part in (vector.x, vector.y, couple) for n in force.unknowns)
        if not unknown and not all(map(is_zero, (vector.x, vector.y, couple))):
            yield {
                **label(letter(force, stage, begins), notation),
                "on": force.on,
                "at": [put(point.x), put(point.y)],
                "vector": [put(vector.x), put(vector.y)],
                "couple": put(couple),
            }


def put_in(began: HandOver, value: Vector | Scalar) -> Any:
    """A value with the places and the impulses of the moment."""
    if isinstance(value, Vector):
        return value.substitute(dict(began.impulses)).substitute(dict(began.before.places))
    return substitute(substitute(value, began.impulses), began.before.places)


def letter(force: Force, stage: Stage, begins: Phase) -> t.Node:
    """A blow as it is given, a collision by its name, the impulse of a constraint with a hat."""
    element = next((e for e in begins.impulses if e.name == force.name), None)
    if element is None:
        return t.Sym(hat(force.name, stage))
    given = [part for part in element["impulse"] if part != t.ZERO] if element.kind == "blow" else []
    return given[0] if len(given) == 1 else t.Sym(element.name)


def components(stage: Stage, begins: Phase) -> Iterator[tuple[t.Node, Scalar]]:
    """What a table names: the components of blows, then all unknown impulses that are not zero."""
    for element in begins.impulses:
        if element.kind == "blow":
            vector = pair(element["impulse"])
            yield from ((present(part), part) for part in (vector.x, vector.y) if not is_zero(part))
    own = {element.name for element in begins.impulses}
    for name, value in stage.began.impulses.items():
        if not is_zero(value):
            yield t.Sym(name if name in own else hat(name, stage)), value


def hat(name: str, stage: Stage) -> str:
    """P̂_x for the impulse of the force P_x."""
    first, _, rest = name.partition("_")
    return stage.study.letters.free(f"{first}_hat_{rest}" if rest else f"{first}_hat")
