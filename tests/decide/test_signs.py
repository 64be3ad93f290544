"""Signs are certified where they hold, and never where a point contradicts them."""

from __future__ import annotations

import random

import mpmath
import pytest

from rbpsym.decide import factoring
from rbpsym.decide.assumptions import positive
from rbpsym.decide.signs import sign
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import root
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import symbol
from tests.decide.numeric import number, some_points
from tests.decide.rows import names_in, read_assumptions

LADDER = "positive M g ell; 0 < theta < pi/2; 0 < theta_0 < pi/2"
RELEASED = "0 < theta < theta_0; 0 < theta_0 < pi/2"
CASES = [
    ("m + M", "positive", "positive"),
    ("m - M", "positive", None),
    ("-m*M**3", "positive", "negative"),
    ("m*M", "nonzero m M", "nonzero"),
    ("x**2", "", "nonnegative"),
    ("x**2 + 1", "", "positive"),
    ("x**2 + 2*x*cos(theta) + 1", "", "nonnegative"),
    ("x**2 + 2*x*cos(theta) + 2", "", "positive"),
    ("x**2 - 5*x + 7", "0 < x < 3", "positive"),
    ("y*x**2 - 3*x + 2", "1 < x < 2; 0 < y < 1", "negative"),
    ("x**3 + 2*x - 2", "1 < x < 2", "positive"),
    ("x**3/m + x/M - 2", "2 < x < 5; 0 < m < 1; 0 < M < 1", "positive"),
    ("x**2 - 2*x + 1", "", "nonnegative"),
    ("x**2 - 2*x + 2", "", "positive"),
    ("x**2 - 2*x*y + 2*y**2", "", "nonnegative"),
    ("a**2 + b**2 - a*b", "positive", "positive"),
    ("a**2 + b**2 + c**2 - a*b - b*c - c*a", "", "nonnegative"),
    ("x**4 + x**2*y**2 + y**4", "nonzero x y", "positive"),
    ("x - x", "", "zero"),
    ("9216*x**4 - 192*x**2*y**2 + 16*y**4", "positive", "positive"),
    ("x**4 - 3*x**2 + 2", "", None),
    ("3*x*sqrt(128*y**2 + x**2) - 96*y**2 - 5*x**2", "positive", "negative"),
    ("exp(x) - 2 + exp(-x)", "positive", "positive"),
    ("exp(x) - 2 + exp(-x)", "", "nonnegative"),
    ("exp(x/2) - exp(x/3)", "positive", "positive"),
    ("exp(x)*exp(y) - 1", "positive", "positive"),
    ("exp(x) - exp(2*x)", "", None),
    ("exp(x) + exp(-x) - 3", "positive", None),
    ("cos(theta)", "0 < theta < pi/2", "positive"),
    ("cos(theta)", "0 < theta < pi", None),
    ("cos(theta)", "pi/2 < theta < pi", "negative"),
    ("sin(theta)", "0 < theta < pi", "positive"),
    ("sin(2*theta)", "0 < theta < pi/2", "positive"),
    ("sin(theta/2)", "0 < theta < pi", "positive"),
    ("sin(theta)", "-pi/2 < theta < pi/2", None),
    ("1 - cos(theta)", "", "nonnegative"),
    ("1 - cos(theta)", "0 < theta < pi/2", "positive"),
    ("2 - cos(theta) - sin(phi)", "", "nonnegative"),
    ("3 - cos(theta) - sin(phi)", "", "positive"),
    ("1 + 3*sin(theta)**2", "", "positive"),
    ("m1 + m2*sin(theta1 - theta2)**2", "positive m1 m2", "positive"),
    ("2*m1 + m2 - m2*cos(2*theta1 - 2*theta2)", "positive m1 m2", "positive"),
    ("m1 + m2 - m2*cos(theta1 - theta2)**2", "positive m1 m2", "positive"),
    ("9*sin(phi)**2 - 16 + 18*sin(phi)*sin(theta - phi)*cos(theta) + 9*cos(theta)**2", "", "negative"),
    ("1 - 6*sin(theta)*sin(theta_0) + 9*sin(theta)**2", LADDER, "positive"),
    ("1 - 6*s*s0 + 9*s**2", "0 < s < 1; 0 < s0 < 1", "positive"),
    ("1 - 6*s*s0 + 9*s**2", "positive", None),
    ("sin(theta_0) - sin(theta)", RELEASED, "positive"),
    ("cos(theta) - cos(theta_0)", RELEASED, "positive"),
    ("sin(theta_0 - theta)", RELEASED, "positive"),
    ("cos(theta_0 - theta)", RELEASED, "positive"),
    ("2*sin(theta_0)/3 - sin(theta_0)", RELEASED, "negative"),
    ("3*sin(theta) - 2*sin(theta_0)", RELEASED, None),
    ("pi - 3", "", "positive"),
    ("sqrt(2) + sqrt(3) - pi", "", "positive"),
    ("sqrt(2)*sqrt(3) - sqrt(6)", "", "zero"),
    ("cos(pi/5) - (1 + sqrt(5))/4", "", "zero"),
    ("sqrt(m**2 + M**2) - m", "positive", "positive"),
    ("m - sqrt(m**2 + M**2)", "positive", "negative"),
    ("sqrt(x)", "", "nonnegative"),
    ("pi/2 - atan(x)", "", "positive"),
    ("pi/2 - asin(x)", "", "nonnegative"),
    ("pi - acos(x)", "", "nonnegative"),
    ("acos(x)", "", "nonnegative"),
    ("pi/2 - acos(x)", "positive", "nonnegative"),
    ("exp(x) + 1", "", "positive"),
    ("ln(1 + x)", "positive", "positive"),
    ("x*(1 - x)", "0 < x < 1", "positive"),
    ("x**3 - x", "1 < x < ", "positive"),
    ("x**3 - x", "0 < x < 1", "negative"),
    ("(R - r)**2 + 2*r", "positive", "positive"),
    ("2*k*L - m - M", "positive k L m; 0 < M < 2*k*L - m", "positive"),
    ("2*k*L - m - M", "positive k L m; 0 < M < 2*k*L", None),
    ("1 - ((m + M)/(2*k*L))**2", "positive k L m; 0 < M < 2*k*L - m", "positive"),
    ("M - m", "positive k m; m < M < k", "positive"),
]


