"""Numbers of one representative pose of a system: for its figures, and to name what is above and what below."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from typing import Any

from rbpsym.errors import NoNumber, NotApplicable, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Vector, derivative, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.compiled import entries_of
from rbpsym.mechanics.numbers import bound, number, sample
from rbpsym.mechanics.placing import stated_place, straight, where_in
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.quantities import LENGTH, NUMBER
from rbpsym.statement.model import Coordinate, Element, PointRef, Problem

Point = tuple[float, float]
LEAST_ANGLE, SHOWN_ANGLE, LEAST_SHARE = 0.3, 0.6, 0.2
DRIVEN_ANGLE = 0.9
ROUNDS = 30
HALVINGS = 5
FLAT = 1e-9  # of a row: less is nothing new


class DrawnPose(Frozen, eq=False):
    """A study with the numbers of the pose in which it is drawn; `given` replaces some of them."""

    study: Study
    given: Mapping[str, float] = field(default_factory=dict)
    numbers: Mapping[str, float] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "numbers", self._tied(drawn_numbers(self.study.problem) | dict(self.given)))

    def _tied(self, numbers: dict[str, float]) -> dict[str, float]:
        system = self.study.system
        if system.implicit and not system.independent and "t" not in self.given:
            numbers = numbers | {"t": shown_time(system, numbers)}
        numbers = numbers | {n: number(v, numbers) for n, v in system.dependent.items()}
        return fitted(system, numbers) if system.implicit else self._come_to(numbers)

    def _come_to(self, numbers: dict[str, float]) -> dict[str, float]:
        """Nearer and nearer to the start, as long as the motion from there does not come so far."""
        system = self.study.system
        known = {} if self.study.at_start or len(system.independent) != 1 else self.study.squares
        for name, square in known.items():
            begun = math.nan if name in self.given else at(system.scope.start.get(name, symbol(name)), numbers)
            for _ in range(HALVINGS):
                if not at(square, numbers) < 0 or math.isnan(begun):
                    break
                numbers |= {name: (numbers[name] + begun) / 2}
            numbers |= {n: number(v, numbers) for n, v in system.dependent.items()}
        return numbers

    @cached_property
    def where(self) -> Callable[[PointRef], Vector]:
        """The position of a point of the statement."""
        return where_in(self.study.system)

    def value(self, found: Scalar) -> float:
        """The number of a scalar."""
        return number(found, self.numbers)

    def node(self, node: t.Node) -> float:
        """The number of a tree."""
        return self.value(scalar(node))

    def point(self, vector: Vector) -> Point:
        """The numbers of a vector."""
        return self.value(vector.x), self.value(vector.y)

    def ref(self, ref: PointRef) -> Point:
        """Where a point of the statement is."""
        return self.point(self.where(ref))

    def center(self, body: str) -> Point:
        """The centre of mass of a body."""
        return self.point(self.study.system.bodies[body].center)

    @cached_property
    def size(self) -> float:
        """The largest size of a body, else the largest length among the parameters."""
        shapes = [body.shape for body in self.study.problem.bodies]
        sizes = [self.node(n) for shape in shapes for key, n in shape.sizes.items() if key in LENGTHS]
        sizes += [self.node(rim) for rims in self.rims.values() for rim in rims]
        known = [self.numbers[q.name] for q in self.study.problem.parameters if q.dimension == LENGTH]
        return max([*sizes, *([] if sizes else known)], default=1.0)

    @cached_property
    def rims(self) -> Mapping[str, tuple[t.Node, ...]]:
        """By body: the radii at which it touches or carries a string, other than those of its outline."""
        found: dict[str, list[t.Node]] = {body.name: [] for body in self.study.problem.bodies}
        for body, radius in touched_radii(self.study.problem):
            own = [self.node(size) for key, size in self.study.problem.body(body).shape.sizes.items() if key in RADII]
            known = [*own, *(self.node(other) for other in found[body])]
            if all(abs(self.node(radius) - other) > 1e-9 for other in known):
                found[body].append(radius)
        return {name: tuple(sorted(rims, key=self.node)) for name, rims in found.items() if rims}

    def slope(self, body: str, coordinate: str) -> float | None:
        """How fast a body's angle grows with a coordinate; None if not at a constant rate."""
        found = derivative(self.study.system.bodies[body].pose.angle, coordinate).number()
        return None if found is None else float(found)

    def reactions(self) -> dict[str, float]:
        """The unknown forces of the motion in this pose, as far as they have numbers."""
        found = {}
        for name, value in self.study.solved.reactions.items():
            with suppress(RbpsymError, ZeroDivisionError):
                found[name] = self.value(value)
        return found


