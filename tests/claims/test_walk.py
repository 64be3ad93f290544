r"""A LaTeX text is walked: environments, numbers, labels, macros, files put in; and hostile ones refused."""


import pytest

from rbpsym.claims.papers.check import printed
from rbpsym.claims.papers.macros import definitions, expanded
from rbpsym.claims.papers.walk import read_paper
from rbpsym.errors import RbpsymError
from tests.effort import at_most

TEXT = r"""\documentclass{article} % \begin{equation} in a comment
\newcommand{\half}[1]{\frac{#1}{2}}
\newcommand\vv{\vec v}
\def\kin#1#2{\half{#1} #2^2}
\newcommand{\force}[1][F]{\vec #1}
\DeclareMathOperator{\sgn}{sgn}
\begin{document}
Inline $E = \kin{m}{v}$ costs \$5, and \(a<b\); no relation in $x$.
\begin{equation}\label{one} a=b \end{equation}
\begin{equation*} c=d \end{equation*}
\[ e=f \]
$$ g=h $$
\begin{align}
 i &= j \label{two} \\
 k &= l \nonumber \\
   &= m \label{three}
\end{align}
\begin{eqnarray} n&=&o\nonumber\\ &=&p \end{eqnarray}
\begin{gather} q=r \tag{A} \\ s=t \end{gather}
\begin{multline} u \\ =v \end{multline}
\begin{equation}\begin{split} w&=x\\&=y \end{split}\label{split}\end{equation}
\begin{subequations}\label{group}
\begin{equation} z=a \end{equation}
\begin{equation} z=b \end{equation}
\end{subequations}
\begin{equation} z=c \end{equation}\label{behind}
\begin{verbatim} \begin{equation} no=no \end{equation} \end{verbatim}
\begin{equation}\label{one} z=d \end{equation}
\end{document}
"""
NUMBERS = ["1", "", "", "", "2", "3", "4", "A", "5", "6", "7", "8a", "8b", "9", "10"]


@pytest.fixture
def paper(tmp_path):
    path = tmp_path / "text.tex"
    path.write_text(TEXT)
    return read_paper(path)


def test_displayed_formulas_have_the_numbers_that_latex_gives(paper):
    assert [formula.number for formula in paper.displayed] == NUMBERS


E = r"\begin{equation}a=b\end{equation}"


def test_a_numbered_row_that_goes_on_has_what_it_goes_on_from(tmp_path):
    path = tmp_path / "text.tex"
    path.write_text("\\begin{align}\na&=b\\label{x}\\\\\n&=c\\\\ d&=e\n\\end{align}")
    rows = [("".join(f.latex.split()), f.number, f.line) for f in read_paper(path).displayed]
    assert [row[0] for row in rows] == [r"a&=b\\", r"a&=b\\&=c\\", "d&=e"]
    assert [row[1] for row in rows] == ["1", "2", "3"]


def test_a_sum_that_goes_on_in_another_numbered_row_is_one_formula(tmp_path):
    path = tmp_path / "text.tex"
    path.write_text("\\begin{align}\na&=b\\\\\n&+c\\label{x}\\\\\n&=d\\\\ -e&=f\n\\end{align}")
    rows = [("".join(f.latex.split()), f.number, f.labels) for f in read_paper(path).displayed]
    whole = r"a&=b\\&+c\\"
    assert rows == [(whole, "1", ()), (whole, "2", ("x",)), (rf"{whole}&=d\\", "3", ()), ("-e&=f", "4", ())]


NUMBERED = {  # text -> numbers
    rf"{E}\setcounter{{equation}}{{7}}{E}\addtocounter{{equation}}{{-2}}{E}": ["1", "8", "7"],
    rf"\numberwithin{{equation}}{{section}}\section{{A}}{E}{E}\section*{{B}}{E}\section{{C}}{E}": [
        "1.1",
        "1.2",
        "1.3",
        "2.1",
    ],
    rf"\counterwithin{{equation}}{{subsection}}\section{{A}}\subsection{{B}}{E}\subsection{{C}}{E}": ["1.1.1", "1.2.1"],
    rf"\documentclass{{book}}\chapter{{A}}{E}\section{{B}}{E}\chapter{{C}}{E}": ["1.1", "1.2", "2.1"],
    rf"\section{{A}}{E}\renewcommand{{\theequation}}{{\thesection-\arabic{{equation}}}}{E}": ["1", "1-2"],
    rf"{E}\appendix\section{{A}}\setcounter{{equation}}{{0}}\renewcommand{{\theequation}}{{A\arabic{{equation}}}}{E}{E}": [
        "1",
        "A1",
        "A2",
    ],
    rf"\numberwithin{{equation}}{{section}}\section{{A}}{E}\appendix\section{{B}}{E}": ["1.1", "A.1"],
    rf"{E}\begin{{subequations}}{E}{E}\end{{subequations}}{E}": ["1", "2a", "2b", "3"],
    rf"\numberwithin{{equation}}{{section}}\section{{A}}\begin{{subequations}}{E}{E}\end{{subequations}}{E}": [
        "1.1a",
        "1.1b",
        "1.2",
    ],
    r"\begin{subequations}\begin{align}a&=b\\c&=d\end{align}\end{subequations}": ["1a", "1b"],
    r"\begin{align}a&=b\tag{*}\\c&=d\\e&=f\notag\end{align}": ["*", "1"],
    r"\begin{alignat}{2}a&=b&\quad c&=d\\e&=f\end{alignat}\begin{flalign*}a&=b\end{flalign*}": ["1", "2", ""],
    r"\begin{multline}a\\=b\\+c\end{multline}\begin{gather*}a=b\\c=d\end{gather*}": ["1", ""],
    r"\begin{equation}\begin{aligned}a&=b\\c&=d\end{aligned}\end{equation}\begin{displaymath}a=b\end{displaymath}": [
        "1",
        "",
    ],
    rf"\stepcounter{{equation}}{E}\begin{{equation}}a=b\tag*{{(x)}}\end{{equation}}": ["2", "(x)"],
}


