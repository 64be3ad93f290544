"""The names in a typed formula: functions, symbols, the sentence for an unknown name; what can be read in two ways."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from difflib import get_close_matches
from fractions import Fraction
from functools import partial
from types import MappingProxyType
from typing import Any

from rbpsym.errors import LimitError, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.hyperbolic import CIRCULAR
from rbpsym.expr.letters import names_of_letter
from rbpsym.expr.source import Cursor, SourceText, refused
from rbpsym.frozen import Frozen, field, replace

MAX_LENGTH, MAX_DIGITS = 2000, 30

OPERATORS: Mapping[str, str] = {typed: sign for sign, others in {  # each as it may be typed
    "+": "+", "-": "- − –", "*": "* × · ⋅ ∙ ∗", "/": "/ ÷ ∕ ⁄", "^": "^ **", "(": "( [", ")": ") ]", ",": ",", "√": "√", "|": "|",
    "=": "= ==", "<": "<", ">": ">", "<=": "<= ≤ ⩽", ">=": ">= ≥ ⩾", "!=": "!= ≠", "~": "≈ ~",
}.items() for typed in others.split()}  # fmt: skip
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


class InfixToken(Frozen):
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


def tokenize(source: SourceText) -> tuple[InfixToken, ...]:
    """The tokens of a text, with an end token. Raises ReadError, LimitError."""
    if len(source.text) > MAX_LENGTH:
        what = f"the expression has {len(source.text)} characters; at most {MAX_LENGTH} are read"
        raise LimitError(what, instead="Split it into smaller parts.")
    return tuple(_tokens(source))


def _tokens(source: SourceText) -> Iterator[InfixToken]:
    position, spaced = 0, False
    while position < len(source.text):
        found = _PATTERNS.match(source.text, position)
        kind = found.lastgroup or "" if found else "operator"
        if kind == "blank" or source.text[position].isspace():
            position, spaced = (found.end() if found and kind == "blank" else position + 1), True
            continue
        token = _READERS[kind](source, found, spaced)
        yield token
        position, spaced = token.end, False
    yield InfixToken("end", "", len(source.text), len(source.text))


def _number(source: SourceText, found: re.Match[str], spaced: bool) -> InfixToken:
    text, (start, end) = found[0], found.span()
    if "," in text:
        text = _with_point(source, text, start, end)
    if len(text) > MAX_DIGITS:
        what = f"a number of {len(text)} digits; at most {MAX_DIGITS} are read"
        raise source.limit(what, start, end)
    return InfixToken("number", text, start, end, Fraction(text), spaced=spaced)


def _with_point(source: SourceText, text: str, start: int, end: int) -> str:
    """1,5 is 1.5; 1,500 may be a thousand and a half thousand. Raises ReadError."""
    if len(text.partition(",")[2]) == 3:
        raise source.error("is this comma a decimal mark, or does it group thousands?", start, end,
                           "Write a point, as in 1.500, or no mark, as in 1500.")  # fmt: skip
    return text.replace(",", ".")


def _name(source: SourceText, found: re.Match[str], spaced: bool) -> InfixToken:
    start = found.start()
    word, end = found[0], found.end()
    if word.startswith("_") or "__" in word:
        raise source.error(
            f"“{word[:40]}” is not a name of a symbol", start, end,
            "Names have letters, digits and single underscores, as in theta_0.",
        )  # fmt: skip
    return _with_tail(source, (word,), start, end, spaced)


def _with_tail(source: SourceText, names: tuple[str, ...], start: int, end: int, spaced: bool) -> InfixToken:
    """A name with the dots and subscripts typed after it: θ̈₁ is theta_1_ddot."""
    dots = ""
    while end < len(source.text) and source.text[end] in _DOTS:
        dots += "_" + _DOTS[source.text[end]]
        end += 1
    tail = _TAIL.match(source.text, end)
    written = tail[0] if tail else ""
    small = written.partition("_")[0]
    label = "_" + small.translate(_SUBSCRIPTS) if small else ""
    suffix = label + written[len(small) :] + dots.replace("_dot_dot", "_ddot")
    end = tail.end() if tail else end
    text = source.text[start:end]
    return InfixToken("name", text, start, end, names=tuple(n + suffix for n in names), spaced=spaced)


def _raised(source: SourceText, found: re.Match[str], spaced: bool) -> InfixToken:
    start, end = found.span()
    if end - start > 4:
        raise source.limit("the exponent is too large; at most 64 is read", start, end)
    value = Fraction(found[0].translate(_SUPERSCRIPTS))
    return InfixToken("raised", found[0], start, end, value, spaced=spaced)


def _sign(source: SourceText, found: re.Match[str], spaced: bool) -> InfixToken:
    text, (start, end) = found[0], found.span()
    if text in OPERATORS:
        return InfixToken("operator", OPERATORS[text], start, end, spaced=spaced)
    return _character(source, text, start, spaced)


def _character(source: SourceText, char: str, start: int, spaced: bool) -> InfixToken:
    """A single character that is no operator: a letter, ½, ẋ. Raises ReadError for others."""
    names = names_of_letter(char)
    if names:
        return _greek(source, names, start, spaced)
    parts = unicodedata.normalize("NFKD", char)
    if "⁄" in parts and unicodedata.category(char) == "No":
        value = Fraction(parts.replace("⁄", "/"))
        return InfixToken("number", char, start, start + 1, value, spaced=spaced)
    return _dotted(source, char, start, spaced)


def _greek(source: SourceText, names: tuple[str, ...], start: int, spaced: bool) -> InfixToken:
    """A letter with its tail; θ0 is θ₀."""
    digits = _DIGITS.match(source.text, start + 1)
    if digits is None:
        return _with_tail(source, names, start, start + 1, spaced)
    text, end = source.text[start : digits.end()], digits.end()
    return InfixToken("name", text, start, end, names=tuple(f"{n}_{digits[0]}" for n in names), spaced=spaced)


def _dotted(source: SourceText, char: str, start: int, spaced: bool) -> InfixToken:
    """A letter that carries its dots, such as ẋ. Raises ReadError for any other character."""
    base, *marks = list(unicodedata.normalize("NFD", char))
    if marks and base.isascii() and all(mark in _DOTS for mark in marks):
        token = _with_tail(source, (base,), start, start + 1, spaced)
        names = tuple(name + "_" + _DOTS[marks[0]] for name in token.names)
        return InfixToken("name", token.text, start, token.end, names=names, spaced=spaced)
    raise refused(source, char, start)


_READERS: Mapping[str, Callable[[SourceText, Any, bool], InfixToken]] = MappingProxyType({
    "number": _number, "name": _name, "raised": _raised, "operator": _sign,
})  # fmt: skip


FUNCTIONS: Mapping[str, Callable[[t.Node], t.Node]] = MappingProxyType({
    **{word: partial(t.Fn, name) for word, name in CIRCULAR.items()}, "sqrt": t.Sqrt, "abs": t.Abs,
    **{name: partial(t.Fn, name) for name in ("asin", "acos", "atan", "elliptic_k", "elliptic_e")},
})  # fmt: skip


class InfixReader(Cursor[InfixToken]):
    """A cursor with the symbols, functions and aliases of a problem.

    `script` says what to choose at the places that can be read in two ways (False behind its end; None: the usual
    reading where there is one, else refuse them), `met` their errors, `parted` what was chosen where this changes what
    is multiplied and what divided. `plain`: no other than the usual reading, where there is one. `bars`: a | would close.
    """

    symbols: frozenset[str] = frozenset()
    functions: Mapping[str, Callable[[t.Node], t.Node]] = field(default_factory=lambda: FUNCTIONS)
    aliases: Mapping[str, str] = field(default_factory=dict)
    script: tuple[bool, ...] | None = None
    met: list[RbpsymError] = field(default_factory=list)
    parted: tuple[bool, ...] = ()
    plain: bool = False
    bars: bool = False

    def decide(self, what: str, instead: str, *, changes_value: bool = False, usual: bool = False) -> bool:
        """Which of two readings to take at the next token; `usual`: the first is what one writes. Raises ReadError."""
        error = self.error(what, instead)
        if usual and (self.script is None or self.plain):
            return False
        if self.script is None:
            raise error
        chosen = len(self.met) < len(self.script) and self.script[len(self.met)]
        self.met.append(error)
        self.parted += (chosen,) if changes_value else ()
        return chosen


def symbol_named(token: InfixToken, reader: InfixReader) -> str | None:
    """The symbol of the problem that a token names, by its own name or an alias."""
    spellings = (*token.names, *(name.replace("_", "") for name in token.names if name != token.text), *_spread(token))
    names = [reader.aliases.get(name, name) for name in spellings]
    return next((name for name in names if name in reader.symbols), None)


def _spread(token: InfixToken) -> tuple[str, ...]:
    """v0 and theta0 may also be v_0 and theta_0."""
    return tuple(f"{found[1]}_{found[2]}" for name in token.names if (found := _NUMBERED.fullmatch(name)))


_NUMBERED = re.compile(r"([A-Za-z]+)(\d+)")


def function_named(token: InfixToken, reader: InfixReader) -> str | None:
    """The function that a name calls, its aliases included; None if it is no function."""
    found = token.kind == "name" and token.text in reader.functions
    return token.text if found and token.text not in reader.symbols else None


def unknown(token: InfixToken, reader: InfixReader) -> RbpsymError:
    """The error for a name that the problem doesn't have."""
    known = sorted(reader.symbols | set(reader.aliases))
    pieces = _pieces(token.names[0], reader.symbols)
    near = get_close_matches(token.names[0], [*known, *(word for word in reader.functions if len(word) > 2)], n=1)
    hint = "The symbols are: " + ", ".join(known) + "."
    if near:
        hint = f"Did you mean “{near[0]}”?"
    if pieces:
        hint = f"If a product is meant, write {'*'.join(pieces)}."
    numbered = _NUMBERED.fullmatch(token.text)
    if numbered and numbered[1] in reader.functions:
        hint = f"Write {numbered[1]}({numbered[2]}*x), or {numbered[1]}(x)^{numbered[2]}."
    elif numbered and numbered[1] in ("e", "E") and reader.position > 1:
        hint = f"Write 10^{numbered[2]} for a power of ten."
    shown = token.text if len(token.text) <= 40 else token.text[:40] + "…"
    return reader.error(f"unknown symbol “{shown}”", hint, token)


