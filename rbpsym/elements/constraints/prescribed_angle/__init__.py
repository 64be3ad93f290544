"""A body whose angle is a given function of time."""

from rbpsym.elements.kinds import element
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import Bodies, Element, Scope, turns


def _against_another(element: Element, scope: Scope, bodies: Bodies) -> None:
    if element["of"] == element["body"]:
        raise element.error(f"turns “{element['body']}” against itself", "name another body under “of”, or none.")


def _told(element: Element, problem: Problem) -> str:
    return "_against" if element["of"] else ""


KIND = element(
    __name__,
    "a body is turned: its angle is a given function of time; an unknown couple drives it",
    unknowns={"{name}": "torque"},
    rules=(_against_another, turns("body")),
    drawn="spin",
    told=_told,
    body="body: the body that is turned",
    angle="angle, of time: its angle, a function of the time t",
    of="body, optional: the body against which it is turned, which feels the opposite couple (a motor on it); absent: the "
    "angle is from +x, and an outside agent turns it",
)
