"""k (distance − natural length) along the line of its ends; k times the vector between them where it is slack at no length."""

from rbpsym.mechanics.interactions import HALF, Element, Force, Law, LawSetting, Scalar, ends, scalar, stretch, sure_distance


def _forces(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    k, natural = scalar(element["stiffness"]), scalar(element["natural_length"])
    if not natural:
        first, second = element["between"]
        return ends(element, setting, (setting.where(second) - setting.where(first)) * k)
    unit, distance = stretch(element, setting)
    return ends(element, setting, unit * (k * (distance - natural)))


def _energy(element: Element, setting: LawSetting) -> Scalar:
    k, natural = scalar(element["stiffness"]), scalar(element["natural_length"])
    if not natural:
        first, second = element["between"]
        apart = setting.where(second) - setting.where(first)
        return k * apart.dot(apart) * HALF
    _, distance = stretch(element, setting)
    return k * (distance - natural) ** 2 * HALF


LAW = Law(_forces, _energy, sure_distance)
