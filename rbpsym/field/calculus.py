"""Derivatives, substitution and definite integrals of scalars."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache

from rbpsym.field import atoms
from rbpsym.field.effort import remembered
from rbpsym.field.poly import ONE, Monomial, Poly, accumulate, generator
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, generator_of, lift, quotient, total
from rbpsym.field.trig import cosine, sine


def derivative(value: Scalar, name: str) -> Scalar:
    """∂ value / ∂ (symbol called name)."""
    num = poly_derivative(value.num, name)
    if value.den is ONE:
        return num
    den = poly_derivative(value.den, name)
    if not den:
        return num * quotient(ONE, value.den)
    return (num * Scalar(value.den) - Scalar(value.num) * den) * quotient(ONE, value.den * value.den)


@remembered
def poly_derivative(poly: Poly, name: str) -> Scalar:
    """The derivative of a polynomial (a Scalar, since ln and root bring quotients)."""
    slopes = {index: slope for index in poly.atoms() if (slope := atom_derivative(index, name))}
    if not slopes:
        return NOTHING
    parts: list[tuple[int | Fraction, Poly]] = []
    others = NOTHING
    for m, c in poly.terms.items():
        for place, (index, exponent) in enumerate(m):
            if index not in slopes:
                continue
            inner = slopes[index]
            lowered = ((index, exponent - 1),) if exponent != 1 else ()
            rest = Poly({m[:place] + lowered + m[place + 1 :]: 1}, 1)
            if inner.den is ONE:
                parts.append((c * exponent, rest * inner.num))
            else:
                others = others + Scalar(rest.scaled(c * exponent)) * inner
    return Scalar(accumulate(parts)) + others


def rate_along(value: Scalar, rates: Mapping[str, Scalar]) -> Scalar:
    """Σ ∂value/∂(symbol) × rate of the symbol: the chain rule, term by term."""
    if value.den is not ONE:
        parts = ((derivative(value, name), rate) for name, rate in rates.items() if depends_on(value, name))
        return total(part * rate for part, rate in parts if part)
    inner = {index: _atom_rate(index, rates) for index in value.num.atoms()}
    found = []
    for m, c in value.num.terms.items():
        for place, (index, exponent) in enumerate(m):
            if inner[index]:
                lowered = ((index, exponent - 1),) if exponent != 1 else ()
                found.append(inner[index] * Scalar(Poly({m[:place] + lowered + m[place + 1 :]: c * exponent})))
    return total(found)


def _atom_rate(index: int, rates: Mapping[str, Scalar]) -> Scalar:
    if rates.keys().isdisjoint(atom_names(index)):
        return NOTHING
    return total(atom_derivative(index, name) * rates[name] for name in rates if name in atom_names(index))


@lru_cache(maxsize=16384)
def atom_derivative(index: int, name: str) -> Scalar:
    """∂ atom / ∂ symbol."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return UNITY if found.arg == name else NOTHING
    arg = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
    inner = derivative(arg, name)
    return OUTER[found.kind](arg, index) * inner if inner else NOTHING


def _self(index: int) -> Scalar:
    return Scalar(generator(index))


OUTER: dict[str, Callable[[Scalar, int], Scalar]] = {
    "cos": lambda arg, index: -sine(arg),
    "sin": lambda arg, index: cosine(arg),
    "root": lambda arg, index: 1 / (2 * _self(index)),
    "exp": lambda arg, index: _self(index),
    "ln": lambda arg, index: 1 / arg,
    "atan": lambda arg, index: 1 / (1 + arg * arg),
    "asin": lambda arg, index: 1 / root(1 - arg * arg),
    "acos": lambda arg, index: -1 / root(1 - arg * arg),
    "sign": lambda arg, index: NOTHING,
    # of the parameter m = k² (Abramowitz and Stegun, 17.3; DLMF, 19.4)
    "elliptic_k": lambda arg, index: (function("elliptic_e", arg) / (1 - arg) - _self(index)) / (2 * arg),
    "elliptic_e": lambda arg, index: (_self(index) - function("elliptic_k", arg)) / (2 * arg),
}


