"""The phases of a motion: what ends the one before, what strikes, and which constraints then hold.

    [[phases]]
    name        = "rolling"
    event       = "no slip"            # of the constraint N: when it stops slipping
    of          = "N"
    constraints = { N = { type = "rolling" } }

Keys of a constraint that is there already are kept as far as its new kind has them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.events import STATED
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind
from rbpsym.expr.tree import Node
from rbpsym.quantities import TIME
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.elements import Surroundings, kind_of_element, read_elements
from rbpsym.statement.model import Element, Phase, Problem
from rbpsym.statement.premises import surely_above
from rbpsym.statement.scope import read_expression
from rbpsym.statement.source import SourceTable, did_you_mean, kind_of

KINDS = {"interactions": INTERACTIONS, "constraints": CONSTRAINTS}
PHASE_KEYS = {
    "name": "what the phase is called",
    "event": "what ends the phase before: " + ", ".join(STATED),
    "of": "the constraint or bounce that the event is about, or the coordinate that reaches a value or rests",
    "at": "the value that the coordinate reaches, or the time that goes",
    "constraints": "constraints that are new or change",
    "interactions": "interactions that are new or change",
    "without": "names of constraints that hold no more, and of interactions that act no more",
    "impulses": "blows, collisions and bounces at the moment of the event",
}


def read_phases(table: SourceTable, problem: Problem, around: Surroundings, led: tuple[Element, ...] = ()) -> tuple[Phase, ...]:
    """The phases after the first, each with the problem that then holds (its start is left to the mechanics); what leads
    coordinates with given accelerations goes on."""
    current = {section: dict(table.table(section, section).data) for section in KINDS}
    found: list[Phase] = []
    names = {q.name: "a parameter" for q in problem.parameters} | {c.name: "a coordinate" for c in problem.coordinates}
    for number, row in enumerate(table.rows("phases", "“phases”"), 2):
        name = row.string("name") or f"phase {number}"
        row.check_keys(PHASE_KEYS, f"the phase “{name}”")
        if name in {phase.name for phase in found}:
            raise row.value_error("name", f"two phases are called “{name}”", "give one another name.")
        event, subject = _event(row, name, current["constraints"], around)
        value = _value(row, name, event, subject, around)
        current = _changed(row, name, current)
        interactions, constraints = read_both(SourceTable(row.source, row.path, current), around)
        impulses = tuple(_checked(e, row, names) for e in read_elements("impulses", row, IMPULSES, around))
        then = replace(problem, interactions=interactions, constraints=(*led, *constraints))
        found.append(Phase(name, event, subject, impulses, then, value))
        if event == "begins":
            _check_begins(row, found[-1])
    return tuple(found)


def _event(row: SourceTable, name: str, current: Mapping[str, object], around: Surroundings) -> tuple[str, str]:
    event = row.string("event", "at once")
    if event not in STATED:
        raise row.value_error(
            "event", f"the phase “{name}” begins with an unknown event “{event}”", did_you_mean(event, STATED, "events")
        )
    kind = STATED[event]
    what = kind.of
    _needless(row, name, event, [key for key, is_asked in (("of", what), ("at", kind.at)) if not is_asked])
    if not what:
        return event, ""
    row.require("of", f"the phase “{name}”", f'add of = "N": {kind.meaning}.')
    subject = row.string("of")
    known: Mapping[str, object] = around.scope.coordinates if what == "coordinate" else current
    if what not in ("coordinate", "constraint"):
        known = {key: part for section in ("constraints", "impulses") for key, part in row.tables(section, section)}
    if subject not in known:
        raise row.value_error(
            "of", f"the phase “{name}”: there is no {what} “{subject}”", did_you_mean(subject, known, f"{what}s")
        )
    return event, subject


def _value(row: SourceTable, name: str, event: str, subject: str, around: Surroundings) -> Node | None:
    """The value that a coordinate reaches, or the time that goes."""
    if STATED[event].at == "time":
        row.require("at", f"the phase “{name}”", 'add at = "t_1": the time that goes.')
        return read_expression(row.item("at"), around.scope, f"“at” of the phase “{name}”", TIME, sign="positive")
    if not STATED[event].at:
        return None
    row.require("at", f"the phase “{name}”", f'add at = "0": the value that {subject} reaches.')
    dimension, given = around.scope.coordinates[subject], around.scope.given
    value = read_expression(row.item("at"), around.scope, f"“at” of the phase “{name}”", dimension)
    lower, upper = given.bounds.get(subject, (None, None))
    if surely_above(lower, value, given) or surely_above(value, upper, given):
        raise row.value_error("at", f"the phase “{name}”: “{subject}” can't reach this value: it is outside its range")
    return value


def _needless(row: SourceTable, name: str, event: str, keys: Iterable[str]) -> None:
    for key in keys:
        if key in row:
            raise row.value_error(
                key,
                f"the phase “{name}” begins “{event}”, which asks for no “{key}”",
                "leave it out, or say which event.",
            )


def read_both(table: SourceTable, around: Surroundings) -> tuple[tuple[Element, ...], ...]:
    """The interactions and the constraints of a table; the former may name the unknown forces of the latter."""
    found: dict[str, tuple[Element, ...]] = {}
    for section, kinds in reversed(KINDS.items()):
        forces = {name: unit for each in found.get("constraints", ()) for name, unit in unknowns_of(each).items()}
        seen = replace(around, scope=replace(around.scope, forces=forces))
        found[section] = read_elements(section, table, kinds, seen)
    return found["interactions"], found["constraints"]


def _changed(row: SourceTable, name: str, current: Mapping[str, Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """The interactions and constraints of the phase as tables."""
    found = {section: dict(parts) for section, parts in current.items()}
    without = row.item("without", [])
    if not isinstance(without.value, (list, tuple)):
        raise without.error(
            f"“without” of the phase “{name}” must be a list of names, not {kind_of(without.value)}",
            'write without = ["N"]',
        )
    for item in without.items():
        held = next((parts for parts in found.values() if item.value in parts), None)
        if held is None:
            known = [key for parts in found.values() for key in parts]
            what = f"the phase “{name}”: there is no constraint or interaction “{item.value}”"
            raise item.error(what, did_you_mean(str(item.value), known))
        del held[item.value]
    for section, parts in found.items():
        for key, part in row.tables(section, f"{section} of the phase “{name}”"):
            if any(key in other for other in found.values() if other is not parts):
                raise part.error(f"“{key}” is an interaction and a constraint", "give one of them another name.")
            parts[key] = _merged(parts[key], part, KINDS[section]) if key in parts else part.data
    return found


def _merged(old: Mapping[str, object], new: SourceTable, kinds: Mapping[str, ElementKind]) -> dict[str, object]:
    kind = kind_of_element(SourceTable(new.source, new.path, {**old, **new.data}), kinds, "type")
    keys = {"type", *(field.name for field in kind.fields)}
    return {**{key: value for key, value in old.items() if key in keys}, **new.data}


def _checked(element: Element, row: SourceTable, names: Mapping[str, str]) -> Element:
    if element.name in names:
        raise row.error(f"“{element.name}” is {names[element.name]} and an impulse", "rename one.", "impulses")
    return element


def _check_begins(row: SourceTable, phase: Phase) -> None:
    """What begins is apart before, and known to meet."""
    if phase.gap is None:
        raise row.value_error(
            "of",
            f"the phase “{phase.name}”: nothing closes where “{phase.subject}” begins",
            "name a contact, or a string or link with a length.",
        )
