"""A class: tables of answers, marks that no spreadsheet runs, pages of feedback, and every kind of item."""

from __future__ import annotations

import csv
import io
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from rbpsym.errors import ReadError
from rbpsym.teaching.grading.desk import Desk, Mark, grade_worksheet
from rbpsym.teaching.grading.feedback import feedback_page, file_name
from rbpsym.teaching.grading.marking import grade
from rbpsym.teaching.model import (
    BlanksKey,
    ChoiceKey,
    ComparisonKey,
    ExplanationKey,
    FormulaKey,
    Item,
    NumberKey,
    OrderKey,
    SignsKey,
    SlipKey,
    Student,
    Worksheet,
)  # fmt: skip
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.ranges import measure_text
from rbpsym.teaching.spreadsheets import RISKY, marks_csv, parse_answers, read_answers, safe
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.machine import to_machine
from rbpsym.typeset.text import to_text
from tests.teaching.sample_worksheet import POWERED, worksheet

SHEET, DESK = worksheet(), Desk()


def marks(**answers: str) -> dict[str, Mark]:
    return {
        mark.item: mark
        for mark in grade_worksheet(SHEET, {name[1:].replace("_", "."): text for name, text in answers.items()}, DESK)
    }


@pytest.mark.parametrize(
    ("item", "answer", "credit", "status"),
    [
        ("4", "b", 1, "right"), ("4", "B)", 1, "right"), ("4", "2", 1, "right"), ("4", "a", 0, "wrong"), ("4", "z", 0, "invalid"),
        ("4", "b c", 0, "invalid"), ("4", "b or a", 0, "invalid"), ("4", "a/b", 0, "invalid"), ("4", "b, c?", 0, "invalid"),
        ("4", "b because a force pulls", 1, "right"), ("4", "b, maybe", 1, "right"), ("4", "b b", 1, "right"),
        ("1", "don't know", 0, "empty"), ("2", "I don't know.", 0, "empty"), ("4", "???", 0, "empty"),
        ("5", "b c a", 1, "right"), ("5", "c, b, a", 1, "right"), ("5", "cba", 1, "right"),
        ("5", "2 > 3 > 1", 1, "right"), ("5", "b a c", 0, "wrong"), ("5", "a b c", 0, "wrong"), ("5", "a b", 0, "invalid"),
        ("5", "a a b", 0, "invalid"), ("6", "2", 1, "right"), ("6", "line 2", 1, "right"), ("6", "b", 1, "right"),
        ("6", "1", 0, "wrong"), ("6", "2: alpha = " + POWERED, 1, "right"),
        ("6", "2: alpha = -g sin(theta)/ell", Fraction(1, 2), "partly right"),
        ("6", "7", 0, "invalid"), ("7", "+ - a; - 0 a; + 0", 1, "right"), ("7", "+−x −0x +0", 1, "right"),
        ("7", "+ -; - 0; + 0", Fraction(3, 4), "partly right"), ("7", "+ - a; - 0; + 0 a", Fraction(3, 4), "partly right"),
        ("7", "+ - n; + 0 n; + 0", Fraction(3, 4), "partly right"), ("7", "000000", 0, "wrong"), ("7", "+ -", 0, "invalid"),
        ("8", "M g ell (1 - cos θ); M g ell", 1, "right"), ("8", "M g ell cos θ; M g ell", Fraction(1, 2), "partly right"),
        ("8", "M g ell (1 - cos θ)", Fraction(1, 2), "partly right"), ("9", "a because", Fraction(1, 2), "partly right"),
        ("9", "b", 0, "wrong"), ("10", "No torque.", 0, "open"), ("10", "", 0, "empty"), ("1", POWERED, 1, "right"),
        ("2", "-5.12 rad/s^2", 1, "right"), ("2", "-5.12", Fraction(4, 5), "partly right"),
    ],
)  # fmt: skip
def test_every_kind_of_item(item: str, answer: str, credit: Fraction, status: str) -> None:
    found = marks(**{f"q{item}": answer})[item]
    assert (found.judgement.credit, found.judgement.status.value) == (credit, status), found
    assert found.points == credit * found.most


