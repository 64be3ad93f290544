"""Steady motions, of what keeps a momentum from its start, as a circular orbit, or beside what goes on with an acceleration,
as a pendulum on a cart that is pulled; and the small oscillations about them.

With the speeds that the momenta give, if it needs them, q̈ is a function of the one coordinate that is left: it is steady where
that vanishes, and swings about there with ϑ² = -dq̈/dq (Goldstein, Classical Mechanics, 3.6; Kleppner & Kolenkow, 10.5).
"""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra import NOTHING, Scalar, derivative, is_zero, names_in, substitute
from rbpsym.algebra.roots import without_even_roots
from rbpsym.equality.rooted import neat
from rbpsym.mechanics.demands import Demand, existence, settle
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.oscillation import Equilibrium, where_stable
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.study import Study


@dataclass(frozen=True, slots=True)
class Orbit:
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
    found, gained, given = [], gain(study, name), study.assumptions
    for place in zeros(gained, name) if gained is not None else ():
        lower, upper = given.range_of(name)
        within = [Demand((place - end) * side) for end, side in ((lower, 1), (upper, -1)) if end is not None]
        square = neat(-substitute(derivative(gained, name), {name: place}), given)
        valid = settle([*existence(place), *within, Demand(square)], given)
        found += [] if valid is None else [Orbit(neat(place, given), square, valid)]
    return found
