"""How much work something is, counted in calls: the same on a slow machine, a busy one and a quick one."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

SOON = 1_500_000  # calls, of C too: a fifth of a second, or two on a slow machine
MANY = 30_000_000


class TooMuchWork(AssertionError):
    """More calls than were granted."""


@contextmanager
def at_most(calls: int = SOON) -> Iterator[None]:
    """Fails as soon as what is done within needs more calls than these, of Python or of C."""
    left = calls

    def count(_frame: FrameType, event: str, _argument: object) -> None:
        nonlocal left
        left -= event in ("call", "c_call")
        if left < 0:
            sys.setprofile(before)
            raise TooMuchWork(f"more than {calls} calls")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        yield
    finally:
        sys.setprofile(before)
