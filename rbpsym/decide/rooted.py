"""Values in which the roots of squares are taken, by the signs that are known, and signs from slopes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.signs import sign
from rbpsym.field import ONE, Poly, Scalar, atoms, factors, generator, inverse, quotient, symbol, with_exponentials_joined
from rbpsym.field.calculus import atom_depends, depends_on, derivative, function, root, substitute
from rbpsym.field.normal import has_roots, in_one_angle, normal, short, shorten
from rbpsym.field.roots import is_root, side_of, simplified_root, tidied, with_image, without_even_roots
from rbpsym.frozen import Frozen


class Senses(Frozen):
    """The sense of sums under assumptions, for `Style.sense`."""

    given: Assumptions

    def __call__(self, sum_: Poly) -> int:
        return sign(Scalar(sum_), self.given).sense


def shorter(value: Scalar) -> Scalar:
    """The value with sin² + cos² = 1 used where that makes it shorter, and one exponential in each product."""
    value = with_exponentials_joined(value)
    num = shorten(value.num)
    return value if num is value.num else quotient(num, value.den)


def rooted(value: Scalar, given: Assumptions) -> Scalar:
    """The value with √(x²) = x for what is positive, and √x √(1/x) = 1 within sines and cosines."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if found.kind == "root" or (found.kind in ("cos", "sin") and sum(map(is_root, found.arg.atoms())) > 1):
            inner = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
            image = root_of(inner, given) if found.kind == "root" else function(found.kind, neat(inner, given))
            value = with_image(value.num, index, image) / with_image(value.den, index, image)
    return shorter(without_even_roots(value))


def root_of(value: Scalar, given: Assumptions) -> Scalar:
    """√value, with what is declared positive and squared taken out."""
    return simplified_root(short(without_even_roots(value)), lambda name: given.sign_of(name) == "positive")


def neat(value: Scalar, given: Assumptions) -> Scalar:
    """The value as it is told: one root in each product, which holds no squares."""
    def sense(part: Scalar) -> int:
        return sign(part, given).sense

    value = tidied(rooted(value, given), sense)
    for index in sorted(value.atoms()):
        image = _denested(atoms.atom(index).arg, sense) if atoms.atom(index).kind == "root" else None
        if image is not None:
            return neat(with_image(value.num, index, image) / with_image(value.den, index, image), given)
    return in_one_angle(shorter(value))


def rationalised(value: Scalar) -> Scalar:
    """2/(√5 - 1) as (√5 + 1)/2: without a root below, where a² - b² c of a + b √c is one term."""
    for index in filter(is_root, value.den.atoms()):
        parts = {power: Scalar(part) for power, part in value.den.by_power(index).items()}
        if set(parts) == {0, 1}:
            other = parts[0] - parts[1] * Scalar(generator(index))
            norm = short(without_even_roots(Scalar(value.den) * other))
            if len(norm.num) == 1 and norm.den is ONE:
                return rationalised(short(without_even_roots(Scalar(value.num) * other) / norm))
    return value


def _denested(radicand: Scalar, sense: Callable[[Scalar], int]) -> Scalar | None:
    """√(A + B√C) as √((A + D)/2) ± √((A - D)/2) where A² - B² C is a square D²; None for another root."""
    roots = [i for i in radicand.num.atoms() if atoms.atom(i).kind == "root"]
    parts = radicand.num.by_power(roots[0]) if len(roots) == 1 and radicand.den is ONE else {}
    if set(parts) != {0, 1}:
        return None
    whole, slope = Scalar(parts[0]), Scalar(parts[1])
    square = whole * whole - slope * slope * atoms.atom(roots[0]).arg
    size = root(square) if square.number() is not None else side_of(square)
    if size is None or has_roots(size) or sense(whole) <= 0 or not sense(slope) or not (sense(size) or sense(slope) > 0):
        return None
    halves = [root((whole + size * way) / 2) for way in (sense(size) or 1, -(sense(size) or 1))]
    return halves[0] + halves[1] * sense(slope)


MOST_SLOPES = 3
SENSES: dict[str | None, int] = {"positive": 1, "negative": -1}
Known = Callable[[Scalar], bool]


