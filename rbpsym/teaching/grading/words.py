"""The words of a typed answer: `mgℓsinθ` is m g ℓ sin θ, if the problem has these names.

A word that is a name stays one. Another is cut into names, functions and numbers if that can be
done in one way with the fewest pieces; else it stays as it is, and the reader refuses it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from types import MappingProxyType

from rbpsym.errors import ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.hyperbolic import HYPERBOLIC
from rbpsym.expr.infix_names import FUNCTIONS
from rbpsym.expr.letters import LETTERS, SAME_LETTER, names_of_letter
from rbpsym.expr.limits import number_of
from rbpsym.teaching.grading.ground import Book

# --- trees that students write, in the words of the field: e^x, 2^x, hyperbolic functions, cube roots


Made = Callable[[t.Node], t.Node]


def _exp(node: t.Node) -> t.Node:
    return t.Fn("exp", node)


def _log10(node: t.Node) -> t.Node:
    return t.Div(t.Fn("ln", node), t.Fn("ln", t.Num(10)))


def _of_reciprocal(name: str) -> Made:
    return lambda node: t.Fn(name, t.Div(t.ONE, node))


MADE: Mapping[str, Made] = MappingProxyType({
    **FUNCTIONS, **HYPERBOLIC, "log10": _log10, "lg": _log10, "log_10": _log10, "root": t.Sqrt,
    "cbrt": lambda node: t.Pow(node, t.Div(t.ONE, t.Num(3))),
    "cotan": FUNCTIONS["cot"], "tangent": FUNCTIONS["tan"], "sine": FUNCTIONS["sin"], "cosine": FUNCTIONS["cos"],
    **dict.fromkeys(("asec", "arcsec"), _of_reciprocal("acos")), **dict.fromkeys(("acsc", "arccsc"), _of_reciprocal("asin")),
})  # fmt: skip
PLAIN = (t.Num, t.Sym, t.Add, t.Neg, t.Mul, t.Div, t.Pow, t.Sqrt, t.Fn, t.Abs, t.Group, t.Deriv, t.Chain, t.Integral)
EULER = "e"


def standard(node: t.Node, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    """The tree with names as the problem has them, e as a number, and powers as exponentials where they vary.

    Raises ReadError for what is no formula of an answer (a vector, an integral without limits, a word).
    """
    if not isinstance(node, PLAIN):
        raise ReadError("only numbers, symbols, roots and functions can be read here", instead="Enter the result.")
    if isinstance(node, t.Sym):
        return _name(node, typed, has_euler)
    inner = t.mapped(node, lambda part: standard(part, typed, has_euler))
    if isinstance(inner, t.Integral):
        return replace(inner, var=typed.get(inner.var, inner.var))
    return _power(inner) if isinstance(inner, t.Pow) else inner


def _name(node: t.Sym, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    if has_euler and node.name == EULER:
        return t.Fn("exp", t.ONE)
    return replace(node, name=typed.get(node.name, node.name))


def _power(node: t.Pow) -> t.Node:
    """e^x is exp(x), and a^x is exp(x ln a)."""
    if number_of(node.exponent) is not None:
        return node
    if node.base == t.Fn("exp", t.ONE):
        return _exp(node.exponent)
    return _exp(t.Mul((node.exponent, t.Fn("ln", node.base))))


# ---


CALLED = frozenset(MADE)
# names of functions that are not known here: never cut into symbols, so that max is not m a x
OTHER_FUNCTIONS = frozenset((
    "max", "min", "mod", "sign", "sgn", "floor", "ceil", "round", "diff", "int", "integrate", "lim", "limit", "sum", "prod",
    "atan2", "arctan2", "asec", "acsc", "acot", "arcsec", "arccsc", "arccot", "arg", "erf", "fact", "factorial", "pow", "exp2",
    "log2", "deriv", "solve", "simplify", "expand", "factor", "eval", "exec", "import", "print", "lambda", "matrix", "vector",
    "and", "or", "not", "if", "else", "true", "false", "inf", "nan",
))  # fmt: skip
GREEK = "".join((*LETTERS.values(), *SAME_LETTER))
SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵪ"
_PLAIN = str.maketrans(SUBSCRIPTS, "0123456789aehijklmnoprstuvxβγρχ")
_DOTS = {"\u0307": "_dot", "\u0308": "_ddot"}
_MARKS = "\u0307\u0308"
_RATES = {"'": "_dot", "''": "_ddot"}
LONGEST = 80  # letters of a word that is cut into names

WORD = re.compile(rf"[A-Za-z{GREEK}][A-Za-z0-9_{GREEK}{SUBSCRIPTS}{_MARKS}]*'*")
_CHUNK = re.compile(
    rf"[{GREEK}][{_MARKS}]*[{SUBSCRIPTS}]*\d*(?:_[A-Za-z0-9{GREEK}]+)*(?:dd?ot(?![a-z]))?'*"
    rf"|[A-Za-z][A-Za-z0-9]*?[{_MARKS}]+[{SUBSCRIPTS}]*(?:_[A-Za-z0-9{GREEK}]+)*"
    rf"|[A-Za-z][A-Za-z0-9]*[{SUBSCRIPTS}]*(?:_[A-Za-z0-9{GREEK}]+)*'*"
    r"|\d+|."
)


def dotted(text: str) -> str:
    """The text with letters that carry dots (ẋ) as letter and dots."""
    return "".join(_decomposed(char) for char in text)


def _decomposed(char: str) -> str:
    parts = unicodedata.normalize("NFD", char) if not char.isascii() else char
    return parts if len(parts) > 1 and all(mark in _DOTS for mark in parts[1:]) else char


def spelled(text: str, book: Book) -> str:
    """The text with each word as names of the problem, with blanks between the factors."""

    def replaced(found: re.Match[str]) -> str:
        return _spelled(found[0], book, raised=text[: found.start()].rstrip().endswith(("^", "**")))

    return WORD.sub(replaced, text)


def _spelled(word: str, book: Book, raised: bool) -> str:
    whole = lookup(word, book)
    if whole or word in CALLED or word.lower() in OTHER_FUNCTIONS:
        return whole or word
    pieces = [piece for chunk in _CHUNK.findall(word) for piece in _pieces(chunk, book)]
    return word if raised and len(pieces) > 1 else " ".join(pieces)


def _pieces(chunk: str, book: Book) -> list[str]:
    """A chunk as names, functions and numbers; itself if it can't be cut."""
    found = lookup(chunk, book)
    if found or chunk in CALLED or chunk.isdigit():
        return [found or chunk]
    return list(_cut(chunk, book)) or [chunk]


