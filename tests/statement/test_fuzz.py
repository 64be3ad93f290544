"""Whatever is typed: a problem or a sentence, nothing else."""

from __future__ import annotations

import random

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.statement import load_text, problem_files
from tests.statement.sound import SOUND

PIECES = [
    '"',
    "'",
    "[",
    "]",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "#",
    ".",
    "\\",
    '"""',
    "[[",
    "]]",
    "0",
    "-",
    "true",
    "(",
    ")",
    "**",
    "1e9",
    "1/0",
    "x",
    "t",
    "rod",
    "cm",
    "theta",
    "\t",
    "é",
    "\x00",
    "sqrt(",
    "99",
    "points",
    "parts",
]
TEXTS = [SOUND, *(path.read_text() for path in problem_files().values())]


def mutant(random_: random.Random) -> str:
    """A text with some characters, words or lines lost, added or exchanged."""
    text = random_.choice(TEXTS)
    for _ in range(random_.randint(1, 3)):
        at = random_.randrange(len(text) + 1)
        end = min(len(text), at + random_.choice([0, 1, 1, 3, 30]))
        text = text[:at] + random_.choice([*PIECES, ""]) + text[end:]
    return text


@pytest.mark.parametrize("seed", range(20))
def test_mutants(seed: int) -> None:
    random_ = random.Random(seed)
    for _ in range(15):
        text = mutant(random_)
        try:
            load_text(text, file="mutant.toml")
        except RbpsymError as error:
            assert str(error).startswith("mutant.toml")
            assert error.place.line <= text.count("\n") + 1


@pytest.mark.parametrize("line", range(0, SOUND.count("\n"), 2))
def test_a_line_lost(line: int) -> None:
    lines = SOUND.split("\n")
    try:
        load_text("\n".join(lines[:line] + lines[line + 1 :]), file="mutant.toml")
    except RbpsymError as error:
        assert str(error).startswith("mutant.toml:")
