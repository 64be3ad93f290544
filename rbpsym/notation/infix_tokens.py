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

from rbpsym.errors import LimitError
from rbpsym.notation.letters import names_of_letter
from rbpsym.notation.source import Source, refused

MAX_LENGTH, MAX_DIGITS = 2000, 30

OPERATORS: Mapping[str, str] = MappingProxyType({
    "+": "+", "-": "-", "−": "-", "–": "-", "*": "*", "×": "*", "·": "*", "⋅": "*", "∙": "*",
    "∗": "*", "/": "/", "÷": "/", "∕": "/", "⁄": "/", "^": "^", "**": "^", "(": "(", ")": ")",
    "[": "(", "]": ")", ",": ",", "√": "√", "|": "|", "=": "=", "==": "=", "<": "<", ">": ">",
    "<=": "<=", ">=": ">=", "≤": "<=", "≥": ">=", "⩽": "<=", "⩾": ">=", "!=": "!=", "≠": "!=",
    "≈": "~", "~": "~",
})  # fmt: skip
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵪ", "0123456789aehijklmnoprstuvxβγρχ")
_DOTS = {"\u0307": "dot", "\u0308": "ddot", "\u20db": "dddot"}

_PATTERNS = re.compile(
    r"(?P<blank>\s+)"
    r"|(?P<number>\d+(?:\.\d+|,\d+(?![\d,.]))?|\.\d+)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<raised>[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<operator>\*\*|<=|>=|==|!=|.)",
    re.ASCII | re.DOTALL,
)
_TAIL = re.compile(r"[₀-₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵪ]*(?:_[A-Za-z0-9]+)*")
_DIGITS = re.compile(r"[0-9]+(?![0-9.,])")


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
    if "," in text:
        text = _with_point(source, text, start, end)
    if len(text) > MAX_DIGITS:
        what = f"a number of {len(text)} digits; at most {MAX_DIGITS} are read"
        raise source.limit(what, start, end)
    return Token("number", text, start, end, Fraction(text), spaced=spaced)


def _with_point(source: Source, text: str, start: int, end: int) -> str:
    """1,5 is 1.5; 1,500 may be a thousand and a half thousand. Raises ReadError."""
    if len(text.partition(",")[2]) == 3:
        raise source.error("is this comma a decimal mark, or does it group thousands?", start, end,
                           "Write a point, as in 1.500, or no mark, as in 1500.")  # fmt: skip
    return text.replace(",", ".")


def _name(source: Source, found: re.Match[str], spaced: bool) -> Token:
    start = found.start()
    word, end = found[0], found.end()
    if word.startswith("_") or "__" in word:
        raise source.error(
            f"“{word[:40]}” is not a name of a symbol", start, end,
            "Names have letters, digits and single underscores, as in theta_0.",
        )  # fmt: skip
    return _with_tail(source, (word,), start, end, spaced)


def _with_tail(source: Source, names: tuple[str, ...], start: int, end: int, spaced: bool) -> Token:
    """A name with the dots and subscripts typed after it: θ̈₁ is theta_1_ddot."""
    dots = ""
    while end < len(source.text) and source.text[end] in _DOTS:
        dots += "_" + _DOTS[source.text[end]]
        end += 1
    tail = _TAIL.match(source.text, end)
    written = tail[0] if tail else ""
    small = re.match(r"[^_]*", written)[0]
    label = "_" + small.translate(_SUBSCRIPTS) if small else ""
    suffix = label + written[len(small) :] + dots.replace("_dot_dot", "_ddot")
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
        return _greek(source, names, start, spaced)
    parts = unicodedata.normalize("NFKD", char)
    if "⁄" in parts and unicodedata.category(char) == "No":
        value = Fraction(parts.replace("⁄", "/"))
        return Token("number", char, start, start + 1, value, spaced=spaced)
    return _dotted(source, char, start, spaced)


def _greek(source: Source, names: tuple[str, ...], start: int, spaced: bool) -> Token:
    """A letter with its tail; θ0 is θ₀."""
    digits = _DIGITS.match(source.text, start + 1)
    if digits is None:
        return _with_tail(source, names, start, start + 1, spaced)
    text, end = source.text[start : digits.end()], digits.end()
    return Token("name", text, start, end, names=tuple(f"{n}_{digits[0]}" for n in names), spaced=spaced)


def _dotted(source: Source, char: str, start: int, spaced: bool) -> Token:
    """A letter that carries its dots, such as ẋ. Raises ReadError for any other character."""
    base, *marks = unicodedata.normalize("NFD", char)
    if marks and base.isascii() and all(mark in _DOTS for mark in marks):
        token = _with_tail(source, (base,), start, start + 1, spaced)
        names = tuple(name + "_" + _DOTS[marks[0]] for name in token.names)
        return Token("name", token.text, start, token.end, names=names, spaced=spaced)
    raise refused(source, char, start)


_READERS = MappingProxyType({
    "number": _number, "name": _name, "raised": _raised, "operator": _sign,
})  # fmt: skip
