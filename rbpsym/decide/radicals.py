"""The zero test for values with roots, logarithms, exponentials and inverse functions; roots in roots undone.

The value is read into independent generators (see `reading`), once for every possible choice
of signs of the factors whose sign is not known; it vanishes if it does so in every case.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import isqrt
from typing import TYPE_CHECKING

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.constants import is_zero_form
from rbpsym.decide.factoring import NONZERO, ZERO, cleared, reduced, split
from rbpsym.decide.points import all_atoms
from rbpsym.decide.reading import CaseReading, Constraint
from rbpsym.decide.rooted import neat
from rbpsym.errors import LimitError, Undecided
from rbpsym.field import ONE, UNIT, Bases, Coefficient, Monomial, Poly, Scalar, atoms, bases_of, has_roots, inside
from rbpsym.field.roots import is_root, without_even_roots
from rbpsym.frozen import Frozen

MOST_CASES = 64
Signs = dict[Poly, int]
HOW = {False: "exact algebra of roots and functions", True: "exact algebra of roots in t = tan(a/2)"}


def vanishes(value: Scalar, assumptions: Assumptions, *, deep: bool) -> str:
    """How it was proved that the numerator vanishes wherever it has a value; "" if it was not."""
    value = without_even_roots(inside(value, lambda part: neat(part, assumptions) if has_roots(part) else part))
    bases = _bases(value)
    try:
        forced = _forced(value, CaseReading(assumptions, bases, deep, {}))
        real = _count_cases(value, assumptions, bases, deep, forced)
    except (LimitError, Undecided, ZeroDivisionError):
        return ""
    return HOW[deep] + (f", in each of {real} cases of signs" if real > 1 else "") if real else ""


def _count_cases(value: Scalar, assumptions: Assumptions, bases: Bases, deep: bool, forced: Signs) -> int:
    """The number of cases of signs, if the value vanishes in each of them; else 0."""
    waiting, real = [dict(forced)], 0
    for _ in range(MOST_CASES):
        if not waiting:
            return real
        reading = CaseReading(assumptions, bases, deep, waiting.pop())
        found = _in_case(value, reading, forced)
        if found is False:
            return 0
        waiting.extend(_other_cases(reading.case, reading.assumed))
        real += found is True
    return 0


def _in_case(value: Scalar, reading: CaseReading, forced: Signs) -> bool | None:
    """Whether it vanishes in this case; None if no point of the domain needs this case."""
    whole, _ = cleared(reading.poly(value.num))
    broken = [constraint for constraint in reading.constraints if reading.is_broken(constraint)]
    if broken:
        return None if _is_void(broken, reading, forced) else False
    return is_zero_form(reduced(whole))


def _forced(value: Scalar, reading: CaseReading) -> Signs:
    """Signs that follow from the existence of a root with only one factor of unknown sign."""
    reading.poly(value.num)
    forced: Signs = {}
    for constraint in reading.constraints:
        unknown = [factor for factor in constraint.odd() if _is_unknown(factor, reading)]
        if len(unknown) == 1 and _is_strict(constraint, reading, except_for=unknown):
            forced[unknown[0]] = reading.case.get(unknown[0], 1) * (-1 if reading.is_broken(constraint) else 1)
    return forced


def _is_unknown(factor: Poly, reading: CaseReading) -> bool:
    return reading.mask(factor) & NONZERO == NONZERO


def _is_strict(constraint: Constraint, reading: CaseReading, except_for: list[Poly]) -> bool:
    """Whether the other factors surely do not vanish where the constraint holds."""
    if constraint.is_strict:
        return True
    vanishing = [factor for factor, k in constraint.factors.items() if k > 0 and reading.mask(factor) & ZERO]
    return set(vanishing) <= set(except_for)


def _is_void(broken: list[Constraint], reading: CaseReading, forced: Signs) -> bool:
    """Whether each point of the domain in this (closed) case lies in another case as well.

    So it is if some constraint is surely violated; or if in each violated one only factors of
    unknown sign may vanish, and these occur in no other constraint: then they may be flipped.
    """
    if any(_is_strict(constraint, reading, []) for constraint in broken):
        return True
    return all(_may_flip(constraint, reading, forced) for constraint in broken)


def _may_flip(constraint: Constraint, reading: CaseReading, forced: Signs) -> bool:
    free = [factor for factor in constraint.odd() if factor not in forced and _is_unknown(factor, reading)]
    different = {(other.sign, frozenset(other.odd())) for other in reading.constraints}
    uses = [factor for _, factors in different for factor in factors]
    inside = [factor for other in reading.constraints for factor in other.factors]
    nested = any(atoms.atom(index).kind in ("root", "ln") for factor in inside for index in factor.atoms())
    single = all(uses.count(factor) == 1 for factor in free)
    return single and not nested and _is_strict(constraint, reading, except_for=free)


def _other_cases(case: Signs, assumed: list[Poly]) -> list[Signs]:
    """The cases in which one of the assumed signs is the other one (those before it kept)."""
    known = {factor: sign for factor, sign in case.items() if factor not in assumed}
    others = []
    for factor in assumed:
        others.append({**known, factor: -1})
        known[factor] = 1
    return others


def _bases(value: Scalar) -> Bases:
    """Base angles of everything, also of what stands inside roots and functions."""
    waves = [index for index in all_atoms([value]) if atoms.atom(index).kind in ("cos", "sin")]
    return bases_of(Poly({((index, 1),): 1 for index in waves}))


if TYPE_CHECKING:
    from rbpsym.decide.factoring import Factors
    from rbpsym.decide.reading import CaseReading

HALF = Fraction(1, 2)


class Denested(Frozen):
    """`image` is the root of one factor (with the coefficient); `others` are left to be taken."""

    image: Poly
    others: Factors


def denested(reading: CaseReading, coefficient: Fraction, found: Factors) -> Denested | None:
    """The root of a factor with a root inside, if it can be written without nesting."""
    for factor, k in found.items():
        if k % 2 and len(factor) > 1 and any(is_root(index) for index in factor.atoms()):
            others = {f: e for f, e in found.items() if f != factor} | {factor: k - 1}
            signs = [reading.sign(f) for f, e in others.items() if e % 2]
            image = _root_of(reading, factor.scaled(coefficient)) if -1 not in signs else None
            if image is not None:
                return Denested(image, others)
    return None


def _parts(poly: Poly) -> dict[Monomial, Poly]:
    """The terms by their product of roots."""
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        roots = tuple(item for item in m if is_root(item[0]))
        parts.setdefault(roots, {})[tuple(item for item in m if not is_root(item[0]))] = c
    return {roots: Poly(terms) for roots, terms in parts.items()}


def _root_of(reading: CaseReading, poly: Poly) -> Poly | None:
    parts = _parts(poly)
    if len(parts) != 2 or UNIT not in parts:
        return None
    a = parts.pop(UNIT)
    [(roots, b)] = parts.items()
    square = reduce(lambda product, item: product * atoms.atom(item[0]).arg.num, roots, ONE)
    d = square_root(reading, reduced(a * a - b * b * square))
    if d is None or reading.sign(a) < 0:
        return None
    low, high = (reading.power(atoms.intern("root", Scalar(x.scaled(HALF))), 1) for x in (a - d, a + d))
    return high + low if reading.sign(b) > 0 else high - low


def square_root(reading: CaseReading, poly: Poly) -> Poly | None:
    """|D| if the polynomial is a square D²."""
    if not poly.terms:
        return poly
    rational, powers = poly.content()
    coefficient, found = split(poly.scaled(1 / rational, tuple((i, -e) for i, e in powers)), reading.deep)
    number = _number_root(coefficient * rational)
    factors = [*found, *((Poly({((i, 1),): 1}), e) for i, e in powers)]
    if number is None or any(k % 2 for _, k in factors):
        return None
    result = Poly({UNIT: number})
    for factor, k in factors:
        result = result * reading.absolute(factor, k // 2)
    return result


def _number_root(value: Fraction) -> Fraction | None:
    if value < 0:
        return None
    p, q = isqrt(value.numerator), isqrt(value.denominator)
    return Fraction(p, q) if p * p == value.numerator and q * q == value.denominator else None
