"""Laws that every writer keeps: all that the document says is there, and nothing unescaped."""

from __future__ import annotations

import html
import json
import re
import shutil
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from zipfile import ZipFile

import pytest

from rbpsym.document import breaking
from rbpsym.document.model import (
    Display,
    Document,
    DocumentError,
    FigureBlock,
    Math,
    Paragraph,
    Ref,
    Section,
    Table,
    numbered,
    parts,
    words,
)
from rbpsym.document.notes import notes
from rbpsym.document.writers import WRITERS, writer
from rbpsym.document.writers.html import folding_pieces, write_html
from rbpsym.document.writers.markdown import in_markdown
from rbpsym.document.writers.pdf import write_pdf
from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.tree import names
from rbpsym.typeset import boxes as b
from rbpsym.typeset import latex, mathml, omml, typst
from rbpsym.typeset.layout import layout
from tests.document.samples import NASTY, SKETCHES, sample
from tests.library.derived import unsimulated

SOURCES = [name for name in WRITERS if name != "pdf"]
PRINTERS = {"typ": typst, "html": mathml, "docx": omml}  # all others print LaTeX
TAGGED = ("html", "docx")
ON_GITHUB = ("md", "ipynb")


def written(name: str, document: Document) -> str:
    """The source of a document; of a .docx its main part, of a notebook its cells."""
    content = writer(name)(document)
    if name == "docx":
        with ZipFile(BytesIO(content)) as file:
            return file.read("word/document.xml").decode()
    return "\n\n".join("".join(cell["source"]) for cell in json.loads(content)["cells"]) if name == "ipynb" else content


def printed(name: str, box: b.Box) -> str:
    """A box as the format prints it."""
    found = PRINTERS.get(name, latex).render(box)
    return in_markdown(found) if name in ON_GITHUB else found


def squeezed(text: str) -> str:
    """Without spaces and without the classes that only style."""
    return re.sub(r'\s| class="[^"]*"| form="infix"', "", text)


def letters(text: str, name: str) -> str:
    """What a printed formula shows: its signs, without markup and layout."""
    text = html.unescape(re.sub(r"<[^>]*>", "", text)) if name in TAGGED else text
    text = re.sub(r"\\(?:left|right)\.?|&(?:amp;)?|\\(?:qquad|begin\{aligned\}|end\{aligned\}|\\)|\bwide\b", "", text)
    return re.sub(r'\s|""|\{\}|\\|\u200b', "", text)


@pytest.mark.parametrize("name", WRITERS)
def test_every_enrolled_writer_writes(name: str) -> None:
    assert len(writer(name)(sample())) > 1000


@pytest.mark.parametrize("name", SOURCES)
def test_every_formula_appears(name: str) -> None:
    document = sample()
    shown = letters(written(name, document), name)
    found = [part for part in parts(document.sections) if isinstance(part, (Math, Display))]
    assert len(found) > 10
    for part in found:
        for line in breaking.lines(part.node, document.notation, 1000.0):
            for box in (line.left, *folding_pieces(line.right)):
                assert letters(printed(name, box), name) in shown


@pytest.mark.parametrize("name", SOURCES)
def test_every_caption_and_cell_appears(name: str) -> None:
    text = written(name, sample())
    text = re.sub("<[^>]*>", "", text) if name in TAGGED else text
    shown = html.unescape(squeezed(text)).replace("\\", "")
    for part in parts(sample().sections):
        if isinstance(part, (FigureBlock, Table)):
            assert "".join(t.text for t in part.caption).replace(" ", "") in shown
    assert "angleatwhichitisreleased" in shown


@pytest.mark.parametrize(
    ("name", "mark"),
    [
        ("tex", r"\begin{tikzpicture}"),
        ("typ", "drawing("),
        ("beamer", r"\begin{tikzpicture}"),
        ("html", "<svg"),
        ("md", "> **Figure"),
        ("ipynb", "](attachment:figure-"),
        ("docx", "<pic:pic>"),
    ],
)
def test_every_scene_is_drawn(name: str, mark: str) -> None:
    figures = [part for part in parts(sample().sections) if isinstance(part, FigureBlock)]
    scenes = len(figures) if name in ("md", "ipynb", "docx") else sum(len(figure.scenes) for figure in figures)
    text = written(name, sample())
    assert text.count(mark) - text.count(f"#let {mark}") == scenes


