"""The couple k (angle − rest angle)."""

from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.interactions import HALF, Law, Setting, angle, couples
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _twist(element: Element, setting: Setting) -> Scalar:
    first, second = element["between"]
    return angle(second, setting) - angle(first, setting) - scalar(element["rest_angle"])


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    return couples(element, *element["between"], -(scalar(element["stiffness"]) * _twist(element, setting)), setting)


LAW = Law(_forces, lambda element, setting: scalar(element["stiffness"]) * _twist(element, setting) ** 2 * HALF)
