"""Names of students that the fonts of a paper have no letters for: the key of the student stands there instead."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cache

from rbpsym.teaching.model import Student, Worksheet

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

    from rbpsym.document.escaping import typst_string

    source = f'#set document(title: "x")\n#set text(font: "{FONT}", lang: "en")\n#{typst_string(text)}'
    try:
        typst.compile(source.encode(), pdf_standards=["ua-1"], font_paths=typst.Fonts(include_system_fonts=False))
    except typst.TypstError:
        return False
    return True
