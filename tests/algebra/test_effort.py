"""The bound on work belongs to the call that sets it."""

import threading

import pytest

from rbpsym.algebra.effort import at_most, spend
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
