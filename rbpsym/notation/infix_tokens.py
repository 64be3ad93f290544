"""Typed text -> tokens: names, numbers, operators, as people type them (θ, ω₁, ½, ², ×, √, −).

Invisible and look-alike characters are refused by name.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError
from rbpsym.notation.letters import names_of_letter

MAX_LENGTH, MAX_DIGITS = 2000, 30

OPERATORS: Mapping[str, str] = MappingProxyType({
    "+": "+", "-": "-", "−": "-", "–": "-", "*": "*", "×": "*", "·": "*", "⋅": "*", "∙": "*",
    "∗": "*", "/": "/", "÷": "/", "∕": "/", "⁄": "/", "^": "^", "**": "^", "(": "(", ")": ")",
    "[": "(", "]": ")", ",": ",", "√": "√", "|": "|", "=": "=", "==": "=", "<": "<", ">": ">",
    "<=": "<=", ">=": ">=", "≤": "<=", "≥": ">=", "⩽": "<=", "⩾": ">=", "!=": "!=", "≠": "!=",
    "≈": "~",
})  # fmt: skip
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵪ", "0123456789aehijklmnoprstuvxβγρχ")
_DOTS = {"\u0307": "dot", "\u0308": "ddot", "\u20db": "dddot"}

_PATTERNS = re.compile(
    r"(?P<blank>\s+)"
    r"|(?P<number>\d+(?:\.\d+)?|\.\d+)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<raised>[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<operator>\*\*|<=|>=|==|!=|.)",
    re.ASCII | re.DOTALL,
)
_TAIL = re.compile(r"[₀-₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵪ]*(?:_[A-Za-z0-9]+)*")


@dataclass(frozen=True, slots=True)
class Token:
    """A token: `kind` is number, name, raised (², as an integer), operator or end.

    `names` are the names that a typed letter may stand for; `spaced` says if a blank was before.
    """

    kind: str
    text: str
    start: int
    end: int
    value: Fraction | None = None
    names: tuple[str, ...] = ()
    spaced: bool = False


@dataclass(frozen=True, slots=True)
class Source:
    """The text being read and the place in a file where it begins."""

    text: str
    place: Place | None = None

    def at(self, start: int, end: int) -> Place:
        """The place of the characters from `start` to `end`, with a caret under them."""
        width = max(end - start, 1)
        if self.place and self.place.text:
            column = max(self.place.column, 1) + start
            return Place(self.place.file, self.place.line, column, self.place.text, width)
        before = self.text[:start]
        line = before.count("\n")
        column = start - (before.rfind("\n") + 1) + 1
        shown = self.text.split("\n")[line][:200] if column < 200 else ""
        base = self.place or Place()
        return Place(base.file, base.line + line if base.line else line and line + 1, column,
                     shown, width)  # fmt: skip

    def error(self, what: str, start: int, end: int, instead: str = "") -> RbpsymError:
        """A ReadError with the place of the characters from `start` to `end`."""
        return ReadError(what, instead=instead, place=self.at(start, end))

    def limit(self, what: str, start: int = 0, end: int = 1) -> RbpsymError:
        """A LimitError at a place."""
        return LimitError(what, place=self.at(start, end))


def tokenize(source: Source) -> tuple[Token, ...]:
    """The tokens of a text, with an end token. Raises ReadError, LimitError."""
    if len(source.text) > MAX_LENGTH:
        what = f"the expression has {len(source.text)} characters; at most {MAX_LENGTH} are read"
        raise LimitError(what, instead="Split it into smaller parts.")
    return tuple(_tokens(source))


def _tokens(source: Source) -> Iterator[Token]:
    position, spaced = 0, False
    while position < len(source.text):
        found = _PATTERNS.match(source.text, position)
        kind = found.lastgroup if found else "operator"
        if kind == "blank" or source.text[position].isspace():
            position, spaced = (found.end() if kind == "blank" else position + 1), True
            continue
        token = _READERS[kind](source, found, spaced)
        yield token
        position, spaced = token.end, False
    yield Token("end", "", len(source.text), len(source.text))


def _number(source: Source, found: re.Match[str], spaced: bool) -> Token:
    text, (start, end) = found[0], found.span()
    if len(text) > MAX_DIGITS:
        what = f"a number of {len(text)} digits; at most {MAX_DIGITS} are read"
        raise source.limit(what, start, end)
    return Token("number", text, start, end, Fraction(text), spaced=spaced)


def _name(source: Source, found: re.Match[str], spaced: bool) -> Token:
    start = found.start()
    word, end = found[0], found.end()
    if word.startswith("_") or word.endswith("__"):
        raise source.error(
            f"“{word}” is not a name: names begin with a letter", start, end,
            "Use the symbols of the problem.",
        )  # fmt: skip
    return _with_tail(source, (word,), start, end, spaced)


def _with_tail(
    source: Source, names: tuple[str, ...], start: int, end: int, spaced: bool
) -> Token:
    """A name with the dots and subscripts typed after it: θ̈₁ is theta_1_ddot."""
    dots = ""
    while end < len(source.text) and source.text[end] in _DOTS:
        dots += "_" + _DOTS[source.text[end]]
        end += 1
    tail = _TAIL.match(source.text, end)
    written = tail[0] if tail else ""
    small = re.match(r"[^_]*", written)[0]
    label = "_" + small.translate(_SUBSCRIPTS) if small else ""
    suffix = label + written[len(small):] + dots.replace("_dot_dot", "_ddot")
    end = tail.end() if tail else end
    text = source.text[start:end]
    return Token("name", text, start, end, names=tuple(n + suffix for n in names), spaced=spaced)


def _raised(source: Source, found: re.Match[str], spaced: bool) -> Token:
    start, end = found.span()
    if end - start > 4:
        raise source.limit("the exponent is too large; at most 64 is read", start, end)
    value = Fraction(found[0].translate(_SUPERSCRIPTS))
    return Token("raised", found[0], start, end, value, spaced=spaced)


def _sign(source: Source, found: re.Match[str], spaced: bool) -> Token:
    text, (start, end) = found[0], found.span()
    if text in OPERATORS:
        return Token("operator", OPERATORS[text], start, end, spaced=spaced)
    return _character(source, text, start, spaced)


def _character(source: Source, char: str, start: int, spaced: bool) -> Token:
    """A single character that is no operator: a letter, ½, ẋ. Raises ReadError for others."""
    names = names_of_letter(char)
    if names:
        return _with_tail(source, names, start, start + 1, spaced)
    parts = unicodedata.normalize("NFKD", char)
    if "⁄" in parts and unicodedata.category(char) == "No":
        value = Fraction(parts.replace("⁄", "/"))
        return Token("number", char, start, start + 1, value, spaced=spaced)
    return _dotted(source, char, start, spaced)


def _dotted(source: Source, char: str, start: int, spaced: bool) -> Token:
    """A letter that carries its dots, such as ẋ. Raises ReadError for any other character."""
    base, *marks = unicodedata.normalize("NFD", char)
    if marks and base.isascii() and all(mark in _DOTS for mark in marks):
        token = _with_tail(source, (base,), start, start + 1, spaced)
        names = tuple(name + "_" + _DOTS[marks[0]] for name in token.names)
        return Token("name", token.text, start, token.end, names=names, spaced=spaced)
    raise refused(source, char, start)


def refused(source: Source, char: str, start: int) -> RbpsymError:
    """The error for a character that can't be read, by its name."""
    code = f"U+{ord(char):04X}"
    name = unicodedata.name(char, "control character").lower()
    if unicodedata.category(char) in ("Cf", "Cc", "Mn", "Co", "Cn"):
        what = f"an invisible character stands here: {name} ({code})"
        return source.error(what, start, start + 1, "Delete it and type the expression again.")
    likeness = unicodedata.normalize("NFKC", char)
    hint = f"Type “{likeness}” instead." if likeness != char and likeness.isascii() else ""
    what = f"the character “{char}” ({name}, {code}) can't be read"
    return source.error(what, start, start + 1, hint or "Use plain letters and Greek letters.")


_READERS = MappingProxyType({
    "number": _number, "name": _name, "raised": _raised, "operator": _sign,
})  # fmt: skip
