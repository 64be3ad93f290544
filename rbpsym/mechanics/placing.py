"""Poses of all bodies: as given, or as the constraints leave no choice."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.errors import StatementError, there
from rbpsym.field import NOTHING, ORIGIN, Scalar, Vector, cartesian, is_zero, names_in, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.constraints import JOINTS, AngleJoin, Touch
from rbpsym.mechanics.geometry import local_point, pair, position
from rbpsym.mechanics.inertia import Inertia
from rbpsym.mechanics.system import Pose, System, rotated
from rbpsym.statement.model import Body, PointRef, Problem
from rbpsym.statement.own_text import letters_of

Inertias = Mapping[str, Inertia]
Row = tuple[Scalar, Scalar, Scalar]


def poses(problem: Problem, inertias: Inertias) -> dict[str, Pose]:
    """The pose of every body; what is left to conditions stands in it as a symbol (`open_name`).

    Where there are bodies and nothing else, a frame of which nothing is said is that of space.
    """
    angles = _angles(problem)
    origins = _given_origins(problem, inertias, angles)
    if problem.is_at_rest:
        return {name: Pose(origins.get(name, ORIGIN), angles[name]) for name in problem.body_names}
    _follow_joins(problem, inertias, angles, origins)
    _follow_lines(problem, inertias, angles, origins)
    for name in problem.body_names:
        if name not in origins:
            origins[name] = cartesian(*(symbol(open_name(name, axis)) for axis in "xy"))
            _follow_joins(problem, inertias, angles, origins)
    return {name: Pose(origins[name], angles[name]) for name in problem.body_names}


def open_name(body: str, what: str) -> str:
    """The symbol of what no one says of a pose: "x", "y" (of the frame's origin) or "angle"."""
    return f"{body}.{what}"


def open_names(placed: Mapping[str, Pose]) -> tuple[str, ...]:
    """The open symbols in the poses, places before angles."""
    names = [open_name(body, what) for what in ("x", "y", "angle") for body in placed]
    found: set[str] = set()
    for pose in placed.values():
        found |= names_in(pose.angle)
        for angle, length in pose.origin.parts.items():
            found |= names_in(angle) | names_in(length)
    return tuple(name for name in names if name in found)


def still_open(problem: Problem, name: str) -> StatementError:
    """The sentence for an open symbol that no condition determines."""
    body, _, what = name.rpartition(".")
    return (_unturned if what == "angle" else _unplaced)(problem.body(body))


def _unturned(body: Body) -> StatementError:
    return StatementError(
        f"nothing says how the body “{body.name}” is turned",
        instead=f'give [bodies.{body.name}] an angle = "...", weld it to another body, or let it roll.',
        place=body.place,
    )


def _angles(problem: Problem) -> dict[str, Scalar]:
    known = {b.name: scalar(b.angle) for b in problem.bodies if b.angle is not None}
    still = problem.is_at_rest
    known |= {b.name: NOTHING for b in problem.bodies if b.angle is None and (still or b.shape.kind == "particle")}
    joins = [join for e in problem.constraints for join in JOINTS[e.kind].angles(e)]
    _until_settled(lambda: any([_join_angle(join, known) for join in joins]))
    for body in problem.bodies:
        if body.name not in known:
            known[body.name] = symbol(open_name(body.name, "angle"))
            _until_settled(lambda: any([_join_angle(join, known) for join in joins]))
    return known


def _join_angle(join: AngleJoin, known: dict[str, Scalar]) -> bool:
    offset = join.offset if join.offset is not None else NOTHING
    if join.first is None or join.first in known:
        if join.second in known:
            return False
        known[join.second] = (known[join.first] if join.first else NOTHING) + offset
        return True
    if join.second in known:
        known[join.first] = known[join.second] - offset
        return True
    return False


def _until_settled(step: Callable[[], bool]) -> None:
    while step():
        pass


def _given_origins(problem: Problem, inertias: Inertias, angles: Mapping[str, Scalar]) -> dict[str, Vector]:
    origins = {}
    for body in problem.bodies:
        if body.placed is not None:
            point, place = body.placed
            local = local_point(body, point, inertias[body.name])
            origins[body.name] = pair(place) - rotated(*local, angles[body.name])
    return origins


def _follow_joins(problem: Problem, inertias: Inertias, angles: Mapping[str, Scalar], origins: dict[str, Vector]) -> None:
    """Bodies are put where pins, pivots and welds to placed bodies say."""
    joins = [(a, b) for e in problem.constraints for a, b in JOINTS[e.kind].joins(e) if a is not None]
    bodies = {body.name: body for body in problem.bodies}

    def turned(body: str, point: str | None) -> Vector:
        return rotated(*local_point(bodies[body], there(point), inertias[body]), angles[body])

    def place(a: PointRef, b: PointRef) -> bool:
        if b.body is None or b.body in origins or (a.body is not None and a.body not in origins):
            return False
        here = pair(there(a.at)) if a.body is None else origins[a.body] + turned(a.body, a.point)
        origins[b.body] = here - turned(b.body, b.point)
        return True

    _until_settled(lambda: any([place(a, b) or place(b, a) for a, b in joins]))


def _follow_lines(problem: Problem, inertias: Inertias, angles: Mapping[str, Scalar], origins: dict[str, Vector]) -> None:
    """A body that touches two lines, not parallel, is put where both say."""
    for body in problem.bodies:
        if body.name in origins:
            continue
        touches = [t for e in problem.constraints for t in JOINTS[e.kind].touches(e) if t.point.body == body.name]
        for touch, other in [(a, b) for k, a in enumerate(touches) for b in touches[k + 1 :]]:
            rows = [_row(t, body, inertias, angles) for t in (touch, other)]
            origin = _intersection(*rows)
            if origin is not None:
                origins[body.name] = origin
                break


def _row(touch: Touch, body: Body, inertias: Inertias, angles: Mapping[str, Scalar]) -> Row:
    """a, b, c with a X + b Y = c for the origin (X, Y) of the body."""
    turned = rotated(*local_point(body, there(touch.point.point), inertias[body.name]), angles[body.name])
    a, b, c = (scalar(n) for n in (touch.line.a, touch.line.b, touch.line.c))
    return a, b, c - a * turned.x - b * turned.y


def _intersection(first: Row, second: Row) -> Vector | None:
    (a, b, c), (d, e, f) = first, second
    determinant = a * e - b * d
    if is_zero(determinant):
        return None
    return cartesian((c * e - b * f) / determinant, (a * f - c * d) / determinant)


def _unplaced(body: Body) -> StatementError:
    return StatementError(
        f"nothing says where the body “{body.name}” is",
        instead=f'give [bodies.{body.name}] the place of one of its points, such as center = ["...", "..."], '
        "or join it by a pivot, pin or weld to something that is placed.",
        place=body.place,
    )


def locator(problem: Problem, inertias: Inertias, placed: Mapping[str, Pose]) -> Callable[[PointRef], Vector]:
    """A function from point references to positions in space."""
    bodies = {body.name: body for body in problem.bodies}
    return lambda ref: position(ref, bodies, inertias, placed)


def where_in(system: System) -> Callable[[PointRef], Vector]:
    """The same for an assembled system."""
    bodies = system.bodies.items()
    return locator(system.problem, {n: s.inertia for n, s in bodies}, {n: s.pose for n, s in bodies})


def origins(system: System) -> dict[str, Vector]:
    """Name → position: O, the places of pivots that are elsewhere, the author's origins."""
    found, letters = {"O": ORIGIN}, letters_of(system.problem)
    where = where_in(system)
    for element in system.problem.constraints:
        if element.kind == "pivot":
            place = where(element["point"])
            if is_fixed(place, system) and not any((place - other).vanishes() for other in found.values()):
                found[letters.free(f"P_{element.name}", taken=letters.things)] = place
    for name, ref in system.problem.origins.items():
        place = where(ref)
        if is_fixed(place, system) and not any((place - other).vanishes() for other in found.values()):
            found[name] = place
    return found


def is_fixed(place: Vector, system: System) -> bool:
    """Whether a place does not move."""
    return all(place.derivative(name).vanishes() for name in (*system.coordinates, "t"))


def stated_place(body: Body) -> Vector | None:
    """The point by which a body is placed, as it is stated."""
    return cartesian(*map(scalar, body.placed[1])) if body.placed else None


def straight(place: Vector, name: str) -> Vector | None:
    """The unit vector along which a place moves with a coordinate; else its part along an axis that is one."""
    rate = place.derivative(name)
    ways = (rate, cartesian(rate.x, NOTHING), cartesian(NOTHING, rate.y))
    return next((way for way in ways if not way.derivative(name) and way.dot(way).number() == 1), None)
