"""The rules of the house: short files, told names, no guessing, nothing for one problem alone."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

from rbpsym.statement.library import problem_files
from tests.architecture.source import MODULES, ROOT, Module, of_every_module

LONGEST = 400  # lines
GUESSES = {"simplify", "trigsimp", "radsimp", "sympify", "parse_expr", "nsimplify", "equals", "eval", "exec"}
# What is not a value but walks over something and remembers where it is.
WALKERS = {"Reader", "CaseReading", "SignStudy", "Cursor", "PositionIndex"}
VAGUE = {"utils", "util", "helper", "helpers", "manager", "managers", "base", "misc", "common"}
SHIPPED = sorted(problem_files())
TEMPLATES = [path for path in sorted((ROOT / "templates").rglob("*")) if path.is_file()]

@of_every_module
def test_files_are_short(module: Module) -> None:
    assert module.text.count("\n") <= LONGEST


@of_every_module
def test_modules_say_what_they_are_for(module: Module) -> None:
    assert ast.get_docstring(module.tree), f"{module.path} has no docstring"


@of_every_module
def test_names_are_telling(module: Module) -> None:
    assert not VAGUE & set(module.parts), module.name
    for node in ast.walk(module.tree):
        if isinstance(node, ast.ClassDef):
            words = {word.lower() for word in re.findall(r"[A-Z][a-z]+", node.name)}
            assert not words & VAGUE, f"{module.path}:{node.lineno}: {node.name}"


def test_no_two_public_classes_have_one_name() -> None:
    """Who reads `Moment` knows which one is meant."""
    homes = defaultdict(list)
    for module in MODULES:
        for node in module.tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                homes[node.name].append(module.name)
    assert not {name: where for name, where in homes.items() if len(where) > 1}


@of_every_module
def test_nothing_is_guessed(module: Module) -> None:
    """No verdict stands on a heuristic and no input is run: none of these is imported or called."""
    for node in ast.walk(module.tree):
        called = getattr(node.func, "attr", getattr(node.func, "id", "")) if isinstance(node, ast.Call) else ""
        name = node.name if isinstance(node, ast.alias) else called
        assert name not in GUESSES, f"{module.path}:{node.lineno}: {name}"


@of_every_module
def test_an_assertion_changes_nothing(module: Module) -> None:
    """In the page the program runs without assertions: one that took a mark from a list took the grammar of questions with it."""
    for node in ast.walk(module.tree):
        inner = ast.walk(node.test) if isinstance(node, ast.Assert) else ()
        called = {part.func.attr for part in inner if isinstance(part, ast.Call) and isinstance(part.func, ast.Attribute)}
        changed = called & {"pop", "append", "add", "remove", "discard", "update", "setdefault", "popleft", "extend", "__next__"}
        assert not changed, f"{module.path}:{node.lineno}: {changed}"


def public(module: Module) -> Iterator[ast.FunctionDef | ast.ClassDef]:
    """Its public functions and classes, and the public methods of those."""
    kinds = (ast.FunctionDef, ast.ClassDef)
    for node in module.tree.body:
        if isinstance(node, kinds) and not node.name.startswith("_"):
            yield node
            if isinstance(node, ast.ClassDef):
                yield from (part for part in node.body if isinstance(part, kinds) and not part.name.startswith("_"))


@of_every_module
def test_public_names_have_docstrings(module: Module) -> None:
    missing = [f"{node.lineno}: {node.name}" for node in public(module) if not ast.get_docstring(node)]
    assert not missing, f"{module.path}: {missing}"


@of_every_module
def test_questions_are_answered_by_yes_or_no(module: Module) -> None:
    for node in public(module):
        if isinstance(node, ast.FunctionDef) and node.name.startswith("is_"):
            assert node.returns is not None and "bool" in ast.unparse(node.returns), f"{module.path}:{node.lineno}"


@of_every_module
def test_values_are_frozen(module: Module) -> None:
    """The standard library's decorator compiles source for each class; what remembers says so by its base."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.ClassDef):
            marks, place = {ast.unparse(mark).split("(")[0] for mark in node.decorator_list}, f"{module.path}:{node.lineno}"
            assert not marks & {"dataclass", "dataclasses.dataclass"}, f"{place}: class {node.name}(Frozen)"
            assert "Walker" not in map(ast.unparse, node.bases) or node.name in WALKERS, f"{place}: {node.name}"


def test_something_ships() -> None:
    assert len(SHIPPED) >= 4


def mentions(text: str) -> list[str]:
    """The shipped problems that a text names."""
    words = set(re.findall(r"[\w-]+", text))
    return [name for name in SHIPPED if name in words or name.replace("-", "_") in words & {text}]


@of_every_module
def test_no_code_for_one_problem(module: Module) -> None:
    """Docstrings may give examples; no other text of the code names a problem that ships."""
    found = [(line, names) for line, text in module.strings() if (names := mentions(text))]
    assert not found, f"{module.path}: {found}"


@pytest.mark.parametrize("path", TEMPLATES, ids=lambda path: path.name)
def test_no_template_for_one_problem(path: Path) -> None:
    assert not mentions(path.read_text(encoding="utf-8", errors="replace"))


def test_the_fast_tests_look_into_every_folder() -> None:
    """`make test-fast` names files that exist, and of every folder of tests at least one, but for those that take hours."""
    listed = re.search(r"^FAST .*?\)$", (ROOT / "Makefile").read_text(encoding="utf-8"), re.S | re.M)
    assert listed is not None
    files = [ROOT / "tests" / f"{name}.py" for name in re.findall(r"\w+/test_\w+", listed[0])]
    assert all(file.is_file() for file in files), [file for file in files if not file.is_file()]
    folders = {file.parent.name for file in (ROOT / "tests").glob("*/test_*.py")} - {"thorough"}
    assert {file.parent.name for file in files} == folders
