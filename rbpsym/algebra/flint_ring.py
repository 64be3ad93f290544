"""Polynomials over ℚ as flint has them; `algebra.ring` asks for them where flint is installed."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from rbpsym.algebra.poly import Coefficient


@lru_cache(maxsize=256)
def _context(count: int) -> tuple[Any, Any]:
    from flint import Ordering, fmpq, fmpq_mpoly_ctx

    return fmpq_mpoly_ctx.get([f"x{k}" for k in range(count)], Ordering.lex), fmpq


def element(terms: dict[tuple[int, ...], Coefficient], count: int) -> Any:
    """An element of ℚ[x0, ...] from its coefficients by powers."""
    context, ratio = _context(count)
    return context.from_dict({m: c if type(c) is int else ratio(c.numerator, c.denominator) for m, c in terms.items()})


def cofactors(a: Any, b: Any) -> tuple[Any, Any] | None:
    """Both without their greatest common divisor; None if there is none."""
    common = a.gcd(b)
    return None if common.is_one() else (a / common, b / common)


def factor_list(value: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """Coefficient and irreducible factors."""
    coefficient, found = value.factor()
    return coefficient, found
