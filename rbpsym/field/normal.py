"""Normal forms modulo sin² + cos² = 1, multiple angles and √x² = x; the exact zero test.

Angles are written in base angles (the monomials of all angles that occur, divided by the
common denominator of their coefficients); then sin² is replaced by 1 - cos², even powers of
roots by their radicands. The field over ℚ of parameters, one sine and cosine a base angle,
is exact: a normal form without terms means identically zero, and with no roots the converse
holds too.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import comb, lcm
from typing import Any, TypeVar

from rbpsym.field import atoms
from rbpsym.field.effort import remembered, spend
from rbpsym.field.modular import is_surely_nonzero
from rbpsym.field.poly import ONE, UNIT, ZERO, Monomial, Poly, accumulate, constant, divided, generator, times
from rbpsym.field.scalar import Scalar, quotient
from rbpsym.field.trig import PI_TERM, cosine, sine

Bases = tuple[tuple[Monomial, int], ...]
T = TypeVar("T", bound=Any)  # polynomials or numbers


def is_zero(value: Scalar) -> bool:
    """Whether the normal form of the numerator has no terms (True is a proof)."""
    if not value.num.terms:
        return True
    return not is_surely_nonzero(value.num) and not normal(without_inverses(value.num)).terms


def without_inverses(poly: Poly) -> Poly:
    """The polynomial times the least monomial that leaves no negative power of a sine or cosine."""
    powers = {i: e for i, e in poly.content()[1] if e < 0 and atoms.atom(i).kind in ("cos", "sin")}
    return poly.scaled(1, tuple((i, -e) for i, e in powers.items())) if powers else poly


def same(a: Scalar, b: Scalar) -> bool:
    """Whether a - b has no terms in normal form (True is a proof)."""
    return a == b or is_zero(a - b)


def normal(poly: Poly, bases: Bases | None = None) -> Poly:
    """The normal form of a polynomial."""
    bases = bases_of(poly) if bases is None else bases
    return reduce_roots(reduce_squares(in_bases(poly, bases)))


def is_rooted(poly: Poly) -> bool:
    """Whether a square root occurs in the polynomial."""
    return any(atoms.atom(index).kind == "root" for index in poly.atoms())


def has_roots(value: Scalar) -> bool:
    """Whether a square root occurs in it, in an angle or a function too."""
    return any(map(_holds_root, value.atoms()))


@lru_cache(maxsize=16384)
def _holds_root(index: int) -> bool:
    found = atoms.atom(index)
    return found.kind == "root" or (isinstance(found.arg, (Scalar, Poly)) and any(map(_holds_root, found.arg.atoms())))


def bases_of(*polys: Poly) -> Bases:
    """Base angles: each monomial of an angle with the common denominator of its multiples."""
    denominators: dict[Monomial, int] = {}
    for index in {i for poly in polys for i in poly.atoms()}:
        found = atoms.atom(index)
        if found.kind in ("cos", "sin"):
            for m, c in found.arg.terms.items():
                denominators[m] = lcm(denominators.get(m, 1), c.denominator)
    return tuple(sorted(denominators.items()))


def in_bases(poly: Poly, bases: Bases) -> Poly:
    """All sines and cosines written in those of the base angles."""
    images = {i: _image(i, bases) for i in poly.atoms()}
    changed = {i: image for i, image in images.items() if image is not None}
    return substitute(poly, changed) if changed else poly


def angles_apart(value: Scalar) -> Scalar:
    """The value with sines and cosines of sums written in those of their base angles."""
    bases = bases_of(value.num, value.den)
    return quotient(in_bases(value.num, bases), in_bases(value.den, bases))


def substitute(poly: Poly, images: dict[int, Poly]) -> Poly:
    """The polynomial with atoms replaced by polynomials (negative powers: monomials only)."""
    parts: list[tuple[int | Fraction, Poly]] = []
    powers: dict[tuple[int, int], Poly] = {}
    for m, c in poly.terms.items():
        product = Poly({tuple(item for item in m if item[0] not in images): 1})
        for index, exponent in m:
            if index in images:
                key = (index, exponent)
                if key not in powers:
                    powers[key] = _power(images[index], index, exponent)
                product = product * powers[key]
        parts.append((c, product))
    return accumulate(parts)


def _power(image: Poly, index: int, exponent: int) -> Poly:
    if exponent < 0 and not image.is_monomial():
        return generator(index) ** exponent
    return image**exponent


@lru_cache(maxsize=4096)
def _image(index: int, bases: Bases) -> Poly | None:
    """The atom in base angles; None if it is one already or no sine or cosine."""
    found = atoms.atom(index)
    if found.kind not in ("cos", "sin"):
        return None
    denominators, point = dict(bases), (ONE, ZERO)
    for m, c in found.arg.terms.items():
        if m == PI_TERM:
            point = turn(point, _constant_turn(c))
            continue
        point = turn(point, _multiple(m, denominators[m], int(c * denominators[m])))
    image = point[found.kind == "sin"]
    return None if image == generator(index) else image


def _constant_turn(turns: int | Fraction) -> tuple[Poly, Poly]:
    angle = Scalar(Poly({PI_TERM: turns}))
    return cosine(angle).num, sine(angle).num


@lru_cache(maxsize=4096)
def _multiple(m: Monomial, denominator: int, times: int) -> tuple[Poly, Poly]:
    angle = Poly({m: Fraction(1, denominator) if denominator > 1 else 1})
    point = generator(atoms.intern("cos", angle)), generator(atoms.intern("sin", angle))
    return turned(point, times, (ONE, ZERO))


def turn(a: tuple[T, T], b: tuple[T, T]) -> tuple[T, T]:
    """(cos, sin) of the sum of two angles."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def turned(point: tuple[T, T], times: int, result: tuple[T, T]) -> tuple[T, T]:
    """(cos, sin) of so many times an angle, beyond the angle of `result`."""
    step = point if times >= 0 else (point[0], -point[1])
    for _ in range(abs(times)):
        result = turn(result, step)
    return result


