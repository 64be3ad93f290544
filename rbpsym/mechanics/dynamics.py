"""Equations of motion and unknown forces from Newton's and Euler's equations.

Newton-Euler gives three equations a body, linear in the accelerations and the unknown forces.
Taken along the velocities that the constraints allow (each equation dotted with ∂V/∂q̇ and
∂ω/∂q̇, and added), the forces of ideal constraints drop out, which is proved for each of them;
what is left is M q̈ = f. The unknown forces then follow from the equations of the single bodies.
Kleppner & Kolenkow, ch. 7; Goldstein, 1.4; the projection is Jourdain's (Kane's) principle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from math import prod

from rbpsym.errors import LimitError
from rbpsym.field import NOTHING, Scalar, Vector, at_most, derivative, is_zero, names_in, short, substitute, total
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen
from rbpsym.mechanics.elimination import CONSTANT, Matrix, Row, blocks, linear_row, solve_linear, solve_matrix, solve_rows
from rbpsym.mechanics.system import BodyState, Force, System
from rbpsym.mechanics.unsolvable import asking, contradictory, indistinct, is_nonzero, massless, unheld

Twist = tuple[Vector, Scalar]  # what a body has of its centre's motion and of its turning
Twists = Mapping[str, Twist]  # by body

LARGEST_BLOCK = 3  # coupled coordinates whose accelerations are always solved for
LARGEST_TRIED = 6  # up to so many they are where the formulas stay short
LONGEST = 60  # terms of a numerator that somebody may still read
FEW_PRODUCTS = 60_000
LARGEST_REACTION = 10_000  # products to multiply out: beyond, nobody reads the formula


class Dynamics(Frozen):
    """M q̈ = f (in coordinates and speeds); accelerations and reactions solved from it.

    `accelerations` is None where a coupled block is too large for closed formulas. `reactions`
    are in coordinates and speeds (and in accelerations, where these stay unsolved).
    `ideal` says of each force of a constraint whether it drops out of M q̈ = f; `workless` whether
    its whole power vanishes (that of an ideal force does unless a support is driven).
    """

    mass_matrix: Matrix
    forcing: tuple[Scalar, ...]
    accelerations: Mapping[str, Scalar] | None
    reactions: Mapping[str, Scalar]
    workless: Mapping[str, bool]
    ideal: Mapping[str, bool]


def torque_about_center(force: Force, state: BodyState) -> Scalar:
    """τ_cm of a force on its body, its couple included, counter-clockwise positive."""
    lever = force.point - state.center
    turning = lever.cross(force.vector) if lever and force.vector else NOTHING
    return turning + force.couple


def _partials(state: BodyState, speeds: tuple[str, ...]) -> tuple[Twist, ...]:
    moving: dict[str, Vector] = dict.fromkeys(speeds, Vector({}))
    for angle, length in state.velocity.parts.items():  # a direction depends on the position alone
        for speed in names_in(length) & moving.keys():
            moving[speed] = moving[speed] + Vector({angle: derivative(length, speed)})
    return tuple((moving[speed], derivative(state.omega, speed)) for speed in speeds)


def equations_of_motion(system: System) -> tuple[Matrix, tuple[Scalar, ...], dict[str, bool]]:
    """(M, f, which forces of constraints are ideal). Raises StatementError if a force needs M q̈ = f to be known."""
    partials = {name: _partials(state, system.speeds) for name, state in system.bodies.items()}
    ways = [{name: own[r] for name, own in partials.items()} for r in range(len(system.speeds))]
    resting = dict.fromkeys(system.accelerations, NOTHING)
    lower = [[short(_inertia(system, way, other)) for other in ways[: r + 1]] for r, way in enumerate(ways)]
    mass = tuple(tuple(lower[max(r, s)][min(r, s)] for s in range(len(lower))) for r in range(len(lower)))
    forcing, unknown = [], dict.fromkeys((f.name for f in system.forces if f.unknowns), True)
    still = {
        name: (state.acceleration.substitute(resting), substitute(state.alpha, resting))
        for name, state in system.bodies.items()
    }
    known = [force for force in system.forces if not force.unknowns]
    for way in ways:
        forcing.append(short(_power(system, known, way) - _inertia(system, way, still)))
        for name in unknown:
            unknown[name] = unknown[name] and is_zero(_power(system, system.named(name), way))
    return mass, tuple(forcing), unknown


def _inertia(system: System, along: Twists, of: Twists) -> Scalar:
    """Σ m v·a + I ω α."""
    parts = []
    for name, state in system.bodies.items():
        (direction, turn), (other, spin) = along[name], of[name]
        if direction and other:
            parts.append(state.mass * direction.dot(other))
        if turn and spin:
            parts.append(state.moment * turn * spin)
    return total(parts)


def _power(system: System, forces: Iterable[Force], along: Twists) -> Scalar:
    """Σ F·v + τ ω, the torque about the centre of mass."""
    parts = []
    for force in forces:
        state, (direction, turn) = system.bodies[force.on], along[force.on]
        parts += [direction.dot(force.vector)] if direction and force.vector else []
        parts += [turn * torque_about_center(force, state)] if turn else []
    return total(parts)


def solve(system: System) -> Dynamics:
    """Accelerations and unknown forces; none of these where masses are not stated, and the motion is given as far as it is
    known. Raises StatementError if the statement does not determine them."""
    if system.problem.unstated:  # 0 q̈ = 0
        nothing = (NOTHING,) * len(system.independent)
        return Dynamics((nothing,) * len(nothing), nothing, None if nothing else {}, {}, {}, {})
    mass, forcing, ideal = equations_of_motion(system)
    if not all(ideal.values()):
        return _solve_together(system, mass, ideal)
    found = _accelerations(system, mass, forcing)
    accelerations = None if found is None else {n: without_even_roots(value) for n, value in found.items()}
    reactions = {n: without_even_roots(value) for n, value in _reactions(system, accelerations).items()}
    return Dynamics(mass, forcing, accelerations, reactions, _workless(system, ideal), ideal)


def _workless(system: System, ideal: Mapping[str, bool]) -> dict[str, bool]:
    """Ideal forces whose power at rest in the coordinates (that of driven supports) vanishes too."""
    if not system.has_clock:
        return dict(ideal)
    still = dict.fromkeys(system.speeds, NOTHING)
    carried = {name: (state.velocity.substitute(still), substitute(state.omega, still)) for name, state in system.bodies.items()}
    return {name: fine and is_zero(_power(system, system.named(name), carried)) for name, fine in ideal.items()}


def _solved_block(part: Matrix, forces: list[Scalar]) -> tuple[Scalar, ...] | None:
    """None where the formulas would be too long to be read."""
    if len(part) <= LARGEST_BLOCK:
        return solve_matrix(part, forces)
    if len(part) > LARGEST_TRIED:
        return None
    try:
        with at_most(FEW_PRODUCTS):
            values = solve_matrix(part, forces)
    except LimitError:
        return None
    return None if any(len(value.num) > LONGEST for value in values) else values


def _accelerations(system: System, mass: Matrix, forcing: tuple[Scalar, ...]) -> dict[str, Scalar] | None:
    found: dict[str, Scalar] = {}
    for block in blocks(mass):
        part = tuple(tuple(mass[i][j] for j in block) for i in block)
        try:
            values = _solved_block(part, [forcing[i] for i in block])
        except ZeroDivisionError:
            raise massless(system, block) from None
        if values is None:
            return None
        found |= {system.accelerations[i]: value for i, value in zip(block, values, strict=True)}
    return {name: found[name] for name in system.accelerations}


def newton_euler_rows(system: System) -> list[tuple[str, str, Scalar]]:
    """(body, "x"|"y"|"rotation", value) of m A - F = 0 and I α - τ_cm = 0 for every body; nothing where masses are not stated."""
    rows: list[tuple[str, str, Scalar]] = []
    if system.problem.unstated:
        return rows
    for name, state in system.bodies.items():
        push = state.acceleration * state.mass
        turn = state.moment * state.alpha
        for force in system.on(name):
            push = push - force.vector
            turn = turn - torque_about_center(force, state)
        rows += [(name, "x", push.x), (name, "y", push.y), (name, "rotation", turn)]
    return rows


def _known_rows(system: System) -> list[tuple[str, str, Scalar]]:
    """Those of `newton_euler_rows` in which no unknown force stands."""
    known = set(system.unknowns)
    return [row for row in newton_euler_rows(system) if not known & names_in(row[2])]


def _along_forces(system: System) -> list[Scalar]:
    """m A - F = 0 along the unknown forces that are neither level nor upright.

    They say nothing new, but a string's tension has the coefficient 1 there: it need not be divided by a sine
    that may vanish.
    """
    rows = []
    for force in system.forces:
        state = system.bodies[force.on]
        for name in force.unknowns:
            along = force.vector.derivative(name)
            if along.x and along.y:
                pushes = (other.vector.dot(along) for other in system.on(force.on))
                rows.append(state.mass * state.acceleration.dot(along) - total(pushes))
    return rows


def reactions_by_acceleration(system: System) -> dict[str, Scalar]:
    """Unknown forces in coordinates, speeds and accelerations: what Newton's equations of the bodies say alone."""
    return _reactions(system, None)


