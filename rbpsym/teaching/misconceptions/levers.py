"""Misconceptions about single forces: where they act, what they move, which of them there are, and what turns on a curve."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.algebra import NOTHING, ORIGIN, UNITY, Vector, depends_on, is_zero, substitute
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.forces import slope_under
from rbpsym.teaching.misconceptions.model import FORCES, MOTION, NO_FORCES, WELL, Misconception, Site
from rbpsym.teaching.targets import axes

HALF = UNITY / 2
DRIVEN = frozenset({"acceleration", "speed", "frequency", "work"})


def _off_center(study: Study) -> Iterator[tuple[Force, Vector]]:
    """Forces that turn a body with no fixed axis, with their arms about its centre of mass."""
    for force in study.system.forces:
        arm = force.point - study.system.bodies[force.on].center
        if force.law != "gravity" and force.on not in axes(study) and not is_zero(arm.cross(force.vector)):
            yield force, arm


def _turning_force_moves_nothing(study: Study) -> Iterator[Site]:
    """A force that turns a body is left out of the motion of its centre of mass."""
    for force, arm in _off_center(study):
        wrong = replace(force, vector=ORIGIN, couple=force.couple + arm.cross(force.vector))
        yield _site(study, force, wrong)


def _site(study: Study, force: Force, wrong: Force | None) -> Site:
    slots = {"force": t.Vec(force.name), "body": BodyRef(force.on)}
    return Site(slots, partial(change.with_forces, study, lambda f: wrong if f is force else f))


def _acts_at_center(study: Study) -> Iterator[Site]:
    """The torque of a force about the centre of mass is left out."""
    for force, arm in _off_center(study):
        yield _site(study, force, replace(force, couple=force.couple - arm.cross(force.vector)))


def _falling(study: Study) -> list[Force]:
    """The weights that do work while it moves."""
    return [f for f in change.weights(study) if any(depends_on(f.point.y, c) for c in study.system.coordinates)]


def _weight_sign(study: Study) -> Iterator[Site]:
    """The weight drives the motion to the other side."""
    for force in _falling(study):
        yield _site(study, force, change.opposite(force))


def _weight_left_out(study: Study) -> Iterator[Site]:
    """The weight of one of several bodies is left out, its inertia is not."""
    for force in _falling(study) if len(study.system.bodies) > 1 else ():
        yield _site(study, force, None)


def _whole_weight_along(study: Study) -> Iterator[Site]:
    """The whole weight along the slope."""
    for force in change.weights(study):
        along = slope_under(study, force.on)
        if along is not None:
            way = change.sign_of(study, along.dot(force.vector)) or 1
            wrong = replace(force, vector=along * (force.vector.y * -way))
            yield _site(study, force, wrong)


def _whole_weight_across(study: Study) -> Iterator[Site]:
    """N = M g on a slope."""
    for force in change.weights(study):
        along = slope_under(study, force.on)
        if along is not None:
            across = along.turned()
            way = change.sign_of(study, across.dot(force.vector)) or 1
            part = along * along.dot(force.vector)
            yield _site(study, force, replace(force, vector=part + across * (force.vector.y * -way)))


def _one_of_two_parts(study: Study) -> Iterator[Site]:
    """A string that pulls a body with both of its parts is counted once."""
    for force in study.system.forces:
        whole = [force.vector.derivative(name) for name in force.unknowns]
        if len(whole) == 1 and is_zero(whole[0].dot(whole[0]) - 4):
            yield _site(study, force, replace(force, vector=force.vector * HALF))


def _both_the_same_way(study: Study) -> Iterator[Site]:
    """Action and reaction with the same sense."""
    for element in study.problem.constraints:
        pair = [f for f in study.system.forces if f.name == element.name and f.by in study.system.bodies]
        if len(pair) == 2 and not is_zero(pair[1].vector.dot(pair[1].vector)):
            yield _site(study, pair[1], change.opposite(pair[1]))


def _inertia_of_others(study: Study) -> Iterator[Site]:
    """One body of several is accelerated for nothing: its M a is left out."""
    for name, state in study.system.bodies.items():
        if len(study.system.bodies) > 1 and name not in axes(study) and state.acceleration != ORIGIN:
            yield Site({"body": BodyRef(name)}, partial(change.with_inertia, study, name, mass=NOTHING))


def _speeds_squared(study: Study, factor: int) -> Iterator[Site]:
    """What the squares of the speeds add to the forces, taken so many times."""
    still, found = dict.fromkeys(study.system.speeds, NOTHING), {}
    for name, value in study.dynamics.reactions.items():
        rest = substitute(value, still)
        found[name] = rest + (value - rest) * factor
    if any(depends_on(value, speed) for value in found.values() for speed in study.system.speeds) or not factor:
        yield Site({}, partial(change.with_reactions, study, found))


def _centripetal_outward(study: Study) -> Iterator[Site]:
    """The acceleration towards the axis with the wrong sign, as if a force outward were added."""
    yield from _speeds_squared(study, -1)


def _instantaneous_center(study: Study) -> Iterator[Site]:
    """The accelerations of a rotation about the point that is at rest just now: that point has one of its own."""
    free = not axes(study) and all(not is_zero(s.omega) for s in study.system.bodies.values())
    if free and any(depends_on(v, s) for v in study.dynamics.reactions.values() for s in study.system.speeds):
        yield from _speeds_squared(study, 0)


MISCONCEPTIONS = (
    Misconception("turning-force-moves-nothing", _turning_force_moves_nothing, MOTION),
    Misconception("force-acts-at-center", _acts_at_center, MOTION),
    Misconception("weight-sign", _weight_sign, DRIVEN, NO_FORCES),
    Misconception("weight-left-out", _weight_left_out, MOTION, NO_FORCES),
    Misconception("whole-weight-along-slope", _whole_weight_along, DRIVEN | {"friction"}),
    Misconception("normal-force-is-weight", _whole_weight_across, MOTION),
    Misconception("one-of-two-parts-of-string", _one_of_two_parts, MOTION),
    Misconception("action-along-reaction", _both_the_same_way, MOTION),
    Misconception("inertia-of-one-body-left-out", _inertia_of_others, MOTION),
    Misconception("centripetal-outward", _centripetal_outward, FORCES, WELL),
    Misconception("instantaneous-center-for-accelerations", _instantaneous_center, FORCES, WELL),
)
