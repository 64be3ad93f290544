"""Sums of squares: what is said of a formula multiplies out, and is positive."""

from __future__ import annotations

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.kernel.certificates import wound
from rbpsym.kernel.positive import positive_sum

POSITIVE = ("M", "m", "k", "r", "a", "p")
SUMS = [
    "4*(M + m) - 3*m*cos_x^2", "k^2 + r^2 + a^2 - 2*r*a*cos_x", "M^2 + m^2 + 2*M*m*cos_x + M*m", "9*sin_x^2 - 16",
    "p^2 + u^2", "3*M - m*u^2*sin_x^2 + m*u^2", "M - sin_x*M/2", "2*r^2 + a^2 - 2*a*r*sin_x - 2*r^2*cos_x",
]  # fmt: skip
NONE = [
    "M - m",
    "M - 2*m*cos_x",
    "u^2 - 1",
    "cos_x",
    "u",
    "M*u",
    "M^2 + m^2 - 2*M*m",
    "M - m*cos_x*sin_x",
    "2*r^2 + a^2 - 3*a*r*sin_x - 2*r^2*cos_x",
]


def read(formula: str) -> Scalar:
    """The value, its sines and cosines as letters."""
    value = scalar(read_infix(formula, [*POSITIVE, "u", "sin_x", "cos_x"]))
    return substitute(value, {f"{kind}_x": symbol(f"{kind} x") for kind in ("sin", "cos")})


def atoms() -> set[int]:
    return {index for name in POSITIVE for index in symbol(name).atoms()}


@pytest.mark.parametrize("formula", SUMS)
def test_a_sum_is_the_formula_and_positive(formula: str) -> None:
    value, positive = read(formula), atoms()
    found = positive_sum(value.num, positive)
    assert found is not None
    whole = sum((factor * root * root for factor, root in found.squares), found.above)
    whole = sum((factor * (wave * turn + 1) for factor, wave, turn in found.waves), whole)
    assert not wound(value * found.sign - whole)
    for factor in (found.above, *(factor for factor, _ in found.squares), *(factor for factor, _, _ in found.waves)):
        assert factor.atoms() <= positive and all(c > 0 for c in factor.num.terms.values())


@pytest.mark.parametrize("formula", NONE)
def test_there_is_none_for_what_may_vanish(formula: str) -> None:
    assert positive_sum(read(formula).num, atoms()) is None
