"""F along the line of two points; F d is its potential energy if it is constant."""

from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.interactions import Law, Setting, ends, stretch, sure_distance
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    return ends(element, setting, stretch(element, setting)[0] * scalar(element["size"]))


def _energy(element: Element, setting: Setting) -> Scalar | None:
    size = scalar(element["size"])
    return size * stretch(element, setting)[1] if setting.is_constant(size) else None


LAW = Law(_forces, _energy, sure_distance)
