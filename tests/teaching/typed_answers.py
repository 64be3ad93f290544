"""The tables of answers that people type (`answers.txt`, `holdout.txt`)."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

EXPECTED = {"==": "right", "!=": "wrong", "??": "invalid", "~~": "undecided"}


@dataclass(frozen=True)
class Row:
    """A key, an answer, what is expected, and the symbols with their signs."""

    key: str
    answer: str
    expected: str
    symbols: tuple[tuple[str, str], ...]


def rows(table: str = "answers.txt") -> list[Row]:
    """All rows of a table."""
    found, symbols = [], ()
    for line in (Path(__file__).parent / table).read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            symbols = tuple(
                (name.rstrip("+"), "positive" if name.endswith("+") else "real") for name in line[1:-1].split()
            )
        elif line and not line.startswith("#"):
            key, sign, answer = re.fullmatch(r"(.*?) (==|!=|\?\?|~~) (.*)", line).groups()
            found.append(Row(key, answer, EXPECTED[sign], symbols))
    return found
