"""Misconceptions about forces: signs, arms, sines, which of them there are, what they move, F = ma at the wrong point."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from math import prod
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ORIGIN, UNITY, Scalar, Vector, depends_on, is_zero, short, substitute
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.proof.step import BodyRef
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import (
    FORCES,
    MOTION,
    NO_FORCES,
    WELL,
    Misconception,
    Site,
    Sites,
    of_forces,
    weights,
    without,
)
from rbpsym.teaching.targets import axes

HALF = UNITY / 2
DRIVEN = frozenset({"acceleration", "speed", "frequency", "work"})


def _force_sign(study: Study) -> Iterator[Site]:
    """A known force (or its torque) with the wrong sign."""
    for element in study.problem.interactions:
        name = element.name
        if element.kind != "gravity":  # see “weight-sign”
            pushes = any(force.vector for force in study.system.named(name))
            slots = {"force": t.Vec(name) if pushes else t.Sym(name), "variant": "force" if pushes else "couple"}
            yield Site(slots, partial(change.with_force, study, name, change.opposite))


# --- forces that are picked, and what is made of each


def _arm(study: Study, force: Force) -> Vector:
    """From the centre of mass of its body to where a force acts."""
    return force.point - study.system.bodies[force.on].center


def _turning(study: Study, force: Force) -> Scalar:
    return _arm(study, force).cross(force.vector)


def _contacts(study: Study) -> list[Force]:
    """Forces of constraints with one unknown that act away from the centre of mass."""
    return [f for f in study.system.forces if len(f.unknowns) == 1 and f.vector and _arm(study, f) != ORIGIN]


def _turning_contacts(study: Study) -> list[Force]:
    return [force for force in _contacts(study) if not is_zero(_turning(study, force))]


def _slanting_contacts(study: Study) -> list[Force]:
    """Contact forces that are neither along their arms nor across them."""
    return [force for force in _turning_contacts(study) if not is_zero(_arm(study, force).dot(force.vector))]


def _off_center(study: Study) -> list[Force]:
    """Forces that turn a body with no fixed axis."""
    free = (f for f in study.system.forces if f.law != "gravity" and f.on not in axes(study))
    return [force for force in free if not is_zero(_turning(study, force))]


def _falling(study: Study) -> list[Force]:
    """The weights that do work while it moves."""
    return [f for f in weights(study) if any(depends_on(f.point.y, c) for c in study.system.coordinates)]


def _strings_with_two_parts(study: Study) -> Iterator[Force]:
    for force in study.system.forces:
        whole = [force.vector.derivative(name) for name in force.unknowns]
        if len(whole) == 1 and is_zero(whole[0].dot(whole[0]) - 4):
            yield force


def _reactions(study: Study) -> Iterator[Force]:
    """Of forces between two bodies the one on the second."""
    for element in study.problem.constraints:
        pair = [f for f in study.system.forces if f.name == element.name and f.by in study.system.bodies]
        if len(pair) == 2 and not is_zero(pair[1].vector.dot(pair[1].vector)):
            yield pair[1]


def _off_middle(study: Study) -> list[Force]:
    """Weights of bodies whose centre of mass is not the middle of their shape."""
    states = ((force, study.system.bodies[force.on]) for force in weights(study))
    return [force for force, state in states if (state.inertia.x or state.inertia.y) and state.pose.origin]


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


def _slope(study: Study, force: Force) -> Vector | None:
    return slope_under(study, force.on)


def _lever(study: Study, force: Force) -> Vector | None:
    return change.arms(study).get(force.on)


def _weights_along(
    direction: Callable[[Study, Force], Vector | None], wrong: Callable[[Study, Force, Vector], Force]
) -> tuple[change.Pick, change.Wrong]:
    """The weights of bodies that have such a direction, and what becomes of them."""

    def changed(study: Study, force: Force) -> Force | None:
        along = direction(study, force)
        return None if along is None else wrong(study, force, along)

    return lambda study: [force for force in weights(study) if direction(study, force) is not None], changed


def _with_couple(force: Force, more: Scalar) -> Force:
    return replace(force, couple=force.couple + more)


def _mirrored(study: Study, force: Force, along: Vector) -> Force:
    """The vector with its components along and across a direction exchanged, their signs kept: sine for cosine."""
    square, across = short(along.dot(along)), along.turned()
    first, second = along.dot(force.vector), across.dot(force.vector)
    way = prod(change.sign_of(study, value) or 1 for value in (first, second))
    return replace(force, vector=(along * second + across * first) * (Scalar(square.den, square.num) * way))


def _sine_in_arm(study: Study, force: Force) -> Force:
    """The torque with the component of the force along the arm for that across it."""
    right, wrong = _turning(study, force), _arm(study, force).dot(force.vector)
    unit = dict.fromkeys(force.unknowns, UNITY)
    ways = (change.sign_of(study, substitute(value, unit)) or 1 for value in (right, wrong))
    return _with_couple(force, wrong * prod(ways) - right)


def _at_other_end(study: Study, force: Force, arm: Vector) -> Force:
    return replace(force, point=study.system.bodies[force.on].center + arm)


def _whole(study: Study, force: Force, along: Vector) -> Force:
    """All of the weight along a direction; its component across it stays."""
    across, way = along.turned(), change.sign_of(study, along.dot(force.vector)) or 1
    return replace(force, vector=along * (force.vector.y * -way) + across * across.dot(force.vector))


# --- other values of the unknown forces


def _as_at_rest(study: Study) -> Iterator[Site]:
    """Forces from the balance of a body at rest: N = weight, though it accelerates."""
    if study.system.unknowns and study.dynamics.accelerations:
        yield Site({}, partial(_resting, study))


def _resting(study: Study) -> Study:
    """ΣF = 0 for every body, the torques left aside."""
    still: dict[str, Any] = {"acceleration": ORIGIN, "alpha": NOTHING, "velocity": ORIGIN}
    system = replace(study.system, bodies={name: replace(state, **still) for name, state in study.system.bodies.items()})
    rows = [value for _, axis, value in newton_euler_rows(system) if axis != "rotation"]
    found = solve_linear(rows, system.unknowns, keep_free=True).values
    return change.with_reactions(
        study, {name: v for name, v in found.items() if not any(depends_on(v, unknown) for unknown in system.unknowns)}
    )


def _at_the_contact(study: Study) -> Iterator[Site]:
    """F = ma with the acceleration of the point where a contact force acts, instead of the centre of mass."""
    for force in _contacts(study):
        state, arm = study.system.bodies[force.on], _arm(study, force)
        here = state.acceleration + arm.turned() * state.alpha - arm * (state.omega * state.omega)
        yield Site({"force": t.Sym(force.name), "body": BodyRef(force.on)}, partial(_with_acceleration, study, force.on, here))


def _with_acceleration(study: Study, body: str, here: Vector) -> Study:
    rows = [value for _, _, value in newton_euler_rows(change.with_body(study, body, acceleration=here))]
    images = study.dynamics.accelerations or {}
    solved = solve_linear([r for r in rows if r], study.system.unknowns).values
    return change.with_reactions(study, {name: short(substitute(value, images)) for name, value in solved.items()})


def _speeds_squared(factor: int, applies: Callable[[Study], bool] = lambda study: True) -> Sites:
    """What the squares of the speeds add to the forces, taken so many times."""

    def sites(study: Study) -> Iterator[Site]:
        speeds, known = study.system.speeds, study.dynamics.reactions
        rest = {name: substitute(value, dict.fromkeys(speeds, NOTHING)) for name, value in known.items()}
        if applies(study) and any(depends_on(value, speed) for value in known.values() for speed in speeds):
            found = {name: rest[name] + (value - rest[name]) * factor for name, value in known.items()}
            yield Site({}, partial(change.with_reactions, study, found))

    return sites


def _all_turn_freely(study: Study) -> bool:
    return not axes(study) and all(not is_zero(state.omega) for state in study.system.bodies.values())


# --- the motion of bodies


def _wrong_sense(study: Study) -> Iterator[Site]:
    """ω and α of a body with the wrong sense: dθ/dt taken for them where the body turns against θ."""
    for name, state in study.system.bodies.items():
        if state.omega and not is_zero(state.omega) and len(study.system.independent) == 1:
            system = change.with_body(study, name, omega=-state.omega, alpha=-state.alpha)
            yield Site({"body": BodyRef(name)}, partial(change.with_parts, study, system=system))


def _shifted(study: Study) -> list[tuple[str, dict[str, Any]]]:
    """Of several bodies those that are accelerated and turn about no axis."""
    bodies = study.system.bodies
    return [(n, {}) for n, s in bodies.items() if len(bodies) > 1 and n not in axes(study) and s.acceleration != ORIGIN]


def _changed(
    name: str, pick: change.Pick, wrong: change.Wrong, about: frozenset[str], tells: frozenset[str] | None = None, **how: Any
) -> Misconception:
    return Misconception(name, of_forces(pick, wrong, **how), about, tells)


MISCONCEPTIONS = (
    Misconception("force-sign", _force_sign, MOTION, NO_FORCES),
    _changed("torque-sign", _turning_contacts, lambda s, f: _with_couple(f, -2 * _turning(s, f)), MOTION, WELL, drawn=t.Sym),
    # the weight of a body that turns about its end at its other end: the whole length for the half
    _changed("whole-length-for-lever-arm", *_weights_along(_lever, _at_other_end), MOTION, WELL),
    _changed("weight-at-middle-of-shape", _off_middle,
             lambda s, f: replace(f, point=s.system.bodies[f.on].pose.origin), MOTION, WELL),
    _changed("sine-for-cosine", *_weights_along(lambda s, f: _lever(s, f) or _slope(s, f), _mirrored), MOTION),
    _changed("sine-for-cosine-in-lever-arm", _slanting_contacts, _sine_in_arm, MOTION, WELL, drawn=t.Sym),
    Misconception("forces-as-at-rest", _as_at_rest, FORCES, WELL),
    Misconception("f-is-ma-at-contact-point", _at_the_contact, FORCES),
    Misconception("centripetal-forgotten", _speeds_squared(0), FORCES, WELL),
    Misconception("wrong-sense-of-rotation", _wrong_sense, MOTION | {"momentum"}, WELL),
    # a force that turns a body is left out of the motion of its centre of mass, or its torque about that is
    _changed("turning-force-moves-nothing", _off_center,
             lambda s, f: replace(_with_couple(f, _turning(s, f)), vector=ORIGIN), MOTION),
    _changed("force-acts-at-center", _off_center, lambda s, f: _with_couple(f, -_turning(s, f)), MOTION),
    _changed("weight-sign", _falling, lambda s, f: change.opposite(f), DRIVEN, NO_FORCES),
    _changed("weight-left-out", lambda s: _falling(s) if len(s.system.bodies) > 1 else [], lambda s, f: None, MOTION, NO_FORCES),
    _changed("whole-weight-along-slope", *_weights_along(_slope, _whole), DRIVEN | {"friction"}),
    _changed("normal-force-is-weight", *_weights_along(_slope, lambda s, f, along: _whole(s, f, along.turned())), MOTION),
    _changed("one-of-two-parts-of-string", _strings_with_two_parts, lambda s, f: replace(f, vector=f.vector * HALF), MOTION),
    _changed("action-along-reaction", _reactions, lambda s, f: change.opposite(f), MOTION),
    _changed("third-law-forgotten", _reactions, lambda s, f: None, MOTION),
    Misconception("inertia-of-one-body-left-out", without("mass", _shifted), MOTION),  # its M a is for nothing
    Misconception("centripetal-outward", _speeds_squared(-1), FORCES, WELL),
    # the accelerations of a rotation about the point that is at rest just now: that point has one of its own
    Misconception("instantaneous-center-for-accelerations", _speeds_squared(0, _all_turn_freely), FORCES, WELL),
)  # fmt: skip
