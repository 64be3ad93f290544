"""Equilibria, their stability, and the frequencies of small oscillations about them; the motion close to a place of rest.

At rest the generalized forces Q(q) vanish. What is said of the motion close to such a place follows from the linear
equations there, in all variables that are of first order: where no speed occurs in them, the squares of the angular
frequencies are the roots of det(K - λ M).

With q = q₀ + δq the equations of motion are M δq̈ + C δq̇ + K δq = 0 up to terms of second order: M the inertia
there, C = -∂f/∂q̇ and K = -∂f/∂q (the slope of the inertia is multiplied by an acceleration, and there is none at
rest). A coordinate that a condition ties to others moves with them as its speed does. A motion with e^{λt} needs
det(M λ² + C λ + K) = 0; all roots of a λⁿ + … have negative real parts if Hurwitz's determinants and the
coefficients are positive (Liénard and Chipart). Gantmacher, Theory of Matrices, XV; Merkin, Stability of Motion.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import rationalised, root_of, rooted
from rbpsym.decide.signs import sign
from rbpsym.errors import NoNumber, RbpsymError
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, atoms, derivative, is_zero, root, short, substitute, symbol, total
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import Matrix, determinant, solve_rows
from rbpsym.mechanics.energy import first_integral, potentials
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.rest import Rest
from rbpsym.mechanics.roots import At, numerator_factors
from rbpsym.mechanics.stability import essential, is_stable, stable_where
from rbpsym.mechanics.system import System

LAMBDA = "lambda_"
DAMPERS = ("damper", "rotary-damper")
Powers = tuple[Scalar, ...]  # coefficients of a polynomial in λ, that of the highest power first


class Linear(Frozen):
    """M, C and K; the irreducible `factors` of det(M λ² + C λ + K) without λ itself, which is one `zeros` times;
    `tied`: what the displacements of tied coordinates are per displacement of each independent one."""

    inertia: Matrix
    damping: Matrix
    stiffness: Matrix
    factors: tuple[Powers, ...]
    zeros: int
    tied: Mapping[str, tuple[Scalar, ...]]

    @property
    def is_damped(self) -> bool:
        """Whether speeds occur in first order."""
        return any(entry for row in self.damping for entry in row)


def linearized(system: System, dynamics: Dynamics, assumptions: Assumptions, there: Callable[[Scalar], Scalar]) -> Linear:
    """The linear equations where `there` puts the place into a value at rest."""
    rates = system.scope.rates
    ways = [{n: there(derivative(rates[n], speed)) for n in system.coordinates} for speed in system.speeds]

    def slope(force: Scalar, way: Mapping[str, Scalar]) -> Scalar:
        """Of the numerator alone, since the force vanishes there."""
        parts = (there(derivative(Scalar(force.num), name)) * part for name, part in way.items() if part)
        return there(-total(parts) / there(Scalar(force.den)))

    stiffness = tuple(tuple(slope(force, way) for way in ways) for force in dynamics.forcing)
    damping = tuple(tuple(slope(force, {speed: UNITY}) for speed in system.speeds) for force in dynamics.forcing)
    inertia = tuple(tuple(there(entry) for entry in row) for row in dynamics.mass_matrix)
    others = (name for name in system.coordinates if name not in system.independent)
    tied = {name: tuple(way[name] for way in ways) for name in others}
    return Linear(inertia, damping, stiffness, *_factors(inertia, damping, stiffness, assumptions), tied)


def _factors(inertia: Matrix, damping: Matrix, stiffness: Matrix, assumptions: Assumptions) -> tuple[tuple[Powers, ...], int]:
    """None where the determinant grows beyond the limits. Without damping a polynomial in λ² is factored."""
    letter, index, size = symbol(LAMBDA), atoms.intern("symbol", LAMBDA), range(len(inertia))
    is_damped = any(entry for row in damping for entry in row)

    def entry(i: int, j: int) -> Scalar:
        head = inertia[i][j] * letter + damping[i][j] if is_damped else inertia[i][j]
        return head * letter + stiffness[i][j]

    try:
        whole = determinant(tuple(tuple(entry(i, j) for j in size) for i in size))
        zeros = min(whole.num.by_power(index), default=0)
        rest = whole / letter**zeros
        found = [_powers(factor, index, assumptions) for factor in numerator_factors(rest) if index in factor.atoms()]
    except RbpsymError:
        return (), 0
    if not is_damped:
        found, zeros = [tuple(x for value in powers for x in (value, NOTHING))[:-1] for powers in found], 2 * zeros
    return tuple(sorted(found, key=len)), zeros


def squares(powers: Powers, assumptions: Assumptions) -> list[Scalar]:
    """The squares of the frequencies of an even factor, as far as they have a closed form."""
    even = powers[::2]
    if len(even) == 2:
        return [short(even[1] / even[0])]
    if len(even) > 3:
        return []
    a, b, c = even
    spread = root_of(short(b * b - 4 * a * c), assumptions)
    return [(b - spread) / (2 * a), (b + spread) / (2 * a)]


def _powers(factor: Poly, index: int, assumptions: Assumptions) -> Powers:
    """The coefficients, with one in front that is positive."""
    parts = factor.by_power(index)
    found = [Scalar(parts.get(k, Poly({}))) for k in range(max(parts), -1, -1)]
    kind = sign(found[0], assumptions).kind
    turned = {"positive": 1, "negative": -1}.get(kind or "", found[0])
    return tuple(short(part * turned) for part in found)


def conditions(powers: Powers) -> list[Scalar]:
    """What is positive exactly where all roots have negative real parts, the first coefficient being positive."""
    degree = len(powers) - 1
    wanted = range(degree - 1, 1, -2)
    return [*powers[1:], *(determinant(hurwitz(powers, size)) for size in wanted)]


def decaying(powers: Powers) -> tuple[Scalar, Scalar]:
    """(γ, ϑ²) of λ² + 2γλ + ϑ²; zeros for a factor that is not quadratic."""
    if len(powers) != 3:
        return NOTHING, NOTHING
    return short(powers[1] / powers[0] / 2), short(powers[2] / powers[0])


def eigenvalues(powers: Powers) -> list[Scalar] | None:
    """The roots of a factor, None if it is longer than a quadratic one."""
    if len(powers) == 2:
        return [short(-powers[1] / powers[0])]
    if len(powers) > 3:
        return None
    decay, square = decaying(powers)
    spread = root(short(decay * decay - square))
    return [-decay - spread, -decay + spread]


def hurwitz(powers: Sequence[Scalar], size: int) -> Matrix:
    """Hurwitz's matrix: a₁ a₃ a₅ …; a₀ a₂ a₄ …; 0 a₁ a₃ …."""

    def part(k: int) -> Scalar:
        return powers[k] if 0 <= k < len(powers) else NOTHING

    return tuple(tuple(part(2 * (j + 1) - (i + 1)) for j in range(size)) for i in range(size))