def _reactions(system: System, accelerations: Mapping[str, Scalar] | None) -> dict[str, Scalar]:
    """Solved with the accelerations as symbols, which are put in at the end."""
    unknowns = system.unknowns
    rows = newton_euler_rows(system)
    solution = solve_linear([*(value for *_, value in rows), *_along_forces(system)], unknowns)
    if solution.free:
        raise indistinct(system, solution.free)
    images = accelerations or {}
    if accelerations is not None and any(is_nonzero(system, value, images) for value in solution.left):
        known = [*_known_rows(system)]
        if not asking(system) or any(is_nonzero(system, value, images) for *_, value in known):
            raise unheld(system, known, images)
        equations = [(body, way, linear_row(value, unknowns)) for body, way, value in rows]
        holds = partial(_vanishes, system, images)
        raise contradictory(system, _in_the_way(equations, unknowns, holds), _alone(equations, unknowns, holds))
    return {name: _on_motion(solution.values[name], images) for name in unknowns}


def _on_motion(value: Scalar, accelerations: Mapping[str, Scalar]) -> Scalar:
    """With the accelerations put in, unless that grows beyond the limits: then these stay as symbols."""
    if _products(value, accelerations) > LARGEST_REACTION:
        return value
    try:
        return short(substitute(value, accelerations))
    except LimitError:
        return value