@pytest.mark.parametrize(("text", "assuming", "kind"), CASES)
def test_sign(text: str, assuming: str, kind: str | None) -> None:
    names = names_in(text)
    found = sign(scalar(read_infix(text, names)), read_assumptions(assuming, names_in(text)))
    assert found.kind == kind
    assert found.certificate or kind is None


OBEYS = {
    "positive": lambda x: x > 0,
    "negative": lambda x: x < 0,
    "zero": lambda x: abs(x) < mpmath.mpf(10) ** -40,
    "nonnegative": lambda x: x > -(mpmath.mpf(10) ** -40),
    "nonpositive": lambda x: x < mpmath.mpf(10) ** -40,
    "nonzero": lambda x: x != 0,
    None: lambda x: True,
}
PIECES = ["x", "y", "1", "2", "3*x", "x*y", "x**2", "y**2", "x**2*y", "cos(a)", "sin(a)", "cos(a)**2", "sin(a)*cos(b)",
          "cos(a - b)", "sin(2*a)", "x*cos(a)", "sqrt(x)", "1/x", "y/x"]  # fmt: skip
GIVEN = ["positive x", "positive x y", "positive x; 0 < a < pi/2", "0 < x < 1; 0 < y < 1; 0 < a < pi", "nonzero x y"]


@pytest.mark.parametrize("seed", range(60))
def test_no_sign_is_contradicted(seed: int) -> None:
    """Random sums under random assumptions, tried at random points."""
    source = random.Random(seed)
    terms = [f"{source.choice(['', '-', '2*', '-3*'])}{source.choice(PIECES)}" for _ in range(source.randint(2, 4))]
    text, assuming = " + ".join(f"({term})" for term in terms), source.choice(GIVEN)
    names = names_in(text)
    wanted = sorted({*names, *names_in(assuming.replace("positive", "").replace("nonzero", ""))})
    found = sign(scalar(read_infix(text, names)), read_assumptions(assuming, wanted))
    for point in some_points(assuming, wanted, 30, seed):
        if point.get("x", 1) > 0:
            assert OBEYS[found.kind](number(read_infix(text, names), point)), (text, assuming, found, point)


def test_masks() -> None:
    """The arithmetic of sets of signs holds for all pairs of signs."""
    for a in range(8):
        for b in range(8):
            for x in factoring.members(a):
                for y in factoring.members(b):
                    assert factoring.times(a, b) & factoring.BITS[x * y]
                    for total in {-1, 0, 1} if x * y < 0 else {max(x, y, key=abs)}:
                        assert factoring.plus(a, b) & factoring.BITS[total]


@pytest.mark.parametrize("power", [1, 2, 3, 4])
def test_an_end_of_a_range_may_hold_a_root(power: int) -> None:
    """c < 2 √(m k) decides 4 m k - c², and what is made of it."""
    m, k, c = (symbol(name) for name in "mkc")
    given = positive("m", "k", "c").with_range("c", None, 2 * root(m * k))
    gap = (4 * m * k - c * c) * c**power
    assert sign(gap, given).kind == "positive" and sign(-gap / m, given).kind == "negative"
    assert sign(gap, positive("m", "k", "c")).kind is None


NEARLY = ("499999/1000000", "-499999/1000000", "1/2", "-1/2", "1", "-1")


@pytest.mark.parametrize("mean", NEARLY)
def test_between_ends_of_both_signs_a_wave_may_vanish(mean: str) -> None:
    """A + sin x cos x, of which points see one sign only where A is close to 1/2: its zeros are there all the same."""
    kind = sign(scalar(read_infix(f"{mean} + sin(x)*cos(x)", ("x",)))).kind
    size = {"499999/1000000": None, "-499999/1000000": None, "1/2": "nonnegative", "-1/2": "nonpositive"}
    assert kind == size.get(mean, "positive" if mean == "1" else "negative")
