"""A point driven along a direction."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ONE, ZERO
from rbpsym.statement.curves import NORMAL
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import Bodies, Element, Scope, on_a_body


def _along_another(element: Element, scope: Scope, bodies: Bodies) -> None:
    if element["point"].body == element["of"]:
        raise element.error(f"drives a point of “{element['of']}” along that body itself", "name a point of another body.")


def _told(element: Element, problem: Problem) -> str:
    return "_along" if element["of"] else {(ONE, ZERO): "_right", (ZERO, ONE): "_up"}.get(element["along"], "")


KIND = element(
    __name__,
    "a point is driven along a direction: its place is a given function of time; an unknown force drives it",
    unknowns=NORMAL,
    rules=(on_a_body("point"), _along_another),
    drawn="driven",
    told=_told,
    point="point: the point that is driven",
    distance="length, of time: place along the direction, a function of the time t",
    along="pair of number = 1 | 0: unit vector of the direction",
    of="body, optional: the body along which it is driven, which feels the opposite force: direction and place are those in "
    "its frame; absent: in space, by an outside agent",
)
