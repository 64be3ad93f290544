"""The bound on work belongs to the call that sets it."""

import threading
from contextlib import nullcontext

import pytest

from rbpsym.errors import LimitError, WorkSpent
from rbpsym.field.effort import apart, at_most, granted, in_all, kept, remembered, spend
from tests.architecture.source import ROOT


def test_a_bound_holds_for_its_own_thread_alone():
    entered, done = threading.Event(), threading.Event()

    def bounded():
        with at_most(10):
            entered.set()
            done.wait(5)

    other = threading.Thread(target=bounded)
    other.start()
    entered.wait(5)
    spend(1_000_000)
    done.set()
    other.join()


def test_an_inner_bound_spends_of_the_outer_one():
    with at_most(10):
        with at_most(100), pytest.raises(LimitError):
            spend(11)
        with pytest.raises(LimitError):
            spend(1)
    spend(1_000_000)


def test_what_is_remembered_spends_as_much_as_what_is_worked_out():
    asked = []

    @remembered
    def costly(number):
        asked.append(number)
        spend(8)
        return number + 1

    for _ in range(2):
        with at_most(10), pytest.raises(LimitError):
            costly(1), costly(1)
    with at_most(16):
        assert costly(1) == costly(1) == 2
    assert asked == [1]


def test_what_went_too_far_is_not_remembered():
    @remembered
    def costly():
        spend(8)
        return 1

    with at_most(4), pytest.raises(LimitError):
        costly()
    assert costly() == 1


@pytest.mark.parametrize("bound", [at_most, in_all])
def test_what_was_cut_short_from_outside_is_not_remembered(bound):
    @remembered
    def careful():
        with apart() if bound is in_all else nullcontext():
            try:
                spend(8)
            except LimitError:
                return "cut short"
        return "whole"

    with bound(4):
        assert careful() == "cut short"
    assert careful() == "whole"


class Costly:
    """Has a value that costs 8 products, and another one that stands for it where these are too many."""

    @kept
    def value(self):
        try:
            with at_most(20):
                spend(8)
        except LimitError:
            return "cut short"
        return "whole"


def test_what_is_kept_is_not_cut_short_by_who_asks_first():
    found = Costly()
    with at_most(4):
        assert found.value == "whole"


@pytest.mark.parametrize("products", [1, 4, 7])
def test_a_question_that_is_given_up_leaves_nothing_behind(products):
    """Nobody on the way takes the end of its work for a refusal, also with bounds of their own; asked again, it is told."""
    found = Costly()
    with pytest.raises(WorkSpent), granted(products):
        found.value
    with granted(8):
        assert found.value == "whole"


def test_a_question_within_a_question_ends_with_it():
    tried = []

    def inner():
        try:
            with granted(100):
                spend(8)
        except LimitError:
            tried.append("another way")

    with pytest.raises(WorkSpent), granted(4):
        inner()
    with granted(1000):
        inner()
    assert not tried
    with granted(1000):
        try:
            with granted(4):
                spend(8)
        except WorkSpent:
            tried.append("another way")
    assert tried


def test_a_bound_of_a_way_within_a_question_is_caught():
    with granted(1000):
        with pytest.raises(LimitError) as caught, at_most(4):
            spend(8)
        assert not isinstance(caught.value, WorkSpent)
        spend(8)


SHARED = ("mechanics", "quantity", "ask", "claims/ground.py", "claims/theory.py")


def test_what_several_ask_for_is_kept_whole():
    """No `cached_property` in the rooms whose objects are shared by methods, questions and claims."""
    for name in SHARED:
        path = ROOT / "rbpsym" / name
        for file in [path] if path.is_file() else sorted(path.rglob("*.py")):
            assert "cached_property" not in file.read_text(encoding="utf-8"), file
