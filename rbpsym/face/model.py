"""A problem whose mechanics answers in sympy: energies, momenta, works, equations of motion, and the steps that prove them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.derive import derive
from rbpsym.document.notes import notation_of
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.face.late import sympy
from rbpsym.face.parts import (
    AngularMomentum,
    Halves,
    InertialFrame,
    Linearization,
    StepRelation,
    SymbolicAnswer,
    in_sympy,
    relations_of,
    space,
    together,
)
from rbpsym.face.reading import CLOCK, name_of, tree_of
from rbpsym.face.writing import Alphabet, alphabet
from rbpsym.field import Scalar, Vector, cartesian, names_in, substitute, symbol, total
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics import compiled, energy, motion, numbers, oscillation, placing
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import Derivation
from rbpsym.solve import shown
from rbpsym.statement.model import Problem
from rbpsym.statement.premises import OPS
from rbpsym.statement.source import did_you_mean
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text

Numbers = Mapping[Any, Any]  # symbols or names → numbers


def model(statement: Problem | Study) -> SymbolicModel:
    """The mechanics of a problem (or of the name of one that ships, of a file, of a text) in sympy.

    >>> import rbpsym
    >>> pendulum = rbpsym.model("rod-pendulum")
    >>> pendulum.coordinates
    (theta(t),)
    """
    return SymbolicModel(statement if isinstance(statement, Study) else Study(statement))


class SymbolicModel(Frozen):
    """A problem and what follows from it. Coordinates are functions of t, as dynamicsymbols makes them; parameters are
    symbols with their signs; x points to the right, y upwards, counter-clockwise is positive."""

    study: Study

    @cached_property
    def derivation(self) -> Derivation:
        """All steps, each with its certificate (without the simulation)."""
        return derive(self.study.problem, simulation=False)

    @cached_property
    def _names(self) -> Alphabet:
        return alphabet(self.study)

    def _written(self, value: Scalar) -> sympy.Expr:
        return self._names.write(shown(value, self.study))

    def _by_symbol(self, values: Mapping[str, Scalar]) -> dict[sympy.Expr, sympy.Expr]:
        return {self._names.scalar(name): self._written(value) for name, value in values.items()}

    def _matrix(self, rows: Sequence[Sequence[Scalar]]) -> sympy.Matrix:
        return sympy.Matrix([[self._written(entry) for entry in row] for row in rows])

    # --- what is stated

    @property
    def parameters(self) -> tuple[sympy.Symbol, ...]:
        """The constants, starts that nobody declared (theta_0) behind the others."""
        return tuple(self._names.constants[each.name] for each in self.study.problem.parameters)

    @property
    def coordinates(self) -> tuple[sympy.Expr, ...]:
        """The coordinates that no constraint has solved for, as functions of t."""
        return tuple(map(self._names.scalar, self.study.system.coordinates))

    @property
    def speeds(self) -> tuple[sympy.Expr, ...]:
        """The independent speeds, as derivatives."""
        return tuple(map(self._names.scalar, self.study.system.speeds))

    @property
    def state(self) -> tuple[sympy.Expr, ...]:
        """What stands in y of `lambdify`: coordinates, then speeds."""
        return (*self.coordinates, *self.speeds)

    @property
    def dependent_coordinates(self) -> dict[sympy.Expr, sympy.Expr]:
        """Those for which a constraint was solved, in terms of the others."""
        return self._by_symbol(self.study.system.dependent)

    @property
    def assumptions(self) -> tuple[sympy.Basic, ...]:
        """The declared signs and ranges, as relations."""
        assumed = self.study.assumptions
        found: list[tuple[str, str, t.Node]] = [(name, OPS[sign], t.ZERO) for name, sign in assumed.signs.items() if sign in OPS]
        for name, ends in assumed.ranges.items():
            found += [(name, op, shown(end)) for op, end in zip("><", ends, strict=True) if end is not None]
        rows = tuple(t.relation(t.Sym(name), op, end) for name, op, end in found)
        return self._names.relations(t.Relations(rows))

    # --- energies, momenta, works

    @property
    def kinetic_energy(self) -> sympy.Expr:
        """Of all bodies together."""
        return self._written(total(self.study.kinetic))

    @property
    def kinetic_energies(self) -> Halves:
        """½ M V² and ½ I_cm ω² (König), of each body in `on`."""
        halves = energy.translational_energy, energy.rotational_energy
        states = self.study.system.bodies.items()
        return together({name: Halves(*(self._written(half(state)) for half in halves)) for name, state in states})

    @property
    def potential_energy(self) -> sympy.Expr | None:
        """None if an interaction has none."""
        return None if self.study.potential is None else self._written(self.study.potential)

    def angular_momentum(self, about: Any = "O", body: str | None = None) -> AngularMomentum:
        """About a fixed point, the name of an origin or a place (x, y), of one body or of all.

        Raises StatementError for a point that moves or is not known.

        >>> import rbpsym
        >>> found = rbpsym.model("rod-pendulum").angular_momentum("O", "rod")
        >>> found.orbital, found.spin
        (M*ell**2*Derivative(theta(t), t)/4, M*ell**2*Derivative(theta(t), t)/12)
        """
        states, origin = self.study.system.bodies, self._place(about)
        if body not in (None, *states):
            raise StatementError(f"there is no body “{body}”", instead=did_you_mean(str(body), states, "bodies"))
        chosen = [state for name, state in states.items() if body in (None, name)]
        parts = (total(energy.orbital_momentum(state, origin) for state in chosen), total(map(energy.spin_momentum, chosen)))
        return AngularMomentum(*map(self._written, parts))

    def _place(self, about: Any) -> Vector:
        known = self.study.origins
        if isinstance(about, str) and about in known:
            return known[about]
        place = cartesian(*map(_scalar, about)) if isinstance(about, (tuple, list)) and len(about) == 2 else None
        if place is None or not placing.is_fixed(place, self.study.system):
            instead = f"give a pair (x, y) that does not move, or one of {', '.join(known)}."
            raise StatementError(f"“{about}” is no fixed point", instead=instead)
        return place

    @cached_property
    def works(self) -> dict[str, Halves]:
        """By force: ∫F·dR_cm and ∫τ_cm dφ from the start, on each body in `on`; an integral over the time where there
        is no closed form."""
        found: dict[str, dict[str, Halves]] = {}
        for item in self.study.works:
            halves = Halves(self._work(item.translational), self._work(item.rotational))
            found.setdefault(item.force, {})[item.on] = halves
        return {name: together(on) for name, on in found.items()}

    def _work(self, half: motion.Work) -> sympy.Expr:
        if half.value is not None:
            return self._written(half.value)
        rates = self.study.system.scope.rates
        power = shown(total(part * rates[name] for name, part in half.parts.items()), self.study)
        return self._names.write(t.Integral(power, CLOCK, t.ZERO, t.Sym(CLOCK)))

    # --- equations of motion

    @cached_property
    def _equations(self) -> t.Relations:
        """M q̈ = f, row by row."""
        rows = zip(self.study.dynamics.mass_matrix, self.study.dynamics.forcing, strict=True)
        gained = [symbol(name) for name in self.study.system.accelerations]
        sides = ((total(m * a for m, a in zip(row, gained, strict=True)), force) for row, force in rows)
        return t.Relations(tuple(t.equation(*(shown(side, self.study) for side in both)) for both in sides))

    @property
    def equations_of_motion(self) -> tuple[sympy.Eq, ...]:
        """M q̈ = f, one equation for each independent speed; with `conditions` where coordinates are tied.

        >>> import rbpsym
        >>> rbpsym.model("rod-pendulum").equations_of_motion
        (Eq(M*ell**2*Derivative(theta(t), (t, 2))/3, -M*ell*g*sin(theta(t))/2),)
        """
        return self._names.relations(self._equations)

    @property
    def conditions(self) -> tuple[sympy.Expr, ...]:
        """What vanishes: the conditions that tie coordinates and are not solved for one of them."""
        return tuple(self._written(condition.value) for condition in self.study.ties)

    @property
    def mass_matrix(self) -> sympy.Matrix:
        """M of M q̈ = f."""
        return self._matrix(self.study.dynamics.mass_matrix)

    @property
    def forcing(self) -> sympy.Matrix:
        """f of M q̈ = f, a column."""
        return self._matrix([[value] for value in self.study.dynamics.forcing])

    @property
    def accelerations(self) -> dict[sympy.Expr, sympy.Expr] | None:
        """The solved equations, by second derivative; None where these have no closed form of a bearable length."""
        found = self.study.dynamics.accelerations
        return None if found is None else self._by_symbol(found)

    @property
    def reactions(self) -> dict[str, sympy.Expr]:
        """The unknown forces and couples by name, in coordinates and speeds."""
        return {name: self._written(value) for name, value in self.study.dynamics.reactions.items()}

    def linearize(self) -> tuple[Linearization, ...]:
        """The linear equations about each position of rest that is known.

        >>> import rbpsym
        >>> [(small.at, small.stable) for small in rbpsym.model("rod-pendulum").linearize()]
        [({theta(t): 0}, True), ({theta(t): pi}, False)]
        """
        return tuple(map(self._small, self.study.equilibria))

    def _small(self, rest: oscillation.Equilibrium) -> Linearization:
        inertia, damping, stiffness = map(self._matrix, (rest.inertia, rest.linear.damping, rest.stiffness))
        demands = (t.relation(shown(demand.value, self.study), demand.op, t.ZERO) for demand in rest.valid)
        valid = tuple(relation for demand in demands for relation in self._names.relations(demand))
        return Linearization(self._by_symbol(rest.at), inertia, damping, stiffness, rest.stable, valid)

    # --- questions

    @cached_property
    def _asked(self) -> Asked:
        return Asked(self.study.problem)

    def ask(self, question: str) -> SymbolicAnswer:
        """The answer to a question in the words of the problem (docs/ask.md): any quantity, at any moment or along the motion.

        Raises StatementError where there is none.

        >>> import rbpsym
        >>> found = rbpsym.model("rod-pendulum").ask("F_y at the start")
        >>> found.value, str(found.verdict.kind)
        (M*g*(1 - 3*sin(theta_0)**2/4), 'PROVED')
        """
        return in_sympy(answered(self._asked, question))

    @property
    def answers(self) -> tuple[SymbolicAnswer, ...]:
        """The answers to the questions that the problem itself asks. Raises StatementError for one without."""
        return tuple(map(self.ask, self.study.problem.questions))

    # --- numbers

    def lambdify(self, values: Numbers | None = None, of: Any = None) -> Callable[..., Any]:
        """f(t, y, *others) → ẏ with numpy, as scipy.integrate.solve_ivp wants it; y is `state`.

        `values` are numbers of parameters by symbol or name, in units that agree; without them, those that occur are
        arguments, in the order of `parameters`. With `of` (an expression or several) their values instead of ẏ, also
        for a whole solution: `f(solution.t, solution.y)`; accelerations and unknown forces are those of the motion.
        Raises StatementError for a parameter without a number.

        >>> import rbpsym
        >>> fall = rbpsym.model("rod-pendulum").lambdify({"ell": 1.5, "g": 10, "M": 1})
        >>> [round(float(rate), 6) for rate in fall(0, [3.141592653589793 / 2, 0])]
        [0.0, -10.0]
        """
        given = (values or {}).items()
        known = {key if isinstance(key, str) else name_of(key): numbers.number(_scalar(value), {}) for key, value in given}
        names = [each.name for each in self.study.problem.parameters]
        for name in known.keys() - names:
            raise StatementError(f"“{name}” is no parameter", instead=did_you_mean(name, names, "parameters"))
        several = of if isinstance(of, (list, tuple)) else [of]
        entries = compiled.entries_of(self.study) if of is None else [self._on_motion(_scalar(each)) for each in several]
        used = set() if values else set().union(*map(names_in, entries))
        others = [name for name in names if name in used]
        if of is None:
            return compiled.compiled_rates(self.study, known, others)
        found = compiled.compiled_values(self.study, entries, known, others)
        return found if several is of else lambda *arguments: found(*arguments)[0]

    def _on_motion(self, value: Scalar) -> Scalar:
        """With accelerations, unknown forces and solved coordinates put in."""
        return substitute(self.study.on_motion(value), self.study.system.dependent)

    # --- for sympy.physics.mechanics, and the steps

    def rigid_bodies(self) -> InertialFrame:
        """(frame, origin, bodies): RigidBody and Particle of sympy.physics.mechanics, with their frames, points and
        velocities in the inertial frame, x to the right, y upwards. Of the inertia, the moment about z alone is there.

        >>> import rbpsym
        >>> frame, origin, bodies = rbpsym.model("rod-pendulum").rigid_bodies()
        >>> [body.kinetic_energy(frame).trigsimp().factor() for body in bodies]
        [M*ell**2*Derivative(theta(t), t)**2/6]
        """
        return space(self.study, self._written)

    @cached_property
    def steps(self) -> dict[str, StepRelation]:
        """What was proved, step by step, in the order of the notes, by id.

        >>> import rbpsym
        >>> rbpsym.model("rod-pendulum").steps["frequency.1"].relation
        Eq(vartheta**2, 3*g/(2*ell))
        """
        return {step.id: step for step in relations_of(self.derivation)}

    # --- looks

    def __repr__(self) -> str:
        notation = notation_of(Derivation(self.study, ()))
        return f"{self.study.problem.name}: {to_text(self._equations, notation)}"

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {to_latex(self._equations, notation_of(Derivation(self.study, ())))}$"


def _scalar(value: object) -> Scalar:
    return scalar(tree_of(value))
