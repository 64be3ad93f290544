"""Equilibria, their stability, and the frequencies of small oscillations about them.

At rest the generalized forces Q(q) vanish. What is said of the motion close to such a place follows from the linear
equations there (`linear`): where no speed occurs in them, the squares of the angular frequencies are the roots of
det(K - λ M).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.roots import simplified_root, without_even_roots
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.equality.assumptions import Assumptions
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import Matrix, determinant, short
from rbpsym.mechanics.linear import LAMBDA, Linear, Nature, gains_nothing, is_symmetric, linearized, nature
from rbpsym.mechanics.numbers import number, sample, samples
from rbpsym.mechanics.roots import common_zeros, numerator_factors
from rbpsym.mechanics.stability import stable_where
from rbpsym.mechanics.system import System


@dataclass(frozen=True, slots=True)
class Equilibrium:
    """A position of rest: `at` the coordinates that are not arbitrary; `frequencies_squared` of the
    normal modes that have a closed form, the slowest first (none where speeds damp the motion); `nature` what is
    proved of its stability; where that is open, it is stable `where` this is positive and unstable where it is
    negative (None: no such formula)."""

    at: Mapping[str, Scalar]
    frequencies_squared: tuple[Scalar, ...]
    linear: Linear
    nature: Nature
    where: Scalar | None = None

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


def resting_forces(system: System, dynamics: Dynamics) -> tuple[Scalar, ...]:
    """Generalized forces with all speeds zero."""
    still = dict.fromkeys(system.speeds, NOTHING)
    return tuple(short(substitute(value, still)) for value in dynamics.forcing)


def is_autonomous(system: System, dynamics: Dynamics) -> bool:
    """Whether the forces at rest are functions of free coordinates alone: no clock, no kinetic friction."""
    if system.implicit or not all(dynamics.ideal.values()):
        return False
    return not any(depends_on(force, "t") for force in resting_forces(system, dynamics))


def equilibria(system: System, dynamics: Dynamics, assumptions: Assumptions) -> tuple[Equilibrium, ...]:
    """The positions of rest within the ranges of the coordinates, as far as closed forms go."""
    if not is_autonomous(system, dynamics) or len(system.independent) > 4:
        return ()
    forces = resting_forces(system, dynamics)
    names = tuple(n for n in system.independent if any(depends_on(force, n) for force in forces))
    if not names:
        return ()
    places = common_zeros(forces, names) or _all_zero(forces, names, assumptions)
    kept = (at for at in places if _within(system, at) and _is_regular(dynamics.mass_matrix, at))
    return tuple(_describe(system, dynamics, at, assumptions) for at in kept)


def _is_regular(mass: Matrix, at: Mapping[str, Scalar]) -> bool:
    """Whether the coordinates describe the neighbourhood of the place (r = 0 in polar coordinates does not)."""
    try:
        return not is_zero(determinant(tuple(tuple(substitute(entry, at) for entry in row) for row in mass)))
    except ZeroDivisionError:
        return False


def _all_zero(forces: Iterable[Scalar], names: Iterable[str], assumptions: Assumptions) -> list[dict[str, Scalar]]:
    """Where all coordinates are 0, if the forces vanish there: authors often count from the position of rest."""
    at = dict.fromkeys(names, NOTHING)
    try:
        left = [_without_roots(substitute(force, at), assumptions) for force in forces]
    except ZeroDivisionError:
        return []
    return [] if any(left) else [at]


def _without_roots(value: Scalar, assumptions: Assumptions) -> Scalar:
    """The value with √(x²) = x for what is positive."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if found.kind == "root":
            inner = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
            image = simplified_root(inner, lambda name: assumptions.sign_of(name) == "positive")
            value = _with_image(value.num, index, image) / _with_image(value.den, index, image)
    return short(without_even_roots(value))


def _with_image(poly: Poly, index: int, image: Scalar) -> Scalar:
    return sum((Scalar(part) * image**power for power, part in poly.by_power(index).items()), NOTHING)


def _within(system: System, at: Mapping[str, Scalar]) -> bool:
    """Whether the place lies in the declared ranges for some of the sample numbers."""
    return any(_within_at(system, at, numbers) for numbers in samples(system.problem))


def _within_at(system: System, at: Mapping[str, Scalar], numbers: Mapping[str, float]) -> bool:
    for coordinate in system.problem.coordinates:
        if coordinate.name not in at:
            continue
        try:
            here = number(at[coordinate.name], numbers)
        except (ValueError, ZeroDivisionError, KeyError):
            return False
        for bound, side in ((coordinate.lower, 1), (coordinate.upper, -1)):
            if bound is not None and side * (here - _number(bound, numbers)) < -1e-9:
                return False
    return True


def _number(node, numbers) -> float:
    from rbpsym.algebra.evaluate import scalar

    return number(scalar(node), numbers)


def _describe(system: System, dynamics: Dynamics, at, assumptions: Assumptions) -> Equilibrium:
    names = system.independent

    still = dict.fromkeys(system.speeds, NOTHING)

    def there(value: Scalar) -> Scalar:
        return _without_roots(substitute(substitute(value, still), at), assumptions)

    linear = linearized(system, dynamics, assumptions, there)
    held = _held(linear.stiffness, names, at)
    found = nature(system, dynamics, linear, held, assumptions)
    where = None
    if found.proved == "open":
        is_kept = is_symmetric(held) and gains_nothing(system, dynamics, assumptions)
        where = stable_where(held, assumptions) if is_kept else found.conditions[0] if len(found.conditions) == 1 else None
    squares = () if linear.is_damped else _frequencies(linear.stiffness, linear.inertia, assumptions)
    return Equilibrium(at, _slowest_first(squares, system), linear, found, where)


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
