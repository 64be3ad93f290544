"""Mass, centre of mass and moment of inertia of a shape, by integration over its mass."""

from __future__ import annotations

from collections.abc import Iterable

from rbpsym.errors import StatementError, there
from rbpsym.expr.tree import Node
from rbpsym.field import NOTHING, UNITY, Scalar, cosine, sine, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.statement.model import Body, MassElement, PlacedShape, Shape
from rbpsym.statement.solids import integrate_ranges


class Inertia(Frozen):
    """mass; centre of mass (x, y) in the body frame; moment of inertia about the centre of mass.

    `about_origin` is ∫ dm r² about the origin of the body frame, None if the moment is given.
    """

    mass: Scalar
    x: Scalar
    y: Scalar
    moment: Scalar
    about_origin: Scalar | None = None


def inertia(body: Body) -> Inertia:
    """The inertia of a body. Raises StatementError if an integral can't be carried out."""
    shape = body.shape
    if shape.given_moment is not None or _has_given_part(shape):
        return _assembled(shape, body.mass)
    try:
        zeroth, x, y, second = (total_moment(shape.elements, power) for power in POWERS)
    except StatementError as error:
        raise error.at(body.place) from None
    mass = scalar(body.mass) if body.mass is not None else zeroth
    return _about_center(mass, (x, y), second)


def _about_center(mass: Scalar, first: tuple[Scalar, Scalar], second: Scalar) -> Inertia:
    """From ∫ x dm and ∫ y dm, and by Steiner's theorem I_cm = I_origin - M d².

    A body without mass has the origin of its frame for a centre; no equation depends on which.
    """
    if not mass:
        return Inertia(NOTHING, NOTHING, NOTHING, NOTHING, NOTHING)
    x, y = (tidy(value / mass) for value in first)
    return Inertia(mass, x, y, tidy(second - mass * (x * x + y * y)), second)


POWERS = ((), ("x",), ("y",), ("r", "r"))


class Moments(Frozen):
    """∫dm, ∫x dm, ∫y dm, ∫r² dm in the body frame."""

    zeroth: Scalar
    x: Scalar
    y: Scalar
    second: Scalar


def mass_moments(shape: Shape, own: Inertia) -> Moments:
    """The moments of a body's mass about the origin of its frame, from its shape and its inertia."""
    if shape.elements:
        return Moments(*(total_moment(shape.elements, power) for power in POWERS))
    second = own.moment + own.mass * (own.x * own.x + own.y * own.y)
    return Moments(own.mass, own.mass * own.x, own.mass * own.y, second)


def total_moment(elements: Iterable[MassElement], power: tuple[str, ...]) -> Scalar:
    """Σ over the elements of ∫ dm × 1, x, y or r² (power (), ("x",), ("y",), ("r", "r"))."""
    return tidy(sum((element_moment(element, power) for element in elements), NOTHING))


def element_moment(element: MassElement, power: tuple[str, ...]) -> Scalar:
    """∫ dm × the power over one element, its sign included."""
    x, y = scalar(element.x), scalar(element.y)
    weight = {(): UNITY, ("x",): x, ("y",): y}.get(power)
    weight = x * x + y * y if weight is None else weight
    integrand = tidy(scalar(element.density) * scalar(element.measure) * weight)
    return integrate_ranges(integrand, element) * element.sign


def _has_given_part(shape: Shape) -> bool:
    return any(part.shape.given_moment is not None or _has_given_part(part.shape) for part in shape.parts)


def _assembled(shape: Shape, mass: Node | None) -> Inertia:
    """From given moments and parts, by the parallel-axis theorem."""
    if shape.given_moment is not None:
        return Inertia(scalar(there(mass)), NOTHING, NOTHING, scalar(shape.given_moment))
    pieces = [_piece(part) for part in shape.parts]
    total = sum((m for m, *_ in pieces), NOTHING)
    x, y = (sum((p[0] * p[k] for p in pieces), NOTHING) for k in (1, 2))
    return _about_center(total, (x, y), sum((p[3] for p in pieces), NOTHING))


def _piece(part: PlacedShape) -> tuple[Scalar, Scalar, Scalar, Scalar]:
    """(mass, x, y of its centre, ∫ dm r² about the composite's origin), signed."""
    own = inertia(Body(part.name or "part", part.shape, part.mass))
    angle, sign = scalar(part.angle), -1 if part.removed else 1
    x = scalar(part.at[0]) + own.x * cosine(angle) - own.y * sine(angle)
    y = scalar(part.at[1]) + own.x * sine(angle) + own.y * cosine(angle)
    second = own.moment + own.mass * (x * x + y * y)
    if part.count is not None:  # all round the origin, which is their common centre
        return own.mass * sign * scalar(part.count), NOTHING, NOTHING, second * sign * scalar(part.count)
    return own.mass * sign, x, y, second * sign
