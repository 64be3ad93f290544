"""The table of answers: a row a student with a column an item, or a row an answer.

“3 points” beside an item holds what the teacher decided of it.

Columns: `student` (or `id`), or `code` (or `form`) for the form code on the paper; then the items, as
“3”, “Q3” or “item 3”, blanks as “3.1”. Other columns are passed over, and named in a report.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rbpsym.errors import Place, RbpsymError, ReadError
from rbpsym.statement.files import text_in
from rbpsym.teaching.csv_rows import rows_in

LARGEST = 64 * 1024 * 1024
STUDENT, CODE, ITEM, ANSWER = (
    ("student", "id", "estudiante"),
    ("code", "form", "código", "codigo"),
    ("item", "task"),
    ("answer", "respuesta"),
)
_POINTS = re.compile(r"(?:q|question|item|task|pregunta|p)?[\s_.:-]*(\d+)[\s_.:-]*(?:points?|puntos?)", re.IGNORECASE)
_ITEM = re.compile(r"(?:q|question|item|task|pregunta|p)?[\s_.:-]*(\d+(?:\.\d+)?)\.?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Row:
    """The answers of one student by item; `line` of the file, `name` that of the class list, points `decided` by the teacher."""

    student: str
    code: str
    answers: Mapping[str, str]
    line: int = 0
    name: str = ""
    decided: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class AnswerTable:
    """All rows, in the order of the file, and the columns that were passed over."""

    rows: tuple[Row, ...]
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
    if item is not None and answer is not None:
        return AnswerTable(_from_long(lines, who, code, item, answer, file))
    columns = {place: found[1] for place, name in enumerate(names) if (found := _ITEM.fullmatch(name))}
    decided = {place: found[1] for place, name in enumerate(names) if (found := _POINTS.fullmatch(name))}
    known = (*columns, *decided, who, code)
    other = tuple(header[place] for place in range(len(names)) if place not in known and header[place].strip())
    return AnswerTable(_from_wide(lines, who, code, columns, decided, file), other)


def _column(names: list[str], known: tuple[str, ...]) -> int | None:
    return next((place for place, name in enumerate(names) if name in known), None)


def _cell(cells: list[str], place: int | None) -> str:
    return cells[place] if place is not None and place < len(cells) else ""


def _from_wide(
    lines: Iterator[tuple[int, list[str]]],
    who: int | None,
    code: int | None,
    columns: Mapping[int, str],
    decided: Mapping[int, str],
    file: str,
) -> tuple[Row, ...]:
    rows = []
    for line, cells in lines:
        answers = {item: _cell(cells, place) for place, item in columns.items()}
        points = {item: told for place, item in decided.items() if (told := _cell(cells, place).strip())}
        rows.append(Row(_cell(cells, who).strip(), _cell(cells, code).strip(), answers, line, decided=points))
    return _unique(rows, file)


def _from_long(
    lines: Iterator[tuple[int, list[str]]], who: int | None, code: int | None, item: int, answer: int, file: str
) -> tuple[Row, ...]:
    held: dict[tuple[str, str], dict[str, str]] = {}
    first: dict[tuple[str, str], int] = {}
    for line, cells in lines:
        key = (_cell(cells, who).strip(), _cell(cells, code).strip())
        found = _ITEM.fullmatch(_cell(cells, item).strip())
        if not found:
            raise ReadError(
                f"“{_cell(cells, item)[:40]}” is no item", instead="Items are 1, 2, 3.1, …", place=Place(file, line)
            )
        answers = held.setdefault(key, {})
        if found[1] in answers:
            raise ReadError(f"item {found[1]} of “{key[0] or key[1]}” is answered twice", place=Place(file, line))
        answers[found[1]] = _cell(cells, answer)
        first.setdefault(key, line)
    return _unique([Row(*key, answers, first[key]) for key, answers in held.items()], file)


def _unique(rows: list[Row], file: str) -> tuple[Row, ...]:
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
