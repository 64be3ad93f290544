"""What of a system is seen, as places in the list of numbers that the browser computes.

Everything is the statement's own geometry: poses of bodies, points of constraints and
interactions, lines, circles and strings, in space. `put` gives the place of a value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.expr.tree import Node
from rbpsym.field import Scalar, Vector, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.contacts import meeting, parameter
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import Geometry, pair
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.strings import pieces
from rbpsym.mechanics.study import Study
from rbpsym.pictures.pose import touched_radii
from rbpsym.statement.curves import is_slot
from rbpsym.statement.model import Element, PlacedShape, Shape, Turn
from rbpsym.statement.slots import drawn_as
from rbpsym.statement.solids import copies, leaves

Part = dict[str, Any]


class SeenStudy(Frozen):
    """A study seen: `put` stores a scalar and says where; `elsewhere` is the ground of other phases."""

    study: Study
    put: Callable[[Scalar], int]
    geometry: Geometry
    elsewhere: tuple[Element, ...] = ()

    def node(self, node: Node) -> int:
        """A formula of the statement, dependent coordinates put in."""
        return self.put(scalar(node))

    def at(self, vector: Vector) -> list[int]:
        """x and y."""
        return [self.put(vector.x), self.put(vector.y)]


def scenery(study: Study, put: Callable[[Scalar], int], elsewhere: tuple[Element, ...] = ()) -> dict[str, list[Part]]:
    """All that is drawn besides the forces, by kind."""
    seen = SeenStudy(study, put, geometry_of(study.system), elsewhere)
    return {name: parts for name, of in KINDS.items() if (parts := list(of(seen)))}


def bodies(seen: SeenStudy) -> Iterator[Part]:
    """Shape, circles that it rolls on or that carry strings, pose, motion and inertia of each body."""
    radii = list(touched_radii(seen.study.problem))
    for body in seen.study.problem.bodies:
        state = seen.study.system.bodies[body.name]
        yield {
            "name": body.name,
            **shape(seen, body.shape),
            "rims": list(dict.fromkeys(seen.node(radius) for name, radius in radii if name == body.name)),
            "at": seen.at(state.pose.origin), "cm": seen.at(state.center), "v": seen.at(state.velocity),
            **{key: seen.put(getattr(state, key)) for key in ("omega", "mass", "moment")},
            "angle": seen.put(state.pose.angle),
        }


def shape(seen: SeenStudy, found: Shape) -> Part:
    """Kind, sizes and parts of a shape."""
    sizes = {key: seen.node(size) for key, size in found.sizes.items() if key != "moment"}
    parts = (one for leaf in leaves(found) for one in copies(leaf, often(seen, leaf)))
    return {"kind": found.kind, "sizes": sizes, "parts": [part(seen, one) for one in parts]}


def often(seen: SeenStudy, placed: PlacedShape) -> int:
    """How often a part is drawn."""
    return 1 if placed.count is None else max(2, round(number(scalar(placed.count), sample(seen.study.problem))))


def part(seen: SeenStudy, placed: PlacedShape) -> Part:
    """A part of a composite."""
    at = [seen.node(node) for node in placed.at]
    return {**shape(seen, placed.shape), "at": at, "angle": seen.node(placed.angle), "removed": placed.removed}


def points(seen: SeenStudy) -> Iterator[Part]:
    """Pivots, pins, welds, slots, edges and the fixed ends of springs and strings."""
    where = seen.geometry.where
    for element in drawn_as(seen.study.problem, "pivot", "pin", "weld", "guide", "slider", "driven"):
        refs = element.values.get("points") or (element["point"],)
        bodies = [ref for ref in refs if ref.body]
        ground = len(bodies) < 2
        kind = "pivot" if ground and element.kind == "pin" else element.kind
        body = bodies[-1]
        yield {"kind": kind, "at": seen.at(where(body)), "of": body.body, **({"ground": ground} if len(refs) > 1 else {})}
    for element in seen.study.problem.constraints:
        ref = element.values.get("point")
        if ref and ref.body is None and element.values.get("of"):
            yield {"kind": "edge", "at": seen.at(where(ref)), "of": None}
    for ref in fixed_ends(seen):
        yield {"kind": "fixed", "at": seen.at(where(ref)), "of": None}


def fixed_ends(seen: SeenStudy) -> Iterator[Any]:
    """Points of the ground to which springs, dampers and strings are tied."""
    for element in drawn_as(seen.study.problem, "link", "cord"):
        yield from (ref for ref in element["between"] if ref.body is None)
    for element in seen.study.problem.of_kind("string"):
        yield from (turn.center for turn in element["path"] if turn.body is None and not turn.sense)


def lines(seen: SeenStudy) -> Iterator[Part]:
    """Lines that are touched: a x + b y = c, in the frame of the body `of` or in space; a slot has no normal."""
    done = set()
    for element in (*seen.study.problem.constraints, *seen.elsewhere):
        line, of = element.values.get("line"), element.values.get("of")
        if line is None or (line.label, of) in done:
            continue
        done.add((line.label, of))
        values = {key: seen.node(getattr(line, key)) for key in "abc"}
        normal = None if is_slot(element) else seen.at(meeting(element, seen.geometry).normal)
        yield {**values, "of": of, "normal": normal, "through": touched(seen, element)}


def touched(seen: SeenStudy, element: Element) -> list[int]:
    """A point of what touches: where it is, the line is drawn."""
    ref = element.values.get("point")
    return seen.at(seen.geometry.where(ref) if ref else seen.geometry.center(element["body"]))


def circles(seen: SeenStudy) -> Iterator[Part]:
    """Fixed circles that are touched (a wire has no normal), and those that strings slide round."""
    for element in seen.study.problem.constraints:
        centre = element.values.get("circle")
        if centre is not None and centre.body is None:
            radius, at = seen.node(element["radius"]), seen.at(seen.geometry.where(centre))
            normal = None if is_slot(element) else seen.at(meeting(element, seen.geometry).normal)
            yield {"at": at, "r": radius, "through": touched(seen, element), "normal": normal}
    for element in seen.study.problem.of_kind("string"):
        yield from filter(None, (turn(seen, one) for one in element["path"] if one.body is None))


def links(seen: SeenStudy) -> Iterator[Part]:
    """Springs and dampers."""
    for element in drawn_as(seen.study.problem, "link"):
        ends = [seen.at(seen.geometry.where(ref)) for ref in element["between"]]
        yield {"kind": element.kind, "ends": ends}


def cords(seen: SeenStudy) -> Iterator[Part]:
    """Curves; the straight pieces of each string, and the circles round which it runs between them."""
    for element in seen.study.problem.constraints:
        if element.values.get("curve") is not None:
            yield from bent(seen, element)
        for piece in pieces(element, seen.geometry):
            yield {"ends": [seen.at(piece.start), seen.at(piece.end)], "turn": turn(seen, piece.second)}
    for element in drawn_as(seen.study.problem, "cord"):
        yield {"ends": [seen.at(seen.geometry.where(ref)) for ref in element["between"]], "turn": None}


def bent(seen: SeenStudy, element: Element) -> Iterator[Part]:
    """A curve in straight pieces, a little farther to both sides than where the point starts."""
    curve, start = element["curve"], seen.study.system.scope.start
    begin = substitute(parameter(element, seen.geometry), start)
    images = ({curve.name: begin * k / 10} for k in range(-12, 13))
    places = [seen.at(pair((curve.x, curve.y)).substitute(image)) for image in images]
    yield from ({"ends": [one, other], "turn": None} for one, other in zip(places, places[1:], strict=False))


def turn(seen: SeenStudy, found: Turn) -> Part | None:
    """The circle that a string meets, and the sense in which it runs round it."""
    if not found.sense:
        return None
    centre = seen.geometry.where(found.center)
    return {"at": seen.at(centre), "r": seen.node(found.radius), "sense": found.sense}


def coils(seen: SeenStudy) -> Iterator[Part]:
    """Torsion springs and rotary dampers, at the hinge of the second body."""
    for element in drawn_as(seen.study.problem, "coil"):
        names = [name for name in reversed(element["between"]) if name in seen.study.system.bodies]
        yield {"kind": element.kind, "at": seen.at(hinge(seen, names[0]))}


def hinge(seen: SeenStudy, body: str) -> Vector:
    """Where a body is hinged, else its centre of mass."""
    for element in drawn_as(seen.study.problem, "pivot", "pin", "weld"):
        for ref in element.values.get("points") or (element["point"],):
            if ref.body == body:
                return seen.geometry.where(ref)
    return seen.geometry.center(body)


def gravity(seen: SeenStudy) -> Iterator[Part]:
    """The direction of gravity."""
    for element in seen.study.problem.of_kind("gravity"):
        yield {"along": seen.at(pair(element["direction"]))}


KINDS: Mapping[str, Callable[[SeenStudy], Iterator[Part]]] = {
    of.__name__: of for of in (bodies, points, lines, circles, links, cords, coils, gravity)
}
