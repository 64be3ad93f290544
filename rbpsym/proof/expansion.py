"""Values close to a place to first order: every symbol is q₀ + ε δq, and ε² = 0.

Products, quotients and functions of such truncated series are formed term by term, so that nothing of first order can
be left out: the remainder is of second order wherever no divisor and no radicand vanishes at the place (there a
division by zero is raised). No derivative and no substitution of `field.calculus` is used: this is the road of the
checkers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, reduce

from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, ONE, UNITY, Poly, Scalar, atoms, function, lift, symbol, total
from rbpsym.frozen import Frozen


class FirstOrder(Frozen):
    """value + ε slope."""

    value: Scalar
    slope: Scalar = NOTHING

    def __mul__(self, other: FirstOrder) -> FirstOrder:
        return FirstOrder(self.value * other.value, self.value * other.slope + self.slope * other.value)

    def __pow__(self, exponent: int) -> FirstOrder:
        if exponent < 0:
            under = self.value**exponent
            return FirstOrder(under, self.slope * under / self.value * exponent)
        return reduce(FirstOrder.__mul__, [self] * exponent, FirstOrder(UNITY))


def _root(arg: FirstOrder) -> FirstOrder:
    found = function("sqrt", arg.value)
    return FirstOrder(found, arg.slope / found / 2) if arg.slope else FirstOrder(found)


FUNCTIONS: Mapping[str, Callable[[FirstOrder], FirstOrder]] = {
    "cos": lambda a: FirstOrder(function("cos", a.value), -a.slope * function("sin", a.value)),
    "sin": lambda a: FirstOrder(function("sin", a.value), a.slope * function("cos", a.value)),
    "atan": lambda a: FirstOrder(function("atan", a.value), a.slope / (UNITY + a.value * a.value)),
    "exp": lambda a: FirstOrder(function("exp", a.value), a.slope * function("exp", a.value)),
    "ln": lambda a: FirstOrder(function("ln", a.value), a.slope / a.value),
    "root": _root,
}


def expanded(value: Scalar, images: Mapping[str, FirstOrder]) -> FirstOrder:
    """The value with series in the place of symbols. Raises Undecided for a function that has no rule here."""
    above = _poly(value.num, images)
    return above if value.den is ONE else above * _poly(value.den, images) ** -1


def _poly(poly: Poly, images: Mapping[str, FirstOrder]) -> FirstOrder:
    known = {index: _atom(index, images) for index in poly.atoms()}
    terms = []
    for monomial, coefficient in poly.terms.items():
        powers = [known[index] ** exponent for index, exponent in monomial]
        terms.append(reduce(FirstOrder.__mul__, powers, FirstOrder(lift(coefficient))))
    return FirstOrder(total(term.value for term in terms), total(term.slope for term in terms))


def _atom(index: int, images: Mapping[str, FirstOrder]) -> FirstOrder:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return images.get(found.arg) or FirstOrder(symbol(found.arg))
    arg = expanded(found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg), images)
    if found.kind in FUNCTIONS:
        return FUNCTIONS[found.kind](arg)
    if arg.slope:
        raise Undecided(f"no expansion of {found.kind} is known")
    return FirstOrder(function(found.kind, arg.value))


def part(value: Scalar, name: str) -> Scalar:
    """What multiplies a symbol in a value that is linear in it."""
    found = value.num.by_power(atoms.intern("symbol", name)).get(1, Poly({}))
    return Scalar(found) if value.den is ONE else Scalar(found) / Scalar(value.den)


class Nearby(Frozen):
    """The equations of motion to first order: Σ M α + C ν + K η for displacements η, speeds ν, accelerations α of the
    independent coordinates (`mass`, `drag`, `pull`); `rest` what is left of them, and of the conditions that tie
    coordinates, at rest in the place; `ties` the slopes of these conditions, all of which have to vanish."""

    mass: list[list[Scalar]]
    drag: list[list[Scalar]]
    pull: list[list[Scalar]]
    rest: list[Scalar]
    ties: list[Scalar]


def nearby(
    rows: Sequence[Scalar],
    conditions: Sequence[Scalar],
    names: Sequence[str],
    at: Mapping[str, Scalar],
    tied: Mapping[str, Sequence[Scalar]],
) -> Nearby:
    """Rows in coordinates, speeds `q_dot` and accelerations `q_ddot`, expanded about rest `at` a place, where `tied`
    coordinates are displaced by so much per displacement of each of the `names`."""
    return _nearby(tuple(rows), tuple(conditions), tuple(names), tuple(at.items()), tuple(tied.items()))


@lru_cache(maxsize=256)
def _nearby(
    rows: tuple[Scalar, ...],
    conditions: tuple[Scalar, ...],
    names: tuple[str, ...],
    places: tuple[tuple[str, Scalar], ...],
    ties: tuple[tuple[str, Sequence[Scalar]], ...],
) -> Nearby:
    at, tied = dict(places), dict(ties)
    shifts = {name: symbol(f"{name} away") for name in names}
    moved = {name: total(a * s for a, s in zip(parts, shifts.values(), strict=True)) for name, parts in tied.items()}
    images = {n: FirstOrder(at.get(n, symbol(n)), shift) for n, shift in (shifts | moved).items()}
    rates = [(f"{name}{dots}", symbol(f"{name} {dots}")) for name in names for dots in ("_dot", "_ddot")]
    images |= {name: FirstOrder(NOTHING, letter) for name, letter in rates}
    found = [expanded(row, images) for row in rows]
    held = [expanded(condition, images) for condition in conditions]

    def matrix(mark: str) -> list[list[Scalar]]:
        return [[part(row.slope, f"{name} {mark}") for name in names] for row in found]

    slopes = [part(row.slope, f"{name} away") for row in held for name in names]
    return Nearby(matrix("_ddot"), matrix("_dot"), matrix("away"), [row.value for row in (*found, *held)], slopes)
