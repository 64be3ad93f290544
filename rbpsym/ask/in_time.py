"""Moments of a motion that is known as a function of the time."""

from __future__ import annotations

from contextlib import suppress

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.scalar import Scalar
from rbpsym.ask.moments import Asked, Moment
from rbpsym.derivation.chapters import course, oscillations
from rbpsym.derivation.draft import Draft
from rbpsym.errors import NotApplicable
from rbpsym.mechanics import solutions
from rbpsym.mechanics.endings import State, uniform_motion


def at_time(asked: Asked, place: int, time: Scalar, manner: str = "") -> Moment:
    """The state at a time after the start of a phase. Raises NotApplicable where that has no closed form."""
    study = asked.study(place)
    if not manner:
        with suppress(NotApplicable):
            return Moment(place, uniform_motion(study, time), "time")
    found = solutions.courses_of(study, manner)
    places = {name: substitute(one.whole, {"t": time}) for name, one in found.items()}
    speeds = {name: substitute(one.speed, {"t": time}) for name, one in found.items()}
    valid = tuple(demand for one in found.values() for demand in one.valid)
    return Moment(place, State(time, places, speeds, valid), "time", courses=found, is_small=solutions.SMALL in manner)


def write(draft: Draft, moment: Moment) -> None:
    """The steps that say the motion as a function of the time, after those on which they rest."""
    laws = {}
    if moment.is_small:
        oscillations.write(draft)
        near = (step for step in draft.steps if step.rule == "linearization" and step.data["proved"] != "unstable")
        laws = {step.data["name"]: step.id for step in near}
    draft.chapter = "course"
    for name, one in moment.courses.items():
        course.told(draft, name, one, laws.get(name, ""))
