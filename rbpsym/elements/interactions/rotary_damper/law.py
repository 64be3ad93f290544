"""The couple c times the rate of the angle, against it."""

from rbpsym.mechanics.interactions import Element, Force, Law, Setting, couples, scalar, spin


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    first, second = element["between"]
    rate = spin(second, setting) - spin(first, setting)
    return couples(element, first, second, -(scalar(element["coefficient"]) * rate), setting)


LAW = Law(_forces)
