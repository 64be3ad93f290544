"""Names of the files of papers: safe on every system, one for each student."""

from __future__ import annotations

import re
import unicodedata

from rbpsym.teaching.model import Worksheet

LONGEST = 60


def file_stem(worksheet: Worksheet) -> str:
    """`name` or `name-student`, without anything that a file system or a shell takes amiss."""
    student = worksheet.student
    return worksheet.name if student is None else f"{safe(worksheet.name)}-{safe(student.id)}"


def safe(text: str) -> str:
    """Letters, digits, dots and dashes of a text; "student" if nothing is left."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9.]+", "-", plain).strip("-.")[:LONGEST] or "student"
