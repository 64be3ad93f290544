"""From a statement to a `System`: poses, conditions, velocities, accelerations and forces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from rbpsym.errors import StatementError, Undecided, there
from rbpsym.field import NOTHING, ONE, UNITY, Scalar, Vector, depends_on, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.field.evaluate import Meanings, scalar, time_derivative
from rbpsym.mechanics.conditions import CLOCK, contradiction
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.geometry import Geometry, start_numbers, unsaid
from rbpsym.mechanics.inertia import Inertia, inertia
from rbpsym.mechanics.interactions import LAWS, LawSetting
from rbpsym.mechanics.numbers import number, sample, samples
from rbpsym.mechanics.placing import locator, open_names, poses, still_open
from rbpsym.mechanics.system import BodyState, ConstraintCondition, Force, Pose, System, at_point
from rbpsym.mechanics.tying import Tied, placed_by, tie
from rbpsym.present.forms import present
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Coordinate, PointRef, Problem
from rbpsym.statement.premises import declared
from rbpsym.typeset.machine import to_machine

CLOSE = 1e-7  # at sample numbers, which are near 1


def assemble(problem: Problem, *, free: bool = False) -> System:
    """Kinematics and forces of a problem; with `free`, what no condition solves for stays free: no speed is solved for.

    Raises StatementError if the poses can't be or contradict.
    """
    inertias = {body.name: inertia(body) for body in problem.bodies}
    given = poses(problem, inertias)
    names = (*_by_preference(problem), *open_names(given))
    try:
        tied = tie(problem, inertias, given, names)
        system = _assembled(problem, inertias, given, tied, free=free)
        if any(state.pose.angle.den is not ONE and depends_on(state.pose.angle, CLOCK) for state in system.bodies.values()):
            raise Undecided("an angle that the time leads is a quotient with a sum below")
    except Undecided:  # an angle that others lead may hold a sum in its denominator: it leads them
        tied = tie(problem, inertias, given, names, is_whole=True)
        system = _assembled(problem, inertias, given, tied, free=free)
    while not (tied.implicit or tied.speeds) and (balanced := _balanced(system)):
        solved = {name: substitute(value, balanced) for name, value in tied.solved.items()} | balanced
        tied = replace(tied, solved=solved)
        system = _assembled(problem, inertias, given, tied, free=free)
    return system


def _assembled(problem: Problem, inertias: Mapping[str, Inertia], given: Mapping[str, Pose], tied: Tied, *, free: bool) -> System:
    placed = {name: _settled(pose, tied.solved) for name, pose in given.items()}
    left = open_names(placed)
    if left:
        raise still_open(problem, left[0])
    names = tuple(c.name for c in problem.coordinates if c.name not in tied.solved)
    solved = {c.name: tied.solved[c.name] for c in problem.coordinates if c.name in tied.solved}
    _refuse_frozen(problem, tied.implicit, names)
    scope, independent = _rates(names, tied, problem, free=free)
    scope = with_clock(scope, problem, placed, tied.implicit)
    states = {name: moving(name, inertias[name], placed[name], scope) for name in problem.body_names}
    bare = System(problem, names, solved, states, (), tied.conditions, tied.implicit, scope, independent, tied.speeds)
    _check_starts(bare)
    _check_start_speeds(bare)
    return with_forces(bare, locator(problem, inertias, placed))


def _balanced(system: System) -> dict[str, Scalar]:
    """A coordinate that moves nothing but what has no mass, such as the joint of two springs: it is where the forces on that
    balance, which are linear in it."""
    for name in system.independent:
        speed, push = f"{name}_dot", NOTHING
        ways = {state.name: state.velocity.derivative(speed) for state in system.bodies.values()}
        moved = [state for state in system.bodies.values() if ways[state.name] or derivative(state.omega, speed)]
        if any(state.mass or state.moment for state in moved):
            continue
        for state in moved:
            turn = derivative(state.omega, speed)
            push += sum((f.vector.dot(ways[state.name]) + f.torque(state.center) * turn for f in system.on(state.name)), NOTHING)
        slope = short(derivative(push, name))
        if slope and not names_in(slope) & {*system.scope.rates, *system.speeds} and not names_in(push) & {*system.speeds}:
            return {name: short(-substitute(push, {name: NOTHING}) / slope)}
    return {}


def with_clock(scope: Meanings, problem: Problem, placed: Mapping[str, Pose], tied: Iterable[ConstraintCondition]) -> Meanings:
    """The time runs where something depends on it explicitly."""
    values = [condition.value for condition in tied]
    values += [v for pose in placed.values() for v in (pose.angle, pose.origin.x, pose.origin.y)]
    values += [scalar(node) for e in problem.interactions for node in e.nodes]
    if not any(depends_on(value, CLOCK) for value in values):
        return scope
    return replace(scope, rates={**scope.rates, CLOCK: UNITY}, start={**scope.start, CLOCK: NOTHING})


def _check_starts(system: System) -> None:
    """A start that a constraint ties to others must agree with them."""
    for coordinate in system.problem.coordinates:
        value = system.dependent.get(coordinate.name)
        free = getattr(coordinate.start, "name", None) in system.problem.implicit  # whatever it is
        if value is None or coordinate.start is None or free:
            continue
        gap = substitute(value, system.scope.start) - scalar(coordinate.start)
        if any(depends_on(gap, name) for name in (*system.coordinates, CLOCK)) or is_zero(gap):
            continue
        if abs(number(gap, sample(system.problem))) > CLOSE:
            raise StatementError(
                f"the start of “{coordinate.name}” contradicts the constraints: they do not hold where the bodies are",
                instead="leave it out, for they tie it to the other coordinates, or mend a place in them.",
                place=coordinate.place,
            )


def _check_start_speeds(system: System) -> None:
    """A start speed that a constraint ties to others must agree with them."""
    for coordinate in system.problem.coordinates:
        if coordinate.name in system.independent or coordinate.speed is None or not scalar(coordinate.speed):
            continue
        rate = system.scope.rates.get(coordinate.name)
        if rate is None:
            rate = time_derivative(system.dependent[coordinate.name], system.scope)
        gap = substitute(rate, system.scope.start) - scalar(coordinate.speed)
        if not is_zero(gap) and not abs(number(gap, sample(system.problem))) <= CLOSE:
            raise StatementError(
                f"the start speed of “{coordinate.name}” contradicts the constraints, which tie it to the other speeds",
                instead="leave it out, or give that of the other coordinate.",
                place=coordinate.place,
            )


def _by_preference(problem: Problem) -> tuple[str, ...]:
    """Coordinates that are best kept come first: those with a start and a start speed, angles."""

    def rank(c: Coordinate) -> tuple[bool, bool, bool]:
        return (c.start is None, not _moves(c), c.quantity.dimension.length != 0)

    return tuple(c.name for c in sorted(problem.coordinates, key=rank))


def _moves(c: Coordinate) -> bool:
    """Whether a speed is stated with which it starts."""
    return c.speed is not None and bool(scalar(c.speed))


def _settled(pose: Pose, solved: Mapping[str, Scalar]) -> Pose:
    if not solved:
        return pose
    return Pose(pose.origin.substitute(solved), substitute(pose.angle, solved))


def _refuse_frozen(problem: Problem, implicit: tuple[ConstraintCondition, ...], free: tuple[str, ...]) -> None:
    """As many implicit conditions as coordinates would leave no motion, unless one holds the time: then it drives."""
    for condition in implicit:
        used = [name for name in free if depends_on(condition.value, name)]
        if len(used) < (1 if depends_on(condition.value, CLOCK) else 2):
            element = next(e for e in problem.constraints if e.name == condition.constraint)
            raise contradiction(condition, element, to_machine(present(condition.value)))


def _rates(names: tuple[str, ...], tied: Tied, problem: Problem, *, free: bool) -> tuple[Meanings, tuple[str, ...]]:
    """Time derivatives of coordinates and speeds; dependent speeds from the implicit conditions, unless all stay free."""
    speeds = {name: symbol(f"{name}_dot") for name in names}
    dependent = _dependent_speeds(names, tied, problem) if (tied.implicit or tied.speeds) and not free else {}
    independent = tuple(name for name in names if f"{name}_dot" not in dependent)
    rates = {name: dependent.get(f"{name}_dot", speed) for name, speed in speeds.items()}
    rates |= {f"{name}_dot": symbol(f"{name}_ddot") for name in independent}
    start = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None and c.name in names}
    start |= _tied_starts(names, tied, problem, start)
    led = sorted((c for c in problem.coordinates if c.name in tied.solved and c.speed is not None), key=_moves)
    leads = [(n, c) for c in led for n in independent if names_in(tied.solved[c.name]) & {*names} == {n}]
    at = {**start, CLOCK: NOTHING}
    slopes = {n: [substitute(derivative(tied.solved[c.name], by), at) for by in (n, CLOCK)] for n, c in leads}
    start |= {f"{n}_dot": (scalar(there(c.speed)) - slopes[n][1]) / slopes[n][0] for n, c in leads if slopes[n][0]}
    told = {f"{c.name}_dot": scalar(c.speed) for c in problem.coordinates if c.speed is not None and c.name in independent}
    start |= {speed: value for speed, value in told.items() if value or speed not in start}  # 0 where nothing is said
    return Meanings(rates=rates, start=start), independent


def _tied_starts(names: tuple[str, ...], tied: Tied, problem: Problem, start: dict[str, Scalar]) -> dict[str, Scalar]:
    """Where coordinates begin of which only their range is said, and conditions that tie them to those that are stated leave
    one place there, whatever the parameters are."""
    given = declared(problem.parameters).assumptions
    for c in problem.coordinates:
        if c.start is None and c.lower and c.upper:
            given = given.with_range(c.name, scalar(c.lower), scalar(c.upper))
    led = [c for c in problem.coordinates if c.name in tied.solved and c.start is not None]
    told = (ConstraintCondition("", tied.solved[c.name] - scalar(there(c.start)), "") for c in led)
    return placed_by((*tied.implicit, *told), names, {**start, CLOCK: NOTHING}, given)


def _dependent_speeds(free: Sequence[str], tied: Tied, problem: Problem) -> dict[str, Scalar]:
    """Speeds that the conditions fix, solved in terms of the others; last those that they do not fix at the start."""
    rows = [condition.value for condition in tied.speeds]
    for condition in tied.implicit:
        parts = (derivative(condition.value, n) * symbol(f"{n}_dot") for n in free)
        rows.append(sum(parts, derivative(condition.value, CLOCK)))
    start = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    loose = {name for name in free if all(is_zero(substitute(derivative(row, f"{name}_dot"), start)) for row in rows)}
    ranks = {f"{c.name}_dot": (c.name in loose, c.start is not None, _moves(c)) for c in problem.coordinates}
    unknowns = tuple(f"{name}_dot" for name in reversed(_by_preference(problem)) if name in free)
    return solve_linear(rows, unknowns, keep_free=True, ranks=ranks).values


def moving(name: str, own: Inertia, pose: Pose, scope: Meanings) -> BodyState:
    """A body in motion, by the rates of what its pose holds."""
    center = at_point(pose, (own.x, own.y)) if own.x or own.y else pose.origin
    velocity = vector_rate(center, scope)
    omega = time_derivative(pose.angle, scope)
    return BodyState(name, own, pose, center, velocity, omega, vector_rate(velocity, scope), time_derivative(omega, scope))


def vector_rate(vector: Vector, scope: Meanings) -> Vector:
    """d/dt of a plane vector."""
    return vector.rate(scope.rates)


def setting_of(system: System, where: Callable[[PointRef], Vector]) -> LawSetting:
    """What the laws of force may look at."""
    numbers = sample(system.problem)
    numbers |= {n: number(v, numbers) for n, v in system.dependent.items()}
    every = (*system.coordinates, *system.dependent)
    names = [*every, *(f"{n}_dot" for n in every), "t"]

    def is_positive(value: Scalar) -> bool | None:
        found = number(value, numbers)
        return None if abs(found) < CLEAR else (_sure_sense(system.problem, value) or found) > 0

    return LawSetting(
        where,
        lambda ref: vector_rate(where(ref), system.scope),
        system.bodies,
        is_positive,
        Geometry(where, {}, start_numbers(system.problem)).sign,
        frozenset(name for element in system.problem.constraints for name in unknowns_of(element)),
        lambda value: not any(depends_on(value, name) for name in names),
    )


def _sure_sense(problem: Problem, value: Scalar) -> int:
    """The sign of a length at the start, where that does not hang on the sizes of parameters; else that where all coordinates
    are zero, as displacements are small; 0 where this hangs on them too."""
    begun = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    for image in (begun, {c.name: NOTHING for c in problem.coordinates}):
        there = substitute(value, image)
        found = {(size > CLEAR) - (size < -CLEAR) for size in (number(there, each) for each in samples(problem, LOOKS))}
        if len(found) == 1 and 0 not in found:
            return found.pop()
    return 0


CLEAR, LOOKS = 1e-12, 8


def with_forces(system: System, where: Callable[[PointRef], Vector]) -> System:
    """The system with all forces that its elements exert; with none where masses are not stated, on which they hang."""
    if system.problem.unstated:
        return system
    setting = setting_of(system, where)
    placed = {name: state.pose for name, state in system.bodies.items()}
    geometry = Geometry(where, placed, start_numbers(system.problem), system.bodies, unsaid(system.problem))
    applied = [f for e in system.problem.interactions for f in LAWS[e.kind].forces(e, setting)]
    kept = [f for e in system.problem.constraints for f in JOINTS[e.kind].forces(e, geometry)]
    _refuse_two_meanings(system, (*applied, *kept))
    forces = tuple(_in_coordinates(force, system.dependent, system.scope) for force in (*applied, *kept))
    return replace(system, forces=forces)


def _refuse_two_meanings(system: System, forces: tuple[Force, ...]) -> None:
    """A force may be called like its size, F = F i: else F² would be the square of the one and of the other."""
    own = {q.name for q in system.problem.parameters} | {c.name for c in system.problem.coordinates}
    for force in forces:
        size = force.vector.dot(force.vector)
        if force.vector and force.name in own and not is_zero(size - symbol(force.name) ** 2):
            raise StatementError(
                f"“{force.name}” is a quantity, and a force that has not this size: what would {force.name}**2 be?",
                instead="give one of them another name.",
                place=system.element(force.name).place,
            )


def _in_coordinates(force: Force, solved: Mapping[str, Scalar], scope: Meanings) -> Force:
    """The same force in the independent coordinates and speeds."""
    images = dict(solved)
    images |= {f"{name}_dot": time_derivative(value, scope) for name, value in solved.items()}
    if not images:
        return force
    return Force(
        force.name,
        force.on,
        force.by,
        force.point.substitute(images),
        force.vector.substitute(images),
        substitute(force.couple, images),
        force.unknowns,
        force.law,
        force.where,
    )
