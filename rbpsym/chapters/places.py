"""Where points are, written in the poses as the author gave them: the rows of geometric conditions."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Meanings, Scalar, Vector, depends_on, is_zero, substitute, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.conditions import RATE, full_rates
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.contacts import meeting, rim_of, touching_point
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import Geometry, components, start_numbers, unsaid
from rbpsym.mechanics.placing import locator, open_names, poses
from rbpsym.mechanics.system import BodyState, Pose, System, at_point
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Body, Element, PointRef
from rbpsym.statement.solids import put_in

Pair = tuple[t.Node, t.Node]


def coordinates_of(draft: Draft, ref: PointRef) -> Pair | None:
    """Coordinates of a point as they follow from the pose as the author gave it, nothing worked out."""
    if ref.body is None:
        return ref.at
    body = draft.study.problem.body(ref.body)
    if body.placed is None or ref.point is None or "cm" in (ref.point, body.placed[0]):
        return None
    x, y = _local_difference(body, ref.point, body.placed[0])
    if (x or y) and body.angle is None:
        return None
    angle = body.angle if body.angle is not None else t.ZERO
    waves = (t.Fn(name, angle) for name in ("cos", "sin"))
    (px, py), (cos, sin) = body.placed[1], (wave if t.names(angle) else present(scalar(wave)) for wave in waves)
    return (t.add(px, *_signed(x, cos), *_signed(y, sin, -1)), t.add(py, *_signed(x, sin), *_signed(y, cos)))


def _local_difference(body: Body, point: str, placed: str) -> tuple[Scalar, Scalar]:
    (ax, ay), (bx, by) = body.points[point], body.points[placed]
    return scalar(ax) - scalar(bx), scalar(ay) - scalar(by)


def _signed(length: Scalar, function: t.Node, sign: int = 1) -> tuple[t.Node, ...]:
    return (t.mul(present(length * sign), function),) if length else ()


def meeting_rows(draft: Draft, element: Element) -> list[t.Chain]:
    """Two points in one place: the rows that do not repeat themselves."""
    rows: list[t.Chain] = []
    for first, second in JOINTS[element.kind].joins(element):
        ends = [None if ref is None else coordinates_of(draft, ref) for ref in (second, first)]
        told = [end for end in ends if end is not None]
        if len(told) == 2:
            rows += [t.equation(a, b) for a, b in zip(*told, strict=True) if a != b]
    return rows


def line_rows(draft: Draft, element: Element) -> list[t.Chain]:
    """A point on a fixed line."""
    rows = []
    for touch in JOINTS[element.kind].touches(element):
        at = coordinates_of(draft, touch.point)
        if at is not None:
            left = t.add(t.mul(touch.line.a, at[0]), t.mul(touch.line.b, at[1]))
            rows.append(t.equation(left, touch.line.c))
    return rows


def distance_rows(draft: Draft, element: Element) -> list[t.Chain]:
    """A round body at the distance of its rim from a line; a distance from the middle of a circle; a string's length."""
    if element.kind == "string":
        ends = [at for turn in element["path"] if (at := coordinates_of(draft, turn.center)) is not None]
        is_told = element["length"] is not None and len(ends) == len(element["path"])
        return [_apart(ends[0], ends[1], element["length"])] if is_told else []
    if element.values.get("circle") is not None:
        return _from_circle(draft, element)
    if element.values.get("curve") is not None:
        at, curve = coordinates_of(draft, element["point"]), element["curve"]
        there = {curve.name: dict(zip("xy", at, strict=True))[curve.axis]} if at and curve.axis else {}
        rows = zip(at or (), (put_in(node, there) for node in (curve.x, curve.y)), strict=False)
        return [t.equation(a, b) for a, b in rows if a != b]
    if element.values.get("rim") is not None and element["of"] is None:
        return _from_line(draft, element)
    return []


def _apart(first: Pair, second: Pair, distance: t.Node) -> t.Chain:
    """(x₁ - x₂)² + (y₁ - y₂)² = d²."""
    gaps = [t.add(a, t.neg(b)) for a, b in zip(first, second, strict=True)]
    return t.equation(t.add(*(t.power(gap, 2) for gap in gaps if gap != t.ZERO)), t.power(distance, 2))


def _from_circle(draft: Draft, element: Element) -> list[t.Chain]:
    here, middle = (coordinates_of(draft, ref) for ref in (touching_point(element), element["circle"]))
    if here is None or middle is None:
        return []
    reach = scalar(element["radius"]) + rim_of(element) * _side(draft, element)
    return [_apart(here, middle, draft.show(reach))]


def _side(draft: Draft, element: Element) -> int:
    """1 outside of the circle, -1 inside."""
    stated = element.values.get("side", "outside")
    if stated != "auto":
        return 1 if stated == "outside" else -1
    geometry = geometry_of(draft.study.system)
    met, middle = meeting(element, geometry), geometry.where(element["circle"])
    return geometry.sign(met.normal.dot(met.place - middle)) or 1


