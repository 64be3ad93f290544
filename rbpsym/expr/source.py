"""The text that is read, with its place in a file (errors with a caret), and a place in a row of its tokens."""

from __future__ import annotations

import re
import sys
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Generic, Protocol, TypeVar

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.limits import check_degree, check_exponent, check_size
from rbpsym.frozen import Frozen, Walker, replace

N = TypeVar("N", bound=t.Node)


class SourceText(Frozen):
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
        return Place(base.file, max(base.line, 1) + line, column, shown, min(width, 200))

    def error(self, what: str, start: int, end: int, instead: str = "", kind: type[ReadError] = ReadError) -> RbpsymError:
        """A ReadError with the place of the characters from `start` to `end`."""
        return kind(what, instead=instead, place=self.at(start, end))

    def limit(self, what: str, start: int = 0, end: int = 1) -> RbpsymError:
        """A LimitError at a place."""
        return LimitError(what, place=self.at(start, end))

    def bounded(self, node: N, end: int = 1) -> N:
        """A tree read from the text, if it keeps the bounds. Raises LimitError at the text up to `end`."""
        try:
            check_size(node)
            check_degree(node)
        except LimitError as error:
            raise error.at(self.at(0, end)) from None
        return node


_LIKE = {"‐": "-", "‑": "-", "‒": "-", "—": "-", "―": "-", "⁃": "-", "﹣": "-", "ꞏ": "*", "•": "*", "⸱": "*", "∣": "|"}
_INSTEAD = {
    "°": "Angles are in radians: 30° is pi/6.", "{": "Use parentheses.", "}": "Use parentheses.",
    "%": "Write a fraction, as in 3/100.",
    "\\": "This looks like LaTeX; write names and signs as on a keyboard: theta, sqrt(x), a/b.",
    "'": "A derivative is written with its name: the speed of theta is theta_dot.",
}  # fmt: skip


def refused(source: SourceText, char: str, start: int) -> RbpsymError:
    """The error for a character that can't be read, by its name."""
    code = f"U+{ord(char):04X}"
    name = unicodedata.name(char, "control character").lower()
    if unicodedata.category(char) in ("Cf", "Cc", "Mn", "Co", "Cn"):
        what = f"an invisible character stands here: {name} ({code})"
        return source.error(what, start, start + 1, "Delete it and type the expression again.")
    likeness = unicodedata.normalize("NFKC", char)
    likeness = _LIKE.get(char, likeness)
    hint = f"Type “{likeness}” instead." if likeness != char and likeness.isascii() else _INSTEAD.get(char, "")
    what = f"the character “{char}” ({name}, {code}) can't be read"
    return source.error(what, start, start + 1, hint or "Use plain letters and Greek letters.")


MAX_DEPTH = 60


class _Token(Protocol):
    @property
    def kind(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def start(self) -> int: ...
    @property
    def end(self) -> int: ...


T = TypeVar("T", bound=_Token)


class Cursor(Walker, Generic[T]):
    """Tokens read from left to right."""

    source: SourceText
    tokens: tuple[T, ...]
    position: int = 0
    depth: int = 0

    @property
    def token(self) -> T:
        """The token that comes next."""
        return self.tokens[self.position]

    @property
    def previous_end(self) -> int:
        """Where the token before ends."""
        return self.tokens[self.position - 1].end if self.position else 0

    def ahead(self, count: int = 1) -> T:
        """The token `count` places after the next."""
        return self.tokens[min(self.position + count, len(self.tokens) - 1)]

    def take(self) -> T:
        """The next token, which is then passed."""
        token = self.token
        self.position = min(self.position + 1, len(self.tokens) - 1)
        return token

    def sees(self, *texts: str, kind: str = "operator") -> bool:
        """Is the next token an operator with one of these texts?"""
        return self.token.kind == kind and self.token.text in texts

    def accept(self, *texts: str) -> bool:
        """Pass the next operator if it is one of these; was it?"""
        found = self.sees(*texts)
        self.position += found
        return found

    def error(self, what: str, instead: str = "", token: T | None = None, kind: type[ReadError] = ReadError) -> RbpsymError:
        """A ReadError at a token (the next one by default)."""
        token = token or self.token
        return self.source.error(what, token.start, token.end, instead, kind)

    def spanned(self, node: N, start: int) -> N:
        """The node with its span from `start` to here."""
        return replace(node, span=(start, self.previous_end))

    def power(self, base: t.Node, exponent: t.Node, start: int) -> t.Node:
        """base^exponent. Raises LimitError for an exponent beyond the bounds."""
        try:
            check_exponent(exponent)
        except LimitError as error:
            raise error.at(self.source.at(*(exponent.span or (start, start + 1)))) from None
        return self.spanned(t.Pow(base, exponent), start)

    @contextmanager
    def deeper(self) -> Iterator[None]:
        """One level of nesting. Raises LimitError beyond the bound."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            what = f"the expression is nested deeper than {MAX_DEPTH} levels"
            raise self.source.limit(what, self.token.start, self.token.end)
        yield
        self.depth -= 1


def behind_brace(text: str, start: int, most: int = sys.maxsize) -> int:
    """The offset behind the brace that closes the one at `start`; 0 if none does so soon."""
    depth = 0
    for found in re.compile(r"\\.|[{}]", re.S).finditer(text, start, min(len(text), start + most)):
        depth += (found[0] == "{") - (found[0] == "}")
        if not depth:
            return found.end()
    return 0
