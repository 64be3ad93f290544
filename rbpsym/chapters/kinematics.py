"""The constraints' conditions; positions, velocities and angular velocities of all bodies."""

from __future__ import annotations

from rbpsym.chapters import conditions
from rbpsym.chapters.inertia import as_power, is_centred, turns_about
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Space, depends_on, has_roots, is_zero, symbol, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.field.poly import generator
from rbpsym.mechanics.energy import stretched
from rbpsym.mechanics.system import BodyState
from rbpsym.proof.draft import Draft
from rbpsym.proof.forms import LETTERED
from rbpsym.proof.step import FULL, STANDARD, BodyRef

LAWS_OF_DISTANCE = ("spring", "damper", "pull")


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "kinematics"
    conditions.write(draft)
    for name, state in draft.study.system.bodies.items():
        _position(draft, name, state)
        _circle(draft, name, state)
        _turning(draft, name, state)
        _velocity(draft, name, state)
    _lengths(draft)


def _lengths(draft: Draft) -> None:
    """The distance of two points that a spring, a damper or a rope joins, where it is a root: a letter of its own."""
    system = draft.study.system
    joined = [one for one in system.problem.interactions if one.kind in LAWS_OF_DISTANCE]
    roots = {one.name: value for one in joined if (value := stretched(system, one)).num in map(generator, value.atoms())}
    pulls = {force.name for force in system.forces if has_roots(force.vector.x) or has_roots(force.vector.y)}
    for name, value in ((name, value) for name, value in roots.items() if has_roots(value) and name in pulls):
        slack = scalar(system.element(name).values.get("natural_length", t.ZERO))
        root, letter = draft.show(value), draft.call(draft.free(f"s_{name}"), value, slack)
        draft.add(f"length.{name}", "identity", t.equation(letter, root), LETTERED, force=t.Vec(name))


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


def _circle(draft: Draft, name: str, state: BodyState) -> None:
    """The centre of mass of a single body that keeps its distance from the origin without turning about it."""
    square = tidy(state.center.dot(state.center))
    moving = [*draft.study.system.coordinates, "t"]
    if not draft.is_single or not square or not state.velocity or any(depends_on(square, q) for q in moving):
        return
    if "O" in turns_about(draft.study, state) or not is_centred(draft, name):
        return
    x, y = (draft.define(draft.of_body(axis, name), tidy(getattr(state.center, axis))) for axis in ("x", "y"))
    draft.add(
        f"circle.{name}",
        "identity",
        t.equation(t.add(t.Pow(x, t.TWO), t.Pow(y, t.TWO)), as_power(draft, square)),
        "kinematics.orbit",
        premises=[f"position.{name}"],
        body=BodyRef(name),
        point=t.Sym("O"),
        level=STANDARD if len(draft.study.problem.constraints) > 1 else FULL,  # of two conditions it is a surprise
    )


def _turning(draft: Draft, name: str, state: BodyState) -> None:
    """ω of the body against the coordinates: dφ/dt, its sign included."""
    omega = draft.define(draft.of_body("omega", name), state.omega)
    draft.context.vectors[omega.name] = Space(z=state.omega)
    if draft.has(f"turning.{name}") or (draft.study.problem.body(name).angle is None and not state.omega):
        return
    angle = state.pose.angle
    if not angle.num.terms:
        return
    statement = t.equation(omega, t.Deriv(_angle_node(draft, name, angle)), draft.show(state.omega))
    draft.add(
        f"turning.{name}",
        "differentiation",
        statement,
        _turning_phrase(draft, state),
        data={"pairs": [(angle, state.omega)]},
        body=BodyRef(name),
        is_result=bool(draft.study.problem.unstated),
        omega=omega,
        coordinates=[t.Sym(n) for n in draft.study.system.independent if depends_on(state.omega, f"{n}_dot")],
    )


def _angle_node(draft: Draft, name: str, angle: Scalar) -> t.Node:
    """The angle as the author gave it, where a coordinate stands in it that is not free."""
    given = draft.study.problem.body(name).angle
    tied = set(draft.study.system.dependent)
    return given if given is not None and t.names(given) & tied else draft.show(angle)


def _turning_phrase(draft: Draft, state: BodyState) -> str:
    """Whether the coordinate grows with or against the positive sense of rotation."""
    for speed in draft.study.system.speeds:
        if is_zero(state.omega + symbol(speed)):
            return "kinematics.turning.opposite"
    return "kinematics.turning.plain" if state.omega else "kinematics.turning.none"


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
        is_result=bool(draft.study.problem.unstated),
    )
    if draft.study.at_start or draft.study.problem.unstated:
        return  # no kinetic energy follows
    square = tidy(state.velocity.dot(state.velocity))
    draft.add(
        f"speed.{name}",
        "identity",
        t.equation(t.Pow(vector, t.TWO), draft.show(square, factor=True)),
        "kinematics.speed",
        premises=[f"velocity.{name}"],
        body=BodyRef(name),
    )
