"""A quick look at a formula with floating-point numbers, to choose what is worth deciding; never a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from hashlib import blake2b
from itertools import islice
from typing import Any

from rbpsym.claims.ground import EqualityQuestion, Ground
from rbpsym.claims.refute import carried_out
from rbpsym.errors import NoNumber, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Space, root
from rbpsym.field import value as exact_value
from rbpsym.field.elliptic import FUNCTIONS as OF_SCALARS
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.numbers import number
from rbpsym.quantity.bound import Motion
from rbpsym.quantity.path import sense

TOLERANCE, SMALL = 1e-8, 1e-4


class Triple(tuple[float, ...]):
    """The three components of a vector, with the arithmetic of vectors."""

    def __add__(self, other: Any) -> Triple:
        if not isinstance(other, Triple) and other == 0:  # the null vector, as the first term of a sum or a side
            return self
        return Triple(a + b for a, b in zip(self, other, strict=True))

    __radd__ = __add__

    def __rsub__(self, other: Any) -> Triple:
        return (-self).__add__(other)

    def __sub__(self, other: Any) -> Triple:
        return self.__add__(-other)

    def __neg__(self) -> Triple:
        return Triple(-a for a in self)

    def __mul__(self, factor: Any) -> Triple:
        return Triple(a * float(factor) for a in self)

    __rmul__ = __mul__

    def __matmul__(self, other: Triple) -> float:
        return sum(a * b for a, b in zip(self, other, strict=True))


Value = float | Triple


def size_of(value: Value) -> float:
    """The largest component, or the number, without its sign."""
    return max(map(abs, value)) if isinstance(value, Triple) else abs(value)


def cross(left: Triple, right: Triple) -> Triple:
    """The vector product."""
    (a, b, c), (x, y, z) = left, right
    return Triple((b * z - c * y, c * x - a * z, a * y - b * x))


class Numbers(dict[str, float]):
    """A generic number for every name, the same each time."""

    def __init__(self, seed: int, known: Mapping[str, float] = {}) -> None:
        super().__init__(known)
        self.seed = seed

    def __missing__(self, name: str) -> float:
        digest = blake2b(f"{self.seed} {name}".encode(), digest_size=4).digest()
        self[name] = 0.4 + int.from_bytes(digest) / 2**32
        return self[name]


class Sample(Frozen):
    """A state of the motion, in numbers; `known` are the values of names met so far."""

    question: EqualityQuestion
    numbers: Numbers
    known: dict[t.Node, Value] = field(default_factory=dict)

    def leaf(self, node: t.Sym | t.Vec) -> Value:
        """The number or triple of a name. Raises ArithmeticError if it has none in closed form."""
        if node not in self.known:
            scope = self.question.ground.scope
            found = scope.vectors.get(node.name) if isinstance(node, t.Vec) else scope.scalars.get(node.name)
            self.known[node] = self._value(found, node.name)
        return self.known[node]

    def exact(self, node: t.Node) -> Value:
        """The number or triple of a derivative or change. Raises RbpsymError if it has no value."""
        return self._value(exact_value(node, self.question.ground.scope), "")

    def _value(self, found: Scalar | Space | None, name: str) -> Value:
        if isinstance(found, Space):
            return Triple(self._scalar(part) for part in found.components())
        return math.pi if name == "pi" else self.numbers[name] if found is None else self._scalar(found)

    def _scalar(self, found: Scalar) -> float:
        done = carried_out(found, self.question)
        if done is None:
            raise ArithmeticError("no closed form")
        return number(done, self.numbers)

    def gap(self, relation: t.Chain) -> float | None:
        """How far the sides are apart, relative to their size; infinitely, if one is a vector; None if that can't be said."""
        try:
            left, right = (value(node, self) for node in relation.items)
            return size_of(left - right) / max(size_of(left), size_of(right), SMALL)
        except TypeError:
            return math.inf
        except (ArithmeticError, ValueError, KeyError, RbpsymError):
            return None

    def is_identity(self, relation: t.Chain, ground: Ground) -> bool:
        """Does it hold of any numbers in place of its names, x = 4 x/4, but for those that are names of one quantity?"""
        values = {name: ground.scope.scalars.get(name, name) for name in t.names(relation)}
        known: dict[t.Node, Value] = {t.Sym(name): Numbers(5)[str(value)] for name, value in values.items()}
        gap = replace(self, known=known).gap(relation)
        return gap is not None and gap < TOLERANCE and bool(known)

    def is_hollow(self, node: t.Node) -> bool:
        """Is it zero because every term of it is, or a factor: in 0 · (a − b) nothing is said of a and b."""
        parts = (node.arg,) if isinstance(node, (t.Neg, t.Group)) else node.terms if isinstance(node, t.Add) else ()
        if parts:
            return all(map(self.is_hollow, parts))
        if isinstance(node, t.Mul):
            return any(map(self.is_hollow, node.factors))
        try:
            return size_of(value(node, self)) < TOLERANCE
        except (ArithmeticError, ValueError, KeyError, TypeError, RbpsymError):
            return False