def _pieces(word: str, symbols: frozenset[str]) -> list[str]:
    """The symbols that a word is made of (mgell: m, g, ell); empty if it isn't."""
    found: dict[int, list[str]] = {0: []}
    for end in range(1, min(len(word), 40) + 1):
        for start in range(end):
            if start in found and word[start:end] in symbols:
                found[end] = [*found[start], word[start:end]]
                break
    return found.get(len(word), [])


def stands_apart(reader: InfixReader) -> bool:
    """Does a function follow, or a parenthesis behind a blank, which one hardly takes for a part of a denominator?"""
    return is_call(reader) or (reader.sees("(") and reader.token.spaced)


def is_settled(node: t.Div, reader: InfixReader) -> bool:
    """Was the quotient, or what stands below its bar, written in parentheses?"""
    text, (start, end) = reader.source.text, node.den.span or (0, 0)
    below = text[:start].rstrip().endswith(("(", "[")) and text[end:].lstrip().startswith((")", "]"))
    return below or (node.span is not None and text[node.span[1] :].lstrip().startswith((")", "]")))


def is_bare_call(node: t.Node, reader: InfixReader) -> bool:
    """Does the node end with a function whose argument has no parentheses?"""
    if isinstance(node, (t.Mul, t.Neg)):
        return is_bare_call(node.factors[-1] if isinstance(node, t.Mul) else node.arg, reader)
    node, end = (node.base, node.base.span) if isinstance(node, t.Pow) else (node, None)
    text = reader.source.text[: end[1] if end else reader.previous_end].rstrip()
    return isinstance(node, t.Fn) and not text.endswith((")", "]", "|"))


def in_last_argument(node: Any, change: Callable[[t.Node], t.Node]) -> t.Node:
    """The node with the argument of the function changed that it ends with."""
    if isinstance(node, t.Mul):
        return replace(node, factors=(*node.factors[:-1], in_last_argument(node.factors[-1], change)))
    if isinstance(node, t.Pow):
        return replace(node, base=in_last_argument(node.base, change))
    if isinstance(node, t.Neg):
        return replace(node, arg=in_last_argument(node.arg, change))
    changed: t.Node = replace(node, arg=change(node.arg))
    return changed


def is_call(reader: InfixReader) -> bool:
    """Does the name of a function follow?"""
    return function_named(reader.token, reader) is not None
