"""Momentum, energy and moments taken over the mass itself, torques by components.

Independent of L = R × P + I ω, of König's theorem and of Steiner's: a body is expanded in the
coordinates of its mass elements, and only its mass moments of order 0, 1 and 2 about the
origin of its own frame are used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction

from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, UNITY, Scalar, Vector, cosine, derivative, is_zero, remembered, short, sine, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.integration import antiderivative
from rbpsym.field.normal import without_even_roots
from rbpsym.mechanics.system import Force, System
from rbpsym.statement.model import MassElement


def primitive(value: Scalar, name: str) -> Scalar:
    """An antiderivative with respect to a symbol. Raises Undecided where none is known, or its derivative is another."""
    found = antiderivative(value, name)
    if found is None:
        raise Undecided("no closed form of the integral was found")
    if not is_zero(derivative(found, name) - value):
        raise Undecided("the derivative of what is proposed as the integral is another function")
    return found


WEIGHTS = (lambda x, y: UNITY, lambda x, y: x, lambda x, y: y, lambda x, y: x * x + y * y)


def mass_moments(system: System, body: str) -> tuple[Scalar, ...]:
    """∫dm, ∫x dm, ∫y dm and ∫r² dm about the origin of the body's frame."""
    shape, own = system.problem.body(body).shape, system.bodies[body].inertia
    if shape.elements:
        return moments_of(shape.elements)
    second = own.moment + own.mass * (own.x * own.x + own.y * own.y)
    return own.mass, own.mass * own.x, own.mass * own.y, second


def moments_of(elements: Iterable[MassElement]) -> tuple[Scalar, ...]:
    """The same of elements of mass."""
    elements = tuple(elements)
    return tuple(sum((_spread(item, weight) for item in elements), NOTHING) for weight in WEIGHTS)


@remembered
def _spread(element: MassElement, weight: Callable[[Scalar, Scalar], Scalar]) -> Scalar:
    """∫ dm × the weight over one element, from the innermost variable outwards; each antiderivative is differentiated."""
    value = scalar(element.density) * scalar(element.measure) * weight(scalar(element.x), scalar(element.y))
    for item in reversed(element.ranges):
        found = primitive(_plain(value), item.variable)
        ends = (substitute(found, {item.variable: scalar(end)}) for end in (item.upper, item.lower))
        value = next(ends) - next(ends)
    return _plain(value) * element.sign


def _plain(value: Scalar) -> Scalar:
    """Even powers of roots worked out, so that an antiderivative can be proposed."""
    return short(Scalar(without_even_roots(value.num), value.den))


def angular_momentum(system: System, body: str, origin: Vector) -> Scalar:
    """∫ (r - origin) × v dm with r = A + x e₁ + y e₂, v = dr/dt, in Cartesian components."""
    place, speed, first, second, spin = _frame(system, body)
    zeroth, first_x, first_y, second_moment = mass_moments(system, body)
    ax, ay = place.x - origin.x, place.y - origin.y
    vx, vy = speed.x, speed.y
    ex, ey = first
    fx, fy = second
    sx, sy = first_x * ex + first_y * fx, first_x * ey + first_y * fy
    constant = (ax * vy - ay * vx) * zeroth
    linear = spin * (ax * sx + ay * sy) + (sx * vy - sy * vx)
    return constant + linear + spin * second_moment


def kinetic_energy(system: System, body: str) -> Scalar:
    """½ ∫ v² dm with v = V_A + ω k × (x e₁ + y e₂)."""
    _, speed, first, second, spin = _frame(system, body)
    zeroth, first_x, first_y, second_moment = mass_moments(system, body)
    sx, sy = first_x * first[0] + first_y * second[0], first_x * first[1] + first_y * second[1]
    square = (speed.x * speed.x + speed.y * speed.y) * zeroth
    mixed = spin * (speed.y * sx - speed.x * sy) * 2
    return (square + mixed + spin * spin * second_moment) * Fraction(1, 2)


Axis = tuple[Scalar, Scalar]


def _frame(system: System, body: str) -> tuple[Vector, Vector, Axis, Axis, Scalar]:
    state = system.bodies[body]
    place, angle = state.pose.origin, state.pose.angle
    c, s = cosine(angle), sine(angle)
    return place, place.rate(system.scope.rates), (c, s), (-s, c), state.omega


def moment_about(moments: tuple[Scalar, ...], point: tuple[Scalar, Scalar]) -> Scalar:
    """∫ |r - p|² dm for a point p of the frame in which these are the moments of the mass."""
    zeroth, first_x, first_y, second_moment = moments
    x, y = point
    return second_moment - (first_x * x + first_y * y) * 2 + zeroth * (x * x + y * y)


def torque(forces: Iterable[Force], origin: Vector) -> Scalar:
    """Σ (x - x₀) F_y - (y - y₀) F_x + couple."""
    total = NOTHING
    for force in forces:
        x, y = force.point.x - origin.x, force.point.y - origin.y
        total = total + x * force.vector.y - y * force.vector.x + force.couple
    return total


def power(system: System, forces: Iterable[Force]) -> Scalar:
    """Σ F·v + couple ω, v being the velocity of the body's point where the force acts."""
    total = NOTHING
    for force in forces:
        state = system.bodies[force.on]
        lever = force.point - state.pose.origin
        speed = state.pose.origin.rate(system.scope.rates)
        vx, vy = speed.x - state.omega * lever.y, speed.y + state.omega * lever.x
        total = total + force.vector.x * vx + force.vector.y * vy + force.couple * state.omega
    return total
