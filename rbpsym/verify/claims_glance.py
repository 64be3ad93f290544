"""A glance at two values in floating-point numbers, to see whether a proof of their equality is worth trying.

Nothing is decided here: what looks different is refuted exactly, and tried to be proved if that fails.
"""

from __future__ import annotations

import math
from hashlib import blake2b

from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.errors import NoNumber
from rbpsym.mechanics.numbers import number
from rbpsym.verify.claims_bound import Motion
from rbpsym.verify.claims_path import sense

CLEAR = 1e-6
LOOKS, SEEDS = 2, 20


class State(dict):
    """Numbers in one state of the motion, found when they are asked for. Raises ArithmeticError where there are none."""

    def __init__(self, motion: Motion, seed: int) -> None:
        super().__init__()
        self.motion, self.seed = motion, seed

    def __missing__(self, name: str) -> float:
        self[name] = self._found(name)
        return self[name]

    def _found(self, name: str) -> float:
        motion, coordinate = self.motion, name.removesuffix("_dot")
        if name in motion.unsettled or name in motion.lawless:
            return self._on_motion(name)
        if name in motion.ledger:
            raise ArithmeticError("a work has no number of its own")
        if name != coordinate and coordinate in motion.squares:
            return math.sqrt(number(motion.squares[coordinate], self)) * (sense(motion, coordinate) or 1)
        if name in motion.speeds and not motion.is_free:
            raise ArithmeticError("the speed is not known")
        digest = blake2b(f"{self.seed} {name}".encode(), digest_size=4).digest()
        return 0.4 + int.from_bytes(digest) / 2**32

    def _on_motion(self, name: str) -> float:
        moved = self.motion.moved(symbol(name))
        if moved == symbol(name):
            raise ArithmeticError("it is not known on the motion")
        return number(moved, self)


def is_along_one_path(motion: Motion) -> bool:
    """Is the speed of the only coordinate a function of its place, so that all states of the motion can be looked at?"""
    return not motion.is_free and len(motion.speeds) == 1 and len(motion.squares) == 1


def look_different(a: Scalar, b: Scalar, motion: Motion) -> bool:
    """Do numbers show the values to be apart in a state of the motion?"""
    seen = 0
    for seed in range(SEEDS):
        try:
            state = State(motion, seed)
            x, y = number(a, state), number(b, state)
        except NoNumber:
            continue
        seen += 1
        if abs(x - y) > CLEAR * max(abs(x), abs(y), CLEAR):
            return True
        if seen == LOOKS:
            return False
    return False
