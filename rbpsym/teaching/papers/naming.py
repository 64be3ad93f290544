"""Names of students: of the files of their papers, and on the papers themselves."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from hashlib import sha256

from rbpsym.teaching.model import Student, Worksheet

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


# --- names of students that the fonts of a paper have no letters for: the key of the student stands there instead


FONT = "New Computer Modern"  # of templates/worksheet.typ
ENCODINGS = ("latin-1", "iso8859-2", "iso8859-9", "iso8859-15")  # what pdflatex sets without further packages


def printable(worksheet: Worksheet, engine: str) -> Worksheet:
    """The worksheet with a name that can be set."""
    student = worksheet.student
    if student is None or has_letters(student.name, engine):
        return worksheet
    shown = student.id if has_letters(student.id, engine) else ""
    return replace(worksheet, student=replace(student, name=shown))


def without_letters(students: Iterable[Student], engine: str) -> tuple[Student, ...]:
    """The students whose names can't be set."""
    return tuple(student for student in students if not has_letters(student.name, engine))


def has_letters(text: str, engine: str) -> bool:
    """Whether an engine (“typst” or “pdflatex”) can set a text."""
    if all(_is_latin(char) for char in text):
        return True
    return engine == "typst" and _typst_sets(text)


def _is_latin(char: str) -> bool:
    for encoding in ENCODINGS:
        try:
            char.encode(encoding)
            return True
        except UnicodeEncodeError:
            continue
    return False


@cache
def _typst_sets(text: str) -> bool:
    """Tried on a page that holds nothing else."""
    import typst

    from rbpsym.typeset.escaping import typst_string

    source = f'#set document(title: "x")\n#set text(font: "{FONT}", lang: "en")\n#{typst_string(text)}'
    try:
        typst.compile(source.encode(), pdf_standards=["ua-1"], font_paths=typst.Fonts(include_system_fonts=False))
    except typst.TypstError:
        return False
    return True
