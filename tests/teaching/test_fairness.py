"""Grading is fair: numbers put in, the teacher's decisions, a slip that is punished once."""

from __future__ import annotations

import csv
import io

import pytest

from rbpsym.notation.machine import to_machine
from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading.desk import Desk, grade_worksheet
from rbpsym.teaching.grading.marking import grade
from rbpsym.teaching.model import ExplanationKey, FormulaKey, NumberKey, Student
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.spreadsheets import parse_answers

CHAIN = """
title = "Chain"
[[problem]]
name = "rod-pendulum"
[[problem.task]]
kind = "formula"
about = "acceleration.theta"
[[problem.task]]
kind = "number"
about = "acceleration.theta"
[[problem.task]]
kind = "number"
about = "speed.theta"
"""


@pytest.fixture
def chain(tmp_path):
    path = tmp_path / "chain.toml"
    path.write_text(CHAIN)
    return plan_of(path).worksheet(Student("ana"), "s")


def marked(sheet, **answers):
    return {m.item: m for m in grade_worksheet(sheet, {k[1:]: v for k, v in answers.items()}, Desk())}


def test_a_wrong_acceleration_is_carried_into_the_speed(chain):
    """Twice the acceleration, so √2 times the speed: the slip is punished once."""
    acceleration, speed = (item for item in chain.items if isinstance(item.key, NumberKey))
    unit = speed.key.measure.unit
    factor = read_unit(unit).factor
    own = f"{2 * float(acceleration.key.measure.value):.6g} {acceleration.key.measure.unit}"
    follows = f"{speed.key.exact * 2**0.5 / factor:.3g} {unit}"
    found = marked(chain, **{f"q{acceleration.id}": own, f"q{speed.id}": follows})
    assert found[acceleration.id].points < found[acceleration.id].most
    assert found[speed.id].judgement.status.value == "carried forward" and found[speed.id].points == found[speed.id].most
    alone = marked(chain, **{f"q{speed.id}": follows})[speed.id]
    assert alone.points < alone.most


def test_numbers_of_the_paper_put_in_are_left_to_the_teacher(chain):
    [item] = [item for item in chain.items if isinstance(item.key, FormulaKey)]
    given = {name: float(m.value) * read_unit(m.unit).factor for name, m in chain.parts[0].given.items()}
    text = to_machine(item.key.value)
    for name, value in given.items():
        text = text.replace(name, f"({value:.4f})") if name != "theta" else text
    found = marked(chain, **{f"q{item.id}": text})[item.id].judgement
    assert [remark.key for remark in found.remarks] == ["numbers put in"] and found.is_for_teacher, (text, found)
    assert not marked(chain, **{f"q{item.id}": f"1.3*({text})"})[item.id].judgement.is_for_teacher


def rows(graded):
    return list(csv.reader(io.StringIO(graded.marks)))


def test_the_teacher_decides_what_is_left_open():
    sheet = plan_of("sliding-ladder").worksheet(Student("ana"))
    [item] = [item for item in sheet.items if isinstance(item.key, ExplanationKey)][:1]
    most = float(item.points)
    table = f"student,{item.id},{item.id} points\nana,No torque.,\nbob,No torque.,{most - 1:g}\ncleo,No torque.,99\n"
    graded = grade("sliding-ladder", parse_answers(table), pages=True, processes=1)
    head, ana, bob, cleo = rows(graded)
    at, teacher = head.index(item.id), head.index("teacher")
    assert item.id in ana[teacher].split() and bob[teacher] == "" and bob[at] == f"{most - 1:g}"
    assert bob[at + 1] == "Marked by the teacher." and float(bob[head.index("total")]) == most - 1
    assert "Marked by the teacher." in graded.pages["bob.html"]
    assert cleo[teacher] == "all" and any("earns 0 to" in sentence for sentence in graded.told)
    assert not any("passed over" in sentence for sentence in graded.told)
