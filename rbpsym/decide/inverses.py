"""Images of inverse functions and exponentials for `reading`."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import prod
from typing import TYPE_CHECKING

from rbpsym.decide.bounds import of_angle
from rbpsym.decide.factoring import PARTS, cleared, reduced
from rbpsym.decide.signs import sign
from rbpsym.field import ONE, PI, UNITY, Monomial, Poly, Scalar, atoms, generator, lift, quotient, root

if TYPE_CHECKING:
    from rbpsym.decide.reading import CaseReading, Turn

QUARTER = PI * Fraction(1, 2)
TERM_PARTS = 12  # other exponentials are powers of exp(term/12)
Inverse = Callable[["CaseReading", Scalar], Poly]


def turn_of_inverse(reading: CaseReading, m: Monomial, parts: int) -> Turn | None:
    """(cos, sin) of asin x, acos x, atan x, or of half of it; None for other angles."""
    if len(m) != 1 or m[0][1] != 1:
        return None
    found = atoms.atom(m[0][0])
    rule = TURNS.get((found.kind, parts))
    if rule is None:
        return None
    cosine, sine = rule(found.arg)
    return reading.scalar(cosine), reading.scalar(sine)


def _of_atan(x: Scalar) -> tuple[Scalar, Scalar]:
    cosine = 1 / root(1 + x * x)
    return cosine, x * cosine


def _half(turn: tuple[Scalar, Scalar]) -> tuple[Scalar, Scalar]:
    """Of half of an angle between -π/2 and π/2."""
    cosine = root((1 + turn[0]) / 2)
    return cosine, turn[1] / (2 * cosine)


TURNS: dict[tuple[str, int], Callable[[Scalar], tuple[Scalar, Scalar]]] = {
    ("asin", 1): lambda x: (root(1 - x * x), x),
    ("acos", 1): lambda x: (x, root(1 - x * x)),
    ("acos", 2): lambda x: (root((1 + x) / 2), root((1 - x) / 2)),
    ("asin", 2): lambda x: _half((root(1 - x * x), x)),
    ("atan", 1): _of_atan,
    ("atan", 2): lambda x: _half(_of_atan(x)),
}


def inverse_image(reading: CaseReading, kind: str, arg: Scalar) -> Poly:
    """The image of an inverse function or an exponential."""
    return INVERSES[kind](reading, arg)


def _asin(reading: CaseReading, arg: Scalar) -> Poly:
    return _odd(reading, "asin", arg, angle_of_sine)


def _atan(reading: CaseReading, arg: Scalar) -> Poly:
    return _odd(reading, "atan", arg, angle_of_tangent)


def _odd(reading: CaseReading, kind: str, arg: Scalar, angle_of: Callable[[Scalar], Scalar | None]) -> Poly:
    """An odd function: known values, the function of which it is the inverse, else a generator."""
    if not arg:
        return Poly({})
    if arg.num.terms[min(arg.num.terms)] < 0:
        return -_odd(reading, kind, -arg, angle_of)
    image = reading.scalar(arg)
    for value, turns in KNOWN[kind]:
        if image == value.num:
            return (PI * turns).num
    angle = angle_of(arg)
    if angle is not None and _is_principal(reading, angle):
        return reading.scalar(angle)
    return generator(atoms.intern(kind, _canonical(image, arg)))


def angle_of_sine(arg: Scalar) -> Scalar | None:
    """A if the argument is sin A, π/2 - A if it is cos A."""
    if arg.den is not ONE or len(arg.num) != 1:
        return None
    [(m, c)] = arg.num.terms.items()
    if c != 1 or len(m) != 1 or m[0][1] != 1:
        return None
    found = atoms.atom(m[0][0])
    if found.kind not in ("sin", "cos"):
        return None
    return Scalar(found.arg) if found.kind == "sin" else QUARTER - Scalar(found.arg)


def angle_of_tangent(arg: Scalar) -> Scalar | None:
    """A if the argument is sin A / cos A."""
    if arg.den is not ONE or len(arg.num) != 1:
        return None
    [(m, c)] = arg.num.terms.items()
    found = {atoms.atom(index).kind: (exponent, atoms.atom(index).arg) for index, exponent in m}
    if c != 1 or len(m) != 2 or set(found) != {"sin", "cos"}:
        return None
    (up, angle), (down, other) = found["sin"], found["cos"]
    if angle != other or up + down:
        return None
    return Scalar(angle) if up == 1 else QUARTER - Scalar(angle) if up == -1 else None


def _is_principal(reading: CaseReading, angle: Scalar) -> bool:
    """Whether the angle surely lies between -π/2 and π/2."""
    if angle.den is not ONE:
        return False
    found = of_angle(angle.num, reading.assumptions)
    if found.lower is None or found.upper is None:
        return False
    ends = found.lower + QUARTER, QUARTER - found.upper
    return all(sign(end, reading.assumptions, factoring=False).is_nonnegative for end in ends)


def _canonical(image: Poly, arg: Scalar) -> Scalar:
    """The argument in the generators of the reading."""
    whole, divisors = cleared(image)
    if any(exponent < 0 for _, exponent in whole.content()[1]):
        return arg
    return quotient(reduced(whole), prod((factor**k for factor, k in divisors.items()), start=ONE))


KNOWN = {
    "asin": (
        (UNITY, Fraction(1, 2)),
        (lift(Fraction(1, 2)), Fraction(1, 6)),
        (root(lift(2)) / 2, Fraction(1, 4)),
        (root(lift(3)) / 2, Fraction(1, 3)),
    ),
    "atan": ((UNITY, Fraction(1, 4)), (root(lift(3)) / 3, Fraction(1, 6)), (root(lift(3)), Fraction(1, 3))),
}


def _exp(reading: CaseReading, arg: Scalar) -> Poly:
    """exp of a sum as a product, exp(k ln f) as a power."""
    image = reading.scalar(arg)
    if any(atoms.atom(index).kind == "factor" for index in image.atoms()):
        return generator(atoms.intern("exp", _canonical(image, arg)))
    return prod((_exp_term(reading, m, Fraction(c)) for m, c in image.terms.items()), start=ONE)


def _exp_term(reading: CaseReading, m: Monomial, c: Fraction) -> Poly:
    found = atoms.atom(m[0][0]) if len(m) == 1 and m[0][1] == 1 else None
    is_power = found is not None and found.kind == "ln"
    if found is not None and is_power and (2 * c).denominator == 1:
        number = found.arg.number()
        if number is None:
            return reading.half_power(found.arg.num, int(2 * c))
        return (root(lift(number)) ** int(2 * c)).num
    parts = PARTS if is_power else TERM_PARTS
    if (c * parts).denominator == 1:
        return generator(atoms.intern("exp", Scalar(Poly({m: Fraction(1, parts)})))) ** int(c * parts)
    return generator(atoms.intern("exp", Scalar(Poly({m: c}))))


def _plain(kind: str) -> Inverse:
    return lambda reading, arg: generator(atoms.intern(kind, _canonical(reading.scalar(arg), arg)))


INVERSES: dict[str, Inverse] = {
    "exp": _exp, "asin": _asin, "acos": lambda reading, arg: QUARTER.num - _asin(reading, arg), "atan": _atan,
    "elliptic_k": _plain("elliptic_k"), "elliptic_e": _plain("elliptic_e"),
}  # fmt: skip
