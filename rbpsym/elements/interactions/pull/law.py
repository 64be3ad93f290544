"""F along the line of two points; F d is its potential energy if it is constant."""

from rbpsym.mechanics.interactions import Element, Force, Law, Scalar, Setting, ends, scalar, stretch, sure_distance


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    return ends(element, setting, stretch(element, setting)[0] * scalar(element["size"]))


def _energy(element: Element, setting: Setting) -> Scalar | None:
    size = scalar(element["size"])
    return size * stretch(element, setting)[1] if setting.is_constant(size) else None


LAW = Law(_forces, _energy, sure_distance)
