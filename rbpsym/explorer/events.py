"""What happens in the explorer and what it is called: events that end a phase, impulses with which one begins."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import UNITY, Scalar, Vector, depends_on, is_zero, polar, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import geometry_of, slip_senses, spare
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.impulse import impulsive, restitutions
from rbpsym.mechanics.phases import HandOver, Stage
from rbpsym.mechanics.strings import pieces
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force, System
from rbpsym.pictures.sketches import force_node
from rbpsym.present.forms import present
from rbpsym.statement.model import Coordinate, Phase
from rbpsym.typeset.accents import accented
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.speech import to_speech
from rbpsym.typeset.text import to_text

Event = dict[str, Any]


def events(study: Study, goal: tuple[str, Scalar] | None) -> Iterator[Event]:
    """What ends the phase, with the scalar that is positive until then (one that reaches zero from either side)."""
    yield from [{"kind": "reaches", "name": goal[0], "value": goal[1]}] if goal is not None else ()
    for element in study.problem.constraints:
        for name in pushes(element):
            kind = "slack" if element.kind == "string" else "lost"
            yield {"kind": kind, "name": name, "value": symbol(name)}
        if element.values.get("friction") in study.system.unknowns:
            for left in spare(element, symbol):
                yield {"kind": "slips", "name": element.name, "value": left}
    yield from _slips(study)
    yield from _used_up(study)
    yield from _left(study)
    for coordinate in study.problem.coordinates:
        yield from _edges(coordinate)


def _slips(study: Study) -> Iterator[Event]:
    geometry, senses = geometry_of(study.system), slip_senses(study.system)
    for name, sense in senses.items():
        slip = slip_speed(geometry, meeting(study.system.element(name), geometry))
        yield {"kind": "holds", "name": name, "value": slip * sense}


def _used_up(study: Study) -> Iterator[Event]:
    """The straight pieces of a string between a pulley and something else, as long as there is any."""
    geometry = geometry_of(study.system)
    for element in study.problem.constraints:
        for piece in pieces(element, geometry):
            moves = any(depends_on(piece.length, name) for name in study.system.coordinates)
            if moves and (piece.first.sense or piece.second.sense):
                yield {"kind": "short", "name": element.name, "value": piece.length}


def _left(study: Study) -> Iterator[Event]:
    """How far a contact is from both ends of the rod on which it is."""
    geometry, shapes = geometry_of(study.system), {body.name: body.shape for body in study.problem.bodies}
    for element in study.problem.constraints:
        rod = element.values.get("of")
        if element.values.get("line") is None or rod is None or shapes[rod].kind != "rod":
            continue
        pose, half = study.system.bodies[rod].pose, scalar(shapes[rod].sizes["length"]) / 2
        along = (meeting(element, geometry).place - pose.origin).dot(polar(UNITY, pose.angle))
        yield from ({"kind": "leaves", "name": element.name, "value": half + along * side} for side in (1, -1))


def _edges(coordinate: Coordinate) -> Iterator[Event]:
    here = t.Sym(coordinate.name)
    for bound, left in ((coordinate.lower, 1), (coordinate.upper, -1)):
        if bound is not None:
            yield {"kind": "edge", "name": coordinate.name, "value": (scalar(here) - scalar(bound)) * left}


# --- what is written in the explorer: formulas as MathML beside their plain text, names of forces and bodies


def label(node: t.Node, notation: Notation) -> dict[str, str]:
    """A formula as MathML, as text, and as it is spoken."""
    return {"math": accented(to_mathml(node, notation)), "text": to_text(node, notation), "spoken": to_speech(node, notation)}


def force_labels(system: System, notation: Notation, said: Words) -> dict[str, dict[str, Any]]:
    """By “force@body”: the name of the force, and of the body if there are several."""
    found: dict[str, dict[str, Any]] = {}
    for force in system.forces:
        node, key = force_node(system, force), f"{force.name}@{force.on}"
        is_told = len(system.bodies) == 1 or node == t.Vec(f"{force.name}_{force.on}")
        found.setdefault(key, {**label(node, notation), "on": "" if is_told else said.body(force.on)})
        found[key] |= {"couple": label(couple_node(force), notation)["math"]} if force.couple else {}
    return found


def couple_node(force: Force) -> t.Node:
    """A couple by its letter if it has one, else by the name of its force."""
    shown = present(force.couple)
    plain = shown.arg if isinstance(shown, t.Neg) else shown
    return shown if isinstance(plain, t.Sym) else t.Sym(force.name)


# --- the impulses with which a phase begins, as places in the list of numbers that the browser computes
# Each impulse on a body is an arrow at its point; what is named in a table are its components. Their values
# are those of `mechanics.phases`, at the state in which the phase begins.


Put = Callable[[Scalar], int]


def strikes(stage: Stage, begins: Phase, put: Put, notation: Notation) -> dict[str, Any] | None:
    """Arrows, components and the kinetic energy that is lost; None where nothing strikes."""
    began = stage.began
    if began is None or not began.is_blow:
        return None
    return {
        "arrows": list(arrows(began, stage, begins, put, notation)),
        "parts": [{**label(node, notation), "value": put(value)} for node, value in components(began, stage, begins)],
        "lost": put(began.energy_lost),
    }


def arrows(began: HandOver, stage: Stage, begins: Phase, put: Put, notation: Notation) -> Iterator[dict[str, Any]]:
    """The impulses that are known and not zero, on all bodies."""
    for force in impulsive(stage.study.system, began.phase.impulses):
        vector, point, couple = (put_in(began, value) for value in (force.vector, force.point, force.couple))
        unknown = any(depends_on(part, n) for part in (vector.x, vector.y, couple) for n in force.unknowns)
        if not unknown and not all(map(is_zero, (vector.x, vector.y, couple))):
            yield {**label(letter(force, stage, begins), notation), "on": force.on, **acting(put, point, vector, couple)}


def acting(put: Put, point: Vector, vector: Vector, couple: Scalar) -> dict[str, Any]:
    """What acts on a body, as places in the list."""
    return {"at": [put(point.x), put(point.y)], "vector": [put(vector.x), put(vector.y)], "couple": put(couple)}


def put_in(began: HandOver, value: Vector | Scalar) -> Any:
    """A value with the places and the impulses of the moment."""
    if isinstance(value, Vector):
        return value.substitute(dict(began.impulses)).substitute(dict(began.before.places))
    return substitute(substitute(value, began.impulses), began.before.places)


def letter(force: Force, stage: Stage, begins: Phase) -> t.Node:
    """A blow as it is given, a collision by its name, the impulse of a constraint with a hat."""
    element = next((e for e in begins.impulses if force.name in (e.name, e.values.get("friction"))), None)
    if element is None:
        return t.Sym(hat(force.name, stage))
    given = [part for part in element["impulse"] if part != t.ZERO] if element.kind == "blow" else []
    return given[0] if len(given) == 1 else t.Sym(force.name)


def components(began: HandOver, stage: Stage, begins: Phase) -> Iterator[tuple[t.Node, Scalar]]:
    """What a table names: the components of blows, then all unknown impulses that are not zero."""
    for element in begins.impulses:
        if element.kind == "blow":
            vector = pair(element["impulse"])
            yield from ((present(part), part) for part in (vector.x, vector.y) if not is_zero(part))
    own = {name for element in begins.impulses for name in restitutions(element)}
    for name, value in began.impulses.items():
        if not is_zero(value):
            yield t.Sym(name if name in own else hat(name, stage)), value


def hat(name: str, stage: Stage) -> str:
    """P̂_x for the impulse of the force P_x."""
    first, _, rest = name.partition("_")
    return stage.study.letters.free(f"{first}_hat_{rest}" if rest else f"{first}_hat")
