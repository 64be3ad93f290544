"""The notes of the shipped problems are, character by character, those in tests/golden."""

import difflib

import pytest

from tests.document.golden import FOLDER, NAMES, body


@pytest.mark.parametrize("name", NAMES)
def test_notes_are_as_they_were(name):
    file = FOLDER / f"{name}.tex"
    kept = file.read_text(encoding="utf-8") if file.is_file() else ""
    lines = difflib.unified_diff(kept.splitlines(), body(name).splitlines(), "tests/golden", "now", lineterm="", n=1)
    assert not list(lines), "run python -m tests.document.golden and read what changed"
