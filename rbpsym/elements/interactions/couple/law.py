"""A given couple, and its opposite on the body that exerts it; −τ φ is its potential energy if it is constant."""

from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.interactions import Law, Setting, angle, couples
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _couple(element: Element, setting: Setting) -> tuple[Force, ...]:
    return couples(element, element["reaction_on"] or "agent", element["on"], scalar(element["couple"]), setting)


def _energy(element: Element, setting: Setting) -> Scalar | None:
    couple = scalar(element["couple"])
    turned = angle(element["on"], setting) - angle(element["reaction_on"], setting)
    return -(couple * turned) if setting.is_constant(couple) else None


LAW = Law(_couple, _energy)
