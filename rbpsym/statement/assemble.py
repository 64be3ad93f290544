"""A problem from its tables: the sections in the order in which they need each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.errors import StatementError
from rbpsym.quantities import Quantity
from rbpsym.statement.bodies import read_bodies
from rbpsym.statement.checks import check_names_differ, check_problem, check_unknowns
from rbpsym.statement.completing import courses, drives, with_masses, words_of
from rbpsym.statement.elements import Surroundings
from rbpsym.statement.letters import letters_of
from rbpsym.statement.model import Coordinate, Pair, PointRef, Problem
from rbpsym.statement.phases import read_both, read_phases
from rbpsym.statement.premises import declared
from rbpsym.statement.quantities import CoordinateReader, read_parameters
from rbpsym.statement.references import check_name, read_point
from rbpsym.statement.scope import ORIGIN, Scope, read_pair, text_of
from rbpsym.statement.source import SourceTable, kind_of
from rbpsym.statement.translations import check_languages, check_translated_names, strings, worded

# What each section of a file is for.
SECTIONS: dict[str, str] = {
    "name": "name of the problem; else the file's",
    "title": "title, or titles by language",
    "source": "where the problem comes from",
    "level": "for whom it is, or that by language",
    "topic": "what it teaches, or that by language",
    "parameters": 'constants: name = "dimension: meaning"',
    "coordinates": "what tells the position: meaning, dimension, start, speed, acceleration, range",
    "points": 'fixed points: Q = ["a", "0"]',
    "bodies": "shape, mass, sizes, pose",
    "interactions": "forces and couples that are known laws",
    "constraints": "conditions and the unknown forces that keep them",
    "phases": "parts of the motion after the first: events, blows, other constraints",
    "origins": "points about which angular momenta are wanted",
    "notation": 'how names are printed: theta_dot = "omega"',
    "meanings": "meanings in other languages: [meanings.es]",
    "names": "what bodies, points and phases are called in other languages: [names.es]",
    "example": "values with units, for numbers and plots",
    "claims": "what a source says, to be confirmed or refuted",
    "ask": 'what is asked: question = "N at the start"',
}


def assemble(table: SourceTable, name: str) -> Problem:
    """The problem that the table of a file (or of Python) states."""
    table.check_keys(SECTIONS, "the problem")
    check_names_differ(table)
    table, unstated = with_masses(table)
    parameters = tuple(read_parameters(table))
    scope = _scope_of(parameters)
    reader = CoordinateReader(table, scope)
    coordinates = tuple(reader.read())
    parameters = (*parameters, *reader.implicit.values())
    named = {getattr(c.start, "name", None): c for c in coordinates}
    starts = tuple(replace(named[name], quantity=quantity) for name, quantity in reader.implicit.items() if name in named)
    scope = replace(_scope_of(parameters, (*coordinates, *starts)), coordinates=reader.dimensions)
    scope = replace(scope, points=_points(table, scope))
    beginning = replace(scope, starts={c.name: c.start for c in coordinates if c.start is not None})
    bodies = read_bodies(table, beginning)
    around = Surroundings(scope, bodies, bool(unstated))
    interactions, constraints = read_both(table, replace(around, scope=beginning))
    problem = Problem(
        name=table.string("name") or name,
        parameters=tuple(q for q in parameters if q.name not in unstated),
        coordinates=coordinates,
        bodies=tuple(bodies.values()),
        interactions=interactions,
        constraints=(*(led := () if unstated else drives(coordinates, bodies, words_of(table))), *constraints),
        points=scope.points,
        origins=_origins(table, around),
        implicit=tuple(reader.implicit),
        unstated=unstated,
        led=courses(coordinates) if unstated else {},
        **_about(table, name),
    )
    check_problem(problem, table)
    problem = replace(problem, phases=read_phases(table, problem, around, led))
    for phase in problem.phases:
        check_unknowns(phase.problem, table)
    check_translated_names(problem, table)
    try:
        letters_of(problem)
    except StatementError as error:
        raise error.at(table.source.key(("notation" if "notation" in table else "parameters",))) from None
    return problem


def _about(table: SourceTable, name: str) -> dict[str, Any]:
    """What a file says about the problem, beside the physics."""
    return {
        "title": worded(table, "title", name),
        "source": table.string("source"),
        "level": worded(table, "level").get("en", ""),
        "topic": worded(table, "topic").get("en", ""),
        "notation": strings(table, "notation"),
        "meanings": _translations(table, "meanings", "theta"),
        "names": _translations(table, "names", "rod"),
        "example": _values(table, "example"),
        "claims": tuple(dict(row.data) for row in table.rows("claims", "“claims”")),
        "questions": dict(_questions(table)),
        "file": table.source.file,
    }


def _scope_of(parameters: tuple[Quantity, ...], coordinates: tuple[Coordinate, ...] = ()) -> Scope:
    return Scope({q.name: q.dimension for q in parameters}, given=declared(parameters, coordinates))


def _points(table: SourceTable, scope: Scope) -> dict[str, Pair]:
    section = table.table("points", "points")
    points: dict[str, Pair] = {"O": ORIGIN}
    for name in section.names():
        check_name(name, section, key=name)
        points[name] = read_pair(section.item(name), scope, f"the point “{name}”")
    return points


def _origins(table: SourceTable, around: Surroundings) -> dict[str, PointRef]:
    """The points of a list, by what they are called; O if the author names none."""
    item = table.item("origins", ["O"])
    if not isinstance(item.value, (list, tuple)):
        raise item.error(f"“origins” must be a list of points, not {kind_of(item.value)}", 'write origins = ["O"]')
    points = [read_point(part, around.scope, around.bodies, "“origins”") for part in item.items()]
    return {point.label: point for point in points}


def _values(table: SourceTable, key: str) -> dict[str, str]:
    """A table of values: texts with a unit, or plain numbers."""
    section = table.table(key, f"“{key}”")
    return {name: text_of(section.item(name), f"“{name}” of [{key}]") for name in section.names()}


def _translations(table: SourceTable, key: str, example: str) -> dict[str, dict[str, str]]:
    section = table.table(key, key)
    check_languages(section, f'write [{key}.es] and, below it, {example} = "..."')
    return {language: strings(section, language) for language in section.names()}


def _questions(table: SourceTable) -> Iterator[tuple[str, Mapping[str, str]]]:
    """What is asked in [[ask]], with its words in other languages."""
    for row in table.rows("ask", "“ask”"):
        row.check_keys(("question", "said"), "a question")
        row.require("question", "a question", 'add question = "N at the start".')
        check_languages(row.table("said", "“said”"), 'write said = { es = "`N` al principio" }')
        yield row.string("question"), strings(row, "said")
