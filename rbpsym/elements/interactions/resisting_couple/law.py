"""−size(ω) in the sense in which the second body turns, seen from the first."""

from rbpsym.frozen import replace
from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, couples, resisted_by, unknowns_in


def _couples(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    (first, second), push = element["between"], resisted_by(element, setting).push
    unknowns = unknowns_in(element, push, setting)
    return tuple(replace(force, unknowns=unknowns) for force in couples(element, first, second, push, setting))


LAW = Law(_couples)
