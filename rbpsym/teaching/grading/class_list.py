"""The class list beside the answers: names for the marks, keys that nobody has, papers that were exchanged or are missing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from types import MappingProxyType

from rbpsym.teaching.grading.answers_csv import Row
from rbpsym.teaching.model import Student
from rbpsym.teaching.plan import Plan

_NOBODY: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class ClassList:
    """The rows that can be marked, those that can't with the reason, and what there is to say.

    names: the name of each student by key, empty without a list; absent: students without a row.
    """

    rows: tuple[Row, ...]
    refused: tuple[tuple[Row, str], ...] = ()
    told: tuple[str, ...] = ()
    names: Mapping[str, str] = field(default_factory=lambda: _NOBODY)
    absent: tuple[Student, ...] = ()


def class_list(
    rows: tuple[Row, ...], plan: Plan, secret: str, language: str, roster: tuple[Student, ...] | None
) -> ClassList:
    """Each row with its student. A row that names only a form code belongs to the student with that paper."""
    if roster is None:
        return ClassList(*_once(rows))
    codes = {plan.worksheet(student, secret, language).code: student.id for student in roster}
    names = {student.id: student.name for student in roster}
    known, refused = _once(tuple(row if row.student else replace(row, student=codes.get(row.code, "")) for row in rows))
    unknown = tuple((row, _unknown(row, names)) for row in known if row.student and row.student not in names)
    kept = tuple(
        replace(row, name=names.get(row.student, "")) for row in known if not row.student or row.student in names
    )
    exchanged = tuple(
        _exchanged(row, codes[row.code]) for row in kept if codes.get(row.code, row.student) != row.student
    )
    absent = tuple(
        student for student in roster if student.id not in {row.student for row in rows} | {r.student for r in kept}
    )
    missing = (f"no answers: {', '.join(map(_called, absent))}.",) if absent else ()
    return ClassList(kept, (*refused, *unknown), (*exchanged, *missing), names, absent)


def _unknown(row: Row, names: Mapping[str, str]) -> str:
    near = get_close_matches(row.student, names, n=1)
    return f"“{row.student[:40]}” is not in the class list" + (f"; is it “{near[0]}”?" if near else "")


def _exchanged(row: Row, owner: str) -> str:
    return f"line {row.line}: {row.student} answered the paper of {owner}; it is marked by that paper."


def _called(student: Student) -> str:
    return student.id if student.name in ("", student.id) else f"{student.id} ({student.name})"


def _once(rows: tuple[Row, ...]) -> tuple[tuple[Row, ...], tuple[tuple[Row, str], ...]]:
    """(the first row of each paper, further ones with the reason): one by the key, another by the code of the paper."""
    seen: dict[str, int] = {}
    kept, again = [], []
    for row in rows:
        held = next((seen[key] for key in (row.code, row.student) if key in seen), None)
        if held is None:
            kept.append(row)
            seen |= {key: row.line for key in (row.code, row.student) if key}
        else:
            again.append((row, f"the same paper as in line {held}"))
    return tuple(kept), tuple(again)
