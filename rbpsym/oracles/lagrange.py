"""Whether the methods give the same accelerations, whether a mass matrix is regular; and the Lagrange oracle.

The oracle takes the equations of motion from kinetic and potential energy, without forces: from the poses alone
T(q, q̇) = Σ ½ M V² + ½ I_cm φ̇² and U(q) are built, and d/dt ∂T/∂q̇ - ∂T/∂q + ∂U/∂q - Q = 0 must hold identically with the
derived accelerations. Q is the virtual work of what has no potential: the `work` in the folder of each interaction. Where
conditions tie the speeds, Lagrange's expressions are taken along the variations that they allow (Goldstein, Classical
Mechanics, 1.4 and 2.4).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import scalars_equal
from rbpsym.decide.verdict import PROVED, Verdict, all_of, proved, undecided
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import LimitError, NotApplicable, there
from rbpsym.field import NOTHING, ORIGIN, Scalar, Vector, at_most, derivative, names_in, substitute, symbol, total
from rbpsym.field.division import vanishes_on
from rbpsym.field.evaluate import Meanings, scalar, time_derivative
from rbpsym.field.modular import PRIME, NoImage
from rbpsym.frozen import Frozen
from rbpsym.mechanics.contacts import meeting, slip_sense
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import residue, solve_linear
from rbpsym.mechanics.energy import potentials
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.placing import where_in
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System, by_letters
from rbpsym.statement.model import Element, PointRef


def agreement(study: Study, found: Mapping[str, Mapping[str, Scalar] | None]) -> dict[str, Verdict]:
    """For each method that applies: its accelerations against those of Newton's and Euler's equations."""
    known = study.dynamics.accelerations
    if known is None:
        return {}
    return {name: _same(study, values, known) for name, values in found.items() if values}


def _same(study: Study, values: Mapping[str, Scalar], known: Mapping[str, Scalar]) -> Verdict:
    verdict = Verdict(PROVED)
    for name, value in values.items():
        verdict = _equal(study, value, known[name])
        if verdict.kind is not PROVED:
            return verdict
    return verdict


def _equal(study: Study, value: Scalar, known: Scalar) -> Verdict:
    """Equality; where conditions tie the coordinates, only the states that satisfy them count."""
    found = scalars_equal(value, known, study.assumptions)
    ties = [tie.value for tie in study.ties]
    if found.kind is PROVED or not ties:
        return found
    if vanishes_on(value - known, ties):
        return proved("in the ideal of the conditions that tie the coordinates")
    return undecided("the coordinates are tied by conditions that were not solved in closed form")


def regular_verdict(matrix: Sequence[Sequence[Scalar]]) -> Verdict:
    """PROVED if the determinant is not 0 at one point modulo a prime, else UNDECIDED.

    The point is consistent with all relations between the atoms, so a value other than 0 there
    proves that the determinant does not vanish identically.
    """
    try:
        images = [[residue(entry) for entry in row] for row in matrix]
    except (NoImage, ZeroDivisionError, ValueError):
        return undecided("the determinant of the mass matrix could not be computed at a point")
    if _determinant(images):
        return proved("determinant not zero modulo a prime")
    return undecided("the determinant of the mass matrix is zero at the point that was tried")


def _determinant(rows: list[list[int]]) -> int:
    """By elimination modulo the prime."""
    product = 1
    while rows:
        place = next((k for k, row in enumerate(rows) if row[0]), None)
        if place is None:
            return 0
        pivot = rows.pop(place)
        product = product * pivot[0] * (-1) ** place % PRIME
        scale = pow(pivot[0], -1, PRIME)
        rows = [[(b - row[0] * scale * a) % PRIME for a, b in zip(pivot[1:], row[1:], strict=True)] for row in rows]
    return product


def friction_forces(motion: FreeMotion, dynamics: Dynamics) -> dict[str, Scalar]:
    """For each coordinate Σ -μN ∂(slip)/∂q̇ over the contacts with kinetic friction."""
    rough = [e for e in motion.system.problem.constraints if e.values.get("coefficient") is not None]
    return {name: sum((_share(motion, e, dynamics.reactions, name) for e in rough), NOTHING) for name in motion.names}


def _share(motion: FreeMotion, element: Element, reactions: Mapping[str, Scalar], name: str) -> Scalar:
    geometry = geometry_of(motion.system)
    met = meeting(element, geometry)
    against = -slip_sense(element, geometry, met)
    slip = met.forward.dot(_velocity(motion, met.on, met.place) - _velocity(motion, met.by, met.place))
    return reactions[element.name] * scalar(element["coefficient"]) * against * derivative(slip, f"{name}_dot")


def _velocity(motion: FreeMotion, body: str | None, place: Vector) -> Vector:
    """Velocity of the material point of a body at a place, every speed a free symbol."""
    if body is None:
        return ORIGIN
    state = motion.system.bodies[body]
    return motion.velocity(state.center) + (place - state.center).turned() * motion.rate(state.pose.angle)


MOST_PRODUCTS = 2_000_000
HALF = Fraction(1, 2)


class FreeMotion(Frozen):
    """Positions and angles of a system, and their rates with every speed q̇ as a free symbol."""

    system: System
    where: Callable[[PointRef], Vector]

    @property
    def names(self) -> tuple[str, ...]:
        """The coordinates, also those whose speeds the conditions tie to others."""
        return self.system.coordinates

    def angle(self, body: str | None) -> Scalar:
        """Angle of a body, 0 for the ground; counter-clockwise positive."""
        state = self.system.bodies.get(body or "")
        return NOTHING if state is None else state.pose.angle

    def own(self, value: Scalar) -> Scalar:
        """An expression of the statement in the coordinates that are left, and their speeds."""
        images = dict(self.system.dependent)
        images |= {f"{n}_dot": self.rate(v) for n, v in self.system.dependent.items()}
        return substitute(value, images)

    def rate(self, value: Scalar) -> Scalar:
        """d/dt of a function of the coordinates (and t)."""
        parts = (derivative(value, name) * symbol(f"{name}_dot") for name in self.names)
        return sum(parts, derivative(value, "t"))

    def velocity(self, place: Vector) -> Vector:
        """d/dt of a position."""
        parts = (place.derivative(name) * symbol(f"{name}_dot") for name in self.names)
        return sum(parts, place.derivative("t"))


def motion_of(system: System) -> FreeMotion:
    """The kinematics that the poses of a system contain."""
    return FreeMotion(system, where_in(system))


def kinetic_energy(motion: FreeMotion) -> Scalar:
    """T = Σ ½ M V² + ½ I_cm φ̇² with the speeds as free symbols."""
    total = NOTHING
    for state in motion.system.bodies.values():
        speed, spin = motion.velocity(state.center), motion.rate(state.pose.angle)
        total = total + (state.mass * speed.dot(speed) + state.moment * spin * spin) * HALF
    return total


# --- what has no potential: Q(q), the virtual work for a variation of q

VIRTUAL_WORKS: KindParts[Callable[[Element, FreeMotion, str], Scalar]] = KindParts(INTERACTIONS, "work", "work")


def generalized_force(motion: FreeMotion, name: str) -> Scalar:
    """-∂U/∂q + Q, by the virtual works of what has no potential."""
    energies, total = potentials(motion.system), NOTHING
    for element in motion.system.problem.interactions:
        energy = energies[element.name]
        total = total + (VIRTUAL_WORKS[element.kind](element, motion, name) if energy is None else -derivative(energy, name))
    return total


# --- Lagrange's equations


def lagrange_expressions(system: System) -> dict[str, Scalar]:
    """For each coordinate d/dt ∂T/∂q̇ - ∂T/∂q + ∂U/∂q - Q in q, q̇, q̈, every q̈ a free symbol."""
    motion = motion_of(system)
    energy = kinetic_energy(motion)
    rates = {name: symbol(f"{name}_dot") for name in motion.names}
    rates |= {f"{name}_dot": symbol(f"{name}_ddot") for name in motion.names}
    scope = Meanings(rates=rates | {"t": symbol("t") ** 0})
    return {
        name: time_derivative(derivative(energy, f"{name}_dot"), scope)
        - derivative(energy, name)
        - generalized_force(motion, name)
        for name in motion.names
    }


def _along_variations(system: System, expressions: Mapping[str, Scalar]) -> list[Scalar]:
    """Σ_q (∂q̇/∂u) E_q for each independent speed u; in independent speeds and accelerations."""
    rates = system.scope.rates
    tied = [name for name in system.coordinates if name not in system.independent]
    images = {f"{name}_ddot": time_derivative(rates[name], system.scope) for name in tied}
    speeds = {f"{name}_dot": rates[name] for name in tied}
    found = []
    for speed in system.speeds:
        parts = (derivative(rates[name], speed) * value for name, value in expressions.items())
        found.append(substitute(substitute(sum(parts, NOTHING), images), speeds))
    return found


def _tied_speeds(system: System) -> list[Scalar]:
    """Time derivatives of the implicit conditions at the allowed speeds, and the conditions on speeds: each must vanish."""
    rates = {name: system.scope.rates[name] for name in system.coordinates}
    found = [
        sum((derivative(c.value, name) * rate for name, rate in rates.items()), derivative(c.value, "t"))
        for c in system.implicit
    ]
    images = {f"{name}_dot": rate for name, rate in rates.items()}
    return found + [substitute(c.value, images) for c in system.speed_ties]


def lagrange_verdict(system: System, dynamics: Dynamics, assumptions: Assumptions | None = None) -> Verdict:
    """Whether Lagrange's equations hold identically with the derived accelerations.

    PROVED or REFUTED by exact algebra; UNDECIDED with the reason if the oracle does not know an
    interaction or a formula grows beyond the limits.
    """
    assumptions = assumptions or Assumptions({q.name: q.sign for q in system.problem.parameters})
    try:
        with at_most(MOST_PRODUCTS):
            return all_of(_verdicts(system, dynamics, assumptions))
    except (NotApplicable, LimitError) as error:
        return undecided(error.what)
    except ZeroDivisionError:
        return undecided("an expression of Lagrange's equations divides by zero")


def _verdicts(system: System, dynamics: Dynamics, assumptions: Assumptions) -> list[Verdict]:
    values = _along_variations(system, _with_friction(system, dynamics, lagrange_expressions(system)))
    found = [_vanishes(value, assumptions) for value in _tied_speeds(system)]
    found += [_vanishes(_defect(system, dynamics, value, k), assumptions) for k, value in enumerate(values)]
    if dynamics.accelerations is None:  # M q̈ = f has one solution only if det M is not 0: shown at one point
        found.append(regular_verdict(dynamics.mass_matrix))
    return found or [proved("nothing moves")]


def start_verdict(study: Study) -> Verdict:
    """The same where only the start is told: there Lagrange's expressions, along all variations that the conditions allow,
    vanish in the sum."""
    system, found = study.system, there(study.instant)
    speeds = by_letters(found.speeds)
    at_start = {**found.places, **speeds, **found.accelerations}
    moves = {n: symbol(f"variation_of_{n}") for n in system.coordinates}
    held = [(c.value, "") for c in system.implicit] + [(c.value, "_dot") for c in system.speed_ties]
    rows = [total(derivative(value, f"{n}{tail}") * move for n, move in moves.items()) for value, tail in held]
    try:
        with at_most(MOST_PRODUCTS):
            known = Dynamics((), (), found.accelerations, found.reactions, {}, {})
            expressions = _with_friction(system, known, lagrange_expressions(system))
            names = tuple(name for move in moves.values() for name in names_in(move))
            allowed = solve_linear([substitute(row, at_start) for row in rows], names, keep_free=True).values
            work = total(substitute(expressions[n], at_start) * move for n, move in moves.items())
            return scalars_equal(substitute(work, allowed), NOTHING, study.assumptions)
    except (NotApplicable, LimitError) as error:
        return undecided(error.what)


def _with_friction(system: System, dynamics: Dynamics, expressions: Mapping[str, Scalar]) -> dict[str, Scalar]:
    """The expressions less the virtual work of kinetic friction, with the unknown forces on which resistances rest."""
    drags = friction_forces(motion_of(system), dynamics)
    known = {name: dynamics.reactions[name] for value in expressions.values() for name in names_in(value) & {*dynamics.reactions}}
    return {name: substitute(value, known) - drags[name] for name, value in expressions.items()}


def _vanishes(value: Scalar, assumptions: Assumptions) -> Verdict:
    return scalars_equal(value, NOTHING, assumptions)


def _defect(system: System, dynamics: Dynamics, value: Scalar, row: int) -> Scalar:
    """Lagrange's expression with the accelerations in it; minus M q̈ - f where these are not explicit."""
    if dynamics.accelerations is not None:
        return substitute(value, dynamics.accelerations)
    return value - _newton_row(system.accelerations, dynamics, row)


def _newton_row(names: Sequence[str], dynamics: Dynamics, row: int) -> Scalar:
    entries = zip(dynamics.mass_matrix[row], names, strict=True)
    return sum((entry * symbol(name) for entry, name in entries), -dynamics.forcing[row])
