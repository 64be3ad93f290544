"""Square roots with everything taken out of them that is known to be a square of something positive."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction

from rbpsym.field import atoms
from rbpsym.field.calculus import inside, root
from rbpsym.field.normal import has_roots, is_zero, partner, tidy, without_squares
from rbpsym.field.poly import ONE, Monomial, Poly, generator, inverse, times
from rbpsym.field.ring import factors
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, generator_of, lift, name_of, total


def simplified_root(value: Scalar, is_positive: Callable[[str], bool]) -> Scalar:
    """√value with rational squares and squares of positive symbols in front."""
    if not value.num.terms or value.number() is not None:
        return root(value)
    rational, powers = value.num.content()
    squares = tuple((i, e - e % 2) for i, e in powers if e - e % 2 and is_positive(atoms.symbol_name(i) or ""))
    inner = value.num.scaled(Fraction(1) / rational, inverse(squares))
    outer = Scalar(Poly({tuple((i, e // 2) for i, e in squares): 1})) * root(Scalar(Poly({(): rational})))
    return outer if inner == ONE == value.den else outer * generator_of("root", Scalar(inner, value.den))


def tidied(value: Scalar, sense: Callable[[Scalar], int]) -> Scalar:
    """The value with one root in each product, in which nothing is squared: √(3 g ℓ)/ℓ as √3 √(g/ℓ), √a √b as √(a b).

    `sense` tells 1 of what is known not to be negative, -1 of what is known not to be positive, else 0. The result has the
    same value where the roots have one; who prints it proves it.
    """
    if not has_roots(value):
        return value
    value = tidy(without_even_roots(inside(value, lambda part: tidied(part, sense))))
    has_below = len(value.den) > 1 and any(map(is_root, value.den.atoms()))
    below = tidied(Scalar(value.den), sense) if has_below else Scalar(value.den)
    if below.num != value.den:
        return tidied(Scalar(value.num) / below, sense)
    high, low = value.num.content()[1], value.den.content()[1]
    common = times(high, inverse(low))
    if any(is_root(i) for i, _ in common):
        rest = Scalar(value.num.scaled(1, inverse(high))) / Scalar(value.den.scaled(1, inverse(low)))
        value = _product(common, rest, sense, is_whole=True)
    elif any(map(is_root, value.num.atoms())):
        below, [index, *others] = UNITY / Scalar(value.den), filter(is_root, value.num.atoms())
        parts = value.num.by_power(index)
        if not others and set(parts) <= {0, 1}:  # what stands before the only root is one factor
            return _product(((index, 1),), Scalar(parts[1]) * below, sense) + Scalar(parts.get(0, Poly({}))) * below
        terms = value.num.terms.items()
        parted = total(_product(m, below * c, sense) for m, c in terms)
        value = parted if parted.den is ONE else total(_product(m, lift(c), sense) for m, c in terms) * below
    value = value if value.den is ONE or any(map(is_root, value.den.atoms())) else with_root_taken_out(value)
    for index in _sizes(value):  # what is even in √(x²) is a function of x
        side = side_of(atoms.atom(index).arg)
        if side is not None and _replaced(value, index, -Scalar(generator(index))) == value:
            value = _replaced(value, index, side)
    return value


def with_root_taken_out(value: Scalar) -> Scalar:
    """A √x + B x as √x (A + B √x), where a denominator that is a multiple of x makes it shorter or there is none."""
    for index in sorted(filter(is_root, value.num.atoms()), key=name_of):
        parts, radicand = value.num.by_power(index), atoms.atom(index).arg
        if set(parts) != {0, 1} or len(radicand.num) < 2:  # by one term all can be divided
            continue
        rest = Scalar(parts[0]) / radicand
        below = Scalar(value.den) / radicand if value.den is not ONE else UNITY
        if rest.den is below.den is ONE:
            whole: Scalar = Scalar(parts[1]) + rest * Scalar(generator(index))
            return whole * Scalar(generator(index)) ** (1 if value.den is ONE else -1) / below
    return value


def is_root(index: int) -> bool:
    """Whether an atom is a square root."""
    return atoms.atom(index).kind == "root"


def _product(powers: Monomial, rest: Scalar, sense: Callable[[Scalar], int], *, is_whole: bool = False) -> Scalar:
    """A product of powers and a rest, its roots made one: of each factor an even power stands before the root."""
    radicand = math.prod((atoms.atom(i).arg ** e for i, e in powers if is_root(i)), start=UNITY)
    rest = rest * Scalar(Poly({tuple(item for item in powers if not is_root(item[0])): 1}))
    size, within = _squared(radicand) or _factored(radicand)
    if not within:
        return rest * root(radicand)
    number, before = _factored(rest)
    ways = {factor: sense(Scalar(factor)) for factor in within}
    unknown = [factor for factor, power in within.items() if power % 2 and not ways[factor]]
    if len(unknown) == 1:  # the root has a value
        others = (ways[factor] for factor, power in within.items() if power % 2 and factor not in unknown)
        ways[unknown[0]] = math.prod(others, start=1 if size > 0 else -1)
    sizes = UNITY
    for factor, way in ways.items():
        if way:
            power = 2 * before.get(factor, 0) + within[factor]
            half = int(power / 2)  # towards zero: nothing stands both before the root and on the other side of its bar
            number *= way ** abs(half - before.get(factor, 0))
            size *= way ** abs(within[factor])
            before[factor], within[factor] = half, power - 2 * half
            size *= way ** abs(within[factor])
        elif within[factor] % 2 == 0:  # |x| stands alone
            power, plain = within.pop(factor) // 2, before.get(factor, 0)
            power, before[factor] = (power, plain) if plain % 2 else (power + plain, 0)
            one = (power > 0) - (power < 0) if power % 2 else 0
            before[factor] += power - one
            sizes = sizes * generator_of("root", Scalar(factor) ** 2) ** one
    if min(within.values(), default=0) < 0 and max(before.values(), default=0) <= 0:  # one bar, not one below the other
        low = [factor for factor, power in before.items() if power < 0 and sense(Scalar(factor)) == 1]
        within |= {factor: within.get(factor, 0) + 2 * before.pop(factor) for factor in low}
    inner = _whole(1 if size > 0 else -1, within)
    inner = tidied(inner, sense) if inner != radicand and inner.den is not ONE else inner
    whole = _whole(number, before) * sizes * root(lift(abs(size)))
    if is_whole and inner.den is not ONE and all(power < 0 for power in within.values()) and (below := UNITY / inner).den is ONE:
        return whole / generator_of("root", below)
    return whole * (UNITY if inner == UNITY else generator_of("root", inner))


def _factored(value: Scalar) -> tuple[Fraction, dict[Poly, int]]:
    """A number and irreducible factors with their powers, those below the bar negative."""
    size, found = Fraction(1), dict[Poly, int]()
    for poly, way in ((value.num, 1), (value.den, -1)):
        low = tuple((i, e) for i, e in poly.content()[1] if e < 0)
        number, parts = factors(poly.scaled(1, inverse(low)))
        size *= Fraction(number) ** way
        for factor, power in (*parts, *((generator(i), e) for i, e in low)):
            found[factor] = found.get(factor, 0) + power * way
    return size, found


def _whole(number: Fraction | int, powers: Mapping[Poly, int]) -> Scalar:
    return math.prod((Scalar(factor) ** power for factor, power in powers.items()), start=lift(number))


def side_of(radicand: Scalar) -> Scalar | None:
    """x, for x²; None for what is no square."""
    number, powers = _squared(radicand) or (Fraction(0), {})
    size = root(lift(number)).number() if number > 0 else None
    return _completed(radicand) if size is None else _whole(size, {factor: power // 2 for factor, power in powers.items()})


def _completed(radicand: Scalar) -> Scalar | None:
    """a u + b/(2 a), for a² u² + b u + c in a symbol u of which the discriminant vanishes modulo sin² + cos² = 1."""
    for index in sorted(i for i in radicand.num.atoms() if atoms.symbol_name(i) and i not in radicand.den.atoms()):
        parts = {power: Scalar(part, radicand.den) for power, part in radicand.num.by_power(index).items()}
        if set(parts) != {0, 1, 2} or any(map(is_root, radicand.num.atoms())):
            continue
        if not is_zero(parts[1] * parts[1] - parts[0] * parts[2] * 4):
            return None
        first = side_of(parts[2])
        return None if first is None else first * Scalar(generator(index)) + parts[1] / (first * 2)
    return None


def _squared(radicand: Scalar) -> tuple[Fraction, dict[Poly, int]] | None:
    """A number and squares of factors: as it is, or without the square of a sine (a cosine); None where it has no such form."""
    waves = {i for m in radicand.num.terms for i, e in m if e > 1 and partner(i) is not None}
    for num in (radicand.num, *(without_squares(radicand.num, index) for index in sorted(waves))):
        number, powers = _factored(Scalar(num, radicand.den))
        if powers and all(power % 2 == 0 for power in powers.values()):
            return number, powers
    return None


def _sizes(value: Scalar) -> Iterator[int]:
    """Roots of squares, wherever they stand in it."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if isinstance(found.arg, (Scalar, Poly)):
            yield from _sizes(found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg))
        if found.kind == "root" and side_of(found.arg) is not None:
            yield index


