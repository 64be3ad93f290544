"""What holds where an answer is judged: meanings, assumptions, dimensions, the motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from rbpsym.algebra.evaluate import BARE, Scope
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.squares import with_squares
from rbpsym.equality.assumptions import NONE, Assumptions
from rbpsym.mechanics.study import Study
from rbpsym.quantities import LENGTH, MASS, TIME, Dimension
from rbpsym.statement.checks import dimensions_with_unknowns
from rbpsym.teaching.grading.book import Book, book
from rbpsym.teaching.grading.intervals import Sampling


def _same(value: Scalar) -> Scalar:
    return value


@dataclass(frozen=True)
class Ground:
    """Meanings of names (`scope`), assumptions, dimensions, and how names may be typed (`book`).

    on_motion: replaces accelerations and unknown forces by what they are; along: squares of the speeds too.
    """

    book: Book
    assumptions: Assumptions = NONE
    scope: Scope = BARE
    dimensions: Mapping[str, Dimension] = field(default_factory=dict)
    on_motion: Callable[[Scalar], Scalar] = _same
    along: Callable[[Scalar], Scalar] = _same
    has_motion: bool = False

    @cached_property
    def sampling(self) -> Sampling:
        """Points at which formulas are compared."""
        return Sampling(self.assumptions, self.scope)


def bare_ground(symbols: Iterable[str] | Mapping[str, str], language: str = "en") -> Ground:
    """The ground of some names alone, with their signs (“positive”, “nonnegative”, “nonzero”, “real”)."""
    signs = dict(symbols) if isinstance(symbols, Mapping) else {}
    return Ground(book(symbols, _rates_named(frozenset(symbols)), language), Assumptions(signs))


_ANGLES = ("theta", "phi", "varphi", "vartheta", "psi", "beta", "alpha", "gamma")


def _rates_named(names: frozenset[str]) -> dict[str, str]:
    """ω for the rate of the only angle that has one, if there is no other ω."""
    rates = [f"{name}_dot" for name in _ANGLES if f"{name}_dot" in names]
    return {rates[0]: "omega"} if len(rates) == 1 and "omega" not in names else {}


def ground_of(study: Study, language: str = "en") -> Ground:
    """The ground of a problem: its names, on its constraints."""
    problem, system = study.problem, study.system
    named = named_quantities(study)
    dimensions = {**dimensions_with_unknowns(problem), **{name: _NAMED[name.partition("_")[0]] for name in named}}
    names = {*dimensions, *named, *system.unknowns}
    scalars = {**named, **system.tied()}
    return Ground(
        book(names, problem.notation, language, problem.names_in(language)),
        study.assumptions,
        system.scope.with_scalars({**system.scope.scalars, **scalars}),
        dimensions,
        study.on_motion,
        lambda value: with_squares(study.on_motion(value), study.squares),
        True,
    )


_NAMED = {"I": MASS * LENGTH**2, "omega": TIME**-1, "alpha": TIME**-2}


def named_quantities(study: Study) -> dict[str, Scalar]:
    """Quantities that a student may name without being told: I of each body, ω and α of the only turning one."""
    bodies = study.system.bodies
    taken = {q.name for q in study.problem.parameters} | set(study.problem.notation.values())
    found = {f"I_{name}": state.moment for name, state in bodies.items()}
    found |= {f"omega_{name}": state.omega for name, state in bodies.items() if state.omega}
    found |= {f"alpha_{name}": state.alpha for name, state in bodies.items() if state.alpha}
    turning = {state.omega for state in bodies.values() if state.omega}
    if len(bodies) == 1:
        found |= dict.fromkeys(("I", "I_cm"), next(iter(bodies.values())).moment)
    if len(turning) == 1:
        state = next(state for state in bodies.values() if state.omega)
        found |= {"omega": state.omega, "alpha": state.alpha}
    return {name: value for name, value in found.items() if name not in taken and value is not None}
