"""Sets of possible signs as bit masks, and their arithmetic."""

from __future__ import annotations

from collections.abc import Callable

MINUS, ZERO, PLUS = 1, 2, 4
ANY, NONZERO = MINUS | ZERO | PLUS, MINUS | PLUS
PLUS_ZERO, MINUS_ZERO = PLUS | ZERO, MINUS | ZERO
DECIDED = (PLUS, MINUS, ZERO)
BITS = {-1: MINUS, 0: ZERO, 1: PLUS}

NAMES: dict[int, str | None] = {
    PLUS: "positive",
    MINUS: "negative",
    ZERO: "zero",
    PLUS_ZERO: "nonnegative",
    MINUS_ZERO: "nonpositive",
    NONZERO: "nonzero",
    ANY: None,
    0: None,
}


def members(mask: int) -> list[int]:
    """The signs in a mask, as -1, 0, 1."""
    return [sign for sign, bit in BITS.items() if mask & bit]


def _sum_of(a: int, b: int) -> int:
    """The mask of the sum of two numbers of known signs."""
    if a == 0 or a == b:
        return BITS[b]
    return BITS[a] if b == 0 else ANY


def _table(rule: Callable[[int, int], int]) -> tuple[tuple[int, ...], ...]:
    rows = []
    for a in range(8):
        row = []
        for b in range(8):
            mask = 0
            for x in members(a):
                for y in members(b):
                    mask |= rule(x, y)
            row.append(mask)
        rows.append(tuple(row))
    return tuple(rows)


_SUM, _PRODUCT = _table(_sum_of), _table(lambda a, b: BITS[a * b])


def plus(a: int, b: int) -> int:
    """Signs that a sum may have."""
    return _SUM[a][b]


def times(a: int, b: int) -> int:
    """Signs that a product may have."""
    return _PRODUCT[a][b]


def flip(a: int) -> int:
    """Signs of the negative."""
    return _PRODUCT[a][MINUS]


def power(a: int, exponent: int) -> int:
    """Signs of an integer power; a base of a negative power is not zero."""
    if exponent < 0:
        a &= NONZERO
    return a if exponent % 2 else (a & ZERO) | (PLUS if a & NONZERO else 0)
