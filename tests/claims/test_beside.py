r"""Claims beside the formulas: a text that carries its claims in comments is checked alone, in every format."""

import json
import shutil
import subprocess

import pytest

from rbpsym.claims.papers.check import printed
from rbpsym.claims.papers.walk import read_paper
from rbpsym.cli import main
from rbpsym.errors import RbpsymError
from rbpsym.statement.library import problem_files

SAID = (r"problem = sliding-ladder", r"\vec V is the velocity of ladder.cm", r"\omega is the speed of theta")
RIGHT, WRONG = r"V^2 = \ell^2\omega^2", r"V^2 = \ell^2\omega^3"
TEX = "\n".join(f"% rbpsym: {line}" for line in SAID)
MD = "<!-- rbpsym: " + "\n".join(SAID) + " -->"
TYP = "\n".join(f"// rbpsym: {line}" for line in SAID)
RST = ".. rbpsym: " + "\n   ".join(SAID)
DISPLAY = r"\begin{equation}\label{a} %s \end{equation}"


def cells(*texts):
    """A notebook of Markdown cells."""
    made = [{"cell_type": "markdown", "source": text.splitlines(keepends=True)} for text in texts]
    return json.dumps({"cells": [*made, {"cell_type": "code", "source": ["x = '$a=b$'"]}]}, indent=1)


# the name of a file, its text with % for the formula, and the line of the formula
TEXTS = [
    ("a.tex", f"{TEX}\nLet \\[a=b\\] it slide. % rbpsym: claim a\n{DISPLAY}", 5),
    ("a.tex", f"\\documentclass{{book}}\n{TEX}\n% rbpsym: claim\n\\[ %s \\]", 6),
    ("a.md", f"{MD}\nIt costs $5 or $6, `$a=b$`, \\[see 5% here\\].\n<!-- rbpsym: claim -->\n\n$$\n%s\n$$\n", 7),
    ("a.md", f"{MD}\n$$ %s $$ <!-- rbpsym: claim -->\n", 4),
    ("a.md", f"{MD}\n```python\n$$a=b$$\n```\n<!-- rbpsym: claim a -->\n```{{math}}\n:label: a\n%s\n```\n", 8),
    ("a.md", f"{MD}\n:::{{note}}\n<!-- rbpsym: claim a -->\n$$ %s $$ (a)\n:::\n", 6),
    ("a.md", f"{MD}\n<!-- rbpsym: claim inline -->\nThen $x$ and $%s$.", 5),
    ("a.rst", f"{RST}\n\n.. code-block:: python\n\n   $a=b$\n\n.. rbpsym: claim\n\n.. math:: %s\n", 11),
    ("a.rst", f"{RST}\n\n.. math::\n   :label: a\n\n   %s\n\nText of $5.\n\n.. rbpsym: claim a\n", 5),
    ("a.rst", f"{RST}\n\n.. rbpsym: claim a\n\n.. math:: \n   :label: a\n\n   %s\n\n   c = d\n", 7),
    ("a.tex", f"{TEX}\n\\begin{{tabular}}{{cc}} $$ & $x$ \\\\ \\end{{tabular}}\n% rbpsym: claim a\n{DISPLAY}", 6),
    ("a.html", f"<html><!-- rbpsym: {chr(10).join(SAID)} -->\n<!-- rbpsym: claim -->\\[ %s \\]<script>$$a=b$$</script>", 4),
    ("a.html", f"{MD}\n<!-- rbpsym: claim -->\n<script type='math/tex; mode=display'>%s</script>", 5),
    ("a.typ", f"{TYP}\n#link(\"https://a.b\")[5] `$a=b$` \\$5\n// rbpsym: claim\n$ %s $", 6),
    ("a.typ", f"{TYP}\n= Head\n/* $a=b$ */ $ a &= b \\ c &= d $\n// rbpsym: claim a\n$ %s\n$ <a>", 7),
    ("a.typ", f"{TYP}\n// rbpsym: claim inline\nHere $x$ and $%s$.", 5),
    ("a.ipynb", cells(f"{MD}\n<!-- rbpsym: claim -->", "Then\n\n$$%s$$"), 0),
    ("a.tex", f"{TEX}\n\\[ a = b \\]\n\\begin{{gather*}}\nV = V \\\\\n% rbpsym: claim\n%s \\end{{gather*}} \\[ c = d \\]", 5),
    ("a.md", f"{MD}\n$$ a = b\n\nwhere $a$ is\n\n<!-- rbpsym: claim -->\n$$ %s $$\n", 9),
]  # fmt: skip


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path


