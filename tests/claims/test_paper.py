"""A whole text walked with its claims: the 41 displayed equations, and what happens when one of them changes."""

from dataclasses import replace

import pytest

from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome
from rbpsym.claims.run import Certificates, check_paper
from rbpsym.statement.library import library_folder
from tests.expr.paper import equations

FILE = load_claims(library_folder() / "claims" / "paper.toml")
NUMBERED = replace(FILE, claims=tuple(claim for claim in FILE.claims if claim.number))
LABELS = {claim.number: claim.label for claim in NUMBERED.claims}


def written(tmp_path, **changes):
    """A text with all equations, some with `changes` (old, new) by number."""
    parts = [r"\documentclass{article}\newcommand{\unused}{\unused}\begin{document}"]
    for number, latex in equations().items():
        latex = latex.replace(*changes.get(f"eq{number}", ("", "")))
        environment = "eqnarray" if "&=&" in latex else "equation"
        label = rf"\label{{{LABELS[str(number)]}}}" if LABELS[str(number)] else ""
        parts.append(f"\\begin{{{environment}}}{label}\n{latex.strip()}\n\\end{{{environment}}}")
    path = tmp_path / "text.tex"
    path.write_text("\n".join([*parts, r"\end{document}"]))
    return path


def results(path):
    return {result.number: result for result in check_paper(path, [NUMBERED], Certificates(None))[0]}


def test_all_displayed_equations_are_proved_in_order(tmp_path):
    found = results(written(tmp_path))
    assert list(found) == [str(number) for number in range(1, 42)]
    assert all(result.outcome is Outcome.PROVED and result.expected for result in found.values())


@pytest.mark.parametrize(
    ("number", "change", "diagnosis"),
    [
        (12, ("=-", "="), "sign"),
        (16, ("{3}", "{12}"), "3 in place of 12"),
        (34, (r"\cos", r"\sin"), "cos in place of sin"),
        (27, (r"m\,\ell^2", r"M\,\ell^2"), "m in place of M"),
        (7, (r"I_{O'}\vec{\omega}", r"I_{cm}\vec{\omega}"), ""),
    ],
)
def test_an_equation_that_changes_turns_red(tmp_path, number, change, diagnosis):
    found = results(written(tmp_path, **{f"eq{number}": change}))
    wrong = [result for result in found.values() if not result.expected]
    assert [result.number for result in wrong] == [str(number)]
    assert wrong[0].outcome is Outcome.REFUTED and diagnosis in wrong[0].diagnosis


def test_an_equation_that_is_gone_is_missed(tmp_path):
    path = written(tmp_path)
    text = path.read_text()
    begin = text.index(r"\begin{equation}\label{ej2f}")
    end = text.index(r"\end{equation}", begin) + len(r"\end{equation}")
    path.write_text(text[:begin] + text[end:])
    found = check_paper(path, [NUMBERED], Certificates(None))[0]
    [missed] = [result for result in found if result.outcome is not Outcome.PROVED]
    assert missed.id == "eq-34" and missed.outcome is Outcome.UNREAD and "was not found in the text" in missed.detail