def _from_line(draft: Draft, element: Element) -> list[t.Chain]:
    at = coordinates_of(draft, touching_point(element))
    if at is None:
        return []
    a, b, c = components(element["line"])
    geometry = geometry_of(draft.study.system)
    met = meeting(element, geometry)
    side = 1 if geometry.sign(met.normal.x * a + met.normal.y * b) >= 0 else -1
    left = t.add(*(t.mul(draft.show(part), x) for part, x in ((a, at[0]), (b, at[1])) if part))
    return [t.equation(left, draft.show(c + rim_of(element) * side))]


class FreeGeometry(Frozen):
    """`geometry` with all speeds free; the bodies whose place or angle no one gave."""

    geometry: Geometry
    unplaced: frozenset[str]
    unturned: frozenset[str]

    def spin(self, body: str | None) -> Scalar | None:
        """Angular velocity of a body in the speeds as given; None if nothing was said of its angle."""
        return None if body is None or body in self.unturned else self.geometry.states[body].omega


def as_given(system: System) -> FreeGeometry:
    """The poses of the statement; open places and angles are those that the constraints gave."""
    problem = system.problem
    inertias = {name: state.inertia for name, state in system.bodies.items()}
    raw = poses(problem, inertias)
    left = open_names(raw)
    unplaced = frozenset(n for n in raw if _is_open(left, raw[n].origin.x, raw[n].origin.y))
    unturned = frozenset(n for n in raw if _is_open(left, raw[n].angle))
    placed = {n: _closed(pose, system.bodies[n].pose, n in unplaced, n in unturned) for n, pose in raw.items()}
    scope = Meanings(rates=full_rates([c.name for c in problem.coordinates]))
    states = {n: _state(system.bodies[n], pose, scope) for n, pose in placed.items()}
    where = locator(problem, inertias, placed)
    return FreeGeometry(Geometry(where, placed, start_numbers(problem), states, unsaid(problem)), unplaced, unturned)


def _closed(raw: Pose, found: Pose, place: bool, angle: bool) -> Pose:
    """A pose in which nothing is open."""
    return Pose(found.origin if place else raw.origin, found.angle if angle else raw.angle)


def _is_open(names: tuple[str, ...], *values: Scalar) -> bool:
    return any(depends_on(value, name) for value in values for name in names)


def _state(state: BodyState, pose: Pose, scope: Meanings) -> BodyState:
    own = state.inertia
    center = at_point(pose, (own.x, own.y)) if own.x or own.y else pose.origin
    return BodyState(state.name, own, pose, center, vector_rate(center, scope), time_derivative(pose.angle, scope))


def speed_along(given: FreeGeometry, body: str | None, place: Vector, direction: Vector) -> Scalar:
    """Speed of the material point of a body at a place along a direction."""
    return direction.dot(given.geometry.velocity(body, place))


def found_spins(draft: Draft, given: FreeGeometry) -> None:
    """The angular velocity of bodies whose angle was left to rolling or to a string."""
    for name in draft.study.problem.body_names:
        state = draft.study.system.bodies[name]
        premises = [s.id for s in draft.steps if s.rule in ("no_slip", "taut")]
        if name in given.unturned and state.omega and premises:
            omega = draft.define(draft.of_body("omega", name), state.omega)
            draft.add(
                f"turning.{name}",
                "tied",
                t.equation(omega, draft.show(state.omega)),
                "kinematics.turning.found",
                premises=premises,
                body=BodyRef(name),
                data={"pairs": [(state.pose.angle, state.omega)]},
            )


def tied(draft: Draft) -> None:
    """Coordinates, or only speeds, in terms of the free ones."""
    system = draft.study.system
    shown = {name for step in draft.steps if step.rule == "constraint" for name in _solved_already(step.statement)}
    premises = [s.id for s in draft.steps if s.rule in ("constraint", "no_slip", "taut")]
    for name, value in system.dependent.items():
        statement = t.equation(t.Sym(name), draft.show(value))
        if name not in shown:
            draft.add(
                f"dependent.{name}",
                "tied",
                statement,
                "kinematics.dependent",
                premises=premises,
                coordinate=t.Sym(name),
                variant=_way(draft, name),
            )
    for name in system.coordinates:
        if name not in system.independent:
            draft.add(
                f"tied_speed.{name}",
                "tied",
                t.equation(t.Sym(f"{name}_dot"), draft.show(system.scope.rates[name], factor=True)),
                "kinematics.tied_speed",
                premises=premises,
                coordinate=t.Sym(name),
            )


def _solved_already(statement: t.Node) -> list[str]:
    """Names that stand alone on the left of a condition, and not on the right of it."""
    rows = t.rows(statement)
    pairs = [(row.items[0], row.items[-1]) for row in rows]
    return [left.name for left, right in pairs if isinstance(left, t.Sym) and left.name not in t.names(right)]


def _way(draft: Draft, name: str) -> str:
    """How it was found: by integrating a condition on the speeds (from the start, or with zero for the constant), by one on
    the place, or by forces that balance."""
    system = draft.study.system
    held = [c for c in system.conditions if depends_on(c.value, name)]
    if not any(c.what == RATE for c in held):
        return "place" if held else "balance"
    declared = next(c.start for c in draft.study.problem.coordinates if c.name == name)
    begins = substitute(system.dependent[name], {**system.scope.start, "t": NOTHING})
    return "rate" if declared is not None or is_zero(begins) else "zero"
