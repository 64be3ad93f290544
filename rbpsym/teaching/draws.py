"""Draws that are the same on every machine: SHA-256 in counter mode, no state but the seed.

`random` is not used: its sequence is promised for one version of Python only.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from hashlib import sha256
from typing import TypeVar

T = TypeVar("T")
WORD = 1 << 64


class Draws:
    """A stream of draws from a seed and a label; two labels give independent streams.

    >>> [Draws(b"seed", "a").below(6) for _ in range(3)] == [Draws(b"seed", "a").below(6)] * 3
    True
    """

    __slots__ = ("_block", "_count", "_key")

    def __init__(self, seed: bytes, label: str = "") -> None:
        self._key = sha256(seed + b"\x00" + label.encode()).digest()
        self._count, self._block = 0, b""

    def word(self) -> int:
        """The next 64 bits."""
        if not self._block:
            self._block = sha256(self._key + self._count.to_bytes(8, "big")).digest()
            self._count += 1
        found, self._block = self._block[:8], self._block[8:]
        return int.from_bytes(found, "big")

    def below(self, bound: int) -> int:
        """An integer from 0 to bound - 1, each as likely (ValueError for bound < 1 or above 2**64)."""
        if not 1 <= bound <= WORD:
            raise ValueError("nothing to draw from, or too much")
        limit = WORD - WORD % bound
        while True:
            found = self.word()
            if found < limit:
                return found % bound

    def one_of(self, items: Sequence[T]) -> T:
        """One of the items."""
        return items[self.below(len(items))]

    def shuffled(self, items: Sequence[T]) -> list[T]:
        """The items in another order (Fisher and Yates)."""
        found = list(items)
        for place in range(len(found) - 1, 0, -1):
            other = self.below(place + 1)
            found[place], found[other] = found[other], found[place]
        return found

    def step(self, low: Fraction, high: Fraction, step: Fraction) -> Fraction:
        """One of low, low + step, ..., not above high; `low` itself where the step is 0."""
        count = int((high - low) / step) if step > 0 else 0
        return low + self.below(count + 1) * step
