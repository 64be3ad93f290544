"""A parameter that nothing uses is said; what ships declares none that neither its statement nor its claims use."""

import pytest

from rbpsym import derive, notes, writer
from rbpsym.statement import load_text
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.references import unused
from tests.cli.test_commands import run
from tests.golden.semantic import examples

FILES = {**problem_files(), **examples()}
TEXT = """
[parameters]
m = "mass"
g = "acceleration"
zeta = "length: nothing"
r = "length < R"
R = "length"
v = "speed"
[coordinates.x]
dimension = "length"
start = "r"
[bodies.b]
shape = "particle"
mass = "m"
center = ["x", "0"]
[[ask]]
question = "time until speed of x = v"
[interactions.F]
type = "force"
on = "b.center"
force = ["m*g", "0"]
"""


@pytest.mark.parametrize("name", FILES)
def test_what_ships_uses_what_it_declares(name: str) -> None:
    path = FILES[name]
    claims = path.parent.parent / "claims" / path.name
    said = claims.read_text(encoding="utf-8") if claims.is_file() else ""
    assert [parameter for parameter in unused(load_problem(path)) if f'"{parameter}"' not in said] == []


def test_starts_bounds_and_questions_use_a_name() -> None:
    assert unused(load_text(TEXT)) == ["zeta"]


@pytest.mark.parametrize("command", [("solve",), ("derive",), ("ask", "speed of x"), ("notes", "--format", "md", "-o", ".")])
def test_the_commands_say_it(tmp_path, monkeypatch, command) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.toml").write_text('title = "Mine"\n' + TEXT, encoding="utf-8")
    first, *more = command
    assert "“zeta” is used nowhere" in run(first, "mine.toml", *more).stderr


def test_what_is_asked_uses_a_name(tmp_path) -> None:
    (tmp_path / "mine.toml").write_text('title = "Mine"\n' + TEXT, encoding="utf-8")
    assert "used nowhere" not in run("ask", str(tmp_path / "mine.toml"), "speed of x where x = r + zeta").stderr


def test_notes_do_not_speak_of_it() -> None:
    """Neither among the letters, nor as what a result is independent of."""
    text = writer("md")(notes(derive(load_text(TEXT))))
    assert "zeta" not in text
