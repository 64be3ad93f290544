"""What students type, made ready for the readers: one small rewriting after the other.

Nothing is dropped: a character that no rule knows stays, and the reader refuses it with a caret.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from types import MappingProxyType

from rbpsym.errors import LimitError, Place
from rbpsym.notation.infix_names import MAX_LENGTH
from rbpsym.teaching.grading import dialects as d
from rbpsym.teaching.grading.dialects import NUMBER, is_label
from rbpsym.teaching.grading.ground import Book
from rbpsym.teaching.grading.words import GREEK, dotted, lookup, spelled

_FRAMES = (("$$", "$$"), ("$", "$"), (r"\(", r"\)"), (r"\[", r"\]"), ("`", "`"))
_LATEX = re.compile(r"\\[A-Za-z,;!:> ]")
# typed signs for which the readers know another
_SIGNS = MappingProxyType({
    "’": "'", "′": "'", "‘": "'", "´": "'", "″": "''", "\u00a0": " ", "＝": "=", "∙": "*", "•": "*",
    "º": "°", "˚": "°", "∛": " cbrt ", "{": "(", "}": ")", "⟦": "(", "⟧": ")",
})  # fmt: skip


def checked_length(text: str) -> str:
    """The text, if it is short enough to be read. Raises LimitError."""
    if len(text) > MAX_LENGTH:
        what = f"the answer has {len(text)} characters; at most {MAX_LENGTH} are read"
        raise LimitError(what, instead="Enter the result alone.", place=Place(text=text[:60], column=1))
    return text


def unframed(text: str) -> str:
    """The text without the marks of a formula ($ … $), a sign = before it, and a full stop after it."""
    text = text.strip().replace("{,}", ",")
    for opening, closing in _FRAMES:
        if text.startswith(opening) and text.endswith(closing) and len(text) > len(opening) + len(closing):
            text = text[len(opening) : -len(closing)].strip()
    return re.sub(r"\s*[.;,]$", "", re.sub(r"^=(?![=>])\s*", "", text))


_LABEL = re.compile(rf"(\\?[A-Za-z{GREEK}][A-Za-z0-9_{GREEK}]*(?:_\{{\w+\}})?'*)\s*[=≈]\s*(?![=>])(?=\S)")


def unlabelled(text: str, book: Book) -> str:
    """The text without a name before a sign = that the problem does not have: T = 2π√(ℓ/g)."""
    found = _LABEL.match(text)
    if found is None:
        return text
    word = re.sub(r"[\\{}]", "", found[1])
    alone = is_label(word, book) and spelled(word, book) == word and text.count("=") <= 1
    return text[found.end() :] if alone else text


def is_latex(text: str) -> bool:
    """Is the text typed in LaTeX?"""
    return bool(_LATEX.search(text))


def plain(text: str, book: Book) -> str:
    """Typed text in the grammar of `notation.infix`, with the names of the problem."""
    for step in STEPS:
        text = step(text, book)
    return text


def with_decimal_points(text: str, language: str) -> str:
    """Numbers with a decimal point: 3,5 is 3.5; 1,250 is 1250 in English, 1.250 in Spanish."""
    if language == "en":
        text = re.sub(r"(?<![\d.,])([1-9]\d{0,2}(?:,\d{3})+)(?![\d,])", lambda f: f[0].replace(",", ""), text)
    return re.sub(r"(?<=\d),(?=\d)", ".", text)


def _signs(text: str, book: Book) -> str:
    return dotted("".join(_SIGNS.get(char, char) for char in text))


_CALL = re.compile(r"(?<!\w)[A-Za-z]\w*\s*\([^()]*\d,\d")


def _numbers(text: str, book: Book) -> str:
    if book.language != "en" or not _CALL.search(text):  # f(2,3) in English: two arguments, not 2.3
        text = with_decimal_points(text, book.language)
    text = re.sub(r"(?<=\d)\.(?![\d\w])", "", text)
    if "e" not in book.names:
        text = re.sub(rf"(?<![\w.])({NUMBER})[eE]([+\-−]?\d{{1,3}})(?![\w.])", r"(\1*10^(\2))", text)
    return text


def _constants(text: str, book: Book) -> str:
    return re.sub(r"%(pi|e)\b", r"\1", text)


_WORD = rf"[A-Za-z{GREEK}][A-Za-z0-9_{GREEK}]*"
_RATE = re.compile(
    rf"(?<![A-Za-z_])d\s*(\^\s*2|²)?\s*({_WORD})\s*/\s*(?:\(\s*d\s*t\s*(\^\s*2|²)?\s*\)|d\s*t\s*(\^\s*2|²)?)(?!\w)"
)


def _rates(text: str, book: Book) -> str:
    """dθ/dt and d²θ/dt² are the names of the rates."""

    def named(found: re.Match[str]) -> str:
        tail = {0: "_dot", 2: "_ddot"}.get(bool(found[1]) + bool(found[3] or found[4]))
        name = tail and lookup(found[2] + tail, book)
        return f" {name} " if name else found[0]

    return _RATE.sub(named, text) if "dt" not in book.names else text


def _times(text: str, book: Book) -> str:
    """θ(t) is θ where t is no name of its own."""
    if "t" in book.names:
        return text
    return re.sub(rf"(?<!\w)({_WORD}'*)\s*\(t\)", lambda f: f[1] if lookup(f[1], book) else f[0], text)


STEPS: tuple[Callable[[str, Book], str], ...] = (
    d.letters_of_mathematica, d.mixed_numbers, d.indices, _signs, _constants, d.small_letters, d.two_arguments,
    d.based_logarithms, _numbers,
    d.powers_of_ten, d.degrees, d.derivatives, _rates, _times, d.ratios, spelled, d.inverses,
)  # fmt: skip
