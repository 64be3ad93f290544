"""Square roots with everything taken out of them that is known to be a square of something positive."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import root
from rbpsym.algebra.grouping import perfect_power
from rbpsym.algebra.poly import ONE, Monomial, Poly, generator, inverse
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar, generator_of


def simplified_root(value: Scalar, is_positive: Callable[[str], bool]) -> Scalar:
    """√value with rational squares and squares of positive symbols in front."""
    if not value.num.terms or value.number() is not None:
        return root(value)
    rational, powers = value.num.content()
    squares = tuple((i, e - e % 2) for i, e in powers if e - e % 2 and is_positive(atoms.symbol_name(i) or ""))
    inner = value.num.scaled(Fraction(1) / rational, inverse(squares))
    outer = Scalar(Poly({_halved(squares): 1})) * root(Scalar(Poly({(): rational})))
    return outer if inner == ONE == value.den else outer * generator_of("root", Scalar(inner, value.den))


def tidied(value: Scalar, is_positive: Callable[[str], bool], surely: Callable[[Poly], bool]) -> Scalar:
    """The value with the squares of its roots' radicands carried out, and √(3 g ℓ)/ℓ as √(3 g/ℓ).

    `surely` tells which sums are known to be positive. The result has the same value where the radicands are
    positive; the caller proves it.
    """
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if found.kind == "root":
            value = _with_divisor_inside(
                _replaced(value, index, _tidied_root(found.arg, is_positive, surely)), is_positive
            )
    return value


def _tidied_root(radicand: Scalar, is_positive: Callable[[str], bool], surely: Callable[[Poly], bool]) -> Scalar:
    radicand = tidied(without_even_roots(radicand), is_positive, surely)
    below = perfect_power(radicand.den)
    if below is not None and below[2] == 2:
        side = next((side for side in (below[1], -below[1]) if surely(side)), None)
        if side is not None:
            return simplified_root(Scalar(radicand.num) / below[0], is_positive) / Scalar(side)
    return simplified_root(radicand, is_positive)


def _replaced(value: Scalar, index: int, image: Scalar) -> Scalar:
    if image.num == generator(index) and image.den is ONE:
        return value
    return with_image(value.num, index, image) / with_image(value.den, index, image)


def with_image(poly: Poly, index: int, image: Scalar) -> Scalar:
    """The polynomial with an image in place of a generator."""
    return sum((Scalar(part) * image**power for power, part in poly.by_power(index).items()), NOTHING)


def _with_divisor_inside(value: Scalar, is_positive: Callable[[str], bool]) -> Scalar:
    """√(3 g ℓ)/ℓ as √(3 g/ℓ), where the root is a factor of the whole."""
    common, divided = dict(value.num.content()[1]), dict(value.den.content()[1])
    roots = [i for i, e in common.items() if e == 1 and atoms.atom(i).kind == "root" and atoms.atom(i).arg.atoms()]
    if len(roots) != 1:
        return value
    radicand = atoms.atom(roots[0]).arg
    inside = dict(radicand.num.content()[1]) if radicand.den is ONE else {}
    below = {i: divided.get(i, 0) - common.get(i, 0) for i in inside}
    moved = {i: 1 for i in below if inside[i] == 1 == below[i] and is_positive(atoms.symbol_name(i) or "")}
    if not moved:
        return value
    by = tuple(sorted(moved.items()))
    rest = value * Scalar(Poly({by: 1})) / Scalar(generator(roots[0]))
    return rest * generator_of("root", Scalar(radicand.num.scaled(1, tuple((i, -2) for i, _ in by))))


def _halved(powers: Monomial) -> Monomial:
    return tuple((i, e // 2) for i, e in powers)


def without_even_roots(value: Scalar) -> Scalar:
    """The value with even powers of square roots carried out, exactly."""
    if all(_squared_root(poly) is None for poly in (value.num, value.den)):
        return value
    return _evened(value.num) / _evened(value.den) if value.den is not ONE else _evened(value.num)


def _squared_root(poly: Poly) -> int | None:
    """A square root of which an even power occurs."""
    return next((i for i in poly.atoms() if atoms.atom(i).kind == "root" and _is_squared(poly, i)), None)


def _evened(poly: Poly) -> Scalar:
    index = _squared_root(poly)
    if index is None:
        return Scalar(poly)
    radicand, total = atoms.atom(index).arg, NOTHING
    for power, part in poly.by_power(index).items():
        odd = Scalar(generator(index)) if power % 2 else UNITY
        total = total + Scalar(part) * odd * radicand ** (power // 2)
    return without_even_roots(total)


def _is_squared(poly: Poly, index: int) -> bool:
    return any(power not in (0, 1) for power in poly.by_power(index))


def without_roots_below(value: Scalar) -> Scalar:
    """1/√x as √x/x, and 1/(a + b √x) as (a - b √x)/(a² - b² x)."""
    value = without_even_roots(value)
    for index in sorted(value.num.atoms()):
        if atoms.atom(index).kind == "root" and any(power < 0 for power in value.num.by_power(index)):
            value = _upright(value.num, index) / Scalar(value.den)
    below = [i for i in value.den.atoms() if atoms.atom(i).kind == "root" and set(value.den.by_power(i)) <= {0, 1}]
    if len(below) != 1:
        return value
    other = with_image(value.den, below[0], -Scalar(generator(below[0])))
    return without_even_roots(Scalar(value.num) * other) / without_even_roots(Scalar(value.den) * other)


def _upright(poly: Poly, index: int) -> Scalar:
    root_, radicand = Scalar(generator(index)), atoms.atom(index).arg
    parts = poly.by_power(index).items()
    return sum((Scalar(part) * root_ ** (power % 2) * radicand ** (power // 2) for power, part in parts), NOTHING)
