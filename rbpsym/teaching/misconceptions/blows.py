"""Misconceptions about blows: what is kept, about which point, and what is not."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from rbpsym.decide.rooted import rooted
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Vector, function, substitute
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import PointRef
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import Misconception, Site
from rbpsym.teaching.targets import axes

ASKED = frozenset({"question"})


def _momentum_kept_at_hinge(study: Study) -> Iterator[Site]:
    """p is kept when something strikes a hinged body, as if the hinge gave no impulse: M V = J for I ω = J b.

    The same speeds come of a body whose moment about the hinge is M d b: that is how it is worked out.
    """
    for body, arm, reach in _struck(study):
        state = study.system.bodies[body]
        wrong = state.mass * arm * (reach - arm)
        yield Site({"body": BodyRef(body)}, partial(_with_moment, study, body, wrong))


def _struck_at_center(study: Study) -> Iterator[Site]:
    """The impulse on a hinged body is given the lever arm of its centre of mass."""
    for body, arm, reach in _struck(study):
        state = study.system.bodies[body]
        whole = state.moment + state.mass * axes(study)[body][1]
        yield Site({"body": BodyRef(body)}, partial(_with_moment, study, body, whole * reach / arm - state.mass * arm * arm))


def _struck(study: Study) -> Iterator[tuple[str, Scalar, Scalar]]:
    """Bodies on a hinge that are struck: the distances of the centre of mass and of the impulse's line from the hinge."""
    geometry, start = geometry_of(study.system), study.system.scope.start
    for ref, line in (*_impulses(study), *((on, study.system.bodies[come].velocity) for on, come in _joined(study))):
        size = rooted(function("sqrt", substitute(line.dot(line), start)), study.assumptions)
        if (body := ref.body or "") in axes(study) and size:
            hinge = study.origins[axes(study)[body][0]]
            places = (study.system.bodies[body].center, geometry.where(ref))
            arm, reach = (substitute((at - hinge).cross(line), start) / size for at in places)
            if arm and reach:
                yield body, arm, reach


def _impulses(study: Study) -> Iterator[tuple[PointRef, Vector]]:
    """Where collisions and blows act, and along which line."""
    for element in (e for phase in study.problem.phases for e in phase.impulses):
        if element.kind == "collision":
            yield from ((ref, pair(element["along"])) for ref in element["points"])
        elif element.kind == "blow":
            yield element["on"], pair(element["impulse"])


def _joined(study: Study) -> Iterator[tuple[PointRef, str]]:
    """Bodies that come on in a phase and were free before, and the point of the other on which they come."""
    held = {ref.body for e in study.problem.constraints for ref in e.values.get("points", ())}
    for phase in study.problem.phases:
        for element in phase.problem.of_kind("pin", "weld"):
            first, second = element["points"]
            if element not in study.problem.constraints and first.body and second.body and second.body not in held:
                yield first, second.body


def _with_moment(study: Study, body: str, moment: Scalar) -> Study:
    return change.restated(study, body, given_moment=present(moment, study.style))


def _spin_kept(study: Study) -> Iterator[Site]:
    """ω, not L, is kept when a body comes on: its part of the moment of inertia is left out."""
    for on, body in _joined(study):
        carrier = on.body or ""
        if substitute(study.system.bodies[carrier].omega, study.system.scope.start):
            yield Site({"body": BodyRef(body), "carrier": BodyRef(carrier)}, partial(_without_mass, study, body))


def _without_mass(study: Study, body: str) -> Study:
    return change.restated(study, body, given_moment=t.ZERO, mass=t.ZERO)


MISCONCEPTIONS = (
    Misconception("momentum-kept-at-hinge", _momentum_kept_at_hinge, ASKED),
    Misconception("struck-at-center-of-mass", _struck_at_center, ASKED),
    Misconception("angular-velocity-kept", _spin_kept, ASKED),
)
