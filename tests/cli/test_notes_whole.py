"""Notes that are written again at each change, and notes of the whole library."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.commands.written import KeptDerivations, watch
from rbpsym.courses import derive_course, sources
from rbpsym.document.book import Chapter, around, book, index_page, occurring, page, problem_card
from rbpsym.document.model import Display, Ref, numbered, parts
from rbpsym.document.notes import notes
from rbpsym.document.writers import writer
from rbpsym.errors import RbpsymError
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files, find_problem
from tests.effort import at_most

NAMES = ("sliding-ladder", "rod-and-disk-free", "ball-on-incline")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return Path(shutil.copy(find_problem("sliding-ladder"), tmp_path / "mine.toml"))


def edit(file: Path, old: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")


def test_an_edit_of_words_derives_nothing_anew(file: Path) -> None:
    kept = KeptDerivations(False)
    before = kept.derivation(file)
    edit(file, "mass of the ladder", "how heavy it is")
    after = kept.derivation(file)
    assert after.steps is before.steps
    assert after.study.problem.parameters[0].meaning == "how heavy it is"
    assert after.study.system.problem is after.study.problem
    assert after.study.dynamics is before.study.dynamics
    assert "how heavy it is" in writer("md")(notes(after, detail="full"))


def test_an_edit_of_the_mechanics_derives_anew(file: Path) -> None:
    kept = KeptDerivations(False)
    before = kept.derivation(file)
    edit(file, 'speed   = "0"', 'speed   = "-omega_0"')
    edit(file, "[parameters]", '[parameters]\nomega_0 = "angular speed: at the start"')
    after = kept.derivation(file)
    assert [step.statement for step in after.steps] != [step.statement for step in before.steps]


def test_an_edit_of_the_notation_restyles_the_kept_steps(file: Path) -> None:
    kept = KeptDerivations(False)
    before = kept.derivation(file)
    edit(file, 'theta_dot  = "omega"', 'theta_dot  = "Omega"')
    after = kept.derivation(file)
    assert after.steps is before.steps
    assert r"\Omega" in writer("md")(notes(after, detail="full"))


def test_a_course_derives_only_the_problem_that_changed() -> None:
    course, kept = load_course(course_files()["paper"]), KeptDerivations(False)
    first = derive_course(course, derived=kept.derivation)
    again = derive_course(course, derived=kept.derivation)
    assert all(again.derivations[name].steps is found.steps for name, found in first.derivations.items())
    assert set(map(Path.stem.fget, sources(course)[1:])) == set(first.derivations)


def test_watching_writes_at_each_change_and_survives_bad_input(file: Path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.commands.written.PAUSE", 0.005)
    edits = iter(
        [("half the length", "half of it"), ("[parameters]", "[parametres]"), ("[parametres]", "[parameters]")]
    )
    kept, written = KeptDerivations(False), []

    def write() -> list[Path]:
        written.append(writer("html")(notes(kept.derivation(file), detail="full")))
        return [file.with_suffix(".html")]

    def until() -> bool:
        for old, new in edits:
            edit(file, old, new)
            return False
        return True

    assert watch(write, lambda: [file], until) == 0
    out, err = capsys.readouterr()
    assert len(written) == 3
    assert out.count("mine.html") == 3
    assert "parametres" in err
    assert "half of it" in written[-1]


def test_a_small_edit_is_written_with_little_work(file: Path) -> None:
    kept = KeptDerivations(False)
    for ending in ("html", "pdf"):
        writer(ending)(notes(kept.derivation(file)))
    edit(file, "mass of the ladder", "how heavy it is")
    with at_most():
        document = notes(kept.derivation(file))
        for ending in ("html", "pdf", "tex"):
            writer(ending)(document)


def test_notes_needs_a_name_or_all() -> None:
    run = CliRunner().invoke
    for arguments in (["notes"], ["notes", "--all", "paper"], ["notes", "--all", "--watch"]):
        result = run(main, arguments)
        assert result.exit_code == 2, arguments
        assert "Error: " in result.output


# --- the library


@cache
def chapters() -> tuple[Chapter, ...]:
    kept = KeptDerivations(False)
    topics = ("ladders", "pendulums", "")
    return tuple(Chapter(n, t, kept.derivation(find_problem(n))) for n, t in zip(NAMES, topics, strict=True))


def test_the_book_numbers_by_problem_and_each_reference_has_a_target() -> None:
    done = numbered(book(chapters()))
    numbers = [part.number for part in parts(done.sections) if isinstance(part, Display) and part.number]
    assert numbers[0] == "1.1"
    assert "2.1" in numbers and "3.1" in numbers
    assert len(set(numbers)) == len(numbers)
    tops = [section.title[0].text for section in done.sections if section.level == 0]
    assert tops == ["Ladders", "Pendulums", "Further problems", "Index"]


def test_the_index_names_what_occurs() -> None:
    done = numbered(book(chapters()))
    index = next(section for section in done.sections if section.label == "section.index")
    entries = {item[0].text: [i.mark for i in item if isinstance(i, Ref)] for item in index.blocks[-1].items}
    assert entries["rod"] == ["§\u202f1", "§\u202f2"]
    assert entries["loss of contact"] == ["§\u202f1"]
    assert entries["rolling without slipping"] == ["§\u202f3"]
    assert list(entries) == sorted(entries)


def test_every_problem_of_the_book_has_its_own_notation() -> None:
    sections = [section for section in book(chapters()).sections if section.notation]
    assert len({frozenset(section.notation.aliases.items()) for section in sections}) > 1


@pytest.mark.parametrize("ending", ["pdf", "tex", "docx", "md", "ipynb", "beamer", "html"])
def test_the_book_is_written_in_every_format(ending: str) -> None:
    content = writer(ending)(book(chapters()[:2]))
    assert len(content) > 10_000
    if ending == "tex":
        assert r"\tableofcontents" in content and r"\numberwithin{equation}{section}" in content


def test_the_site_leads_to_every_problem_and_back() -> None:
    cards = [problem_card(chapter, "en", "introductory") for chapter in chapters()]
    text = index_page([], cards, book="library.pdf")
    assert re.findall(r'<a href="([\w-]+)\.html"', text) == list(NAMES)
    assert text.count("<svg") == len(NAMES)
    assert "library.pdf" in text
    assert "<script" not in text and "http://www.w3.org" in text and not re.search(r'(?:src|href)="http', text)


def test_a_page_of_the_site_leads_to_the_problems_of_its_topic_and_to_its_neighbours() -> None:
    ladder, pendulum, ball = chapters()
    twins = [ladder, replace(pendulum, topic=ladder.topic), ball]
    text = page(notes(ladder.derivation), around(twins, 0, "en"))
    assert re.findall(r'href="([\w-]+)\.html"', text) == ["index", pendulum.name, pendulum.name]
    assert ">Ladders<" in text
    text = page(notes(ball.derivation), around(twins, 2, "en"))
    assert re.findall(r'href="([\w-]+)\.html"', text) == ["index", pendulum.name]


def test_the_site_has_the_index_of_what_occurs() -> None:
    text = index_page([], [problem_card(chapter, "en") for chapter in chapters()], found=occurring(chapters(), "en"))
    entries = dict(re.findall(r"<dt>([^<]*)</dt>\s*<dd>(.*?)</dd>", text, re.S))
    assert "sliding-ladder.html" in entries["loss of contact"]
    assert set(re.findall(r'href="#([\w-]+)"', text)) == set(re.findall(r'<section id="([\w-]+)"', text))


def test_the_printed_index_gives_pages() -> None:
    document = book(chapters()[:2])
    assert r"rod, \pageref{p1.part}, \pageref{p2.part}" in writer("tex")(document)
    assert 'rod, #page-of(label("p1.part"));, #page-of(label("p2.part"));' in writer("typ")(document)
    assert "rod, §\u202f1, §\u202f2" in writer("md")(document)


def test_a_problem_that_cannot_be_derived_is_told_and_left_out(tmp_path: Path, monkeypatch) -> None:
    from rbpsym.commands import arguments as shelves
    from rbpsym.commands import written

    bad = tmp_path / "bad.toml"
    bad.write_text('title = "x"\n', encoding="utf-8")
    entries = [shelves.entry("problem", "bad", bad), shelves.entry("problem", NAMES[0], find_problem(NAMES[0]))]
    monkeypatch.setattr(written, "shelf", lambda: iter(entries))
    arguments = ["notes", "--all", "--format", "html,md", "--no-simulation", "-o", str(tmp_path / "out")]
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == 1
    assert "bad is left out" in result.output
    assert {path.name for path in (tmp_path / "out").iterdir()} >= {"index.html", "sliding-ladder.html", "library.md"}


def test_errors_are_sentences() -> None:
    with pytest.raises(RbpsymError):
        KeptDerivations(False).derivation(Path("nowhere.toml"))
