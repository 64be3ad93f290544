"""The force that drives a point along a direction."""

from rbpsym.field import Vector
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.constraints import Element, Force, Geometry, Joint, Scalar, opposed, symbol
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.system import rotated


def _along(element: Element, geometry: Geometry) -> Vector:
    along = pair(element["along"])
    return rotated(along.x, along.y, geometry.angle(element["of"])) if element["of"] else along


def _gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    place = geometry.where(element["point"]) - geometry.origin(element["of"])
    return ((_along(element, geometry).dot(place) - scalar(element["distance"]), "driven"),)


def _force(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """On the point; the opposite one on the body along which it is driven, if there is one."""
    ref, push = element["point"], _along(element, geometry) * symbol(element.name)
    ends = ((body, geometry.where(ref), ref.label) for body in (ref.body, element["of"]))
    return opposed(element.name, ends, push, outside="agent", unknowns=(element.name,))


JOINT = Joint(_force, gaps=_gaps)
