"""An applied couple."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import Sym, neg
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import Bodies, Element, Scope, turns


def _other_body(element: Element, scope: Scope, bodies: Bodies) -> None:
    if element["on"] == element["reaction_on"]:
        raise element.error(f"acts on “{element['on']}” and reacts on it as well", "name another body.")


def _told(element: Element, problem: Problem) -> str:
    return "" if element["couple"] in (Sym(element.name), neg(Sym(element.name))) else "_named"


KIND = element(
    __name__,
    "an applied couple, counter-clockwise positive",
    rules=(turns("on"), turns("reaction_on"), _other_body),
    drawn="turn",
    told=_told,
    on="body: the body that it acts on",
    couple="torque, of speeds: its torque",
    reaction_on="body, optional: the body that feels the opposite couple; absent: an outside agent",
)
