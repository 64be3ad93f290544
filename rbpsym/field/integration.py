"""Antiderivatives of polynomials in a variable, its sines and cosines, and of exponentials.

`antiderivative` returns None where the integrand is outside the class; what it returns is
proved by the caller (differentiate, compare). The form is the one a textbook finds: an odd
power of sine or cosine by substitution, even powers by double angles, products of different
angles by sums, powers of the variable by parts.
"""

from __future__ import annotations

from fractions import Fraction

from rbpsym.field import atoms
from rbpsym.field.calculus import depends_on, derivative, split_factor, substitute
from rbpsym.field.normal import short, without_even_roots
from rbpsym.field.poly import ONE, Monomial, Poly, generator
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, generator_of, lift, quotient, symbol
from rbpsym.field.trig import cosine, sine


def definite(value: Scalar, name: str, lower: Scalar, upper: Scalar) -> Scalar | None:
    """∫_lower^upper value d(name); None if no antiderivative in the class is found."""
    found = antiderivative(value, name)
    if found is None:
        return None
    return substitute(found, {name: upper}) - substitute(found, {name: lower})


def antiderivative(value: Scalar, name: str) -> Scalar | None:
    """An antiderivative with respect to the symbol, or None."""
    num = without_even_roots(value.num)
    rooted = [i for i in num.atoms() if atoms.atom(i).kind == "root" and depends_on(Scalar(atoms.atom(i).arg), name)]
    if rooted:
        return _by_roots(num, quotient(ONE, value.den), rooted[0], name)
    if value.den is not ONE and depends_on(Scalar(value.den), name):
        return None
    groups: dict[Monomial, dict[Monomial, Fraction | int]] = {}
    for m, c in num.terms.items():
        free, bound = split_factor(m, name)
        groups.setdefault(bound, {})[free] = c
    total = NOTHING
    for bound, rest in groups.items():
        part = _monomial(bound, name)
        if part is None:
            return None
        total = total + part * Scalar(Poly(rest))
    return total * quotient(ONE, value.den) if value.den is not ONE else total


def with_logarithm(value: Scalar, name: str) -> tuple[Scalar, Scalar, Scalar] | None:
    """(f, c, D) with the antiderivative f + c ln D of a quotient N/D with a linear D, or with N = c D'; None for another one."""
    powers = [power for power in value.den.by_power(atoms.intern("symbol", name)) if power < 0]
    above, below = (Scalar(part) * symbol(name) ** -min(powers, default=0) for part in (value.num, value.den))
    slope = derivative(below, name)
    if not slope:
        return (found, NOTHING, UNITY) if (found := antiderivative(value, name)) is not None else None
    ratio = short(above / slope)
    if not depends_on(ratio, name):
        return NOTHING, ratio, below
    if depends_on(slope, name):
        return None
    rest = substitute(above, {name: symbol(name) - below / slope})
    whole = antiderivative(short((above - rest) / below), name)
    return None if whole is None else (whole, short(rest / slope), below)


def _by_roots(num: Poly, below: Scalar, index: int, name: str) -> Scalar | None:
    """∫ f dx + Σ ∫ c B' B^(e/2) dx with constant c: the powers of one root √B by themselves, the rest alone."""
    parts, inner = num.by_power(index), atoms.atom(index).arg
    slope, root_ = derivative(inner, name), Scalar(generator(index))
    total = NOTHING
    for exponent, part in parts.items():
        ratio = NOTHING if not exponent else short(Scalar(part) * below / slope)
        found = antiderivative(Scalar(part) * below, name) if not exponent else ratio * root_ ** (exponent + 2)
        if found is None or exponent == -2 or depends_on(ratio, name):
            return None
        total = total + (found / (exponent + 2) * 2 if exponent else found)
    return total


def _monomial(m: Monomial, name: str) -> Scalar | None:
    """An antiderivative of variable^n × exponentials, sines and cosines of it."""
    power, angles, growths = 0, dict[Poly, list[int]](), list[Scalar]()
    for index, exponent in m:
        found = atoms.atom(index)
        if found.kind == "symbol":
            power = exponent
        elif found.kind in ("cos", "sin") and _rate(found.arg, name):
            angles.setdefault(found.arg, [0, 0])[found.kind == "sin"] += exponent
        elif found.kind == "exp" and isinstance(found.arg, Scalar | Poly) and (rate := _rate(found.arg, name)):
            growths.append(rate * exponent)
        else:
            return None
    growth = short(sum(growths, NOTHING))
    if growths and not growth:
        return None
    if not (angles or growths):
        return _power(power, name)
    if power == 0 and len(angles) == 1 and not growths:
        [(angle, (cosines, sines))] = angles.items()
        return _single_angle(angle, cosines, sines, name)
    is_whole = power >= 0 and all(exponent >= 0 for pair in angles.values() for exponent in pair)
    if not is_whole:
        return None
    rest = Scalar(Poly({tuple((index, e) for index, e in m if atoms.atom(index).kind == "exp"): 1}))
    return _by_waves(power, angles, name, growth) * rest