def test_blanks_may_have_columns_of_their_own() -> None:
    assert marks(q8_1="M g ell (1 - cos θ)", q8_2="M g ell")["8"].judgement.credit == 1


def test_a_slip_of_a_blank_is_told() -> None:
    found = marks(q8="M g ell cos θ; M g ell")["8"].judgement
    assert found.slip is not None and [remark.key for remark in found.remarks] == ["blank", "slip", "first wrong"]


def test_an_error_is_carried_forward() -> None:
    """A wrong formula in item 1 is taken as it is in item 3: R times the own angular acceleration."""
    own = "-(m/2 + M)*g*ell*sin(theta)/(m*ell**2/3 + M*ell**2)"
    value = 0.25 * -(0.5 + 2) * 9.81 * 0.5 / (1 / 3 + 2)
    found = marks(q1=own, q3=f"{value:.3g} m/s^2")
    assert found["1"].judgement.status.value == "wrong"
    assert found["3"].judgement.status.value == "carried forward" and found["3"].points == found["3"].most
    alone = marks(q3=f"{value:.3g} m/s^2")
    assert alone["3"].judgement.status.value == "wrong"
    for trivial in ("0", "1", "theta''", "g", "m/"):
        assert marks(q1=trivial, q3="0 m/s^2")["3"].points == 0


# --- every kind of answer of real worksheets: the key is right however it is printed, each slip is known again

PRINTERS = {"latex": to_latex, "text": to_text, "machine": to_machine}


@cache
def sheets(name: str) -> tuple[Worksheet, ...]:
    plan = plan_of(name)
    return tuple(plan.worksheet(Student(student), "secret") for student in ("ana", "bob"))


def right_answer(item: Item, sheet: Worksheet, printed) -> str:
    match item.key:
        case FormulaKey(value=value):
            return printed(value, sheet.notation)
        case NumberKey(measure=measure):
            return measure_text(measure)
        case ChoiceKey(right=right) | ComparisonKey(right=right):
            return "abcdefgh"[right]
        case OrderKey(sample=sample):
            return " ".join("abcdefgh"[place] for place in sample)
        case SlipKey(wrong=wrong):
            return str(wrong + 1)
        case SignsKey(rows=rows):
            letters = {
                name: "abcdefgh"[k] for k, name in enumerate(dict.fromkeys(row.cancels for row in rows if row.cancels))
            }
            return "; ".join(f"{row.translational} {row.rotational} {letters.get(row.cancels, '')}" for row in rows)
        case BlanksKey(blanks=blanks):
            return " ; ".join(printed(blank.value, sheet.notation) for blank in blanks)
    return ""


@pytest.mark.parametrize("name", ["sliding-ladder", "rod-and-disk-free"])
@pytest.mark.parametrize("printer", PRINTERS)
def test_keys_are_right_however_they_are_printed(name: str, printer: str) -> None:
    for sheet in sheets(name):
        answers = {item.id: right_answer(item, sheet, PRINTERS[printer]) for item in sheet.items}
        for mark in grade_worksheet(sheet, answers, DESK):
            item = sheet.item(mark.item)
            if isinstance(item.key, (ExplanationKey, ComparisonKey)):
                continue
            ambiguous = printer == "text" and mark.judgement.is_for_teacher  # 3g/4ℓ on one line can be read in two ways
            assert mark.points == mark.most or ambiguous, mark


@pytest.mark.parametrize("name", ["sliding-ladder", "rod-and-disk-free"])
def test_slips_are_known_again(name: str) -> None:
    seen = 0
    for sheet in sheets(name):
        for item in sheet.items:
            for known in getattr(item.key, "anticipated", ()):
                is_number = isinstance(item.key, NumberKey)
                answer = measure_text(known.number) if is_number else to_machine(known.formula)
                (found,) = [mark for mark in grade_worksheet(sheet, {item.id: answer}, DESK) if mark.item == item.id]
                assert found.judgement.slip == known.slip and found.judgement.credit < 1, (answer, found)
                seen += 1
    assert seen >= 8


# --- tables of answers


