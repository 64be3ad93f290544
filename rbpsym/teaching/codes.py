"""Form codes: the few characters on a paper from which its numbers, tasks and key are made again.

A variant's seed is the first 60 bits of SHA-256(secret, worksheet, student). The code holds the seed
masked by the secret, and two check characters that depend on the seed, the secret and the
worksheet's text: who does not know the secret can't rebuild a key, and a mistyped code, a wrong secret or
a file that was changed meanwhile is noticed.
"""

from __future__ import annotations

from dataclasses import dataclass
from hashlib import sha256

from rbpsym.errors import RbpsymError

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # Crockford's: no I, L, O, U
READ_AS = str.maketrans("ILO", "110")
BITS, LETTERS, CHECKS = 60, 12, 2


@dataclass(frozen=True, slots=True)
class FormCode:
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
        raise RbpsymError(
            f"“{text}” is no form code",
            instead="a code looks like ladder.en.7K3F-9QTM-2CAB-4D: worksheet, language, four groups.",
        )
    return parts[0], parts[1]


def read(text: str, secret: str, fingerprint: str) -> FormCode:
    """The code that was printed. Raises RbpsymError if it is mistyped, or the secret or the file is another."""
    worksheet, language = name_in(text)
    letters = text.strip().rsplit(".", 1)[1].upper().translate(READ_AS).replace("-", "")
    for letter in letters:
        if letter not in ALPHABET:
            raise RbpsymError(f"“{letter}” can't stand in a form code", instead=f"its characters are {ALPHABET}.")
    if len(letters) != LETTERS + CHECKS:
        raise RbpsymError(
            f"the form code has {len(letters)} characters instead of {LETTERS + CHECKS} after the language",
            instead="copy it whole from the foot of the paper.",
        )
    masked = sum(ALPHABET.index(letter) << shift for letter, shift in _places(letters))
    bare = FormCode(worksheet, language, 0)
    code = FormCode(worksheet, language, masked ^ _mask(bare, secret))
    if _check(code, secret, fingerprint) != letters[LETTERS:]:
        raise RbpsymError(
            f"the form code “{text}” does not fit: it is mistyped, or the secret or the worksheet's file is another",
            instead="check the characters; give the --seed with which the papers were made, and the same file.",
        )
    return code


def _places(letters: str) -> list[tuple[str, int]]:
    return list(zip(letters[:LETTERS], range(BITS - 5, -1, -5), strict=True))


def _mask(code: FormCode, secret: str) -> int:
    return int.from_bytes(_digest("mask", secret, code.worksheet, code.language)[:8], "big") >> (64 - BITS)


def _check(code: FormCode, secret: str, fingerprint: str) -> str:
    found = _digest("check", secret, code.worksheet, code.language, str(code.seed), fingerprint)
    return "".join(ALPHABET[byte & 31] for byte in found[:CHECKS])
