"""Misconceptions about how bodies are joined: bearing and weld, rolling and sliding, the third law."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.algebra import NOTHING, UNITY
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.model import Element
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import FORCES, MOTION, NO_INERTIA, SPIN, WELL, Misconception, Site


def _free_as_welded(study: Study) -> Iterator[Site]:
    """A body on a bearing turns with the one that carries it."""
    for element in study.problem.of_kind("pin"):
        first, second = (ref.body for ref in element["points"])
        body = None if second is None else study.problem.body(second)
        if first is None or body is None or body.angle is None or not study.system.bodies[second].moment:
            continue
        yield Site({"body": BodyRef(second), "carrier": BodyRef(first)}, partial(_welded, study, element, second))


def _welded(study: Study, element: Element, body: str) -> Study:
    """The statement with a weld for the bearing; what told the body's own angle goes."""
    own = t.names(study.problem.body(body).angle)
    used = {n for b in study.problem.bodies if b.name != body for n in _names(b)}
    gone = {c.name for c in study.problem.coordinates if c.name in own - used}
    weld = Element(
        element.name, "weld", {**element.values, "angle": None, "couple": f"tau_{element.name}"}, element.place
    )
    problem = replace(
        study.problem,
        bodies=tuple(replace(b, angle=None) if b.name == body else b for b in study.problem.bodies),
        coordinates=tuple(c for c in study.problem.coordinates if c.name not in gone),
        constraints=tuple(weld if e is element else e for e in study.problem.constraints),
    )
    return Study(problem)


def _names(body) -> set[str]:
    nodes = [body.angle, *(body.placed[1] if body.placed else ())]
    return {name for node in nodes if node is not None for name in t.names(node)}


def _welded_as_free(study: Study) -> Iterator[Site]:
    """A body that is fixed to another is taken not to turn with it: its I_cm is missing."""
    for element in study.problem.of_kind("weld"):
        name = element["points"][1].body
        if name is not None and study.system.bodies[name].moment:
            yield Site({"body": BodyRef(name)}, partial(change.with_inertia, study, name, moment=NOTHING))


def _spin_of_carrier(study: Study) -> Iterator[Site]:
    """The angular velocity of the carrier is used for the body on it (in momentum and energy)."""
    for element in study.problem.of_kind("pin"):
        first, second = (ref.body for ref in element["points"])
        if first is None or second is None or not study.system.bodies[second].moment:
            continue

        carrier = study.system.bodies[first]
        system = change.with_body(study, second, omega=carrier.omega, alpha=carrier.alpha)
        yield Site({"body": BodyRef(second), "carrier": BodyRef(first)}, partial(change.with_kinematics, study, system))


def _third_law_forgotten(study: Study) -> Iterator[Site]:
    """The force between two bodies is counted on one of them only."""
    for element in study.problem.constraints:
        pair = [f for f in study.system.forces if f.name == element.name and f.by in study.system.bodies]
        if len(pair) == 2:
            carrier = pair[1].on
            slots = {"force": t.Vec(element.name), "body": BodyRef(carrier)}
            yield Site(slots, partial(_without, study, element.name, carrier))


def _without(study: Study, name: str, body: str) -> Study:
    return change.with_forces(study, lambda force: None if (force.name, force.on) == (name, body) else force)


def _rolling_as_sliding(study: Study) -> Iterator[Site]:
    """No friction where a body rolls: it slides down like a block."""
    for element in study.problem.of_kind("rolling"):
        friction = element["friction"]
        slots = {"body": BodyRef(element["body"]), "friction": t.Sym(friction)}
        yield Site(slots, partial(change.with_element, study, element, _touching(element, None, "auto")))


def _touching(element: Element, coefficient: t.Node | None, slip: str) -> Element:
    kept = {key: value for key, value in element.values.items() if key != "limit"}
    return Element(element.name, "touch", {**kept, "coefficient": coefficient, "slip": slip}, element.place)


def _friction_is_mu_n(study: Study) -> Iterator[Site]:
    """f = μN though nothing slips: the balance of forces with the greatest friction there can be."""
    for element in study.problem.of_kind("rolling"):
        if element["limit"] is not None:
            slots = {"friction": t.Sym(element["friction"]), "normal": t.Sym(element.name), "mu": element["limit"]}
            yield Site(slots, partial(_with_greatest_friction, study, element))


def _with_greatest_friction(study: Study, element: Element) -> Study:
    """Kinetic friction, to the side to which the static friction pushes."""
    name = element["friction"]
    force = study.system.named(name)[0]
    push = force.vector.substitute({name: UNITY}).dot(meeting(element, geometry_of(study.system)).forward)
    way = change.sign_of(study, push) * change.sign_of(study, study.dynamics.reactions[name])
    slip = "backward" if way > 0 else "forward"
    return change.with_element(study, element, _touching(element, element["limit"], slip))


def _friction_wrong_way(study: Study) -> Iterator[Site]:
    """Static friction drawn to the other side in the balance of forces, its torque left right."""
    for element in study.problem.of_kind("rolling"):
        friction = element["friction"]

        def turned(force, name: str = friction):
            if force.name != name:
                return force
            arm = force.point - study.system.bodies[force.on].center
            return replace(force, vector=-force.vector, couple=force.couple + 2 * arm.cross(force.vector))

        yield Site({"friction": t.Sym(friction)}, lambda turned=turned: change.with_forces(study, turned))


def _held_is_weight(study: Study) -> Iterator[Site]:
    """The tension (or the force of the joint) equals the weight of what hangs on it: that body's M a is forgotten."""
    for element in study.problem.of_kind("string", "pin"):
        for name in _hanging(study, element):
            slots = {"force": t.Sym(element.name), "body": BodyRef(name)}
            yield Site(slots, partial(change.with_inertia, study, name, mass=NOTHING))


def _hanging(study: Study, element: Element) -> list[str]:
    """Bodies that nothing but this element and gravity holds."""
    own = {f.on for f in study.system.forces if study.system.element(f.name) is element}
    others = {f.on for f in study.system.forces if f.law != "gravity" and study.system.element(f.name) is not element}
    return sorted(own - others) if len(study.system.bodies) > 1 else []


def _pulley_at_rest(study: Study) -> Iterator[Site]:
    """A string's tension is the same on both sides of a round body that it turns: its I_cm is left out."""
    for element in study.problem.of_kind("string"):
        for turn in element["path"]:
            name = turn.body
            if turn.sense and name is not None and study.system.bodies[name].moment:
                yield Site({"body": BodyRef(name)}, partial(change.with_inertia, study, name, moment=NOTHING))


MISCONCEPTIONS = (
    Misconception("free-taken-as-welded", _free_as_welded, SPIN, WELL),
    Misconception("welded-taken-as-free", _welded_as_free, SPIN, NO_INERTIA),
    Misconception("spin-of-carrier", _spin_of_carrier, frozenset({"momentum", "kinetic"}), WELL),
    Misconception("third-law-forgotten", _third_law_forgotten, MOTION),
    Misconception("rolling-taken-as-sliding", _rolling_as_sliding, MOTION),
    Misconception("friction-is-mu-n", _friction_is_mu_n, MOTION),
    Misconception("friction-wrong-way", _friction_wrong_way, MOTION),
    Misconception("tension-is-weight", _held_is_weight, MOTION | FORCES),
    Misconception("same-tension-on-both-sides", _pulley_at_rest, MOTION),
)
