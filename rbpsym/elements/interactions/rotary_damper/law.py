"""The couple c times the rate of the angle, against it."""

from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, couples, scalar, spin


def _forces(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    first, second = element["between"]
    rate = spin(second, setting) - spin(first, setting)
    return couples(element, first, second, -(scalar(element["coefficient"]) * rate), setting)


LAW = Law(_forces)