def partner(index: int) -> int | None:
    """The sine's cosine and the cosine's sine; None for other atoms."""
    found = atoms.atom(index)
    other = {"cos": "sin", "sin": "cos"}.get(found.kind)
    return atoms.intern(other, found.arg) if other else None


def partner_of(index: int) -> int:
    """The same for what is a sine or cosine."""
    other = partner(index)
    if other is None:
        raise ValueError("this is neither a sine nor a cosine")
    return other


def reduce_squares(poly: Poly) -> Poly:
    """sin² replaced by 1 - cos² everywhere."""
    for index in poly.atoms():
        if atoms.atom(index).kind == "sin":
            poly = without_squares(poly, index)
    return poly


def without_squares(poly: Poly, index: int) -> Poly:
    """Powers ≥ 2 of a sine (or cosine) replaced through its partner: s^(2h) = Σ (h over k) (-c²)^k."""
    powers = [next((e for i, e in m if i == index), 0) for m in poly.terms]
    if max(powers, default=0) < 2:
        return poly
    other, result = partner_of(index), dict[Monomial, int]()
    denominator, terms = poly.whole()
    for power, (m, c) in zip(powers, terms.items(), strict=True):
        if power < 2:
            result[m] = result.get(m, 0) + c
            continue
        half, keep = divmod(power, 2)
        rest = tuple([(i, keep if i == index else e) for i, e in m if i != index or keep])
        for k, number in enumerate(_signed_row(half)):
            key = times(rest, ((other, 2 * k),)) if k else rest
            result[key] = result.get(key, 0) + c * number
    spend(len(poly) + len(result))
    return divided(result, denominator)


@lru_cache(maxsize=64)
def _signed_row(n: int) -> tuple[int, ...]:
    """Coefficients of (1 - x)ⁿ."""
    return tuple(comb(n, k) * (-1) ** k for k in range(n + 1))


def _squared(poly: Poly) -> set[int]:
    """Atoms that occur to a power of two or more."""
    return {i for m in poly.terms for i, e in m if e > 1}


def short(value: Scalar) -> Scalar:
    """The value with sin² + cos² = 1 used where that makes it shorter."""
    num = shorten(value.num)
    return value if num is value.num else Scalar(num) if value.den is ONE else quotient(num, value.den)


