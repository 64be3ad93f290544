"""The motion from its start as a path: speeds as functions of the place, which states lie on it; and a glance along it.

q̇ = σ √(q̇²(q)), where σ is the sense in which the motion sets out; so it goes until it first comes to rest. A glance
in floating-point numbers tells whether a proof of an equality is worth trying. Nothing is decided by it: what looks
different is refuted exactly, and tried to be proved if that fails.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from hashlib import blake2b
from itertools import product

from rbpsym.decide.domain import Condition
from rbpsym.decide.points import Point
from rbpsym.decide.signs import sign
from rbpsym.errors import NoNumber
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ONE, Scalar, is_zero, kept, short, symbol
from rbpsym.field.calculus import depends_on, derivative, inside, names_in, root, substitute
from rbpsym.field.integration import definite
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.arrivals import inward
from rbpsym.mechanics.motion import along_motion
from rbpsym.mechanics.numbers import number
from rbpsym.quantity.bound import Motion

STEPS, EDGE = 32, 1e-9
Branch = tuple[tuple[Scalar, ...], list[Condition]]


def first_push(motion: Motion, name: str) -> Scalar:
    """What sets a coordinate going: its speed at the start, or its acceleration there if it starts from rest."""
    first = motion.scope.start.get(f"{name}_dot") or motion.moved(symbol(f"{name}_ddot"))
    return substitute(first, motion.scope.start)


def sense(motion: Motion, name: str) -> int:
    """1 or -1, the sense in which a coordinate sets out; 0 where it depends on the parameters or is not known.

    What starts from rest in an equilibrium at an end of its range goes into the range.
    """
    push = first_push(motion, name)
    if found := sign(push, motion.assumptions).sense:
        return found
    return inward(motion.scope.start.get(name), motion.assumptions.range_of(name)) if is_zero(push) else 0


def on_path(values: tuple[Scalar, ...], motion: Motion) -> Iterator[Branch]:
    """The values with all speeds put in, for each sense that is possible, and when it is that sense."""
    moving = [name for name in motion.squares if any(depends_on(value, f"{name}_dot") for value in values)]
    known = {name: sense(motion, name) for name in moving}
    for signs in product(*((known[name],) if known[name] else (1, -1) for name in moving)):
        image, when = {}, []
        for name, way in zip(moving, signs, strict=True):
            image[f"{name}_dot"] = root(motion.squares[name]) * way
            if not known[name]:
                when.append(Condition(t.Sym(f"{name}_dot"), ">", first_push(motion, name) * way))
        yield tuple(even(substitute(value, image)) for value in values), when


def with_energy(values: tuple[Scalar, ...], motion: Motion) -> Iterator[Branch]:
    """The values where the energy is that of the start: one of the speeds is what it must be for that.

    As they are where nothing moves in them, where no energy is conserved, or where it is not said how the motion starts.
    """
    energy, speeds = motion.energy or NOTHING, motion.speeds if motion.energy is not None else ()
    moving = names_in(energy) & motion.scope.rates.keys()
    is_told = any(depends_on(value, name) for value in values for name in moving)
    if not is_told or not moving & set(speeds) or not moving <= motion.scope.start.keys():
        yield values, []
        return
    speed = min((n for n in speeds if n in moving), key=lambda n: any(depends_on(value, n) for value in values))
    gap = energy - substitute(energy, motion.scope.start)
    first = derivative(gap, speed)
    rest, slope, half = (substitute(f, {speed: NOTHING}) for f in (gap, first, derivative(first, speed)))
    spread = slope * slope - half * rest * 2
    for way in (1, -1):
        image = {speed: (root(spread) * way - slope) / half}
        yield tuple(even(substitute(value, image)) for value in values), [Condition(t.Sym(speed), ">=", spread)]


def even(value: Scalar) -> Scalar:
    """The value with squares of roots carried out, inside roots too."""
    return without_even_roots(inside(value, even))


def reachable(motion: Motion) -> list[Condition]:
    """What holds on the path: the squares of the speeds are not negative, declared ranges are kept."""
    squares = [Condition(t.Sym(f"{name}_dot"), ">=", square) for name, square in motion.squares.items()]
    return [*squares, *motion.kept]


def work_done(power: Scalar, motion: Motion) -> Scalar | None:
    """∫ power dt from the start, coordinate by coordinate along which it is done, or over the time; None if it has none."""
    known = motion.moved(power)
    if not names_in(known) & {*motion.scope.rates, *motion.speeds} - {"t"}:
        return definite(known, "t", NOTHING, symbol("t"))
    names = [n for n in motion.scope.start if n in motion.scope.rates and depends_on(known, f"{n}_dot")]
    total, rest = NOTHING, known
    steady = known - sum((derivative(known, f"{n}_dot") * symbol(f"{n}_dot") for n in names), NOTHING)
    is_beside = not is_zero(steady) and not names_in(steady) & {*motion.scope.rates, *motion.speeds} - {"t"}
    for name in names:
        speed = f"{name}_dot"
        rest = rest - derivative(known, speed) * symbol(speed)
        part = derivative(known, speed) if len(names) > 1 or is_beside else substitute(known / symbol(speed), {})
        integrand = along_motion(part, motion.squares)
        others = {*motion.scope.rates, "t"} - {name}
        if integrand is None or any(depends_on(integrand, other) for other in others):
            return None
        if integrand.den is not ONE and depends_on(Scalar(integrand.den), name):
            return None
        done = definite(integrand, name, motion.scope.start[name], symbol(name))
        if done is None:
            return None
        total = total + done
    if is_beside:
        gone = definite(steady, "t", NOTHING, symbol("t"))
        return None if gone is None else total + gone
    return total if len(names) == 1 or (names and is_zero(rest)) else None


def work_by_energy(power: Scalar, motion: Motion) -> Scalar | None:
    """∫ power dt of power = (a q̈ + b(q)) q̇ with constant a, as what it gives to the square of the speed of the one coordinate,
    and to what acts beside it; None where it is no such power."""
    if len(motion.speeds) != 1:
        return None
    [speed] = motion.speeds
    return _by_gain(power / symbol(speed), motion, speed, speed.removesuffix("_dot"), symbol(speed) ** 2 / 2)


def gathered(rate: Scalar, motion: Motion) -> Scalar | None:
    """∫ rate dt of rate = a q̈ + b(t) with constant a, as what it gives to a speed; None where it is no such rate."""
    found = (_by_gain(rate, motion, speed, "t", symbol(speed)) for speed in motion.speeds)
    return next((one for one in found if one is not None), None)


def _by_gain(rate: Scalar, motion: Motion, speed: str, over: str, gained: Scalar) -> Scalar | None:
    """a (gained - gained at first) + ∫ b d(over) of a rate a q̈ + b with constant a and b a function of `over`; None where it is
    none."""
    start, moving = {"t": NOTHING, **motion.scope.start}, {*motion.scope.rates, *motion.speeds, "t"}
    known, gain = (short(motion.moved(value)) for value in (rate, symbol(speed.replace("_dot", "_ddot"))))
    for name in (names_in(gain) & moving) if {speed, over} <= start.keys() else ():
        slope = derivative(gain, name)
        share = short(derivative(known, name) / slope)
        beside = short(known - share * gain)
        if share and not names_in(share) & moving and not names_in(beside) & (moving - {over}):
            done = definite(beside, over, start[over], symbol(over))
            return None if done is None else done + share * (gained - substitute(gained, start))
    return None


class Path(Frozen):
    """The way from the start until the motion first comes to rest, along some coordinates.

    at: names that are given as functions of others.
    """

    motion: Motion
    names: tuple[str, ...]
    at: Mapping[str, Scalar] = field(default_factory=dict)

    @kept
    def pushes(self) -> dict[str, Scalar]:
        """What sets each coordinate going."""
        return {name: first_push(self.motion, name) for name in self.names}

    @property
    def values(self) -> list[Scalar]:
        """What must have a value at a point of the path."""
        starts = [self.motion.scope.start[name] for name in self.names]
        found = [*starts, *self.pushes.values(), *(self.motion.squares[name] for name in self.names)]
        return [substitute(value, self.at) for value in found]

    def holds(self, point: Point) -> bool:
        """Whether the point is met on the way (a look in floating-point numbers: it only takes witnesses away)."""
        angles = {n: 2 * point.parts[n] * math.atan2(float(s), 1 + float(c)) for n, (c, s) in point.angles.items()}
        numbers = {**{name: float(value) for name, value in point.numbers.items()}, **angles}
        try:
            numbers |= {name: number(value, numbers) for name, value in self.at.items()}
            return all(self._is_met(name, numbers) for name in self.names)
        except NoNumber:  # a root or quotient has no number there
            return False

    def _is_met(self, name: str, numbers: dict[str, float]) -> bool:
        begin, square = number(self.motion.scope.start[name], numbers), self.motion.squares[name]
        numbers.setdefault(name, begin)
        way = numbers[name] - begin
        if not square or number(self.pushes[name], numbers) * way < -EDGE:
            return abs(way) < EDGE
        between = (number(square, {**numbers, name: begin + way * k / STEPS}) for k in range(1, STEPS + 1))
        return all(value > -EDGE for value in between)


def path_of(values: Iterable[Scalar], motion: Motion) -> Path:
    """The path along the coordinates on which values depend, by their places or speeds."""
    names = set().union(*(names_in(value) for value in values))
    return Path(motion, tuple(n for n in motion.squares if names & {n, f"{n}_dot"} and n in motion.scope.start))


CLEAR = 1e-6
LOOKS, SEEDS = 2, 20


class State(dict[str, float]):
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
