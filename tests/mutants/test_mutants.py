"""Mutants of the shipped claims are refuted on their motion, rewrites proved (`make mutants` runs many more)."""

from collections import Counter
from functools import cache

import pytest

from rbpsym.statement.library import library_folder
from tests.claims.witnesses import off_the_motion, refutations_on_motions
from tests.mutants.run import run, trials

pytestmark = pytest.mark.heavy

FILES = sorted((library_folder() / "claims").glob("*.toml"))


by_file = pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)


@cache
def tried(path):
    """The trials of a file, and the refutations among them whose witness has to lie on the motion."""
    with refutations_on_motions() as refuted:
        return list(trials(path, 6)), refuted


@by_file
def test_mutants_are_refuted_and_rewrites_proved(path):
    found, _ = tried(path)
    wrong = [(trial.claim, str(trial.relation), str(trial.found)) for trial in found if not trial.is_passed]
    assert not wrong
    assert min(Counter((trial.claim, trial.wanted) for trial in found).values()) == 6


@by_file
def test_no_witness_lies_off_the_motion(path):
    _, refuted = tried(path)
    assert not [(str(w), why, r) for w, motion, r in refuted if (why := off_the_motion(w, motion))]


def test_the_last_line_has_the_figures(capsys, tmp_path):
    text = """
[settings.rod]
problem = "sliding-ladder"
symbols = { '\\ell' = "ell", 'M' = "M", 'I' = "moment of inertia of ladder" }
[[claim]]
id = "moment"
latex = '''I=\\frac{M\\ell^2}{3}'''
"""
    path = tmp_path / "rod.toml"
    path.write_text(text)
    assert run([path], wanted=5)
    assert "5/5 mutants refuted (100 %), 5/5 rewrites proved (100 %)" in capsys.readouterr().out.splitlines()[-1]
