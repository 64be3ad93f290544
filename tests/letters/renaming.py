"""A problem in which every name is another one: parameters, coordinates, bodies, forces, points and phases."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.statement import build
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem

WORDS = ("type", "shape", "meaning", "event", "side", "slip", "frame", "dimension", "sign", "glyph", "sense", "name",
         "removed", "smooth")  # fmt: skip
THINGS = ("point", "points", "body", "bodies", "on", "reaction_on", "between", "of", "circle", "path", "around",
          "without", "origins")  # fmt: skip
SECTIONS = ("parameters", "coordinates", "points", "bodies", "interactions", "constraints", "phases", "origins", "example",
            "notation")  # fmt: skip
NAMED = (
    "parameters",
    "coordinates",
    "points",
    "bodies",
    "interactions",
    "constraints",
    "impulses",
    "example",
    "notation",
)
WORD = re.compile(r"(?<![\w.])[A-Za-z]\w*")
ENDINGS = re.compile(r"(_dot|_ddot)$")


@dataclass(frozen=True)
class Names:
    """New names by old ones: of quantities, and of things."""

    symbols: Mapping[str, str]
    things: Mapping[str, str]

    def word(self, word: str, things_first: bool) -> str:
        stem = ENDINGS.sub("", word)
        tables = (self.things, self.symbols) if things_first else (self.symbols, self.things)
        return next((table[stem] + word[len(stem) :] for table in tables if stem in table), word)

    def text(self, text: str, things_first: bool = False, axes: tuple[str, ...] = ()) -> str:
        return WORD.sub(lambda w: w.group() if w.group() in axes else self.word(w.group(), things_first), text)


def symbols_of(problem: Problem) -> list[str]:
    """The names of quantities: parameters (those that only a start names too) and coordinates."""
    return [q.name for q in problem.parameters] + [c.name for c in problem.coordinates]


def things_of(problem: Problem) -> list[str]:
    """The names of bodies, fixed points, interactions, constraints and impulses."""
    elements = [*problem.interactions, *problem.constraints]
    for phase in problem.phases:
        elements += [*phase.problem.constraints, *phase.impulses]
    return [
        *dict.fromkeys((*problem.body_names, *(p for p in problem.points if p != "O"), *(e.name for e in elements)))
    ]


def renamed(name: str, names: Names) -> Problem:
    """The problem of the library with other names."""
    return build.problem("renamed", **data_of(name, names))


def data_of(name: str, names: Names) -> dict[str, object]:
    """The sections of the problem with other names."""
    data = tomllib.loads(problem_files()[name].read_text())
    return {key: _section(key, data[key], names) for key in SECTIONS if key in data}


def _section(key: str, value: object, names: Names) -> object:
    if key in NAMED:
        things_first = key not in ("parameters", "coordinates", "example", "notation")
        found = {names.word(k, things_first): (k, part) for k, part in value.items()}
        if key in ("notation", "example"):
            return {k: part for k, (_, part) in found.items()}
        if key == "interactions":  # what is left out is written with letters of its own
            found = {
                k: (old, {"g": "g"} | part if part["type"] == "gravity" else part) for k, (old, part) in found.items()
            }
        if key == "parameters":
            return {k: _parameter(part, names) for k, (_, part) in found.items()}
        return {k: _value("", part, names) for k, (_, part) in found.items()}
    return _value(key, value, names)


def _parameter(value: object, names: Names) -> object:
    if not isinstance(value, str):
        return _value("", value, names)
    head, colon, meaning = value.partition(":")
    kind, bound = re.match(r"([^<>]*)(.*)", head).groups()
    return kind + names.text(bound) + colon + meaning


def _value(key: str, value: object, names: Names) -> object:
    if key == "line":  # x and y are the axes
        return names.text(value, axes=("x", "y"))
    if isinstance(value, str):
        return value if key in WORDS else names.text(value, key in THINGS)
    if isinstance(value, list):
        return [_value("" if isinstance(part, list) else key, part, names) for part in value]
    if isinstance(value, dict):
        own = key in ("constraints", "impulses")
        if key == "points":  # of a body
            return {k: _value("", part, names) for k, part in value.items()}
        return {names.word(k, True) if own else k: _value("" if own else k, part, names) for k, part in value.items()}
    return value


def unknowns(problem: Problem) -> list[str]:
    """The names of all unknown forces and impulses, in order."""
    found = [name for element in problem.constraints for name in unknowns_of(element)]
    for phase in problem.phases:
        found += [name for element in phase.problem.constraints for name in unknowns_of(element)]
        found += [element.name for element in phase.impulses]
    return found


def dictionary(old: Problem, new: Problem) -> dict[str, str]:
    """Old -> new of everything that an answer may name."""
    pairs = dict(zip(symbols_of(old), symbols_of(new), strict=True))
    for c in [c.name for c in old.coordinates]:
        pairs |= {f"{c}_dot": f"{pairs[c]}_dot", f"{c}_ddot": f"{pairs[c]}_ddot", f"d_{c}": f"d_{pairs[c]}"}
    return pairs | dict(zip(unknowns(old), unknowns(new), strict=True))


def original(name: str) -> Problem:
    return load_problem(problem_files()[name])


def same_names(name: str) -> Names:
    """Each name for itself."""
    problem = original(name)
    return Names({n: n for n in symbols_of(problem)}, {n: n for n in things_of(problem)})
