"""The unknown force at a point that is held."""

from rbpsym.mechanics.constraints import ORIGIN, Element, Force, Geometry, Joint, PointRef, joining


def _force(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    ref = element["point"]
    return joining(element, (ref.body, geometry.where(ref), ref.label), (None, ORIGIN, ""))


def _joins(element: Element) -> tuple[tuple[PointRef | None, PointRef], ...]:
    support = None if element["at"] is None else PointRef(f"{element.name} support", at=element["at"])
    return ((support, element["point"]),)


JOINT = Joint(_force, joins=_joins)
