"""Pages that everyone can read: axe-core finds nothing in Chromium, the PDF is PDF/UA-1, formulas are spoken."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

import rbpsym
from rbpsym.courses import derive_course
from rbpsym.document.book import Chapter, around, index_page, occurring, page, problem_card
from rbpsym.document.model import Display, Document, FigureBlock, Math, parts
from rbpsym.document.notes import course_notes
from rbpsym.document.writers import writer
from rbpsym.expr.glyphs import Notation
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from rbpsym.typeset.speech import to_speech
from tests.document.samples import sample
from tests.npm import MODULES

needs_axe = pytest.mark.skipif(
    shutil.which("node") is None or shutil.which("chromium") is None or not (MODULES / "axe-core").is_dir(),
    reason="needs Node, Chromium and npm install --prefix .ci",
)


@cache
def paper() -> Document:
    return course_notes(derive_course(load_course(course_files()["paper"]), simulation=False))


def pages() -> dict[str, str]:
    """Every kind of block, with vectors in bold; the notes of a problem with long formulas; the two kinds of a site."""
    derivation = rbpsym.derive(rbpsym.load_problem(rbpsym.find_problem("rod-and-disk-free")), simulation=False)
    notes = rbpsym.notes(derivation)
    chapters = [Chapter("rod-and-disk-free", f"topic {place // 2}", derivation) for place in range(6)]
    found = {"sample": writer("html")(sample(Notation(vector="bold"))), "notes": writer("html")(notes)}
    found["page"] = page(notes, around(chapters, 2, "en"))
    cards = [problem_card(chapter, "en", "introductory") for chapter in chapters]
    return found | {"index": index_page(cards[:1], cards, book="x.pdf", found=occurring(chapters, "en"))}


@needs_axe
def test_axe_finds_nothing(tmp_path: Path) -> None:
    for name, content in pages().items():
        (tmp_path / f"{name}.html").write_text(content, encoding="utf-8")
    command = ["node", str(Path(__file__).with_name("axe.cjs")), str(MODULES), *map(str, sorted(tmp_path.iterdir()))]
    done = subprocess.run(command, capture_output=True, text=True, timeout=180, check=True)
    for found in json.loads(done.stdout):
        where = f"{Path(found['file']).name}, {found['view']}"
        assert found["violations"] == [], where
        assert found["outside"] == [], f"{where}: a page needs no network"
        assert found["wider"] <= 0, f"{where}: the page is wider than the screen"
        assert found["font"], f"{where}: the embedded font is not there"


def test_the_pdf_is_tagged_for_readers_aloud() -> None:
    """Typst refuses PDF/UA-1 where an alt text is missing; the metadata say that it kept the standard."""
    content = writer("pdf")(paper())
    assert b"pdfuaid" in content
    assert b"/MarkInfo" in content
    assert b"/Lang" in content


def test_every_formula_and_figure_of_the_typst_source_is_spoken() -> None:
    document = sample()
    text = writer("typ")(document)
    for part in parts(document.sections):
        if isinstance(part, (Math, Display)):
            assert json.dumps(to_speech(part.node, document.notation), ensure_ascii=False) in text
        if isinstance(part, FigureBlock):
            assert json.dumps(part.alt, ensure_ascii=False) in text


def test_the_page_has_landmarks_and_a_language() -> None:
    text = writer("html")(paper())
    assert re.search(r'<html lang="en">', text)
    for tag in ("header", "nav", "main"):
        assert len(re.findall(rf"<{tag}[ >]", text)) == 1
    headings = [int(level) for level in re.findall(r"<h([1-6])", text)]
    assert headings[0] == 1
    assert all(after <= before + 1 for before, after in zip(headings, headings[1:], strict=False))


def test_values_have_looks_for_notebooks() -> None:
    derivation = rbpsym.derive(rbpsym.load_problem(rbpsym.find_problem("sliding-ladder")), simulation=False)
    step = derivation.steps[-1]
    values = (derivation.study.problem, derivation, derivation.show(step.id), step, rbpsym.notes(derivation))
    for value in values:
        bundle = value._repr_mimebundle_()
        assert set(bundle) == {"text/html", "text/latex", "text/plain"}
        assert all(bundle.values())
        assert "<html" not in bundle["text/html"]
        rules = re.sub(r"<style>.*?</style>", "", bundle["text/html"], flags=re.S)
        assert "<math" in rules and "\\" not in rules
    assert set(step.statement._repr_mimebundle_()) == {"text/latex", "text/plain"}
    assert "proved" in step.certificate.verdict._repr_mimebundle_()["text/plain"]


def test_an_excerpt_of_an_unknown_step_is_an_error_at_once() -> None:
    derivation = rbpsym.derive(rbpsym.load_problem(rbpsym.find_problem("sliding-ladder")), simulation=False)
    with pytest.raises(KeyError):
        derivation.show("no.such.step")


def test_the_style_of_a_notebook_stays_inside() -> None:
    from rbpsym.document.looks import scoped_style

    sheet = scoped_style()
    assert sheet.startswith(".rbpsym")
    assert not re.search(r"(?:^|[},])(?:body|html|:root)\s*\{", sheet)
    assert sheet.count("{") == sheet.count("}")
