"""`rbpsym check`: what it prints and writes, its exit codes, its memory."""

import json
from dataclasses import replace
from xml.etree import ElementTree

import click
import pytest

from rbpsym.claims.run import NAME
from rbpsym.cli import main
from rbpsym.commands.check import doubtful, verdicts
from rbpsym.decide.verdict import PROVED, UNDECIDED, Verdict
from rbpsym.errors import RbpsymError
from rbpsym.proof.step import Certificate
from tests.library.derived import unsimulated

CLAIMS = r"""
[settings.ladder]
problem = "sliding-ladder"
[settings.ladder.symbols]
'\theta' = "theta"
'\alpha' = "acceleration of theta"
'g'      = "g"
'\ell'   = "ell"

[[claim]]
id      = "acceleration"
label   = "eom"
setting = "ladder"
latex   = '''\alpha=-\frac{3g}{4\ell}\cos\theta'''

[[claim]]
id      = "words"
setting = "ladder"
expect  = "not computed"
not_computed = "an opinion"
"""
TEXT = r"""\begin{equation}\label{eom}
\alpha=-\frac{3g}{4\ell}\cos\theta
\end{equation}
"""


SPANISH = r"""\newcommand{\vel}{\omega}
\begin{equation} \vel^2 = \frac{3g}{2\ell}(\sen\theta_0 - \operatorname{sen}\theta) \end{equation}
\begin{equation} N_f = \frac{M g}{4} (1 + 9{,}0\sen^2\theta - 6\,{\rm sen}\,\theta\,\mathrm{sen}\,\theta_0) \end{equation}
\begin{equation} \operatorname{tg}\theta = \frac{\sen\theta}{\cos\theta} \end{equation}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "claims.toml").write_text(CLAIMS)
    (tmp_path / "wrong.toml").write_text(CLAIMS.replace("3g}{4", "3g}{2"))
    (tmp_path / "unread.toml").write_text(CLAIMS.replace(r"\cos\theta", r"\cos\phi"))
    (tmp_path / "text.tex").write_text(TEXT)
    (tmp_path / "slip.tex").write_text(TEXT.replace("-", ""))
    (tmp_path / "papel.tex").write_text(SPANISH)
    return tmp_path


def run(*names):
    return main.main(["check", *names], standalone_mode=False)


@pytest.mark.parametrize(
    ("names", "code"),
    [
        (["claims.toml"], 0),
        (["wrong.toml"], 1),
        (["unread.toml"], 2),
        (["text.tex", "--problems", "claims.toml"], 0),
        (["slip.tex", "--problems", "claims.toml"], 1),
        (["claims.toml", "wrong.toml", "--failures"], 1),
        (["text.tex", "--problems", "sliding-ladder"], 0),
        (["slip.tex", "--problems", "sliding-ladder"], 1),
        (["papel.tex", "--problems", "sliding-ladder"], 0),
    ],
)
def test_exit_codes(folder, names, code, capsys):
    assert run(*names) == code
    assert ("NOT AS EXPECTED" in capsys.readouterr().out) is (code > 0)


@pytest.mark.parametrize("names", [["nothing.toml"], ["nothing.tex", "--problems", "claims.toml"]])
def test_what_is_not_there_is_said(folder, names):
    with pytest.raises(RbpsymError) as caught:
        run(*names)
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    "names", [["text.tex"], ["claims.toml", "--problems", "claims.toml"], ["claims.toml", "--only", "x"]]
)
def test_arguments_that_do_not_fit_are_said(folder, names):
    with pytest.raises(click.UsageError):
        run(*names)


def test_the_table_names_the_slip(folder, capsys):
    run("slip.tex", "--problems", "claims.toml")
    told = " ".join(capsys.readouterr().out.split())
    assert "eom" in told and "near miss: sign" in told and "left = " in told


def test_json_for_programs(folder, capsys):
    run("slip.tex", "--problems", "claims.toml", "--json")
    found = json.loads(capsys.readouterr().out)
    assert found["summary"]["REFUTED"] == 1 and found["summary"]["unexpected"] == 1
    [result] = [row for row in found["results"] if row["id"] == "acceleration"]
    assert (result["line"], result["outcome"], result["expected"]) == (1, "REFUTED", False)
    assert result["links"][0]["detail"].startswith("at ")


def test_junit_report(folder):
    run("slip.tex", "--problems", "claims.toml", "--junit", "report.xml")
    suite = ElementTree.parse(folder / "report.xml").getroot()
    assert (suite.get("tests"), suite.get("failures"), suite.get("skipped")) == ("2", "1", "1")
    assert suite.find(".//failure").get("message").startswith("REFUTED")


def test_annotations_for_github(folder, capsys):
    run("slip.tex", "--problems", "claims.toml", "--github")
    line = capsys.readouterr().out.splitlines()[-1]
    assert line.startswith("::error file=slip.tex,line=1,title=(1) REFUTED::at ") and "%0A" in line


def test_a_claims_file_alone_is_annotated_at_the_claim(folder, capsys):
    run("wrong.toml", "--github")
    assert "::error file=wrong.toml,line=11," in capsys.readouterr().out


def test_page_for_people(folder):
    run("slip.tex", "--problems", "claims.toml", "--html", "report.html")
    page = (folder / "report.html").read_text()
    assert 'id="acceleration"' in page and "unexpected" in page and "near miss" in page
    assert r"\alpha=\frac{3g}{4\ell}\cos\theta" in page and "<script" not in page


def test_certificates_are_used_again_and_only_for_the_same_content(folder, capsys, monkeypatch):
    run("claims.toml")
    first = capsys.readouterr().out
    assert (folder / "cache" / "rbpsym" / NAME).is_file()
    monkeypatch.setattr("rbpsym.claims.check.decide", lambda *_, **__: pytest.fail("decided again"))
    run("claims.toml")
    assert capsys.readouterr().out == first
    with pytest.raises(pytest.fail.Exception):
        run("wrong.toml")


def test_a_broken_or_unwritable_cache_is_no_error(folder):
    store = folder / "cache" / "rbpsym" / NAME
    store.parent.mkdir(parents=True)
    store.write_text("{broken")
    assert run("claims.toml") == 0
    (folder / "file").write_text("")
    assert run("claims.toml", "--cache", str(folder / "file" / "inside")) == 0


def test_a_problem_is_derived(folder, capsys):
    assert run("sliding-ladder") == 0
    assert "derivation: sliding-ladder" in " ".join(capsys.readouterr().out.split())


def test_formulas_of_the_page_are_drawn_and_nothing_of_the_text_is_markup(folder):
    text = CLAIMS.replace(r"\alpha=", r"\alpha\text{<b>}=").replace("an opinion", "<script>alert(1)</script>")
    (folder / "marked.toml").write_text(text)
    run("marked.toml", "--html", "report.html")
    page = (folder / "report.html").read_text()
    assert "<math " in page and "<script>" not in page and "<b>" not in page


@pytest.mark.parametrize("place", ["begins", "steps", "lagrange"])
def test_a_doubt_in_a_later_phase_is_a_doubt(place):
    """A derivation is PROVED where all of its phases are."""
    made = unsimulated("ball-slipping-to-rolling")
    assert {verdict.kind for verdict in verdicts(made)} == {PROVED} and not list(doubtful(made))
    doubt = Verdict(UNDECIDED, reason="not known")
    [phase] = made.phases
    if place == "lagrange":
        phase = replace(phase, derivation=replace(phase.derivation, lagrange=doubt))
    else:
        home = phase if place == "begins" else phase.derivation
        first, *others = getattr(home, place)
        home = replace(home, **{place: (replace(first, certificate=Certificate((), doubt)), *others)})
        phase = home if place == "begins" else replace(phase, derivation=home)
    spoilt = replace(made, phases=(phase,))
    assert doubt in verdicts(spoilt)
    assert len(list(doubtful(spoilt))) == (place != "lagrange")
