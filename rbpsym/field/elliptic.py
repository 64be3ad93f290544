"""The functions of the field as functions of floats; complete elliptic integrals, of the parameter m = k² < 1 (Abramowitz and
Stegun, 17.6)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

N = TypeVar("N", float, complex)

CLOSE, MOST = 1e-16, 40  # of two means to each other, and of their steps


def first(m: N) -> N:
    """K = ∫ du/√(1 - m sin² u) from 0 to π/2, by the arithmetic-geometric mean; next to the real axis too, for derivatives.
    Raises ValueError for m ≥ 1.

    >>> first(0.0) == math.pi / 2
    True
    """
    return _means(m)[0]


def second(m: N) -> N:
    """E = ∫ √(1 - m sin² u) du from 0 to π/2, in the same way."""
    whole, gone = _means(m)
    return whole * (1 - gone)


def _means(m: N) -> tuple[N, N]:
    """(K, 1 - E/K)."""
    if not m.real < 1:
        raise ValueError("an elliptic integral of a modulus that is not less than 1")
    root: Any = cmath.sqrt if isinstance(m, complex) else math.sqrt  # of the kind of m
    weight = 0.5
    a: N
    a, b, gone = 1.0, root(1 - m), m / 2
    for _ in range(MOST):
        c, weight = (a - b) / 2, weight * 2
        a, b, gone = (a + b) / 2, root(a * b), gone + weight * c * c
        if abs(c) < CLOSE * abs(a):
            break
    return math.pi / (2 * a), gone


FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    "cos": math.cos,
    "sin": math.sin,
    "root": math.sqrt,
    "exp": math.exp,
    "ln": math.log,
    "atan": math.atan,
    "asin": math.asin,
    "acos": math.acos,
    "elliptic_k": first,
    "elliptic_e": second,
}
