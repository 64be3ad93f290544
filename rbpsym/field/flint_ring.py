"""Polynomials over ℚ and enclosed functions as flint has them; both are asked for where flint is installed."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any

from rbpsym.field.poly import Coefficient


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


def enclosed(name: str, value: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """The middle and the radius of what encloses a function of a fraction."""
    from flint import acb, arb, ctx, fmpq

    with ctx.workprec(bits):
        argument = arb(fmpq(value.numerator, value.denominator))
        found = acb(argument).elliptic_k().real if name == "elliptic_k" else getattr(argument, name)()
        (middle, shift), (radius, scale) = found.mid().man_exp(), found.rad().man_exp()
    return int(middle) * Fraction(2) ** int(shift), int(radius) * Fraction(2) ** int(scale)