def test_wide_tables() -> None:
    for text in (
        "student,1,Q2,item 3.1,note\nana,x,y,z,n\n",
        "student;1;Q2;item 3.1;note\nana;x;y;z;n\n",
        "Student\t1\tQ2\tItem 3.1\tnote\r\nana\tx\ty\tz\tn\r\n",
    ):
        table = parse_answers(text)
        assert [(row.student, dict(row.answers)) for row in table.rows] == [("ana", {"1": "x", "2": "y", "3.1": "z"})]
        assert table.passed_over == ("note",)


def test_long_tables() -> None:
    table = parse_answers('student,item,answer\nana,1,"m, g"\nbob,1,x\nana,Q2,y\n')
    assert [(row.student, dict(row.answers)) for row in table.rows] == [
        ("ana", {"1": "m, g", "2": "y"}),
        ("bob", {"1": "x"}),
    ]


def test_cells_may_hold_lines_and_quotes() -> None:
    (row,) = parse_answers('student,1\nana,"a ""b""\nc"\n').rows
    assert row.answers["1"] == 'a "b"\nc'


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("", "no column"), ("name,1\nana,x\n", "no column"), ("student,1\n,x\n", "names no student"),
        ("student,1\nana,x\nana,y\n", "has a row already, in line 2"), ("student,item,answer\nana,one,x\n", "is no item"),
        ("student,item,answer\nana,1,x\nana,1,y\n", "answered twice"),
    ],
)  # fmt: skip
def test_tables_that_can_not_be_used(text: str, what: str) -> None:
    with pytest.raises(ReadError, match=what):
        parse_answers(text)


def test_encodings(tmp_path: Path) -> None:
    path = tmp_path / "answers.csv"
    for encoding in ("utf-8", "utf-8-sig", "utf-16"):
        path.write_bytes("student,1\nañá,mgℓ\n".encode(encoding))
        assert read_answers(path).rows[0].answers["1"] == "mgℓ"
    path.write_bytes("student,1\nañá,x\n".encode("latin-1"))
    with pytest.raises(ReadError, match="not UTF-8"):
        read_answers(path)
    with pytest.raises(ReadError, match="can't read"):
        read_answers(tmp_path / "none.csv")


# --- marks and pages

HOSTILE = [
    "=1+1",
    "+1",
    "-1",
    "@SUM(1)",
    "\t=1",
    "\r=1",
    " =1",
    "'=1",
    '"=1',
    "＝1",
    "－1",
    "|calc",
    "%0A",
    "\n=1",
    "=cmd|' /C calc'!A0",
]


@pytest.mark.parametrize("cell", HOSTILE)
def test_no_cell_is_a_formula(cell: str) -> None:
    rows = list(csv.reader(io.StringIO(marks_csv(["student"], [[cell]]))))
    assert rows[1][0] == safe(cell)
    assert not rows[1][0].startswith(RISKY) and rows[1][0].startswith("'")
    assert "\n" not in rows[1][0] and "\r" not in rows[1][0]


@pytest.mark.parametrize("cell", ["ana", "0.5", "Right.", "“=” is here"])
def test_harmless_cells_stay(cell: str) -> None:
    assert safe(cell) == cell


@pytest.mark.parametrize(
    "student",
    ["../../etc/passwd", "/root", "..", ".", "a/b", "a\\b", "nul\x00", "x" * 300, "", "=1", "\u202e", "ana\n"],
)
def test_pages_stay_in_their_folder(student: str, tmp_path: Path) -> None:
    name = file_name(student)
    assert (tmp_path / name).resolve().parent == tmp_path.resolve()
    assert name.endswith(".html") and len(name) < 120 and not name.startswith(".")


def test_names_of_pages_differ() -> None:
    names = ["a b", "a-b", "a/b", "A b", "ana", "Ana", "ana ", "a  b"]
    assert len({file_name(name) for name in names}) == len(names)


def test_pages_run_nothing() -> None:
    answers = {
        item.id: f"<script>alert({item.id})</script><img src=x onerror=alert(1)>\u202e&#60;" for item in SHEET.items
    }
    page = feedback_page(SHEET, grade_worksheet(SHEET, answers, DESK), "<b>ana</b>")
    assert "<script" not in page and "<img" not in page and "<b>" not in page and "\u202e" not in page
    assert "⟨U+202E⟩" in page


