r"""Hostile texts: marks that never close lose one formula, not a file; the time grows with the text, not with its square."""

import random
import time

import pytest

from rbpsym.claims.papers.walk import read_paper
from rbpsym.errors import RbpsymError

SIZE, SECONDS = 20_000, 2  # of the processor; what is not linear takes many
MARKS = [
    "<!--", "-->", "$$ ", "$x ", "\n$", "$`", "\\[", "\\(", "\\\\[", "\\begin{align}", "\\begin {", "`", " `x",
    "```\n~~~\n", ":::{a}\n", "```a", "{math}`", " ", "\t>", "%", "rbpsym:", "\\begin{verbatim}", "\\begin{comment}",
    "\\verb1", "\\newcommand{\\a}{", "\\renewcommand\\theequation{", "\\documentclass[", "\\usepackage[a",
    "\\numberwithin[", "\\newcommand\\a ", "\\begin{alignat}[", "\\label{", "\\tag{", "{", "$\n\n", "<script ",
    "</pre ", "<script type=\"math/tex\">", "&lt;", ".. code", "code", ".. math::\n   \n", "#", "#include \"", "/*",
    "//", "\"", "$ ", "frac(", "^(", "(", "_a", "<a",
]  # fmt: skip


@pytest.mark.parametrize("ending", ["tex", "md", "html", "rst", "typ"])
def test_the_time_is_that_of_the_length(tmp_path, ending):
    path, chance = tmp_path / f"a.{ending}", random.Random(ending)
    mixed = ["".join(chance.choices(MARKS, k=4)) for _ in range(20)]
    for mark in (*MARKS, *mixed):
        whole = mark * (SIZE // len(mark))
        path.write_text(f"x{whole[: SIZE // 2]}" + "\n".join(whole[k : k + 199] for k in range(0, SIZE // 2, 199)))
        begun = time.process_time()
        try:
            read_paper(path)
        except RbpsymError:
            continue
        finally:
            assert time.process_time() - begun < SECONDS, (mark, ending)


OPEN = [r"\[ a = b", "$ a", r"\( a", "$$ a = b", r"\begin{align} a = b", r"\newcommand{\x}{ {", r"\def\y{"]


@pytest.mark.parametrize("opening", OPEN)
def test_what_is_never_closed_loses_nothing_else(tmp_path, opening):
    (tmp_path / "a.tex").write_text(f"One\n{opening}\n\nmore text\n\\section{{B}}\n\\[ c = d \\] and $e=f$ but\n$$ g=h\n%\n$$")
    found = read_paper(tmp_path / "a.tex")
    assert [formula.latex.strip() for formula in found.formulas][-3:] == ["c = d", "e=f", "g=h"]
    assert [line for _, line, said in found.remarks if "never closed" in said] == [2]