@pytest.mark.parametrize("text", NUMBERED)
def test_numbers_are_those_of_latex(tmp_path, text):
    path = tmp_path / "text.tex"
    path.write_text(text)
    assert [formula.number for formula in read_paper(path).displayed] == NUMBERED[text]


def test_labels_and_lines(paper):
    labelled = {label: (formula.number, formula.line) for formula in paper.displayed for label in formula.labels}
    assert labelled["one"] == ("10", 28) and labelled["two"] == ("2", 13) and labelled["three"] == ("3", 14)
    assert [formula.line for formula in paper.formulas if not formula.displayed] == [8, 8, 8]


def test_rows_with_numbers_of_their_own_are_formulas_of_their_own(paper):
    rows = [formula.latex.split() for formula in paper.displayed if formula.number in ("2", "3", "4")]
    assert ["&=" in row or "=" in "".join(row) for row in rows] == [True] * 3
    assert "k" in rows[1] and "m" in rows[1]


def test_labels_that_are_wrong_are_remarked(paper):
    told = [remark for _, _, remark in paper.remarks]
    assert any("“behind” stands behind its equation" in remark for remark in told)
    assert any("“one” is defined a second time (first in line 9)" in remark for remark in told)


def test_macros_are_put_in(paper):
    first = paper.formulas[0]
    assert "".join(printed(first, paper).latex.split()) == r"E=\frac{m}{2}v^2"


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"\half{x}", r"\frac{x}{2}"),
        (r"\half x", r"\frac{x}{2}"),
        (r"\vv x", r"\vec v  x"),
        (r"\force", r"\vec F"),
        (r"\force[N]", r"\vec N"),
        (r"\kin{\half{a}}b", r"\frac{\frac{a}{2}}{2} b^2"),
        (r"\sgn x", r"\operatorname{sgn} x"),
        (r"\halfway", r"\halfway"),
    ],
)
def test_arguments_of_macros(paper, latex, wanted):
    assert "".join(expanded(latex, paper.macros).split()) == "".join(wanted.split())


def test_input_beside_the_text(tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "a.tex").write_text("\n$$ x=1 $$\n")
    (tmp_path / "main.tex").write_text(
        "\\begin{equation}a=b\\end{equation}\n\\input{parts/a}\n$$ y=2 $$ % \\input{no}\n"
    )
    found = read_paper(tmp_path / "main.tex").displayed
    assert [(formula.latex.strip(), formula.file.split("/")[-1], formula.line) for formula in found] == [
        ("a=b", "main.tex", 1),
        ("x=1", "a.tex", 2),
        ("y=2", "main.tex", 3),
    ]


HOSTILE = {
    "long line": ("x" * 300_000, "a line of more than"),
    "not UTF-8": (b"\xff\xfe\x00", "not UTF-8"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_texts_get_a_sentence_quickly(tmp_path, name):
    text, words = HOSTILE[name]
    path = tmp_path / "main.tex"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with at_most(), pytest.raises(RbpsymError) as caught:
        read_paper(path)
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\input{/etc/passwd}", "outside the folder"),
        (r"\input{../secret}", "outside the folder"),
        (r"\input{link}", "outside the folder"),
        (r"\input{main}", "inputs itself"),
        (r"\input{nothing}", "no file “nothing”"),
        ("\\input{a\0b}", "no name of a file"),
    ],
)
def test_what_can_not_be_put_in_is_told_and_the_rest_is_read(tmp_path, text, words):
    folder = tmp_path / "paper"
    folder.mkdir()
    (tmp_path / "secret.tex").write_text("$secret = 1$")
    (folder / "link.tex").symlink_to(tmp_path / "secret.tex")
    (folder / "main.tex").write_text(f"{text}\n\\[ a = b \\]")
    with at_most():
        paper = read_paper(folder / "main.tex")
    assert [one.latex.strip() for one in paper.formulas] == ["a = b"]
    assert any(words in said for _, _, said in paper.text.remarks)


@pytest.mark.parametrize(
    "text",
    [
        r"\newcommand{\x}{\x\x}",
        r"\def\x{\y\y}\def\y{\x\x}",
        r"\newcommand{\x}[1]{\x{#1#1}}",
        "".join(rf"\def\{chr(97 + k)}{{\{chr(98 + k)}\{chr(98 + k)}}}" for k in range(25)) + r"\def\x{\a}",
    ],
)
def test_macros_that_never_end_are_refused_quickly(text):
    macros, *_ = definitions(text)
    with at_most(), pytest.raises(RbpsymError):
        expanded(r"\x{a}", macros)


def test_what_a_macro_brings_is_dropped_too():
    macros, *_ = definitions(r"\newcommand{\w}{\ensuremath{\omega}}")
    assert "".join(expanded(r"\w = 1", macros).split()) == r"{\omega}=1"
