"""Frozen values mean what those of the standard library mean."""

from __future__ import annotations

import dataclasses
import pickle
from collections.abc import Callable
from typing import Any

import pytest

from rbpsym.frozen import dataclass, replace

MAKERS = {"own": dataclass, "standard": dataclasses.dataclass}


@dataclass(frozen=True, slots=True)
class Place:
    """A place, to be pickled."""

    x: int
    marks: tuple[str, ...] = ()


def kinds(make: Callable[..., Any], **how: bool) -> tuple[Any, Any]:
    """A class and one that adds a field to it."""

    @make(**how)
    class One:
        """One."""

        x: int
        note: str = dataclasses.field(default="n", compare=False, repr=False)
        marks: list[int] = dataclasses.field(default_factory=list, hash=False)
        span: int | None = dataclasses.field(default=None, kw_only=True)

    @make(**how)
    class Two(One):
        """Two."""

        y: int = 3
        twice: int = dataclasses.field(init=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "twice", 2 * self.y)

        def __hash__(self) -> int:
            return 7

    return One, Two


def shown(call: Callable[[Any, Any], Any], one: Any, two: Any) -> str:
    """What comes of it, or the kind of its error."""
    try:
        return str(call(one, two))
    except (AttributeError, TypeError) as error:
        return type(error).__name__


CALLS: tuple[Callable[[Any, Any], Any], ...] = (
    lambda one, two: [one(1), one(1, "a", [2]), one(x=1, span=4), two(1, y=5), two(1, "a", [], 6)],
    lambda one, two: [one(1) == one(1, "other"), one(1) == one(2), one(1) == two(1), one(1) == 1,],
    lambda one, two: [one(1, span=2) == one(1), one(1, marks=[1]) == one(1)],
    lambda one, two: [hash(one(1)) == hash(one(1, "other")), hash(two(1))],
    lambda one, two: [one(1).marks is one(1).marks, two(1).twice, two.__match_args__],
    lambda one, two: [replace(one(1, "a"), x=2), dataclasses.replace(two(1), y=4), replace(two(1), y=4).twice],
    lambda one, two: one(),
    lambda one, two: one(1, 2, [], 4),
    lambda one, two: one(1, x=2),
    lambda one, two: one(1, other=2),
    lambda one, two: replace(one(1), other=2),
    lambda one, two: setattr(one(1), "x", 2),
    lambda one, two: delattr(one(1), "x"),
    lambda one, two: [f.name for f in dataclasses.fields(two)] + [dataclasses.astuple(two(1))],
)


@pytest.mark.parametrize("call", CALLS, ids=range(len(CALLS)))
@pytest.mark.parametrize("slots", [True, False])
@pytest.mark.parametrize("frozen", [True, False])
def test_it_is_what_the_standard_library_makes(call: Callable[[Any, Any], Any], slots: bool, frozen: bool) -> None:
    own, standard = (shown(call, *kinds(make, slots=slots, frozen=frozen)) for make in MAKERS.values())
    assert own == standard


def test_it_can_be_sent_to_another_process() -> None:
    assert pickle.loads(pickle.dumps(Place(1, ("a",)))) == Place(1, ("a",))
