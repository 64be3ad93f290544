"""Complete elliptic integrals as numbers, functions of the parameter m = k² < 1 (Abramowitz and Stegun, 17.6)."""

from __future__ import annotations

import math

CLOSE = 1e-16


def first(m: float) -> float:
    """K = ∫ du/√(1 - m sin² u) from 0 to π/2, by the arithmetic-geometric mean. Raises ValueError for m ≥ 1.

    >>> first(0.0) == math.pi / 2
    True
    """
    return _means(m)[0]


def second(m: float) -> float:
    """E = ∫ √(1 - m sin² u) du from 0 to π/2, in the same way."""
    whole, gone = _means(m)
    return whole * (1 - gone)


def _means(m: float) -> tuple[float, float]:
    """(K, 1 - E/K)."""
    if not m < 1:
        raise ValueError("an elliptic integral of a modulus that is not less than 1")
    a, b, gone, weight = 1.0, math.sqrt(1 - m), m / 2, 0.5
    while abs(a - b) > CLOSE * a:
        c, weight = (a - b) / 2, weight * 2
        a, b, gone = (a + b) / 2, math.sqrt(a * b), gone + weight * c * c
        if abs(c) < CLOSE * a:
            break
    return math.pi / (2 * a), gone
