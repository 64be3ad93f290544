"""A problem from Python is the problem from a file."""

from __future__ import annotations

import subprocess
import sys
import tomllib

import pytest

from rbpsym.errors import RbpsymError, StatementError
from rbpsym.statement import build, find_problem, load_problem, load_text, problem_files
from tests.statement.broken import ROWS
from tests.statement.sound import SOUND, Broken

FILES = list(problem_files().values())


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_python_equals_file(path) -> None:
    assert build.problem(path.stem, **tomllib.loads(path.read_text())) == load_problem(path)


def test_sound_statement_from_python() -> None:
    assert build.problem("all", **tomllib.loads(SOUND)) == load_text(SOUND, name="all")


def test_ladder_by_functions() -> None:
    file = load_problem(find_problem("sliding-ladder"))
    built = build.problem(
        "sliding-ladder",
        title=dict(file.title),
        source=file.source,
        level=file.level,
        topic=file.topic,
        parameters={
            "M": build.parameter("mass", "mass of the ladder"),
            "ell": "length: half the length of the ladder",
            "g": "acceleration: acceleration of gravity",
        },
        coordinates={
            "theta": build.coordinate("angle between the ladder and the floor", start="theta_0", range=(0, "pi/2")),
        },
        bodies={
            "ladder": build.rod(
                "2*ell", mass="M", center=("ell*cos(theta)", "ell*sin(theta)"), angle="pi - theta", meaning="ladder"
            ),
        },
        interactions={"W": build.gravity()},
        constraints={"N_w": build.contact("ladder.end", "x = 0"), "N_f": build.contact("ladder.start", "y = 0")},
        notation=dict(file.notation),
        meanings=dict(file.meanings),
        example=dict(file.example),
        ask=[{"question": text, "said": dict(said)} for text, said in file.questions.items()],
    )
    assert built == file


TOML_FAULTS = 8  # rows that only a file can be wrong in


@pytest.mark.parametrize("row", ROWS[TOML_FAULTS:], ids=lambda row: row.name)
def test_sentences_are_the_same(row: Broken) -> None:
    with pytest.raises(RbpsymError) as of_file:
        load_text(row.text)
    with pytest.raises(RbpsymError) as of_python:
        build.problem("p", **tomllib.loads(row.text))
    assert of_python.value.what == of_file.value.what
    assert str(of_python.value).startswith("p")


def test_caret_without_a_file() -> None:
    with pytest.raises(RbpsymError) as found:
        build.problem(
            "p",
            parameters={"a": "length", "m": "mass"},
            coordinates={"q": {}},
            bodies={"rod": build.rod("a + q", mass="m")},
        )
    assert str(found.value).split("\n")[:3] == [
        "p: bodies.rod.length:5: “length” of the body “rod” must not depend on “q”, a coordinate",
        "    a + q",
        "        ^",
    ]


def test_too_many_values() -> None:
    with pytest.raises(StatementError, match="rod takes 1 values, not 2"):
        build.rod("ell", "M")


def test_help_of_a_function() -> None:
    from inspect import signature

    assert str(signature(build.spring)) == "(between, stiffness, natural_length='0', **keys)"
    assert "natural_length: length at which it is slack" in build.spring.__doc__


def test_no_algebra_is_imported() -> None:
    code = (
        "import sys; from rbpsym.statement import load_problem, find_problem;"
        "load_problem(find_problem('sliding-ladder'));"
        "print([m for m in sys.modules if m.startswith(('sympy', 'rbpsym.field', 'rbpsym.mechanics'))])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
