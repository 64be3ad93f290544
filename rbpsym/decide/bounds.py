"""Bounds of single generators: of a name by its range, of a sine or cosine by its angle's range."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.factoring import MINUS, PLUS, ZERO
from rbpsym.field import NOTHING, PI, UNIT, UNITY, Monomial, Poly, Scalar, atoms, cosine, generator_of, lift, sine
from rbpsym.frozen import Frozen, replace

Bound = Scalar | None
IsNonnegative = Callable[[Scalar], bool]


class Bounds(Frozen):
    """An interval; `lower_in` and `upper_in` say whether an end may be reached."""

    lower: Bound = None
    upper: Bound = None
    lower_in: bool = False
    upper_in: bool = False


NO_BOUNDS = Bounds()
FULL_WAVE = Bounds(lift(-1), UNITY, True, True)
PI_BOUNDS = Bounds(lift(Fraction(103993, 33102)), lift(Fraction(104348, 33215)))
LOWEST = {"positive": Bounds(NOTHING), "nonnegative": Bounds(NOTHING, lower_in=True)}


def of_symbol(name: str, assumptions: Assumptions) -> Bounds:
    """The range of a name, narrowed by its sign."""
    if name == "pi":
        return PI_BOUNDS
    lower, upper = assumptions.range_of(name)
    lower_in, upper_in = ((name, side) in assumptions.reached for side in (0, 1))
    by_sign = LOWEST.get(assumptions.sign_of(name), NO_BOUNDS)
    if by_sign.lower is not None and (lower is None or _is_negative_number(lower)):
        return Bounds(by_sign.lower, upper, by_sign.lower_in, upper_in)
    return Bounds(lower, upper, lower_in, upper_in)


def _is_negative_number(bound: Scalar) -> bool:
    number = bound.number()
    return number is not None and number < 0


def of_angle(angle: Poly, assumptions: Assumptions) -> Bounds:
    """Between what an angle lies: each name replaced by the end of its range, reached if each of these is."""
    order = sorted(angle.terms, key=lambda m: -_depth(m, assumptions))
    ends: list[Bound] = [Scalar(angle), Scalar(angle)]
    reached = [True, True]
    for side in (0, 1):
        for m in order:
            c = angle.terms[m]
            here = ends[side]
            if _is_constant(m) or here is None or here.num.terms.get(m) != c:
                continue
            found = _range_of(m, assumptions)
            end, end_in = ((found.lower, found.lower_in), (found.upper, found.upper_in))[side if c > 0 else 1 - side]
            ends[side] = None if end is None else here + (end - Scalar(Poly({m: 1}))) * c
            reached[side] &= end_in
    return Bounds(ends[0], ends[1], reached[0], reached[1])


def _is_constant(m: Monomial) -> bool:
    return m == UNIT or m == ((atoms.PI, 1),)


def _range_of(m: Monomial, assumptions: Assumptions) -> Bounds:
    name = atoms.symbol_name(m[0][0]) if len(m) == 1 and m[0][1] == 1 else None
    return of_symbol(name, assumptions) if name else NO_BOUNDS


def _depth(m: Monomial, assumptions: Assumptions) -> int:
    """How many generators stand in the bounds: such names are replaced first."""
    found = NO_BOUNDS if _is_constant(m) else _range_of(m, assumptions)
    return sum(len(end.atoms() - {atoms.PI}) for end in (found.lower, found.upper) if end is not None)


def of_cosine(angle: Bounds, is_nonnegative: IsNonnegative) -> Bounds:
    """Bounds of the cosine of an angle within these bounds.

    On a half turn from kπ to (k+1)π the cosine is monotone; from (k-1/2)π to (k+1/2)π it has
    one sign; from (k-1)π to (k+1)π it comes to the value opposite to that at kπ at the ends alone.
    """
    lower, upper = angle.lower, angle.upper
    if lower is None or upper is None:
        return FULL_WAVE
    for k in (0, -1, 1, -2, 2, -3, 3):
        if is_nonnegative(lower - PI * k) and is_nonnegative(PI * (k + 1) - upper):
            found = Bounds(cosine(upper), cosine(lower), angle.upper_in, angle.lower_in)
            return found if k % 2 == 0 else Bounds(found.upper, found.lower, found.upper_in, found.lower_in)
    ends_in = angle.lower_in or angle.upper_in
    for part, least in ((Fraction(1, 2), NOTHING), (Fraction(1), lift(-1))):
        for k in (0, -1, 1, -2, 2):
            if is_nonnegative(lower - PI * (k - part)) and is_nonnegative(PI * (k + part) - upper):
                return Bounds(least, UNITY, ends_in, True) if k % 2 == 0 else Bounds(lift(-1), -least, True, ends_in)
    return FULL_WAVE


def of_wave(kind: str, angle: Poly, assumptions: Assumptions, is_nonnegative: IsNonnegative) -> Bounds:
    """Bounds of a sine or cosine; sin A = cos(A - π/2), and cos A ≥ cos E from -E to E."""
    [(term, factor), *others] = angle.terms.items()
    own = _range_of(term, assumptions) if (kind, factor, others) == ("cos", 1, []) else NO_BOUNDS
    if own.lower is not None and own.upper == -own.lower and depends_on_names(own.upper) and is_nonnegative(PI - own.upper):
        return Bounds(cosine(own.upper), UNITY, own.upper_in, True)
    found = of_angle(angle, assumptions)
    if kind == "sin":
        lower, upper = (None if end is None else end - PI * Fraction(1, 2) for end in (found.lower, found.upper))
        found = replace(found, lower=lower, upper=upper)
    return of_cosine(found, is_nonnegative)


def of_inverse(kind: str, arg: int) -> Bounds:
    """Bounds of an inverse sine, cosine or tangent whose argument has one of the signs `arg`."""
    quarter = PI * Fraction(1, 2)
    low = NOTHING if kind == "acos" or not arg & MINUS else -quarter
    high = quarter if kind != "acos" or not arg & MINUS else PI
    if kind != "acos" and not arg & PLUS:
        high = NOTHING
    elif kind == "acos" and not arg & PLUS:
        low = quarter
    return Bounds(low, high, kind != "atan" or not low, kind != "atan" or not high)


def of_exponential(arg: int) -> Bounds:
    """Bounds of an exponential whose argument has one of the signs `arg`."""
    if not arg & MINUS:
        return Bounds(UNITY, None, bool(arg & ZERO))
    return Bounds(NOTHING) if arg & PLUS else Bounds(NOTHING, UNITY, upper_in=bool(arg & ZERO))


def of_half_tangent(angle: Poly, assumptions: Assumptions, is_nonnegative: IsNonnegative) -> Bounds:
    """Bounds of tan(a/2) for an angle a between -π and π."""
    found = of_angle(angle, assumptions)
    lower, upper = found.lower, found.upper
    if lower is not None and not is_nonnegative(lower + PI):
        return NO_BOUNDS
    if upper is not None and not is_nonnegative(PI - upper):
        return NO_BOUNDS
    if lower is None or upper is None:
        return NO_BOUNDS
    return Bounds(_half_tangent(lower), _half_tangent(upper), found.lower_in, found.upper_in)


def _half_tangent(angle: Scalar) -> Bound:
    """tan(a/2) as a value; None at ±π, where it is infinite."""
    if not depends_on_names(angle):
        below = 1 + cosine(angle)
        return sine(angle) / below if below else None
    return generator_of("half", angle.num)


def depends_on_names(value: Scalar) -> bool:
    """Whether something else than π occurs in an angle."""
    return bool(value.atoms() - {atoms.PI})
