"""Quantities that are made of others: ratios, multiples, and what vibrations are described by."""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.algebra.calculus import root
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import PI, Scalar
from rbpsym.ask.finding import Finding
from rbpsym.ask.seen import Scene, number_in, seen
from rbpsym.equality.verdict import proved
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.mechanics.demands import existence, settle
from rbpsym.mechanics.elimination import short


def _times(world: Scene, factor: str, text: str) -> Scalar:
    return number_in(world, factor) * value_of(world, text)


def _ratio(world: Scene, above: str, below: str) -> Scalar:
    return short(value_of(world, above) / value_of(world, below))


def _pendulum(world: Scene, name: str | None) -> Scalar:
    """The length g/ϑ² of the simple pendulum with the same period."""
    known = {scalar(element["g"]) for element in world.study.problem.interactions if element.kind == "gravity"}
    if len(known) != 1:
        raise StatementError("a simple pendulum of equal period needs one acceleration of gravity")
    return short(known.pop() / seen(world, f"frequency of {name or world.study.system.independent[0]}") ** 2)


def _magnitude(world: Scene, force: str, when: str) -> Scalar:
    return root(short(seen(world, f"impulse of {force}_x{when}") ** 2 + seen(world, f"impulse of {force}_y{when}") ** 2))


MADE: tuple[tuple[str, Callable[..., Scalar]], ...] = (
    (r"damped period of (\w+)", lambda world, name: PI * 2 / seen(world, f"damped frequency of {name}")),
    (r"damping ratio of (\w+)", lambda world, name: _ratio(world, f"decay rate of {name}", f"undamped frequency of {name}")),
    (r"logarithmic decrement of (\w+)",
     lambda world, name: PI * 2 * _ratio(world, f"decay rate of {name}", f"damped frequency of {name}")),
    (r"(?:length of the simple pendulum with (?:the )?(?:equal|same) period|equivalent length)(?: of (\w+))?", _pendulum),
    (r"magnitude of impulse of (\w+)((?: when \w+ begins)?)", _magnitude),
    (r"twice (?:the )?(.+)", lambda world, text: _times(world, "2", text)),
    (r"([\w./^]+?) ?(?:\*|times) ?(?:the )?((?!.* [+-] ).+ .+)", _times),
    (r"ratio of (.+) to (?:the )?((?!.* mode$).+)", _ratio),
)  # fmt: skip


def value_of(world: Scene, text: str) -> Scalar:
    """A quantity that is made of others, or one by itself. Raises StatementError or ReadError for what means nothing."""
    try:
        return seen(world, text)
    except RbpsymError:
        found = next(((make, words) for pattern, make in MADE if (words := re.fullmatch(pattern, text))), None)
        if found is None:
            raise
        return found[0](world, *found[1].groups())


def made(world: Scene, text: str) -> Finding:
    """What is found for such a quantity: it is what the others in it are said to be."""
    value = value_of(world, text)
    demands = [demand for _, found in world.used for part in found.values for demand in existence(part)]
    left = settle(demands, world.motion.assumptions)
    return Finding(proved("it is made of what is said"), values=(value,), valid=tuple(demands) if left is None else left)
