"""Where points are, written in the poses as the author gave them: the rows of geometric conditions."""

from __future__ import annotations

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.contacts import meeting, rim_of, touching_point
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import components
from rbpsym.notation import tree as t
from rbpsym.statement.model import Body, Element, PointRef

Pair = tuple[t.Node, t.Node]


def coordinates_of(draft: Draft, ref: PointRef) -> Pair | None:
    """Coordinates of a point as they follow from the pose as the author gave it, nothing worked out."""
    if ref.body is None:
        return ref.at
    body = draft.study.problem.body(ref.body)
    if body.placed is None or "cm" in (ref.point, body.placed[0]):
        return None
    x, y = _local_difference(body, ref.point)
    if (x or y) and body.angle is None:
        return None
    angle = body.angle if body.angle is not None else t.ZERO
    (px, py), cos, sin = body.placed[1], t.Fn("cos", angle), t.Fn("sin", angle)
    return (t.add(px, *_signed(x, cos), *_signed(y, sin, -1)), t.add(py, *_signed(x, sin), *_signed(y, cos)))


def _local_difference(body: Body, point: str) -> tuple[Scalar, Scalar]:
    (ax, ay), (bx, by) = body.points[point], body.points[body.placed[0]]
    return scalar(ax) - scalar(bx), scalar(ay) - scalar(by)


def _signed(length: Scalar, function: t.Node, sign: int = 1) -> tuple[t.Node, ...]:
    return (t.mul(present(length * sign), function),) if length else ()


def meeting_rows(draft: Draft, element: Element) -> list[t.Node]:
    """Two points in one place: the rows that do not repeat themselves."""
    rows: list[t.Node] = []
    for first, second in JOINTS[element.kind].joins(element):
        ends = [None if ref is None else coordinates_of(draft, ref) for ref in (second, first)]
        if None not in ends:
            rows += [t.equation(a, b) for a, b in zip(*ends, strict=True) if a != b]
    return rows


def line_rows(draft: Draft, element: Element) -> list[t.Node]:
    """A point on a fixed line."""
    rows = []
    for touch in JOINTS[element.kind].touches(element):
        at = coordinates_of(draft, touch.point)
        if at is not None:
            left = t.add(t.mul(touch.line.a, at[0]), t.mul(touch.line.b, at[1]))
            rows.append(t.equation(left, touch.line.c))
    return rows


def distance_rows(draft: Draft, element: Element) -> list[t.Node]:
    """A round body at the distance of its rim from a line; a distance from the middle of a circle; a string's length."""
    if element.kind == "string":
        ends = [coordinates_of(draft, turn.center) for turn in element["path"]]
        return [] if element["length"] is None or None in ends else [_apart(*ends, element["length"])]
    if element.values.get("circle") is not None:
        return _from_circle(draft, element)
    if element.values.get("rim") is not None and element["of"] is None:
        return _from_line(draft, element)
    return []


def _apart(first: Pair, second: Pair, distance: t.Node) -> t.Node:
    """(x₁ - x₂)² + (y₁ - y₂)² = d²."""
    gaps = [t.add(a, t.neg(b)) for a, b in zip(first, second, strict=True)]
    return t.equation(t.add(*(t.power(_grouped(gap), 2) for gap in gaps if gap != t.ZERO)), t.power(distance, 2))


def _grouped(node: t.Node) -> t.Node:
    return t.Group(node) if isinstance(node, (t.Add, t.Neg, t.Mul)) else node


def _from_circle(draft: Draft, element: Element) -> list[t.Node]:
    here, middle = (coordinates_of(draft, ref) for ref in (touching_point(element), element["circle"]))
    if here is None or middle is None:
        return []
    reach = scalar(element["radius"]) + rim_of(element) * _side(draft, element)
    return [_apart(here, middle, draft.show(reach))]


def _side(draft: Draft, element: Element) -> int:
    """1 outside of the circle, -1 inside."""
    stated = element.values.get("side", "outside")
    if stated != "auto":
        return 1 if stated == "outside" else -1
    geometry = geometry_of(draft.study.system)
    met, middle = meeting(element, geometry), geometry.where(element["circle"])
    return geometry.sign(met.normal.dot(met.place - middle)) or 1


def _from_line(draft: Draft, element: Element) -> list[t.Node]:
    at = coordinates_of(draft, touching_point(element))
    if at is None:
        return []
    a, b, c = components(element["line"])
    geometry = geometry_of(draft.study.system)
    met = meeting(element, geometry)
    side = 1 if geometry.sign(met.normal.x * a + met.normal.y * b) >= 0 else -1
    left = t.add(*(t.mul(draft.show(part), _summed(x)) for part, x in ((a, at[0]), (b, at[1])) if part))
    return [t.equation(left, draft.show(c + rim_of(element) * side))]


def _summed(node: t.Node) -> t.Node:
    return t.Group(node) if isinstance(node, t.Add) else node
