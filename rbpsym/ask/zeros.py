"""Where a function of one quantity vanishes within its declared range, and which sign it has elsewhere.

Zeros are found factor by factor. Between two neighbours of a complete list of zeros and poles a function keeps its
sign; which one it is follows from the range, from the slope at a zero, or from an end of the range.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from math import gcd

from rbpsym.ask.limits import leading
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.rooted import neat, over_growth, rooted, sign_along
from rbpsym.decide.signs import sign
from rbpsym.field import NOTHING, ONE, PI, UNITY, Poly, Scalar, atoms, generator, is_zero, short, symbol
from rbpsym.field.calculus import atom_depends, depends_on, derivative, function, root, substitute
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.demands import Demand, assuming, existence, settle
from rbpsym.mechanics.rest import turns_within
from rbpsym.mechanics.roots import factor_zeros, factors_in, period

SENSES = {"positive": 1, "negative": -1, "zero": 0}
Place = tuple[Scalar, tuple[Demand, ...]]


class Zero(Frozen):
    """Where a function vanishes (`is_pole`: has no value); it lies in the range if `asked` is met."""

    place: Scalar
    asked: tuple[Demand, ...] = ()
    is_pole: bool = False


class Crossing(Frozen):
    """The only zero of an `equation` without a closed solution: it is monotone, in the `sense`, and its ends differ in sign."""

    equation: Scalar
    sense: int


class Zeros(Frozen):
    """All zeros and poles in the range, from the lowest where their order is decided; `open_`: factors that may vanish
    elsewhere too."""

    found: tuple[Zero, ...] = ()
    crossings: tuple[Crossing, ...] = ()
    open_: tuple[Scalar, ...] = ()

    @property
    def asked(self) -> tuple[Demand, ...]:
        """What has to be met for all of them to lie in the range."""
        return tuple(dict.fromkeys(demand for zero in self.found for demand in zero.asked))


def zeros(value: Scalar, name: str, given: Assumptions) -> Zeros:
    """Zeros and poles of a value in a quantity, the others being fixed."""
    value = rooted(value, given)
    found: list[Zero] = []
    crossings: list[Crossing] = []
    open_: list[Scalar] = []
    for part, is_pole in ((value, False), *((below, True) for below in _divisors(value, name))):
        for factor in factors_in(part, name):
            if sign(factor, given).is_nonzero or sign_along(factor, name, given):
                continue
            places = _places(factor, name, given)
            if places is None:
                crossing = _crossing(factor, name, given)
                crossings += [crossing] if crossing else []
                open_ += [factor] if crossing is None or is_pole else []
                continue
            for place, asked in places:
                left = _within(value, place, asked, name, given, is_pole)
                if left is not None and not any(is_zero(place - old.place) for old in found):
                    found.append(Zero(place, left, is_pole))
    return Zeros(tuple(_ordered(found, given)), tuple(c for c in crossings if c), tuple(open_))


def _divisors(value: Scalar, name: str) -> Iterator[Scalar]:
    if value.den is not ONE and depends_on(Scalar(value.den), name):
        yield Scalar(value.den)
    below = {index for m in value.num.terms for index, exponent in m if exponent < 0 and atom_depends(index, name)}
    yield from (Scalar(generator(index)) for index in sorted(below))


def _within(
    value: Scalar, place: Scalar, asked: tuple[Demand, ...], name: str, given: Assumptions, is_pole: bool
) -> tuple[Demand, ...] | None:
    """What is left to ask for the place to exist in the range; None if it never does."""
    limits, there = of_symbol(name, given), {name: place}
    demands = [*exists(place), *asked]
    demands += [] if limits.lower is None else [Demand(place - limits.lower, ">=" if limits.lower_in else ">")]
    demands += [] if limits.upper is None else [Demand(limits.upper - place, ">=" if limits.upper_in else ">")]
    try:
        if not is_pole:
            needed = (Demand(substitute(d.value, there), OPS[d.op]) for d in existence(value) if depends_on(d.value, name))
            demands += needed
        return settle((Demand(rooted(d.value, given), d.op) for d in demands), given)
    except ZeroDivisionError:
        return None


OPS = {">": ">=", ">=": ">=", "!=": "!="}


def exists(place: Scalar) -> list[Demand]:
    """What is asked for a value to exist, arguments of inverse sines and cosines between -1 and 1 in two demands."""
    found = existence(place)
    for index in place.atoms():
        if atoms.atom(index).kind in ("asin", "acos"):
            arg = atoms.atom(index).arg
            whole = Demand(UNITY - arg * arg)
            found = [d for demand in found for d in ((Demand(1 - arg), Demand(1 + arg)) if demand == whole else (demand,))]
    return found


def _ordered(found: list[Zero], given: Assumptions) -> list[Zero]:
    """From the lowest to the highest, as far as that is decided."""
    given = where_met(given, (demand for zero in found for demand in zero.asked))
    ordered: list[Zero] = []
    for zero in found:
        place = next((k for k, old in enumerate(ordered) if precedes(zero.place, old.place, given)), len(ordered))
        ordered.insert(place, zero)
    return ordered


def where_met(given: Assumptions, demands: Iterable[Demand]) -> Assumptions:
    """The assumptions with all that the demands say of single quantities."""
    return assuming(given, demands, tighter=True)


def precedes(first: Scalar, second: Scalar, given: Assumptions) -> bool:
    """Whether one value is surely less than another."""
    return settled_sign(second - first, given) == 1


def settled_sign(value: Scalar, given: Assumptions) -> int | None:
    """1, -1 or 0; None if it is not decided. What holds inverse functions is compared by their arguments."""
    known = SENSES.get(sign(rooted(value, given), given).kind or "")
    if known is not None:
        return known
    if settle([Demand(value)], given) == ():
        return 1
    return -1 if settle([Demand(-value)], given) == () else None


# --- the zeros of one factor


def _places(factor: Scalar, name: str, given: Assumptions) -> list[Place] | None:
    """All zeros with what has to hold for them; None if they have no closed form."""
    waves = (atoms.atom(i).arg for i in factor.num.atoms() if atoms.atom(i).kind in ("cos", "sin"))
    if any(atoms.atom(i).kind in UNDONE and atom_depends(i, name) for angle in waves for i in angle.atoms()):
        return None  # squares of its roots would bring these back
    index = next((i for i in factor.num.atoms() if atoms.atom(i).kind == "root" and atom_depends(i, name)), None)
    if index is not None:
        return _squared(factor, index, name, given)
    index = next((i for i in factor.num.atoms() if atoms.atom(i).kind in UNDONE and atom_depends(i, name)), None)
    if index is not None:
        return _undone(factor, index, name, given)
    turn, found = period(factor, name), factor_zeros(factor, name) or _by_power(factor, name) or _by_phase(factor, name, given)
    if not found:
        return None
    within = _limited(given, name)
    return [(neat(place, given), ()) for first in found for place in turns_within(within, name, first, turn)]


def _limited(given: Assumptions, name: str) -> Assumptions:
    """The range of the name with what its sign says."""
    limits = of_symbol(name, given)
    return given.with_range(name, limits.lower, limits.upper)


def _squared(factor: Scalar, index: int, name: str, given: Assumptions) -> list[Place] | None:
    """A + B √x = 0 where A² = B² x and A B is not positive."""
    parts = {k: Scalar(part) for k, part in factor.num.by_power(index).items()}
    if set(parts) - {0, 1}:
        return None
    a, b = parts.get(0, NOTHING), parts[1]
    found = _all_places(rooted(a * a - b * b * atoms.atom(index).arg, given), name, given)
    if found is None:
        return None
    return [(place, (*asked, Demand(-substitute(a * b, {name: place}), ">="))) for place, asked in found]


def _all_places(value: Scalar, name: str, given: Assumptions) -> list[Place] | None:
    """The zeros of all factors; None if one of them that may vanish has no closed ones."""
    found: list[Place] = []
    for part in factors_in(value, name):
        places = _places(part, name, given)
        if places is None and not sign(part, given).is_nonzero:
            return None
        found += places or ()
    return found


UNDONE = {  # the function that undoes it, and between what its values lie
    "acos": ("cos", NOTHING, PI),
    "asin": ("sin", -PI / 2, PI / 2),
    "atan": ("tan", -PI / 2, PI / 2),
    "ln": ("exp", None, None),
    "exp": ("ln", NOTHING, None),
}


def _undone(factor: Scalar, index: int, name: str, given: Assumptions) -> list[Place] | None:
    """a arccos x + b = 0 where x = cos(b/a), between the ends of what arccos can be."""
    parts = {k: Scalar(part) for k, part in factor.num.by_power(index).items()}
    if set(parts) - {0, 1} or any(depends_on(part, name) for part in parts.values()):
        other = over_growth(factor, name)  # of two exponentials one is left
        return None if other is None or (_grown(factor, name), _grown(other, name)) != (2, 1) else _all_places(other, name, given)
    kind, low, high = UNDONE[atoms.atom(index).kind]
    angle = short(-parts.get(0, NOTHING) / parts[1])
    found = _all_places(atoms.atom(index).arg - function(kind, angle), name, given)
    asked: tuple[Demand, ...] = () if low is None else (Demand(angle - low, ">=" if high else ">"),)
    asked += () if high is None else (Demand(high - angle, ">="),)
    return None if found is None else [(place, (*asked, *more)) for place, more in found]


def _grown(factor: Scalar, name: str) -> int:
    """How many exponentials of the name are in it."""
    return sum(atoms.atom(i).kind == "exp" and atom_depends(i, name) for i in factor.num.atoms())


def _by_power(factor: Scalar, name: str) -> list[Scalar]:
    """Zeros of a polynomial in x² or x⁴, linear or quadratic."""
    parts = factor.num.by_power(atoms.intern("symbol", name))
    shared = reduce(gcd, parts)
    if shared not in (2, 4) or any(depends_on(Scalar(part), name) for part in parts.values()):
        return []
    inner = sum((Scalar(part) * symbol(name) ** (k // shared) for k, part in parts.items()), NOTHING)
    found = []
    for square in factor_zeros(inner, name):
        size = root(square) if shared == 2 else root(root(square))
        found += [size, -size]
    return found


def _by_phase(factor: Scalar, name: str, given: Assumptions) -> list[Scalar]:
    """Zeros of a cos A + b sin A + d as φ ± acos(-d/√(a² + b²)), tan φ = b/a."""
    angles = {atoms.atom(i).arg for i in factor.num.atoms() if atom_depends(i, name) and atoms.atom(i).kind in ("cos", "sin")}
    if len(angles) != 1:
        return []
    [angle] = angles
    cos, sin = (generator(atoms.intern(kind, angle)) for kind in ("cos", "sin"))
    a, b = (Scalar(factor.num.by_power(next(iter(wave.atoms()))).get(1, Poly({}))) for wave in (cos, sin))
    rest, rate = factor - a * Scalar(cos) - b * Scalar(sin), derivative(Scalar(angle), name)
    side = SENSES.get(sign(a, given).kind or "")
    if not side or any(depends_on(part, name) for part in (a, b, rest, rate)):
        return []
    phase = function("atan", b / a) + (NOTHING if side > 0 else PI)
    spread = function("acos", -rest / root(short(a * a + b * b)))
    offset = substitute(Scalar(angle), {name: NOTHING})
    return [(phase + spread * way - offset) / rate for way in (1, -1)]


def _crossing(factor: Scalar, name: str, given: Assumptions) -> Crossing | None:
    """The one zero of a monotone factor whose signs at the ends of the range differ."""
    sense = SENSES.get(sign(short(derivative(factor, name)), given).kind or "")
    ends = [sign_at_end(factor, name, given, upper) for upper in (False, True)]
    return Crossing(factor, sense) if sense and ends == [-sense, sense] else None


def sign_at_end(value: Scalar, name: str, given: Assumptions, upper: bool) -> int | None:
    """The sign close to an end of the range."""
    limits = of_symbol(name, given)
    end, side = (limits.upper, -1) if upper else (limits.lower, 1)
    return sign_beside(value, name, end, side if end is not None else -side, given)


def sign_beside(value: Scalar, name: str, place: Scalar | None, side: int, given: Assumptions) -> int | None:
    """The sign on one side of a place, or at infinity, from the leading term there."""
    found = leading(value, name, place, given, side)
    return None if found is None else settled_sign(found.coefficient, given.without(name))


# --- signs between zeros


class SignTable(Frozen):
    """The signs of a function between its zeros and poles, of which one more sign than zeros is known where `is_whole`."""

    zeros: Zeros
    signs: tuple[int | None, ...] = field(default=())

    @property
    def is_whole(self) -> bool:
        """Whether all zeros and all signs are known."""
        return not self.zeros.open_ and None not in self.signs


def sign_table(value: Scalar, name: str, given: Assumptions) -> SignTable:
    """The sign on every part of the range, where what the zeros ask for is met."""
    value = rooted(value, given)
    known = zeros(value, name, given)
    given = where_met(given, known.asked)
    if known.crossings and (known.found or len(known.crossings) > 1):
        return SignTable(known, (None,) * (len(known.found) + 2))
    if known.crossings:
        return SignTable(known, tuple(sign_at_end(value, name, given, upper) for upper in (False, True)))
    places = [zero.place for zero in known.found]
    is_ordered = all(precedes(a, b, given) for a, b in zip(places, places[1:], strict=False))
    if known.open_ or not is_ordered:
        return SignTable(known, (None,) * (len(places) + 1))
    whole = short(value * Scalar(value.den) ** 2)  # of the same sign, and without poles above the line
    sense = SENSES.get(sign(short(derivative(whole, name)), given).kind or "") if len(places) == 1 else 0
    if sense:
        return SignTable(known, (-sense, sense))
    signs = [_sign_between(whole, name, pair, given) for pair in zip([None, *places], [*places, None], strict=True)]
    if len(places) == 1 and None in signs and not depends_on(derivative(whole, name), name):  # linear: it changes its sign
        signs = [-signs[1] if side is None and signs[1] else side for side in signs]
        signs = [-signs[0] if side is None and signs[0] else side for side in signs]
    return SignTable(known, tuple(signs))


def _sign_between(value: Scalar, name: str, ends: Sequence[Scalar | None], given: Assumptions) -> int | None:
    limits = of_symbol(name, given)
    low, high = (limits.lower if ends[0] is None else ends[0]), (limits.upper if ends[1] is None else ends[1])
    direct = sign_along(value, name, given.with_range(name, low, high))
    if direct:
        return direct
    for place, side in zip(ends, (1, -1), strict=True):
        found = sign_at_end(value, name, given, side < 0) if place is None else sign_beside(value, name, place, side, given)
        if found:
            return found
    if low is None or high is None:
        return None
    between = (place for place in _quarters(value, name) if precedes(low, place, given) and precedes(place, high, given))
    return next((found for place in between if (found := settled_sign(substitute(value, {name: place}), given))), None)


def _quarters(value: Scalar, name: str) -> list[Scalar]:
    """The quarters of two periods, where waves have plain values."""
    turn = period(value, name)
    return [] if turn is None else [turn * k / 4 for k in range(-4, 5)]
