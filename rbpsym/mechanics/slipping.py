"""How long a motion in time is as its formula tells: until a kinetic friction has lost its sense."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.field import Scalar, depends_on, derivative, names_in, short, substitute, without_even_roots
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.solutions import TIME, Given, InTime
from rbpsym.mechanics.solved import time_to


def lasting(known: Given, found: Mapping[str, InTime]) -> Iterator[Demand]:
    """What is asked of the time: that no slip has changed its sense since the start. That is said as t ≤ the first time at
    which one vanishes, if there surely is one and a formula gives it, else of the slip as far as the courses `found` tell
    it, which has to be met from the start on."""
    study, at, letters = known.study, dict[str, Scalar](), dict[str, Scalar]()
    for name, one in found.items():
        at |= {name: one.place, f"{name}_dot": derivative(one.place, "t")}
        letters |= one.letters
    for slip in slips(study.system).values():
        told = short(without_even_roots(substitute(slip, at)))
        if not names_in(told) & {"t", *study.system.coordinates, *study.system.speeds} or not depends_on(short(told / TIME), "t"):
            continue  # it stays what it is at the start, or grows from rest as it begins to
        first = time_to(told, known, letters)
        if first is not None and settle(first[1], study.assumptions) == ():
            yield Demand(short(substitute(first[0], letters) - TIME), ">=")
        else:
            yield Demand(short(without_even_roots(substitute(told, letters))), ">=")
