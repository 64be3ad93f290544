"""Two bodies that collide."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import RESTITUTION, Bodies, Element, Scope, bodies_joined, restitution


def _two_bodies(element: Element, scope: Scope, bodies: Bodies) -> None:
    first, second = bodies_joined(element, "points")
    if first == second:
        raise element.error("is between points of one body", "name two bodies.")


KIND = element(
    __name__,
    "two points of two bodies collide without friction; the unknown impulse pushes the second along the direction",
    unknowns={"{name}": "impulse"},
    rules=(_two_bodies, restitution),
    points="points: the two points that meet; of a round body its center will do",
    along="pair of number: unit vector of the normal, from the first to the second body",
    **RESTITUTION,
)