# --- what is proved of the stability


class Nature(Frozen):
    """What is `proved` of a position of rest: "asymptotic" (all roots have negative real parts, but for displacements
    along which every place is one of rest), "minimum" (of the energy, of which nothing is gained), "unstable" (a root
    with a positive real part), or "open"; and what has to be positive for the first, as far as that is not certain."""

    proved: str
    conditions: tuple[Scalar, ...] = ()

    @property
    def stable(self) -> bool | None:
        """None: not decided."""
        return {"asymptotic": True, "minimum": True, "unstable": False}.get(self.proved)


def nature(system: System, dynamics: Dynamics, linear: Linear, held: Matrix, assumptions: Assumptions) -> Nature:
    """The strongest that is proved; `held` is K over the coordinates that are not arbitrary."""
    definite = is_stable(held, assumptions) if is_symmetric(linear.stiffness) and is_symmetric(linear.damping) else None
    needed = [value for powers in linear.factors for value in (conditions(powers) if linear.is_damped else powers[1:])]
    signs = [sign(value, assumptions).kind for value in needed]
    if definite is False or "negative" in signs:
        return Nature("unstable")
    left = [value for value, kind in zip(needed, signs, strict=True) if kind != "positive"]
    settles = linear.is_damped and linear.factors and linear.zeros == len(linear.inertia) - len(held) and all(left)
    if settles and not left:
        return Nature("asymptotic")
    open_ = tuple(dict.fromkeys(essential(value, assumptions) for value in left)) if settles else ()
    return Nature("minimum" if definite and gains_nothing(system, dynamics, assumptions) else "open", open_)


