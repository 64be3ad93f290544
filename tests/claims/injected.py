"""Errors of one token put into printed formulas by their text alone: nothing here knows what a diagnosis tries."""

from __future__ import annotations

import re
from collections.abc import Iterator

_LETTER = re.compile(
    r"(?<![\\A-Za-z_{])(?:[A-Za-z](?:_\w)?|\\(?:theta|omega|ell|alpha|phi)(?![a-z]))(?![A-Za-z{])"
)
CHANGES = {
    "sign": (re.compile(r"[+-]"), lambda found: "-" if found == "+" else "+"),
    "number": (re.compile(r"\d"), lambda found: str(int(found) % 8 + 2)),
    "function": (re.compile(r"\\(?:sin|cos)(?![a-z])"), lambda found: r"\cos" if found == r"\sin" else r"\sin"),
    "power": (re.compile(r"\^2"), lambda found: ""),
    "dot": (re.compile(r"\\dot(?![a-z])"), lambda found: ""),
    "lost": (_LETTER, lambda found: ""),
}


def injected(latex: str, letters: list[str]) -> Iterator[tuple[str, str]]:
    """(kind, formula) of every error of one token; `letters` are the symbols that may stand for another."""
    for kind, (pattern, change) in CHANGES.items():
        for found in pattern.finditer(latex):
            yield kind, f"{latex[: found.start()]}{change(found[0])}{latex[found.end() :]}"
    for found in _LETTER.finditer(latex):
        for letter in letters:
            if letter != found[0]:
                yield "letter", f"{latex[: found.start()]}{letter} {latex[found.end() :]}"
