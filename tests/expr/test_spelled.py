"""What is typed in characters beyond ASCII is read as the LaTeX that it stands for, and what nobody writes so is refused."""

import pytest

from rbpsym.claims.papers.draft import ANY
from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import latex_ways
from rbpsym.expr.latex.spelled import tables
from rbpsym.expr.latex.tokens import tokenize
from rbpsym.expr.source import SourceText


def _tokens(text):
    return [(token.kind, token.text) for token in tokenize(SourceText(text), gaps=True)]


@pytest.mark.parametrize(("chars", "latex"), tables()["typed"].items())
def test_a_character_has_the_tokens_of_its_latex(chars, latex):
    assert all(_tokens(f"a {char} b") == _tokens(f"a {latex} b") for char in chars)


@pytest.mark.parametrize(
    ("typed", "latex"),
    [
        ("K = ½ m v²", r"K = \frac{1}{2} m v^{2}"),
        ("x₁₂ = v⁻¹²", "x_{12} = v^{-12}"),
        ("ẋ = θ̈ + a⃗", r"\dot{x} = \ddot{θ} + \vec{a}"),
        ("𝑥 = 𝐚·𝐛", r"x = \boldsymbol{a} \cdot \boldsymbol{b}"),
        ("f（x）＝3", "f(x) = 3"),
        ("∂u/∂t = ∑_i a_i", r"\partial u/\partial t = \sum_i a_i"),
    ],
)
def test_what_is_typed_is_read_as_its_latex(typed, latex):
    assert latex_ways(typed, ANY, whole=True).trees == latex_ways(latex, ANY, whole=True).trees


@pytest.mark.parametrize("typed", ["ü = 3", "x = √2", "ª = 2", "a → \u200b b"])
def test_what_could_be_meant_otherwise_is_refused(typed):
    with pytest.raises(RbpsymError, match=r"can't be read|invisible"):
        latex_ways(typed, ANY, whole=True)