@pytest.mark.parametrize("name", SOURCES)
def test_numbers_of_equations_and_references_agree(name: str) -> None:
    text = written(name, sample())
    given = [part.number for part in parts(numbered(sample()).sections) if isinstance(part, Display) and part.number]
    assert given == [str(n + 1) for n in range(len(given))]
    if name in ("tex", "beamer"):
        assert text.count(r"\begin{equation}") == len(given)
    else:
        assert all(f"({number})" in text or rf"\tag{{{number}}}" in text for number in given)


class Visible(HTMLParser):
    """The text that a browser shows."""

    def __init__(self) -> None:
        super().__init__()
        self.text, self.hidden, self.tags = "", 0, []

    def handle_starttag(self, tag: str, attrs: list) -> None:
        self.hidden += tag in ("style", "title")
        self.tags += [] if tag in ("meta", "br") else [tag]

    def handle_endtag(self, tag: str) -> None:
        self.hidden -= tag in ("style", "title")
        assert self.tags.pop() == tag

    def handle_startendtag(self, tag: str, attrs: list) -> None:
        pass

    def handle_data(self, data: str) -> None:
        self.text += "" if self.hidden else data


def visible(document: Document) -> str:
    parser = Visible()
    parser.feed(written("html", document))
    assert not parser.tags, "every element is closed"
    return parser.text


def without_nasty(document: Document) -> Document:
    """The sample without the paragraph that holds every special character."""
    kept = tuple(
        replace(section, blocks=tuple(block for block in section.blocks if block != Paragraph(words(NASTY))))
        for section in document.sections
    )
    return replace(document, sections=kept)


def test_a_rendered_page_shows_no_markup() -> None:
    text = visible(without_nasty(sample()))
    assert not re.search(r"\\|\$|&\w+;|\{|\}", text)
    assert NASTY in visible(sample())


def test_html_needs_no_network_and_no_script() -> None:
    text = written("html", sample())
    assert "<script" not in text
    assert not re.search(r'(?:src|href)="(?:https?:)?//', text)
    assert not re.search(r"url\((?!data:)", text)


HOSTILE = Document(
    words("<b>&amp;</b> \\input{x} #eval"),
    (
        Section(
            words("</h2><script>alert(1)</script>"),
            (
                Paragraph(words(NASTY)),
                Paragraph(words("1. no list - no list + = heading / term: // comment")),
                Table((words("a | b"),), ((words("c & d \\\\ e"),),), words("50 %")),
                FigureBlock((), words("none"), '"><script>'),
            ),
            label='a"b<c',
        ),
    ),
)


def test_hostile_text_is_escaped_everywhere() -> None:
    text = written("html", HOSTILE)
    assert "<script" not in text
    assert "<b>&amp;amp;</b>" not in text
    for name in ("tex", "md"):
        assert written(name, HOSTILE)
    assert r"\input" not in written("tex", HOSTILE).replace(r"\inputencoding", "")
    assert write_pdf(
        replace(HOSTILE, sections=(replace(HOSTILE.sections[0], blocks=HOSTILE.sections[0].blocks[:3]),))
    ).startswith(b"%PDF")


def test_a_reference_without_a_target_is_an_error() -> None:
    broken = Document(words("x"), (Section(words("y"), (Paragraph((Ref("nowhere"),)),)),))
    with pytest.raises(DocumentError, match="nowhere"):
        numbered(broken)


def test_a_label_given_twice_is_an_error() -> None:
    twice = Section(words("y"), (), "same")
    with pytest.raises(DocumentError, match="same"):
        numbered(Document(words("x"), (twice, twice)))


