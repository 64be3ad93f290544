"""Equilibria, their stability, and the frequencies of small oscillations about them.

At rest the generalized forces Q(q) vanish. What is said of the motion close to such a place follows from the linear
equations there (`linear`): where no speed occurs in them, the squares of the angular frequencies are the roots of
det(K - λ M).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.roots import simplified_root
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import Matrix, determinant, short
from rbpsym.mechanics.linear import LAMBDA, Linear, Nature, gains_nothing, is_symmetric, linearized, nature
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.rest import Rest, rooted
from rbpsym.mechanics.roots import numerator_factors
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
    squares = () if linear.is_damped else _frequencies(linear.stiffness, linear.inertia, assumptions)
    return Equilibrium(at, _slowest_first(squares, system), linear, found, where, valid)


def _held(stiffness: Matrix, names, at) -> Matrix:
    """Over the coordinates that are not arbitrary."""
    kept = [k for k, n in enumerate(names) if n in at]
    return tuple(tuple(stiffness[i][j] for j in kept) for i in kept)


def _slowest_first(squares: tuple[Scalar, ...], system: System) -> tuple[Scalar, ...]:
    """In the order of their sizes at sample numbers; as they are where these give none."""
    numbers = sample(system.problem)
    try:
        return tuple(sorted(squares, key=lambda square: number(square, numbers)))
    except (ValueError, ZeroDivisionError, KeyError):
        return squares


def _frequencies(stiffness: Matrix, inertia: Matrix, assumptions: Assumptions) -> tuple[Scalar, ...]:
    """The non-zero roots λ of det(K - λ M) that have a closed form, factor by factor."""
    unknown = symbol(LAMBDA)
    size = range(len(stiffness))
    if all(is_zero(matrix[i][j]) for matrix in (stiffness, inertia) for i in size for j in size if i != j):
        return _distinct(short(stiffness[k][k] / inertia[k][k]) for k in size if not is_zero(stiffness[k][k]))
    matrix = tuple(tuple(stiffness[i][j] - unknown * inertia[i][j] for j in size) for i in size)
    try:
        whole = determinant(matrix)
        found: list[Scalar] = []
        for factor in numerator_factors(whole):
            found += _roots_of(Scalar(factor), assumptions)
    except RbpsymError:
        return ()
    return tuple(found)


def _distinct(values: Iterable[Scalar]) -> tuple[Scalar, ...]:
    found: list[Scalar] = []
    for value in values:
        if not any(is_zero(value - other) for other in found):
            found.append(value)
    return tuple(found)


def _roots_of(factor: Scalar, assumptions: Assumptions) -> list[Scalar]:
    """Roots in λ of a linear or quadratic factor (λ itself is left out: no restoring force)."""
    c = substitute(factor, {LAMBDA: NOTHING})
    slope = derivative(factor, LAMBDA)
    if not slope or is_zero(c):
        return []
    curvature = derivative(slope, LAMBDA)
    if not curvature:
        return [short(-(c / slope))]
    if depends_on(curvature, LAMBDA):
        return []
    a, b = curvature / 2, substitute(slope, {LAMBDA: NOTHING})
    spread = simplified_root(short(b * b - 4 * a * c), lambda name: assumptions.sign_of(name) == "positive")
    return [(-b - spread) / (2 * a), (-b + spread) / (2 * a)]
