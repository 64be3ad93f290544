"""Names of the files of papers: safe on every system, one for each student."""

from __future__ import annotations

import re
import unicodedata
from hashlib import sha256

from rbpsym.teaching.model import Worksheet

LONGEST = 60


def file_stem(worksheet: Worksheet) -> str:
    """`name` or `name-student`, without anything that a file system or a shell takes amiss."""
    student = worksheet.student
    return worksheet.name if student is None else f"{safe(worksheet.name)}-{own(student.id)}"


def own(id: str) -> str:
    """A name that no other id has, not even where capitals do not count: a changed one ends with a digest."""
    plain = safe(id)
    if plain == id == id.lower():
        return plain
    return f"{plain}-{sha256(id.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}"


def safe(text: str) -> str:
    """Letters, digits, dots and dashes of a text; "student" if nothing is left."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9.]+", "-", plain).strip("-.")[:LONGEST] or "student"
