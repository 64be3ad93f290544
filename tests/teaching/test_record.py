"""Grading refuses papers that are not those that were given out: another seed, file, language or engine."""

import json

import pytest

from rbpsym.cli import main
from rbpsym.errors import RbpsymError
from rbpsym.teaching.batch import known_plan
from rbpsym.teaching.grading.marking import grade

SHEET = """
title = "Rod"
[[problem]]
name = "rod-pendulum"
[[problem.task]]
kind = "number"
about = "speed.theta"
number = 1
points = 3
"""
STUDENTS = "id,name\nana,Ana\nbob,Bob\n"
ANSWERS = "student,1\nana,1 rad/s\nbob,2 rad/s\n"


def fresh():
    """As in a new process, which reads the files anew."""
    known_plan.cache_clear()


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    fresh()
    for name, text in (("rod.toml", SHEET), ("class.csv", STUDENTS), ("answers.csv", ANSWERS)):
        (tmp_path / name).write_text(text)
    return tmp_path


def made(*more):
    names = ["rod.toml", "--students", "class.csv", "-o", "papers", "--format", "tex", "--jobs", "1"]
    assert main.main(["worksheet", *names, *more], standalone_mode=False) == 0


def graded(**more):
    return grade("rod.toml", "answers.csv", processes=1, **more)


def refused(**more):
    with pytest.raises(RbpsymError) as caught:
        graded(**more)
    assert "rod.papers.json" in str(caught.value) and caught.value.exit_code == 2
    return str(caught.value)


def test_the_seed_of_the_papers_is_asked_for(folder):
    made("--seed", "autumn")
    assert not any("--seed" in sentence for sentence in graded(secret="autumn").told)
    assert "they were made with a --seed" in refused()
    assert "the --seed or the language is another one" in refused(secret="spring")
    assert "the --seed or the language is another one" in refused(secret="autumn", language="es")
    assert graded(secret="autumn", roster="class.csv").marks.count("\n") == 3


def test_papers_without_a_seed_are_known_too(folder):
    made()
    assert graded().marks
    refused(secret="autumn")


def test_another_file_is_noticed(folder):
    made("--seed", "autumn")
    (folder / "rod.toml").write_text(SHEET.replace("Rod", "Rods"))
    fresh()
    assert any("was changed after its papers" in sentence for sentence in graded(secret="autumn").told)
    (folder / "rod.toml").write_text(SHEET.replace("number = 1", "number = 1\nlevel = 1").replace("speed", "acceleration"))
    fresh()
    assert "file is another one now" in refused(secret="autumn")


def test_an_engine_that_draws_otherwise_is_noticed(folder):
    made("--seed", "autumn")
    path = folder / "papers" / "rod.papers.json"
    record = json.loads(path.read_text())
    record["version"], record["papers"]["ana"] = "0.0.1", "0" * 16
    path.write_text(json.dumps(record))
    assert "made with rbpsym 0.0.1" in refused(secret="autumn")
    path.write_text("{}")
    assert "no record of papers" in refused(secret="autumn")


def test_where_nothing_is_known_that_is_said(folder):
    assert any("no rod.papers.json was found" in sentence for sentence in graded(secret="autumn").told)
    made("--seed", "autumn")
    (folder / "papers").rename(folder.parent / f"{folder.name}-elsewhere")
    assert any("no rod.papers.json" in sentence for sentence in graded(secret="autumn").told)
    refused(secret="", papers=folder.parent / f"{folder.name}-elsewhere")
    (folder / "answers.csv").write_text("student,1\nzoe,1 rad/s\n")
    told = graded(secret="x", papers=folder.parent / f"{folder.name}-elsewhere").told
    assert any("knows none of these students" in sentence for sentence in told)


def test_papers_of_two_lists_are_kept_together(folder):
    made("--seed", "autumn")
    (folder / "class.csv").write_text("id\ncleo\n")
    made("--seed", "autumn")
    assert set(json.loads((folder / "papers" / "rod.papers.json").read_text())["papers"]) == {"ana", "bob", "cleo"}


def test_the_command_ends_with_a_sentence_and_writes_nothing(folder):
    made("--seed", "autumn")
    with pytest.raises(RbpsymError):
        main.main(["grade", "rod.toml", "answers.csv", "-o", "marks.csv"], standalone_mode=False)
    assert not (folder / "marks.csv").exists()
