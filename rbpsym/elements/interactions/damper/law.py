"""c times the rate of the distance, against it."""

from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, ends, scalar, stretch


def _forces(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    unit, _ = stretch(element, setting)
    first, second = element["between"]
    rate = unit.dot(setting.velocity(second) - setting.velocity(first))
    return ends(element, setting, unit * (scalar(element["coefficient"]) * rate))


LAW = Law(_forces)
