"""A given couple, and its opposite on the body that exerts it; −τ φ is its potential energy if it is constant."""

from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, Scalar, angle, couples, scalar


def _couple(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    return couples(element, element["reaction_on"] or "agent", element["on"], scalar(element["couple"]), setting)


def _energy(element: Element, setting: LawSetting) -> Scalar | None:
    couple = scalar(element["couple"])
    turned = angle(element["on"], setting) - angle(element["reaction_on"], setting)
    return -(couple * turned) if setting.is_constant(couple) else None


LAW = Law(_couple, _energy)