def test_a_class(tmp_path: Path) -> None:
    name = "sliding-ladder"
    plan = plan_of(name)
    code = plan.worksheet(Student("bob"), "s").code
    sheet = plan.worksheet(Student("ana"), "s")
    number = next(item for item in sheet.items if isinstance(item.key, NumberKey))
    path = tmp_path / "answers.csv"
    path.write_text(
        f"student,code,{number.id},99\nana,,{measure_text(number.key.measure)},\n=bob,{code},,\neve,{name}.en.AAAA-AAAA-AAAA-AA,,\n",
        encoding="utf-8",
    )
    graded = grade(name, path, secret="s", pages=True)
    rows = list(csv.DictReader(io.StringIO(graded.marks)))
    assert [row["student"] for row in rows] == ["ana", "'=bob", "eve"]
    assert float(rows[0][number.id]) == float(number.points) and rows[0][f"{number.id} remarks"] == "Right."
    assert rows[1]["code"] == code and rows[1]["total"] == "0"
    assert rows[2]["teacher"] == "all" and rows[2]["total"] == ""
    assert any("does not fit" in sentence for sentence in graded.told) and any(
        "no item 99" in sentence for sentence in graded.told
    )
    assert len(graded.pages) == 2


# --- with the class list

ROSTER = (
    Student("001", "Siobhán O'Brien"),
    Student("002", "李 小龙"),
    Student("003", "=cmd|' /C calc'!A0"),
    Student("004"),
)


def listed(*lines: str):
    return grade("sliding-ladder", parse_answers("\n".join(lines)), secret="autumn", roster=ROSTER, processes=1)


def rows_of(graded) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(graded.marks)))


def test_a_class_list_gives_names_and_tells_who_is_missing() -> None:
    graded = listed("student,1", "001,g", "002,g", "0O3,g")
    found = {row["student"]: row for row in rows_of(graded)}
    assert [found[key]["name"] for key in ("001", "002", "003", "0O3")] == [
        "Siobhán O'Brien",
        "李 小龙",
        "'=cmd|' /C calc'!A0",
        "",
    ]
    assert found["003"]["total"] == "" and found["001"]["total"] != "" and found["0O3"]["teacher"] == "all"
    assert any("“0O3” is not in the class list; is it “003”" in text for text in graded.told)
    assert graded.told[-1] == "no answers: 003 (=cmd|' /C calc'!A0), 004."


def test_codes_find_their_students() -> None:
    codes = {row["student"]: row["code"] for row in rows_of(listed("student,1", "001,g", "002,g"))}
    graded = listed("student,code,1", f",{codes['001']},g", f"002,{codes['002']},g", f"004,{codes['001']},g", "003,,g")
    rows = [(row["student"], row["teacher"]) for row in rows_of(graded)]
    assert rows[0][0] == "001" and ("004", "all") in rows
    assert any("the same paper as in line 2" in text for text in graded.told)


def test_an_exchanged_paper_is_marked_by_itself() -> None:
    codes = {row["student"]: row["code"] for row in rows_of(listed("student,1", "001,g", "002,g"))}
    graded = listed("student,code,1", f"001,{codes['002']},g")
    assert "line 2: 001 answered the paper of 002; it is marked by that paper." in graded.told
    assert rows_of(graded)[0]["code"] == codes["002"]


def test_rows_that_cancel_may_be_marked_together_or_apart() -> None:
    from rbpsym.teaching.grading.choices import _cancel, _groups

    assert _cancel(_groups(["a", "b", ""]), _groups(["N", "F", ""])) and _cancel(
        _groups(["a", "a", ""]), _groups(["N", "F", ""])
    )
    assert not _cancel(_groups(["a", "b", ""]), _groups(["N", "N", ""]))
    assert not _cancel(_groups(["a", "a", "a"]), _groups(["N", "N", ""])) and not _cancel(
        _groups(["a", "", ""]), _groups(["N", "F", ""])
    )
