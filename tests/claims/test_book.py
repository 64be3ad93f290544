"""The page on a book that checks its formulas does what it says."""

import json
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


DOME = """
title = "A small ball on a dome"
parameters = {m = "mass", R = "length", g = "acceleration", v_0 = "velocity, nonnegative"}
[coordinates.theta]
start = "0"
speed = "v_0/R"
range = ["0", "pi/2"]
[bodies.ball]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "R*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "ball.center"
circle = "O"
radius = "R"
"""
NOTES = r"""<!-- rbpsym: problem = dome
\mathbf{r} is the position of ball.center
\hat{e}_r is the unit vector along position of ball.center
\hat{e}_\theta is the minus unit vector across position of ball.center -->
<!-- rbpsym: claim inline -->
- $\mathbf{r} = R\hat{e}_r = R(\sin\theta\,\hat\imath + \cos\theta\,\hat\jmath)$
<!-- rbpsym: claim inline -->
- $\hat{e}_\theta = \cos\theta\,\hat\imath - \sin\theta\,\hat\jmath$
"""


def test_a_problem_beside_the_text_goes_by_its_name_and_a_unit_vector_wears_a_hat(chapter):
    (chapter.parent / "dome.toml").write_text(DOME)
    (chapter.parent / "notes.md").write_text(NOTES)
    found = run("notes.md")
    assert found.exit_code == 0 and "2 PROVED" in found.output, found.output
    (chapter.parent / "notes.md").write_text(NOTES.replace("- \\sin\\theta\\,\\hat\\jmath$", "+ \\sin\\theta\\,\\hat\\jmath$"))
    found = run("notes.md")
    assert found.exit_code == 1 and "1 REFUTED" in found.output and "\u20d7" not in found.output, found.output


def test_the_draft_of_a_notebook_keeps_its_form_and_sees_what_stands_alone(chapter):
    rows = [part.strip("\n") for part in re.findall(r"\n  (\S.*?)(?:,?\s*\\label\{eq:\w+\})", CHAPTER)]
    lines = ["# The sliding ladder\n", *(f"- ${row.replace('&', '').strip()}$\n" for row in rows)]
    cells = [{"cell_type": "markdown", "metadata": {}, "source": lines}]
    notebook = {"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}
    (chapter.parent / "ladder.ipynb").write_text(json.dumps(notebook, indent=1))
    found = run("--init", "ladder.ipynb")
    added = [line[1:].strip() for line in found.output.splitlines() if line.startswith("+ ")]
    said = [json.loads(line.removesuffix(",")) for line in added]
    assert said and all(line.startswith("<!-- rbpsym") and line.endswith(" -->\n") for line in said), found.output
    assert "<!-- rbpsym: claim inline -->\n" in said


def test_the_draft_says_nothing_in_dimensions_that_do_not_fit(chapter):
    """α was an acceleration that is nothing and t a mass, so that ω = ω_0 + αt was proved of a rod that is caught."""
    text = r"a rod that is caught $$\omega = \omega_0 + \alpha t$$ and $$\omega^2 = \omega_0^2 + 2\alpha(\theta - \theta_0)$$"
    chapter.with_suffix(".md").write_text(text.replace(" $$", "\n\n$$").replace("$$ ", "$$\n\n"))
    found = run("--init", "chapter.md")
    assert found.exit_code == 0 and "rbpsym? " in found.output and "rbpsym: claim" not in found.output, found.output
