"""Integrals as one types them: ∫_{a}^{b} f dθ, Integral(f, (θ, a, b)), integrate(f, θ, a, b), int(f, θ=a..b)."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from rbpsym.errors import ReadError
from rbpsym.notation import tree as t
from rbpsym.teaching.grading.book import Book
from rbpsym.teaching.grading.dialects import arguments_from
from rbpsym.teaching.grading.words import WORD, lookup

HELD = "integral_0"  # the name that holds the place of an integral in the formula around
_CALL = re.compile(r"(?<![A-Za-z\\])(?:Integral|[Ii]ntegrate|int)\s*[(\[]")
_LIMIT = r"\s*(?:\{([^{}]*)\}|\(([^()]*)\)|(-?[^\s^_{}()+*/-]+))\s*"
_SIGN = re.compile(rf"∫\s*_{_LIMIT}\^{_LIMIT}(.*?)d\s*({WORD.pattern})(?=\s*(?:$|[-+)\],=*/]))", re.DOTALL)


def with_integral(text: str, book: Book, read: Callable[[str, Book], t.Node]) -> t.Node | None:
    """The tree of a text that holds a typed integral, each part of it read by `read`; None if it holds none.

    Raises ReadError for one without limits, or over what is no quantity of the problem.
    """
    call, sign = _CALL.search(text), _SIGN.search(text)
    if call is None and "∫" not in text:
        return None
    parts, end = _of_call(text, call) if call else _of_sign(sign)
    if len(parts) != 4 or (variable := lookup(parts[1].strip(), book)) is None:
        raise ReadError("this integral can't be read", instead="Write Integral(f, theta, a, b): of f, from a to b.")
    integrand, lower, upper = (read(parts[k], book) for k in (0, 2, 3))
    whole = t.Integral(integrand, variable, lower, upper)
    begin = (call or sign).start()
    rest = read(f"{text[:begin]} {HELD} {text[end:]}", replace(book, names=book.names | {HELD}))
    return _filled(rest, whole)


def _of_call(text: str, call: re.Match[str]) -> tuple[list[str], int]:
    """(integrand, variable, lower and upper limit, where the call ends) of Integral(f, ...)."""
    parts, end = arguments_from(text.translate(str.maketrans("{}", "()")), call.end()) or ([], len(text))
    bare = ", ".join(part.strip().strip("()") for part in parts[1:])
    return [*parts[:1], *re.split(r",|=|\.\.", bare)], end


def _of_sign(sign: re.Match[str] | None) -> tuple[list[str], int]:
    if sign is None:
        return [], 0
    lower, upper = (next(filter(None, sign.groups()[k : k + 3]), "") for k in (0, 3))
    return [sign[7], sign[8], lower, upper], sign.end()


def _filled(node: t.Node, whole: t.Node) -> t.Node:
    return whole if node == t.Sym(HELD) else t.mapped(node, lambda part: _filled(part, whole))
