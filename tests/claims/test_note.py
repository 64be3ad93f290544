"""A lecture note with its claims file, checked by the commands that docs/ci.md prints."""

import re
import shlex
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = [
    " ".join(found.split())
    for found in re.findall(
        r"(?<=rbpsym )check notes\.tex [^\n]*(?:\n +--[^\n]*)?", (ROOT / "docs" / "ci.md").read_text()
    )
]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    shutil.copytree(Path(__file__).parent / "note", tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path


def run(command: str):
    """The result of a printed command."""
    return CliRunner().invoke(main, shlex.split(command), standalone_mode=True)


def test_the_page_prints_commands():
    assert len(COMMANDS) >= 2


@pytest.mark.parametrize("command", COMMANDS)
def test_a_printed_command_is_content_with_a_right_note(folder, command):
    found = run(command)
    assert found.exit_code == 0, found.output
    assert "all as expected" in found.output


@pytest.mark.parametrize("command", COMMANDS)
def test_a_sign_turns_it_red(folder, command):
    text = folder / "notes.tex"
    text.write_text(text.read_text().replace("MRv+I", "MRv-I"))
    found = run(command)
    assert found.exit_code == 1
    assert "near miss: sign of −Iω" in found.output
    if "--github" in command:
        assert "::error file=notes.tex,line=45,title=(2.6) REFUTED::" in found.output
        assert 'failures="1"' in (folder / "formulas.xml").read_text()
        assert "REFUTED" in (folder / "formulas.html").read_text()


def test_numbers_are_those_of_the_sections(folder):
    found = run("check notes.tex --problems claims.toml --all")
    for number in ("(1.1)", "(1.4)", "(2.2)", "(2.6)"):
        assert number in found.output