def _replaced(value: Scalar, index: int, image: Scalar) -> Scalar:
    value = inside(value, lambda part: _replaced(part, index, image))
    return with_image(value.num, index, image) / with_image(value.den, index, image)


def with_numbers_inside(value: Scalar) -> Scalar:
    """The value with the numbers before a root in it: √6/3 √(ℓ/g) as √(2 ℓ/(3 g)), √2 √3 as √6; only squares stay before."""
    if not any(map(is_root, value.num.atoms())):
        return value
    number, common = value.num.content()
    divisor = value.den.content()[0]
    if not any(is_root(i) for i, _ in common):
        return total(_with_number_inside(m, Fraction(c)) for m, c in value.num.terms.items()) / Scalar(value.den)
    rest = Scalar(value.num.scaled(1 / number, inverse(common)), value.den.scaled(1 / divisor))
    return rest * _with_number_inside(common, number / divisor)


def _with_number_inside(powers: Monomial, number: Fraction) -> Scalar:
    roots = {i: atoms.atom(i).arg for i, e in powers if is_root(i) and e == 1}
    plain = {i: arg.number() for i, arg in roots.items() if arg.number() is not None}
    size = math.prod(plain.values(), start=Fraction(1))
    whole, others = Scalar(Poly({tuple(item for item in powers if item[0] not in plain): 1})), [*roots.keys() - plain.keys()]
    if len(others) != 1:
        return whole * number * (generator_of("root", lift(size)) if size != 1 else UNITY)
    radicand = roots[others[0]]
    own = radicand.num.content()[0] / radicand.den.content()[0]
    size = number * number * size * own
    before = Fraction(*(root(lift(part)).num.content()[0].numerator for part in size.as_integer_ratio()))
    if before.denominator > 1 and radicand.den is ONE and all(e > 0 for m in radicand.num.terms for _, e in m):
        before /= (size / before**2).denominator  # √(2 g h)/4, and no bar in the root
    inner = radicand * (size / before**2 / own)
    [(above, one), *more] = inner.num.terms.items()
    is_below = not more and abs(one.numerator) == 1 and all(e < 0 for _, e in above)
    image = 1 / generator_of("root", 1 / inner) if is_below else generator_of("root", inner)
    return whole / Scalar(generator(others[0])) * image * (before if number > 0 else -before)


def with_image(poly: Poly, index: int, image: Scalar) -> Scalar:
    """The polynomial with an image in place of a generator."""
    return sum((Scalar(part) * image**power for power, part in poly.by_power(index).items()), NOTHING)


def without_even_roots(value: Scalar) -> Scalar:
    """The value with even powers of square roots carried out, exactly."""
    if all(_squared_root(poly) is None for poly in (value.num, value.den)):
        return value
    return _evened(value.num) / _evened(value.den) if value.den is not ONE else _evened(value.num)


def has_squared_roots(value: Scalar) -> bool:
    """Whether a root stands squared in it, as no one writes it (1/√x may be written)."""
    powers = ((index, power) for poly in (value.num, value.den) for term in poly.terms for index, power in term)
    return any(abs(power) > 1 and is_root(index) for index, power in powers)


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
