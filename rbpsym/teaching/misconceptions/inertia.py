"""Misconceptions about how mass resists turning: I_cm, the axis, the parallel-axis theorem, the shape."""

from __future__ import annotations

from collections.abc import Container, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial, reduce

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, is_zero, names_in
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import BodyRef
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import INERTIA, NO_INERTIA, SPIN, WELL, Misconception, Site, Sites, without
from rbpsym.teaching.targets import axes

ROUND = {"disk": Fraction(1, 2), "ring": Fraction(1), "ball": Fraction(2, 5), "shell": Fraction(2, 3)}


def _moment(study: Study, name: str, moment: Scalar, **slots: object) -> Site:
    """A body with another moment of inertia."""
    return Site({"body": BodyRef(name), **slots}, partial(change.with_inertia, study, name, moment=moment))


def _scaled(factor: int | Fraction, kinds: Container[str]) -> Sites:
    """I_cm of these shapes times a factor."""

    def sites(study: Study) -> Iterator[Site]:
        for name, state in change.spinning(study):
            if study.problem.body(name).shape.kind in kinds:
                yield _moment(study, name, state.moment * factor)

    return sites


def _shifted(times: int) -> Sites:
    """M d² of the axis so many times more than the parallel-axis theorem says."""

    def sites(study: Study) -> Iterator[Site]:
        for name, (label, square) in axes(study).items():
            state = study.system.bodies[name]
            if state.moment or times > 0:
                yield _moment(study, name, state.moment + state.mass * square * times, point=t.Sym(label))

    return sites


def _all_at_centers(study: Study) -> Iterator[Site]:
    """Every body a point mass (the simple pendulum instead of the compound one)."""
    names = [name for name, _ in change.spinning(study)]
    if len(names) > 1:
        yield Site({}, lambda: reduce(lambda found, name: change.with_inertia(found, name, moment=NOTHING), names, study))


def _about_end(study: Study) -> Iterator[Site]:
    """The moment about the end of a rod used as that about its centre (or a third for a twelfth)."""
    for name, state in change.spinning(study):
        shape = study.problem.body(name).shape
        if name in axes(study) or "length" not in shape.sizes:
            continue
        half = scalar(shape.sizes["length"]) / 2
        yield _moment(study, name, state.moment + state.mass * half * half)


def _center_for_end(study: Study) -> Iterator[Site]:
    """The moment of a rod about its centre taken for that about its end: a twelfth where the axis asks for a third."""
    for name, (label, square) in axes(study).items():
        state, shape = study.system.bodies[name], study.problem.body(name).shape
        if shape.kind == "rod" and is_zero(state.mass * square * 4 - state.mass * scalar(shape.sizes["length"]) ** 2):
            continue  # that is “axis forgotten”
        if shape.kind == "rod":
            end = (scalar(shape.sizes["length"]) / 2) ** 2
            yield _moment(study, name, state.moment + state.mass * (end - square), point=t.Sym(label))


def _another_shape(study: Study) -> Iterator[Site]:
    """The factor of another round shape: ½, 1, 2/5, 2/3 of M R²."""
    for name, state in change.spinning(study):
        shape = study.problem.body(name).shape
        if shape.kind not in ROUND or "radius" not in shape.sizes:
            continue
        radius = scalar(shape.sizes["radius"])
        if names_in(state.mass) & names_in(radius):
            continue  # its moment of inertia is what is given: M R² stands for it
        for kind, share in ROUND.items():
            if kind != shape.kind:
                yield _moment(study, name, state.mass * radius * radius * share, variant=kind)


def _mass_dropped(study: Study) -> Iterator[Site]:
    """A body that hangs on another is left out: its weight and its inertia (but for a spin of its own)."""
    for element in study.problem.of_kind("pin", "weld"):
        name = element["points"][1].body
        if name is None or len(study.system.bodies) < 2:
            continue

        spin = {"moment": NOTHING} if element.kind == "weld" else {}
        wrong = replace(study.system.bodies[name].inertia, mass=NOTHING, **spin)
        forces = tuple(f for f in study.system.forces if not (f.law == "gravity" and f.on == name))
        system = replace(change.with_body(study, name, inertia=wrong), forces=forces)
        yield Site({"body": BodyRef(name)}, partial(change.with_parts, study, system=system))


MISCONCEPTIONS = (
    # a body taken for a point mass at its centre
    Misconception("spin-dropped", without("moment", lambda s: ((n, {}) for n, _ in change.spinning(s))), SPIN, NO_INERTIA),
    Misconception("all-mass-at-centers", _all_at_centers, SPIN, NO_INERTIA),
    Misconception("parallel-axis-forgotten", _shifted(-1), SPIN, NO_INERTIA),  # I_O - M d² for I_cm: the whole is I_cm
    Misconception("parallel-axis-twice", _shifted(1), SPIN, NO_INERTIA),
    Misconception("moment-about-wrong-point", _about_end, INERTIA, WELL),
    Misconception("end-of-rod-taken-for-axis", _center_for_end, SPIN, NO_INERTIA),
    Misconception("moment-of-another-shape", _another_shape, INERTIA, WELL),
    Misconception("diameter-for-radius", _scaled(4, ROUND), INERTIA, WELL),
    Misconception("half-length-for-length", _scaled(Fraction(1, 4), ["rod"]), INERTIA, WELL),
    Misconception("shift-by-whole-length", _shifted(3), SPIN, NO_INERTIA),  # from the far end: twice the distance
    Misconception("mass-dropped", _mass_dropped, SPIN),
)