def lookup(word: str, book: Book) -> str | None:
    """The name that a word is, with its dots, primes and subscripts; None if it is none."""
    return next((name for way in _readings(word) if (name := book.named(way))), None)


@lru_cache(maxsize=4096)
def _readings(word: str) -> tuple[str, ...]:
    """How a word may be typed in plain letters, the likeliest first; of a long one each piece is looked up."""
    return tuple(_ways(word))


def _ways(word: str) -> Iterator[str]:
    primes = len(word) - len(word.rstrip("'"))
    rate = _RATES.get("'" * primes, "")
    stem = re.sub(f"[{_MARKS}]+", "", word[: len(word) - primes])
    marks = re.sub(f"[^{_MARKS}]", "", word)
    rate += {"": "", "\u0307": "_dot", "\u0308": "_ddot", "\u0307\u0307": "_ddot"}.get(marks, "_")
    for plain in _in_plain_letters(stem):
        yield plain + rate
        yield re.sub(r"(dd?ot)$", r"_\1", plain) + rate
        yield re.sub(r"(?<=[A-Za-z])(\d+)$", r"_\1", plain) + rate
        yield re.sub(r"_?[oO]$", "_0", plain) + rate  # θo is meant to be θ₀
        if primes == 1:
            yield plain + "_prime"


def _in_plain_letters(stem: str) -> Iterator[str]:
    """A word with Greek letters by their names and subscripts after an underscore."""
    stem = re.sub(f"[{SUBSCRIPTS}]+", lambda found: "_" + found[0].translate(_PLAIN), stem)
    texts = [""]
    for char in stem:
        options = names_of_letter(char) or (char,)
        texts = [text + option for text in texts for option in options][:16]
    yield from texts


def _cut(chunk: str, book: Book) -> tuple[str, ...]:
    """The one shortest way to cut a word; empty if there is none or more than one."""
    if len(chunk) > LONGEST or chunk.lower() in OTHER_FUNCTIONS:
        return ()
    best: list[tuple[int, set[tuple[str, ...]]]] = [(0, {()})]
    for end in range(1, len(chunk) + 1):
        ways: set[tuple[str, ...]] = set()
        for start in range(max(0, end - 16), end):
            piece = _piece(chunk[start:end], book)
            if piece and not (piece.isdigit() and start and chunk[start - 1].isdigit()):
                ways |= {(*before, piece) for before in best[start][1]}
        least = min(map(len, ways), default=0)
        best.append((least, set(sorted(way for way in ways if len(way) == least)[:4])))
    found = best[-1][1]
    return next(iter(found)) if len(found) == 1 else ()


def _piece(text: str, book: Book) -> str | None:
    if text in CALLED or text == "pi" or text.isdigit():
        return text
    return lookup(text, book)
