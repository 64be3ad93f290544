"""Points at which claims are computed exactly: small rational parameters, Pythagorean angles.

A point gives a fraction to each name, and a rational point of the circle to each angle that
occurs in a sine or cosine, so that no rounding stands between a reader and a refutation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from math import lcm, tan
from typing import Any

from rbpsym.decide import enclosure as e
from rbpsym.decide.assumptions import Assumptions, Range
from rbpsym.decide.enclosure import Number, Outside
from rbpsym.field import PI_TERM, Monomial, Poly, Scalar, atoms
from rbpsym.field.normal import turn, turned
from rbpsym.frozen import Frozen, field

Turn = tuple[Number, Number]


class Point(Frozen):
    """numbers: value of each plain name. angles: (cos, sin) of name/parts for each angle name."""

    numbers: Mapping[str, Fraction]
    angles: Mapping[str, tuple[Fraction, Fraction]] = field(default_factory=dict)
    parts: Mapping[str, int] = field(default_factory=dict)
    known: dict[int, Number] = field(default_factory=dict, compare=False)

    def value(self, scalar: Scalar) -> Number:
        """The value of a scalar. Raises Outside where it has none."""
        num = self.poly(scalar.num)
        den = self.poly(scalar.den)
        return num if den == 1 else num * e.reciprocal(den)

    def poly(self, poly: Poly) -> Number:
        """The value of a polynomial."""
        total: Number = Fraction(0)
        for m, c in poly.terms.items():
            total = total + self._monomial(m) * Fraction(c)
        return total

    def _monomial(self, m: Monomial) -> Number:
        product: Number = Fraction(1)
        for index, exponent in m:
            factor = self.atom(index)
            product = product * (factor if exponent == 1 else power(factor, exponent))
        return product

    def atom(self, index: int) -> Number:
        """The value of an atom."""
        if index not in self.known:
            found = atoms.atom(index)
            self.known[index] = VALUES.get(found.kind, _unknown)(self, found.arg)
        return self.known[index]

    def symbol(self, name: str) -> Number:
        """The value of a name."""
        if name in self.angles:
            c, s = self.angles[name]
            return 2 * self.parts[name] * e.atan(s / (1 + c))
        return self.numbers[name]

    def turn(self, angle: Poly) -> Turn:
        """(cos, sin) of an angle."""
        result: Turn = (Fraction(1), Fraction(0))
        for m, c in angle.terms.items():
            result = turn(result, self._part(m, Fraction(c)))
        return result

    def _part(self, m: Monomial, c: Fraction) -> Turn:
        name = angle_name(m)
        if name is not None and name in self.angles and (c * self.parts[name]).denominator == 1:
            return turned(self.angles[name], int(c * self.parts[name]), QUARTERS[0])
        if m == PI_TERM and (2 * c).denominator == 1:
            return QUARTERS[int(2 * c) % 4]
        return e.turn_of(self._monomial(m) * c)


QUARTERS: tuple[Turn, ...] = tuple((Fraction(c), Fraction(s)) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1)))


def power(number: Number, exponent: int) -> Number:
    """An integer power. Raises Outside for a negative power of zero."""
    return number**exponent if exponent >= 0 else e.reciprocal(number) ** -exponent


def _unknown(point: Point, arg: object) -> Number:
    raise Outside("a quantity that is known only by name")


def _sign(point: Point, arg: Scalar) -> Number:
    found = e.sign_of(point.value(arg))
    if found is None:
        raise Outside("a sign that the enclosure does not tell")
    return Fraction(found)


def _of(function: Callable[[Number], Number]) -> Callable[[Point, Scalar], Number]:
    return lambda point, arg: function(point.value(arg))


VALUES: dict[str, Callable[[Point, Any], Number]] = {
    "symbol": lambda point, name: e.pi() if name == "pi" else point.symbol(name),
    "cos": lambda point, angle: point.turn(angle)[0],
    "sin": lambda point, angle: point.turn(angle)[1],
    "root": _of(e.root),
    "exp": _of(e.exp),
    "ln": _of(e.ln),
    "atan": _of(e.atan),
    "asin": _of(e.asin),
    "acos": _of(e.acos),
    "elliptic_k": _of(e.elliptic_k),
    "elliptic_e": _unknown,
    "sign": _sign,
}


def angle_name(m: Monomial) -> str | None:
    """The name of an angle that is a plain symbol (not π)."""
    if len(m) != 1 or m[0][1] != 1 or m[0][0] == atoms.PI:
        return None
    return atoms.symbol_name(m[0][0])


def all_atoms(scalars: Iterable[Scalar]) -> set[int]:
    """All atoms of the scalars, those inside angles, roots and functions too."""
    found: set[int] = set()
    waiting = [index for scalar in scalars for index in scalar.atoms()]
    while waiting:
        index = waiting.pop()
        if index not in found:
            found.add(index)
            arg = atoms.atom(index).arg
            waiting.extend(arg.atoms() if isinstance(arg, (Scalar, Poly)) else ())
    return found


def names_of(scalars: Iterable[Scalar]) -> list[str]:
    """The names on which the scalars depend, in alphabetic order, without π."""
    found = {atoms.symbol_name(index) for index in all_atoms(scalars)}
    return sorted(name for name in found if name and name != "pi")


def angle_parts(scalars: Iterable[Scalar]) -> dict[str, int]:
    """For each name that is an angle: into how many parts its multiples divide it."""
    parts: dict[str, int] = {}
    for index in all_atoms(scalars):
        found = atoms.atom(index)
        if found.kind in ("cos", "sin"):
            for m, c in found.arg.terms.items():
                name = angle_name(m)
                if name:
                    parts[name] = lcm(parts.get(name, 1), Fraction(c).denominator)
    return parts


def with_bounds(names: Iterable[str], assumptions: Assumptions) -> list[str]:
    """The names and those that stand in the bounds of their ranges."""
    found, waiting = set(), list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting.extend(names_of(bound for bound in assumptions.range_of(name) if bound is not None))
    return sorted(found)


SIGN_TESTS: dict[str, Callable[[int | None], bool]] = {
    "positive": lambda sign: sign == 1,
    "nonnegative": lambda sign: sign in (0, 1),
    "nonzero": lambda sign: sign in (1, -1),
    "real": lambda sign: True,
}


def satisfies(point: Point, name: str, assumptions: Assumptions) -> bool:
    """Whether the point surely fulfils what is assumed of one name."""
    if assumptions.sign_of(name) == "real" and assumptions.range_of(name) == (None, None):
        return True
    number = point.symbol(name)
    if not SIGN_TESTS[assumptions.sign_of(name)](e.sign_of(number)):
        return False
    lower, upper = assumptions.range_of(name)
    try:
        above = lower is None or e.sign_of(number - point.value(lower)) == 1
        return above and (upper is None or e.sign_of(point.value(upper) - number) == 1)
    except e.Outside:  # a bound has no value there
        return False


def _fractions(text: str) -> tuple[Fraction, ...]:
    return tuple(Fraction(part) for part in text.split())


POSITIVE = _fractions("1 2 3 4 5 1/2 6 7 3/2 8 9 1/3 10 12 1/10 13 15 20 100 1/100")
REAL = _fractions("1 2 -1 3 -2 1/2 -3 4 -1/2 5 -5 7 1/3 -4 10 -10 1/10 -1/10 100 -100 0")
TANGENTS = _fractions("1/3 1/2 2/5 1/4 2/3 -1/3 2 -1/2 3 -2 1/5 3/4 -1/4 3/7 -3 1/10 4/5 -4/5 1/20 9/10 5 -1/20")


def _circle(tangent: Fraction) -> tuple[Fraction, Fraction]:
    scale = 1 / (1 + tangent * tangent)
    return (1 - tangent * tangent) * scale, 2 * tangent * scale


CIRCLE = tuple(map(_circle, TANGENTS))


def points(scalars: Iterable[Scalar], assumptions: Assumptions, most: int = 60) -> Iterator[Point]:
    """Points that satisfy the assumptions, simple ones first."""
    scalars = list(scalars)
    names, parts = with_bounds(names_of(scalars), assumptions), angle_parts(scalars)
    ranges = {name: assumptions.range_of(name) for name in names}
    options = {name: _options(parts.get(name), assumptions.sign_of(name), _numeric(ranges[name])) for name in names}
    if not all(options.values()):
        return
    tied = [name for name in names if _numeric(ranges[name]) != ranges[name]]  # which the options do not see
    seen = 0
    for k in range(8 * most):
        point = _pick(options, parts, k)
        if all(satisfies(point, name, assumptions) for name in tied):
            yield point
            seen += 1
        if seen >= most or not names:
            return


def _pick(options: dict[str, tuple[Any, ...]], parts: dict[str, int], k: int) -> Point:
    """The k-th choice: all first options, then shifted and finally scattered ones."""
    chosen = {}
    for place, (name, values) in enumerate(options.items()):
        step = k + place * (k > 0) if k < 6 else k * (2 * place + 1) + place * (k // 7)
        chosen[name] = values[step % len(values)]
    angles = {name: chosen[name] for name in parts if name in chosen}
    return Point({n: v for n, v in chosen.items() if n not in angles}, angles, parts)


@cache
def _options(parts: int | None, sign: str, bounds: Range) -> tuple[Any, ...]:
    """Values of a name that its sign and its numeric bounds admit."""
    name, inside = "x", _inside(bounds)
    own = Assumptions({name: sign}, {name: bounds})
    if parts:
        circle = [*CIRCLE, *(_circle(_near(tan(float(x) / (2 * parts)))) for x in inside)]
        return tuple(c for c in circle if satisfies(Point({}, {name: c}, {name: parts}), name, own))
    values = POSITIVE if sign == "positive" else REAL
    return tuple(v for v in (*values, *inside) if satisfies(Point({name: v}), name, own))


def _inside(bounds: Range) -> list[Fraction]:
    """A fraction between numeric bounds, however close, or beyond the only one."""
    found = [float(e.ends(Point({}).value(bound))[0]) for bound in bounds if bound is not None]
    if len(found) == 2:
        return [_near(sum(found) / 2), Fraction(sum(found) / 2).limit_denominator(10**6)]
    return [_near(end + step) for end in found for step in (1, -1)]


def _near(value: float) -> Fraction:
    return Fraction(value).limit_denominator(30)


def _numeric(bounds: Range) -> Range:
    lower, upper = (bound if bound is not None and not names_of([bound]) else None for bound in bounds)
    return lower, upper
