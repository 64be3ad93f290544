"""The force where the bodies meet, and beside it the couple that keeps one from turning against the other."""

from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.constraints import AngleJoin, Element, Force, Geometry, Joint, couples, pair_of_forces


def _forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    first, second = (ref.body for ref in element["points"])
    first, second = (first, second) if second is not None else (second, first)
    return (*pair_of_forces(element, geometry), *couples(element["couple"], second, first, "ground", geometry))


def _angles(element: Element) -> tuple[AngleJoin, ...]:
    first, second = element["points"]
    offset = scalar(element["angle"]) if element["angle"] is not None else None
    if second.body is None:
        return (AngleJoin(None, first.body, None if offset is None else -offset),)
    return (AngleJoin(first.body, second.body, offset),)


JOINT = Joint(_forces, joins=lambda element: (tuple(element["points"]),), angles=_angles)
