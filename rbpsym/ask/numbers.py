"""Numbers with units for the letters of an answer, and its value at them: “M = 10 kg, theta_0 = 70 deg, theta = 10..60 deg”."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction

from rbpsym.decide import enclosure
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.dimensions import a, dimension_of
from rbpsym.decide.points import Point
from rbpsym.errors import DimensionError, NoNumber, ReadError, StatementError, there
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import Scalar, names_in
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.numbers import floating, number
from rbpsym.mechanics.study import Study
from rbpsym.quantities import ENERGY, NUMBER, TIME, Dimension
from rbpsym.statement.checks import dimensions_with_unknowns
from rbpsym.statement.model import Problem
from rbpsym.statement.premises import OPS
from rbpsym.statement.source import did_you_mean, unit_example
from rbpsym.statement.starter import SIGNS
from rbpsym.statement.units import read_unit, unit_of
from rbpsym.typeset.text import to_text

_NUMBER = r"[-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_ONE = re.compile(rf"\s*({_NUMBER})\s*(.*?)\s*")
_EXACT = re.compile(r"((?:\d|[-+*/^().\s]|pi|π|sqrt)*(?:\d|\)|pi|π))\s*((?!pi|sqrt)[^\W\d].*)?")  # pi/12, sqrt(2) m, 1/2
_RANGE = re.compile(rf"\s*({_NUMBER}\s*[^.]*?)\s*\.\.\s*({_NUMBER}.*?)(?:\s+step\s+({_NUMBER}.*?))?\s*")
STEPS, MOST = 10, 1000  # places of a range without a step, and at most
NEAR, LEAST = 1e-9, 3


class GivenNumbers(Frozen):
    """Numbers in SI units by name, one or more of each; to how many significant figures they are given at least."""

    values: Mapping[str, tuple[float, ...]]
    digits: int = LEAST

    @property
    def ranges(self) -> list[str]:
        """The names with several values."""
        return [name for name, values in self.values.items() if len(values) > 1]

    def beside(self, problem: Problem, more: Mapping[str, str]) -> GivenNumbers:
        """With what a question itself gives for its letters: a number, or a coordinate for which one stands."""
        same = {name: self.values[value] for name, value in more.items() if value in self.values}
        said = ", ".join(f"{name} = {value}" for name, value in more.items() if value not in dimensions_with_unknowns(problem))
        return GivenNumbers({**self.values, **same, **(read_numbers(said, problem).values if said else {})}, self.digits)

    def in_case(self, problem: Problem) -> Problem:
        """The problem with these numbers as its example: of several cases that in which they are is told."""
        own = {name: repr(values[0]) for name, values in self.values.items() if len(values) == 1}
        return replace(problem, example={**problem.example, **own})

    def rows(self) -> list[dict[str, float]]:
        """One set of numbers for each place of the range; the ranges go on together."""
        count = max(map(len, self.values.values()), default=1)
        return [{n: v[k] if len(v) > 1 else v[0] for n, v in self.values.items()} for k in range(count)]


def read_numbers(text: str, problem: Problem) -> GivenNumbers:
    """The numbers of “M = 10 kg, theta = 10..60 deg step 5 deg”; “example” stands for those of the problem. Raises
    ReadError for what can't be read, StatementError for what contradicts the declared signs and ranges."""
    known = {**dimensions_with_unknowns(problem), "t": TIME}
    found, digits, own = {}, [], set[str]()
    for part in filter(None, (part.strip() for part in re.split(r"[,;](?!\d)", text))):
        if part == "example":
            rows = [*problem.example.items()]
        else:
            name, is_given, value = (word.strip() for word in part.partition("="))
            if not is_given:
                raise ReadError(f"“{part}” gives no number", instead="write it as in “M = 10 kg, theta_0 = 70 deg”.")
            rows = [(name, value)]
            if name in own:
                raise ReadError(f"“{name}” is given two numbers", instead="leave one out, or give a range.")
            own.add(name)
        for name, value in rows:
            if name not in known:
                raise ReadError(f"“{name}” is no letter of this problem", instead=did_you_mean(name, list(known), "letters"))
            found[name] = _values(name, str(value), known[name])
            exact = _exact(str(value))
            shown = re.findall(_NUMBER, str(value)[:40])[:1] if exact is None else ()
            digits += [len(re.sub(r"[eE].*|[^\d]", "", number).lstrip("0")) or 1 for number in shown]
    if len({len(values) for values in found.values() if len(values) > 1}) > 1:
        raise ReadError("two ranges have different numbers of places", instead="give both the same number of steps.")
    given = GivenNumbers(found, max(min(digits, default=LEAST), LEAST))
    for row in given.rows():
        _check_declared(problem, row)
    return given


