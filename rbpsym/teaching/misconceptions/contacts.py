"""Misconceptions about contacts: v = R ω while it slips, friction along the slip, the torque about a point that accelerates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.algebra import NOTHING, depends_on, derivative, is_zero, short
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.model import Element
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import ENERGY, MOTION, WELL, Misconception, Site

SHOWN_AT_ONCE = frozenset({"acceleration", "frequency"})


def _slipping(study: Study) -> list[Element]:
    """Contacts with kinetic friction."""
    return [e for e in study.problem.of_kind("touch") if e.values.get("coefficient") is not None]


def _slots(element: Element) -> dict:
    return {"body": BodyRef(element["body"]), "friction": t.Sym(element["friction"])}


def _rolls_while_slipping(study: Study) -> Iterator[Site]:
    """v = R ω as a law, also while it slips."""
    for element in _slipping(study):
        kept = {key: value for key, value in element.values.items() if key not in ("coefficient", "slip")}
        rolling = Element(element.name, "rolling", {**kept, "limit": None}, element.place)
        yield Site(_slots(element), partial(change.with_element, study, element, rolling))


def _along_the_slip(study: Study) -> Iterator[Site]:
    """Kinetic friction to the side to which the point of contact slips."""
    for element in _slipping(study):
        yield Site(_slots(element), partial(change.with_force, study, element["friction"], change.opposite))


def _friction_left_out(study: Study) -> Iterator[Site]:
    """It slides as if the floor were smooth."""
    for element in _slipping(study):
        wrong = element.with_values(coefficient=None)
        yield Site(_slots(element), partial(change.with_element, study, element, wrong))


def _about_accelerating_contact(study: Study) -> Iterator[Site]:
    """τ = I α about the point of contact of a body whose centre of mass is not above it: M a of that point is left out."""
    system = study.system
    if len(system.bodies) != 1 or len(system.independent) != 1 or not study.dynamics.accelerations:
        return
    [(name, state)], [coordinate] = system.bodies.items(), system.independent
    for element in study.problem.of_kind("rolling"):
        point = meeting(element, geometry_of(system)).place
        arm, push = state.center - point, f"{coordinate}_ddot"
        known = (f.torque(point) for f in system.forces if not f.unknowns)
        rate = short(derivative(state.alpha, push))
        whole = (state.moment + state.mass * arm.dot(arm)) * rate
        if element["of"] is not None or is_zero(whole) or not any(depends_on(arm.dot(arm), c) for c in system.coordinates):
            continue
        value = short(sum(known, NOTHING) / whole)
        dynamics = replace(study.dynamics, accelerations={push: value})
        wrong = partial(change.with_parts, study, system=system, dynamics=dynamics, first_integral=None)
        yield Site({"body": BodyRef(name)}, wrong)


def _static_friction_drains(study: Study) -> Iterator[Site]:
    """The work of static friction on the centre of mass is counted as lost."""
    energy, known = study.first_integral, study.reactions_along_motion or {}
    for element in study.problem.of_kind("rolling"):
        own = [w for w in study.works if w.force == element["friction"] and w.translational.value is not None]
        if energy is not None and len(own) == 1 and element["friction"] in known:
            lost = energy - own[0].translational.value
            kept = {"system": study.system, "dynamics": study.dynamics, "kinetic": study.kinetic}
            yield Site(_slots(element), partial(change.with_parts, study, **kept, first_integral=lost))


MISCONCEPTIONS = (
    Misconception("rolls-while-slipping", _rolls_while_slipping, MOTION),
    Misconception("friction-along-slip", _along_the_slip, MOTION),
    Misconception("kinetic-friction-left-out", _friction_left_out, MOTION),
    Misconception("torque-about-accelerating-contact", _about_accelerating_contact, SHOWN_AT_ONCE, WELL),
    Misconception("static-friction-drains-energy", _static_friction_drains, ENERGY),
)
