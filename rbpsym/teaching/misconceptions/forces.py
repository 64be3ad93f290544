"""Misconceptions about forces, lever arms and Newton's law: signs, arms, sines, F = ma at the wrong point."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import prod

from rbpsym.algebra import NOTHING, ORIGIN, Scalar, Vector, is_zero, substitute
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.elimination import short, solve_linear
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import FORCES, MOTION, NO_FORCES, WELL, Misconception, Site


def _force_sign(study: Study) -> Iterator[Site]:
    """A known force (or its torque) with the wrong sign."""
    for element in study.problem.interactions:
        name = element.name
        if element.kind != "gravity":  # see “weight-sign”
            slots = {"force": t.Vec(name), "variant": "couple" if _is_couple(study, name) else "force"}
            yield Site(slots, partial(change.with_force, study, name, change.opposite))


def _is_couple(study: Study, name: str) -> bool:
    """Does an interaction only turn, and neither push nor pull?"""
    return not any(f.vector for f in study.system.named(name))


def _one_torque_sign(study: Study) -> Iterator[Site]:
    """The torque about the centre of mass of one contact force with the wrong sign."""
    for force in _contacts(study):
        arm = force.point - study.system.bodies[force.on].center
        torque = arm.cross(force.vector)
        if not is_zero(torque):
            slots = {"force": t.Sym(force.name), "body": BodyRef(force.on)}
            yield Site(slots, partial(_with_couple, study, force, -2 * torque))


def _contacts(study: Study) -> list[Force]:
    """Forces of constraints with one unknown that act away from the centre of mass."""
    return [f for f in study.system.forces if len(f.unknowns) == 1 and f.vector and f.point != _center(study, f)]


def _center(study: Study, force: Force) -> Vector:
    return study.system.bodies[force.on].center


def _with_couple(study: Study, force: Force, more: Scalar) -> Study:
    return change.with_forces(study, lambda f: replace(f, couple=f.couple + more) if f is force else f)


def _whole_lever(study: Study) -> Iterator[Site]:
    """The weight of a body that turns about its end is put at its other end: the whole length for the half."""
    for name in study.system.bodies:
        arm = change.arm_of(study, name)
        if arm is not None and change.weights(study, name):
            yield Site({"body": BodyRef(name)}, partial(_with_weight_at, study, name, study.system.bodies[name].center + arm))


def _weight_at_middle(study: Study) -> Iterator[Site]:
    """The weight acts at the middle of the shape where the centre of mass is elsewhere."""
    for name, state in study.system.bodies.items():
        if (state.inertia.x or state.inertia.y) and state.pose.origin and change.weights(study, name):
            yield Site({"body": BodyRef(name)}, partial(_with_weight_at, study, name, state.pose.origin))


def _with_weight_at(study: Study, name: str, place: Vector) -> Study:
    return change.with_weight(study, name, lambda force: replace(force, point=place))


def _swapped_weight(study: Study) -> Iterator[Site]:
    """Sine for cosine in the component of the weight: across the lever arm, or along a slope."""
    for name in study.system.bodies:
        along = change.arm_of(study, name) or slope_under(study, name)
        if along is None or not change.weights(study, name):
            continue

        def swap(force: Force, along: Vector = along) -> Force:
            return replace(force, vector=_mirrored(study, force.vector, along))

        yield Site({"body": BodyRef(name)}, partial(change.with_weight, study, name, swap))


def slope_under(study: Study, body: str) -> Vector | None:
    """The direction of the fixed line that the body touches, if that is neither level nor upright."""
    geometry = geometry_of(study.system)
    for element in study.problem.constraints:
        if element.values.get("line") is None or element["of"] is not None:
            continue
        met = meeting(element, geometry)
        if met.on == body and not is_zero(met.normal.x) and not is_zero(met.normal.y):
            return met.forward
    return None


def _mirrored(study: Study, vector: Vector, along: Vector) -> Vector:
    """The vector with its components along and across a direction exchanged, their signs kept."""
    square = short(along.dot(along))
    across = along.turned()
    first, second = along.dot(vector), across.dot(vector)
    way = prod(change.sign_of(study, value) or 1 for value in (first, second))
    return (along * second + across * first) * (Scalar(square.den, square.num) * way)


def _swapped_lever(study: Study) -> Iterator[Site]:
    """Sine for cosine in the lever arm of a contact force."""
    for force in _contacts(study):
        arm = force.point - _center(study, force)
        right, wrong = arm.cross(force.vector), arm.dot(force.vector)
        if is_zero(wrong) or is_zero(right):
            continue
        unit = {name: Scalar((wrong * 0 + 1).num) for name in force.unknowns}
        ways = (change.sign_of(study, substitute(value, unit)) or 1 for value in (right, wrong))
        slots = {"force": t.Sym(force.name), "body": BodyRef(force.on)}
        yield Site(slots, partial(_with_couple, study, force, wrong * prod(ways) - right))


def _as_at_rest(study: Study) -> Iterator[Site]:
    """Forces from the balance of a body at rest: N = weight, though it accelerates."""
    if study.system.unknowns and study.dynamics.accelerations:
        yield Site({}, lambda: _resting(study))


def _resting(study: Study) -> Study:
    """ΣF = 0 for every body, the torques left aside."""
    rows = [value for _, axis, value in newton_euler_rows(_still(study.system)) if axis != "rotation"]
    found = solve_linear(rows, study.system.unknowns, keep_free=True)
    known = {n: v for n, v in found.values.items() if not set(_unknowns(v)) & set(study.system.unknowns)}
    return change.with_reactions(study, known)


def _unknowns(value: Scalar) -> list[str]:
    from rbpsym.algebra import atoms

    return [name for index in value.atoms() if (name := atoms.symbol_name(index))]


def _still(system: System) -> System:
    still = {"acceleration": ORIGIN, "alpha": NOTHING, "velocity": ORIGIN}
    return replace(system, bodies={name: replace(state, **still) for name, state in system.bodies.items()})


def _at_the_contact(study: Study) -> Iterator[Site]:
    """F = ma with the acceleration of the point where a contact force acts, instead of the centre of mass."""
    for force in _contacts(study):
        state = study.system.bodies[force.on]
        arm = force.point - state.center
        here = state.acceleration + arm.turned() * state.alpha - arm * (state.omega * state.omega)

        def wrong(force: Force = force, here: Vector = here) -> Study:
            rows = [value for _, _, value in newton_euler_rows(change.with_body(study, force.on, acceleration=here))]
            images = study.dynamics.accelerations or {}
            solved = solve_linear([r for r in rows if r], study.system.unknowns).values
            found = {name: short(substitute(value, images)) for name, value in solved.items()}
            return change.with_reactions(study, found)

        yield Site({"force": t.Sym(force.name), "body": BodyRef(force.on)}, wrong)


def _no_centripetal(study: Study) -> Iterator[Site]:
    """The acceleration towards the axis is left out of the forces."""
    speeds = study.system.speeds
    if not any(set(_unknowns(value)) & set(speeds) for value in study.dynamics.reactions.values()):
        return

    still = dict.fromkeys(speeds, NOTHING)
    reactions = study.dynamics.reactions.items()
    yield Site({}, lambda: change.with_reactions(study, {name: substitute(value, still) for name, value in reactions}))


def _whole_length(study: Study) -> Iterator[Site]:
    """The force of a spring from its length instead of its elongation."""
    for element in study.problem.interactions:
        if element.kind == "spring" and change.is_nonzero(element["natural_length"]):
            wrong = element.with_values(natural_length=t.ZERO)
            yield Site({"force": t.Vec(element.name)}, partial(change.with_element, study, element, wrong))


def _wrong_sense(study: Study) -> Iterator[Site]:
    """ω and α of a body with the wrong sense: dθ/dt taken for them where the body turns against θ."""
    for name, state in study.system.bodies.items():
        if not state.omega or is_zero(state.omega) or len(study.system.independent) != 1:
            continue
        system = change.with_body(study, name, omega=-state.omega, alpha=-state.alpha)
        yield Site({"body": BodyRef(name)}, partial(change.with_parts, study, system=system))


MISCONCEPTIONS = (
    Misconception("force-sign", _force_sign, MOTION, NO_FORCES),
    Misconception("torque-sign", _one_torque_sign, MOTION, WELL),
    Misconception("whole-length-for-lever-arm", _whole_lever, MOTION, WELL),
    Misconception("weight-at-middle-of-shape", _weight_at_middle, MOTION, WELL),
    Misconception("sine-for-cosine", _swapped_weight, MOTION),
    Misconception("sine-for-cosine-in-lever-arm", _swapped_lever, MOTION, WELL),
    Misconception("forces-as-at-rest", _as_at_rest, FORCES, WELL),
    Misconception("f-is-ma-at-contact-point", _at_the_contact, FORCES),
    Misconception("centripetal-forgotten", _no_centripetal, FORCES, WELL),
    Misconception("length-for-elongation", _whole_length, MOTION, WELL),
    Misconception("wrong-sense-of-rotation", _wrong_sense, MOTION | {"momentum"}, WELL),
)
