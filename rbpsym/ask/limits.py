"""Limits of exact values: the leading term of the power series at a place, from one side, or at infinity."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.rooted import root_of, rooted
from rbpsym.decide.signs import sign
from rbpsym.errors import LimitError, Undecided, all_there
from rbpsym.field import ONE, Coefficient, Monomial, Poly, apart, at_most, atoms, depends_on, generator, is_zero, names_in, short
from rbpsym.field.calculus import atom_depends, derivative, split_factor, substitute
from rbpsym.field.roots import without_even_roots
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, symbol
from rbpsym.frozen import Frozen

SMALL = "epsilon_"  # what goes to zero from above
LENGTH = 5  # terms of a series
MOST_PRODUCTS = 20_000


class Leading(Frozen):
    """coefficient × ε^order, ε > 0 being the distance from the place, or one over the size of what goes to infinity; `image`:
    the value as a function of ε where `power` is 1, of √ε where it is 2; `there`: so the quantity itself."""

    coefficient: Scalar
    order: Fraction
    image: Scalar
    there: Scalar
    power: int = 1

    @property
    def limit(self) -> Scalar | None:
        """The limit; None where it is infinite."""
        return None if self.order < 0 else self.coefficient if not self.order else NOTHING


def leading(value: Scalar, name: str, to: Scalar | None, given: Assumptions, side: int = 1) -> Leading | None:
    """The leading term for name → to from above (`side` 1) or below (-1); for `to` None: → ∞ or -∞. Squares of what is declared
    positive leave their roots.

    None where no such term is found, as of what vanishes identically.
    """
    try:
        with apart(), at_most(MOST_PRODUCTS):
            for power in (1, 2):  # √ε is a power series in δ with ε = δ²
                step = symbol(SMALL) ** power * side
                there = 1 / step if to is None else to + step
                image = substitute(value, {name: there})
                found = _series(image, given)
                if found is not None:
                    break
    except (LimitError, Undecided, ZeroDivisionError):
        return None
    first = None if found is None else next((k for k, term in enumerate(found.terms) if not is_zero(term)), None)
    if found is None or first is None:
        return None
    return Leading(short(found.terms[first]), Fraction(found.start + first, power), image, there, power)


def squeezed(value: Scalar, name: str, to: Scalar | None, given: Assumptions, side: int = 1) -> str | None:
    """A symbol in a value to which the declared ranges leave no value in the limit, as none is left to μ < b/h for b → 0, nor
    to M > m for M → 0."""
    own = of_symbol(name, given)
    ends = ((own.lower, 1), (own.upper, -1))
    gaps = [end if to is None else (end - to) * way for end, way in ends[to is None:] if end is not None]
    if any(to is None or sign(gap, given).kind == "positive" for gap in gaps):
        return name
    for other in sorted(names_in(value) - {name}):
        limits = of_symbol(other, given)
        width = NOTHING if limits.lower is None or limits.upper is None else limits.upper - limits.lower
        if depends_on(width, name) and ((found := leading(width, name, to, given, side)) is None or found.order > 0):
            return other
    return None


class Series(Frozen):
    """Σ terms[k] ε^(start + k), as far as the terms go."""

    start: int
    terms: tuple[Scalar, ...]

    def __add__(self, other: Series) -> Series:
        low = min(self.start, other.start)
        first, second = ([NOTHING] * (s.start - low) + [*s.terms] for s in (self, other))
        return Series(low, tuple(a + b for a, b in zip(first, second, strict=False)))

    def __mul__(self, other: Series) -> Series:
        return Series(self.start + other.start, _convolved(self.terms, other.terms))

    def from_first(self) -> Series | None:
        """With a first term that is not zero; None if there is none."""
        first = next((k for k, term in enumerate(self.terms) if not is_zero(term)), None)
        return None if first is None else Series(self.start + first, self.terms[first:])


def _convolved(a: Sequence[Scalar], b: Sequence[Scalar]) -> tuple[Scalar, ...]:
    return tuple(short(sum((a[i] * b[k - i] for i in range(k + 1)), NOTHING)) for k in range(min(len(a), len(b))))


def _inverse(series: Series) -> Series | None:
    found = series.from_first()
    if found is None:
        return None
    terms = [1 / found.terms[0]]
    for k in range(1, len(found.terms)):
        terms.append(-sum((found.terms[i] * terms[k - i] for i in range(1, k + 1)), NOTHING) / found.terms[0])
    return Series(-found.start, tuple(terms))


def _series(value: Scalar, given: Assumptions) -> Series | None:
    above = _of_poly(value.num, given)
    if value.den is ONE or above is None:
        return above
    below = _of_poly(value.den, given)
    below = None if below is None else _inverse(below)
    return None if below is None else above * below


def _constant(value: Scalar) -> Series:
    return Series(0, (value, *[NOTHING] * (LENGTH - 1)))


def _of_poly(poly: Poly, given: Assumptions) -> Series | None:
    moving = [index for index in poly.atoms() if atom_depends(index, SMALL)]
    found = all_there(_of_atom(index, given) for index in moving)
    if found is None:
        return None
    known = dict(zip(moving, found, strict=True))
    groups: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        free, bound = split_factor(m, SMALL)
        groups.setdefault(bound, {})[free] = c
    total: Series | None = None
    for bound, rest in groups.items():
        product: Series | None = _constant(Scalar(Poly(rest)))
        for index, exponent in bound:
            factor = known[index] if exponent > 0 else _inverse(known[index])
            for _ in range(abs(exponent)):
                product = None if factor is None or product is None else product * factor
        if product is None:
            return None
        total = product if total is None else total + product
    return total or _constant(NOTHING)


def _of_atom(index: int, given: Assumptions) -> Series | None:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return Series(1, (UNITY, *[NOTHING] * (LENGTH - 1)))
    if found.kind == "root":
        return _of_root(found.arg, given)
    if found.kind in POWERS and is_zero(substitute(found.arg, {SMALL: NOTHING})):
        return _composed(POWERS[found.kind], _series(found.arg, given))
    inner = _series(found.arg, given) if found.kind == "exp" else None
    inner = inner and inner.from_first()
    if inner and inner.start < 0 and sign(inner.terms[0], given).kind == "negative":
        return _constant(NOTHING)  # it vanishes faster than any power
    terms, value, factorial = [], Scalar(generator(index)), 1
    for k in range(LENGTH):
        terms.append(rooted(substitute(value, {SMALL: NOTHING}), given) / factorial)
        value, factorial = derivative(value, SMALL), factorial * (k + 1)
    return Series(0, tuple(terms))


# of the parameter m, in units of π/2 (Abramowitz and Stegun, 17.3.11 and 17.3.12)
POWERS = {
    "elliptic_k": (Fraction(1), Fraction(1, 4), Fraction(9, 64), Fraction(25, 256), Fraction(1225, 16384)),
    "elliptic_e": (Fraction(1), Fraction(-1, 4), Fraction(-3, 64), Fraction(-5, 256), Fraction(-175, 16384)),
}


def _composed(powers: Sequence[Fraction], inner: Series | None) -> Series | None:
    """(π/2) Σ c_k mᵏ of what goes to zero."""
    total: Series | None = _constant(NOTHING)
    for power in reversed(powers):
        total = None if inner is None or total is None else total * inner + _constant(PI / 2 * power)
    return total


def _of_root(radicand: Scalar, given: Assumptions) -> Series | None:
    inner = _series(radicand, given)
    inner = None if inner is None else inner.from_first()
    if inner is None or inner.start % 2:
        return None
    first = root_of(without_even_roots(inner.terms[0]), given)
    terms = [first]
    for k in range(1, len(inner.terms)):
        mixed = sum((terms[i] * terms[k - i] for i in range(1, k)), NOTHING)
        terms.append(without_even_roots((inner.terms[k] - mixed) / first / 2))
    return Series(inner.start // 2, tuple(terms))
