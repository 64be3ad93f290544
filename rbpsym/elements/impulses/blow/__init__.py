"""A given impulse."""

from rbpsym.elements.kinds import element
from rbpsym.statement.premises import sign_of
from rbpsym.statement.rules import Bodies, Element, Scope


def _strikes(element: Element, scope: Scope, bodies: Bodies) -> None:
    if element["on"].body is None:
        raise element.error("strikes a fixed place", "name a point of a body.")
    if all(sign_of(part) == "zero" for part in element["impulse"]):
        raise element.error("has no impulse at all", 'write impulse = ["J", "0"]')


KIND = element(
    __name__,
    "a given impulse at a point",
    rules=(_strikes,),
    drawn="blow",
    on="point: the point of a body that is struck",
    impulse="pair of impulse: its components in space",
)
