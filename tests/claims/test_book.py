"""The page on a book that checks its formulas does what it says."""

import re

import pytest
from click.testing import CliRunner

from rbpsym.claims.papers.claims import OF_CLAIM, OF_SETTING
from rbpsym.cli import main
from tests.architecture.source import ROOT

PAGE = (ROOT / "docs" / "book.md").read_text(encoding="utf-8")
CHAPTER, COMMENTS = re.findall(r"```latex\n(.*?)```", PAGE, re.S)


@pytest.fixture
def chapter(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "chapter.tex"


def run(*names):
    return CliRunner().invoke(main, ["check", *names], standalone_mode=True)


def test_the_draft_names_the_problem(chapter):
    chapter.write_text(CHAPTER)
    found = run("--init", "chapter.tex")
    assert found.exit_code == 0 and "+% rbpsym: problem = sliding-ladder" in found.output
    assert found.output.count("+% rbpsym: claim") == 3


def test_the_comments_make_it_green_and_a_typo_red(chapter):
    chapter.write_text(COMMENTS + CHAPTER)
    found = run("chapter.tex")
    assert found.exit_code == 0 and "3 PROVED; all as expected" in found.output, found.output
    chapter.write_text((COMMENTS + CHAPTER).replace(r"\sin\theta_0 - \sin", r"\sin\theta_0 + \sin"))
    found = run("chapter.tex", "--fix", "repairs.patch")
    assert found.exit_code == 1 and "1 REFUTED; 1 NOT AS EXPECTED" in found.output
    assert r"\sin\theta_0 - \sin\theta" in (chapter.parent / "repairs.patch").read_text()


def test_every_word_of_a_comment_is_told():
    assert all(f"`{key} = " in PAGE or key in ("says", "not_computed") for key in (*OF_SETTING, *OF_CLAIM) if key != "theory")
