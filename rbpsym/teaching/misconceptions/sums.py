"""Misconceptions about sums: halves and parts of energies and momenta that are forgotten, counted twice or turned round."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.algebra import NOTHING, ORIGIN, Scalar, is_zero, short, symbol
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.motion import Work, along_motion
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import ENERGY, WELL, WORKS, Misconception, Site

KINETIC = ENERGY | {"kinetic"}


def _with_kinetic(study: Study, translational: Scalar, rotational: Scalar) -> Iterator[Site]:
    """Another kinetic energy, and the speed that follows from it."""
    if study.potential is not None and (translational, rotational) != study.kinetic:
        kept = {"system": study.system, "dynamics": study.dynamics, "kinetic": (translational, rotational)}
        energy = translational + rotational + study.potential
        yield Site({}, partial(change.with_parts, study, **kept, first_integral=energy))


def _no_translational_energy(study: Study) -> Iterator[Site]:
    """½ I ω² is all."""
    if study.kinetic[1]:
        yield from _with_kinetic(study, NOTHING, study.kinetic[1])


def _no_half(study: Study) -> Iterator[Site]:
    """M V² for ½ M V², and I ω² for ½ I ω²."""
    yield from _with_kinetic(study, study.kinetic[0] * 2, study.kinetic[1] * 2)


def _no_half_in_rotation(study: Study) -> Iterator[Site]:
    """I ω² for ½ I ω²."""
    if study.kinetic[0]:
        yield from _with_kinetic(study, study.kinetic[0], study.kinetic[1] * 2)


def _directed_energy(study: Study) -> Iterator[Site]:
    """Energies of rotations in opposite senses taken to subtract."""
    states = [state for _, state in change.spinning(study)]
    turning = [(state, change.sign_of(study, short(state.omega / states[0].omega))) for state in states]
    if {way for _, way in turning} == {1, -1}:
        total = sum((s.moment * s.omega * s.omega * way for s, way in turning), NOTHING) / 2
        yield from _with_kinetic(study, study.kinetic[0], total)


def _no_half_in_spring(study: Study) -> Iterator[Site]:
    """k s² for ½ k s²."""
    for element in study.problem.interactions:
        if element.kind != "spring" or study.first_integral is None:
            continue
        stiff = element.with_values(stiffness=t.mul(t.TWO, element["stiffness"]))
        potential = change.with_element(study, element, stiff).potential
        if potential is not None:
            kept = {"system": study.system, "dynamics": study.dynamics, "kinetic": study.kinetic}
            energy = sum(study.kinetic, NOTHING) + potential
            yield Site({"force": t.Vec(element.name)}, partial(change.with_parts, study, **kept, first_integral=energy))


def _uniform_acceleration(study: Study) -> Iterator[Site]:
    """v² = v₀² + 2 a s with an acceleration that changes on the way."""
    start = study.system.scope.start
    for name in study.squares:
        push = (study.dynamics.accelerations or {}).get(f"{name}_ddot")
        here = None if push is None else along_motion(push, study.squares)
        if here is not None and name in start:
            first = start.get(f"{name}_dot", NOTHING)
            square = first * first + here * (symbol(name) - start[name]) * 2
            squares = {**study.squares, name: square}
            kept = {"system": study.system, "dynamics": study.dynamics}
            yield Site({"coordinate": t.Sym(name)}, partial(change.with_parts, study, **kept, squares=squares))


def _one_body_forgotten(study: Study) -> Iterator[Site]:
    """One body is not counted in the sum over the system."""
    for name, state in study.system.bodies.items():
        if len(study.system.bodies) > 1 and (state.velocity != ORIGIN or state.omega):
            still = change.with_body(study, name, velocity=ORIGIN, omega=NOTHING)
            yield Site({"body": BodyRef(name)}, partial(change.with_kinematics, study, still))


def _sine_for_cosine(study: Study) -> Iterator[Site]:
    """The component of the momentum along the lever arm for the one across it."""
    for name, state in study.system.bodies.items():
        arm = state.center - study.origins["O"]
        if not is_zero(arm.dot(state.velocity)):
            turned = change.with_body(study, name, velocity=state.velocity.turned())
            yield Site({"body": BodyRef(name)}, partial(change.with_kinematics, study, turned))


def _work_sign(study: Study) -> Iterator[Site]:
    """Both works of a force with the wrong sign."""
    for item in study.works:
        halves = {h: getattr(item, h) for h in ("translational", "rotational")}
        if None not in (half.value for half in halves.values()):
            turned = replace(item, **{name: Work(half.parts, -half.value) for name, half in halves.items()})
            works = tuple(turned if w is item else w for w in study.works)
            wrong = partial(change.with_kinematics, study, study.system, works=works)
            yield Site({"force": t.Vec(item.force), "body": BodyRef(item.on)}, wrong)


SUMS = frozenset({"momentum", "kinetic"})

MISCONCEPTIONS = (
    Misconception("translational-energy-left-out", _no_translational_energy, KINETIC, WELL),
    Misconception("half-forgotten-in-kinetic-energy", _no_half, KINETIC, WELL),
    Misconception("half-forgotten-in-rotational-energy", _no_half_in_rotation, KINETIC, WELL),
    Misconception("rotational-energies-subtract", _directed_energy, KINETIC, WELL),
    Misconception("half-forgotten-in-spring-energy", _no_half_in_spring, ENERGY),
    Misconception("uniform-acceleration-formula", _uniform_acceleration, frozenset({"speed"})),
    Misconception("one-body-not-in-the-sum", _one_body_forgotten, SUMS, WELL),
    Misconception("sine-for-cosine-in-momentum", _sine_for_cosine, frozenset({"momentum"})),
    Misconception("work-sign", _work_sign, WORKS),
)