def checked(folder, capsys, name, text, *more):
    """(exit code, results) of a text."""
    (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    code = main.main(["check", name, "--json", *more], standalone_mode=False)
    return code, json.loads(capsys.readouterr().out)["results"]


@pytest.mark.parametrize("case", range(len(TEXTS)), ids=lambda case: TEXTS[case][0])
def test_a_text_carries_its_claims(folder, capsys, case):
    name, text, line = TEXTS[case]
    typst = (lambda latex: latex.replace("\\", "").replace("ellomega", "ell omega")) if name.endswith("typ") else str
    escape = json.dumps if name.endswith("ipynb") else lambda latex: f'"{typst(latex)}"'
    code, [row] = checked(folder, capsys, name, text.replace("%s", escape(RIGHT)[1:-1]))
    assert (code, row["outcome"]) == (0, "PROVED") and row["line"] == (line or row["line"])
    code, [row] = checked(folder, capsys, name, text.replace("%s", escape(WRONG)[1:-1]))
    assert (code, row["outcome"]) == (1, "REFUTED") and "exponent" in row["diagnosis"]


def test_a_comment_in_front_of_a_display_claims_all_its_numbers(folder, capsys):
    display = "\\begin{align} V^2 &= \\ell^2\\omega^2 \\\\ a &= b %s \\end{align}"
    code, rows = checked(folder, capsys, "a.tex", f"{TEX}\n% rbpsym: claim\n{display % ''}")
    assert [row["outcome"] for row in rows] == ["PROVED", "COULD NOT BE READ"] and code == 2
    within = f"{TEX}\n\\begin{{align}}\na &= b \\\\ % nothing\n% rbpsym: claim\n{RIGHT} \\end{{align}}"
    code, rows = checked(folder, capsys, "a.tex", within)
    assert code == 0 and [row["number"] for row in rows] == ["2"]


INCLUDES = [
    ("a.md", f"{MD}\n```{{include}} part/b.md\n:x: y\n```\n"),
    ("a.md", f"{MD}\n```{{toctree}}\n---\nmaxdepth: 2\n---\nB <part/b>\n*\n```\n"),
    ("a.rst", f"{RST}\n\n.. include:: part/b.md\n"), ("a.rst", f"{RST}\n\n.. toctree::\n   :caption: C\n\n   part/b.md\n"),
    ("a.typ", f'{TYP}\n#include "part/b.md"\n'),
]  # fmt: skip


@pytest.mark.parametrize("case", range(len(INCLUDES)))
def test_files_that_a_text_puts_in_are_read_where_it_does(folder, capsys, case):
    (folder / "part").mkdir()
    (folder / "part" / "b.md").write_text(f"\n<!-- rbpsym: claim -->\n$${RIGHT}$$\n")
    code, [row] = checked(folder, capsys, *INCLUDES[case])
    assert (code, row["line"]) == (0, 3) and row["file"].endswith("b.md")


@pytest.mark.parametrize("name", ["../README.md", "nothing.md", "a.md"])
def test_what_a_page_does_not_find_is_told_and_loses_nothing(folder, capsys, name):
    (folder / "README.md").write_text("$$a=b$$")
    (folder / "in").mkdir()
    text = f"{MD}\n```{{include}} {name}\n```\n<!-- rbpsym: claim -->\n$${RIGHT}$$\n"
    (folder / "in" / "a.md").write_text(text)
    assert main.main(["check", "in/a.md"], standalone_mode=False) == 0
    assert "in/a.md:4: not read: " in capsys.readouterr().out


def test_a_notebook_carries_its_claims_in_metadata(folder, capsys):
    book = json.loads(cells("Then", f"$${RIGHT}$$"))
    book["metadata"] = {"rbpsym": list(SAID)}
    book["cells"][1]["metadata"] = {"rbpsym": "claim"}
    code, [row] = checked(folder, capsys, "a.ipynb", json.dumps(book, indent=1))
    assert (code, row["outcome"]) == (0, "PROVED") and row["line"] > 5


def test_a_display_that_is_never_closed_is_an_error_where_it_is_claimed(folder, capsys):
    text = f"{TEX}\n% rbpsym: claim\n\\[ {RIGHT}\n\n\\section{{B}}\n% rbpsym: claim\n\\[ {RIGHT} \\]"
    code, rows = checked(folder, capsys, "a.tex", text)
    assert code == 2 and [row["outcome"] for row in rows] == ["COULD NOT BE READ", "PROVED"]
    assert "never closed" in rows[0]["detail"] and "line 5" in rows[0]["detail"].replace("a.tex:5", "line 5")


def test_what_is_said_of_a_claim(folder, capsys):
    slip = f"{TEX}\n% rbpsym: claim\n\\[ {WRONG} \\]\n% rbpsym: expect = refuted\n% rbpsym: erratum = E1\n"
    code, [row] = checked(folder, capsys, "a.tex", f"{slip}% rbpsym: right = {RIGHT}\n")
    assert code == 0 and row["erratum"] == "E1" and row["right"] == "PROVED"
    given = f"{TEX}\n% rbpsym: claim\n\\[ \\ddot\\theta = 0 \\]\n% rbpsym: given = g = 0\n"
    assert checked(folder, capsys, "a.tex", given)[0] == 0


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("claim", "no problem is named"),
        ("problem = sliding-ladder\n% rbpsym: claim eq:none", "no formula has the label"),
        ("problem = sliding-ladder\n% rbpsym: claims", "says nothing here"),
        ("problem = sliding-ladder\n% rbpsym: claim\n\\[a=b\\]\n% rbpsym: expect = wrong", "can't be"),
        ("problem = sliding-ladder\n% rbpsym: claim\n\\[a=b\\]\n% rbpsym: right = a=c", "belongs to a claim"),
        ("problem = ../secret.toml", "outside the folder"),
        ("problem = link.toml", "outside the folder"),
        ("problem = none.toml", "no problem"),
        ("problem = sliding-lader", "sliding-ladder"),
    ],
)  # fmt: skip
def test_what_says_nothing_is_told_in_its_line(tmp_path, folder, capsys, said, told):
    (folder / "in").mkdir()
    (folder / "secret.toml").write_text("x = 1")
    (folder / "in" / "link.toml").symlink_to(folder / "secret.toml")
    with pytest.raises(RbpsymError, match=told) as caught:
        checked(folder, capsys, "in/a.tex", f"\n% rbpsym: {said}\n")
    assert caught.value.place.file.endswith("a.tex") and caught.value.exit_code == 2