def _values(name: str, text: str, dimension: Dimension) -> tuple[float, ...]:
    """One number, or those of a range."""
    ends = _RANGE.fullmatch(text)
    if ends is None:
        return (_single(name, text, dimension),)
    unit = there(_ONE.fullmatch(ends[2]))[2]
    texts = [end if there(_ONE.fullmatch(end))[2] else f"{end} {unit}" for end in ends.groups() if end is not None]
    first, last, *steps = (_single(name, text, dimension) for text in texts)
    size = abs(steps[0]) if steps else abs(last - first) / STEPS
    count = round(abs(last - first) / size) if size else 0
    if not 0 < count <= MOST or abs(count * size - abs(last - first)) > 1e-6 * abs(last - first):
        what = f"the range of “{name}” has no whole number of steps up to {MOST}"
        raise ReadError(what, instead="write 10 deg .. 80 deg step 10 deg.")
    return tuple(first + (last - first) * k / count for k in range(count + 1))


def _exact(text: str) -> tuple[float, str] | None:
    """A number that is written as an expression, and its unit; None for a plain one, a range and what is none."""
    found = _EXACT.fullmatch(text.strip().replace("−", "-"))
    if not found or re.fullmatch(_NUMBER, found[1].strip()) or _RANGE.fullmatch(text):
        return None
    try:
        return number(scalar(read_infix(found[1].replace("^", "**"), ())), {}), found[2] or ""
    except (ZeroDivisionError, NoNumber):
        return None


def _single(name: str, text: str, dimension: Dimension) -> float:
    """A number with a unit in SI units; without one it is in SI units."""
    found = _exact(text) or ((one := _ONE.fullmatch(text.replace("−", "-"))) and (float(one[1]), one[2]))
    if not found:
        raise ReadError(f"“{text}” is no number for “{name}”", instead=unit_example(dimension))
    unit = read_unit(found[1])
    if unit.of_mechanics != dimension and found[1]:
        raise ReadError(f"“{text}” does not fit “{name}”, which is {a(dimension)}", instead=unit_example(dimension))
    size = found[0] * unit.factor * (2 * math.pi if unit.counts_cycles else 1)
    if not math.isfinite(size):
        raise ReadError(f"“{text}” is no size of a thing", instead=unit_example(dimension))
    return size


def _check_declared(problem: Problem, numbers: Mapping[str, float]) -> None:
    for quantity in problem.parameters:
        if quantity.name in numbers and quantity.sign in OPS and not SIGNS[OPS[quantity.sign]](numbers[quantity.name]):
            raise StatementError(
                f"{quantity.name} = {numbers[quantity.name]:.4g} contradicts the statement: it is declared to be {quantity.sign}",
                instead="change the number, or its declaration.",
            )
    bounds = [(q.name, q.lower, q.upper) for q in problem.parameters] + [(c.name, c.lower, c.upper) for c in problem.coordinates]
    bounds += [(c.start.name, c.lower, c.upper) for c in problem.coordinates if isinstance(c.start, t.Sym)]
    for name, *ends in bounds:
        for end, side in zip(ends, (1, -1), strict=True):
            if name in numbers and end is not None and names_in(scalar(end)) <= {*numbers, "pi"}:
                room = side * (numbers[name] - number(scalar(end), numbers))
                if room < -NEAR * max(1.0, abs(numbers[name])):
                    raise StatementError(
                        f"{name} = {numbers[name]:.4g} contradicts the statement: it lies {'below' if side > 0 else 'above'} "
                        f"the declared range, which ends at {to_text(end)}",
                        instead="change the number, or the range.",
                    )


def require_numbers(study: Study, values: Iterable[Scalar], known: Collection[str]) -> None:
    """Raise StatementError for letters without a number."""
    missing = sorted({n for value in values for n in names_in(value)} - {*known, "pi"})
    if missing:
        dimensions = {**dimensions_with_unknowns(study.problem), "t": TIME}
        told = ", ".join(f"{n} ({dimensions[n]})" if n in dimensions else n for n in missing)
        raise StatementError(f"a number is missing for {told}", instead=f'add it: --with "…, {missing[0]} = …".')


