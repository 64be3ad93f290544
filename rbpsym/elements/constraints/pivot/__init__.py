"""A point of a body held at a fixed place, or at one that is moved."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import names
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import COMPONENTS, Bodies, Element, Scope, on_a_body


def _place(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """Where the pose puts the point; None if only the mechanics can tell."""
    point, placed = element["point"], bodies[element["point"].body].placed
    if element["at"] is not None:
        return element
    if placed is None:
        raise element.error(f"does not say where “{point.label}” is held", 'add at = ["0", "0"]')
    if placed[0] != point.point:
        return element
    moving = sorted((names(placed[1][0]) | names(placed[1][1])) & set(scope.coordinates))
    if moving:
        fault = f"holds “{point.label}”, but the pose lets it move with “{moving[0]}”"
        raise element.error(fault, 'say where it is held: at = ["0", "0"]')
    return element.with_values(at=placed[1])


def _told(element: Element, problem: Problem) -> str:
    ends, at = {"ground", element["point"].body}, element["at"] or ()
    rough = any(ends == {*each["between"]} for each in problem.of_kind("resisting-couple"))
    return "_rough" * rough + "_moved" * any("t" in names(part) for part in at)


KIND = element(
    __name__,
    "a point of a body is held at a fixed place, free to turn there",
    unknowns=COMPONENTS,
    rules=(on_a_body("point"), _place),
    holds="joint",
    drawn="pivot",
    told=_told,
    point="point: the point that is held",
    at="pair of length, of time, optional: where it is held; absent: where the body's pose puts it",
)
