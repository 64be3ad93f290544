"""Errors of one token put into printed formulas by their text alone: nothing here knows what a diagnosis tries."""

from __future__ import annotations

import re
from collections.abc import Iterator

_LETTER = re.compile(r"(?<![\\A-Za-z_{])(?:[A-Za-z](?:_\w)?|\\(?:theta|omega|ell|alpha|phi)(?![a-z]))(?![A-Za-z{])")
CHANGES = {
    "sign": (re.compile(r"[+-]"), lambda found: "-" if found == "+" else "+"),
    "number": (re.compile(r"\d"), lambda found: str(int(found) % 8 + 2)),
    "function": (re.compile(r"\\(?:sin|cos)(?![a-z])"), lambda found: r"\cos" if found == r"\sin" else r"\sin"),
    "power": (re.compile(r"\^2"), lambda found: ""),
    "dot": (re.compile(r"\\dot(?![a-z])"), lambda found: ""),
    "lost": (_LETTER, lambda found: ""),
    "index": (
        re.compile(r"(?<=_)[A-Za-z\d]|(?<=_\{)[A-Za-z\d](?=\})"),
        lambda found: str(int(found) + 1) if found.isdigit() else "2",
    ),
    "swapped": (re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}"), lambda found: _turned(found)),
}


def _turned(quotient: str) -> str:
    above, below = re.findall(r"\{([^{}]*)\}", quotient)
    return rf"\frac{{{below}}}{{{above}}}"


def _terms(latex: str) -> Iterator[tuple[int, int]]:
    """From where to where a term stands with the sign in front of it, in whatever braces and parentheses."""
    for sign in re.finditer(r"(?<![=(\[{^&\s])\s*[+-]", latex):
        depth, end = 0, sign.end()
        while end < len(latex):
            depth += (latex[end] in "{([") - (latex[end] in "})]")
            if depth < 0 or (depth == 0 and (latex[end] in "+-=<>&.,;" or latex.startswith(r"\\", end))):
                break
            end += 1
        if latex[sign.end() : end].strip():
            yield sign.start(), end


def injected(latex: str, letters: list[str]) -> Iterator[tuple[str, str]]:
    """(kind, formula) of every error of one token; `letters` are the symbols that may stand for another."""
    for kind, (pattern, change) in CHANGES.items():
        for found in pattern.finditer(latex):
            yield kind, f"{latex[: found.start()]}{change(found[0])}{latex[found.end() :]}"
    for begin, end in _terms(latex):
        yield "term", latex[:begin] + " " + latex[end:]
    for found in _LETTER.finditer(latex):
        for letter in letters:
            if letter != found[0]:
                yield "letter", f"{latex[: found.start()]}{letter} {latex[found.end() :]}"


def rewritten(latex: str, letters: list[str]) -> Iterator[str]:
    """The same equation said otherwise: turned, multiplied, with something added on both sides, with a double angle."""
    left, sign, right = (part.strip(" .,;&\n") for part in latex.partition("="))
    if not sign or re.search(r"=|\\\\|&|\\q?quad|\\text|\\(?:approx|to|[lg]eq?)(?![a-z])|[<>;,]|\\begin", f"{left} {right}"):
        return
    yield f"{right} = {left}"
    yield rf"7\left({left}\right) = 7\left({right}\right)"
    yield rf"\frac{{{left}}}{{5}} - \frac{{{right}}}{{5}} = 0"
    for found in re.finditer(r"\\cos\s*(\\[a-z]+)(?![a-z^_'({])", latex):
        yield rf"{latex[: found.start()]}\left(1 - 2\sin^2\frac{{{found[1]}}}{{2}}\right){latex[found.end() :]}"
