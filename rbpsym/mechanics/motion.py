"""Motion from the start state: squares of speeds and forces as functions of position, and the work of every force.

Of each body: Translational work ∫F·dR_cm and rotational work ∫τ_cm dφ of every force on every body.

The integrand for a coordinate q is F·∂R_cm/∂q and τ_cm ∂φ/∂q (for the time, where something is
driven, F·∂R_cm/∂t and τ_cm ∂φ/∂t); unknown forces stay as symbols
in it. The value is the integral from the start along the motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from rbpsym.field import NOTHING, UNITY, Poly, Scalar, Vector, atoms, is_zero, short, symbol
from rbpsym.field.calculus import depends_on, derivative, function, names_in, substitute
from rbpsym.field.exponentials import with_exponentials_joined
from rbpsym.field.integration import definite
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen
from rbpsym.mechanics.dynamics import Dynamics, torque_about_center
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.energy import is_conserved
from rbpsym.mechanics.system import BodyState, Force, System

Values = Mapping[str, Scalar]


def speed_squared(system: System, dynamics: Dynamics, integral: Scalar | None) -> dict[str, Scalar]:
    """For each coordinate for which it is a function of position: the square of its speed.

    For several degrees of freedom, for each coordinate whose acceleration depends on itself alone; then,
    for the one that is left, from the first integral. If there is none, for the one that is left when conserved momenta
    give the other speeds. Coordinates without a start are left out.
    """
    alone = len(system.independent) == 1 and integral is not None
    found = {} if alone else _decoupled(system, dynamics)
    left = [name for name in system.independent if name not in found]
    if len(left) == 1 and integral is not None:
        square = from_integral(system, integral, left[0], found)
        found |= {} if square is None else {left[0]: square}
    return found or _reduced(system, dynamics, integral)


def conserved_momenta(system: System, dynamics: Dynamics, integral: Scalar) -> dict[str, Scalar]:
    """∂E/∂q̇ by coordinate, where it is what it was at the start (Goldstein, Classical Mechanics, 2.6)."""
    momenta = {name: derivative(integral, f"{name}_dot") for name in system.independent}
    known = (name in system.scope.start for name in system.coordinates)
    return {n: p for n, p in momenta.items() if is_conserved(system, dynamics, p)} if all(known) else {}


def kept_speeds(system: System, dynamics: Dynamics, integral: Scalar | None) -> dict[str, Scalar]:
    """The speeds that conserved momenta give in terms of the one that is left; none if more are left."""
    kept = {} if integral is None or dynamics.accelerations is None else conserved_momenta(system, dynamics, integral)
    if len(kept) != len(system.independent) - 1 or not kept:
        return {}
    rows = [momentum - substitute(momentum, system.scope.start) for momentum in kept.values()]
    solution = solve_linear(rows, [f"{name}_dot" for name in kept])
    return {} if solution.free or solution.left else solution.values


def _reduced(system: System, dynamics: Dynamics, integral: Scalar | None) -> dict[str, Scalar]:
    """q̇² of the one coordinate whose speed the conserved momenta leave, from the first integral."""
    kept = kept_speeds(system, dynamics, integral)
    if not kept or integral is None:
        return {}
    [name] = [name for name in system.independent if f"{name}_dot" not in kept]
    now, speed = substitute(integral, kept), f"{name}_dot"
    rest, slope = substitute(now, {speed: NOTHING}), substitute(derivative(now, speed), {speed: NOTHING})
    half_mass = derivative(derivative(now, speed), speed) / 2
    if not is_zero(slope) or any(depends_on(value, n) for value in (rest, half_mass) for n in system.coordinates if n != name):
        return {}
    start = substitute(integral, system.scope.start)
    return {name: short(without_even_roots((start - rest) / half_mass))}


def from_integral(system: System, integral: Scalar, name: str, known: Mapping[str, Scalar]) -> Scalar | None:
    """q̇² from (½ m(q) q̇² + U(q)) at start and now, the squares of the other speeds being known."""
    speed = f"{name}_dot"
    if any(n not in system.scope.start for n in (name, *system.coordinates, "t") if n == name or depends_on(integral, n)):
        return None
    now: Scalar | None = integral
    for other, square in known.items():
        now = now if now is None else _without_speed(_at_rest(now, other, square), f"{other}_dot", square)
    if now is None:
        return None
    half_mass = derivative(derivative(now, speed), speed) / 2
    rest = substitute(now, {speed: NOTHING})
    if not is_zero(now - half_mass * symbol(speed) ** 2 - rest):
        return None
    start = substitute(integral, system.scope.start)
    return short(without_even_roots((start - rest) / half_mass))


def _at_rest(value: Scalar, name: str, square: Scalar) -> Scalar:
    """The value with a speed that is known to stay zero."""
    return value if square else substitute(value, {f"{name}_dot": NOTHING})


def _decoupled(system: System, dynamics: Dynamics) -> dict[str, Scalar]:
    found = dict[str, Scalar]()
    for name in system.independent:
        acceleration = (dynamics.accelerations or {}).get(f"{name}_ddot")
        if acceleration is not None and name in system.scope.start:
            square = _square(system, acceleration, name)
            found |= {} if square is None else {name: square}
    return found


def _square(system: System, gain: Scalar, name: str) -> Scalar | None:
    """u = q̇² of q̈ = c(q) + b(q) q̇², by du/dq = 2 c + 2 b u; None for another acceleration. (Where b is constant and c too, as of
    drag, the motion is told as a function of the time.)"""
    speed, begin = f"{name}_dot", system.scope.start[name]
    bend = derivative(derivative(gain, speed), speed) / 2
    push = short(gain - bend * symbol(speed) ** 2)
    if any(depends_on(part, n) for part in (bend, push) for n in (*system.coordinates, *system.speeds, "t") if n != name):
        return None
    if bend and not any(depends_on(part, name) for part in (bend, push)):
        return None
    grown = definite(bend * 2, name, begin, symbol(name))
    dies = None if grown is None else function("exp", short(-grown)) if bend else UNITY
    gained = None if dies is None else definite(push * dies * 2, name, begin, symbol(name))
    first = system.scope.start.get(speed, NOTHING)
    return None if gained is None or dies is None else with_exponentials_joined(short((first * first + gained) / dies))


def along_motion(value: Scalar, squares: Mapping[str, Scalar]) -> Scalar | None:
    """The value with even powers of speeds replaced; None if a speed remains."""
    left: Scalar | None = value
    for name, square in squares.items():
        left = None if left is None else _without_speed(left, f"{name}_dot", square)
    return None if left is None or any(name.endswith(("_dot", "_ddot")) for name in names_in(left)) else short(left)


def _without_speed(value: Scalar, speed: str, square: Scalar) -> Scalar | None:
    index = atoms.intern("symbol", speed)
    if index not in value.atoms():
        return value
    top = _replaced(value.num, index, square)
    low = _replaced(value.den, index, square)
    return None if top is None or low is None else top / low


def _replaced(poly: Poly, index: int, square: Scalar) -> Scalar | None:
    total = NOTHING
    for power, part in poly.by_power(index).items():
        if power % 2 or power < 0:
            return None
        total = total + Scalar(part) * square ** (power // 2)
    return total


class Work(Frozen):
    """One half of a force's work on a body.

    `parts`: integrand by coordinate (only those that are not identically zero); `value`: the
    work done since the start, None if it can't be given in closed form.
    """

    parts: Mapping[str, Scalar]
    value: Scalar | None


class ForceWork(Frozen):
    """Both halves of the work of one force on one body."""

    force: str
    on: str
    translational: Work
    rotational: Work


def works(system: System, reactions: Values, squares: Values) -> tuple[ForceWork, ...]:
    """The ledger of works, force by force and body by body."""
    merged: dict[tuple[str, str], list[Force]] = {}
    for force in system.forces:
        merged.setdefault((force.name, force.on), []).append(force)
    return tuple(_work(system, forces, reactions, squares) for forces in merged.values())


def _work(system: System, forces: list[Force], reactions: Values, squares: Values) -> ForceWork:
    state = system.bodies[forces[0].on]
    push = sum((force.vector for force in forces), Vector({}))
    turn = sum((torque_about_center(force, state) for force in forces), NOTHING)
    return ForceWork(
        forces[0].name,
        forces[0].on,
        _half(system, lambda q: push.dot(_center_partial(state, q, system)), reactions, squares),
        _half(system, lambda q: turn * _angle_partial(state, q, system), reactions, squares),
    )


def _center_partial(state: BodyState, name: str, system: System) -> Vector:
    """∂R_cm/∂q, through ∂V/∂q̇ (the same, and right when speeds depend on each other)."""
    if name == "t":
        return state.velocity.substitute(dict.fromkeys(system.speeds, NOTHING))
    return state.velocity.derivative(f"{name}_dot")


def _angle_partial(state: BodyState, name: str, system: System) -> Scalar:
    if name == "t":
        return substitute(state.omega, dict.fromkeys(system.speeds, NOTHING))
    return derivative(state.omega, f"{name}_dot")


def _half(system: System, integrand: Callable[[str], Scalar], reactions: Values, squares: Values) -> Work:
    names = (*system.independent, "t") if system.has_clock else system.independent
    parts = {name: short(integrand(name)) for name in names}
    parts = {name: part for name, part in parts.items() if not is_zero(part)}
    return Work(parts, _value(system, parts, reactions, squares))


def _value(system: System, parts: Values, reactions: Values, squares: Values) -> Scalar | None:
    if not parts:
        return NOTHING
    total = NOTHING
    for name, part in parts.items():
        known = along_motion(substitute(part, reactions), squares)
        if known is None or name not in system.scope.start or not _of_one(known, name, system):
            return None
        done = definite(known, name, system.scope.start[name], symbol(name))
        if done is None:
            return None
        total = total + done
    return short(total)


def _of_one(value: Scalar, name: str, system: System) -> bool:
    return not any(depends_on(value, other) for other in (*system.coordinates, "t") if other != name)


def power(system: System, item: ForceWork) -> Scalar:
    """The rate at which both halves together do work."""
    total = NOTHING
    for half in (item.translational, item.rotational):
        for name, part in half.parts.items():
            total = total + part * system.scope.rates[name]
    return total


def net_power(system: System, forces: Iterable[Force]) -> Scalar:
    """Σ F·V + τ_cm ω: the rate at which forces work, the translational and the rotational part of it."""
    total = NOTHING
    for force in forces:
        state = system.bodies[force.on]
        total = total + force.vector.dot(state.velocity) + torque_about_center(force, state) * state.omega
    return total


def resting(system: System, dynamics: Dynamics) -> dict[str, Scalar]:
    """The coordinates with their starts, and their speeds with zero, that nothing moves from there, whatever the others do; none
    where nothing else moves: what is all at rest may be meant to leave it."""
    start, gains = system.scope.start, dynamics.accelerations or {}
    names = [n for n in system.independent if {n, f"{n}_dot"} <= start.keys() and is_zero(start[f"{n}_dot"])]
    while names:
        still = {n: start[n] for n in names} | {f"{n}_dot": NOTHING for n in names}
        kept = [n for n in names if _vanishes(gains.get(f"{n}_ddot", symbol(n)), still)]
        if kept == names:
            return still if len(names) < len(system.independent) else {}
        names = kept
    return {}


def _vanishes(gain: Scalar, there: dict[str, Scalar]) -> bool:
    """Whether an acceleration is known there, and is zero."""
    try:
        return is_zero(substitute(gain, there))
    except ZeroDivisionError:
        return False