def test_a_quantity_elsewhere_stays_inside_too(folder, capsys):
    (folder / "in").mkdir()
    (folder / "secret.toml").write_text("x = 1")
    said = f"{TEX}\n% rbpsym: a is the speed of theta in ../secret.toml\n% rbpsym: claim\n\\[ a=1 \\]"
    code, [row] = checked(folder, capsys, "in/a.tex", said)
    assert code == 2 and "outside" in row["detail"]


def test_only_what_is_claimed_is_judged_and_the_order_is_that_of_reading(folder, capsys):
    (folder / "part").mkdir()
    (folder / "part" / "B.tex").write_bytes("\n\n% schön\n\\[ a = b \\]\n% rbpsym: claim\n\\[ V=1 \\]".encode("latin-1"))
    whole = f"{TEX}\n\\import{{part/}}{{b}}\n% rbpsym: claim\n\\[ {RIGHT} \\]\n"
    code, rows = checked(folder, capsys, "a.tex", whole)
    assert [row["outcome"] for row in rows] == ["REFUTED", "PROVED"] and code == 1
    code, rows = checked(folder, capsys, "a.tex", whole, "--all")
    assert [row["outcome"] for row in rows] == ["NOT A FORMULA WE COMPUTE", "REFUTED", "PROVED"]
    main.main(["check", "a.tex", "--github"], standalone_mode=False)
    told = capsys.readouterr().out
    assert "read as Latin-1" in told and "in other letters" in told


def test_a_changed_display_stays_the_claim_that_it_is(folder, capsys):
    r"""In a claims file: no number and no label, but its line; one typo is one REFUTED."""
    said = "problem = 'sliding-ladder'\n[symbols]\n'V' = 'velocity of ladder.cm'\n"
    (folder / "c.toml").write_text(said + "[[claim]]\nid = 'v'\nline = 2\nlatex = 'V^2=4'")
    code, rows = checked(folder, capsys, "a.tex", "Text\n\\[ V=1 \\]\n", "--problems", "c.toml")
    assert code == 1 and [(row["id"], row["outcome"]) for row in rows] == [("v", "REFUTED")]


