"""Names of students that a font has no letters for never stop the papers of a class."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rbpsym.teaching.formats import Options
from rbpsym.teaching.model import Student
from rbpsym.teaching.paper_files import export_pdf, export_tex
from rbpsym.teaching.papers.layout import has_letters, without_letters
from tests.teaching.sample_worksheet import worksheet


@pytest.mark.parametrize("name", ["Siobhán O'Brien", "Łukasz Żółć", "Ştefan Ğ", 'Bob "Al" <b>#$%&_{}~^\\</b>'])
def test_names_that_every_engine_sets(name: str) -> None:
    assert has_letters(name, "typst") and has_letters(name, "pdflatex")


@pytest.mark.parametrize(
    ("name", "by_typst"), [("李 小龙", False), ("💥", False), ("Ελένη", True), ("Nguyễn Thị", True)]
)
def test_names_that_some_set(name: str, by_typst: bool) -> None:
    assert has_letters(name, "typst") == by_typst and not has_letters(name, "pdflatex")
    assert bool(without_letters([Student("1", name)], "typst")) != by_typst


@pytest.mark.parametrize("name", ["李 小龙", "=cmd|' /C calc'!A0", "#panic() \\input{x} $x$ @a"])
def test_papers_are_made(name: str) -> None:
    sheet = replace(worksheet(), student=Student("003", name))
    (paper,) = export_pdf((sheet,), Options()).files.values()
    assert paper.startswith(b"%PDF")
    (source,) = export_tex((sheet,), Options()).files.values()
    assert "李" not in source and ("003" in source or "cmd" in source or "panic" in source)
