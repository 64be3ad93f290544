"""Form codes and draws: the few characters on a paper from which its numbers, tasks and key are made again.

A variant's seed is the first 60 bits of SHA-256(secret, worksheet, student). The code holds the seed
masked by the secret, and two check characters that depend on the seed, the secret and the
worksheet's text: who does not know the secret can't rebuild a key, and a mistyped code, a wrong secret or
a file that was changed meanwhile is noticed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from hashlib import sha256
from typing import TypeVar

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # Crockford's: no I, L, O, U
READ_AS = str.maketrans("ILO", "110")
BITS, LETTERS, CHECKS = 60, 12, 2


class FormCode(Frozen):
    """worksheet: name of its file or problem; language of the paper; seed of its variant."""

    worksheet: str
    language: str
    seed: int


def seed_of(secret: str, worksheet: str, student: str) -> int:
    """The seed of a student's variant: the first 60 bits of SHA-256 over the three, kept apart."""
    return int.from_bytes(_digest(secret, worksheet, student)[:8], "big") >> (64 - BITS)


def _digest(*parts: str) -> bytes:
    joined = b"".join(len(raw).to_bytes(8, "big") + raw for raw in (part.encode() for part in parts))
    return sha256(joined).digest()


def written(code: FormCode, secret: str, fingerprint: str) -> str:
    """The code as it is printed: `name.en.XXXX-XXXX-XXXX-CC`; `fingerprint` stands for the worksheet's text."""
    masked = code.seed ^ _mask(code, secret)
    letters = "".join(ALPHABET[(masked >> shift) & 31] for shift in range(BITS - 5, -1, -5))
    groups = [letters[at : at + 4] for at in range(0, LETTERS, 4)]
    return f"{code.worksheet}.{code.language}.{'-'.join([*groups, _check(code, secret, fingerprint)])}"


def name_in(text: str) -> tuple[str, str]:
    """(worksheet, language) of a printed code. Raises RbpsymError for what is no code."""
    parts = text.strip().rsplit(".", 2)
    if len(parts) != 3 or not all(parts):
        what = f"“{text}” is no form code"
        raise RbpsymError(what, instead="a code looks like ladder.en.7K3F-9QTM-2CAB-4D: worksheet, language, four groups.")
    return parts[0], parts[1]


def read(text: str, secret: str, fingerprint: str) -> FormCode:
    """The code that was printed. Raises RbpsymError if it is mistyped, or the secret or the file is another."""
    worksheet, language = name_in(text)
    letters = text.strip().rsplit(".", 1)[1].upper().translate(READ_AS).replace("-", "")
    for letter in letters:
        if letter not in ALPHABET:
            raise RbpsymError(f"“{letter}” can't stand in a form code", instead=f"its characters are {ALPHABET}.")
    if len(letters) != LETTERS + CHECKS:
        what = f"the form code has {len(letters)} characters instead of {LETTERS + CHECKS} after the language"
        raise RbpsymError(what, instead="copy it whole from the foot of the paper.")
    masked = sum(ALPHABET.index(letter) << shift for letter, shift in zip(letters, range(BITS - 5, -1, -5), strict=False))
    bare = FormCode(worksheet, language, 0)
    code = FormCode(worksheet, language, masked ^ _mask(bare, secret))
    if _check(code, secret, fingerprint) != letters[LETTERS:]:
        raise RbpsymError(
            f"the form code “{text}” does not fit: it is mistyped, or the secret or the worksheet's file is another",
            instead="check the characters; give the --seed with which the papers were made, and the same file.",
        )
    return code


def _mask(code: FormCode, secret: str) -> int:
    return int.from_bytes(_digest("mask", secret, code.worksheet, code.language)[:8], "big") >> (64 - BITS)


def _check(code: FormCode, secret: str, fingerprint: str) -> str:
    found = _digest("check", secret, code.worksheet, code.language, str(code.seed), fingerprint)
    return "".join(ALPHABET[byte & 31] for byte in found[:CHECKS])


# --- draws that are the same on every machine: SHA-256 in counter mode, no state but the seed
# `random` is not used: its sequence is promised for one version of Python only.


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
