"""The force normal to the line, and the couple that keeps the angle."""

from rbpsym.mechanics.constraints import AngleJoin, Element
from rbpsym.mechanics.contacts import normal_forces, touching


def _angles(element: Element) -> tuple[AngleJoin, ...]:
    return (AngleJoin(element["of"], element["point"].body, None),)


JOINT = touching(normal_forces, angles=_angles)
