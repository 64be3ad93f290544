"""A problem from a TOML file or text.

Grammar: the keys of a file are those of `assemble.SECTIONS`; the kinds stand in `shapes`,
`interactions` and `constraints`. `rbpsym.statement.build` makes the same from Python.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

from rbpsym.errors import LimitError, Place, ReadError, StatementError
from rbpsym.quantities import Quantity
from rbpsym.statement.bodies import read_bodies
from rbpsym.statement.checks import check_names_differ, check_problem, check_unknowns
from rbpsym.statement.completing import courses, drives, with_masses, words_of
from rbpsym.statement.elements import Surroundings
from rbpsym.statement.library import check_size, problem_files, text_in
from rbpsym.statement.model import Coordinate, Pair, PointRef, Problem
from rbpsym.statement.own_text import check_languages, check_translated_names, letters_of, strings, worded
from rbpsym.statement.phases import read_both, read_phases
from rbpsym.statement.positions import index_positions, place_at
from rbpsym.statement.premises import declared
from rbpsym.statement.quantities import CoordinateReader, read_parameters
from rbpsym.statement.references import check_name, read_point
from rbpsym.statement.scope import ORIGIN, Scope, read_pair, text_of
from rbpsym.statement.source import Source, SourceTable, check_characters, kind_of

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


MAX_BYTES = 64 * 1024
WHAT = "the problem file"
MAX_DEPTH = 12


def load_problem(path_or_text: str | Path) -> Problem:
    """The problem in a file, in a text (a str of more than one line), or the one of that name that ships."""
    if isinstance(path_or_text, str) and "\n" in path_or_text:
        return load_text(path_or_text)
    if not isinstance(path_or_text, (str, PathLike)):
        what = f"the name of a problem is a text or a path, not {kind_of(path_or_text)}"
        raise ReadError(what, instead='write load_problem("my-problem.toml"), or the name of one that ships.')
    path = Path(path_or_text)
    if not path.suffix and len(path.parts) == 1 and not path.exists() and str(path) in problem_files():
        path = problem_files()[str(path_or_text)]
    return load_text(_content(path, MAX_BYTES), file=str(path), name=path.stem)


def load_text(text: str, file: str = "", name: str = "") -> Problem:
    """The problem in a TOML text; `file` is what errors call it."""
    table = table_of(text, file)
    return replace(assemble(table, name or Path(file).stem or "problem"), text=table.source.text)


def table_of(text: str, file: str = "", most: int = MAX_BYTES) -> SourceTable:
    """A TOML text as a table that knows its places, within the bounds of size and depth."""
    text = text.removeprefix("\ufeff").replace("\r\n", "\n")
    check_size(len(text.encode("utf-8", "surrogatepass")), most, WHAT, file)
    data = _parse(text, file)
    _check_depth(data, file)
    table = SourceTable(Source(file, index_positions(text)), (), data)
    check_characters(table)
    return table


def load_table(path: Path, most: int = MAX_BYTES) -> SourceTable:
    """The table in a TOML file."""
    return table_of(_content(path, most), str(path), most)


def _content(path: Path, most: int) -> str:
    return text_in(path, most, WHAT, "give the name of a problem file (.toml); “rbpsym new” writes one to start from.")


def _check_depth(data: object, file: str, depth: int = 0) -> None:
    if depth > MAX_DEPTH:
        raise LimitError(f"tables and lists are nested more than {MAX_DEPTH} deep", place=Place(file))
    for part in data.values() if isinstance(data, Mapping) else data if isinstance(data, list) else ():
        _check_depth(part, file, depth + 1)


# --- TOML that is none

_FAULTS: tuple[tuple[str, str, str], ...] = (
    (r"Expected '=' after a key", "a key must be followed by “=” and its value", 'write key = "value"'),
    (r"Invalid value", "this is not a value", 'put expressions in quotes: mass = "M"'),
    (r"Unterminated string|Illegal character '\\n'", "a quote is missing at the end of this text", 'end it with "'),
    (
        r"Expected newline or end of document",
        "there is something after the value",
        "write one key = value a line; put the whole expression in quotes.",
    ),
    (r"Cannot declare .* twice", "this table is there already", "join the two tables, or rename one."),
    (
        r"Cannot overwrite a value|Duplicate inline table key|Cannot mutate",
        "this key is there already",
        "remove one of the two, or rename it.",
    ),
    (r"Unclosed array", "a list is not closed", "end it with ]"),
    (r"Unclosed inline table", "a table in braces is not closed on its line", "end it with }"),
    (r"Invalid initial character for a key", "a key must begin here", "a key is letters, digits, “_” and “-”."),
    (r"Expected '\]", "the name of the table is not closed", "write [name] or [[name]]"),
    (r"Unescaped '\\'|hex|unicode", "a backslash in double quotes starts an escape", "use single quotes, or \\\\."),
    (r"Invalid statement", "a line must be a [table] or key = value", ""),
    (r"Illegal character|invalid character", "a character that can't stand in a TOML file", ""),
)
_AT = re.compile(r" \(at (?:line (\d+), column (\d+)|end of document)\)$")


def _parse(text: str, file: str) -> dict[str, object]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _syntax_error(str(error), text, file) from None
    except RecursionError:
        raise LimitError(f"tables and lists are nested more than {MAX_DEPTH} deep", place=Place(file)) from None
    except ValueError as error:  # dates that don't exist, numbers with too many digits
        raise ReadError(f"not a value that can be read: {error}", place=Place(file)) from None


def _syntax_error(message: str, text: str, file: str) -> ReadError:
    found = _AT.search(message)
    fault = message[: found.start()] if found else message
    what, instead = next(((what, hint) for pattern, what, hint in _FAULTS if re.search(pattern, fault)), (fault, ""))
    return ReadError(what, instead=instead, place=_syntax_place(found, fault, text, file))


def _syntax_place(found: re.Match[str] | None, fault: str, text: str, file: str) -> Place:
    """Where the fault is; of a repeated key or table, the beginning of its line."""
    if found is None or found[1] is None:
        return place_at(file, text, len(text.rstrip()))
    line, column = int(found[1]), int(found[2])
    start = sum(len(row) + 1 for row in text.split("\n")[: line - 1])
    row = text[start:].split("\n", 1)[0]
    if re.match("Cannot|Duplicate", fault):
        return place_at(file, text, start, len(row.split("=")[0].rstrip()))
    behind = 2 if fault.startswith("Unescaped") else 0  # tomllib tells the place after the escape
    return place_at(file, text, start + min(column - 1 - behind, len(row)), 1 + behind // 2)
