"""Tables as spreadsheets save them: the class list and the answers of a class are read, its marks are written.

What is wrong in a table is told with its place.
"""

from __future__ import annotations

import csv
import io
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from rbpsym.errors import Place, RbpsymError, ReadError
from rbpsym.frozen import Frozen, field
from rbpsym.statement.library import text_in
from rbpsym.teaching.model import Student

# --- tables in CSV files as spreadsheets save them: decoded, and cut into rows; what is wrong is told with its place


HINT = "Save it as CSV UTF-8."
LONGEST_CELL = 20_000


def rows_in(text: str, file: str) -> Iterator[tuple[int, list[str]]]:
    """(line, cells) of all rows that hold something; commas, semicolons or tabs part them. Raises ReadError."""
    mark = max(",;\t", key=text.split("\n", 1)[0].count)
    csv.field_size_limit(2**30)
    reader = csv.reader(io.StringIO(text.replace("\x00", "\ufffd"), newline=""), delimiter=mark)
    try:
        for cells in reader:
            if any(cell.strip() for cell in cells):
                yield reader.line_num, [cell[:LONGEST_CELL] for cell in cells]
    except csv.Error as error:
        raise ReadError(f"this is no CSV: {error}", instead=HINT, place=Place(file, reader.line_num)) from None


# --- the class list: a CSV file with a key for each student and, if there is one, the name to print


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
    first = name if key is None else key
    if first is None:
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
    return _students(rows[1:], first, name, file)


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
    id, shown = _cell(row, key).strip(), _cell(row, name).strip()
    if not id:
        raise ReadError("a student without a key", instead="fill in the first column.", place=place)
    if len(id) > LONGEST or len(shown) > LONGEST or not (id + shown).isprintable():
        raise ReadError("a key or name that can't be printed", instead=f"use up to {LONGEST} letters.", place=place)
    return Student(id, shown or id)


# --- the table of answers: a row a student with a column an item, or a row an answer
# “3 points” beside an item holds what the teacher decided of it.
#
# Columns: `student` (or `id`), or `code` (or `form`) for the form code on the paper; then the items, as
# “3”, “Q3” or “item 3”, blanks as “3.1”. Other columns are passed over, and named in a report.


LARGEST = 64 * 1024 * 1024
STUDENT, CODE, ITEM, ANSWER = (
    ("student", "id", "estudiante"),
    ("code", "form", "código", "codigo"),
    ("item", "task"),
    ("answer", "respuesta"),
)
_POINTS = re.compile(r"(?:q|question|item|task|pregunta|p)?[\s_.:-]*(\d+)[\s_.:-]*(?:points?|puntos?)", re.IGNORECASE)
_ITEM = re.compile(r"(?:q|question|item|task|pregunta|p)?[\s_.:-]*(\d+(?:\.\d+)?)\.?", re.IGNORECASE)


class AnswerRow(Frozen):
    """The answers of one student by item; `line` of the file, `name` that of the class list, points `decided` by the teacher."""

    student: str
    code: str
    answers: Mapping[str, str]
    line: int = 0
    name: str = ""
    decided: Mapping[str, str] = field(default_factory=dict)


class AnswerTable(Frozen):
    """All rows, in the order of the file, and the columns that were passed over."""

    rows: tuple[AnswerRow, ...]
    passed_over: tuple[str, ...] = ()


def read_answers(path: Path) -> AnswerTable:
    """The table in a file. Raises ReadError with file and line."""
    return parse_answers(text_in(path, LARGEST, "the answers", of_sheets=True), str(path))


def parse_answers(text: str, file: str = "answers.csv") -> AnswerTable:
    """The table in a text. Raises ReadError with file and line."""
    lines = rows_in(text, file)
    _, header = next(lines, (1, []))
    names = [name.strip().lower() for name in header]
    who, code = _column(names, STUDENT), _column(names, CODE)
    if who is None and code is None:
        hint = "the first line names the columns: student, or code, and the items 1, 2, …"
        raise ReadError("there is no column “student” or “code”", instead=hint, place=Place(file, 1))
    item, answer = _column(names, ITEM), _column(names, ANSWER)
    read = (((_cell(cells, who).strip(), _cell(cells, code).strip()), line, cells) for line, cells in lines)
    if item is not None and answer is not None:
        typed = ((key, line, _cell(cells, item), _cell(cells, answer)) for key, line, cells in read)
        return AnswerTable(_unique(_gathered(typed, file), file))
    columns = {place: found[1] for place, name in enumerate(names) if (found := _ITEM.fullmatch(name))}
    decided = {place: found[1] for place, name in enumerate(names) if (found := _POINTS.fullmatch(name))}
    rows = []
    for key, line, cells in read:
        answers = {item: _cell(cells, place) for place, item in columns.items()}
        points = {item: told for place, item in decided.items() if (told := _cell(cells, place).strip())}
        rows.append(AnswerRow(*key, answers, line, decided=points))
    known = (*columns, *decided, who, code)
    other = tuple(header[place] for place in range(len(names)) if place not in known and header[place].strip())
    return AnswerTable(_unique(rows, file), other)


def _column(names: list[str], known: tuple[str, ...]) -> int | None:
    return next((place for place, name in enumerate(names) if name in known), None)


def _cell(cells: list[str], place: int | None) -> str:
    return cells[place] if place is not None and place < len(cells) else ""


def _gathered(typed: Iterable[tuple[tuple[str, str], int, str, str]], file: str) -> list[AnswerRow]:
    """The answers of each student (told by key, line, item and answer) in one row."""
    rows: dict[tuple[str, str], tuple[int, dict[str, str]]] = {}
    for key, line, item, answer in typed:
        named = _ITEM.fullmatch(item.strip())
        if not named:
            raise ReadError(f"“{item[:40]}” is no item", instead="Items are 1, 2, 3.1, …", place=Place(file, line))
        answers = rows.setdefault(key, (line, {}))[1]
        if named[1] in answers:
            raise ReadError(f"item {named[1]} of “{key[0] or key[1]}” is answered twice", place=Place(file, line))
        answers[named[1]] = answer
    return [AnswerRow(*key, answers, line) for key, (line, answers) in rows.items()]


def _unique(rows: list[AnswerRow], file: str) -> tuple[AnswerRow, ...]:
    """The rows, if each says who it is of, and no student comes twice. Raises ReadError."""
    seen: dict[str, int] = {}
    for row in rows:
        key = row.student or row.code
        if not key:
            raise _doubtful("this row names no student and no form code", row.line, file)
        if key in seen:
            raise _doubtful(f"“{key[:40]}” has a row already, in line {seen[key]}", row.line, file)
        seen[key] = row.line
    return tuple(rows)


def _doubtful(what: str, line: int, file: str) -> RbpsymError:
    return ReadError(what, instead="Each student has one row.", place=Place(file, line))


# --- the table of marks: a row a student. No cell is a formula to a spreadsheet, whatever a student typed


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
