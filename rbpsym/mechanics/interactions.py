"""What the law of an interaction says: its forces, and its potential energy where it has one.

The law of a kind is the `LAW` of the module `law` in its folder. Laws get the element, the positions of points and the
states of the bodies; they return the forces on each body.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from rbpsym.elements.interactions import INTERACTIONS, LETTERS
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import StatementError
from rbpsym.expr.tree import ONE
from rbpsym.field import (
    NOTHING,
    ORIGIN,
    UNITY,
    Scalar,
    Vector,
    depends_on,
    derivative,
    is_zero,
    names_in,
    root,
    substitute,
    symbol,
    tidy,
)
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.geometry import no_direction, pair
from rbpsym.mechanics.system import BodyState, Force, opposed
from rbpsym.statement.model import Element, PointRef

HALF = Fraction(1, 2)


class LawSetting(Frozen):
    """What a law may look at: positions and velocities of points, states of bodies, signs (`sign`: at the start), the names
    of unknown forces."""

    where: Callable[[PointRef], Vector]
    velocity: Callable[[PointRef], Vector]
    states: Mapping[str, BodyState]
    is_positive: Callable[[Scalar], bool | None]
    sign: Callable[[Scalar], int]
    unknowns: frozenset[str]
    is_constant: Callable[[Scalar], bool]


class Law(Frozen):
    """forces(element, setting); potential(element, setting) is None where there is none; `taken`: what is positive
    where the formula of the force holds."""

    forces: Callable[[Element, LawSetting], tuple[Force, ...]]
    potential: Callable[[Element, LawSetting], Scalar | None] = lambda element, setting: None
    taken: Callable[[Element, LawSetting], tuple[Scalar, ...]] = lambda element, setting: ()


LAWS: KindParts[Law] = KindParts(INTERACTIONS, "law", "LAW")


def stretch(element: Element, setting: LawSetting) -> tuple[Vector, Scalar]:
    """(unit vector from the first end to the second, their distance). Raises StatementError where they are one place."""
    first, second = element["between"]
    apart = (setting.where(second) - setting.where(first)).settled()
    if not apart.parts:
        raise no_direction(element, first.label, second.label)
    if len(apart.parts) == 1:
        [(angle, length)] = apart.parts.items()
        sign = -1 if setting.is_positive(length) is False else 1
        return Vector({angle: UNITY * sign}), length * sign
    distance = root(tidy(apart.dot(apart)))
    return apart * distance.inverse(), distance


def ends(element: Element, setting: LawSetting, pull: Vector) -> tuple[Force, ...]:
    """The pull on the first end (towards the second) and its opposite on the second."""
    both = ((ref.body, setting.where(ref), ref.label) for ref in element["between"])
    return opposed(element.name, both, pull, law=element.kind)


def sure_distance(element: Element, setting: LawSetting) -> tuple[Scalar, ...]:
    """The distance of the ends, if it is no root and the force hangs on its sign."""
    first, second = element["between"]
    is_line = len((setting.where(second) - setting.where(first)).settled().parts) == 1
    return (stretch(element, setting)[1],) if is_line and scalar(element.values.get("natural_length", ONE)) else ()


def couples(element: Element, first: str, second: str, on_second: Scalar, setting: LawSetting) -> tuple[Force, ...]:
    """A couple on the second body, and its opposite on the first."""
    pairs = ((second, first, on_second), (first, second, -on_second))
    return tuple(
        Force(element.name, name, other, setting.states[name].center, ORIGIN, couple, law=element.kind, where=f"{name}.cm")
        for name, other, couple in pairs
        if name in setting.states
    )


def angle(name: str, setting: LawSetting) -> Scalar:
    """Angle of a body, 0 for the ground."""
    return setting.states[name].pose.angle if name in setting.states else NOTHING


def spin(name: str, setting: LawSetting) -> Scalar:
    """Angular velocity of a body, 0 for the ground."""
    return setting.states[name].omega if name in setting.states else NOTHING


def resisted_by(element: Element, setting: LawSetting) -> Resisted:
    """What a resistance is against. Raises StatementError as `resisted`."""
    return resisted(element, setting.velocity, lambda name: spin(name, setting), setting.sign)


def unknowns_in(element: Element, push: Scalar, setting: LawSetting) -> tuple[str, ...]:
    """The unknown forces in a size. Raises StatementError where it is not linear in them."""
    found = tuple(sorted(names_in(push) & setting.unknowns))
    if any(names_in(derivative(push, name)) & setting.unknowns for name in found):
        raise StatementError(
            f"the size of “{element.name}” is not linear in the unknown forces {', '.join(found)}",
            instead="where the direction of the force is known, write its one component, or a multiple of a tension.",
            place=element.place,
        )
    return found


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
