"""A bound on work that does not depend on the machine: products of terms, counted as they are made.

What is multiplied out within `at_most(n)` may make n products of terms; beyond, LimitError is
raised. So a method that does not lead to an end is given up, on every machine at the same place.
The bound belongs to the call: another thread has its own.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from math import inf

from rbpsym.errors import LimitError

_left: ContextVar[list[float] | None] = ContextVar("products that are left", default=None)


def spend(products: int) -> None:
    """Counts. Raises LimitError where more is spent than is allowed."""
    left = _left.get()
    if left is not None:
        left[0] -= products
        if left[0] < 0:
            raise LimitError("the expression grows beyond what can be expanded exactly")


@contextmanager
def at_most(products: int) -> Iterator[None]:
    """Within it, no more products than these (nor than an outer bound leaves)."""
    outer = _left.get()
    granted = min(inf if outer is None else outer[0], products)
    own = [granted]
    token = _left.set(own)
    try:
        yield
    finally:
        _left.reset(token)
        if outer is not None:
            outer[0] -= granted - own[0]


@contextmanager
def apart() -> Iterator[None]:
    """Within it, what is spent counts for no bound that was set outside."""
    token = _left.set(None)
    try:
        yield
    finally:
        _left.reset(token)