def shown_time(system: System, numbers: Mapping[str, float]) -> float:
    """A moment at which what is driven has turned by an angle that is seen."""
    angles = [
        c.name for c in system.problem.coordinates if c.quantity.dimension == NUMBER and c.name in system.dependent
    ]
    for name in angles:
        now, soon = (number(system.dependent[name], {**numbers, "t": t}) for t in (0.0, 1e-6))
        if abs(soon - now) > 1e-12:
            return DRIVEN_ANGLE / abs(soon - now) * 1e-6
    return numbers.get("t", 0.0)


def fitted(system: System, numbers: dict[str, float]) -> dict[str, float]:
    """The nearest numbers with which the conditions that stay as equations hold (Newton's method); what depends follows."""
    free = [name for name in system.coordinates if name not in system.independent] or list(system.coordinates)
    rows = [(one.value, [derivative(one.value, name) for name in free]) for one in system.implicit]
    for _ in range(ROUNDS):
        gaps = [number(value, numbers) for value, _ in rows]
        slopes = [[number(slope, numbers) for slope in all_] for _, all_ in rows]
        moves = shortest(slopes, gaps)
        numbers |= {name: numbers[name] - move for name, move in zip(free, moves, strict=True)}
        numbers |= {n: number(v, numbers) for n, v in system.dependent.items()}
    return numbers


def shortest(rows: list[list[float]], wanted: list[float]) -> list[float]:
    """The shortest vector whose products with the rows are those wanted; rows that say nothing new are left out."""
    kept: list[tuple[list[float], float]] = []  # at right angles to each other, of length 1
    for row, value in zip(rows, wanted, strict=True):
        rest, size = list(row), math.hypot(*row)
        for other, known in kept:
            along = sum(a * b for a, b in zip(rest, other, strict=True))
            rest, value = [a - along * b for a, b in zip(rest, other, strict=True)], value - along * known
        if (length := math.hypot(*rest)) > FLAT * size:
            kept.append(([a / length for a in rest], value / length))
    return [sum(row[k] * value for row, value in kept) for k in range(len(rows[0]))]


RADII = ("radius", "outer", "inner")
LENGTHS = (*RADII, "length", "width", "height", "base")


def touched_radii(problem: Problem) -> Iterator[tuple[str, t.Node]]:
    """(body, radius) of all that touches or runs round a body."""
    for element in problem.constraints:
        if element.values.get("rim") is not None:
            yield element["body"], element["rim"]
        circle = element.values.get("circle")
        if circle is not None and circle.body is not None:
            yield circle.body, element["radius"]
        for turn in element.values.get("path") or ():
            if turn.body is not None and turn.sense:
                yield turn.body, turn.radius


def other_numbers(pose: DrawnPose) -> DrawnPose:
    """The same pose with other numbers: what is equal in both is equal by no chance."""
    problem = pose.study.problem
    fixed = [q.name for q in problem.parameters]
    names = [*fixed, *(c.name for c in problem.coordinates)]
    factors = {name: 1.0 - 0.037 * ((place * 5) % 7 + 1) for place, name in enumerate(names)}
    return DrawnPose(pose.study, {n: (pose.numbers[n] or 0.3 * (n in fixed)) * factor for n, factor in factors.items()})


def drawn_numbers(problem: Problem) -> dict[str, float]:
    """The sample of a problem; angles and displacements too small to be seen are opened.

    Where something strikes at the start, the bodies stand as they do then.
    """
    numbers = sample(problem, problem.example)
    if problem.phases and problem.phases[0].event == "at once":
        starts = {c.name: bound(c.start, numbers) for c in problem.coordinates}
        return numbers | {name: value for name, value in starts.items() if value is not None}
    _open_displacements(problem, numbers)
    for coordinate in problem.coordinates:
        if coordinate.quantity.dimension == NUMBER and abs(numbers[coordinate.name]) < LEAST_ANGLE:
            numbers[coordinate.name] = _opened(coordinate, numbers)
    _spread_angles(problem, numbers)
    return numbers


