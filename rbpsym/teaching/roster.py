"""The class list: a CSV file with a key for each student and, if there is one, the name to print."""

from __future__ import annotations

from pathlib import Path

from rbpsym.errors import Place, ReadError
from rbpsym.statement.files import text_in
from rbpsym.teaching.csv_rows import rows_in
from rbpsym.teaching.model import Student

IDS = ("id", "student", "email", "e-mail", "username", "matricula", "matrícula", "correo", "clave")
NAMES = ("name", "full name", "nombre", "nombre completo")
MOST_BYTES, MOST_STUDENTS, LONGEST = 8 * 1024 * 1024, 100_000, 200


def load_roster(path: Path) -> tuple[Student, ...]:
    """The students in the order of the file. Raises ReadError with the line of what is wrong."""
    return roster_of(text_in(path, MOST_BYTES, "the class list", of_sheets=True), str(path))


def roster_of(text: str, file: str = "roster") -> tuple[Student, ...]:
    """The students in a CSV text, whose first line names its columns."""
    rows = list(rows_in(text, file))
    if not rows:
        raise ReadError("the roster is empty", instead="write a line for each student: id,name", place=Place(file))
    heading = [cell.strip().lower() for cell in rows[0][1]]
    key = next((heading.index(name) for name in IDS if name in heading), None)
    name = next((heading.index(n) for n in NAMES if n in heading), None)
    if key is None and name is None:
        known = ", ".join((*IDS, *NAMES))
        raise ReadError(
            "the first line of the roster names no column that is known",
            instead=f"begin it with a line of headings, “id,name” say; known: {known}.",
            place=Place(file, rows[0][0]),
        )
    if not rows[1:]:
        raise ReadError(
            "the roster has headings, but no student", instead="write a line for each below them.", place=Place(file, 1)
        )
    return _students(rows[1:], key if key is not None else name, name, file)


def _students(rows: list[tuple[int, list[str]]], key: int, name: int | None, file: str) -> tuple[Student, ...]:
    if len(rows) > MOST_STUDENTS:
        raise ReadError(f"the roster has more than {MOST_STUDENTS} students", place=Place(file))
    seen: dict[str, int] = {}
    found = []
    for line, row in rows:
        student = _student(row, key, name, Place(file, line))
        if student.id in seen:
            raise ReadError(
                f"“{student.id}” is there twice, in lines {seen[student.id]} and {line}",
                instead="give each student a key of their own.",
                place=Place(file, line),
            )
        seen[student.id] = line
        found.append(student)
    return tuple(found)


def _student(row: list[str], key: int, name: int | None, place: Place) -> Student:
    cells = [cell.strip() for cell in row]
    id = cells[key] if key < len(cells) else ""
    if not id:
        raise ReadError("a student without a key", instead="fill in the first column.", place=place)
    shown = cells[name] if name is not None and name < len(cells) else ""
    if len(id) > LONGEST or len(shown) > LONGEST or not (id + shown).isprintable():
        raise ReadError("a key or name that can't be printed", instead=f"use up to {LONGEST} letters.", place=place)
    return Student(id, shown or id)
