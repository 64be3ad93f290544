"""A wrong statement gets a sentence and a caret, never a traceback."""

from __future__ import annotations

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.statement import load_problem, load_text
from tests.statement.broken import ROWS
from tests.statement.sound import SOUND, Broken


def fault(text: str, file: str = "broken.toml") -> RbpsymError:
    with pytest.raises(RbpsymError) as found:
        load_text(text, file=file)
    return found.value


def test_the_sound_statement_is_sound() -> None:
    assert load_text(SOUND).body_names == ("rod", "disk", "bob")


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.name)
def test_sentence(row: Broken) -> None:
    error = fault(row.text)
    assert row.says in error.what
    assert row.hint in error.instead
    assert error.exit_code == 2
    assert str(error).startswith("broken.toml:")


@pytest.mark.parametrize("row", [row for row in ROWS if "«" in row.new], ids=lambda row: row.name)
def test_caret(row: Broken) -> None:
    place = fault(row.text).place
    assert (place.line, place.column, place.width) == row.caret
    assert place.text == row.text.split("\n")[place.line - 1].replace("\t", " ")


@pytest.mark.parametrize("row", [row for row in ROWS if "«" not in row.new], ids=lambda row: row.name)
def test_line(row: Broken) -> None:
    """Where no character is to blame, the sentence still names a line of the file."""
    assert fault(row.text).place.line > 0


def test_every_row_is_another_fault() -> None:
    assert len({row.name for row in ROWS}) == len({row.text for row in ROWS}) == len(ROWS) >= 100


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "no bodies"),
        (
            "[bodies.a]\nshape = 'particle'\nmass = '0'\n"
            "[interactions.F]\ntype = 'force'\non = 'a.center'\nforce = ['0', '0']",
            "no coordinates",
        ),
        ("a = " + "[" * 5000 + "]" * 5000, "nested"),
        ("a = " + "[" * 20 + "]" * 20, "nested"),
        ("# " + "x" * 70_000, "too large"),
        ("a = " + "9" * 5000, "not a value"),
        ("[[parameters]]\na = 1", "parameters must be a table"),
        ("[bodies]\nrod = 1", "bodies.rod must be a table"),
        ("bodies.rod.shape = 'rod'\nbodies.rod.parts = 1", "unknown key “parts”"),
        ("claims = 'x'", "list of tables"),
        ("[title]\nen = 1", "must be a text"),
        ("[meanings]\nes = 'x'", "must be a table"),
        ("x = 1979-05-27", "unknown key “x”"),
        ("\x00", "a line must be"),
        ("a = 'x\x00'", "can't stand in a TOML file"),
    ],
)
def test_no_traceback(text: str, says: str) -> None:
    assert says in str(fault(text))


@pytest.mark.parametrize("content", [b"\xff\xfe[bodies]", b"\x89PNG\r\n"])
def test_a_file_that_is_no_text(tmp_path, content: bytes) -> None:
    path = tmp_path / "picture.toml"
    path.write_bytes(content)
    with pytest.raises(RbpsymError, match="not a text file"):
        load_problem(path)


def test_files_that_are_not_there(tmp_path) -> None:
    for path in (tmp_path / "none.toml", tmp_path, "a\0b"):
        with pytest.raises(RbpsymError, match="can't read the problem"):
            load_problem(path)


def test_whole_message() -> None:
    text = SOUND.replace('angle  = "theta - pi/2"', 'angle  = "theta - ell"')
    assert str(fault(text)).split("\n") == [
        "broken.toml:33:19: a length is added to an angle or a number",
        '    angle  = "theta - ell"',
        "                      ^^^",
        "  terms of a sum must have one dimension.",
    ]