def test_an_unknown_format_or_engine_is_a_sentence() -> None:
    with pytest.raises(DocumentError, match="docs"):
        writer("docs")
    with pytest.raises(RbpsymError, match="lualatex"):
        write_pdf(sample(), "lualatex")


def test_the_same_document_is_written_the_same_twice() -> None:
    for name in SOURCES:
        assert written(name, sample()) == written(name, sample())


@pytest.mark.parametrize("column", [12.0, 20.0, 37.0])
def test_no_line_is_wider_than_the_column_if_its_terms_fit(column: float) -> None:
    for part in parts(sample().sections):
        if isinstance(part, Display):
            found = breaking.lines(part.node, sample().notation, column)
            atoms = [breaking.width(t) for line in found for t in breaking.terms(line.right)]
            if max(atoms) + breaking.INDENT + 6 < column:
                assert breaking.widest(found) <= column + 1e-9


def test_breaking_loses_no_term() -> None:
    for part in parts(sample().sections):
        if isinstance(part, Display):
            whole = latex.render(layout(part.node, sample().notation))
            for column in (8.0, 15.0, 30.0):
                found = breaking.lines(part.node, sample().notation, column)
                text = "".join(latex.render(line.left) + latex.render(line.right) for line in found)
                see = without_bars if "/" in text and "/" not in whole else str
                assert see(letters(text, "tex")) == see(letters(whole, "tex"))


def without_bars(text: str) -> str:
    """Without what makes a fraction: one that is too wide for its line is written with a stroke."""
    return re.sub(r"frac|[{}()\[\]/]", "", text)


def test_the_sample_has_every_sketch() -> None:
    figures = [part for part in parts(sample().sections) if isinstance(part, FigureBlock)]
    assert len(figures) >= len(SKETCHES)


def test_what_latex_shows_reads_back_as_the_same_formula() -> None:
    document = sample()
    text = written("tex", document)
    bodies = re.findall(r"\\begin\{equation\*?\}(?:\\label\{[^}]*\})?\n(.*?)\\end\{equation", text, re.S)
    shown = [part for part in parts(document.sections) if isinstance(part, Display)]
    assert len(bodies) == len(shown)
    for found, part in zip(bodies, shown, strict=True):
        formula = re.sub(r"\\(?:reason\w+|tag\*)\{.*|\\(?:begin|end)\{gathered\}|\\qquad (?=\\reason)", "", found)
        formula = re.sub(r"\\boxed\{(.*)\}\s*$", r"\1", formula.strip(), flags=re.S)
        formula = formula.removesuffix("\\\\").replace("\\\\\n  &\\qquad {}", " ")
        node = read_latex(formula, names(part.node), notation=document.notation)
        again = letters(latex.to_latex(node, document.notation), "tex")
        assert again == letters(latex.to_latex(part.node, document.notation), "tex")


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="TeX is not installed")
def test_pdflatex_compiles_the_latex() -> None:
    assert write_pdf(sample(), "pdflatex").startswith(b"%PDF")
    assert write_pdf(HOSTILE, "pdflatex").startswith(b"%PDF")


def test_a_missing_pdflatex_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(RbpsymError, match="pdflatex is not installed"):
        write_pdf(sample(), "pdflatex")


def test_apostrophes_are_those_of_print() -> None:
    document = Document(words("Newton's laws and the bodies' spins"), (Section(words("Steiner's rule"), ()),))
    for name in ("html", "typ", "md", "docx", "ipynb"):
        text = written(name, document)
        assert "Newton’s laws" in text or name in TAGGED
        assert "Steiner’s rule" in text
        assert "Steiner's" not in text


def test_a_mark_does_not_stand_alone_on_the_line_below_its_formula():
    page = write_html(numbered(notes(unsimulated("rod-pendulum"))))
    assert re.search(r'<span class="held"><math(?:(?!</math>).)*</math>\.</span>', page)
    assert not re.search(r"<p>(?:(?!</p>).)*</math>[.,](?!</span>)", page)