def _spread_angles(problem: Problem, numbers: dict[str, float]) -> None:
    """Two angles that are equal by chance would hide that they are two."""
    seen: list[float] = []
    apart = 0.45 if any(map(_joins, problem.constraints)) else -0.35
    for coordinate in problem.coordinates:
        if coordinate.quantity.dimension == NUMBER:
            here = numbers[coordinate.name]
            if any(abs(here - other) < 0.1 for other in seen):
                numbers[coordinate.name] = _shown(coordinate, numbers, here + apart)
            seen.append(numbers[coordinate.name])


def _open_displacements(problem: Problem, numbers: dict[str, float]) -> None:
    """Displacements that are drawn get sizes that are seen; bodies that would hide each other stand apart."""
    size = _extent(problem, numbers)
    moving = [c for c in problem.coordinates if c.quantity.dimension == LENGTH]
    hidden = len(moving) > 1 and len(moving) == len(problem.bodies) and not any(map(_joins, problem.constraints))
    for coordinate in moving:
        if hidden and all(numbers[c.name] == numbers[coordinate.name] for c in moving):
            continue
        if _is_plain(coordinate, problem) and abs(numbers[coordinate.name]) < LEAST_SHARE * size:
            numbers[coordinate.name] = _shown(coordinate, numbers, size * (1.2 if len(problem.bodies) == 1 else 0.5))
        elif None in (coordinate.lower, coordinate.upper) and coordinate.lower is not coordinate.upper:
            numbers[coordinate.name] = _shown(coordinate, numbers, 0.6 * size)
    if hidden and len({numbers[c.name] for c in moving}) == 1:
        numbers |= {c.name: 1.3 * size * place for place, c in enumerate(moving)}


def _extent(problem: Problem, numbers: Mapping[str, float]) -> float:
    """The largest length, radii counted twice."""
    round_ones = [s for b in problem.bodies for key, s in b.shape.sizes.items() if key in RADII]
    doubled = {node.name for node in round_ones if isinstance(node, t.Sym)}
    lengths = [q.name for q in problem.parameters if q.dimension == LENGTH]
    return max([numbers[name] * (2 if name in doubled else 1) for name in lengths], default=1.0)


def _joins(element: Element) -> bool:
    """Does it join two bodies?"""
    ends = [turn.body for turn in element.values.get("path") or () if turn.body]
    return element.kind in ("pin", "weld") or len(ends) > 1 or bool(element.values.get("of"))


def _is_plain(coordinate: Coordinate, problem: Problem) -> bool:
    """Is it a way of a body along a straight line, with no string that ties it to others?"""
    if any(element.kind == "string" for element in problem.constraints):
        return False
    return any(straight(place, coordinate.name) for body in problem.bodies if (place := stated_place(body)))


def _shown(coordinate: Coordinate, numbers: Mapping[str, float], wanted: float) -> float:
    low, high = _range(coordinate, numbers)
    return max(wanted if wanted < high else 0.5 * (max(low, 0.0) + high), low)


def _opened(coordinate: Coordinate, numbers: Mapping[str, float]) -> float:
    """An angle that is seen and lies in the coordinate's range."""
    low, high = _range(coordinate, numbers)
    return min(max(SHOWN_ANGLE, low), high) if low <= high else SHOWN_ANGLE


def _range(coordinate: Coordinate, numbers: Mapping[str, float]) -> tuple[float, float]:
    """The ends of a coordinate's range; infinite where there are none."""
    low, high = (bound(end, numbers) for end in (coordinate.lower, coordinate.upper))
    return -math.inf if low is None else low, math.inf if high is None else high


# --- how a system begins to move, in plain numbers, from the accelerations that were derived; or why there is no motion
# Conditions that stay as equations hold at the start and are kept by the rates.


STILL = 1e-9
SOON = 1e-4

REASONS = {  # why there is no motion that can be followed
    "statics": "nothing moves: it is a problem of statics",
    "tied": "the speeds are tied by a condition that is no condition on the places",
    "no_start": "the statement does not say where the motion starts",
    "rest": "nothing moves",
    "at_start": "the motion is known at its start alone",
}


def at(value: Scalar, numbers: Mapping[str, Any]) -> float:
    """A quantity at one moment; not a number where it has none."""
    with suppress(NoNumber):
        return float(number(value, numbers))
    return math.nan


