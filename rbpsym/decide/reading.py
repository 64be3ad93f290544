"""Values read into independent generators: tan(a/2), roots of factors, logarithms of factors.

√(Π fᵏ) = Π |f|^(k/2) holds wherever the left side exists, so one generator √|f| a factor f is
enough, and the sign of f says what |f| is. `shallow` reading takes only monomials out of a
radicand; `deep` reading passes to t = tan(a/2), where the field is purely transcendental, and
factors. A divisor that is no monomial is a generator `factor` until `cleared`.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import prod
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.factoring import Factors, cleared, divisor, primes, reduced, split
from rbpsym.decide.inverses import inverse_image, turn_of_inverse
from rbpsym.decide.signs import sign
from rbpsym.errors import Undecided
from rbpsym.field import PI_TERM, Bases, Scalar, atoms, cosine, lift, root, sine
from rbpsym.field.normal import turn, turned
from rbpsym.field.poly import ONE, ZERO, Monomial, Poly, accumulate, constant, generator, inverse
from rbpsym.frozen import Frozen, Walker, field

Turn = tuple[Poly, Poly]


class Constraint(Frozen):
    """sign × Π factorᵏ ≥ 0, from a root; or > 0, from a logarithm (`is_strict`)."""

    sign: int
    factors: Factors
    is_strict: bool

    def odd(self) -> list[Poly]:
        """The factors that decide its sign."""
        return [factor for factor, k in self.factors.items() if k % 2]


class CaseReading(Walker):
    """One way of reading, in one case of signs.

    case: the signs (1, -1) of factors whose sign is not known. Signs that are missing are taken
    as 1 and noted in `assumed`.
    """

    assumptions: Assumptions
    bases: Bases
    deep: bool
    case: dict[Poly, int]
    assumed: list[Poly] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    images: dict[tuple[int, int], Poly] = field(default_factory=dict)

    def scalar(self, value: Scalar) -> Poly:
        """The image of a value."""
        num = self.poly(value.num)
        return num if value.den is ONE else num * self.raised(self.poly(value.den), -1)

    def poly(self, poly: Poly) -> Poly:
        """The image of a polynomial."""
        parts = []
        for m, c in poly.terms.items():
            product = ONE
            for index, exponent in m:
                product = product * self.power(index, exponent)
            parts.append((c, product))
        return accumulate(parts)

    def power(self, index: int, exponent: int) -> Poly:
        """The image of a power of a generator."""
        key = (index, exponent)
        if key not in self.images:
            found = atoms.atom(index)
            rule = IMAGES.get(found.kind)
            image = rule(self, found.arg) if rule else None
            self.images[key] = generator(index) ** exponent if image is None else self.raised(image, exponent)
        return self.images[key]

    def raised(self, image: Poly, exponent: int) -> Poly:
        """An integer power; what can't be divided by becomes a `factor`."""
        if exponent >= 0 or image.is_monomial():
            return image**exponent
        whole, divisors = cleared(image)
        if not whole.terms:
            raise ZeroDivisionError
        rational, powers = whole.content()
        rest = whole.scaled(1 / rational, inverse(powers))
        result = Poly({powers: rational}) ** exponent * divisor(rest, exponent)
        for factor, k in divisors.items():
            result = result * factor ** (-k * exponent)
        return result

    def mask(self, factor: Poly) -> int:
        """What sign a factor may have in any case."""
        return sign(Scalar(factor), self.assumptions, factoring=False).mask

    def sign(self, factor: Poly) -> int:
        """The sign of a factor in this case."""
        mask = self.mask(factor)
        if not mask & 1:
            return 1
        if not mask & 4:
            return -1
        if factor not in self.case:
            self.case[factor] = 1
            self.assumed.append(factor)
        return self.case[factor]

    def constrain(self, coefficient: Fraction, factors: Factors, *, is_strict: bool) -> None:
        """Note under which condition a root or logarithm exists."""
        self.constraints.append(Constraint(1 if coefficient > 0 else -1, factors, is_strict))

    def is_broken(self, constraint: Constraint) -> bool:
        """Whether a constraint contradicts the signs of this case."""
        return prod((self.sign(factor) for factor in constraint.odd()), start=constraint.sign) < 0

    def factored(self, value: Scalar) -> tuple[Fraction, Factors]:
        """A value as coefficient × product of integer powers of factors."""
        coefficient = Fraction(1)
        found: dict[Poly, int] = {}
        for poly, direction in ((value.num, 1), (value.den, -1)):
            c, parts = self._factors(self.poly(poly) if poly is not ONE else ONE)
            coefficient *= c**direction if c else 0
            for factor, k in parts.items():
                found[factor] = found.get(factor, 0) + k * direction
        return coefficient, found

    def _factors(self, image: Poly) -> tuple[Fraction, Factors]:
        whole, divisors = cleared(image)
        if not whole.terms:
            return Fraction(0), {}
        _, powers = whole.content()
        rest = reduced(whole.scaled(1, inverse(powers)))
        if not rest.terms:
            return Fraction(0), {}
        rational, more = rest.content()
        found: Factors = {}
        for index, k in (*powers, *more):
            found[generator(index)] = found.get(generator(index), 0) + k
        for whole, times in ((rest.scaled(1 / rational, inverse(more)), 1), *((f, -k) for f, k in divisors.items())):
            coefficient, parts = split(whole, self.deep)
            rational *= coefficient**times
            for factor, k in parts:
                found[factor] = found.get(factor, 0) + k * times
        return rational, found

    def absolute(self, factor: Poly, exponent: int) -> Poly:
        """|factor|^exponent."""
        factor = factor if self.sign(factor) > 0 else -factor
        return factor**exponent if exponent >= 0 or factor.is_monomial() else divisor(factor, exponent)

    def half_power(self, factor: Poly, exponent: int) -> Poly:
        """|factor|^(exponent/2)."""
        whole = self.absolute(factor, exponent // 2)
        if exponent % 2 == 0:
            return whole
        inside = factor if self.sign(factor) > 0 else -factor
        return whole * generator(atoms.intern("root", Scalar(inside)))


def _of_root(reading: CaseReading, arg: Scalar) -> Poly:
    """√(c Π fᵏ) = √|c| Π |f|^(k/2)."""
    from rbpsym.decide.radicals import denested

    coefficient, found = reading.factored(arg)
    if not coefficient:
        return ZERO
    reading.constrain(coefficient, found, is_strict=False)
    nested = denested(reading, coefficient, found)
    image = root(lift(abs(coefficient))).num if nested is None else nested.image
    for factor, k in (found if nested is None else nested.others).items():
        image = image * reading.half_power(factor, k)
    return image


def _of_logarithm(reading: CaseReading, arg: Scalar) -> Poly:
    """ln(c Π fᵏ) = Σ over the primes of c, and Σ k ln |f|."""
    coefficient, found = reading.factored(arg)
    if not coefficient:
        raise Undecided("the logarithm of zero")
    reading.constrain(coefficient, found, is_strict=True)
    parts = [(k, _logarithm(constant(p))) for p, k in primes(abs(coefficient)).items()]
    parts += [(k, _logarithm(factor)) for factor, k in found.items()]
    return accumulate(parts)


def _logarithm(factor: Poly) -> Poly:
    """ln |factor|; of a root half that of the radicand, of an exponential its argument."""
    is_generator = factor.is_monomial() and len(next(iter(factor.terms))) == 1
    found = atoms.atom(next(iter(factor.atoms()))) if is_generator else None
    if found is not None and found.kind in ("exp", "root"):
        inside: Scalar = found.arg
        if found.kind == "exp" and inside.den is ONE:
            return inside.num
        if found.kind == "root":
            number = inside.number()
            return _logarithm(inside.num if number is None else constant(number)).scaled(Fraction(1, 2))
    return generator(atoms.intern("ln", Scalar(factor)))


def _wave(place: int) -> Callable[[CaseReading, Poly], Poly]:
    def image(reading: CaseReading, angle: Poly) -> Poly:
        return _turn_of(reading, angle)[place]

    return image


def _turn_of(reading: CaseReading, angle: Poly) -> Turn:
    """(cos, sin) of an angle in the base angles of the reading."""
    point, parts = (ONE, ZERO), dict(reading.bases)
    for m, c in angle.terms.items():
        if m == PI_TERM:
            constant_angle = Scalar(Poly({m: c}))
            point = turn(point, (cosine(constant_angle).num, sine(constant_angle).num))
        else:
            point = turned(_base(reading, m, parts[m]), int(c * parts[m]), point)
    return point


def _base(reading: CaseReading, m: Monomial, parts: int) -> Turn:
    known = turn_of_inverse(reading, m, parts)
    if known is not None:
        return known
    angle = Poly({m: Fraction(1, parts) if parts > 1 else 1})
    if not reading.deep:
        return generator(atoms.intern("cos", angle)), generator(atoms.intern("sin", angle))
    t = generator(atoms.intern("half", angle))
    below = divisor(ONE + t * t, -1)
    return (ONE - t * t) * below, t.scaled(2) * below


def _of_inverse(kind: str) -> Callable[[CaseReading, Scalar], Poly]:
    def image(reading: CaseReading, arg: Scalar) -> Poly:
        return inverse_image(reading, kind, arg)

    return image


IMAGES: dict[str, Callable[[CaseReading, Any], Poly | None]] = {
    "cos": _wave(0),
    "sin": _wave(1),
    "root": _of_root,
    "ln": _of_logarithm,
    "exp": _of_inverse("exp"),
    "asin": _of_inverse("asin"),
    "acos": _of_inverse("acos"),
    "atan": _of_inverse("atan"),
    "elliptic_k": _of_inverse("elliptic_k"),
    "elliptic_e": _of_inverse("elliptic_e"),
}
