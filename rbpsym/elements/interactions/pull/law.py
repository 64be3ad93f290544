"""F along the line of two points; F d is its potential energy if it is constant."""

from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, Scalar, ends, scalar, stretch, sure_distance


def _forces(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    return ends(element, setting, stretch(element, setting)[0] * scalar(element["size"]))


def _energy(element: Element, setting: LawSetting) -> Scalar | None:
    size = scalar(element["size"])
    return size * stretch(element, setting)[1] if setting.is_constant(size) else None


LAW = Law(_forces, _energy, sure_distance)
