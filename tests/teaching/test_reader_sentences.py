"""Every sentence that a reader can say of an answer has a translation in each language, and graded feedback uses it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import rbpsym
from rbpsym.decide.dimensions import a
from rbpsym.document.phrases import usual_notation
from rbpsym.document.writers.page import plain_text
from rbpsym.languages import languages
from rbpsym.proof.step import BodyRef
from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.grading.answer import grade_answer
from rbpsym.teaching.grading.feedback import comment, translated
from rbpsym.teaching.grading.ground import book
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.model import Slip
from rbpsym.teaching.wording import say_slip

HOUSE = Path(rbpsym.__file__).parent
READERS = (
    *sorted((HOUSE / "expr").glob("infix*.py")),
    *(HOUSE / "expr" / f"{name}.py" for name in ("limits", "source")),
    HOUSE / "statement" / "units.py",
    *(
        HOUSE / "expr" / "latex" / f"{name}.py"
        for name in ("calculus", "functions", "grammar", "names", "reader", "rows", "sums", "tokens")
    ),
    *(HOUSE / "teaching" / "grading" / f"{name}.py" for name in ("quantity", "reading", "words")),
)
FOREIGN = tuple(language for language in languages() if language != "en")
SENTENCE = re.compile(r"[A-Za-z]{2,}'? [A-Za-z“{*\\0-9<(\]]|[”}] [a-z]|^[A-Z][a-z]+ ")
PATTERN = re.compile(r"\(\?|\\s|\\w|%|\[\^")
NO_SENTENCES = frozenset({"so that", "that is", "de modo que", "por tanto", "por lo tanto", "es decir", "o sea", "i.e",
                          "as long as", "da cui", "such that",
                          "provided that", "siempre que", "control character", "The symbols are: ", "read as"})  # fmt: skip


def sentences(file: Path) -> Iterator[str]:
    """The texts of a module that read as sentences, {} for each place."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    inner = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in ast.walk(node)} - {
        id(node) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr)
    }
    docs = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        text = template(node) if id(node) not in inner | docs else None
        if text and SENTENCE.search(text) and not PATTERN.search(text) and text not in NO_SENTENCES:
            yield text


def template(node: ast.AST) -> str | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)
    return None


@pytest.mark.parametrize("language", FOREIGN)
@pytest.mark.parametrize("file", READERS, ids=lambda file: file.stem)
def test_each_sentence_of_a_reader_is_translated(file: Path, language: str) -> None:
    told = [text.replace("{}", "x") for text in sentences(file)]
    assert not [text for text in told if translated(text, language) == text]


@pytest.mark.parametrize("language", FOREIGN)
def test_dimensions_are_translated(language: str) -> None:
    for dimension in DIMENSIONS.values():
        assert translated(a(dimension), language) != a(dimension)


def remarks(answer: str, language: str) -> str:
    found = grade_answer(answer, "m*g", {"m": "positive", "g": "positive"}, language=language)
    return plain_text(comment(found, language, say_slip), usual_notation(language), language)


@pytest.mark.parametrize(
    "answer", ["m*(g", "m*", "foo", "m*/g", "\\frac{m}{", "m]", "m g\u200b", "m ≤ g", "m" * 4000, ""]
)
def test_feedback_is_in_the_language_of_the_worksheet(answer: str) -> None:
    text = remarks(answer, "es")
    assert not re.search(r"\b(the|is|this|at most|write|are|here)\b", text, re.IGNORECASE), text
    assert text.endswith((".", "?"))
    assert remarks(answer, "en") != text


def test_what_fills_a_place_is_kept() -> None:
    assert "«foo»" in remarks("foo*m", "es")
    assert translated("a force is added to a length", "es") == "se suma una fuerza con una longitud"


@pytest.mark.parametrize(
    "answer",
    ["W_varilla sen(theta)", "W_rod*sin(theta)", r"W_{\mathrm{varilla}}\operatorname{sen}\theta", "W_varilla*senθ"],
)
def test_names_of_bodies_and_functions_are_read_as_the_sheet_prints_them(answer: str) -> None:
    names = book(["W_rod", "theta"], None, "es", {"rod": "varilla"})
    assert read_formula(answer, names) == read_formula("W_rod*sin(theta)", book(["W_rod", "theta"]))


def test_names_are_read_without_their_accents() -> None:
    assert book(["W_bob"], None, "es", {"bob": "péndulo"}).named("W_pendulo") == "W_bob"


def test_a_slip_is_told_with_the_names_of_the_language() -> None:
    ladder = load_problem(problem_files()["sliding-ladder"])
    slip = Slip("spin-dropped", {"body": BodyRef("ladder")})
    text = plain_text(say_slip(slip, "es", [ladder]), usual_notation("es"), "es")
    assert text.startswith("Trataste la escalera como una masa puntual")
