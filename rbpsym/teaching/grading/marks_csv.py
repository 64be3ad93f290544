"""The table of marks: a row a student. No cell is a formula to a spreadsheet, whatever a student typed."""

from __future__ import annotations

import csv
import io
import unicodedata
from collections.abc import Iterable, Sequence

RISKY = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")


def safe(cell: str) -> str:
    """A cell on one line that no spreadsheet takes for a formula: an apostrophe stands before one that might be."""
    flat = " ".join(cell.split())
    plain = unicodedata.normalize("NFKC", flat).lstrip(" '\"")
    return f"'{flat}" if plain.startswith(RISKY) else flat


def marks_csv(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The text of the file."""
    held = io.StringIO(newline="")
    writer = csv.writer(held, lineterminator="\r\n", quoting=csv.QUOTE_MINIMAL)
    for row in (header, *rows):
        writer.writerow([safe(cell) for cell in row])
    return held.getvalue()
