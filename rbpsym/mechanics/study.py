"""All that mechanics knows of a problem, each part worked out when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Self

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import rooted
from rbpsym.errors import LimitError, there
from rbpsym.expr.tree import Fn, Node, Sym, walk
from rbpsym.field import NOTHING, PI, Scalar, Vector, apart, at_most, has_roots, kept, names_in, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics import energy, events, friction, motion, oscillation, rest, sides
from rbpsym.mechanics.assemble import assemble
from rbpsym.mechanics.dynamics import FEW_PRODUCTS, Dynamics, newton_euler_rows, solve
from rbpsym.mechanics.instant import Instant, has_start
from rbpsym.mechanics.placing import origins
from rbpsym.mechanics.rest import AtRest
from rbpsym.mechanics.system import ConstraintCondition, System
from rbpsym.mechanics.unsolvable import too_long
from rbpsym.present.style import COEFFICIENT, OTHER, Style
from rbpsym.quantities import ACCELERATION, NUMBER, Dimension, Quantity
from rbpsym.statement.model import Coordinate, Problem
from rbpsym.statement.own_text import Letters, letters_of

MOST_PRODUCTS = 600_000  # of terms, for the equations of motion: forty times as many as the longest of the library takes


class Study(Frozen):
    """A problem with its mechanics."""

    problem: Problem

    def under(self, problem: Problem) -> Self:
        """The mechanics of the same system stated in other words: all that was worked out is taken over."""
        other, found = type(self)(problem), vars(self) | {"problem": problem}
        vars(other).update(found | ({"system": replace(self.system, problem=problem)} if "system" in found else {}))
        return other

    def of(self, system: System) -> Self:
        """The mechanics of a system that is worked out already."""
        other = type(self)(system.problem)
        vars(other)["system"] = system
        return other

    @kept
    def system(self) -> System:
        """Kinematics and forces."""
        return assemble(self.problem)

    @kept
    def answered(self) -> dict[tuple[str, str], Any]:
        """Answers to questions by their words and letter: kept by those who ask."""
        return {}

    @kept
    def letters(self) -> Letters:
        """The letters that are free."""
        return letters_of(self.problem)

    @property
    def ties(self) -> tuple[ConstraintCondition, ...]:
        """The conditions that tie coordinates to each other without an explicit solution."""
        return self.system.implicit

    @property
    def at_start(self) -> bool:
        """Whether only the start is told (`at_start.StartStudy`)."""
        return False

    @property
    def instant(self) -> Instant | None:
        """What holds at the start, where only this is told."""
        return None

    @property
    def solved(self) -> Dynamics | Instant:
        """Accelerations and unknown forces, for every position or else at the start."""
        return self.instant or self.dynamics

    @property
    def dynamics(self) -> Dynamics:
        """Equations of motion, accelerations, unknown forces. Raises LimitError where they grow too long."""
        if isinstance(self._dynamics, LimitError):
            raise self._dynamics
        return self._dynamics

    @kept
    def _dynamics(self) -> Dynamics | LimitError:
        """That it grows too long is found out only once, whoever asks first."""
        try:
            with apart(), at_most(FEW_PRODUCTS if self.ties and has_start(self.problem) else MOST_PRODUCTS):
                return solve(self.system)
        except LimitError:
            return too_long(self.system)

    @kept
    def newton_euler_rows(self) -> list[Scalar]:
        """M A - F (x and y) and I α - τ_cm of every body, which vanish."""
        return [value for _, _, value in self.labelled_rows]

    @kept
    def labelled_rows(self) -> list[tuple[str, str, Scalar]]:
        """The same with the body and "x", "y" or "rotation"."""
        return newton_euler_rows(self.system)

    @kept
    def motion_rows(self) -> tuple[Scalar, ...]:
        """M q̈ - f, row by row, which vanish on the motion."""
        system, found = self.system, []
        for row, force in zip(self.dynamics.mass_matrix, self.dynamics.forcing, strict=True):
            pushed = (m * symbol(a) for m, a in zip(row, system.accelerations, strict=True))
            found.append(sum(pushed, NOTHING) - force)
        return tuple(found)

    @kept
    def power_balance(self) -> Scalar:
        """Σ q̇ (M q̈ - f), which vanishes on the motion."""
        pairs = zip(self.system.speeds, self.motion_rows, strict=True)
        return sum((symbol(speed) * row for speed, row in pairs), NOTHING)

    @property
    def has_clock(self) -> bool:
        """Whether something depends on the time explicitly."""
        return self.system.has_clock

    @kept
    def assumptions(self) -> Assumptions:
        """Declared signs of the parameters and ranges of the coordinates."""
        signs = {"t": "nonnegative"} | {q.name: q.sign for q in self.problem.parameters}  # counted from the start
        stated: tuple[Quantity | Coordinate, ...] = (*self.problem.parameters, *self.problem.coordinates)
        ranges = {
            c.name: (None if c.lower is None else scalar(c.lower), None if c.upper is None else scalar(c.upper))
            for c in stated
            if (c.lower, c.upper) != (None, None)
        }
        starts = [(c.start, c.name) for c in self.problem.coordinates if c.name in ranges]
        ranges |= {s.name: ranges[name] for s, name in starts if isinstance(s, Sym) and s.name in self.problem.implicit}
        return Assumptions(signs, {**self._roomy_circles, **self._slopes, **ranges})

    @property
    def _roomy_circles(self) -> dict[str, tuple[Scalar | None, Scalar | None]]:
        """What rolls or slides inside a circle is smaller than the circle."""
        inside = [e for e in self.problem.constraints if e.values.get("side") == "inside" and e.values.get("rim")]
        rims = [(e["rim"], scalar(e["radius"])) for e in inside]
        return {rim.name: (NOTHING, radius) for rim, radius in rims if isinstance(rim, Sym)}

    @property
    def _slopes(self) -> dict[str, tuple[Scalar | None, Scalar | None]]:
        """An angle that gives the slope of a line by its tangent lies below a right angle."""
        lines = [e["line"] for e in self.problem.constraints if e.values.get("line") is not None]
        nodes = (node for line in lines for part in (line.a, line.b, line.c) for node in walk(part))
        slopes = {node.arg.name for node in nodes if isinstance(node, Fn) and node.name == "tan" and isinstance(node.arg, Sym)}
        signs = {q.name: q.sign for q in self.problem.parameters if q.name in slopes}
        return {name: (NOTHING if sign == "positive" else -PI / 2, PI / 2) for name, sign in signs.items()}

    @kept
    def style(self) -> Style:
        """How factors are ordered: coefficients, masses, stiffnesses, g, lengths, other parameters."""
        rank = {q.name: (self._rank(q), place) for place, q in enumerate(self.problem.parameters)}
        rank |= {name: (0.5, place) for place, name in enumerate(self.system.unknowns)}
        moving = [c.name for c in self.problem.coordinates] + list(self.system.unknowns)
        dimensions = {q.name: q.dimension for q in self.problem.parameters}
        varying = frozenset([*moving, *(f"{name}_dot" for name in moving), "t"])
        return Style(rank, varying, dimensions, greater=self._greater)

    def _rank(self, quantity: Quantity) -> float:
        if quantity.dimension == NUMBER and quantity.name not in self.problem.implicit:
            return COEFFICIENT
        return next((rank for test, rank in RANKS if test(quantity.dimension)), OTHER)

    @property
    def _greater(self) -> frozenset[tuple[str, str]]:
        """Pairs of parameters of which the first is known to be the greater one."""
        lower, upper = [], []
        for name, (low, high) in self.assumptions.ranges.items():
            lower += [(name, other) for other in _single(low)]
            upper += [(other, name) for other in _single(high)]
        return frozenset((*lower, *upper))

    @kept
    def meanings(self) -> dict[Node, Any]:
        """What was made of formulas in the names of the problem, by who looks at them often."""
        return {}

    @kept
    def kinetic(self) -> tuple[Scalar, Scalar]:
        """(translational, rotational) kinetic energy."""
        return energy.kinetic_energy(self.system)

    @kept
    def potential(self) -> Scalar | None:
        """Potential energy, None if an interaction has none."""
        return energy.potential_energy(self.system)

    @kept
    def first_integral(self) -> Scalar | None:
        """The energy integral, None if there is none."""
        return energy.first_integral(self.system, self.dynamics)

    @kept
    def squares(self) -> Mapping[str, Scalar]:
        """Squares of speeds as functions of position, from the start."""
        found = motion.speed_squared(self.system, self.dynamics, self.first_integral)
        return {name: rooted(square, self.assumptions) if has_roots(square) else square for name, square in found.items()}

    @kept
    def resting(self) -> Mapping[str, Scalar]:
        """Coordinates and their speeds that stay what they are at the start while others move."""
        return {} if self.at_start or self.ties else motion.resting(self.system, self.dynamics)

    @kept
    def momentum_speeds(self) -> Mapping[str, Scalar]:
        """The speeds that conserved momenta give, where one that changes is left and its square follows from the energy."""
        single = sum(map(bool, self.squares.values())) == 1
        found = motion.kept_speeds(self.system, self.dynamics, self.first_integral) if single else {}
        return found if len(found) == len(self.system.independent) - 1 else {}

    @property
    def kept_speeds(self) -> Mapping[str, Scalar]:
        """The same, where none of them is one that stays nothing."""
        return self.momentum_speeds if len(self.squares) == 1 else {}

    @kept
    def kept_momenta(self) -> Mapping[str, Scalar]:
        """The momenta that give them, by coordinate."""
        names = {speed.removesuffix("_dot") for speed in self.momentum_speeds}
        momenta = motion.conserved_momenta(self.system, self.dynamics, there(self.first_integral)) if names else {}
        return {name: momentum for name, momentum in momenta.items() if name in names}

    @kept
    def reactions_along_motion(self) -> Mapping[str, Scalar] | None:
        """Unknown forces as functions of position alone; None if they aren't."""
        found = {}
        for name, value in self.dynamics.reactions.items():
            along = motion.along_motion(value, self.squares)
            if along is None:
                return None
            found[name] = along
        return found

    @kept
    def works(self) -> tuple[motion.ForceWork, ...]:
        """Works of every force on every body."""
        return motion.works(self.system, self.dynamics.reactions, self.squares)

    @kept
    def equilibria(self) -> tuple[oscillation.Equilibrium, ...]:
        """Positions of rest with their stability and frequencies."""
        return oscillation.equilibria(self.system, self.dynamics, self.assumptions, self.rest)

    @kept
    def rest(self) -> rest.Rest:
        """Where the system can rest, and whether that is all."""
        return rest.rest(self.system, self.dynamics, self.assumptions)

    @kept
    def open_balance(self) -> AtRest | None:
        """The position of rest where no formula gives one; None if there is a formula or no such place."""
        return rest.balance(self.system, self.dynamics, self.assumptions) if self.rest.open_ else None

    @property
    def losses(self) -> tuple[events.Loss, ...]:
        """Contacts that end."""
        return self.ended.found

    @kept
    def ended(self) -> events.Losses:
        """Contacts that end, and whether there are no others."""
        along = self.reactions_along_motion
        return events.losses(self.system, self.dynamics, along, self.squares, self.assumptions)

    @kept
    def sides(self) -> tuple[sides.Side, ...]:
        """What becomes of each one-sided force."""
        known = self.reactions_along_motion or self.dynamics.reactions
        return sides.sides(self.system, known, self.ended, self.assumptions)

    @kept
    def friction_needs(self) -> tuple[friction.FrictionNeed, ...]:
        """How much static friction the contacts that do not slip need."""
        known = self.reactions_along_motion or self.dynamics.reactions
        return friction.friction_needs(self.system, known, self.assumptions)

    @kept
    def origins(self) -> dict[str, Vector]:
        """Fixed points about which momenta are taken: O, pivots, and those that the author names."""
        return origins(self.system)

    def on_motion(self, value: Scalar) -> Scalar:
        """The value with accelerations and unknown forces replaced by what they are."""
        if not names_in(value) & {*self.system.unknowns, *self.system.accelerations}:
            return value
        value = substitute(value, self.dynamics.reactions)
        return substitute(value, self.dynamics.accelerations or {})

    def begun(self, value: Scalar) -> Scalar:
        """The value at the start, places and speeds not yet put in, with accelerations and unknown forces replaced."""
        return self.on_motion(value)


RANKS: tuple[tuple[Callable[[Dimension], object], int], ...] = (
    (lambda d: d.mass and not d.length and not d.time, 1),
    (lambda d: d == ACCELERATION, 3),
    (lambda d: d.mass, 2),
    (lambda d: d.length and not d.time, 4),
)


def _single(bound: Scalar | None) -> Iterable[str]:
    """The symbol that a bound is, if it is one."""
    names = () if bound is None else names_in(bound)
    return names if len(names) == 1 and bound == symbol(*names) else ()
