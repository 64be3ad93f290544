"""Every error that a user can meet: what is wrong, where, and what to do instead."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from rbpsym.frozen import Frozen

T = TypeVar("T")


class Place(Frozen):
    """A position in a source: file, line and column (from 1), the line's text, caret width."""

    file: str = ""
    line: int = 0
    column: int = 0
    text: str = ""
    width: int = 1

    def __str__(self) -> str:
        """`file:line:column`, without the parts that are unknown."""
        return ":".join([self.file or "input", *(str(n) for n in (self.line, self.column) if n)])


class RbpsymError(Exception):
    """Base of all errors that are told to the user as a sentence; `exit_code` for the shell."""

    exit_code = 2

    def __init__(self, what: str, *, instead: str = "", place: Place | None = None) -> None:
        super().__init__(what)
        self.what, self.instead, self.place = what, instead, place

    def at(self, place: Place | None) -> RbpsymError:
        """The same error, told at `place`, if it had none."""
        return self if self.place else type(self)(self.what, instead=self.instead, place=place)

    def __str__(self) -> str:
        lines = [f"{self.place}: {self.what}" if self.place else self.what]
        if self.place and self.place.text:
            margin = " " * max(self.place.column - 1, 0)
            lines += [f"    {self.place.text}", f"    {margin}{'^' * max(self.place.width, 1)}"]
        if self.instead:
            lines.append(f"  {self.instead}")
        return "\n".join(lines)


class ReadError(RbpsymError):
    """An expression or a file that can't be read."""


class UnknownName(ReadError):
    """A name or command that is not known where it stands."""


class Incomplete(ReadError):
    """A place where a number or symbol is missing."""


class StatementError(RbpsymError):
    """A problem statement that contradicts itself or does not determine the motion."""


class Ambiguous(StatementError):
    """Words that were understood, and may mean several things here, or nothing that is known: no other meaning is looked for."""


class Indistinct(StatementError):
    """Unknown forces that the equations do not tell apart: `free`."""

    free: tuple[str, ...] = ()


class DimensionError(RbpsymError):
    """Quantities of different dimension added, compared, or a length where an angle belongs."""


class LimitError(RbpsymError):
    """An input beyond the declared bounds of size, depth, digits or exponent."""


class WorkSpent(LimitError):
    """A question whose answer takes more work than is granted to one."""


class NotApplicable(RbpsymError):
    """A method that does not apply to a problem; `what` says why."""

    exit_code = 0


class NoNumber(RbpsymError, ValueError):
    """A quantity that has no number at a sample: a name is missing, a root is not real, a denominator is zero."""


class Undecided(RbpsymError):
    """A question outside the decidable class; `what` says why."""

    exit_code = 1


def there(value: T | None) -> T:
    """The value, which is there: whoever stated it has seen to that. Raises ValueError where it is not."""
    if value is None:
        raise ValueError("what has to be there is missing")
    return value


def all_there(values: Iterable[T | None]) -> list[T] | None:
    """All values; None where one of them is missing."""
    found: list[T] = []
    for value in values:
        if value is None:
            return None
        found.append(value)
    return found
