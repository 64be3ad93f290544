"""The bound on work belongs to the call that sets it."""

import threading
from contextlib import nullcontext

import pytest

from rbpsym.algebra.effort import apart, at_most, in_all, remembered, spend
from rbpsym.errors import LimitError


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
