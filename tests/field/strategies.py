"""Random exact values for property tests, and their numbers in double precision."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from hypothesis import settings
from hypothesis import strategies as st

from rbpsym.field import atoms
from rbpsym.field.normal import is_zero
from rbpsym.field.poly import Poly
from rbpsym.field.scalar import PI, Scalar, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import polar, vector_sum

steady = settings(max_examples=80)
A, B, X, Y, M = map(symbol, "abxym")

fractions = st.builds(Fraction, st.integers(-6, 6), st.sampled_from([1, 1, 1, 2, 3, 4]))
numbers = fractions.map(lift)
angles = st.builds(
    lambda p, q, turns, parts: A * Fraction(p, parts) + B * q + PI * turns,
    st.integers(-2, 2),
    st.integers(-2, 2),
    st.sampled_from([Fraction(0), Fraction(0), Fraction(1, 2), Fraction(1), Fraction(-1, 3), Fraction(1, 4)]),
    st.sampled_from([1, 1, 2]),
)
waves = st.one_of(angles.map(cosine), angles.map(sine))
symbols = st.sampled_from([X, Y, M])
leaves = st.one_of(numbers, symbols, waves)


def _sums(parts):
    return st.one_of(
        st.builds(lambda p, q: p + q, parts, parts),
        st.builds(lambda p, q: p - q, parts, parts),
        st.builds(lambda p, q: p * q, parts, parts),
    )


polynomials = st.recursive(leaves, _sums, max_leaves=6)
divisors = polynomials.filter(lambda value: not is_zero(value))
quotients = st.builds(lambda p, q: p / q, polynomials, divisors)
scalars = st.one_of(polynomials, quotients)
vectors = st.lists(st.tuples(st.one_of(numbers, symbols), angles), max_size=3).map(vector_sum)
unit_vectors = angles.map(lambda angle: polar(lift(1), angle))

POINT = {"a": 0.7, "b": -1.3, "x": 1.9, "y": 0.6, "m": 2.3}
OTHER = {"a": -2.1, "b": 0.4, "x": 0.35, "y": 3.1, "m": 1.2}
FUNCTIONS = {
    "cos": math.cos,
    "sin": math.sin,
    "root": math.sqrt,
    "exp": math.exp,
    "ln": math.log,
    "atan": math.atan,
    "asin": math.asin,
    "acos": math.acos,
}


def number(value: Scalar | Poly, at: Mapping[str, float] = POINT) -> float:
    """The value in double precision, computed term by term."""
    if isinstance(value, Scalar):
        return number(value.num, at) / number(value.den, at)
    return sum(float(c) * math.prod(_atom(i, at) ** e for i, e in m) for m, c in value.terms.items())


def _atom(index: int, at: Mapping[str, float]) -> float:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return math.pi if found.arg == "pi" else at[found.arg]
    return FUNCTIONS[found.kind](number(found.arg, at))


def close(a: float, b: float) -> bool:
    """Whether two numbers agree up to rounding."""
    return math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-6)
