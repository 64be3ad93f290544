"""Notes of the library in Spanish: no key or place is missing, no English sentence is left."""

import re

import pytest

from rbpsym.document.notes import notes
from rbpsym.document.writers import writer
from rbpsym.statement.library import problem_files
from tests.library.derived import derived

SAMPLE = sorted(problem_files())[::7]
ENGLISH = re.compile(r"\b(the|which|with|whose|equals)\b")


@pytest.mark.parametrize("name", SAMPLE)
def test_notes_are_spanish(name: str) -> None:
    text = writer("md")(notes(derived(name), "es", "full"))
    text = re.sub(r"\$\$.*?\$\$|\$[^$]*\$", "", str(text), flags=re.DOTALL)
    prose = [line for line in text.splitlines() if not line.startswith(("*", "!"))]  # the source keeps its title
    assert not [line for line in prose if ENGLISH.search(line)]
