"""What ends a phase in the explorer: numbers that are positive while it lasts.

The normal force of a contact, the tension of a string, the slip of a contact with kinetic friction, the
friction that is left, the straight pieces of a string, the rod under a contact, the range of a coordinate.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import UNITY, Scalar, symbol
from rbpsym.algebra.vector import polar
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import geometry_of, slip_senses
from rbpsym.mechanics.strings import segments
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.model import Coordinate
from rbpsym.statement.paths import runs

Event = dict[str, Any]


def events(study: Study, goal: tuple[str, Scalar] | None) -> Iterator[Event]:
    """What ends the phase, with the scalar that is positive until then (one that reaches zero from either side)."""
    if goal is not None:
        name, value = goal
        yield {"kind": "reaches", "name": name, "value": symbol(name) - value}
    for element in study.problem.constraints:
        for name in pushes(element):
            kind = "slack" if element.kind == "string" else "lost"
            yield {"kind": kind, "name": name, "value": symbol(name)}
        if element.values.get("limit") is not None and element["friction"] in study.system.unknowns:
            grip, limit = symbol(element["friction"]), scalar(element["limit"]) * symbol(element.name)
            for left in (limit - grip, limit + grip):
                yield {"kind": "slips", "name": element.name, "value": left}
    yield from _slips(study)
    yield from _used_up(study)
    yield from _left(study)
    for coordinate in study.problem.coordinates:
        yield from _edges(coordinate)


def _slips(study: Study) -> Iterator[Event]:
    geometry, senses = geometry_of(study.system), slip_senses(study.system)
    for name, sense in senses.items():
        slip = slip_speed(geometry, meeting(study.system.element(name), geometry))
        yield {"kind": "holds", "name": name, "value": slip * sense}


def _used_up(study: Study) -> Iterator[Event]:
    """The straight pieces of a string between a pulley and something else, as long as there is any."""
    geometry = geometry_of(study.system)
    for element in study.problem.constraints:
        if element.kind != "string":
            continue
        for piece in (piece for run in runs(element["path"]) for piece in segments(run, geometry)):
            if (piece.first.sense or piece.second.sense) and any(
                depends_on(piece.length, n) for n in study.system.coordinates
            ):
                yield {"kind": "short", "name": element.name, "value": piece.length}


def _left(study: Study) -> Iterator[Event]:
    """How far a contact is from both ends of the rod on which it is."""
    geometry, shapes = geometry_of(study.system), {body.name: body.shape for body in study.problem.bodies}
    for element in study.problem.constraints:
        rod = element.values.get("of")
        if element.values.get("line") is None or rod is None or shapes[rod].kind != "rod":
            continue
        pose, half = study.system.bodies[rod].pose, scalar(shapes[rod].sizes["length"]) / 2
        along = (meeting(element, geometry).place - pose.origin).dot(polar(UNITY, pose.angle))
        yield from ({"kind": "leaves", "name": element.name, "value": half + along * side} for side in (1, -1))


def _edges(coordinate: Coordinate) -> Iterator[Event]:
    here = t.Sym(coordinate.name)
    for bound, left in ((coordinate.lower, 1), (coordinate.upper, -1)):
        if bound is not None:
            yield {"kind": "edge", "name": coordinate.name, "value": (scalar(here) - scalar(bound)) * left}
