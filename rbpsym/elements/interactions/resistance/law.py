"""−size(v) along the velocity of a point."""

from rbpsym.mechanics.interactions import Law, Setting, resisted_by, unknowns_in
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _force(element: Element, setting: Setting) -> tuple[Force, ...]:
    found, ref = resisted_by(element, setting), element["on"]
    where, vector, unknowns = setting.where(ref), found.way * found.push, unknowns_in(element, found.push, setting)
    return (Force(element.name, ref.body, "medium", where, vector, unknowns=unknowns, law=element.kind, where=ref.label),)


LAW = Law(_force)
