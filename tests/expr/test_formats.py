"""Typst compiles, MathML is one well-formed element, speech has words for everything."""

from xml.etree import ElementTree

import pytest
import typst

from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Relations, Sym
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.speech import WORDS, to_speech
from rbpsym.typeset.typst import to_typst
from tests.expr.paper import NAMES
from tests.expr.samples import CALCULUS, SAMPLES, SCALARS

CORE = frozenset(
    "math mi mn mo mrow mfrac msqrt msub msup msubsup mover munder mspace mtable mtr mtd".split()
)  # fmt: skip


def test_typst_compiles_every_sample():
    notations = (Notation(), Notation(vector="bold", differential="upright", decimal=","))
    formulas = [to_typst(way, style) for tree in SAMPLES.values() for style in notations for way in (tree, Relations((tree,)))]
    formulas += [to_typst(Sym(name)) for name in NAMES]
    page = "\n".join(f"$ {formula} $" for formula in formulas)
    assert typst.compile(page.encode()).startswith(b"%PDF")


@pytest.mark.parametrize("name", SAMPLES)
def test_mathml_is_core(name):
    for tree in (SAMPLES[name], Relations((SAMPLES[name],))):
        root = ElementTree.fromstring(to_mathml(tree))
        assert {part.tag.split("}")[1] for part in root.iter()} <= CORE
        assert len(root) == 1


CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munder": 2}


@pytest.mark.parametrize("name", SAMPLES)
def test_mathml_elements_have_their_parts(name):
    root = ElementTree.fromstring(to_mathml(SAMPLES[name]))
    for part in root.iter():
        tag = part.tag.split("}")[1]
        assert len(part) == CHILDREN.get(tag, len(part))


SPOKEN = {
    "ladder": "minus 3 times g over 4 times ell end fraction times cosine of theta",
    "square": "sine of theta squared",
    "sum squared": "open parenthesis m over 2 plus capital m close parenthesis squared",
    "root": "the square root of 3 times g over 2 times ell end fraction",
}


@pytest.mark.parametrize("name", SPOKEN)
def test_speech(name):
    assert to_speech(SCALARS[name]) == SPOKEN[name]


def test_speech_in_another_language():
    words = {
        **WORDS,
        "integral": "la integral desde {a} hasta {b} de {c} d {d}",
        "over": "sobre",
        "letters.theta": "tita",
    }
    assert to_speech(CALCULUS["integral times"], Notation(words=words)).startswith("la integral desde tita")