def value_at(study: Study, values: Sequence[Scalar], valid: Sequence[t.Node], numbers: Mapping[str, float]) -> list[float]:
    """The values at some numbers. Raises StatementError for a letter without one, or where a condition is not met."""
    require_numbers(study, values, numbers)
    if (node := unmet(study, valid, numbers)) is not None:
        raise StatementError(f"with these numbers the answer does not hold: it needs {to_text(node)}", instead="change a number.")
    try:
        return [number(value, numbers) for value in values]
    except NoNumber as error:
        needs = ", ".join(to_text(node) for node in valid)  # at the very edge of one of these
        hint = f"change a number, or ask for another case: this one needs {needs}." if needs else "change a number."
        raise StatementError(f"the answer has no value at these numbers: {error.what}", instead=hint) from None


def unmet(study: Study, valid: Iterable[t.Node], numbers: Mapping[str, float], *, wholly: bool = False) -> t.Node | None:
    """The first of some conditions that is not met at numbers; `wholly`: raises StatementError where a letter has none."""
    for node in valid:
        for left, op, right in t.relations(node):
            gap = scalar(t.add(left, t.neg(right)), study.system.scope)
            if wholly:
                require_numbers(study, (gap,), numbers)
            if names_in(gap) <= {*numbers, "pi"} and not _holds(gap, op, numbers):
                return node
    return None


def _holds(gap: Scalar, op: str, numbers: Mapping[str, float]) -> bool:
    found = floating(gap, numbers)
    met = {">": found > -NEAR, ">=": found >= -NEAR, "!=": abs(found) > NEAR, "=": abs(found) < NEAR}
    return found == found and met.get(op, True)


ENERGIES = re.compile(r"energ|work|lost|Lagrangian|(?:^|\W)[EKU](?:_|\b)")


def unit_for(node: t.Node, study: Study, what: str, *, is_angle: bool = False) -> str:
    """The unit of a value, as printed: "" for a number, rad for an angle; by `what` it is said to be, a torque or an energy."""
    try:
        dimension = dimension_of(node, {**dimensions_with_unknowns(study.problem), "t": TIME})
    except DimensionError:
        return ""
    name = "torque" if dimension == ENERGY and not ENERGIES.search(what) else ""
    return "rad" if is_angle and dimension == NUMBER else unit_of(dimension, name)


def rounded(value: float, digits: int) -> str:
    """The value to so many significant figures, zeros at its end too.

    >>> rounded(-2.697, 3), rounded(0.2, 3), rounded(300.04, 3), rounded(0, 3), rounded(12345.6, 3)
    ('-2.70', '0.200', '300', '0', '1.23e+04')
    """
    if not value:
        return "0"
    is_plain = 1e-4 <= abs(value) < 10**digits
    return f"{value:#.{digits}g}".rstrip(".") if is_plain else f"{value:.{digits - 1}e}"


STEPS, WIDEST = 60, 64  # halvings of what is bracketed, and doublings of a range without an end


def bracket(equation: Scalar, name: str, given: Assumptions, numbers: Mapping[str, float]) -> tuple[Fraction, Fraction] | None:
    """Two numbers at which the function has opposite signs, close to each other; None if they are not found."""
    exact = {other: Fraction(value) for other, value in numbers.items() if other != name}

    def sign(place: Fraction) -> int | None:
        try:
            return enclosure.sign_of(Point({**exact, name: place}).value(equation))
        except enclosure.Outside:
            return None

    limits = of_symbol(name, given)
    low, high = (None if end is None else _number(end, exact) for end in (limits.lower, limits.upper))
    for size in (2**k for k in range(-WIDEST, WIDEST)):  # a range without an end is looked through from its other end
        first = -size if low is None and high is None else high - size if low is None else low
        last = (first + 2 * size if low is None else low + size) if high is None else high
        step = (last - first) / 2**40
        below, above = sign(first + step), sign(last - step)
        if below is not None and above is not None and below == -above:
            break
    else:
        return None
    low, high = first + step, last - step
    for _ in range(STEPS):
        middle = (low + high) / 2
        found = sign(middle)
        if found is None:
            break
        low, high = (middle, high) if found in (below, 0) else (low, middle)
    return low, high


def _number(value: Scalar, exact: Mapping[str, Fraction]) -> Fraction:
    low, high = enclosure.ends(Point(exact).value(value))
    return (low + high) / 2
