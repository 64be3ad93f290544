"""The table of identities as values.

A file in tables/ holds rows [left, right, assumptions, verdict, note]. Assumptions are "positive"
(all names that have no range), "positive a b", "nonnegative x", "nonzero x", "0 < theta < pi/2",
"1 < x < " and so on, joined by semicolons; a name without assumptions is real.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.verdict import Kind
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Node
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar

KNOWN = {"sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "exp", "ln", "sqrt", "abs", "pi"}
TABLES = Path(__file__).with_name("tables")
WORDS = re.compile(r"\b(positive|nonnegative|nonzero)\b")


@dataclass(frozen=True)
class Row:
    """One row of the table."""

    left: str
    right: str
    assuming: str
    verdict: Kind
    note: str

    @property
    def names(self) -> list[str]:
        """The quantities in it, those in bounds included."""
        return names_in(f"{self.left} {self.right} {WORDS.sub('', self.assuming)}")

    @property
    def sides(self) -> tuple[Node, Node]:
        """Both sides as trees."""
        return read_infix(self.left, self.names), read_infix(self.right, self.names)

    @property
    def assumptions(self) -> Assumptions:
        """What may be assumed."""
        return read_assumptions(self.assuming, self.names)


def names_in(text: str) -> list[str]:
    """All names that are no functions."""
    return sorted(set(re.findall(r"[A-Za-z_][A-Za-z_0-9]*", text)) - KNOWN)


def read_assumptions(text: str, names: list[str]) -> Assumptions:
    """What is said by `positive`, `positive a b`, `lower < x < upper`, joined by semicolons."""
    signs, ranges = {}, {}
    for item in filter(None, map(str.strip, text.split(";"))):
        sign = re.match(r"(positive|nonnegative|nonzero)\b(.*)", item)
        if sign:
            signs |= dict.fromkeys(sign[2].split() or names, sign[1])
        else:
            lower, name, upper = (part.strip() for part in f" {item} ".split("<"))
            ranges[name] = (_bound(lower), _bound(upper))
    return Assumptions({n: s for n, s in signs.items() if n not in ranges}, ranges)


def _bound(text: str) -> Scalar | None:
    return scalar(read_infix(text, names_in(text))) if text else None


@lru_cache(maxsize=1)
def table() -> tuple[Row, ...]:
    """All rows of all files."""
    rows = []
    for path in sorted(TABLES.glob("*.toml")):
        for left, right, given, verdict, note in tomllib.loads(path.read_text(encoding="utf-8"))["rows"]:
            rows.append(Row(left, right, given, Kind(verdict), note))
    return tuple(rows)