WRONG_TEXT = r"""% rbpsym: problem = sliding-ladder
% rbpsym: \w is the speed of theta
% rbpsym: claim
\begin{equation}\label{a} \ddot\theta = \frac{3 g}{4\ell}\cos\theta. \end{equation}
% rbpsym: claim
\[ \w^2 = \frac{3 g}{2\ell}(\cos\theta_0 - \sin\theta) \]
"""


def test_a_patch_repairs_what_is_wrong(folder, capsys):
    """The author's own symbols and spaces stay; the repaired text is green."""
    text = WRONG_TEXT.replace(r"\w", r"\omega")
    code, rows = checked(folder, capsys, "a.tex", text, "--fix", "a.patch")
    assert code == 1 and [row["outcome"] for row in rows] == ["REFUTED", "REFUTED"]
    patch = (folder / "a.patch").read_text()
    assert r"+\begin{equation}\label{a} \ddot\theta = -\frac{3 g}{4\ell}\cos\theta. \end{equation}" in patch
    plus = [line[1:] for line in patch.split("\n") if line.startswith("+") and not line.startswith("+++")]
    lines = text.split("\n")
    lines[3], lines[5] = plus
    assert checked(folder, capsys, "a.tex", "\n".join(lines))[0] == 0
    book = cells("<!-- rbpsym: problem = sliding-ladder\nclaim -->\n$$\\ddot\\theta = \\frac{3 g}{4\\ell}\\cos\\theta$$")
    checked(folder, capsys, "a.ipynb", book, "--fix", "a.patch")
    assert "-\\\\frac{3 g}{4\\\\ell}" in (folder / "a.patch").read_text()


OWN = r"""\newcommand{\w}{\omega} \newcommand{\half}[2][2]{\frac{#2 g}{#1\ell}}
% rbpsym: problem = sliding-ladder
% rbpsym: \omega is the speed of theta
% rbpsym: \alpha is the acceleration of theta
% rbpsym: claim a
\begin{align} \w^2 &= \half{3}(\sin\theta_0 % first
   + \sin\theta), \label{a} \\ x &= 1 \end{align}
% rbpsym: claim
\[ \w = \boxed{-\half[4]{3} \cos\theta} \]
"""


def test_a_patch_keeps_the_macros_comments_and_labels_of_the_author(folder, capsys):
    checked(folder, capsys, "a.tex", OWN, "--fix", "a.patch")
    plus = [line[1:] for line in (folder / "a.patch").read_text().split("\n") if line[:1] == "+" and line[:3] != "+++"]
    fixed = r"\[ \alpha = \boxed{-\half[4]{3} \cos\theta} \]"
    assert plus == [r"   - \sin\theta), \label{a} \\ x &= 1 \end{align}", fixed]


LADDER = r"""A ladder slides along a wall.
%s T = \frac{2}{3} M \ell^2 \omega^2 %s
Then
%s \alpha = -\frac{3 g}{4\ell}\cos\theta %s
and %s Q = q %s
"""


@pytest.mark.parametrize(("name", "marks"), [("a.tex", (r"\[", r"\]")), ("a.md", ("$$", "$$"))])
def test_a_first_draft_proves_what_it_says(folder, capsys, name, marks):
    r"""T, α and ω are no names of the problem; what is not proved stands behind a “?”, and says nothing."""
    (folder / name).write_text(LADDER % (marks * 3))
    assert main.main(["check", "--init", name], standalone_mode=False) == 0
    told = capsys.readouterr().out
    assert "rbpsym: problem = sliding-ladder" in told and "T is the kinetic energy" in told and "rbpsym? Q is" in told
    lines = [line[1:] for line in told.split("\n") if line[:1] in ("+", " ") and line[:3] != "+++"]
    code, rows = checked(folder, capsys, name, "\n".join(lines) + "\n")
    assert code == 0 and [row["outcome"] for row in rows] == ["PROVED", "PROVED"]


