"""What the constraints ask of the given poses and speeds: proved, solved for a coordinate, or kept as equations.

Conditions for the speeds are no slip and taut strings; those that are rates of a position are integrated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError, there
from rbpsym.field import ONE, Vector, atoms, depends_on, derivative, has_roots, is_zero, short, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.integration import antiderivative
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, symbol
from rbpsym.mechanics.constraints import JOINTS, AngleJoin
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.numbers import floating, number, sample
from rbpsym.mechanics.roots import factor_zeros, factors_in, period, zeros
from rbpsym.mechanics.system import ConstraintCondition, Force, Pose
from rbpsym.quantities import NUMBER
from rbpsym.statement.model import Coordinate, Element, PointRef, Problem
from rbpsym.statement.premises import declared

CLOCK, RATE = "t", "rate"


def rate_conditions(problem: Problem, geometry: Geometry) -> list[ConstraintCondition]:
    """The conditions of all constraints that are linear in the speeds, at the states of `geometry`."""
    return [c for element in problem.constraints for c in _condition_of(element, geometry)]


def _condition_of(element: Element, geometry: Geometry) -> list[ConstraintCondition]:
    joint = JOINTS[element.kind]
    wanted = joint.rates(element, geometry)
    forces = joint.forces(element, geometry) if wanted else ()
    return [
        ConstraintCondition(element.name, short(factor * _power_of_unit(forces, name, geometry)), RATE)
        for name, factor in wanted
    ]


def _power_of_unit(forces: Sequence[Force], name: str, geometry: Geometry) -> Scalar:
    """Σ F·v for the unknown force at 1."""
    total = NOTHING
    for force in forces:
        push = force.vector.derivative(name)
        if push:
            total = total + push.dot(geometry.velocity(force.on, force.point))
    return total


def integrated(value: Scalar, names: Sequence[str]) -> Scalar | None:
    """F(q, t) with dF/dt = value; None if there is none in the class of `antiderivative`."""
    slopes = {name: derivative(value, f"{name}_dot") for name in names}
    slopes[CLOCK] = substitute(value, {f"{name}_dot": NOTHING for name in names})
    slopes = {name: slope for name, slope in slopes.items() if not is_zero(slope)}
    total = NOTHING
    for name, slope in slopes.items():
        rest = short(slope - derivative(total, name))
        part = antiderivative(rest, name) if rest else NOTHING
        if part is None:
            return None
        total = total + part
    wanted = (slopes.get(name, NOTHING) - derivative(total, name) for name in (*names, CLOCK))
    return total if all(map(is_zero, wanted)) else None


def from_start(value: Scalar, names: Sequence[str], start: Mapping[str, Scalar]) -> Scalar:
    """F - F(start) if all coordinates in it have a declared start; else F: the others count from there."""
    used = [name for name in names if depends_on(value, name)]
    if not all(name in start for name in used):
        return value
    return short(value - substitute(value, {name: start[name] for name in used} | {CLOCK: NOTHING}))


def full_rates(names: Sequence[str]) -> dict[str, Scalar]:
    """Rates of coordinates whose speeds are all free, and of the time."""
    return {name: symbol(f"{name}_dot") for name in names} | {CLOCK: UNITY}


def all_conditions(problem: Problem, geometry: Geometry) -> tuple[ConstraintCondition, ...]:
    """Every scalar condition on the position, as `value = 0`, in the poses as given: where coordinates are led, then those of
    every constraint."""
    given = declared(problem.parameters).assumptions
    led = (ConstraintCondition(name, symbol(name) - scalar(place), "led") for name, place in problem.led.items())
    found = (*led, *(c for element in problem.constraints for c in _of(element, problem, geometry)))
    # √((a² + h²)/a²), of an angle atan(h/a), is √(a² + h²)/a by the declared signs
    return tuple(replace(c, value=neat(c.value, given)) if has_roots(c.value) else c for c in found)


def _of(element: Element, problem: Problem, geometry: Geometry) -> list[ConstraintCondition]:
    joint, found, where, placed = JOINTS[element.kind], [], geometry.where, geometry.poses
    for first, second in joint.joins(element):
        found += _meeting(element, first, where(second), where, problem)
    for join in joint.angles(element):
        found.append(ConstraintCondition(element.name, _turned(join, placed, problem), "angle"))
    for touch in joint.touches(element):
        at, line = where(touch.point), touch.line
        value = scalar(line.a) * at.x + scalar(line.b) * at.y - scalar(line.c)
        found.append(ConstraintCondition(element.name, value, "line"))
    return found + [ConstraintCondition(element.name, value, what) for value, what in joint.gaps(element, geometry)]


def _meeting(
    element: Element, first: PointRef | None, second: Vector, where: Callable[[PointRef], Vector], problem: Problem
) -> list[ConstraintCondition]:
    """Two points in one place; a pivot without a place holds its point where the pose has it."""
    if first is None:
        moving = [c.name for c in problem.coordinates if second.derivative(c.name)]
        if not all(second.derivative(name).vanishes() for name in moving):
            raise StatementError(
                f"the pivot “{element.name}” holds {element['point'].label}, but in the given pose that "
                f"point moves with {moving[0]}",
                instead='pivot a point that stays in place, or say where it is held: at = ["0", "0"].',
                place=element.place,
            )
        return [ConstraintCondition(element.name, NOTHING, what) for what in "xy"]
    difference = second - where(first)
    if not difference:
        return [ConstraintCondition(element.name, NOTHING, what) for what in "xy"]
    return [ConstraintCondition(element.name, difference.x, "x"), ConstraintCondition(element.name, difference.y, "y")]


def _turned(join: AngleJoin, placed: Mapping[str, Pose], problem: Problem) -> Scalar:
    turn = placed[join.second].angle - (placed[join.first].angle if join.first else NOTHING)
    if join.offset is not None:
        return turn - join.offset
    start = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    return turn - substitute(turn, start) if start else NOTHING


def solve_explicitly(
    conditions: tuple[ConstraintCondition, ...], names: tuple[str, ...], problem: Problem, *, is_whole: bool = False
) -> tuple[dict[str, Scalar], tuple[ConstraintCondition, ...]]:
    """(dependent coordinates in terms of the others, conditions that stay implicit).

    A condition is solved for the last-named coordinate in which it is linear with a coefficient
    that does not depend on coordinates; with `is_whole` in no angle that is a quotient with a sum below, of which there is no
    sine. A condition on one coordinate alone, such as
    L sin φ = 0, holds that one where it is.
    """
    solved: dict[str, Scalar] = {}
    angles = {c.name for c in problem.coordinates if is_whole and c.quantity.dimension == NUMBER}
    waiting, before = list(conditions), None
    while waiting and len(waiting) != before:  # what is solved may leave one coordinate in a condition that stood before it
        before, left = len(waiting), []
        for condition in waiting:
            value = substitute(condition.value, solved)
            if is_zero(value):
                continue
            linear = (n for n in reversed(names) if n not in solved and _is_linear(value, n, names))
            name = next((n for n in linear if n not in angles or _linear_zero(value, n).den is ONE), None)
            image = _held(value, names, problem) if name is None else _linear_zero(value, name)
            if image is None:
                left.append(ConstraintCondition(condition.constraint, value, condition.what))
                continue
            name = name or _names_in(value, names)[0]
            solved = {n: substitute(old, {name: image}) for n, old in solved.items()} | {name: image}
        waiting = left
    return solved, tuple(waiting)


def _is_linear(value: Scalar, name: str, names: tuple[str, ...]) -> bool:
    slope = derivative(value, name)
    return bool(slope) and not is_zero(slope) and not any(depends_on(slope, other) for other in names)


def _linear_zero(value: Scalar, name: str) -> Scalar:
    return substitute(value, {name: NOTHING}) / derivative(value, name) * -1


def _names_in(value: Scalar, names: tuple[str, ...]) -> list[str]:
    return [name for name in names if depends_on(value, name)]


def _held(value: Scalar, names: tuple[str, ...], problem: Problem) -> Scalar | None:
    """Where a condition on one coordinate of several holds it: the zero that is nearest to 0 of those
    that its range allows, or its start if it has one. None if it does not hold there."""
    used = _names_in(value, names)
    coordinate = next((c for c in problem.coordinates if [c.name] == used), None)
    if coordinate is not None and coordinate.start is None and depends_on(value, CLOCK):
        return _driven(value, coordinate, declared(problem.parameters).assumptions)
    if coordinate is not None and coordinate.start is not None:
        return _held_at_start(value, coordinate)
    if coordinate is None or len(names) < 2:
        return None
    numbers = sample(problem)
    each = ((floating(zero, numbers), zero) for zero in zeros(value, coordinate.name))
    places = [(at, zero) for at, zero in each if at == at and _is_allowed(at, coordinate, numbers)]
    return min(places, key=lambda item: abs(item[0]))[1] if places else None


def _driven(value: Scalar, coordinate: Coordinate, given: Assumptions) -> Scalar | None:
    """Where a condition that runs with the time puts a coordinate. None if that is not decided, and where it is an angle of a
    quotient with a sum below: its rates grow too long, it stays tied."""
    ends = tuple(None if end is None else scalar(end) for end in (coordinate.lower, coordinate.upper))
    place = None if ends == (None, None) else only_place(value, coordinate.name, (ends[0], ends[1]), given)
    args = [] if place is None else [atoms.atom(index).arg for index in place.atoms()]
    return place if all(getattr(arg, "den", ONE) is ONE for arg in args) else None


def only_place(value: Scalar, name: str, ends: tuple[Scalar | None, Scalar | None], given: Assumptions) -> Scalar | None:
    """The only zero that may lie in a range, whatever the parameters are; None if that is not decided. What comes back after each
    turn needs both ends, a line none."""
    sides = [(end, way) for end, way in zip(ends, (1, -1), strict=True) if end is not None]
    if len(sides) < (0 if not depends_on(derivative(value, name), name) else 2 if period(value, name) else 1):
        return None
    if not all(factor_zeros(factor, name) for factor in factors_in(value, name)):
        return None  # a zero without a closed form may lie there, too
    gaps = [(zero, [sign((zero - end) * way, given) for end, way in sides]) for zero in zeros(value, name)]
    left = [item for item in gaps if not any(one.sense < 0 or one.kind == "zero" for one in item[1])]
    left = left or [item for item in gaps if "negative" not in {one.kind for one in item[1]}]
    return left[0][0] if len(left) == 1 and all(one.is_nonnegative for one in left[0][1]) else None


def _held_at_start(value: Scalar, coordinate: Coordinate) -> Scalar | None:
    """The start, if the condition holds there and nothing moves: it is held until a later phase."""
    start = scalar(there(coordinate.start))
    moves = coordinate.speed is not None and not is_zero(scalar(coordinate.speed))
    return None if moves or not is_zero(substitute(value, {coordinate.name: start})) else start


def _is_allowed(place: float, coordinate: Coordinate, numbers: Mapping[str, float]) -> bool:
    bounds = ((coordinate.lower, 1), (coordinate.upper, -1))
    return all(node is None or side * (place - number(scalar(node), numbers)) > -1e-9 for node, side in bounds)


def contradiction(condition: ConstraintCondition, element: Element, text: str) -> StatementError:
    """The sentence for a condition that the given poses can't satisfy while they move."""
    if condition.what in APART:
        return StatementError(
            f"{element.kind} “{element.name}”: in the given poses {' and '.join(_subjects(element))} "
            f"{APART[condition.what]} (that would ask for {text} = 0)",
            instead="change the place (center) of the body so that it does, or leave the place out: the constraint gives it.",
            place=element.place,
        )
    return StatementError(
        f"the constraint “{element.name}” ({element.kind} of {' and '.join(_subjects(element))}) contradicts the poses: "
        f"it asks for {text} = 0, which does not hold while the coordinates vary",
        instead="check the pose (center, angle) of the bodies that it joins, and which point it names.",
        place=element.place,
    )


APART = {"gap": "does not touch the curve", "length": "are not at the distance of the string's length"}


def _subjects(element: Element) -> list[str]:
    """The points and bodies that an element speaks of, as the author wrote them."""
    values = [element.values[key] for key in ("point", "points", "body", "path") if key in element.values]
    flat = [part for value in values for part in (value if isinstance(value, tuple) else (value,))]
    return [part if isinstance(part, str) else getattr(part, "center", part).label for part in flat]