def in_one_angle(value: Scalar) -> Scalar:
    """The value with sines and cosines of multiples in those of the angle itself, where that is shorter."""
    num = shorten(in_bases(value.num, bases_of(value.num)))
    return quotient(num, value.den) if len(num) < len(value.num) else value


@remembered
def shorten(poly: Poly) -> Poly:
    """The shortest of: as it is, without sin², without cos² (angle by angle); without squares of numbers' roots."""
    squared = _squared(poly)
    for index in [i for i in squared if is_root_of_number(i)]:
        poly = _without_even_powers(poly, index, atoms.atom(index).arg.num)
    if len(poly) < 2:
        return poly
    for index in sorted(poly.atoms()) if squared else ():
        if index in squared and atoms.atom(index).kind in ("cos", "sin") and _merges(poly, index):
            other = without_squares(poly, index)
            if len(other) < len(poly):
                poly, squared = other, _squared(other)
    return poly


def _merges(poly: Poly, index: int) -> bool:
    """Whether some term with a square of the sine (or cosine) differs from another by sines and cosines of its angle alone."""
    other = partner(index)
    rests, squares = set[Monomial](), set[Monomial]()
    for m in poly.terms:
        power, rest = 0, m
        for i, e in m:
            if i in (index, other):
                power = e if i == index else power
                rest = tuple([item for item in m if item[0] != index and item[0] != other])
        if rest in (rests if power > 1 else squares):
            return True
        rests.add(rest)
        if power > 1:
            squares.add(rest)
    return False


def is_root_of_number(index: int) -> bool:
    """Whether an atom is the root of a number."""
    found = atoms.atom(index)
    return found.kind == "root" and found.arg.number() is not None


def reduce_roots(poly: Poly) -> Poly:
    """Even powers of roots replaced by their radicands.

    Where a radicand (or its denominator) would have to be divided by, the whole polynomial
    is multiplied by it instead: the result is the normal form up to a non-zero factor.
    """
    for _ in range(64):
        index = next((i for i in poly.atoms() if _has_square(poly, i)), None)
        if index is None:
            return poly
        poly = reduce_squares(_without_root_powers(poly, index))
    return poly


def _has_square(poly: Poly, index: int) -> bool:
    if atoms.atom(index).kind != "root":
        return False
    return any(power not in (0, 1) for power in poly.by_power(index))


def _without_root_powers(poly: Poly, index: int) -> Poly:
    radicand, parts = atoms.atom(index).arg, poly.by_power(index)
    halves = {power: power // 2 for power in parts}
    least, most = min(0, *halves.values()), max(0, *halves.values())
    result = []
    for power, part in parts.items():
        image = radicand.num ** (halves[power] - least) * radicand.den ** (most - halves[power])
        odd = ((index, 1),) if power % 2 else UNIT
        result.append((1, (part * image).scaled(1, odd)))
    return accumulate(result)


def without_even_roots(poly: Poly) -> Poly:
    """√x² = x, and 1/√x = √x/x where x is one term; unlike `reduce_roots`, the value stays the same."""
    for index in sorted(poly.atoms()):
        found = atoms.atom(index)
        if found.kind == "root" and found.arg.den is ONE:
            poly = _without_even_powers(poly, index, found.arg.num)
    return poly


def _without_even_powers(poly: Poly, index: int, radicand: Poly) -> Poly:
    parts, result = poly.by_power(index), []
    for power, part in parts.items():
        half = power // 2 if power > 0 or radicand.is_monomial() else 0
        left = power - 2 * half
        result.append((1, (part * radicand**half).scaled(1, ((index, left),) if left else UNIT)))
    return accumulate(result) if parts.keys() - {0, 1} else poly


def number(value: int | Fraction) -> Scalar:
    """A number as a Scalar."""
    return Scalar(constant(value))


def tidy(value: Scalar) -> Scalar:
    """Even powers of roots and sums of squares of sine and cosine worked out."""
    if value.den is not ONE:
        return quotient(shorten(value.num), value.den)
    return Scalar(shorten(without_even_roots(value.num)))
