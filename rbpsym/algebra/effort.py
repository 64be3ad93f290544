"""A bound on work that does not depend on the machine: products of terms, counted as they are made.

What is multiplied out within `at_most(n)` may make n products of terms; beyond, LimitError is
raised. So a method that does not lead to an end is given up, on every machine at the same place.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from math import inf

from rbpsym.errors import LimitError

_left = inf


def spend(products: int) -> None:
    """Counts. Raises LimitError where more is spent than is allowed."""
    global _left
    _left -= products
    if _left < 0:
        raise LimitError("the expression grows beyond what can be expanded exactly")


def is_bounded() -> bool:
    """Whether some bound holds now."""
    return _left != inf


@contextmanager
def at_most(products: int) -> Iterator[None]:
    """Within it, no more products than these (nor than an outer bound leaves)."""
    global _left
    outer = _left
    granted = _left = min(outer, products)
    try:
        yield
    finally:
        _left = outer - (granted - _left)
