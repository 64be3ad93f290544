"""Units of the numbers on a paper, and how a number is rounded and printed."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal
from fractions import Fraction

from rbpsym.errors import RbpsymError
from rbpsym.quantities import Dimension
from rbpsym.statement.printed_units import RAISED, offered, scale_of, unit_text
from rbpsym.statement.units import unit_named
from rbpsym.teaching.model import Measure


def si(measure: Measure) -> float:
    """The value in SI units, angles in radians."""
    return float(measure.value) * scale_of(measure.unit)


def known_unit(unit: str, dimension: Dimension, what: str) -> str:
    """The unit, if it is one of the dimension. Raises RbpsymError with those that are."""
    found = offered().get(unit) or unit_named(unit)
    if found is not None and found[0] == dimension:
        return unit
    fitting = [name for name, (known, _) in offered().items() if known == dimension and name]
    what = f"“{unit}” is no unit of {what}" if unit else f"{what} needs a unit"
    raise RbpsymError(what, instead=f"write one of {', '.join(fitting)}." if fitting else "leave the unit out.")


def measured(value: float, unit: str, digits: int) -> Measure:
    """A value in SI units as it is printed: in `unit`, rounded half up to so many significant figures."""
    return Measure(Fraction(rounded(value / scale_of(unit), digits)), unit, digits)


def rounded(value: float, digits: int) -> Decimal:
    """The value rounded half up to significant figures (ValueError for nan and infinity).

    A value that is a tie but for the noise of floating point is taken for the tie, so that every machine rounds alike.
    """
    if not math.isfinite(value):
        raise ValueError("no number")
    if not value:
        return Decimal(0)
    exact = Decimal(f"{value:.13e}")
    place = exact.adjusted() - digits + 1
    return exact.quantize(Decimal(1).scaleb(place), rounding=ROUND_HALF_UP)


def digits_text(measure: Measure, mark: str = ".") -> str:
    """The digits as printed: all significant ones, powers of ten only for very large and very small numbers.

    >>> digits_text(Measure(Fraction(5, 2), "m", 3)), digits_text(Measure(Fraction(1, 80000), "", 2))
    ('2.50', '1.3 × 10⁻⁵')
    """
    value = Decimal(measure.value.numerator) / Decimal(measure.value.denominator)
    if not value:
        return "0"
    power = value.adjusted()
    if -4 <= power < 6:
        text = f"{value.quantize(Decimal(1).scaleb(min(power - measure.digits + 1, 0)), rounding=ROUND_HALF_UP)}"
        return _signed(text, mark)
    scaled = value.scaleb(-power).quantize(Decimal(1).scaleb(1 - measure.digits), rounding=ROUND_HALF_UP)
    return f"{_signed(str(scaled), mark)} × 10{str(power).translate(RAISED)}"


def _signed(text: str, mark: str) -> str:
    return text.replace("-", "−").replace(".", mark)


def number_text(value: Fraction, mark: str = ".") -> str:
    """A number of points with at most two decimals: 3, 2.5, 23.5."""
    return f"{float(value):.2f}".rstrip("0").rstrip(".").replace(".", mark)


def measure_text(measure: Measure, mark: str = ".") -> str:
    """Number and unit: “2.50 m”, “64.0°”."""
    unit = unit_text(measure.unit)
    return digits_text(measure, mark) + (unit if unit in ("", "°") else f"\u00a0{unit}")