def is_symmetric(matrix: Matrix) -> bool:
    """Whether it equals its transpose."""
    return all(is_zero(matrix[i][j] - matrix[j][i]) for i, j in combinations(range(len(matrix)), 2))


def gains_nothing(system: System, dynamics: Dynamics, assumptions: Assumptions) -> bool:
    """Whether the energy (relative to driven supports: Jacobi's integral) is kept or taken away by dampers alone."""
    without = {name for name, energy in potentials(system).items() if energy is None}
    others = [element for element in system.problem.interactions if element.name in without]
    losses = (e.kind in DAMPERS and sign(scalar(e["coefficient"]), assumptions).is_nonnegative for e in others)
    return (not system.has_clock and all(losses)) or first_integral(system, dynamics) is not None


class Equilibrium(Frozen):
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


def where_stable(item: Equilibrium) -> Equilibrium:
    """The same place under the condition that makes it stable, if that is open and one condition tells it."""
    if item.stable is not None or item.where is None:
        return item
    proved = "asymptotic" if item.nature.conditions else "minimum"
    return replace(item, nature=Nature(proved), where=None, valid=(*item.valid, Demand(item.where)))


def equilibria(system: System, dynamics: Dynamics, assumptions: Assumptions, found: Rest) -> tuple[Equilibrium, ...]:
    """The positions of rest, and what is said of the motion close to them."""
    return tuple(_describe(system, dynamics, *place, assumptions) for place in found.places)


def _describe(system: System, dynamics: Dynamics, at: At, valid: tuple[Demand, ...], assumptions: Assumptions) -> Equilibrium:
    names, assumptions = system.independent, assuming(assumptions, valid, whole=True)
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


def _held(stiffness: Matrix, names: Sequence[str], at: At) -> Matrix:
    """Over the coordinates that are not arbitrary."""
    kept = [k for k, n in enumerate(names) if n in at]
    return tuple(tuple(stiffness[i][j] for j in kept) for i in kept)


def amplitudes(item: Equilibrium, square: Scalar) -> tuple[Scalar, ...] | None:
    """Those of the coordinates in a mode, by its frequency squared, over the first that does not vanish; None where several
    modes have it."""
    pairs = zip(item.stiffness, item.inertia, strict=True)
    names = [f"A_{k}" for k in range(len(item.inertia))]
    rows = [{n: k - square * m for n, k, m in zip(names, a, b, strict=True)} for a, b in pairs]
    found = solve_rows(rows, names, keep_free=True)
    if len(found.free) != 1:
        return None
    whole = [substitute(found.values.get(name, symbol(name)), {found.free[0]: UNITY}) for name in names]
    first = next(value for value in whole if not is_zero(value))
    return tuple(rationalised(short(value / first)) for value in whole)


def _slowest_first(found: list[Scalar], system: System) -> tuple[Scalar, ...]:
    """In the order of their sizes at sample numbers; as they are where these give none."""
    numbers = sample(system.problem)
    try:
        return tuple(sorted(found, key=lambda square: number(square, numbers)))
    except NoNumber:
        return tuple(found)
