"""Kinetic and potential energy, and the momentum of each body.

T = ½ M V² + ½ I_cm ω² (König); L = R × P + I_cm ω about a fixed origin.
Kleppner & Kolenkow 7.2-7.4.
"""

from __future__ import annotations

from fractions import Fraction

from rbpsym.errors import LimitError, there
from rbpsym.field import NOTHING, Scalar, Vector, at_most, depends_on, derivative, is_zero, short, substitute, symbol
from rbpsym.field.evaluate import time_derivative
from rbpsym.field.integration import antiderivative
from rbpsym.field.roots import without_even_roots
from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.interactions import LAWS, stretch
from rbpsym.mechanics.placing import where_in
from rbpsym.mechanics.system import BodyState, System
from rbpsym.statement.model import Element

HALF = Fraction(1, 2)
MOST_PRODUCTS = 2_000_000  # to put accelerations into the rate of an energy


def translational_energy(state: BodyState) -> Scalar:
    """½ M V² of a body."""
    return short(state.mass * state.velocity.dot(state.velocity) * HALF)


def rotational_energy(state: BodyState) -> Scalar:
    """½ I_cm ω² of a body."""
    return state.moment * state.omega**2 * HALF


def kinetic_energy(system: System) -> tuple[Scalar, Scalar]:
    """(translational, rotational) kinetic energy of all bodies."""
    states = system.bodies.values()
    parts = [sum(map(of, states), NOTHING) for of in (translational_energy, rotational_energy)]
    return short(parts[0]), short(parts[1])


def stretched(system: System, spring: Element) -> Scalar:
    """The distance between the ends of a spring."""
    return substitute(stretch(spring, setting_of(system, where_in(system)))[1], system.dependent)


def potentials(system: System) -> dict[str, Scalar | None]:
    """Potential energy of each interaction; None for one that has none."""
    setting = setting_of(system, where_in(system))
    found = {}
    for element in system.problem.interactions:
        value = LAWS[element.kind].potential(element, setting)
        found[element.name] = None if value is None else substitute(value, system.dependent)
    return found


def potential_energy(system: System) -> Scalar | None:
    """The sum of the potential energies, None if an interaction has none."""
    values = list(potentials(system).values())
    return None if any(value is None for value in values) else short(without_even_roots(sum(map(there, values), NOTHING)))


def orbital_momentum(state: BodyState, origin: Vector) -> Scalar:
    """R × P about a fixed origin, counter-clockwise positive."""
    return short(state.mass * (state.center - origin).cross(state.velocity))


def spin_momentum(state: BodyState) -> Scalar:
    """I_cm ω."""
    return state.moment * state.omega


def is_conserved(system: System, dynamics: Dynamics, value: Scalar) -> bool | None:
    """Whether d(value)/dt = 0 along the motion (None if accelerations are not known explicitly).

    The rate of an energy is the power of M q̈ - f, Σ q̇ (M q̈ - f), which needs no solution.
    """
    rate = time_derivative(value, system.scope)
    if is_zero(rate - _power(system, dynamics)):
        return True
    if dynamics.accelerations is None:
        return None
    try:
        with at_most(MOST_PRODUCTS):
            return is_zero(substitute(rate, dynamics.accelerations))
    except LimitError:
        return None


def _power(system: System, dynamics: Dynamics) -> Scalar:
    """Σ q̇ (M q̈ - f), which vanishes on the motion."""
    gained = (p * symbol(a) for p, a in zip(_momenta(system, dynamics), system.accelerations, strict=True))
    done = (symbol(speed) * force for speed, force in zip(system.speeds, dynamics.forcing, strict=True))
    return sum(gained, NOTHING) - sum(done, NOTHING)


def effective_potential(system: System, dynamics: Dynamics) -> Scalar | None:
    """-∫ Q dq of generalized forces Q that depend on position alone and have one, whatever interactions they come from.

    Q_i = f_i + d(Σ M_ij q̇_j)/dt - ∂T/∂q_i at kept speeds.
    """
    if not (system.independent and all(dynamics.ideal.values())) or system.implicit:
        return None
    names, speeds = system.independent, [symbol(speed) for speed in system.speeds]
    momenta, moving = _momenta(system, dynamics), _moving(system, dynamics)
    forces, found = [], NOTHING
    for name, forcing, momentum in zip(names, dynamics.forcing, momenta, strict=True):
        carried = sum((derivative(momentum, other) * v for other, v in zip(names, speeds, strict=True)), NOTHING)
        forces.append(short(forcing + carried - derivative(moving, name)))
        part = antiderivative(forces[-1] + derivative(found, name), name)
        if part is None or any(depends_on(forces[-1], other) for other in ("t", *system.speeds)):
            return None
        found = found - part
    closed = all(is_zero(force + derivative(found, name)) for name, force in zip(names, forces, strict=True))
    return found if closed else None


def _momenta(system: System, dynamics: Dynamics) -> list[Scalar]:
    """Σ M_ij q̇_j."""
    speeds = [symbol(speed) for speed in system.speeds]
    return [sum((m * v for m, v in zip(row, speeds, strict=True)), NOTHING) for row in dynamics.mass_matrix]


def _moving(system: System, dynamics: Dynamics) -> Scalar:
    """½ Σ M_ij q̇_i q̇_j."""
    return sum((p * symbol(v) for p, v in zip(_momenta(system, dynamics), system.speeds, strict=True)), NOTHING) * HALF


def first_integral(system: System, dynamics: Dynamics) -> Scalar | None:
    """A constant of the motion quadratic in the speeds: T + U, or T - ∫Q dq, relative to supports that are driven ½ Σ M q̇ q̇ -
    ∫Q dq (Jacobi's integral); None where masses are not stated.

    Goldstein, Classical Mechanics, 2.7.
    """
    if system.problem.unstated:
        return None
    potential = None if system.has_clock else potential_energy(system)
    if potential is None:
        potential = effective_potential(system, dynamics)
    if potential is None:
        return None
    moving = _moving(system, dynamics) if system.has_clock else sum(kinetic_energy(system), NOTHING)
    energy = short(moving + potential)
    return energy if is_conserved(system, dynamics, energy) is not False else None
