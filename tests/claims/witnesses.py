"""Witnesses of refutations, caught as claims are decided, and what is wrong with one as a state of its motion."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from rbpsym.claims import check as claims_check
from rbpsym.expr import tree as t
from rbpsym.mechanics.numbers import number

CLOSE = 1e-9


@contextmanager
def refutations() -> Iterator[list]:
    """The witnesses of what is refuted within."""
    found, link = [], claims_check._link

    def watched(relation, verdict):
        if verdict.witness is not None and verdict.is_refuted:
            found.append(verdict.witness)
        return link(relation, verdict)

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(claims_check, "_link", watched)
        yield found


@contextmanager
def refutations_on_motions() -> Iterator[list]:
    """(witness, motion, relation) of what is refuted within, where the witness has to lie on the motion."""
    found, decided = [], claims_check._decided

    def watched(relation, ground, question):
        before = len(seen)
        link = decided(relation, ground, question)
        loose = any(ground.kind(name) == "up to a constant" for name in t.names(relation))
        loose = loose or "start" not in question.depths  # what is demanded of all motions may fail on any
        if not loose and not ground.motion.is_free:  # "up to a constant" is an identity of all motions
            found.extend((witness, ground.motion, relation) for witness in seen[before:])
        return link

    with refutations() as seen, pytest.MonkeyPatch.context() as patched:
        patched.setattr(claims_check, "_decided", watched)
        yield found


def off_the_motion(witness, motion):
    """What is wrong with a witness as a state of the motion, in words."""
    numbers = {name: float(value) for name, value in witness.numbers}
    for angle, c, s in witness.points:
        name, _, parts = angle.partition("/")
        numbers[name] = int(parts or 1) * math.atan2(float(s), float(c))
    for name, value in numbers.items():
        if motion.assumptions.sign_of(name) == "positive" and value <= 0:
            return f"{name} is not positive"
        lower, upper = motion.assumptions.range_of(name)
        below = lower is not None and value <= number(lower, numbers)
        if below or (upper is not None and value >= number(upper, numbers)):
            return f"{name} is outside its range"
    for name, square in motion.squares.items():
        if f"{name}_dot" in numbers:
            return f"the speed of {name} is taken at will"
        if name in numbers and name in motion.scope.start:
            try:
                begin = number(motion.scope.start[name], numbers)
                way = [begin + (numbers[name] - begin) * k / 50 for k in range(51)]
                least = min(number(square, {**numbers, name: here}) for here in way)
            except KeyError as error:
                return f"it does not say what {error} is"
            if least < -CLOSE:
                return f"the square of the speed of {name} is negative on the way"
    return ""
