"""Units in words, as siunitx has them, and written close together: metres per second squared, \\per\\second, ms^-1."""

from __future__ import annotations

import re

_STEPS = (
    (re.compile(r"\\(?:square)\s*\\([A-Za-z]+)"), r"\1^2"),
    (re.compile(r"\\(?:cubic)\s*\\([A-Za-z]+)"), r"\1^3"),
    (re.compile(r"\\squared(?![A-Za-z])"), "^2"),
    (re.compile(r"\\cubed(?![A-Za-z])"), "^3"),
    (re.compile(r"\\per(?![A-Za-z])"), "/"),
    (re.compile(r"\\(?=[A-Za-z])"), " "),
    (re.compile(r"\s*\b(?:per|por|entre)\b\s*"), "/"),
    (re.compile(r"\s+(?:squared|al cuadrado|cuadrados?)\b"), "^2"),
    (re.compile(r"\s+(?:cubed|al cubo|cúbicos?)\b"), "^3"),
    (re.compile(r"\bsquare\s+([A-Za-z]+)"), r"\1^2"),
    (re.compile(r"\bcubic\s+([A-Za-z]+)"), r"\1^3"),
    (re.compile(r"(?<![A-Za-z])ms(?=\s*(?:\^|\*\*)?\s*[({]?\s*[-−⁻])"), "m s"),  # of m/s, never one over milliseconds
    (re.compile(r"(?<=[A-Za-z])-(?=[A-Za-z])"), "·"),
    (re.compile(r"\["), "("),
    (re.compile(r"\]"), ")"),
)
PREFIXES = {"kilo": "k", "mega": "M", "giga": "G", "milli": "m", "mili": "m", "centi": "c", "deci": "d", "micro": "µ"}


def in_signs(text: str) -> str:
    """The unit with signs instead of words.

    >>> in_signs("meters per second squared")
    'meters/second^2'
    """
    for pattern, sign in _STEPS:
        text = pattern.sub(sign, text)
    return text


def unprefixed(word: str) -> tuple[str, str] | None:
    """(sign of the prefix, the rest) of kilonewton; None if it begins with no prefix."""
    return next(((sign, word[len(name) :]) for name, sign in PREFIXES.items() if word.lower().startswith(name)), None)
