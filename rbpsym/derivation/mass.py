"""Momentum, energy and moments taken over the mass itself, torques by components.

Independent of L = R × P + I ω, of König's theorem and of Steiner's: a body is expanded in the
coordinates of its mass elements, and only its mass moments of order 0, 1 and 2 about the
origin of its own frame are used.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.inertia import POWERS, total_moment
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force, System


@dataclass(frozen=True, slots=True)
class Moments:
    """∫dm, ∫x dm, ∫y dm, ∫r² dm in the body frame."""

    zeroth: Scalar
    x: Scalar
    y: Scalar
    second: Scalar


def mass_moments(system: System, body: str) -> Moments:
    """The moments of a body's mass about the origin of its frame."""
    shape = system.problem.body(body).shape
    if shape.elements:
        return Moments(*(total_moment(shape.elements, power) for power in POWERS))
    own = system.bodies[body].inertia
    second = own.moment + own.mass * (own.x * own.x + own.y * own.y)
    return Moments(own.mass, own.mass * own.x, own.mass * own.y, second)


def angular_momentum(system: System, body: str, origin: Vector) -> Scalar:
    """∫ (r - origin) × v dm with r = A + x e₁ + y e₂, v = dr/dt, in Cartesian components."""
    place, speed, first, second, spin = _frame(system, body)
    m = mass_moments(system, body)
    ax, ay = place.x - origin.x, place.y - origin.y
    vx, vy = speed.x, speed.y
    ex, ey = first
    fx, fy = second
    sx, sy = m.x * ex + m.y * fx, m.x * ey + m.y * fy
    constant = (ax * vy - ay * vx) * m.zeroth
    linear = spin * (ax * sx + ay * sy) + (sx * vy - sy * vx)
    return constant + linear + spin * m.second


def kinetic_energy(system: System, body: str) -> Scalar:
    """½ ∫ v² dm with v = V_A + ω k × (x e₁ + y e₂)."""
    _, speed, first, second, spin = _frame(system, body)
    m = mass_moments(system, body)
    sx, sy = m.x * first[0] + m.y * second[0], m.x * first[1] + m.y * second[1]
    square = (speed.x * speed.x + speed.y * speed.y) * m.zeroth
    mixed = spin * (speed.y * sx - speed.x * sy) * 2
    return (square + mixed + spin * spin * m.second) * Fraction(1, 2)


def _frame(system: System, body: str):
    from rbpsym.algebra.trig import cosine, sine

    state = system.bodies[body]
    place, angle = state.pose.origin, state.pose.angle
    c, s = cosine(angle), sine(angle)
    return place, vector_rate(place, system.scope), (c, s), (-s, c), state.omega


def moment_about(study: Study, body: str, point: tuple[Scalar, Scalar]) -> Scalar:
    """∫ |r - p|² dm for a point p of the body frame."""
    m = mass_moments(study.system, body)
    x, y = point
    return m.second - (m.x * x + m.y * y) * 2 + m.zeroth * (x * x + y * y)


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
        speed = vector_rate(state.pose.origin, system.scope)
        vx, vy = speed.x - state.omega * lever.y, speed.y + state.omega * lever.x
        total = total + force.vector.x * vx + force.vector.y * vy + force.couple * state.omega
    return total
