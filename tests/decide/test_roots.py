"""No claim about roots is proved that fails anywhere on a lattice, boundaries and zeros included."""

from __future__ import annotations

import itertools
import random
from fractions import Fraction

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import equal
from rbpsym.decide.radicals import vanishes
from rbpsym.decide.verdict import PROVED, REFUTED
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import root
from rbpsym.field.scalar import symbol
from tests.decide.numeric import NoValue, at_witness, mpmath, number

FACTORS = ["x", "y", "(x - 1)", "(x + y)", "(-x)", "(x**2 + y**2)", "(y - x)", "2", "(1 - x**2)"]
LATTICE = [Fraction(n, 2) for n in (-4, -2, -1, 0, 1, 2, 3, 4)]
GIVEN = [
    Assumptions(),
    Assumptions({"x": "positive"}),
    Assumptions({"y": "nonnegative"}),
    Assumptions({"x": "nonzero"}),
]
HOLDS = {"positive": lambda v: v > 0, "nonnegative": lambda v: v >= 0, "nonzero": lambda v: v != 0}


def some_claim(source: random.Random) -> tuple[str, str]:
    """A root of a product, and the same taken apart, perhaps wrongly; perhaps with company."""
    f, g, h = (source.choice(FACTORS) for _ in range(3))
    left, right = source.choice([
        (f"sqrt({f}*{g})", f"sqrt({f})*sqrt({g})"),
        (f"sqrt({f}**2*{g})", f"{f}*sqrt({g})"),
        (f"sqrt({f}**2*{g})", f"abs({f})*sqrt({g})"),
        (f"sqrt({f}/{g})", f"sqrt({f}*{g})/{g}"),
        (f"sqrt({f}/{g})", f"sqrt({f}*{g})/abs({g})"),
        (f"sqrt({f}**2)", f),
        (f"sqrt({f}**3*{g})", f"{f}*sqrt({f}*{g})"),
        (f"sqrt({f}*{g})*sqrt({g}*{h})", f"{g}*sqrt({f}*{h})"),
        (f"sqrt({f}*{g})*sqrt({g}*{h})", f"abs({g})*sqrt({f}*{h})"),
        (f"abs({f}*{g})", f"abs({f})*{g}"),
    ])  # fmt: skip
    a, b = source.choice(FACTORS), source.choice(FACTORS)
    more = source.choice(["", f" + sqrt({a}*{b})", f" + sqrt({a})", f" + abs({a})*sqrt({b})", f" + sqrt(-{a}**2*{b})"])
    return left + more, right + more


@pytest.mark.parametrize("seed", range(150))
def test_verdicts_on_roots(seed: int) -> None:
    source = random.Random(seed)
    left, right = (read_infix(text, ["x", "y"]) for text in some_claim(source))
    given = source.choice(GIVEN)
    verdict = equal(left, right, given)
    if verdict.kind is REFUTED:
        point = at_witness(verdict.witness)
        assert abs(number(left, point) - number(right, point)) > mpmath.mpf(10) ** -30
    if verdict.kind is not PROVED:
        return
    for x, y in itertools.product(LATTICE, repeat=2):
        point = {"x": mpmath.mpf(x.numerator) / x.denominator, "y": mpmath.mpf(y.numerator) / y.denominator}
        if all(HOLDS[sign](point[name]) for name, sign in given.signs.items()):
            try:
                a, b = number(left, point), number(right, point)
            except NoValue:
                continue
            assert abs(a - b) < mpmath.mpf(10) ** -30, (seed, point, str(verdict))


@pytest.mark.parametrize(("sign", "proof"), [("positive", True), ("nonnegative", False), ("real", False)])
def test_a_root_tells_no_sign_beside_what_may_vanish(sign, proof) -> None:
    """√(x y) asks for y ≥ 0 where x > 0; where x = 0 it asks for nothing."""
    x, y = symbol("x"), symbol("y")
    claim = (root(x * y) + 1) * (root(y * y) - y)
    assert bool(vanishes(claim, Assumptions({"x": sign}), deep=False)) is proof
