"""c times the rate of the distance, against it."""

from rbpsym.mechanics.interactions import Element, Force, Law, Setting, ends, scalar, stretch


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    unit, _ = stretch(element, setting)
    first, second = element["between"]
    rate = unit.dot(setting.velocity(second) - setting.velocity(first))
    return ends(element, setting, unit * (scalar(element["coefficient"]) * rate))


LAW = Law(_forces)
