"""Forces and couples against a motion: size(v), of which the sense is that of the motion when it begins.

On a point -size(v) V/v with its velocity V relative to the medium; between two bodies -size(ω) against the rate at which the
second turns relative to the first. Along one direction v = σ ṡ with the sense σ = ±1, which has to last; where the size is a
multiple of v, or the direction changes, nothing has to. Kleppner & Kolenkow 3.6; Meriam & Kraige, Statics, 6/6 and 6/8.
"""

from __future__ import annotations

from collections.abc import Callable

from rbpsym.elements.interactions import LETTERS
from rbpsym.errors import StatementError
from rbpsym.field import UNITY, Scalar, Vector, depends_on, is_zero, root, substitute, symbol, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.geometry import pair
from rbpsym.statement.model import Element, PointRef

SENSES = {"ccw": 1, "cw": -1}


class Resisted(Frozen):
    """What is resisted: its `rate` along a direction (None for a couple), the sense that it has to keep (0: any will do), and
    the force or couple `push` along the direction, which is negative where the rate is positive."""

    rate: Scalar
    way: Vector | None
    sense: int
    push: Scalar

    @property
    def slip(self) -> Scalar:
        """The speed in its sense."""
        return self.rate * (self.sense or 1)

    @property
    def size(self) -> Scalar:
        """The magnitude of the force or couple, where the motion has its sense."""
        return -self.push * (self.sense or 1)


def resisted(
    element: Element,
    velocity: Callable[[PointRef], Vector],
    omega: Callable[[str], Scalar],
    sign: Callable[[Scalar], int],
) -> Resisted:
    """What an element of such a kind resists. Raises StatementError where it starts from rest and nothing says which way."""
    rate, way = _moving(element, velocity, omega)
    pushes = {sense: _push(element, rate, sense) for sense in (1, -1)}
    has_way = way is None or len(way.parts) == 1
    if not has_way or is_zero(pushes[1] - pushes[-1]):
        return Resisted(rate, way, 0, pushes[1])
    sense = _stated(element, way, sign) or sign(rate)
    if not sense:
        cure = 'sense = "ccw" or "cw"' if way is None else 'toward = ["1", "0"], to the side to which it goes'
        raise StatementError(
            f"the {element.kind.replace('-', ' ')} “{element.name}” is against a motion, but at the start nothing moves there",
            instead=f"say which way it will move, {cure}.",
            place=element.place,
        )
    return Resisted(rate, way, sense, pushes[sense])


def _moving(
    element: Element, velocity: Callable[[PointRef], Vector], omega: Callable[[str], Scalar]
) -> tuple[Scalar, Vector | None]:
    """(rate, its direction)."""
    if element.kind == "resisting-couple":
        first, second = map(omega, element["between"])
        return second - first, None
    relative = (velocity(element["on"]) - pair(element["medium"])).settled()
    if len(relative.parts) == 1:
        [(angle, rate)] = relative.parts.items()
        return rate, Vector({angle: UNITY})
    speed = root(tidy(relative.dot(relative)))
    return speed, relative * speed.inverse() if relative.parts else relative


def _push(element: Element, rate: Scalar, sense: int) -> Scalar:
    """-size(v)/v rate, in which v is the rate in its sense."""
    letter, size = LETTERS[element.kind], scalar(element["size"])
    factor = size / symbol(letter)
    if not depends_on(factor, letter):
        return -(factor * rate)
    return substitute(size, {letter: rate * sense}) * -sense


def _stated(element: Element, way: Vector | None, sign: Callable[[Scalar], int]) -> int:
    if way is None:
        return SENSES.get(element["sense"], 0)
    return 0 if element["toward"] is None else sign(way.dot(pair(element["toward"])))