def _products(value: Scalar, accelerations: Mapping[str, Scalar]) -> int:
    """How many products of terms it takes to put the accelerations into a value that is linear in them."""
    row = linear_row(value, tuple(accelerations))
    images = [accelerations[name] for name in row if name != CONSTANT]
    common = prod(len(den) for den in {image.den for image in images})
    found = sum(len(row[name].num) * len(accelerations[name].num) for name in row if name != CONSTANT)
    return common * (found + len(row[CONSTANT].num))


def _vanishes(system: System, images: Mapping[str, Scalar], value: Scalar) -> bool:
    return not is_nonzero(system, value, images)


def _alone(equations: Sequence[tuple[str, str, Row]], unknowns: tuple[str, ...], holds: Callable[[Scalar], bool]) -> list[str]:
    """The bodies whose own equations have no solution, whatever the forces on them are."""
    bodies = dict.fromkeys(body for body, _, _ in equations)
    own = {name: solve_rows([row for body, _, row in equations if body == name], unknowns) for name in bodies}
    return [name for name, rest in own.items() if not all(map(holds, rest.left))]


def _in_the_way(
    equations: Sequence[tuple[str, str, Row]], unknowns: tuple[str, ...], holds: Callable[[Scalar], bool] = is_zero
) -> list[str]:
    """The bodies without whose equations the others have a solution: one of them lacks what holds it."""
    bodies = dict.fromkeys(body for body, _, _ in equations)
    rests = {name: solve_rows([row for body, _, row in equations if body != name], unknowns) for name in bodies}
    return [name for name, rest in rests.items() if all(map(holds, rest.left))]


def _solve_together(system: System, mass: Matrix, ideal: Mapping[str, bool]) -> Dynamics:
    """Accelerations and forces in one elimination, where a constraint force does not drop out."""
    unknowns = (*system.unknowns, *system.accelerations)
    equations = [(body, way, linear_row(value, unknowns)) for body, way, value in newton_euler_rows(system)]
    solution = solve_rows([row for _, _, row in equations], unknowns)
    if solution.free:
        raise indistinct(system, solution.free)
    if not all(is_zero(value) for value in solution.left):
        raise contradictory(system, _in_the_way(equations, unknowns))
    accelerations = {name: solution.values[name] for name in system.accelerations}
    reactions = {name: solution.values[name] for name in system.unknowns}
    gained = [accelerations[name] for name in system.accelerations]
    forcing = tuple(short(sum((m * a for m, a in zip(row, gained, strict=True)), NOTHING)) for row in mass)
    return Dynamics(mass, forcing, accelerations, reactions, _workless(system, ideal), ideal)
