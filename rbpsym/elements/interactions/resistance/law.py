"""−size(v) along the velocity of a point."""

from rbpsym.field import ORIGIN
from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, resisted_by, unknowns_in


def _force(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    found, ref = resisted_by(element, setting), element["on"]
    where, vector, unknowns = setting.where(ref), (found.way or ORIGIN) * found.push, unknowns_in(element, found.push, setting)
    return (Force(element.name, ref.body, "medium", where, vector, unknowns=unknowns, law=element.kind, where=ref.label),)


LAW = Law(_force)