SECTIONS = r"""# A swinging rod
A uniform rod is hinged at its end.

$$ I_O = \frac13 M\ell^2 $$

$$ \dot\theta^2 = \frac{3g}{\ell}(\cos\theta-\cos\theta_0) \quad (1) $$

# A sliding ladder
It slides down a wall.

$$ K = \frac23 M\ell^2\dot\theta^2, \qquad U = Mg\ell\sin\theta $$

$$ \ddot\theta = -\frac{3g}{4\ell}\cos\theta $$
"""


def test_each_section_has_the_problem_that_it_is_about(folder, capsys):
    (folder / "a.md").write_text(SECTIONS)
    main.main(["check", "--init", "a.md"], standalone_mode=False)
    lines = [line[1:] for line in capsys.readouterr().out.split("\n") if line[:1] in ("+", " ") and line[:3] != "+++"]
    found = [line[21:-4] for line in lines if line.startswith("<!-- rbpsym: problem")]
    assert found == ["= rod-pendulum", "= sliding-ladder"]
    code, rows = checked(folder, capsys, "a.md", "\n".join(lines) + "\n")
    assert code == 0 and [row["outcome"] for row in rows] == ["PROVED"] * 4


def test_a_first_draft_tries_the_problems_beside_the_text(folder, capsys):
    """A shell in place of the ball."""
    shipped = problem_files()["ball-on-incline"].read_text()
    (folder / "mine.toml").write_text(shipped.replace('"ball"\nmass', '"shell"\nmass').replace("2*tan(beta)/7", "2*tan(beta)/5"))
    (folder / "a.md").write_text("$$ a = \\frac{3}{5} g\\sin\\beta $$\n\nand\n\n$$ K = \\frac{5}{6} M v^2 $$\n")
    main.main(["check", "--init", "a.md"], standalone_mode=False)
    told = capsys.readouterr().out
    assert "rbpsym: problem = mine" in told and told.count("rbpsym: claim") == 2


def test_a_draft_without_a_fit_is_all_guesses(folder, capsys):
    (folder / "a.tex").write_text("\\[ \\omega = Q q \\]")
    main.main(["check", "--init", "a.tex"], standalone_mode=False)
    told = capsys.readouterr().out
    assert "% rbpsym? problem = NAME" in told and "rbpsym:" not in told and "speed of C" in told


def test_what_was_decided_before_derives_nothing(folder, capsys, monkeypatch):
    text = f"{TEX}\n% rbpsym: claim\n\\[ {RIGHT} \\]"
    first = checked(folder, capsys, "a.tex", text)
    monkeypatch.setattr("rbpsym.claims.run.Worlds.problem", lambda *_: pytest.fail("a problem is derived"))
    code, found = checked(folder, capsys, "a.tex", text)
    assert (code, [one["outcome"] for one in found]) == (0, [one["outcome"] for one in first[1]])


SITE_TEXT = f"{MD}\n<!-- rbpsym: claim -->\n$$\n\\sq V = \\sq{{\\ell}}\\sq\\w\n$$\n"
SITES = [
    ("conf.py", "mathjax3_config = {'tex': {'macros': {'w': r'\\omega', 'sq': ['#1^2', 1]}}}"),
    ("_config.yml", 'sphinx:\n  config:\n    mathjax3_config:\n      tex:\n        macros:\n          w: "\\\\omega"\n'
                    '          sq: ["#1^2", 1]\n'),
    ("myst.yml", "project:\n  math:\n    '\\w': '\\omega'\n    '\\sq': '#1^2'\n"),
    ("conf.py", "math_defs_filename = '_static/defs.tex'"),
]  # fmt: skip


@pytest.mark.parametrize("below", ["", "ch/one"])
@pytest.mark.parametrize(("name", "said"), SITES)
def test_macros_of_a_site_are_those_of_its_texts(folder, capsys, name, said, below):
    (folder / "_static").mkdir()
    (folder / "_static" / "defs.tex").write_text("\\newcommand{\\w}{\\omega}\n\\newcommand{\\sq}[1]{#1^2}\n")
    (folder / name).write_text(said)
    (folder / below).mkdir(parents=True, exist_ok=True)
    code, (found,) = checked(folder, capsys, f"{below}/a.md".lstrip("/"), SITE_TEXT)
    assert (code, found["outcome"]) == (0, "PROVED")


def test_nothing_is_looked_for_above_the_folder_of_the_run(folder, capsys, monkeypatch):
    (folder / "conf.py").write_text(SITES[0][1])
    (folder / "inner").mkdir()
    monkeypatch.chdir(folder / "inner")
    assert checked(folder / "inner", capsys, "a.md", SITE_TEXT)[0] == 2


