"""Swings of any size, of which the square of the speed is q̇² = a + R cos n(q - q*) about a stable place of rest q*.

With sin(n(q - q*)/2) = k sin u the time is ∫ du/(ϑ √(1 - k² sin² u)): a quarter of the period takes K(k)/ϑ, where ϑ is the
angular frequency of the small swings (Landau and Lifshitz, Mechanics, § 11).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from rbpsym.algebra import NOTHING, Scalar, derivative, function, is_zero, root, substitute
from rbpsym.equality.rooted import neat
from rbpsym.errors import StatementError
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.oscillation import where_stable
from rbpsym.mechanics.study import Study

TIMES = (Fraction(1), Fraction(2), Fraction(1, 2), Fraction(4))  # n, with a small whole 4/n


@dataclass(frozen=True, slots=True)
class Swing:
    """The place of rest, the squares of ϑ and of the modulus k, 2/n, and what they ask of the parameters."""

    rest: Scalar
    rate_squared: Scalar
    modulus_squared: Scalar
    part: Fraction
    valid: tuple[Demand, ...]

    def time(self, study: Study, quarters: int) -> Scalar:
        """The time of so many quarters of the period."""
        rate = neat(root(short(self.rate_squared)), study.assumptions)
        return function("elliptic_k", self.modulus_squared) * quarters / rate


def swing_of(study: Study, name: str) -> Swing:
    """The swing of a coordinate from its start. Raises StatementError where it is none of that form."""
    square, start = study.squares.get(name), study.system.scope.start
    if square is None or study.at_start or name not in start:
        raise StatementError(f"the speed of “{name}” is not known as a function of its place from the start")
    slope, third = (derivative(square, name), derivative(derivative(derivative(square, name), name), name))
    squared = (-third / slope).number() if slope else None
    times = next((n for n in TIMES if n * n == squared), None)
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
    asked = settle((Demand(1 - modulus), *item.valid), study.assumptions)
    if asked is None:
        raise StatementError(f"“{name}” does not swing: it goes round and round")
    return Swing(rest, rate, modulus, 2 / times, tuple(asked))


def quarters_to(study: Study, name: str, place: Scalar) -> int | None:
    """After how many quarters of the period from rest it is there first: at the place of rest, or at the other turning point."""
    start = study.system.scope.start
    if not is_zero(start.get(f"{name}_dot", NOTHING)):
        return None
    rest = swing_of(study, name).rest
    known = {1: rest, 2: rest * 2 - start[name], 4: start[name]}
    return next((quarters for quarters, there in known.items() if is_zero(place - there)), None)
