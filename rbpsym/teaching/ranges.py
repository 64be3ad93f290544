"""From which numbers a quantity is drawn: low, high and step, with unit and significant figures, as a worksheet file says.

Without a wish of the worksheet they lie around the author's example (else around a generic value).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Set
from decimal import ROUND_HALF_UP, Decimal, InvalidOperation
from fractions import Fraction

from rbpsym.ask.asking import answered_all, letters
from rbpsym.ask.found import Answer
from rbpsym.ask.senses import demands_of
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.numbers import angles, floating, sample, unit_of_given
from rbpsym.mechanics.phases import followable, known_stages
from rbpsym.mechanics.pushing import begun_numbers
from rbpsym.mechanics.study import Study
from rbpsym.quantities import ACCELERATION, NUMBER, Dimension, Quantity
from rbpsym.statement.model import Coordinate, Problem
from rbpsym.statement.source import SourceItem, SourceTable, kind_of
from rbpsym.statement.units import RAISED, offered, scale_of, unit_named, unit_of, unit_text
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.compiled import compiled
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
    """A value in SI units as it is printed: in `unit`, rounded half up to so many significant figures.

    A value that is a tie but for the noise of floating point is taken for the tie, so that every machine rounds alike.
    Raises ValueError for nan and infinity.
    """
    return Measure(in_figures(Fraction(f"{value / scale_of(unit):.13e}"), digits), unit, digits)


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


# --- From which numbers a quantity is drawn: low, high and step, with unit and significant figures, as a worksheet file says


DIGITS = 3
LESS, MORE = Fraction(7, 10), Fraction(14, 10)  # how far from the example


class NumberRange(Frozen):
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


def middles(ranges: Mapping[str, NumberRange]) -> dict[str, float]:
    """The middle of each range, in SI units."""
    return {name: float(r.low + r.high) / 2 * scale_of(r.unit) for name, r in ranges.items()}


def named_quantities(problem: Problem) -> Mapping[str, Dimension]:
    """Constants of a problem, by name: its parameters and the starts that nobody declared."""
    return {q.name: q.dimension for q in problem.parameters}


def conditions(study: Study, *, asks: bool = True) -> list[Demand]:
    """What it takes for the motion to begin as it is told, to come to all phases and to what the problem itself asks."""
    found = [*followable(known_stages(study.problem)[0])]
    for answer in answered_all(study, letters(study)) if asks and not study.problem.phases else ():
        found += demands_of(answer) if isinstance(answer, Answer) else ()
    return [demand for demand in found if demand.op != "!="]


def default_ranges(study: Study) -> dict[str, NumberRange]:
    """A range for each constant of a problem, around its example, else around numbers at which it moves as it is stated."""
    problem, named, turned = study.problem, named_quantities(study.problem), angles(study.problem)
    for asked in (conditions(study), conditions(study, asks=False)):
        begun = begun_numbers(study, asked, far=True)
        if all(floating(demand.value, begun) >= 0 for demand in asked):
            break
    weight = next((name for name, dimension in named.items() if dimension == ACCELERATION), None)
    pace = math.sqrt(sample(problem)[weight] / begun[weight]) if weight else 1.0  # in other seconds it is the earth's gravity
    generic = {name: begun[name] * pace**-dimension.time for name, dimension in named.items()}
    return {name: _around(name, dimension, problem, generic, turned) for name, dimension in named.items()}


def _around(name: str, dimension: Dimension, problem: Problem, generic: Mapping[str, float], turned: Set[str]) -> NumberRange:
    text = str(problem.example.get(name, ""))
    if text:
        measure = read_measure(text, dimension, f"the example of “{name}”")
    else:
        value, unit = generic.get(name, 1.0), unit_of_given(name, dimension, turned)
        measure = Measure(Fraction(round(math.degrees(value))) if unit == "deg" else Fraction(Decimal(f"{value:.2g}")), unit)
    if dimension == ACCELERATION or not measure.value:
        return NumberRange(measure.value, measure.value, Fraction(0), measure.unit)
    return spread(measure)


def spread(measure: Measure) -> NumberRange:
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
    return NumberRange(low, high, step, measure.unit)


def _angles(measure: Measure) -> NumberRange:
    low, high = sorted((round(measure.value * LESS), round(measure.value * MORE)))
    if 0 < measure.value < 90:
        low, high = max(low, 2), min(high, 85)
    return NumberRange(Fraction(low), Fraction(high), Fraction(1), measure.unit)


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


# --- the numbers of a worksheet file: fixed ones and ranges, checked against what the problem says of them


RANGE_KEYS = ("from", "to", "step", "digits")
MOST_NUMBERS, MOST_DIGITS = 100_000, 6
NOISE = 1e-9


class Named(Frozen):
    """What a problem says of a number: its dimension, its sign, and between which values (in SI units) it lies."""

    name: str
    dimension: Dimension
    sign: str = "real"
    lower: float = -math.inf
    upper: float = math.inf


def numbers_in(table: SourceTable, problem: Problem) -> Iterator[tuple[str, NumberRange]]:
    """(name, range) for each entry of [problem.numbers]. Raises StatementError with its place."""
    known = {named.name: named for named in _known(problem)}
    table.check_keys(known, f"the numbers of “{problem.name}”")
    for name in table.names():
        yield name, _range(table, known[name])


def _known(problem: Problem) -> Iterator[Named]:
    """Parameters, starts of coordinates, and coordinates (where it is looked at)."""
    signs = {q.name: q.sign for q in problem.parameters}
    bounds = {q.name: _bounds(q) for q in problem.parameters}
    bounds |= {c.start.name: _bounds(c) for c in problem.coordinates if isinstance(c.start, t.Sym)}
    for name, dimension in named_quantities(problem).items():
        yield Named(name, dimension, signs.get(name, "real"), *bounds.get(name, ()))
    for coordinate in problem.coordinates:
        yield Named(coordinate.name, coordinate.quantity.dimension, "real", *_bounds(coordinate))


def _bounds(quantity: Quantity | Coordinate) -> tuple[float, float]:
    """Its declared range, as far as that is numbers."""
    found = []
    for bound, none in ((quantity.lower, -math.inf), (quantity.upper, math.inf)):
        value = none if bound is None else compiled([scalar(bound)])({})[0]
        found.append(value if math.isfinite(value) else none)
    return found[0], found[1]


def _range(table: SourceTable, named: Named) -> NumberRange:
    """A fixed number "60 deg", or { from, to, step, digits }."""
    value, name = table.data[named.name], named.name
    if isinstance(value, str):
        measure = _measure(table.item(name), named, f"“{name}”")
        return NumberRange(measure.value, measure.value, Fraction(0), measure.unit, max(DIGITS, figures(measure.value)))
    if not isinstance(value, Mapping):
        raise table.value_error(
            name, f"“{name}” must be a number with its unit or a range, not {kind_of(value)}", _example(named)
        )
    row = table.table(name, name)
    row.check_keys(RANGE_KEYS, "a range")
    for key in RANGE_KEYS[:3]:
        row.require(key, f"the range of “{name}”")
    low, high = (_measure(row.item(key), named, f"“{key}”") for key in ("from", "to"))
    step = _told(row.item("step"), lambda: read_measure(row.string("step"), named.dimension, "“step”"))
    found = NumberRange(low.value, high.value, step.value, low.unit, row.whole("digits", DIGITS, 1, MOST_DIGITS))
    _check_range(row, found, {low.unit, high.unit, step.unit})
    return found


def _example(named: Named) -> str:
    """How it could be written."""
    unit = "deg" if named.dimension == NUMBER and named.sign == "real" else unit_of(named.dimension)
    one, low, high, step = (f'"{number} {unit}"'.replace(' "', '"') for number in ("50", "40", "60", "1"))
    return f"write {named.name} = {one} or {named.name} = {{ from = {low}, to = {high}, step = {step} }}"


def _measure(item: SourceItem, named: Named, what: str) -> Measure:
    """A number that the problem allows for this quantity."""
    if not isinstance(item.value, str):
        raise item.error(f"{what} must be a text in quotes, not {kind_of(item.value)}", _example(named))
    measure = _told(item, lambda: read_measure(item.value, named.dimension, what))
    if named.sign in SIGNS and not SIGNS[named.sign](measure.value):
        raise item.error(f"“{named.name}” must be {named.sign} in this problem", "give another number")
    if not named.lower - NOISE <= si(measure) <= named.upper + NOISE:
        raise item.error(f"“{named.name}” is not {measure_text(measure)} in this problem", _between(named, measure.unit))
    if figures(measure.value) > MOST_DIGITS:
        raise item.error(f"{what} has more than {MOST_DIGITS} significant figures", "round it")
    return measure


SIGNS: Mapping[str, Callable[[Fraction], bool]] = {
    "positive": lambda value: value > 0,
    "nonnegative": lambda value: value >= 0,
    "nonzero": lambda value: value != 0,
}


def _between(named: Named, unit: str) -> str:
    """The declared range in words."""
    ends = {"from": named.lower, "up to": named.upper}
    told = [f"{word} {value / scale_of(unit):.4g}{unit_text(unit)}" for word, value in ends.items() if math.isfinite(value)]
    return f"it goes {' '.join(told)}"


def _check_range(row: SourceTable, found: NumberRange, units: set[str]) -> None:
    if len(units) > 1:
        raise row.value_error("step", "“from”, “to” and “step” must be in the same unit", f"write all in {found.unit}")
    if found.step <= 0:
        raise row.value_error("step", "the step must be greater than 0", f'write a fixed number: "{row.data["from"]}", or a step')
    if found.low > found.high:
        raise row.value_error("to", "the range ends before it begins", "exchange “from” and “to”")
    if (found.high - found.low) / found.step > MOST_NUMBERS:
        raise row.value_error("step", f"this makes more than {MOST_NUMBERS} numbers", "write a greater step")
    needed = max(figures(found.low + k * found.step) for k in range(min(40, int((found.high - found.low) / found.step) + 1)))
    if needed > found.digits:
        key = "digits" if "digits" in row else "step"
        hint = f"write digits = {needed}, or a greater step" if needed <= MOST_DIGITS else "write a greater step"
        raise row.value_error(key, f"{found.digits} significant figures do not tell the numbers of this range apart", hint)


def _told(item: SourceItem, call: Callable[[], Measure]) -> Measure:
    """The result of a reader, its error told at the place of what it read."""
    try:
        return call()
    except RbpsymError as error:
        raise item.error(error.what, error.instead) from None