def root(value: Scalar) -> Scalar:
    """The non-negative square root; squares of plain numbers are taken out."""
    number = value.number()
    if number is not None and number >= 0:
        return _number_root(Fraction(number))
    return generator_of("root", value)


def _number_root(value: Fraction) -> Scalar:
    """√(p/q) = √(pq)/q as a rational times roots of primes (which are independent)."""
    outer, inner = lift(Fraction(1, value.denominator)), value.numerator * value.denominator
    k = 2
    while k * k <= inner and k < 10_000:
        while inner % (k * k) == 0:
            outer, inner = outer * k, inner // (k * k)
        if inner % k == 0:
            outer, inner = outer * generator_of("root", lift(k)), inner // k
        k += 1
    return outer * inner if inner <= 1 else outer * generator_of("root", lift(inner))


def function(name: str, arg: Scalar) -> Scalar:
    """A named function of a scalar as a value: trigonometric ones by their angle, others as atoms."""
    return FUNCTIONS[name](arg)


def _known(name: str, values: Mapping[Scalar, Scalar]) -> Callable[[Scalar], Scalar]:
    return lambda arg: values[arg] if arg in values else generator_of(name, arg)


def _powered(arg: Scalar) -> Scalar:
    """exp(x), of c ln x with a whole 2c as a power of x."""
    [(m, c), *more] = arg.num.terms.items() if arg.den is ONE and arg else [((), 0)]
    found = atoms.atom(m[0][0]) if len(m) == 1 and m[0][1] == 1 and not more and (2 * c).denominator == 1 else None
    if not found or found.kind != "ln":
        return generator_of("exp", arg) if arg else UNITY
    base: Scalar = found.arg
    return base ** int(c // 1) * (root(base) if (2 * c) % 2 else UNITY)


def _logarithm(arg: Scalar) -> Scalar:
    """ln x, of √x as ln x/2."""
    [(m, c), *more] = arg.num.terms.items() if arg.den is ONE and arg else [((), 0)]
    found = atoms.atom(m[0][0]) if len(m) == 1 and m[0][1] == c == 1 and not more else None
    return _logarithm(found.arg) / 2 if found and found.kind == "root" else _known("ln", {UNITY: NOTHING})(arg)


def _turned(name: str, values: Mapping[Scalar, Scalar]) -> Callable[[Scalar], Scalar]:
    """Of an odd function: -f(x) for f(-x)."""
    plain = _known(name, values)

    def see(arg: Scalar) -> Scalar:
        below = all(c < 0 for c in arg.num.terms.values()) and arg not in values
        return -plain(-arg) if below else plain(arg)

    return see


def _odd(values: Mapping[Scalar, Scalar]) -> dict[Scalar, Scalar]:
    return {NOTHING: NOTHING, **values, **{-at: -value for at, value in values.items()}}


HALF = Fraction(1, 2)
ROOT_2, ROOT_3 = root(lift(2)), root(lift(3))
SINES = _odd({lift(HALF): PI / 6, ROOT_2 / 2: PI / 4, 1 / ROOT_2: PI / 4, ROOT_3 / 2: PI / 3, UNITY: PI / 2})
TANGENTS = _odd({ROOT_3 / 3: PI / 6, 1 / ROOT_3: PI / 6, UNITY: PI / 4, ROOT_3: PI / 3})


FUNCTIONS: dict[str, Callable[[Scalar], Scalar]] = {
    "cos": cosine,
    "sin": sine,
    "tan": lambda a: sine(a) / cosine(a),
    "cot": lambda a: cosine(a) / sine(a),
    "sec": lambda a: 1 / cosine(a),
    "csc": lambda a: 1 / sine(a),
    "exp": _powered,
    "ln": _logarithm,
    "asin": _turned("asin", SINES),
    "acos": _known("acos", {at: PI / 2 - angle for at, angle in SINES.items()}),
    "atan": _turned("atan", TANGENTS),
    "elliptic_k": _known("elliptic_k", {NOTHING: PI / 2}),
    "elliptic_e": _known("elliptic_e", {NOTHING: PI / 2, UNITY: UNITY}),
    "sqrt": root,
}


def substitute(value: Scalar, images: Mapping[str, Scalar]) -> Scalar:
    """The value with symbols replaced (inside angles, roots and functions too)."""
    if not images:
        return value
    key = tuple(sorted(images.items(), key=lambda item: item[0]))
    num = _poly_substitute(value.num, key)
    return num if value.den is ONE else num / _poly_substitute(value.den, key)


@remembered
def _poly_substitute(poly: Poly, key: tuple[tuple[str, Scalar], ...]) -> Scalar:
    names = [name for name, _ in key]
    touched = [i for i in poly.atoms() if not atom_names(i).isdisjoint(names)]
    return _with_images(poly, {i: image for i in touched if (image := _atom_substitute(i, key)) is not None})


def _with_images(poly: Poly, images: Mapping[int, Scalar]) -> Scalar:
    if not images:
        return Scalar(poly)
    by_factor: dict[Monomial, dict[Monomial, int | Fraction]] = {}
    for m, c in poly.terms.items():
        key = tuple(item for item in m if item[0] in images)
        by_factor.setdefault(key, {})[tuple(item for item in m if item[0] not in images)] = c
    return total(_times_images(Poly(rest), key, images) for key, rest in by_factor.items())


def _times_images(rest: Poly, key: Monomial, images: Mapping[int, Scalar]) -> Scalar:
    product = UNITY
    for index, exponent in key:
        product = product * images[index] ** exponent
    return product * Scalar(rest)


@lru_cache(maxsize=16384)
def _atom_substitute(index: int, key: tuple[tuple[str, Scalar], ...]) -> Scalar | None:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return dict(key).get(found.arg)
    arg = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
    image = substitute(arg, dict(key))
    if image == arg:
        return None
    return FUNCTIONS[{"root": "sqrt"}.get(found.kind, found.kind)](image)


def inside(value: Scalar, see: Callable[[Scalar], Scalar]) -> Scalar:
    """The value with the arguments of its roots and functions seen otherwise."""
    images = {}
    for index in value.atoms():
        found = atoms.atom(index)
        if not isinstance(found.arg, (Scalar, Poly)) or found.kind == "sign":
            continue
        arg = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
        seen = see(arg)
        if seen != arg and (seen.den is ONE or arg is found.arg):  # an angle has no sum below a bar
            images[index] = FUNCTIONS[{"root": "sqrt"}.get(found.kind, found.kind)](seen)
    num = _with_images(value.num, images)
    return num if value.den is ONE else num / _with_images(value.den, images)


def depends_on(value: Scalar, name: str) -> bool:
    """Whether the symbol occurs anywhere in the value (also inside an angle)."""
    return name in names_in(value)


def names_in(value: Scalar) -> frozenset[str]:
    """All symbols that occur anywhere in the value (also inside an angle)."""
    return _names(value.atoms())


@lru_cache(maxsize=16384)
def _names(indices: frozenset[int]) -> frozenset[str]:
    return frozenset().union(*map(atom_names, indices))


@lru_cache(maxsize=16384)
def atom_names(index: int) -> frozenset[str]:
    """The symbols that occur in the atom."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return frozenset((found.arg,))
    return names_in(found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg))


def atom_depends(index: int, name: str) -> bool:
    """Whether the symbol occurs in the atom."""
    return name in atom_names(index)


def split_factor(m: Monomial, name: str) -> tuple[Monomial, Monomial]:
    """The part of a monomial that does not depend on the symbol, and the part that does."""
    free = tuple(item for item in m if not atom_depends(item[0], name))
    return free, tuple(item for item in m if atom_depends(item[0], name))