def samples(question: EqualityQuestion, count: int = 2, relation: t.Chain | None = None) -> list[Sample]:
    """States in which the squares of the speeds are not negative, and both sides have a value (if there are any)."""
    motion = question.motion
    if not motion.states:  # seeds with what they give for the coordinates and speeds; every second one is near the start
        found = [(seed, known) for seed in range(60) if (known := _state(motion, seed)) is not None]
        motion.states.extend(found or _start_state(motion))
    looks = [Sample(question, Numbers(seed, known)) for seed, known in motion.states]
    valued = (look for look in looks if relation is not None and look.gap(relation) is not None)
    return list(islice(valued, count)) or looks[:count]


def _start_state(motion: Motion) -> list[tuple[int, dict[str, float]]]:
    """The start alone, for a motion that stays there."""
    numbers = Numbers(0)
    try:
        known = {name: number(value, numbers) for name, value in motion.scope.start.items()}
    except NoNumber:
        return []
    return [(0, {**numbers, **known})]


def _state(motion: Motion, seed: int) -> dict[str, float] | None:
    numbers = Numbers(seed)
    try:
        for name in motion.squares if seed % 2 else ():
            begin = motion.scope.start.get(name)
            numbers[name] = numbers[name] if begin is None else number(begin, numbers) + (numbers[name] - 0.9) / 4
        squares = motion.squares.items()
        roots = {f"{n}_dot": number(root(s), numbers) * (sense(motion, n) or 1) for n, s in squares}
    except NoNumber:
        return None
    return {**numbers, **roots}


def value(node: t.Node, at: Sample) -> Any:
    """The number or triple of a formula; what is no plain algebra is computed exactly first."""
    rule = VALUES.get(type(node))
    return rule(node, at) if rule else at.exact(node)


def _power(node: t.Pow, at: Sample) -> float:
    base = value(node.base, at)
    return base @ base if isinstance(base, Triple) else math.pow(base, value(node.exponent, at))


def length(found: Value) -> float:
    """Of a vector; of a number what it is without its sign."""
    return math.sqrt(found @ found) if isinstance(found, Triple) else abs(found)


FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    **OF_SCALARS, "tan": math.tan, "cot": lambda x: 1 / math.tan(x), "sec": lambda x: 1 / math.cos(x),
    "csc": lambda x: 1 / math.sin(x),
}  # fmt: skip
UNITS = {axis: Triple(float(axis == other) for other in "xyz") for axis in "xyz"}

VALUES: Mapping[type, Callable[[Any, Sample], Value]] = {
    t.Num: lambda node, at: float(node.value), **dict.fromkeys((t.Sym, t.Vec), lambda node, at: at.leaf(node)),
    t.Unit: lambda node, at: UNITS[node.axis], t.Add: lambda node, at: sum(value(term, at) for term in node.terms),
    t.Neg: lambda node, at: -value(node.arg, at),
    t.Mul: lambda node, at: math.prod(value(factor, at) for factor in node.factors),
    t.Div: lambda node, at: value(node.num, at) * (1 / value(node.den, at)), t.Pow: _power,
    t.Sqrt: lambda node, at: math.sqrt(value(node.arg, at)), t.Fn: lambda node, at: FUNCTIONS[node.name](value(node.arg, at)),
    t.Abs: lambda node, at: length(value(node.arg, at)), t.Group: lambda node, at: value(node.arg, at),
    t.Cross: lambda node, at: cross(value(node.left, at), value(node.right, at)),
    t.Dot: lambda node, at: value(node.left, at) @ value(node.right, at),
}  # fmt: skip
