"""From which numbers a quantity is drawn: low, high and step, with unit and significant figures.

Without a wish of the worksheet they lie around the author's example (else around a generic value).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from fractions import Fraction

from rbpsym.errors import RbpsymError
from rbpsym.mechanics.numbers import sample
from rbpsym.notation import tree as t
from rbpsym.quantities import ACCELERATION, NUMBER, Dimension
from rbpsym.statement.model import Problem
from rbpsym.statement.printed_units import scale_of, unit_of
from rbpsym.teaching.draws import Draws
from rbpsym.teaching.model import Measure
from rbpsym.teaching.units import known_unit

DIGITS = 3
LESS, MORE = Fraction(7, 10), Fraction(14, 10)  # how far from the example


@dataclass(frozen=True, slots=True)
class Range:
    """The numbers low, low + step, ... up to high, in `unit`, printed with so many figures."""

    low: Fraction
    high: Fraction
    step: Fraction
    unit: str
    digits: int = DIGITS

    def draw(self, draws: Draws) -> Measure:
        """One of the numbers, exactly as it is printed."""
        return Measure(in_figures(draws.step(self.low, self.high, self.step), self.digits), self.unit, self.digits)


def in_figures(value: Fraction, digits: int) -> Fraction:
    """The value rounded to significant figures, half away from zero.

    >>> str(in_figures(Fraction("13.25"), 3)), str(in_figures(Fraction("0.5"), 3))
    ('133/10', '1/2')
    """
    if not value:
        return value
    unit = Fraction(10) ** (_power(value) - digits + 1)
    rounded = math.floor(abs(value) / unit + Fraction(1, 2)) * unit
    return rounded if value > 0 else -rounded


def _power(value: Fraction) -> int:
    """The power of ten of the first figure, exactly."""
    found = math.floor(math.log10(abs(value)))
    return found + (abs(value) >= Fraction(10) ** (found + 1)) - (abs(value) < Fraction(10) ** found)


def figures(value: Fraction) -> int:
    """How many significant figures a decimal number needs (20 for one that has no end).

    >>> figures(Fraction("1.325")), figures(Fraction(1200)), figures(Fraction(0))
    (4, 2, 1)
    """
    return next((digits for digits in range(1, 20) if in_figures(value, digits) == value), 20)


def middles(ranges: Mapping[str, Range]) -> dict[str, float]:
    """The middle of each range, in SI units."""
    return {name: float(r.low + r.high) / 2 * scale_of(r.unit) for name, r in ranges.items()}


def named_quantities(problem: Problem) -> Mapping[str, Dimension]:
    """Constants of a problem, by name: its parameters and the starts that nobody declared."""
    return {q.name: q.dimension for q in problem.parameters}


def default_ranges(problem: Problem) -> dict[str, Range]:
    """A range for each constant of a problem, around its example."""
    generic = sample(problem)
    starts = {c.start.name for c in problem.coordinates if isinstance(c.start, t.Sym)}
    return {
        name: _around(name, dimension, problem, generic, name in starts)
        for name, dimension in named_quantities(problem).items()
    }


def _around(name: str, dimension: Dimension, problem: Problem, generic: Mapping[str, float], is_start: bool) -> Range:
    text = str(problem.example.get(name, ""))
    if text:
        measure = read_measure(text, dimension, f"the example of “{name}”")
    else:
        measure = _generic(generic.get(name, 1.0), dimension, is_start)
    if dimension == ACCELERATION or not measure.value:
        return Range(measure.value, measure.value, Fraction(0), measure.unit)
    return spread(measure)


def _generic(value: float, dimension: Dimension, is_start: bool) -> Measure:
    if dimension == NUMBER and is_start:
        return Measure(Fraction(round(math.degrees(value))), "deg")
    return Measure(Fraction(Decimal(f"{value:.2g}")), unit_of(dimension))


def spread(measure: Measure) -> Range:
    """From 0.7 to 1.4 times a value, in steps that leave three figures; angles in whole degrees.

    A pure number below 1 stays below 1.
    """
    if measure.unit in ("deg", "°"):
        return _angles(measure)
    step = step_near(measure.value)
    ends = sorted((measure.value * LESS, measure.value * MORE))
    low, high = (Fraction(round(end / step)) * step for end in ends)
    if not measure.unit and 0 < measure.value < 1:
        high = min(high, Fraction(19, 20))  # coefficients of friction and restitution
    return Range(low, high, step, measure.unit)


def _angles(measure: Measure) -> Range:
    low, high = sorted((round(measure.value * LESS), round(measure.value * MORE)))
    if 0 < measure.value < 90:
        low, high = max(low, 2), min(high, 85)
    return Range(Fraction(low), Fraction(high), Fraction(1), measure.unit)


def step_near(value: Fraction) -> Fraction:
    """Half a unit of the second figure: 0.005 for 0.5, 0.05 for 2, 0.5 for 10."""
    power = math.floor(math.log10(abs(value)))
    return Fraction(5) * Fraction(10) ** (power - 2)


def read_measure(text: str, dimension: Dimension, what: str) -> Measure:
    """A number with its unit, “0.25 m”. Raises RbpsymError for anything else."""
    first, _, unit = text.strip().partition(" ")
    try:
        value = Decimal(first)
        if not value.is_finite() or abs(value.adjusted()) > 30:
            raise InvalidOperation
    except InvalidOperation:
        raise RbpsymError(f"{what}: “{first}” is no number", instead='write a number and a unit: "0.25 m".') from None
    unit = "*".join(unit.split())  # “kg m^2” is “kg*m^2”
    return Measure(Fraction(value), known_unit(unit, dimension, what), DIGITS)
