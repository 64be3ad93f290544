"""Equilibria, their stability, and the frequencies of small oscillations about them.

At rest the generalized forces Q(q) vanish. What is said of the motion close to such a place follows from the linear
equations there (`linear`): where no speed occurs in them, the squares of the angular frequencies are the roots of
det(K - λ M).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.errors import NoNumber
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import Matrix
from rbpsym.mechanics.linear import Linear, Nature, gains_nothing, is_symmetric, linearized, nature, squares
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.rest import Rest, rooted
from rbpsym.mechanics.stability import stable_where
from rbpsym.mechanics.system import System


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """A position of rest: `at` the coordinates that are not arbitrary; `frequencies_squared` of the
    normal modes that have a closed form, the slowest first (none where speeds damp the motion); `nature` what is
    proved of its stability; where that is open, it is stable `where` this is positive and unstable where it is
    negative (None: no such formula). It exists where `valid` is met."""

    at: Mapping[str, Scalar]
    frequencies_squared: tuple[Scalar, ...]
    linear: Linear
    nature: Nature
    where: Scalar | None = None
    valid: tuple[Demand, ...] = ()

    @property
    def stable(self) -> bool | None:
        """None if it is not decided."""
        return self.nature.stable

    @property
    def stiffness(self) -> Matrix:
        """K."""
        return self.linear.stiffness

    @property
    def inertia(self) -> Matrix:
        """M."""
        return self.linear.inertia

    @property
    def facts(self) -> dict[str, object]:
        """Where it is, how tied coordinates move with the others there, and what it asks of the parameters."""
        return {"at": self.at, "tied": self.linear.tied, "valid": self.valid}


def equilibria(system: System, dynamics: Dynamics, assumptions: Assumptions, found: Rest) -> tuple[Equilibrium, ...]:
    """The positions of rest, and what is said of the motion close to them."""
    return tuple(_describe(system, dynamics, *place, assumptions) for place in found.places)


def _describe(system: System, dynamics: Dynamics, at, valid, assumptions: Assumptions) -> Equilibrium:
    names, assumptions = system.independent, assuming(assumptions, valid)
    still = dict.fromkeys(system.speeds, NOTHING)

    def there(value: Scalar) -> Scalar:
        return rooted(substitute(substitute(value, still), at), assumptions)

    linear = linearized(system, dynamics, assumptions, there)
    held = _held(linear.stiffness, names, at)
    found = nature(system, dynamics, linear, held, assumptions)
    where = None
    if found.proved == "open":
        is_kept = is_symmetric(held) and gains_nothing(system, dynamics, assumptions)
        where = stable_where(held, assumptions) if is_kept else found.conditions[0] if len(found.conditions) == 1 else None
        decided = None if where is None else sign(where, assumptions).kind
        if decided == "negative" or (decided == "positive" and is_kept):
            found, where = Nature("minimum" if decided == "positive" else "unstable"), None
    even = () if linear.is_damped else linear.factors
    frequencies = [square for powers in even for square in squares(powers, assumptions)]
    return Equilibrium(at, _slowest_first(frequencies, system), linear, found, where, valid)


def _held(stiffness: Matrix, names, at) -> Matrix:
    """Over the coordinates that are not arbitrary."""
    kept = [k for k, n in enumerate(names) if n in at]
    return tuple(tuple(stiffness[i][j] for j in kept) for i in kept)


def _slowest_first(found: list[Scalar], system: System) -> tuple[Scalar, ...]:
    """In the order of their sizes at sample numbers; as they are where these give none."""
    numbers = sample(system.problem)
    try:
        return tuple(sorted(found, key=lambda square: number(square, numbers)))
    except NoNumber:
        return tuple(found)