def reactions(study: Study) -> dict[str, Scalar]:
    """The unknown forces: along the motion where they are known so, else as functions of the state."""
    return {**study.dynamics.reactions, **(study.reactions_along_motion or {})}


def require_motion(study: Study) -> None:
    """Raises NotApplicable if there is no motion that could be followed."""
    system = study.system
    if not study.problem.coordinates:
        raise NotApplicable(REASONS["statics"])
    if study.at_start:
        raise NotApplicable(REASONS["at_start"])
    if system.speed_ties:
        raise NotApplicable(REASONS["tied"])
    if any(name not in system.scope.start for name in system.independent):
        raise NotApplicable(REASONS["no_start"])


class Defined(dict[str, float]):
    """Numbers by name; what is defined by a formula is worked out when it is asked for."""

    def __init__(self, numbers: Mapping[str, float], formulas: Mapping[str, Scalar]) -> None:
        super().__init__(numbers)
        self.formulas = formulas

    def __missing__(self, name: str) -> float:
        self[name] = number(self.formulas[name], self)
        return self[name]


class Moving(Frozen):
    """A system with numbers for its parameters: its state at the start, how that changes, and all numbers of a state."""

    study: Study
    given: Mapping[str, float]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What a state consists of."""
        return (*self.study.system.coordinates, *self.study.system.speeds, "t")

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """The coordinates that are shown: the independent ones, or all where everything is driven."""
        return tuple(self.study.system.independent) or tuple(c.name for c in self.study.problem.coordinates)

    @cached_property
    def sizes(self) -> dict[str, float]:
        """What a far way is for each coordinate: a radian, or a length of the problem."""
        lengths = [q.name for q in self.study.problem.parameters if q.dimension == LENGTH and self.given.get(q.name)]
        length = abs(self.given[lengths[0]]) if lengths else 1.0
        kinds = {c.name: c.quantity.dimension for c in self.study.problem.coordinates}
        return {name: 1.0 if kind == NUMBER else length for name, kind in kinds.items()}

    def numbers(self, state: Any) -> dict[str, Any]:
        """All numbers of a state. Raises NoNumber where one has no value."""
        formulas = self.study.system.defined
        found = Defined({**self.given, **dict(zip(self.names, state, strict=True))}, formulas)
        for name in formulas:
            found[name]
        return found

    def with_forces(self, state: Any) -> dict[str, Any]:
        """The same with the unknown forces."""
        numbers = self.numbers(state)
        return {**numbers, **{name: at(value, numbers) for name, value in reactions(self.study).items()}}

    def rate(self, _: float, state: Any) -> Any:
        """Speeds and accelerations."""
        numbers, system = self.numbers(state), self.study.system
        entries, size = [number(value, numbers) for value in entries_of(self.study)], len(system.speeds)
        mass = [entries[k * size : (k + 1) * size] for k in range(size)]
        gains = shortest(mass, entries[size * size : size * size + size]) if mass else []
        return [*(numbers[f"{name}_dot"] for name in system.coordinates), *gains, 1.0]

    def after(self, state: Any, time: float) -> Any:
        """The state a short time later."""
        return [value + time * rate for value, rate in zip(state, self.rate(0.0, state), strict=True)]

    def start(self) -> Any:
        """Where the motion starts; what the author left open is where the conditions that stay want it."""
        scope, still = self.study.system.scope.start, dict.fromkeys((*self.study.system.speeds, "t"), 0.0)
        found = {**sample(self.study.problem), **self.given, **still}
        found |= {name: at(scope[name], self.given) for name in self.names if name in scope}
        if self.study.system.implicit:
            found = fitted(self.study.system, found)
        state: Sequence[float] = [found[name] for name in self.names]
        if not all(map(math.isfinite, state)):
            raise NotApplicable("the start has no numbers")
        return state

    def pace(self, state: Any) -> float:
        """The time in which the fastest coordinate moves by its size; infinite if nothing moves."""
        now, soon = self.numbers(state), self.numbers(self.after(state, SOON))
        paces = [math.inf]
        for name in self.shown:
            speed = now[f"{name}_dot"] / self.sizes[name]
            gain = (soon[f"{name}_dot"] - now[f"{name}_dot"]) / SOON / self.sizes[name]
            paces += [1 / abs(speed)] if abs(speed) > STILL else []
            paces += [math.sqrt(1 / abs(gain))] if abs(gain) > STILL else []
        return min(paces)
