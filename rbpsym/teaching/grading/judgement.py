"""What is found about one answer: its status, the part of the points that it earns, and remarks."""

from __future__ import annotations

import re
from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction
from typing import Any

from rbpsym.decide.verdict import Witness
from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field, replace
from rbpsym.teaching.model import Slip

ALL, NONE, HALF = Fraction(1), Fraction(0), Fraction(1, 2)


class Status(StrEnum):
    """What an answer is. INVALID, UNDECIDED and OPEN go to the teacher."""

    RIGHT = "right"
    CARRIED = "carried forward"
    PARTLY = "partly right"
    UNFINISHED = "unfinished"
    WRONG = "wrong"
    INVALID = "invalid"
    UNDECIDED = "undecided"
    OPEN = "open"
    EMPTY = "empty"


GIVES_UP = re.compile(
    r"\s*(?:i\s+)?(?:don['’]?t\s+know|do\s+not\s+know|no\s+idea|idk|no\s+(?:lo\s+)?s[eé]|ni\s+idea|\?+)[\s.!]*", re.IGNORECASE
)
FOR_THE_TEACHER = frozenset({Status.INVALID, Status.UNDECIDED, Status.OPEN})


class Remark(Frozen):
    """A sentence of the phrases, under [remark], its places filled with `slots` (texts, or trees of formulas)."""

    key: str
    slots: Mapping[str, Any] = field(default_factory=dict)


class Judgement(Frozen):
    """`credit` is the part of the points earned, 0 to 1; `slip` the misconception that was recognised.

    parts: what was marked apart (“value”, “unit”, “figures”, or the blanks), each with its own credit.
    """

    status: Status
    credit: Fraction = NONE
    remarks: tuple[Remark, ...] = ()
    slip: Slip | None = None
    witness: Witness | None = None
    parts: tuple[tuple[str, Fraction], ...] = ()
    teacher: bool = False

    @property
    def is_for_teacher(self) -> bool:
        """Whether a person should look at it."""
        return self.teacher or self.status in FOR_THE_TEACHER

    def with_remark(self, key: str, **slots: Any) -> Judgement:
        """The same with one more remark."""
        return replace(self, remarks=(*self.remarks, Remark(key, slots)))


RIGHT = Judgement(Status.RIGHT, ALL)
EMPTY = Judgement(Status.EMPTY, remarks=(Remark("empty"),))


def slip_remarks(slip: Slip) -> tuple[Remark, ...]:
    """What the slip is, and the first step that it spoils, as it should be."""
    first = () if slip.shown is None else (Remark("first wrong", {"step": slip.shown}),)
    return (Remark("slip", {"slip": slip}), *first)


def wrong(key: str = "wrong", **slots: Any) -> Judgement:
    """No points, with a remark."""
    return Judgement(Status.WRONG, remarks=(Remark(key, slots),))


def invalid(error: Exception | None) -> Judgement:
    """An answer that can't be read, with the sentence that says why, and the place under a caret."""
    slots: dict[str, object] = {"why": str(error), "shown": ""}
    if isinstance(error, RbpsymError):
        why = " ".join(filter(None, (sentence(error.what), error.instead)))
        slots = {"why": why, "shown": _shown(error), "error": error}
    return Judgement(Status.INVALID, remarks=(Remark("invalid", slots),))


def sentence(text: str) -> str:
    """The text with a full stop, unless it ends with a sign of its own."""
    return text if text.endswith((".", "?", "!")) else f"{text}."


def _shown(error: RbpsymError) -> str:
    """The line with a caret under what is meant."""
    place = error.place
    if place is None or not place.text:
        return ""
    return f"{place.text}\n{' ' * max(place.column - 1, 0)}{'^' * max(place.width, 1)}"


def undecided(reason: str) -> Judgement:
    """An answer that the teacher decides."""
    return Judgement(Status.UNDECIDED, remarks=(Remark("undecided", {"reason": reason}),))