def test_a_chapter_has_the_macros_of_its_document(folder, capsys):
    (folder / "parts").mkdir()
    head = "\\documentclass{book}\n\\newcommand{\\w}{\\omega}\n\\newcommand{\\sq}[1]{#1^2}\n"
    (folder / "book.tex").write_text(f"{head}\\begin{{document}}\n\\include{{parts/one}}\n\\end{{document}}")
    (folder / "other.tex").write_text("\\documentclass{book}\n\\newcommand{\\w}{\\theta}\n\\input{parts/two}")
    text = f"{TEX}\n% rbpsym: claim\n\\[ \\sq V = \\sq{{\\ell}}\\sq\\w \\]"
    assert checked(folder, capsys, "parts/one.tex", text)[0] == 0


def test_what_typst_defines_and_imports_is_read(folder, capsys):
    (folder / "own").mkdir()
    (folder / "own" / "setup.typ").write_text("#let sq(body) = $body^2$\n#let om = $omega$\n$ 1 = 2 $\n")
    text = f'#import "own/setup.typ": *\n#let lsq(#NO) = 3\n#let half = $1/2$\n{TYP}\n// rbpsym: claim\n' \
           "$ half sq(V) = sq(ell) sq(om)/2 $"
    code, found = checked(folder, capsys, "a.typ", text)
    assert (code, [one["outcome"] for one in found]) == (0, ["PROVED"]), found


def test_a_symbol_may_be_what_the_text_does_not_define_and_is_written_as_its_format_wants(folder, capsys):
    said = "<!-- rbpsym: \\th is theta\nV\\_1 is the magnitude of velocity of ladder.cm\nclaim -->"
    code, found = checked(folder, capsys, "a.md", f"{MD}\n{said}\n$$ V\\_1^2\\sin \\th = \\ell^2\\omega^2\\sin\\theta $$")
    assert (code, [one["outcome"] for one in found]) == (0, ["PROVED"]), found


def test_macros_of_packages_beside_the_text_are_those_of_the_text(folder, capsys):
    (folder / "own.sty").write_text("\\RequirePackage{more} % \\newcommand{\\w}{x}\n\\newcommand{\\w}{\\omega}\n")
    (folder / "more.sty").write_text("\\newcommand{\\sq}[1]{#1^2}\n")
    text = f"\\usepackage[a]{{amsmath, own}}\n{TEX}\n% rbpsym: claim\n\\[ \\sq V = \\sq{{\\ell}}\\sq\\w \\]"
    assert checked(folder, capsys, "a.tex", text)[0] == 0


@pytest.mark.parametrize(
    ("wrong", "right"),
    [(r"V^2 = \ell^2\omgea^2", RIGHT), (r"V^2 = \el^2\omega^2", RIGHT), (r"V^2 = \ell^2v^2", RIGHT), (r"V^2 = \frac{}{1}", ""),
     (r"^2 = \ell^2\omega^2", rf"\vec {RIGHT}"), (r"V^2 = \ell^2\omega^22", RIGHT), ("\f\nV^2 = \\ell^2v^2", RIGHT)],
)
def test_a_name_that_is_unknown_or_lost_is_repaired(folder, capsys, wrong, right):
    code, [row] = checked(folder, capsys, "a.tex", f"{TEX}\n% rbpsym: claim\n\\[{wrong}\\]")
    assert code == 2 and row["outcome"] == "COULD NOT BE READ" and row["fix"].strip() == right


def test_a_repair_of_a_chain_leaves_no_link_false(folder, capsys):
    code, [row] = checked(folder, capsys, "a.tex", f"{TEX}\n% rbpsym: claim\n\\[V^2 = \\ell^3\\omega^2 = \\ell\\omega^2\\ell\\]")
    assert code == 1 and row["fix"] == r"V^2 = \ell^2\omega^2 = \ell\omega^2\ell"


@pytest.mark.parametrize(("numbers", "told"), [("1{,}5 a = 2{,}125", "."), ("1.5 a = 10,000", " "), ("a = 10,000", ",")])
def test_the_decimal_mark_is_that_of_the_whole_text(folder, numbers, told):
    (folder / "a.tex").write_text(rf"\[ {numbers} \] \[ b = 2{{,}}125 \] \[ c = 10,000 \]")
    paper = read_paper(folder / "a.tex")
    assert told in printed(paper.displayed[0], paper).latex and len(printed(paper.displayed[0], paper).latex) == len(numbers) + 2


