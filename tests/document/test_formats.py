"""What is peculiar to a format: native equations, frames that fit, Markdown that survives, notebooks that run."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace
from functools import cache
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rbpsym
from rbpsym.courses import derive_course
from rbpsym.document import files as extras
from rbpsym.document.model import (
    Display,
    Document,
    FigureBlock,
    ItemList,
    Math,
    Paragraph,
    Ref,
    Section,
    Table,
    numbered,
    parts,
    words,
)
from rbpsym.document.notes import course_notes, plain
from rbpsym.document.pictures import pictures
from rbpsym.document.writers import WRITERS, files, writer
from rbpsym.document.writers.markdown import in_cell, in_markdown
from rbpsym.document.writers.page import page_for
from rbpsym.document.writers.pdf import compiled, end_of, without_last_lines, write_pdf
from rbpsym.document.writers.slides import COLUMN, SLIDES, digest, write_slides
from rbpsym.document.writers.typst import write_typst
from rbpsym.errors import RbpsymError
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from tests.document.samples import NASTY, sample
from tests.library.derived import unsimulated

M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"


@cache
def ladder():
    return unsimulated("sliding-ladder")


def count(document: Document, kind: type) -> int:
    return sum(isinstance(part, kind) for part in parts(document.sections))


# --- Word


def word(document: Document) -> ET.Element:
    with ZipFile(BytesIO(writer("docx")(document))) as file:
        assert file.testzip() is None
        return ET.fromstring(file.read("word/document.xml"))


def test_word_has_native_equations_tables_and_pictures() -> None:
    document = sample()
    root = word(document)
    assert len(list(root.iter(f"{M}oMath"))) >= count(document, Display) + count(document, Math)
    assert len(list(root.iter(f"{W}drawing"))) == count(document, FigureBlock)
    headers = list(root.iter(f"{W}tblHeader"))
    assert len(headers) == count(document, Table)


def test_word_opens_in_its_own_library() -> None:
    docx = pytest.importorskip("docx")
    file = docx.Document(BytesIO(writer("docx")(sample())))
    assert file.core_properties.title == "A pendulum and a ladder"
    assert NASTY in [paragraph.text for paragraph in file.paragraphs]
    headings = [p.text for p in file.paragraphs if p.style.name.startswith("Heading")]
    assert headings[:2] == ["1\u2002The problem", "2\u2002Equation of motion"]


def test_word_shows_no_mark_of_alignment() -> None:
    texts = [part.text or "" for part in word(sample()).iter(f"{M}t")]
    assert texts and not any(mark in text for text in texts for mark in "&\\$")


def test_links_of_word_lead_to_bookmarks() -> None:
    root = word(sample())
    targets = {mark.get(f"{W}name") for mark in root.iter(f"{W}bookmarkStart")}
    links = [link.get(f"{W}anchor") for link in root.iter(f"{W}hyperlink")]
    assert links and set(links) <= targets
    assert all(len(name) <= 40 for name in targets)


def test_pictures_of_word_say_what_is_seen() -> None:
    found = [part.get("descr") for part in word(sample()).iter() if part.tag.endswith("}docPr")]
    told = [" ".join(f.alt.split()) for f in parts(sample().sections) if isinstance(f, FigureBlock)]
    assert [" ".join(text.split()) for text in found] == told


def test_each_ordered_list_of_word_begins_with_one() -> None:
    two = ItemList((words("a"), words("b")), ordered=True)
    document = Document(words("x"), (Section(words("y"), (two, Paragraph(words("z")), replace(two))),))
    numbers = [part.get(f"{W}val") for part in word(document).iter(f"{W}numId")]
    assert len(numbers) == 4
    assert len(set(numbers)) == 2


def test_a_missing_package_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "docx", None)
    with pytest.raises(RbpsymError, match="python-docx is not installed") as error:
        writer("docx")(sample())
    assert "pip install 'rbpsym[docx]'" in str(error.value)


def test_every_extra_is_declared() -> None:
    import tomllib

    declared = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"]
    for package, name in extras.EXTRAS.values():
        assert any(line.startswith(package) for line in declared["optional-dependencies"][name])


# --- slides


def test_frames_keep_all_blocks_in_order() -> None:
    document = numbered(rbpsym.notes(ladder()))
    source, page = write_slides(document), page_for(document, SLIDES, COLUMN)
    shown = [page.show(block) for section in document.sections for block in section.blocks]
    places = [source.find(text) for text in shown]
    assert -1 not in places and places == sorted(places)


def test_no_slide_begins_with_words_whose_formula_is_left_out() -> None:
    """Words that lead to a formula are kept with it, or not at all."""
    for section in digest(rbpsym.notes(ladder())).sections:
        assert not [block for block in section.blocks[-1:] if isinstance(block, Paragraph) and plain(block.inlines).endswith(":")]


def test_the_slides_of_a_problem_hold_its_whole_argument() -> None:
    """Each formula to which words of a slide point is on a slide, and so is each of the notes but for those of the checks."""
    notes, slides = rbpsym.notes(ladder()), digest(rbpsym.notes(ladder()))
    assert count(slides, Display) == count(notes, Display) > 10
    assert not any(section.label.endswith("section.checks") for section in slides.sections)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="TeX is not installed")
def test_slides_compile_and_nothing_sticks_out(monkeypatch: pytest.MonkeyPatch) -> None:
    logs = []
    run = subprocess.run
    monkeypatch.setattr(subprocess, "run", lambda *a, **k: logs.append(run(*a, **k)) or logs[-1])
    assert compiled(write_slides(rbpsym.notes(ladder()))).startswith(b"%PDF")
    assert compiled(write_slides(sample())).startswith(b"%PDF")
    text = "".join(log.stdout.decode("utf-8", "replace") for log in logs)
    assert "Overfull \\vbox" not in text
    assert not [float(pt) for pt in re.findall(r"Overfull \\hbox \(([\d.]+)pt", text) if float(pt) > 3]


def test_slides_without_tex_are_a_source(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert list(files(sample(), "beamer", "name")) == ["name-slides.tex"]


# --- Markdown


def test_markdown_has_a_drawing_beside_it_for_each_figure() -> None:
    found = files(sample(), "md", "ladder")
    svgs = [name for name in found if name.endswith(".svg")]
    assert len(svgs) == count(sample(), FigureBlock)
    assert all(f"]({name})" in found["ladder.md"] for name in svgs)
    for name in svgs:
        root = ET.fromstring(found[name])
        assert root.tag.endswith("svg")
        assert not re.search(rb"<(?:script|foreignObject|image)|href=\"http", found[name])


@pytest.mark.parametrize(
    ("latex", "safe"),
    [
        (r"\vec{R}_{cm} + \vec{V}_{cm}", r"\vec{R}_ {cm} + \vec{V}_ {cm}"),
        (r"a \, b", r"a \thinspace  b"),
        (r"x < y", r"x \lt y"),
        (r"\left[ a \right](b)", r"\left[ a \right] (b)"),
        (r"\mathpzc{w}", "𝓌"),
        (r"N_w", r"N_w"),
    ],
)
def test_formulas_are_not_taken_for_markdown(latex: str, safe: str) -> None:
    assert in_markdown(latex) == safe


def test_bars_do_not_part_cells() -> None:
    assert in_cell(r"$\left. x \right|_0$ and \| word") == r"$\left. x \right\vert _0$ and \| word"


def test_a_formula_in_markdown_is_not_emphasis() -> None:
    text = writer("md")(rbpsym.notes(ladder()))
    inline = re.sub(r"\$\$.*?\$\$", "", text, flags=re.S)
    for formula in re.findall(r"\$([^$\n]+)\$", inline):
        assert not re.search(r"[^\w\s\\]_\S|[<>*]|\\[,;{}]", formula), formula


# --- notebooks


def cells(document: Document) -> list[dict]:
    return json.loads(writer("ipynb")(document))["cells"]


def test_a_notebook_is_valid() -> None:
    nbformat = pytest.importorskip("nbformat")
    for document in (sample(), rbpsym.notes(ladder())):
        nbformat.validate(nbformat.reads(writer("ipynb")(document), 4))


def test_a_notebook_builds_derives_and_checks() -> None:
    code = ["".join(cell["source"]) for cell in cells(rbpsym.notes(ladder())) if cell["cell_type"] == "code"]
    results = [step.id for step in ladder().steps if step.is_result]
    shown = re.findall(r'"([\w.]+)"', " ".join(line for line in code if line.startswith("derivation.show")))
    assert code[0].startswith("from rbpsym import derive, load_text")
    assert set(shown) <= set(results)
    assert len(shown) >= 3
    assert "assert summary" in code[-1]


def test_the_code_of_a_notebook_runs_from_top_to_bottom() -> None:
    space: dict = {}
    for cell in cells(rbpsym.notes(ladder())):
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), "cell", "exec"), space)
    assert space["problem"] == ladder().study.problem
    assert space["summary"]["proved"] == len(ladder().steps)


PHASED = ["ball-slipping-to-rolling", "box-against-ridge", "falling-rod-hooked"]


@pytest.mark.parametrize("name", PHASED)
def test_the_results_of_all_phases_show_themselves(name: str) -> None:
    space: dict = {}
    shown = 0
    for cell in cells(rbpsym.notes(rbpsym.load_problem(rbpsym.find_problem(name)))):
        if cell["cell_type"] == "code":
            source = "".join(cell["source"])
            exec(compile(source, "cell", "exec"), space)
            if source.startswith("derivation.show"):
                assert "<math" in eval(source, space)._repr_mimebundle_()["text/html"]
                shown += "phase2." in source
    assert shown and space["summary"]["refuted"] == 0


@pytest.mark.parametrize("name", ["sliding-ladder", PHASED[0]])
def test_a_kernel_runs_the_notebook_and_shows_pages(name: str) -> None:
    """In Jupyter itself: no error, and a derivation shows itself as HTML."""
    nbformat = pytest.importorskip("nbformat")
    client = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    notebook = nbformat.reads(writer("ipynb")(rbpsym.notes(rbpsym.load_problem(rbpsym.find_problem(name)))), 4)
    client.NotebookClient(notebook, timeout=240, startup_timeout=240, kernel_name="python3").execute()
    data = [output["data"] for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    assert sum("text/html" in found and "<math" in found["text/html"] for found in data) >= 3


def test_a_notebook_says_what_follows_a_change_and_what_it_needs() -> None:
    first = "".join(cells(rbpsym.notes(ladder()))[0]["source"])
    assert "pip install rbpsym" in first and "stay those of the statement as it was" in first


@given(st.text(max_size=200))
@settings(max_examples=60)
def test_any_statement_is_a_literal_of_python(text: str) -> None:
    from rbpsym.document.writers.notebook import quoted

    clean = text.encode("utf-8", "ignore").decode().replace("\r", "")
    assert eval(quoted(clean)).strip() == clean.strip()


# --- pictures


def test_pictures_have_the_size_of_their_scenes() -> None:
    for found in pictures(numbered(sample())).values():
        assert found.content.startswith(b"\x89PNG")
        assert 2 < found.width < 20
        assert 1 < found.height < 20


# --- hostile words

HOSTILE = st.text(
    st.one_of(st.sampled_from("\\&$#%_{}~^<>|`\"'*[]()=+-/@!;:,.1 \n\t"), st.characters(codec="utf-8")), max_size=40
)
LATIN = st.text(st.sampled_from("\\&$#%_{}~^<>|`\"'*[]()=+-/@!;:,.1aéñ "), min_size=1, max_size=40)


def hostile(text: str) -> Document:
    block = (Paragraph(words(text)), Table((words(text),), ((words(text),),), words(text)), ItemList((words(text),)))
    return Document(words(text), (Section(words(text), block),), words(text), words(text))


@given(HOSTILE)
@settings(max_examples=40)
def test_any_title_stands_in_html_as_it_is(text: str) -> None:
    page = writer("html")(hostile(text))
    body = re.sub(r"<(style|title)>.*?</\1>", "", page, flags=re.S)
    tags = {tag.lower() for tag in re.findall(r"</?([a-zA-Z][\w-]*)", body)}
    known = "html head meta body header h1 h2 p main div table caption span thead tr th tbody td ul li nav ol a"
    assert tags <= set(known.split())


@given(HOSTILE)
@settings(max_examples=12)
def test_any_title_gives_a_word_file(text: str) -> None:
    root = word(hostile(text))
    shown = "".join(part.text or "" for part in root.iter(f"{W}t")).replace("’", "'")  # behind a letter it is an apostrophe
    clean = "".join(c for c in text.replace("’", "'") if c.isprintable())
    assert all(char in shown for char in clean if char.strip())


@given(LATIN | HOSTILE)
@settings(max_examples=15)
def test_any_title_is_typeset(text: str) -> None:
    assert write_pdf(hostile(f"a {text}")).startswith(b"%PDF")


SCRIPTS = "مرحبا שלום 漢字 θ ≤ é e\u0301 🚀\ufe0f \u202eabc\u202c Ǆ ﷽ Ω½"


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler is not installed")
@pytest.mark.parametrize("engine", ["typst", "pdflatex", "beamer"])
def test_letters_of_all_scripts_and_pictures_are_set_or_told(engine: str, tmp_path: Path) -> None:
    if engine != "typst" and shutil.which("pdflatex") is None:
        pytest.skip("TeX is not installed")
    document = hostile(SCRIPTS)
    content = compiled(write_slides(document)) if engine == "beamer" else write_pdf(document, engine)
    (tmp_path / "x.pdf").write_bytes(content)
    text = subprocess.run(
        ["pdftotext", str(tmp_path / "x.pdf"), "-"], capture_output=True, text=True, check=True
    ).stdout
    assert text.count("rocket") >= 5
    assert "½" in text


@given(HOSTILE)
@settings(max_examples=40)
def test_any_title_is_no_command_of_tex(text: str) -> None:
    for name in ("tex", "beamer"):
        source = writer(name)(hostile(text))
        assert r"\input{" not in source and r"\write18" not in source
        assert source.count(r"\begin{document}") == source.count(r"\end{document}") == 1


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="TeX is not installed")
@pytest.mark.parametrize("name", ["tex", "beamer"])
def test_the_nastiest_title_compiles(name: str) -> None:
    assert compiled(writer(name)(hostile(NASTY))).startswith(b"%PDF")


def test_every_format_has_files_by_its_name() -> None:
    for name in WRITERS:
        found = files(sample(), name, "x")
        assert all(file.startswith("x") for file in found)
        assert all(found.values())


# --- rendered pages


MARKUP = re.compile(r"\\|\$|&(?:\w+;)?|(?<!\w)#\w|\*\*|\bfrac\b|\bthinspace\b|\{|\}")


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler is not installed")
@pytest.mark.parametrize("name", ["typst", "pdflatex", "beamer"])
def test_no_markup_is_left_on_a_printed_page(name: str, tmp_path: Path) -> None:
    if name != "typst" and shutil.which("pdflatex") is None:
        pytest.skip("TeX is not installed")
    document = rbpsym.notes(ladder(), plots=True)
    content = compiled(write_slides(document)) if name == "beamer" else write_pdf(document, name)
    (tmp_path / "x.pdf").write_bytes(content)
    text = subprocess.run(
        ["pdftotext", str(tmp_path / "x.pdf"), "-"], capture_output=True, text=True, check=True
    ).stdout
    assert len(text) > 3000
    assert not MARKUP.search(text), MARKUP.search(text)
    assert "??" not in text


def test_no_markup_is_left_in_word() -> None:
    root = word(rbpsym.notes(ladder(), plots=True))
    texts = [part.text or "" for part in root.iter() if part.tag in (f"{W}t", f"{M}t")]
    assert not [text for text in texts if MARKUP.search(text)]


def test_markdown_renders_without_markup_left() -> None:
    """By a reader of CommonMark with tables; formulas are taken out first, as GitHub does it."""
    reader = pytest.importorskip("markdown_it").MarkdownIt("commonmark").enable("table")
    for name in ("md", "ipynb"):
        content = writer(name)(rbpsym.notes(ladder(), plots=True))
        cells = json.loads(content)["cells"] if name == "ipynb" else []
        parts_ = ["".join(c["source"]) for c in cells if c["cell_type"] == "markdown"] or [content]
        for part in parts_:
            bare = re.sub(r"\$\$.*?\$\$|\$[^$\n]+\$", "formula", part, flags=re.S)
            page = re.sub(r"<[^>]*>", "", reader.render(bare))
            assert not re.search(r"\\|\$|\*\*|\||^#", page, re.M), page


@pytest.mark.parametrize("name", ["md", "ipynb"])
def test_tables_of_markdown_have_equal_rows(name: str) -> None:
    text = writer(name)(rbpsym.notes(ladder()))
    text = "".join("".join(c["source"]) + "\n" for c in json.loads(text)["cells"]) if name == "ipynb" else text
    blocks = re.findall(r"(?:^\|.*\|\n?)+", text, re.M)
    assert blocks
    for block in blocks:
        counts = {len(re.findall(r"(?<!\\)\|", line)) for line in block.strip().splitlines()}
        assert len(counts) == 1, block


def test_slides_of_the_course_are_its_results_and_figures() -> None:
    """Every boxed formula stands on a frame, few others do, and no word points to what is not there."""
    document = course_notes(derive_course(load_course(course_files()["paper"]), simulation=False), plots=True)
    shown = digest(document)
    boxed = [part.node for part in parts(document) if isinstance(part, Display) and part.boxed]
    told = [part for part in parts(shown) if isinstance(part, Display)]
    assert [part.node for part in told if part.boxed] == boxed
    assert len(told) < 1.7 * len(boxed)  # with those from which the answers follow
    assert write_slides(shown).count(r"\begin{frame}") < 40
    labels = {part.label for part in parts(shown) if getattr(part, "label", "")} | {s.label for s in shown.sections}
    labels |= {label for part in told for label in part.also}
    assert {part.label for part in parts(shown) if isinstance(part, Ref)} <= labels


@pytest.mark.parametrize(("lines", "pages"), [(52, 1), (75, 2)])
def test_a_last_page_of_a_few_lines_is_saved(lines: int, pages: int) -> None:
    text = tuple(Paragraph(words("A line.")) for _ in range(lines))
    source = write_typst(Document(words("Long"), (Section(words("One"), text),)))
    assert end_of(source)[0] == 2 and end_of(without_last_lines(source))[0] == pages
