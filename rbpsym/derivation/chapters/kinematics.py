"""Positions, velocities and angular velocities of all bodies; the constraints' conditions."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import FULL, BodyRef
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.inertia import tidy
from rbpsym.mechanics.system import BodyState
from rbpsym.notation import tree as t
from rbpsym.statement.model import Body, Element, PointRef


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "kinematics"
    for element in draft.study.problem.constraints:
        _condition(draft, element)
    _dependent(draft)
    for name, state in draft.study.system.bodies.items():
        _position(draft, name, state)
        _turning(draft, name, state)
        _velocity(draft, name, state)


def _condition(draft: Draft, element: Element) -> None:
    """What a constraint asks, written in the poses as given: an identity, or an equation for coordinates."""
    rows = [row for row in (_meeting(draft, element), *_touching(draft, element)) if row is not None]
    if not rows or draft.study.system.dependent or draft.study.system.implicit:
        return
    statement = rows[0] if len(rows) == 1 else t.System(tuple(rows))
    labels = [ref.label for ref in _points(element)]
    draft.add(
        f"condition.{element.name}",
        "constraint",
        statement,
        f"kinematics.condition.{element.kind}",
        level=FULL,
        force=t.Vec(element.name),
        points=labels,
    )


def _points(element: Element) -> list[PointRef]:
    joint = JOINTS[element.kind]
    return [ref for join in joint.joins(element) for ref in join if ref] + [t_.point for t_ in joint.touches(element)]


def _raw(draft: Draft, ref: PointRef) -> tuple[t.Node, t.Node] | None:
    """Coordinates of a point as they follow from the pose as the author gave it, nothing worked out."""
    if ref.body is None:
        return ref.at
    body = draft.study.problem.body(ref.body)
    if body.placed is None or ref.point == "cm" or body.placed[0] == "cm":
        return None
    angle = body.angle if body.angle is not None else t.ZERO
    x, y = _local_difference(body, ref.point)
    (px, py), cos, sin = body.placed[1], t.Fn("cos", angle), t.Fn("sin", angle)
    return (t.add(px, *_signed(x, cos), *_signed(y, sin, -1)), t.add(py, *_signed(x, sin), *_signed(y, cos)))


def _local_difference(body: Body, point: str) -> tuple[Scalar, Scalar]:
    from rbpsym.algebra.evaluate import scalar

    (ax, ay), (bx, by) = body.points[point], body.points[body.placed[0]]
    return scalar(ax) - scalar(bx), scalar(ay) - scalar(by)


def _signed(length: Scalar, function: t.Node, sign: int = 1) -> tuple[t.Node, ...]:
    from rbpsym.algebra.present import present

    return (t.mul(present(length * sign), function),) if length else ()


def _meeting(draft: Draft, element: Element) -> t.Node | None:
    rows = []
    for first, second in JOINTS[element.kind].joins(element):
        if first is None:
            return None
        ends = [_raw(draft, ref) for ref in (second, first)]
        if None in ends:
            return None
        rows += [t.equation(a, b) for a, b in zip(*ends, strict=True) if a != b]
    return None if not rows else rows[0] if len(rows) == 1 else t.System(tuple(rows))


def _touching(draft: Draft, element: Element) -> list[t.Node]:
    rows = []
    for touch in JOINTS[element.kind].touches(element):
        at = _raw(draft, touch.point)
        if at is not None:
            left = t.add(t.mul(touch.line.a, at[0]), t.mul(touch.line.b, at[1]))
            rows.append(t.equation(left, touch.line.c))
    return rows


def _dependent(draft: Draft) -> None:
    """Coordinates that the constraints tie to the others."""
    for name, value in draft.study.system.dependent.items():
        draft.context.scalars[name] = value
        draft.add(
            f"dependent.{name}",
            "statement",
            t.equation(t.Sym(name), draft.show(value)),
            "kinematics.dependent",
            coordinate=t.Sym(name),
        )


def _position(draft: Draft, name: str, state: BodyState) -> None:
    vector = draft.define_vector(draft.of_body("R", name), state.center)
    if not state.center:
        return
    draft.add(
        f"position.{name}",
        "statement",
        t.equation(vector, draft.show_vector(state.center)),
        "kinematics.position",
        premises=[s.id for s in draft.steps if s.rule == "constraint"],
        body=BodyRef(name),
    )


def _turning(draft: Draft, name: str, state: BodyState) -> None:
    """ω of the body against the coordinates: dφ/dt, its sign included."""
    omega = draft.define(draft.of_body("omega", name), state.omega)
    draft.context.vectors[omega.name] = _along_z(state.omega)
    if draft.study.problem.body(name).angle is None and not state.omega:
        return
    angle = state.pose.angle
    if not angle.num.terms:
        return
    statement = t.equation(omega, t.Deriv(draft.show(angle)), draft.show(state.omega))
    draft.add(
        f"turning.{name}",
        "differentiation",
        statement,
        _turning_phrase(draft, state),
        data={"pairs": [(angle, state.omega)]},
        body=BodyRef(name),
        omega=omega,
        coordinates=[t.Sym(n) for n in draft.study.system.independent if depends_on(state.omega, f"{n}_dot")],
    )


def _turning_phrase(draft: Draft, state: BodyState) -> str:
    """Whether the coordinate grows with or against the positive sense of rotation."""
    from rbpsym.algebra.scalar import symbol

    for speed in draft.study.system.speeds:
        if is_zero(state.omega + symbol(speed)):
            return "kinematics.turning.opposite"
    return "kinematics.turning.plain" if state.omega else "kinematics.turning.none"


def _along_z(value: Scalar):
    from rbpsym.algebra.vector import Space

    return Space(z=value)


def _velocity(draft: Draft, name: str, state: BodyState) -> None:
    vector = draft.define_vector(draft.of_body("V", name), state.velocity)
    draft.define_vector(draft.of_body("P", name), state.velocity * state.mass)
    draft.define_vector(draft.of_body("A", name), state.acceleration)
    if not state.velocity:
        return
    position = t.Vec(draft.of_body("R", name))
    pairs = [(tidy(a), tidy(b)) for a, b in ((state.center.x, state.velocity.x), (state.center.y, state.velocity.y))]
    draft.add(
        f"velocity.{name}",
        "differentiation",
        t.equation(vector, t.Deriv(position), draft.show_vector(state.velocity, factor=True)),
        "kinematics.velocity",
        premises=[f"position.{name}"],
        data={"pairs": pairs},
        body=BodyRef(name),
    )
    square = tidy(state.velocity.dot(state.velocity))
    draft.add(
        f"speed.{name}",
        "identity",
        t.equation(t.Pow(vector, t.TWO), draft.show(square, factor=True)),
        "kinematics.speed",
        premises=[f"velocity.{name}"],
        body=BodyRef(name),
    )