@pytest.mark.parametrize(
    ("numbers", "read"),
    [("a = 1,5 b", "1.5"), ("a = 2(9,81)", "9.81"), ("a_{1,2} = b", "1,2"), ("A = (1,2)", "1,2"), (r"a = \cos(0,5)", "0.5")],
)
def test_a_text_that_says_so_has_a_decimal_comma(folder, numbers, read):
    (folder / "a.tex").write_text(rf"\usepackage{{icomma}} \[ {numbers} \]")
    paper = read_paper(folder / "a.tex")
    assert read in printed(paper.displayed[0], paper).latex


@pytest.mark.parametrize(("package", "read"), [("physics", r"\divergence"), ("amsmath", r"\div")])
def test_what_div_is_hangs_on_the_packages(folder, package, read):
    (folder / "a.tex").write_text(rf"\usepackage{{{package}}} \[ \rho \div{{v}} = 0 \]")
    paper = read_paper(folder / "a.tex")
    assert f"{read}{{v}}" in printed(paper.displayed[0], paper).latex.replace(" ", "")


CRATE = """
title = "A crate that is pulled"
[parameters]
m = "mass: mass"
mu = "number: friction"
T = "force: tension"
theta = "angle, acute: slope of the rope"
g = "acceleration: gravity"
[coordinates.x]
meaning = "place"
dimension = "length"
start = "0"
speed = "0"
[bodies.crate]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.W]
type = "gravity"
[interactions.C]
type = "force"
on = "crate.center"
force = ["T*cos(theta)", "T*sin(theta)"]
[constraints.N]
type = "contact"
point = "crate.center"
line = "y = 0"
coefficient = "mu"
friction = "f_N"
slip = "forward"
"""


def test_a_state_in_which_the_contact_would_pull_refutes_nothing(folder, capsys):
    (folder / "crate.toml").write_text(CRATE)
    said = "% rbpsym: problem = crate\n% rbpsym: f is the friction force\n% rbpsym: a is acceleration of x\n% rbpsym: claim\n"
    _, [row] = checked(folder, capsys, "a.tex", rf"{said}\[ T\cos\theta - f = ma \]")
    assert row["outcome"] != "REFUTED"
    _, [row] = checked(folder, capsys, "a.tex", rf"{said}\[ T\cos\theta + f = ma \]")
    assert row["outcome"] == "REFUTED"


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        (r"a = \frac{T\cos\theta - \mu N}{m g}", r"a = \frac{T\cos\theta - \mu N}{m}"),  # no factor above, too
        (r"K = \frac{m}{8}\ddot{y}^2", r"K = \frac{m}{8}\dot{y}^2"),
        (r"K = \frac{1}{2}v^2", r"K = \frac{1}{2} m v^2"),
        (r"- \mu N = ma", r"T \cos\theta - \mu N = ma"),
    ],
)
def test_a_repair_is_what_the_author_would_have_written(folder, capsys, wrong, right):
    (folder / "crate.toml").write_text(CRATE)
    meanings = ("a is acceleration of x", "y is 2*x", "K is the kinetic energy", "v is the speed of x")
    said = "".join(f"% rbpsym: {one}\n" for one in ("problem = crate", *meanings, "claim"))
    checked(folder, capsys, "a.tex", f"{said}\\begin{{equation}}\n  {wrong}\n\\end{{equation}}", "--fix", "a.patch")
    assert f"+{right}".replace(" ", "") in (folder / "a.patch").read_text().replace(" ", "").split("\n")


@pytest.mark.skipif(not shutil.which("git"), reason="git is not installed")
def test_git_takes_a_patch_of_a_text_without_a_last_line_end(folder, capsys):
    tex, md = f"\f{TEX}\n% rbpsym: claim\n\\[{WRONG}\\]\f% end", f"{MD}\n<!-- rbpsym: claim -->\n$${WRONG}$$"
    for name, text in (("a.tex", tex), ("b.md", md)):
        checked(folder, capsys, name, text, "--fix", "a.patch")
        subprocess.run(["git", "apply", "--unsafe-paths", "a.patch"], check=True, cwd=folder)
        assert (folder / name).read_text() == text.replace(WRONG, RIGHT)
