"""Misconceptions about how bodies are joined: bearing and weld, contacts that roll or slip, strings, springs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, depends_on, derivative, is_zero, short
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Body, Element, Turn
from rbpsym.statement.solids import put_into
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.energy import with_energy
from rbpsym.teaching.misconceptions.model import (
    ENERGY,
    FORCES,
    MOTION,
    NO_INERTIA,
    SPIN,
    WELL,
    Misconception,
    Site,
    of_elements,
    without,
)

SHOWN_AT_ONCE = frozenset({"acceleration", "frequency"})


# --- bearings and welds


def _borne(study: Study) -> Iterator[tuple[Element, str, str]]:
    """Bearings between two bodies of which the second can turn: (element, carrier, body)."""
    for element in study.problem.of_kind("pin"):
        first, second = (ref.body for ref in element["points"])
        if first is not None and second is not None and study.system.bodies[second].moment:
            yield element, first, second


def _free_as_welded(study: Study) -> Iterator[Site]:
    """A body on a bearing turns with the one that carries it."""
    for element, first, second in _borne(study):
        if study.problem.body(second).angle is not None:
            yield Site({"body": BodyRef(second), "carrier": BodyRef(first)}, partial(_welded, study, element, second))


def _welded(study: Study, element: Element, body: str) -> Study:
    """The statement with a weld for the bearing; what told the body's own angle goes."""
    own = study.problem.body(body).angle
    used = {n for b in study.problem.bodies if b.name != body for n in _names(b)}
    gone = (t.names(own) if own else set()) - used
    weld = Element(element.name, "weld", {**element.values, "angle": None, "couple": f"tau_{element.name}"}, element.place)
    problem = replace(
        study.problem,
        bodies=tuple(replace(b, angle=None) if b.name == body else b for b in study.problem.bodies),
        coordinates=tuple(c for c in study.problem.coordinates if c.name not in gone),
        constraints=tuple(weld if e is element else e for e in study.problem.constraints),
    )
    return Study(problem)


def _names(body: Body) -> set[str]:
    nodes = [body.angle, *(body.placed[1] if body.placed else ())]
    return {name for node in nodes if node is not None for name in t.names(node)}


def _welded_ones(study: Study) -> Iterator[tuple[str, Mapping[str, Any]]]:
    names = (element["points"][1].body for element in study.problem.of_kind("weld"))
    return ((name, {}) for name in names if name is not None and study.system.bodies[name].moment)


def _spin_of_carrier(study: Study) -> Iterator[Site]:
    """The angular velocity of the carrier is used for the body on it (in momentum and energy)."""
    for _, first, second in _borne(study):
        carrier = study.system.bodies[first]
        system = change.with_body(study, second, omega=carrier.omega, alpha=carrier.alpha)
        yield Site({"body": BodyRef(second), "carrier": BodyRef(first)}, partial(change.with_kinematics, study, system))


def _one_radius(study: Study) -> Iterator[Site]:
    """Rim and hub of a wheel with two radii taken to have one speed: the one radius stands for the other."""
    for name in study.system.bodies:
        radii = list(dict.fromkeys(r for e in study.problem.elements for r in _radii(e, name) if isinstance(r, t.Sym)))
        for one, other in pairwise(radii):
            yield Site({"body": BodyRef(name)}, partial(_with_value, study, {other.name: one}))


def _radii(element: Element, body: str) -> Iterator[t.Node | None]:
    """At which radii of a body strings or contacts act."""
    yield from (part.radius for part in element.values.get("path", ()) if isinstance(part, Turn) and part.body == body)
    if element.values.get("body") == body:
        yield element.values.get("rim")


def _with_value(study: Study, values: Mapping[str, t.Node]) -> Study:
    parts = ("bodies", "interactions", "constraints")
    return Study(replace(study.problem, **{part: put_into(getattr(study.problem, part), values) for part in parts}))


# --- contacts that roll or slip


def _slipping(study: Study) -> list[Element]:
    """Contacts with kinetic friction."""
    return [e for e in study.problem.of_kind("touch") if e.values.get("coefficient") is not None]


def _rolling(study: Study) -> Iterable[Element]:
    return study.problem.of_kind("rolling")


def _stretched(study: Study) -> Iterable[Element]:
    """Springs that are not without length."""
    return (e for e in study.problem.interactions if e.kind == "spring" and change.is_nonzero(e["natural_length"]))


