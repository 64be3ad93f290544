"""Strings: straight segments between points and circles, one tension from grip to grip.

A taut inextensible string moves along each segment with one speed, so the places to which it
is tied (or whose rims it grips) have equal speeds along it; the tension T pulls on both. Its
power T u·(v_first - v_second) then vanishes: that is the condition of the string.
Kleppner & Kolenkow 2.4, 7.6.
"""

from __future__ import annotations

from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, QUARTER, UNITY, Scalar, Vector, depends_on, is_rooted, is_zero, polar, symbol, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.geometry import Geometry, no_direction
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element, Turn
from rbpsym.statement.paths import runs, tensions


class Segment(Frozen):
    """A straight piece: `along` the unit vector from `start` (leaving `first`) to `end` (at `second`)."""

    first: Turn
    second: Turn
    start: Vector
    end: Vector
    along: Vector
    length: Scalar


class StringCrosses(Exception):
    """A string can't leave or reach a circle as it is said to: it would have to run through it."""

    def __init__(self, first: Turn, second: Turn) -> None:
        super().__init__(first.center.label, second.center.label)
        self.ends = (first, second)


def segment(first: Turn, second: Turn, geometry: Geometry) -> Segment:
    """The common tangent of two circles in the senses in which the string runs (points: radius 0).

    With ρ = s r (counter-clockwise positive) the string leaves a circle at C - ρ k×u, so the
    distance of the centres across the string is ρ_second - ρ_first. Raises Crossing.
    """
    here, there = geometry.where(first.center), geometry.where(second.center)
    leaving, arriving = (scalar(turn.radius) * turn.sense for turn in (first, second))
    apart = (there - here).settled()
    found = _straight(apart, arriving - leaving, geometry)
    if found is None:
        raise StringCrosses(first, second)
    along, length = found
    across = along.turned()
    return Segment(first, second, here - across * leaving, there - across * arriving, along, length)


def _straight(apart: Vector, offset: Scalar, geometry: Geometry) -> tuple[Vector, Scalar] | None:
    """(u, length of the segment) with apart = length u + offset k×u; None where only the opposite sense has a plain
    one. Where nothing says where the end is, the plain one is meant."""
    other = None
    for angle in dict.fromkeys(a + QUARTER * k for a in apart.parts for k in range(4)):
        along = polar(UNITY, angle)
        length = tidy(apart.dot(along))
        if not is_zero(apart.dot(along.turned()) - offset):
            continue
        if is_zero(length) or geometry.sign(length) > 0:
            return along, length
        other = other or (along, length)
    if other is None:
        return _slanting(apart, offset, geometry)
    return other if any(depends_on(other[1], name) for name in geometry.unsaid) else None


def _slanting(apart: Vector, offset: Scalar, geometry: Geometry) -> tuple[Vector, Scalar]:
    square = tidy(apart.dot(apart))
    length = geometry.size(tidy(square - offset * offset))
    return (apart * length - apart.turned() * offset) * square.inverse() if offset else apart * length.inverse(), length


def segments(run: tuple[Turn, ...], geometry: Geometry) -> list[Segment]:
    """The straight pieces of a run. Raises Crossing."""
    return [segment(a, b, geometry) for a, b in zip(run, run[1:], strict=False)]


def pieces(element: Element, geometry: Geometry) -> list[Segment]:
    """Those of all runs of a string; none of what is none. Raises Crossing."""
    found = runs(element["path"]) if element.kind == "string" else ()
    return [piece for run in found for piece in segments(run, geometry)]


def spans(element: Element, geometry: Geometry) -> tuple[Scalar, ...]:
    """The lengths of its straight pieces, positive where each runs the way that is taken; none of what ends on a rim."""
    found = (piece for run in runs(element["path"]) for piece in _pieces(element, run, geometry))
    return tuple(piece.length for piece in found if not is_zero(piece.length))


def _pieces(element: Element, run: tuple[Turn, ...], geometry: Geometry) -> list[Segment]:
    for first, second in zip(run, run[1:], strict=False):
        if not (geometry.where(second.center) - geometry.where(first.center)).settled().parts:
            raise no_direction(element, first.center.label, second.center.label)
    try:
        return segments(run, geometry)
    except StringCrosses as fault:
        start, end = (turn.body or turn.center.label for turn in fault.ends)
        raise StatementError(
            f"the string “{element.name}” would have to cross its pulley between “{start}” and “{end}” at the start",
            instead=f"let it run round the other way ({_other_way(fault.ends)}), or say on which side of the pulley its ends "
            'are, also where a coordinate follows from others: start = "-h" for a weight that hangs below it, or a range.',
            place=element.place,
        ) from None


def _other_way(ends: tuple[Turn, Turn]) -> str:
    said, other = ("ccw", "cw") if next(turn.sense for turn in ends if turn.sense) > 0 else ("cw", "ccw")
    return f"{other} instead of {said}"


def pulls(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """The tension on both ends of every run, first on that of a point; where the string slides round a circle, both pulls act at
    its centre."""
    found: list[Force] = []
    for name, run in zip(tensions(element), runs(element["path"]), strict=True):
        parts = _pieces(element, run, geometry)
        first, last = parts[0], parts[-1]
        others = [turn.body or "ground" for turn in (run[-1], run[0])] if len(parts) == 1 else ["string", "string"]
        own = _pull(name, run[0], others[0], first.start, first.along)
        for before, after in zip(parts, parts[1:], strict=False):
            own += _pull(name, after.first, "string", geometry.where(after.first.center), after.along - before.along)
        own += _pull(name, run[-1], others[1], last.end, -last.along)
        found += own[::-1] if run[0].sense and not run[-1].sense else own
    return tuple(found)


def _pull(name: str, turn: Turn, by: str, place: Vector, direction: Vector) -> list[Force]:
    """The tension on the body of a place on the path, if it belongs to one."""
    if turn.body is None:
        return []
    return [Force(name, turn.body, by, place, direction * symbol(name), unknowns=(name,), where=turn.center.label)]


def speeds_along(element: Element, geometry: Geometry) -> tuple[tuple[str, Scalar], ...]:
    """Tensions whose power vanishes; with the length of a free segment as factor, which clears its root."""
    if element["length"] is not None:
        return ()
    found = []
    for name, run in zip(tensions(element), runs(element["path"]), strict=True):
        parts = _pieces(element, run, geometry)
        free = len(parts) == 1 and is_rooted(parts[0].length.num)
        found.append((name, parts[0].length if free else UNITY))
    return tuple(found)


def gap(element: Element, geometry: Geometry) -> Scalar | None:
    """The distance minus the given length, along one line; else the same of their squares; None if no length is given.
    Raises StatementError where nothing says which of two points along a line is ahead."""
    if element["length"] is None:
        return None
    first, second = (geometry.where(turn.center) for turn in element["path"])
    apart, length = (second - first).settled(), scalar(element["length"])
    [way, *more] = apart.parts.values() or [NOTHING]
    if not more and (open_ := next((name for name in sorted(geometry.unsaid) if depends_on(way, name)), None)):
        ends = " and ".join(f"“{turn.center.label}”" for turn in element["path"])
        what = f"nothing says on which side of each other {ends} are, which the {element.kind} “{element.name}” joins"
        raise StatementError(what, instead=f"say where “{open_}” is at the start, or give it a range.", place=element.place)
    if not more and (sign := geometry.sign(way)):
        return way * sign - length
    return apart.dot(apart) - length**2