def sign_along(value: Scalar, name: str, given: Assumptions, known: Known = lambda value: False, most: int = MOST_SLOPES) -> int:
    """1 or -1 where the value is surely positive or negative within the range of a quantity, 0 where that is not seen;
    `known`: whether a value that is free of the quantity is not negative, beside what is declared."""
    kind = sign(value, given).kind
    if kind in SENSES:
        return SENSES[kind]
    if value.den is not ONE:
        below = SENSES.get(sign(Scalar(value.den), given).kind, 0)
        return below * sign_along(Scalar(value.num), name, given, known, most)
    limits = of_symbol(name, given)
    ends = [end for end in (limits.lower, limits.upper) if end is not None]
    if len(ends) < 2 or limits.lower_in or limits.upper_in or not most or not _is_smooth(value, name, given, ends):
        return 0  # at an end that belongs to the range it may vanish
    there = [rooted(substitute(value, {name: end}), given) for end in ends]
    slope = derivative(value, name)
    for side in (1, -1):
        kept = [known(end * side) or sign(end * side, given.without(name)).is_nonnegative for end in there]
        way = sign_along(slope, name, given, most=most - 1) * side if any(kept) else 0
        bend = derivative(_without_growth(slope), name)  # where that keeps its sign, the value rises and then falls
        if (way and kept[way < 0]) or (all(kept) and sign_along(bend, name, given, most=0) == -side):
            return side
    low, high = (None if end is None else end / 2 for end in ends)
    signs = [sign_along(part, name, given.with_range(name, low, high), known, most - 1) for part in _in_halves(value, name)]
    if len(signs) > 1:
        return prod(signs)
    other = over_growth(value, name)
    return 0 if other is None else sign_along(other, name, given, known, most - 1)


def over_growth(value: Scalar, name: str = "") -> Scalar | None:
    """The value over the first exponential (of a quantity) that is in it; None if there is none."""
    for index in sorted(value.num.atoms()):
        if atoms.atom(index).kind == "exp" and (not name or atom_depends(index, name)):
            return with_exponentials_joined(value / Scalar(generator(index)))
    return None


def _without_growth(value: Scalar) -> Scalar:
    """Without the exponentials that are factors of all of it."""
    common = tuple(item for item in value.num.content()[1] if atoms.atom(item[0]).kind == "exp")
    return Scalar(value.num.scaled(1, inverse(common)), value.den)


def _in_halves(value: Scalar, name: str) -> list[Scalar]:
    """Factors in half of the angle: A sin 2u + B (cos 2u - 1) = 2 sin u (A cos u - B sin u)."""
    if value.den is not ONE or not any(atoms.atom(index).kind in ("sin", "cos") for index in value.num.atoms()):
        return []
    half = shorten(normal(substitute(value, {name: symbol(name) * 2}).num))
    common = half.content()[1]
    rest = half.scaled(1, inverse(common))
    number, found = factors(rest) if rest.terms and all(e > 0 for m in rest.terms for _, e in m) else (1, ())
    parts = [Scalar(Poly({common: number})), *(Scalar(part) for part, power in found for _ in range(power))]
    return parts if len(rest) > 1 and parts[1:] != [Scalar(rest)] else []


def _is_smooth(value: Scalar, name: str, given: Assumptions, ends: Sequence[Scalar]) -> bool:
    """Whether the value is a polynomial in the quantity, in waves and exponentials of what changes evenly with it, and in roots
    of what is such a one and positive (below a line, at the ends too)."""
    inner = {(atoms.atom(index), power > 0) for term in value.num.terms for index, power in term if atom_depends(index, name)}
    return value.den is ONE and bool(inner) and all(_is_plain(*item, name, given, ends) for item in inner)


def _is_plain(atom: atoms.Atom, is_above: bool, name: str, given: Assumptions, ends: Sequence[Scalar]) -> bool:
    if atom.kind not in ("sin", "cos", "exp", "root"):
        return is_above and atom.kind == "symbol"
    arg = atom.arg if isinstance(atom.arg, Scalar) else Scalar(atom.arg)
    if atom.kind == "root":
        values = [arg, *(substitute(arg, {name: end}) for end in ends if not is_above)]
        return _is_smooth(arg, name, given, ends) and all(sign(value, given).kind == "positive" for value in values)
    return is_above and not depends_on(derivative(arg, name), name)
