"""A bound on work that is counted: the same system is too heavy on every machine, however busy."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

from rbpsym.field.poly import Poly
from rbpsym.oracles.simulation_motion import Equations

A_PLACE = 8  # of a motion at which the equations are solved: it takes as long as so many terms


class TooHeavy(BaseException):
    """More than the bound. No `except Exception` of what is tested takes it for an error of its own."""


@contextmanager
def at_most(most: int) -> Iterator[None]:
    """Within it, polynomials with so many terms are made at most, and places of motions that count as much."""
    left = most
    make, solve = Poly.__init__, Equations.at

    def spend(work: int) -> None:
        nonlocal left
        left -= work
        if left < 0:
            raise TooHeavy

    def made(self, terms, *more) -> None:
        spend(1 + len(terms))
        make(self, terms, *more)

    def at(self, where, speed):
        spend(A_PLACE)
        return solve(self, where, speed)

    with patch.object(Poly, "__init__", made), patch.object(Equations, "at", at):
        yield
