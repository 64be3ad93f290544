"""Green means checked: what is not decided fails unless that is expected; with --all, formulas without a claim have a scope."""

import json

import pytest

from rbpsym.cli import main
from rbpsym.errors import RbpsymError

LADDER = """problem = "sliding-ladder"
[symbols]
'V' = "velocity of ladder.cm"
"""
OWN = """
[[claim]]
id = "a"
latex = '''\\alpha = 2 M'''
expect = "refuted"
symbols = {'\\alpha' = "moment of inertia of ladder"}
"""
ENERGY = r"\begin{equation}\label{e} E=\frac12 M V^2+\frac12 I_{cm}\dot\theta^2 \end{equation}" + "\n"
TRUE = r"\begin{equation} V^2=\ell^2\dot\theta^2 \end{equation}" + "\n"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path


def checked(folder, capsys, texts, claims, *more):
    """(exit code, results by label or number) of a main text with its claims files."""
    for name, text in texts.items():
        (folder / name).write_text(text)
    names = []
    for place, text in enumerate(claims):
        (folder / f"claims{place}.toml").write_text(text)
        names += ["--problems", f"claims{place}.toml"]
    code = main.main(["check", next(iter(texts)), *names, "--all", "--json", *more], standalone_mode=False)
    rows = json.loads(capsys.readouterr().out)["results"]
    return code, {row["label"] or row["number"] or row["id"]: row for row in rows}


def test_an_unbound_symbol_is_not_passed_and_named(folder, capsys):
    code, rows = checked(folder, capsys, {"a.tex": ENERGY + TRUE}, [LADDER], "--failures")
    assert code == 1 and list(rows) == ["e"]
    assert "'E' = " in rows["e"]["detail"]
    code, rows = checked(folder, capsys, {"a.tex": ENERGY + TRUE}, [LADDER + "'E' = \"energy\"\n"])
    assert code == 1 and "'I_{cm}' = " in rows["e"]["detail"] and rows["2"]["outcome"] == "PROVED"


def test_it_may_be_expected(folder, capsys):
    claims = (
        'unclaimed = "not computed"\n'
        + LADDER
        + OWN.replace("\\alpha = 2 M", "V^2=\\ell^2\\dot\\theta^2").replace("refuted", "proved")
    )
    code, rows = checked(folder, capsys, {"a.tex": ENERGY + TRUE}, [claims])
    assert code == 0 and rows["e"]["expected"]
    claimed = LADDER + OWN.replace("\\alpha = 2 M", "E=1").replace("refuted", "not computed").replace(
        'id = "a"', 'id = "a"\nlabel = "e"\nnot_computed = "E is defined elsewhere"'
    )
    code, rows = checked(folder, capsys, {"a.tex": ENERGY + TRUE}, [claimed])
    assert code == 0 and rows["e"]["outcome"] == "NOT A FORMULA WE COMPUTE"


@pytest.mark.parametrize(
    "text", ["Only $a=b$ in a sentence.", r"\begin{equation} \theta \end{equation}", "No formula."]
)
def test_nothing_decided_is_no_success(folder, capsys, text):
    assert checked(folder, capsys, {"a.tex": text}, [LADDER])[0] == 1
    (folder / "claims0.toml").write_text(LADDER)
    main.main(["check", "a.tex", "--problems", "claims0.toml"], standalone_mode=False)
    assert "nothing was decided" in capsys.readouterr().out


def test_settings_without_claims_are_no_problem_file(folder, capsys):
    several = (
        f"[settings.a]\n{LADDER.replace('[symbols]', '[settings.a.symbols]')}[settings.b]\nproblem = 'rod-pendulum'\n"
    )
    code, rows = checked(folder, capsys, {"a.tex": TRUE}, [several])
    assert code == 1 and "several settings" in rows["1"]["detail"]
    with pytest.raises(RbpsymError, match="without claims"):
        main.main(["check", "claims0.toml"], standalone_mode=False)


def test_a_problem_that_cannot_be_read_is_an_error_of_the_run(folder, capsys):
    with pytest.raises(RbpsymError):
        checked(folder, capsys, {"a.tex": TRUE}, ["title = 1\n"])


def test_a_formula_nobody_claimed_never_has_the_symbols_of_another_claim(folder, capsys):
    """Z means I_cm for one claim only."""
    texts = {"a.tex": "\\begin{equation}Z = 2 M\\end{equation}\n\\begin{equation}\\label{n}Z = M\\ell^2\\end{equation}"}
    code, rows = checked(folder, capsys, texts, [LADDER + OWN.replace("\\alpha", "Z")])
    assert rows["1"]["outcome"] == "REFUTED" and rows["1"]["expected"]
    assert rows["n"]["outcome"] == "NOT A FORMULA WE COMPUTE" and "'Z' = " in rows["n"]["detail"] and code == 1


def test_a_chapter_put_in_has_its_own_symbols(folder, capsys):
    texts = {"a.tex": f"{TRUE}\\input{{b}}", "b.tex": "\n\\begin{equation}\\label{b} V = 2 M \\end{equation}"}
    other = "text = 'b.tex'\nproblem = 'rod-pendulum'\n[symbols]\n'V' = 'minus M'\n"
    code, rows = checked(folder, capsys, texts, ["text = 'a.tex'\n" + LADDER, other])
    assert rows["1"]["outcome"] == "PROVED" and rows["b"]["outcome"] == "REFUTED"
    assert "-M" in rows["b"]["diagnosis"] + rows["b"]["links"][0]["detail"] or code == 1
    unnamed = [one.replace("text = ", "source = ") for one in ("text = 'a.tex'\n" + LADDER, other)]
    code, rows = checked(folder, capsys, texts, unnamed)
    assert code == 1 and all("several files" in row["detail"] for row in rows.values())
