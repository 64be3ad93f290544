"""The couple k (angle − rest angle)."""

from rbpsym.mechanics.interactions import HALF, Element, Force, Law, LawSetting, Scalar, angle, couples, scalar


def _twist(element: Element, setting: LawSetting) -> Scalar:
    first, second = element["between"]
    return angle(second, setting) - angle(first, setting) - scalar(element["rest_angle"])


def _forces(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    first, second = element["between"]
    return couples(element, first, second, -(scalar(element["stiffness"]) * _twist(element, setting)), setting)


LAW = Law(_forces, lambda element, setting: scalar(element["stiffness"]) * _twist(element, setting) ** 2 * HALF)
