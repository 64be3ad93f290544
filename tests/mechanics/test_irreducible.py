"""What is known to be irreducible without a search is what the search would give."""

import pytest

from rbpsym.field.ring import factors
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.mechanics.roots import _is_irreducible, numerator_factors

a, b, c, x = (symbol(name) for name in "abcx")
s, k = sine(x), cosine(x)
VALUES = [a + b, a * b + c, 3 * s - 2 * a, 1 - 6 * s * a + 9 * s * s, a * s * (b + c), (a + b) * (a - b),
          a * a + 2 * a * b + b * b, a * b + b * c + a * c, s * k * a, a * a * b + c, a - a * b, s * s + k]  # fmt: skip


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_the_same_factors_as_by_search(value):
    searched = {Scalar(factor.scaled(1 / factor.content()[0])) for factor, _ in factors(value.num)[1]}
    found = {Scalar(factor.scaled(1 / factor.content()[0])) for factor in numerator_factors(value)}
    assert {frozenset((f, -f)) for f in found} == {frozenset((f, -f)) for f in searched}


def test_a_product_is_not_taken_for_irreducible():
    assert not _is_irreducible(((a + b) * (a + c)).num)
