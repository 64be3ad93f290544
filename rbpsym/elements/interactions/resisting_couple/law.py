"""−size(ω) in the sense in which the second body turns, seen from the first."""

from rbpsym.frozen import replace
from rbpsym.mechanics.interactions import Law, Setting, couples, resisted_by, unknowns_in
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _couples(element: Element, setting: Setting) -> tuple[Force, ...]:
    push = resisted_by(element, setting).push
    pairs = couples(element, *element["between"], push, setting)
    return tuple(replace(force, unknowns=unknowns_in(element, push, setting)) for force in pairs)


LAW = Law(_couples)
