"""The couple that turns a body; the opposite one on the body against which it is turned, if there is one."""

from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.constraints import AngleJoin, Element, Force, Geometry, Joint, couples


def _couple(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    return couples(element.name, element["body"], element["of"], "agent", geometry)


def _angles(element: Element) -> tuple[AngleJoin, ...]:
    return (AngleJoin(element["of"], element["body"], scalar(element["angle"])),)


JOINT = Joint(_couple, angles=_angles)
