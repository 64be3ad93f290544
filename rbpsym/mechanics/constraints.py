"""What each kind of constraint says: which points and angles it joins, and its unknown forces.

A new kind is a new entry of `JOINTS`: the forces by which it keeps its conditions, and these.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.field import EX, EY, UNITY, Scalar, Vector, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics import strings
from rbpsym.mechanics.contacts import couples, curve_gaps, holding_forces, meeting, meshing_force, normal_forces, taken
from rbpsym.mechanics.geometry import Geometry, pair
from rbpsym.mechanics.system import Force, opposed, rotated
from rbpsym.statement.curves import toucher
from rbpsym.statement.model import Element, Line, PointRef


class AngleJoin(Frozen):
    """angle(second) - angle(first) = offset; first None means the ground; offset None: as it starts."""

    first: str | None
    second: str
    offset: Scalar | None


class Touch(Frozen):
    """A point that lies on a line."""

    point: PointRef
    line: Line
    side: str


def _none(element: Element, geometry: Geometry | None = None) -> tuple:
    return ()


class Joint(Frozen):
    """A kind of constraint: its forces, and what it asks for.

    `joins`: points that coincide; `angles` that are tied; `touches`: points on fixed lines;
    `gaps`: (value, what it is) of further quantities of position that vanish; `rates`: (unknown,
    factor) of unknown forces whose power per unit of force, times the factor, vanishes: a
    condition for the speeds; `taken`: what is positive where the sides and the ways of strings are those that the
    sample state shows. The forces of a one-sided constraint can push (or pull) only.
    """

    forces: Callable[[Element, Geometry], tuple[Force, ...]]
    joins: Callable[[Element], tuple[tuple[PointRef | None, PointRef], ...]] = _none
    angles: Callable[[Element], tuple[AngleJoin, ...]] = _none
    touches: Callable[[Element], tuple[Touch, ...]] = _none
    gaps: Callable[[Element, Geometry], tuple[tuple[Scalar, str], ...]] = _none
    rates: Callable[[Element, Geometry], tuple[tuple[str, Scalar], ...]] = _none
    taken: Callable[[Element, Geometry], tuple[Scalar, ...]] = taken
    is_one_sided: bool = False

    def fixed_lines(self, element: Element) -> tuple[tuple[str, Line], ...]:
        """(body, fixed line that it touches); none for other curves and other kinds."""
        if element.values.get("line") is None or element["of"] is not None:
            return ()
        return ((toucher(element), element["line"]),)


def unknown(element: Element) -> tuple[Vector, tuple[str, str]]:
    """The unknown force N of a joint as a vector N_x i + N_y j, with its component names."""
    names = (f"{element.name}_x", f"{element.name}_y")
    return EX * symbol(names[0]) + EY * symbol(names[1]), names


def _pivot_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    ref = element["point"]
    vector, names = unknown(element)
    return (Force(element.name, ref.body, "ground", geometry.where(ref), vector, unknowns=names, where=ref.label),)


def _pair_of_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """The force on the second body, and its reaction on the first if that is a body.

    Each acts at the body's own point: where the condition is not an identity of the poses, the two
    points coincide only on the motions that it allows, and on these the pair does no work by form.
    """
    first, second = element["points"]
    vector, names = unknown(element)
    ends = ((ref.body, geometry.where(ref), ref.label) for ref in ((first, second) if second.body is None else (second, first)))
    return opposed(element.name, ends, vector, unknowns=names)


def _weld_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """The force where the bodies meet, and beside it the couple that keeps one from turning against the other."""
    first, second = (ref.body for ref in element["points"])
    first, second = (first, second) if second is not None else (second, first)
    return (*_pair_of_forces(element, geometry), *couples(element["couple"], second, first, "ground", geometry))


def _weld_angles(element: Element) -> tuple[AngleJoin, ...]:
    first, second = element["points"]
    offset = scalar(element["angle"]) if element["angle"] is not None else None
    if second.body is None:
        return (AngleJoin(None, first.body, None if offset is None else -offset),)
    return (AngleJoin(first.body, second.body, offset),)


def _touches(element: Element) -> tuple[Touch, ...]:
    """A point of a body on a fixed line."""
    if element["line"] is None or element["of"] is not None:
        return ()
    return (Touch(element["point"], element["line"], element.values.get("side", "auto")),)


def _curve_gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    if element.values.get("curve") is not None:
        return tuple((gap, "gap") for gap in curve_gaps(element, geometry))
    return () if "point" in element.values and _touches(element) else ((meeting(element, geometry).gap, "gap"),)


def _slips(element: Element, geometry: Geometry) -> tuple[tuple[str, Scalar], ...]:
    """What is held by friction does not slip: the power of the friction vanishes."""
    return ((element["friction"], UNITY),)


def _slider_angles(element: Element) -> tuple[AngleJoin, ...]:
    return (AngleJoin(element["of"], element["point"].body, None),)


def _string_gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    found = strings.gap(element, geometry)
    return () if found is None else ((found, "length"),)


def _driven_gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    place = geometry.where(element["point"]) - geometry.origin(element["of"])
    return ((_driven_along(element, geometry).dot(place) - scalar(element["distance"]), "driven"),)


def _driven_along(element: Element, geometry: Geometry) -> Vector:
    along = pair(element["along"])
    return rotated(along.x, along.y, geometry.angle(element["of"])) if element["of"] else along


def _driving_force(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """On the point; the opposite one on the body along which it is driven, if there is one."""
    ref, push = element["point"], _driven_along(element, geometry) * symbol(element.name)
    ends = ((body, geometry.where(ref), ref.label) for body in (ref.body, element["of"]))
    return opposed(element.name, ends, push, outside="agent", unknowns=(element.name,))


def _driven_angles(element: Element) -> tuple[AngleJoin, ...]:
    return (AngleJoin(element["of"], element["body"], scalar(element["angle"])),)


def _driving_couple(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """On the body that is turned; the opposite one on the body that turns it, if one does."""
    return couples(element.name, element["body"], element["of"], "agent", geometry)


JOINTS: Mapping[str, Joint] = {
    "pivot": Joint(_pivot_forces, joins=lambda e: ((_fixed(e), e["point"]),)),
    "pin": Joint(_pair_of_forces, joins=lambda e: (tuple(e["points"]),)),
    "weld": Joint(_weld_forces, joins=lambda e: (tuple(e["points"]),), angles=_weld_angles),
    "contact": Joint(normal_forces, touches=_touches, gaps=_curve_gaps, is_one_sided=True),
    "guide": Joint(normal_forces, touches=_touches, gaps=_curve_gaps),
    "slider": Joint(normal_forces, touches=_touches, gaps=_curve_gaps, angles=_slider_angles),
    "touch": Joint(normal_forces, gaps=_curve_gaps, is_one_sided=True),
    "rolling": Joint(holding_forces, gaps=_curve_gaps, rates=_slips, is_one_sided=True),
    "gear": Joint(meshing_force, gaps=_curve_gaps, rates=lambda e, geometry: ((e.name, UNITY),)),
    "sticking": Joint(holding_forces, touches=_touches, gaps=_curve_gaps, rates=_slips, is_one_sided=True),
    "string": Joint(strings.pulls, gaps=_string_gaps, rates=strings.speeds_along, taken=strings.spans, is_one_sided=True),
    "link": Joint(strings.pulls, gaps=_string_gaps, rates=strings.speeds_along, taken=strings.spans),  # a string that may push
    "prescribed": Joint(_driving_force, gaps=_driven_gaps),
    "prescribed-angle": Joint(_driving_couple, angles=_driven_angles),
}


def _fixed(element: Element) -> PointRef | None:
    at = element["at"]
    return None if at is None else PointRef(f"{element.name} support", at=at)
