"""Steady motions, of what keeps a momentum from its start, as a circular orbit, or beside what goes on with an acceleration,
as a pendulum on a cart that is pulled; and the small oscillations about them.

With the speeds that the momenta give, if it needs them, q̈ is a function of the one coordinate that is left: it is steady where
that vanishes, and swings about there with ϑ² = -dq̈/dq (Goldstein, Classical Mechanics, 3.6; Kleppner & Kolenkow, 10.5).
"""

from __future__ import annotations

from fractions import Fraction

from rbpsym.decide.rooted import neat
from rbpsym.errors import StatementError
from rbpsym.field import (
    NOTHING,
    PI,
    Scalar,
    derivative,
    function,
    is_zero,
    names_in,
    root,
    short,
    substitute,
    symbol,
    without_even_roots,
)
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand, existence, possible, settle
from rbpsym.mechanics.oscillation import Equilibrium, where_stable
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.study import Study


class Orbit(Frozen):
    """Where a coordinate stays on a steady motion, the square of the frequency about it, and what that asks for."""

    place: Scalar
    square: Scalar
    valid: tuple[Demand, ...]


def turns(study: Study, name: str) -> bool:
    """Whether the speed that another coordinate has at the start drives this one, so that it is no motion about a rest: a
    coordinate on which no force depends, as the angle of an orbit, keeps going."""
    start, gains = study.system.scope.start, study.dynamics.accelerations or {}
    at_rest = {name, *(each for item in study.equilibria for each in item.at)}
    is_known = study.equilibria or study.kept_speeds
    going = [n for n in study.system.independent if is_known and n not in at_rest and start.get(f"{n}_dot", NOTHING)]
    still = {f"{n}_dot": NOTHING for n in study.system.independent if n not in going}
    gained = short(substitute(gains.get(f"{name}_ddot", NOTHING), still))
    return any(not is_zero(derivative(gained, f"{n}_dot")) for n in going)


def swinging(study: Study) -> Equilibrium | None:
    """The one place of rest that is stable, or is so for some parameters; None where there are several, or it turns."""
    known = () if study.at_start or study.system.has_clock else study.equilibria
    found = [item for item in known if item.stable] or [item for item in map(where_stable, known) if item.stable]
    return found[0] if len(found) == 1 and not any(turns(study, name) for name in found[0].at) else None


def gain(study: Study, name: str) -> Scalar | None:
    """The acceleration at rest of a coordinate, with the speeds that kept momenta give, where it is a function of its place
    alone and no speed of its own acts on it in first order; None if it is not."""
    known = (study.dynamics.accelerations or {}).get(f"{name}_ddot")
    found = None if known is None or study.ties else substitute(known, study.kept_speeds if [*study.squares] == [name] else {})
    still = {f"{name}_dot": NOTHING}
    if found is None or not is_zero(substitute(derivative(found, f"{name}_dot"), still)):
        return None
    found = short(without_even_roots(substitute(found, still)))
    return None if names_in(found) & {*study.system.scope.rates, *study.system.speeds} - {name} else found


def orbits(study: Study, name: str) -> list[Orbit]:
    """The steady motions about which it swings, as far as they have a closed form."""
    found, gained, given = list[Orbit](), gain(study, name) or NOTHING, study.assumptions
    for place in zeros(gained, name):
        lower, upper = given.range_of(name)
        within = [Demand((place - end) * side) for end, side in ((lower, 1), (upper, -1)) if end is not None]
        if is_zero(substitute(Scalar(gained.den), {name: place})):  # it is no function there
            continue
        square = neat(-substitute(derivative(gained, name), {name: place}), given)
        valid = settle([*existence(place), *within, Demand(square)], given)
        found += [] if valid is None else [Orbit(neat(place, given), square, valid)]
    return found


TIMES = (Fraction(1), Fraction(2), Fraction(1, 2), Fraction(4))  # n, with a small whole 4/n


class Swing(Frozen):
    """The place of rest, the squares of ϑ and of the modulus k, 2/n, and what they ask of the parameters; `height`: U - U at rest
    of what swings in one time, however far."""

    rest: Scalar
    rate_squared: Scalar
    modulus_squared: Scalar
    part: Fraction
    valid: tuple[Demand, ...]
    height: Scalar | None = None

    def time(self, study: Study, quarters: int) -> Scalar:
        """The time of so many quarters of the period."""
        rate = neat(root(short(self.rate_squared)), study.assumptions)
        return (function("elliptic_k", self.modulus_squared) if self.height is None else PI / 2) * quarters / rate


def _isochrone(study: Study, name: str) -> Swing | None:
    """The swing from rest in which V = U - U(q*) is ½ ϑ² s², s being ∫ √M dq: V'² = 2 ϑ² M V, as for a bead on a cycloid
    (Huygens); None where V is none such, or not the same on both sides."""
    start, potential, items = study.system.scope.start, study.potential, study.equilibria
    item = next((one for one in items if one.stable and set(one.at) == {name} and one.frequencies_squared), None)
    if item is None or potential is None or study.system.has_clock or start.get(f"{name}_dot", NOTHING):
        return None
    rest, [square], [[mass]] = item.at[name], item.frequencies_squared, study.dynamics.mass_matrix
    height = short(potential - substitute(potential, {name: rest}))
    mirrored, slope = substitute(height, {name: rest * 2 - symbol(name)}), derivative(height, name)
    if not (is_zero(mirrored - height) and is_zero(slope * slope - square * mass * height * 2)):
        return None
    return Swing(rest, square, NOTHING, Fraction(0), (*item.valid, Demand(start[name] - rest, "!=")), height)


def swing_of(study: Study, name: str) -> Swing:
    """The swing of a coordinate from its start. Raises StatementError where it is none of that form."""
    square, start = study.squares.get(name), study.system.scope.start
    if square is None or study.at_start or name not in start:
        raise StatementError(f"the speed of “{name}” is not known as a function of its place from the start")
    slope, third = (derivative(square, name), derivative(derivative(derivative(square, name), name), name))
    squared = (-third / slope).number() if slope else None
    times = next((n for n in TIMES if n * n == squared), None)
    if times is None and (found := _isochrone(study, name)):
        return found
    if times is None:
        raise StatementError(f"the swing of “{name}” has no period that is known in closed form or by an elliptic integral")
    items = [item for item in map(where_stable, study.equilibria) if item.stable and set(item.at) == {name}]
    item = next((one for one in items if is_zero(substitute(slope, {name: one.at[name]}))), None)
    if item is None:
        raise StatementError(f"no stable equilibrium of “{name}” is known, about which it would swing")
    rest = item.at[name]
    rate = short(-substitute(derivative(slope, name), {name: rest}) / 2)
    away = function("sin", (start[name] - rest) * times / 2)
    speed = start.get(f"{name}_dot", NOTHING)
    modulus = short(away * away + speed * speed * times**2 / (rate * 4))
    never = StatementError(f"“{name}” does not swing: it goes round and round")
    asked = possible((Demand(1 - modulus), *item.valid), study.assumptions, never)
    return Swing(rest, rate, modulus, 2 / times, asked)


def quarters_to(study: Study, name: str, place: Scalar) -> int | None:
    """After how many quarters of the period from rest it is there first: at the place of rest, or at the other turning point."""
    start = study.system.scope.start
    if not is_zero(start.get(f"{name}_dot", NOTHING)):
        return None
    rest = swing_of(study, name).rest
    known = {1: rest, 2: rest * 2 - start[name], 4: start[name]}
    return next((quarters for quarters, there in known.items() if is_zero(place - there)), None)
