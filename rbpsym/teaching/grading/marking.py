"""A whole class: answers in, marks and pages of feedback out."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from fractions import Fraction
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType
from typing import Any

from rbpsym.document.files import write_whole
from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field, replace
from rbpsym.teaching.batch import SUFFIX, TURN, Handout, check, findable, known_plan, record_of
from rbpsym.teaching.executor import Journal, crew, run
from rbpsym.teaching.grading.desk import Desk, Mark, decided, grade_worksheet
from rbpsym.teaching.grading.feedback import feedback_page, file_name, remarks_text
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.plan import WorksheetPlan
from rbpsym.teaching.ranges import number_text
from rbpsym.teaching.spreadsheets import AnswerRow, AnswerTable, load_roster, marks_csv, read_answers

# --- the class list beside the answers: names for the marks, keys that nobody has, papers that were exchanged or are missing


_NOBODY: Mapping[str, str] = MappingProxyType({})


class ClassList(Frozen):
    """The rows that can be marked, those that can't with the reason, and what there is to say.

    names: the name of each student by key, empty without a list; absent: students without a row.
    """

    rows: tuple[AnswerRow, ...]
    refused: tuple[tuple[AnswerRow, str], ...] = ()
    told: tuple[str, ...] = ()
    names: Mapping[str, str] = field(default_factory=lambda: _NOBODY)
    absent: tuple[Student, ...] = ()


def class_list(
    rows: tuple[AnswerRow, ...], plan: WorksheetPlan, secret: str, language: str, roster: tuple[Student, ...] | None
) -> ClassList:
    """Each row with its student. A row that names only a form code belongs to the student with that paper."""
    if roster is None:
        return ClassList(*_once(rows))
    codes = {plan.worksheet(student, secret, language).code: student.id for student in roster}
    names = {student.id: student.name for student in roster}
    known, refused = _once(tuple(row if row.student else replace(row, student=codes.get(row.code, "")) for row in rows))
    unknown = tuple((row, _unknown(row, names)) for row in known if row.student and row.student not in names)
    kept = tuple(replace(row, name=names.get(row.student, "")) for row in known if not row.student or row.student in names)
    exchanged = tuple(_exchanged(row, codes[row.code]) for row in kept if codes.get(row.code, row.student) != row.student)
    absent = tuple(student for student in roster if student.id not in {row.student for row in rows} | {r.student for r in kept})
    missing = (f"no answers: {', '.join(map(_called, absent))}.",) if absent else ()
    return ClassList(kept, (*refused, *unknown), (*exchanged, *missing), names, absent)


def _unknown(row: AnswerRow, names: Mapping[str, str]) -> str:
    near = get_close_matches(row.student, names, n=1)
    return f"“{row.student[:40]}” is not in the class list" + (f"; is it “{near[0]}”?" if near else "")


def _exchanged(row: AnswerRow, owner: str) -> str:
    return f"line {row.line}: {row.student} answered the paper of {owner}; it is marked by that paper."


def _called(student: Student) -> str:
    return student.id if student.name in ("", student.id) else f"{student.id} ({student.name})"


def _once(rows: tuple[AnswerRow, ...]) -> tuple[tuple[AnswerRow, ...], tuple[tuple[AnswerRow, str], ...]]:
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


# ---


class GradingOrder(Handout):
    """Whose answers are to be graded, and whether pages of feedback are wanted."""

    pages: bool = False


class Graded(Frozen):
    """The outcome: the text of marks.csv, pages by file name, how many answers the teacher should look at,
    columns and rows that could not be used, each told in a sentence."""

    marks: str
    pages: dict[str, str]
    students: int
    answers: int
    for_teacher: int
    told: tuple[str, ...]


Told = Callable[[int, int], None]


def grade(
    worksheet: str | Path,
    answers: str | Path | AnswerTable,
    *,
    secret: str = "",
    language: str = "",
    roster: str | Path | tuple[Student, ...] | None = None,
    papers: str | Path | None = None,
    pages: bool = False,
    executor: str = "",
    processes: int = 0,
    journal: Path | None = None,
    told: Told = lambda done, of: None,
) -> Graded:
    """The marks of a class. `secret` is the --seed with which the papers were made.

    With `roster`, the class list, the marks hold names, and keys that nobody has are told. `papers` is the folder of
    the papers, where it is not near the answers: papers that are not those that are made now are refused.
    With `journal` an interrupted run goes on where it was. Raises RbpsymError for files that can't be
    used; never for an answer.
    """
    plan, source = known_plan(str(worksheet)), findable(str(worksheet))
    table = answers if isinstance(answers, AnswerTable) else read_answers(Path(answers))
    order = GradingOrder(source, secret, language, plan.fingerprint, pages)
    files = [Path(file) for file in (answers, roster, source) if isinstance(file, (str, Path))]
    fits = _papers_fit([Path(papers)] if papers else [file.parent for file in files], plan, order, table)
    listed = class_list(table.rows, plan, secret, language, _roster(roster))
    jobs = [(order, row) for row in listed.rows]
    held = Journal(journal, _about(order, listed.rows))
    found = [json.loads(text) for text in run(mark_rows, jobs, crew(executor, processes), held, told)]
    found += [_refused(row, why) for row, why in listed.refused]
    return _graded(found, table, replace(listed, told=(*fits, *listed.told)))


def _papers_fit(folders: list[Path], plan: WorksheetPlan, order: GradingOrder, table: AnswerTable) -> tuple[str, ...]:
    """What there is to say of the record beside the papers. Raises RbpsymError if it is of other papers."""
    path = record_of(plan.sheet.name, folders)
    if path is not None:
        said = check(path, plan, order.secret, order.language, [row.student for row in table.rows if not row.code])
        return (said,) if said else ()
    if all(row.code for row in table.rows):
        return ()  # a form code tells by itself whether it fits
    name = f"{plan.sheet.name}{SUFFIX}"
    return (f"no {name} was found (--papers DIR): nothing shows that the --seed is that of the papers.",)


def _roster(roster: str | Path | tuple[Student, ...] | None) -> tuple[Student, ...] | None:
    return roster if roster is None or isinstance(roster, tuple) else load_roster(Path(roster))


def _refused(row: AnswerRow, why: str) -> dict[str, object]:
    return {"student": row.student, "code": row.code, "error": f"line {row.line}: {why}"}


def _about(order: GradingOrder, rows: tuple[AnswerRow, ...]) -> str:
    """Stands for all that the results depend on."""
    from rbpsym import __version__

    parts = (__version__, order.fingerprint, order.secret, order.language, order.pages, rows)
    return sha256(repr(parts).encode("utf-8", "surrogatepass")).hexdigest()


@lru_cache(maxsize=8)
def _desk(language: str) -> Desk:
    return Desk(language)


def mark_rows(jobs: tuple[tuple[GradingOrder, AnswerRow], ...]) -> list[str]:
    """The marks of some rows, each as JSON. A function of this module, so that other processes can call it."""
    with TURN:
        return [json.dumps(_marked(order, row), ensure_ascii=False) for order, row in jobs]


def _marked(order: GradingOrder, row: AnswerRow) -> dict[str, object]:
    plan = order.plan()
    try:
        sheet = _sheet(plan, order, row)
        marks = grade_worksheet(sheet, row.answers, _desk(sheet.language))
        marks = tuple(decided(mark, row.decided[mark.item]) if mark.item in row.decided else mark for mark in marks)
    except RbpsymError as error:
        return _refused(row, error.what)
    return _told(order, row, sheet, marks)


def _sheet(plan: WorksheetPlan, order: GradingOrder, row: AnswerRow) -> Worksheet:
    """The paper of a row: by its form code if it has one."""
    if row.code:
        return plan.from_code(row.code, order.secret, Student(row.student) if row.student else None)
    return plan.worksheet(Student(row.student), order.secret, order.language)


def _told(order: GradingOrder, row: AnswerRow, sheet: Worksheet, marks: tuple[Mark, ...]) -> dict[str, object]:
    name = row.student or sheet.code
    return {
        "student": row.student,
        "code": sheet.code,
        "total": number_text(sum((mark.points for mark in marks), Fraction(0))),
        "most": number_text(sheet.points),
        "items": [[mark.item, number_text(mark.points), remarks_text(mark, sheet)] for mark in marks],
        "teacher": [mark.item for mark in marks if mark.judgement.is_for_teacher],
        "answered": sum(bool(mark.answer.strip()) for mark in marks),
        "file": file_name(name),
        "page": feedback_page(sheet, marks, row.name or name) if order.pages else "",
    }


def _graded(found: list[dict[str, Any]], table: AnswerTable, listed: ClassList) -> Graded:
    whole = [one for one in found if "error" not in one]
    items = list(dict.fromkeys(item for one in whole for item, _, _ in one["items"]))
    header = ["student", "code", "total", "of", "teacher", *(c for item in items for c in (item, f"{item} remarks"))]
    rows = [_row(one, items) for one in found]
    rows += [[student.id, "", "", "", *([""] * (2 * len(items) + 1))] for student in listed.absent]
    if listed.names:
        header.insert(1, "name")
        rows = [[row[0], listed.names.get(row[0], ""), *row[1:]] for row in rows]
    told = [f"the column “{name}” is no item of the worksheet and was passed over." for name in table.passed_over]
    told += [f"{one['student'] or one['code']}: {one['error'].rstrip('?')}." for one in found if "error" in one]
    told += listed.told
    known = {name.partition(".")[0] for row in table.rows for name in row.answers} - set(items)
    told += [f"the worksheet has no item {name}." for name in sorted(known) if whole]
    return Graded(
        marks_csv(header, rows),
        {one["file"]: one["page"] for one in whole if one["page"]},
        len(found),
        sum(one["answered"] for one in whole),
        sum(len(one["teacher"]) for one in whole),
        tuple(told),
    )


def _row(one: dict[str, Any], items: list[str]) -> list[str]:
    if "error" in one:
        return [one["student"], one["code"], "", "", "all", *([""] * (2 * len(items) - 1)), one["error"]][: 5 + 2 * len(items)]
    held = {item: (points, said) for item, points, said in one["items"]}
    cells = [cell for item in items for cell in held.get(item, ("", ""))]
    return [one["student"], one["code"], one["total"], one["most"], " ".join(one["teacher"]), *cells]


def write_graded(graded: Graded, marks: Path, folder: Path | None) -> list[Path]:
    """Write marks.csv and the pages, each whole or not at all. The marks carry a mark of UTF-8 for spreadsheets."""
    written = [write_whole(folder / name, page) for name, page in graded.pages.items()] if folder else []
    return [write_whole(marks, "\ufeff" + graded.marks), *written]