def _rate(angle: Poly | Scalar, name: str) -> Scalar | None:
    """d(angle)/d(variable) if constant, else None."""
    rate = derivative(angle if isinstance(angle, Scalar) else Scalar(angle), name)
    return None if depends_on(rate, name) else rate


def _power(n: int, name: str) -> Scalar:
    variable = symbol(name)
    return generator_of("ln", variable) if n == -1 else variable ** (n + 1) * Fraction(1, n + 1)


def _single_angle(angle: Poly, cosines: int, sines: int, name: str) -> Scalar | None:
    """∫ cos^a sin^b of one angle: by substitution of the other if one power is odd, of the tangent, or by waves."""
    c, s, rate = cosine(Scalar(angle)), sine(Scalar(angle)), 1 / derivative(Scalar(angle), name)
    if cosines > 0 and cosines % 2:
        return _times_rate(_substituted(s, -1, cosines // 2, sines), rate)
    if sines > 0 and sines % 2:
        return _times_rate(_substituted(c, -1, sines // 2, cosines), -rate)
    if min(cosines, sines) >= 0:
        return _by_waves(0, {angle: [cosines, sines]}, name)
    if (cosines + sines) % 2 == 0 and cosines + sines < 0:
        return _times_rate(_substituted(s / c, 1, -(cosines + sines) // 2 - 1, sines), rate)
    return _lowered(angle, cosines, sines, name)


def _times_rate(value: Scalar | None, rate: Scalar) -> Scalar | None:
    return None if value is None else value * rate


def _lowered(angle: Poly, cosines: int, sines: int, name: str) -> Scalar | None:
    """By cos² = 1 - sin² (or sin² = 1 - cos²) where the other power is negative; None if neither is a square."""
    if cosines >= 2:
        parts = [_single_angle(angle, cosines - 2, sines + more, name) for more in (0, 2)]
    elif sines >= 2:
        parts = [_single_angle(angle, cosines + more, sines - 2, name) for more in (0, 2)]
    else:
        return None
    return None if parts[0] is None or parts[1] is None else parts[0] - parts[1]


def _substituted(u: Scalar, sign: int, halves: int, power: int) -> Scalar | None:
    """∫ (1 + sign u²)^halves u^power du; None if it holds a logarithm."""
    total, binomial = NOTHING, 1
    for k in range(halves + 1):
        degree = power + 2 * k + 1
        if degree == 0:
            return None
        total = total + u**degree * Fraction(binomial * sign**k, degree)
        binomial = binomial * (halves - k) // (k + 1)
    return total


def _by_waves(power: int, angles: dict[Poly, list[int]], name: str, growth: Scalar = NOTHING) -> Scalar:
    """By writing the product as a sum of single sines and cosines; over e^(growth x) where that is a factor."""
    total = NOTHING
    for angle, (c, s) in _waves(angles).items():
        total = total + _wave(power, Scalar(angle), lift(c), lift(s), name, growth)
    return total


def _waves(angles: dict[Poly, list[int]]) -> dict[Poly, tuple[Fraction, Fraction]]:
    """The product of powers as Σ c cos(angle) + s sin(angle)."""
    waves = {Poly({}): (Fraction(1), Fraction(0))}
    for angle, (cosines, sines) in angles.items():
        for kind in "c" * cosines + "s" * sines:
            waves = _times(waves, angle, kind)
    return waves


Waves = dict[Poly, tuple[Fraction, Fraction]]


def _times(waves: Waves, angle: Poly, kind: str) -> Waves:
    result: Waves = {}
    for base, (c, s) in waves.items():
        for sign in (1, -1):
            turned = base + angle if sign > 0 else base - angle
            part = (c / 2, s / 2) if kind == "c" else (-sign * s / 2, sign * c / 2)
            old = result.get(turned, (Fraction(0), Fraction(0)))
            result[turned] = (old[0] + part[0], old[1] + part[1])
    return result


def _wave(power: int, angle: Scalar, c: Scalar, s: Scalar, name: str, growth: Scalar) -> Scalar:
    """e^(-gx) ∫ x^power e^(gx) (c cos + s sin) dx, by parts."""
    rate = derivative(angle, name)
    if not (rate or growth):
        return (cosine(angle) * c + sine(angle) * s) * _power(power, name)
    if rate and growth:
        below = short(rate * rate + growth * growth)
        c, s = (growth * c - rate * s) / below, (rate * c + growth * s) / below
    else:
        c, s = (c / growth, s / growth) if growth else (-s / rate, c / rate)
    wave = cosine(angle) * c + sine(angle) * s
    if power == 0:
        return wave
    return wave * symbol(name) ** power - _wave(power - 1, angle, c, s, name, growth) * lift(power)
