"""An applied force."""

from rbpsym.elements.kinds import element
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import Bodies, Element, Scope, on_a_body


def _frame(element: Element, scope: Scope, bodies: Bodies) -> None:
    name = element["on"].body
    if element["frame"] == "body" and bodies[name].shape.kind == "particle":
        raise element.error(f"is fixed in “{name}”, a particle, which has no angle", 'use frame = "space".')


def _told(element: Element, problem: Problem) -> str:
    return "_turning" if element["frame"] == "body" else ""


KIND = element(
    __name__,
    "an applied force, its components in space or in the frame of the body",
    rules=(on_a_body("on"), _frame),
    drawn="arrow",
    told=_told,
    on="point: the point of a body at which it acts",
    force="pair of force, of speeds: its components",
    frame="one of space | body = space: where the components are fixed",
)
