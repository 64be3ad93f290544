"""Files of papers, keys and solutions: PDF by the Typst wheel or by pdflatex, LaTeX sources in the exam class, HTML."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from rbpsym.document.model import Document
from rbpsym.errors import RbpsymError
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.layout import file_stem, key_document, paper_document, printable, solution_document

Write = Callable[[Document, Worksheet, bool], str | bytes]


def export_pdf(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One paper a student; with keys also a key and, if asked for, a solution each."""
    write = ENGINES.get(options.engine)
    if write is None:
        raise RbpsymError(f"unknown PDF engine “{options.engine}”", instead=f"known: {', '.join(ENGINES)}.")
    return _papers(worksheets, options, "pdf", options.engine, write)


def export_latex(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """The same as sources."""
    return _papers(worksheets, options, "tex", "pdflatex", latex)


def export_typst(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """The same as sources for Typst."""
    return _papers(worksheets, options, "typ", "typst", typst_source)


def export_html(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One page a student without any answer; with keys also one for practice, which holds them behind folds."""
    from rbpsym.teaching.papers.html_paper import write_html

    files: dict[str, str] = {}
    for worksheet in worksheets:
        stem = file_stem(worksheet)
        files[f"{stem}.html"] = write_html(worksheet)
        if options.key:
            files[f"keys/{stem}-key.html"] = write_html(worksheet, is_key=True)
    return Exported(files)


def _papers(worksheets: tuple[Worksheet, ...], options: Options, ending: str, engine: str, write: Write) -> Exported:
    files: dict[str, str | bytes] = {}
    for worksheet in (printable(worksheet, engine) for worksheet in worksheets):
        stem = file_stem(worksheet)
        files[f"{stem}.{ending}"] = write(paper_document(worksheet), worksheet, False)
        if options.key:
            files[f"keys/{stem}-key.{ending}"] = write(key_document(worksheet), worksheet, True)
        if options.solution and options.derivations:
            document = solution_document(worksheet, options.derivations)
            files[f"keys/{stem}-solution.{ending}"] = write(document, worksheet, True)
    return Exported(files)


def latex(document: Document, worksheet: Worksheet, is_key: bool) -> str:
    """The source in the exam class."""
    from rbpsym.teaching.papers.latex_paper import write_paper

    return write_paper(document, worksheet, is_key=is_key)


def by_pdflatex(document: Document, worksheet: Worksheet, is_key: bool) -> bytes:
    """PDF by pdflatex, of the same source."""
    from rbpsym.document.writers.pdf import compiled

    return compiled(latex(document, worksheet, is_key))


def typst_source(document: Document, worksheet: Worksheet, is_key: bool) -> str:
    """The source for Typst."""
    from rbpsym.teaching.papers.typst_paper import write_paper

    return write_paper(document, worksheet, is_key=is_key)


def by_typst(document: Document, worksheet: Worksheet, is_key: bool) -> bytes:
    """Tagged PDF by Typst."""
    import typst

    source = typst_source(document, worksheet, is_key).encode()
    return typst.compile(source, pdf_standards=["ua-1"], font_paths=_fonts())


@cache
def _fonts() -> Any:
    """The fonts that come with Typst, looked up once for all papers."""
    import typst

    return typst.Fonts(include_system_fonts=False)


ENGINES: Mapping[str, Write] = {"typst": by_typst, "pdflatex": by_pdflatex}
