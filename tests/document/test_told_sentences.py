"""What is said beside an answer, and why it is open, is said in the language of the page."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from importlib import import_module
from itertools import product
from pathlib import Path

import pytest

import rbpsym
from rbpsym.ask.finding import NAME, OF_IT, SAID
from rbpsym.document.translated import translated
from rbpsym.languages import languages

HOUSE = Path(rbpsym.__file__).parent
ROOMS = ("ask", "chapters", "decide", "field", "proof", "quantity")
FILES = [file for room in ROOMS for file in sorted((HOUSE / room).rglob("*.py"))]
OPEN = {"undecided", "Undecided"}
FOREIGN = sorted(set(languages()) - {"en"})


def told(file: Path) -> set[str]:
    """The sentences of a module that give a reason or stand beside an answer, x in each place."""
    constants = vars(import_module(".".join(file.relative_to(HOUSE.parent).with_suffix("").parts)))
    found: list[str] = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        match node:
            case ast.Call(func=ast.Name(id=name), args=[first, *_]) if name in OPEN:
                found += texts(first, constants)
            case ast.keyword(arg="says", value=value) | ast.Assign(targets=[ast.Name(id="says")], value=value):
                found += texts(value, constants)
    return {text for text in found if re.search("[a-z]{2,} ", text)}


def texts(node: ast.AST, constants: Mapping[str, object]) -> Iterator[str]:
    if isinstance(node, ast.JoinedStr):
        ways = ([part.value] if isinstance(part, ast.Constant) else [*filled(part, constants)] for part in node.values)
        yield from map("".join, product(*ways))
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif not isinstance(node, ast.Call):
        for part in ast.iter_child_nodes(node):
            yield from texts(part, constants)


def filled(part: ast.FormattedValue, constants: Mapping[str, object]) -> Iterator[str]:
    """What may stand in a place: words that the module names, else x."""
    ways = [part.value.body, part.value.orelse] if isinstance(part.value, ast.IfExp) else [part.value]
    for way in ways:
        known = constants.get(way.id) if isinstance(way, ast.Name) else None
        yield known if isinstance(known, str) else "x"


def test_there_are_such_sentences():
    assert len({text for file in FILES for text in told(file)}) > 60


@pytest.mark.parametrize("language", FOREIGN)
@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_each_is_translated(file, language):
    assert not [text for text in told(file) if translated(text, language) == text]




def written_out(pattern: str) -> Iterator[str]:
    """The texts of a pattern of alternatives and optional parts."""
    part = re.search(r"\(([^()]*)\)(\??)", pattern)
    if part is None:
        yield from pattern.split("|")
    else:
        for way in (*part[1].split("|"), *([""] if part[2] else [])):
            yield from written_out(pattern[: part.start()] + way + pattern[part.end() :])


@pytest.mark.parametrize("language", FOREIGN)
def test_each_clause_that_a_rule_decides_is_translated(language):
    clauses = [text for row in SAID for text in written_out(row.replace(NAME, "x").replace(OF_IT, "x"))]
    assert not [text for text in clauses if text != "no" and translated(text, language) == text]