def _slots(element: Element) -> Mapping[str, Any]:
    return {"body": BodyRef(element["body"]), "friction": t.Sym(element["friction"])}


def _as_rolling(element: Element) -> Element:
    """v = R ω as a law, also while it slips."""
    kept = {key: value for key, value in element.values.items() if key not in ("coefficient", "slip")}
    return Element(element.name, "rolling", {**kept, "limit": None}, element.place)


def _touching(element: Element, coefficient: t.Node | None = None, slip: str = "auto") -> Element:
    """It slides; without a coefficient like a block on what is smooth."""
    kept = {key: value for key, value in element.values.items() if key != "limit"}
    return Element(element.name, "touch", {**kept, "coefficient": coefficient, "slip": slip}, element.place)


def _along_the_slip(study: Study) -> Iterator[Site]:
    """Kinetic friction to the side to which the point of contact slips."""
    for element in _slipping(study):
        yield Site(_slots(element), partial(change.with_force, study, element["friction"], change.opposite))


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
    for element in _rolling(study):
        works = (w.translational.value for w in study.works if w.force == element["friction"])
        own = [value for value in works if value is not None]
        if energy is not None and len(own) == 1 and element["friction"] in known:
            yield Site(_slots(element), partial(with_energy, study, energy - own[0]))


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
    for element in _rolling(study):
        turned = partial(_turned, study)
        yield Site({"friction": t.Sym(element["friction"])}, partial(change.with_force, study, element["friction"], turned))


def _turned(study: Study, force: Force) -> Force:
    arm = force.point - study.system.bodies[force.on].center
    return replace(force, vector=-force.vector, couple=force.couple + 2 * arm.cross(force.vector))


# --- strings


def _held(study: Study) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """What hangs on a string or a joint, with that."""
    held = study.problem.of_kind("string", "pin")
    return ((name, {"force": t.Sym(element.name)}) for element in held for name in _hanging(study, element))


def _hanging(study: Study, element: Element) -> list[str]:
    """Bodies that nothing but this element and gravity holds."""
    own = {f.on for f in study.system.forces if study.system.element(f.name) is element}
    others = {f.on for f in study.system.forces if f.law != "gravity" and study.system.element(f.name) is not element}
    return sorted(own - others) if len(study.system.bodies) > 1 else []


def _pulleys(study: Study) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Round bodies that a string turns; on a body at its end it is wound, and there is one side."""
    turns = (turn for element in study.problem.of_kind("string") for turn in element["path"][1:-1])
    return ((n.body, {}) for n in turns if n.sense and n.body is not None and study.system.bodies[n.body].moment)


MISCONCEPTIONS = (
    Misconception("free-taken-as-welded", _free_as_welded, SPIN, WELL),
    Misconception("welded-taken-as-free", without("moment", _welded_ones), SPIN, NO_INERTIA),
    Misconception("spin-of-carrier", _spin_of_carrier, frozenset({"momentum", "kinetic"}), WELL),
    Misconception("rim-and-hub-alike", _one_radius, MOTION),
    Misconception("rolling-taken-as-sliding", of_elements(_rolling, _touching, _slots), MOTION),
    Misconception("friction-is-mu-n", _friction_is_mu_n, MOTION),
    Misconception("friction-wrong-way", _friction_wrong_way, MOTION),
    Misconception("tension-is-weight", without("mass", _held), MOTION | FORCES),
    Misconception("same-tension-on-both-sides", without("moment", _pulleys), MOTION),
    Misconception("rolls-while-slipping", of_elements(_slipping, _as_rolling, _slots), MOTION),
    Misconception("friction-along-slip", _along_the_slip, MOTION),
    Misconception("kinetic-friction-left-out", of_elements(_slipping, lambda e: e.with_values(coefficient=None), _slots), MOTION),
    Misconception("torque-about-accelerating-contact", _about_accelerating_contact, SHOWN_AT_ONCE, WELL),
    Misconception("static-friction-drains-energy", _static_friction_drains, ENERGY),
    Misconception("length-for-elongation", of_elements(
        _stretched, lambda e: e.with_values(natural_length=t.ZERO), lambda e: {"force": t.Vec(e.name)}), MOTION, WELL),
)  # fmt: skip
