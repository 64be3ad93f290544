"""Whether a position of rest is stable: signs of the leading minors of the stiffness (Lagrange-Dirichlet)."""

from __future__ import annotations

from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.field import UNITY, Scalar, generator, is_zero, name_of, short, with_root_taken_out
from rbpsym.field.normal import is_root_of_number
from rbpsym.mechanics.elimination import Matrix, determinant
from rbpsym.mechanics.roots import numerator_factors


def is_stable(matrix: Matrix, assumptions: Assumptions) -> bool | None:
    """True if the matrix is positive definite, False where a direction has negative stiffness, None: not decided."""
    diagonal = [sign(row[k], assumptions).kind for k, row in enumerate(matrix)]
    if "negative" in diagonal:
        return False
    minors = [sign(minor, assumptions).kind for minor in _minors(matrix)]
    if all(kind == "positive" for kind in minors):
        return True
    return False if minors and minors[-1] == "negative" else None


def stable_where(matrix: Matrix, assumptions: Assumptions) -> Scalar | None:
    """What is positive where the place is stable and negative where it is not, as short as it gets; None if more than
    one condition would be needed."""
    open_ones = [minor for minor in _minors(matrix) if sign(minor, assumptions).kind != "positive"]
    if len(open_ones) != 1 or is_zero(open_ones[0]):
        return None
    return essential(open_ones[0], assumptions)


def _minors(matrix: Matrix) -> list[Scalar]:
    return [determinant(tuple(row[:k] for row in matrix[:k])) for k in range(1, len(matrix) + 1)]


def essential(value: Scalar, assumptions: Assumptions) -> Scalar:
    """The value without factors whose signs are known, as far as it can be factored."""
    value = with_root_taken_out(Scalar(value.num)) / Scalar(value.den)
    product = UNITY
    for factor in open_factors(value, assumptions):
        product = product * factor
    for found in (product, -product):
        if sign(short(value / found), assumptions).kind == "positive":
            return _primitive(short(found))
    return value


def open_factors(value: Scalar, assumptions: Assumptions) -> list[Scalar]:
    """The factors above the line whose signs are not known; the value itself where it can't be factored."""
    try:
        factors = [Scalar(factor) for factor in numerator_factors(value)]
    except RbpsymError:
        return [value]
    return [factor for factor in factors if sign(factor, assumptions).kind not in ("positive", "negative")]


def _primitive(value: Scalar) -> Scalar:
    """Without a common number, be it a root: √2 a - 2 b + √2 b as a - √2 b + b, by a term that no other is a multiple of."""
    plain = [(sorted((name_of(i), e) for i, e in m if not is_root_of_number(i)), m) for m in value.num.terms]
    single = [(key, m) for key, m in plain if sum(key == other for other, _ in plain) == 1]
    for index in (i for i, _ in max(single)[1] if is_root_of_number(i)) if single else ():
        value = short(value * Scalar(generator(index)))
    return Scalar(value.num.scaled(1 / abs(Fraction(value.num.content()[0]))), value.den)
