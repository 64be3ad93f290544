"""Frozen values mean what those of the standard library mean."""

from __future__ import annotations

import dataclasses
import pickle
from collections.abc import Callable
from typing import Any

import pytest

from rbpsym.frozen import OFTEN, Frozen, Late, Walker, field, replace


class Place(Frozen):
    """A place, to be pickled."""

    x: int
    marks: tuple[str, ...] = ()


def kinds(base: type, make: Callable[[Any], Any]) -> tuple[Any, Any]:
    """A class and one that adds a field to it."""

    @make
    class One(base):
        """One."""

        x: int
        note: str = dataclasses.field(default="n", compare=False, repr=False)
        marks: list[int] = dataclasses.field(default_factory=list, hash=False)
        span: int | None = dataclasses.field(default=None, kw_only=True)

    @make
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
def test_it_is_what_the_standard_library_makes(call: Callable[[Any, Any], Any]) -> None:
    standard = kinds(object, dataclasses.dataclass(frozen=True))
    assert shown(call, *kinds(Frozen, lambda cls: cls)) == shown(call, *standard)


def test_what_is_equal_to_itself_alone() -> None:
    class Own(Frozen, eq=False):
        """Own."""

        x: int

    first, second = Own(1), Own(1)
    assert first == first != second and len({first, second}) == 2


def test_walkers_remember() -> None:
    class Own(Walker):
        """Own."""

        x: int
        seen: list[int] = dataclasses.field(default_factory=list)

    own = Own(1)
    own.x, own.seen[:] = 2, [3]
    assert (own.x, own.seen, Own(1).seen) == (2, [3], [])


def test_a_late_field_is_found_once_and_replacing_another_does_not_look():
    class Own(Frozen):
        a: int
        b: int = Late(7)

    looks = []
    late = replace(Own(1, lambda: looks.append(1) or 5), a=2)
    assert (late.a, looks, Own(1).b, Own(1, 3).b) == (2, [], 7, 3)
    assert (late.b, late.b, late, looks) == (5, 5, Own(2, 5), [1])


def test_it_can_be_sent_to_another_process() -> None:
    assert pickle.loads(pickle.dumps(Place(1, ("a",)))) == Place(1, ("a",))


def test_written_out_it_does_the_same():
    """A class that is made often gets another constructor: the same fields, defaults and refusals."""

    class Often(Frozen):
        a: int
        b: list = field(default_factory=list)
        c: int = field(default=3, init=False)
        d: int = field(default=4, kw_only=True)

        def __post_init__(self):
            assert self.d

    class After(Often):
        e: str = "e"

    for kind in (Often, After):
        before = kind.__init__
        made = [(kind(1), kind(1, [2], d=5), kind(b=[2], a=1, d=5)) for _ in range(OFTEN)]
        assert kind.__init__ is not before
        assert made[0] == made[-1] and made[0][1] == made[0][2] != made[0][0] and made[-1][0].c == 3
        assert made[0][0].b is not made[-1][0].b
        for values, named in (((), {}), ((1,), {"c": 2}), ((1, [], "e", 4, 5), {})):
            with pytest.raises(TypeError):
                kind(*values, **named)
