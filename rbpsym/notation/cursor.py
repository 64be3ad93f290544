"""A place in a row of tokens, with a bound on the depth of reading. Shared by both readers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from rbpsym.errors import RbpsymError

MAX_DEPTH = 60


class _Token(Protocol):
    kind: str
    text: str
    start: int
    end: int


class _Source(Protocol):
    text: str

    def error(self, what: str, start: int, end: int, instead: str = "") -> RbpsymError: ...
    def limit(self, what: str, start: int = 0, end: int = 1) -> RbpsymError: ...


T = TypeVar("T", bound=_Token)


@dataclass(slots=True)
class Cursor(Generic[T]):
    """Tokens read from left to right."""

    source: _Source
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

    def accept(self, *texts: str, kind: str = "operator") -> bool:
        """Pass the next token if it is one of these; was it?"""
        found = self.sees(*texts, kind=kind)
        self.position += found
        return found

    def error(self, what: str, instead: str = "", token: T | None = None) -> RbpsymError:
        """A ReadError at a token (the next one by default)."""
        token = token or self.token
        return self.source.error(what, token.start, token.end, instead)

    @contextmanager
    def deeper(self) -> Iterator[None]:
        """One level of nesting. Raises LimitError beyond the bound."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            what = f"the expression is nested deeper than {MAX_DEPTH} levels"
            raise self.source.limit(what, self.token.start, self.token.end)
        yield
        self.depth -= 1
