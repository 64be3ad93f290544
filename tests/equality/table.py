"""The table of claims: rows of tables/*.toml with what is assumed, read once for tests and benchmarks.

A file has `positive` (names that are positive wherever a row says nothing else of them) and
`rows`: left, right, verdict, note, and perhaps `given`, pieces between semicolons such as
"m M > 0", "x != 0", "y real", "0 < theta < pi/2".
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from rbpsym.algebra.evaluate import scalar
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.decide import equal
from rbpsym.equality.verdict import Verdict
from rbpsym.notation.infix import read_infix
from rbpsym.notation.infix_names import FUNCTIONS
from rbpsym.notation.tree import Node

TABLES = Path(__file__).parent / "tables"
SIGNS = {"> 0": "positive", ">= 0": "nonnegative", "!= 0": "nonzero", "real": "real"}
NAME = re.compile(r"[a-zA-Z_]\w*")


@dataclass(frozen=True)
class Row:
    """One claim: left = right for all quantities that satisfy the conditions."""

    left: str
    right: str
    verdict: str
    note: str
    file: str
    signs: tuple[tuple[str, str], ...]
    ranges: tuple[tuple[str, str | None, str | None], ...]

    @property
    def id(self) -> str:
        return f"{self.file}: {self.left} = {self.right}"

    @property
    def names(self) -> list[str]:
        """All symbols of the row, those in bounds included."""
        bounds = [bound for _, *ends in self.ranges for bound in ends if bound]
        found = {name for text in (self.left, self.right, *bounds) for name in NAME.findall(text)}
        return sorted(found - set(FUNCTIONS) - {"pi"})

    @property
    def assumptions(self) -> Assumptions:
        """What the engine may assume."""

        def bound(text: str | None):
            return None if text is None else scalar(read_infix(text, self.names))

        ranges = {name: (bound(low), bound(high)) for name, low, high in self.ranges}
        return Assumptions({name: sign for name, sign in self.signs if name in self.names}, ranges)

    def sides(self) -> tuple[Node, Node]:
        """Both sides as trees."""
        return read_infix(self.left, self.names), read_infix(self.right, self.names)

    def decide(self) -> Verdict:
        """What the engine says."""
        return equal(*self.sides(), self.assumptions)


def load(directory: Path = TABLES) -> list[Row]:
    """All rows of all files."""
    return [row for path in sorted(directory.glob("*.toml")) for row in _rows(path)]


def _rows(path: Path) -> list[Row]:
    content = tomllib.loads(path.read_text(encoding="utf-8"))
    default = dict.fromkeys(content["positive"].split(), "positive")
    found = []
    for entry in content["rows"]:
        signs, ranges = _given(entry.pop("given", ""))
        bounded = {name for name, *_ in ranges}
        known = {name: sign for name, sign in default.items() if name not in bounded} | signs
        found.append(Row(**entry, file=path.stem, signs=tuple(known.items()), ranges=tuple(ranges)))
    return found


def _given(text: str) -> tuple[dict[str, str], list[tuple[str, str | None, str | None]]]:
    signs: dict[str, str] = {}
    ranges = []
    for piece in filter(None, (part.strip() for part in text.split(";"))):
        ends = [end.strip() for end in piece.split(" < ")]
        sign = next((word for word in SIGNS if piece.endswith(word)), None)
        if len(ends) == 3:
            ranges.append((ends[1], ends[0], ends[2]))
        elif len(ends) == 2:
            ranges.append((ends[0], None, ends[1]))
        elif sign:
            signs |= dict.fromkeys(piece.removesuffix(sign).split(), SIGNS[sign])
        else:
            raise ValueError(f"unknown condition {piece!r}")
    return signs, ranges
