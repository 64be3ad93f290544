"""PDF of papers, keys and solutions, by the Typst wheel or by pdflatex."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

from rbpsym.document.model import Document
from rbpsym.errors import RbpsymError
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.layout import key_document, paper_document, solution_document
from rbpsym.teaching.papers.letters import printable
from rbpsym.teaching.papers.naming import file_stem


def export_pdf(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One paper a student; with keys also a key and a solution each."""
    engine = ENGINES.get(options.engine)
    if engine is None:
        raise RbpsymError(f"unknown PDF engine “{options.engine}”", instead=f"known: {', '.join(ENGINES)}.")
    files: dict[str, bytes] = {}
    for worksheet in (printable(worksheet, options.engine) for worksheet in worksheets):
        stem = file_stem(worksheet)
        files[f"{stem}.pdf"] = engine(paper_document(worksheet), worksheet, False)
        if options.key:
            files[f"keys/{stem}-key.pdf"] = engine(key_document(worksheet), worksheet, True)
        if options.solution and options.derivations:
            document = solution_document(worksheet, options.derivations)
            files[f"keys/{stem}-solution.pdf"] = engine(document, worksheet, True)
    return Exported(files)


def by_typst(document: Document, worksheet: Worksheet, is_key: bool) -> bytes:
    """Tagged PDF by Typst."""
    import typst

    from rbpsym.teaching.papers.typst_paper import write_paper

    source = write_paper(document, worksheet, is_key=is_key).encode()
    return typst.compile(source, pdf_standards=["ua-1"], font_paths=_fonts())


@cache
def _fonts() -> object:
    """The fonts that come with Typst, looked up once for all papers."""
    import typst

    return typst.Fonts(include_system_fonts=False)


def by_pdflatex(document: Document, worksheet: Worksheet, is_key: bool) -> bytes:
    """By pdflatex, from the same document in the exam class."""
    from rbpsym.document.writers.pdf import compiled
    from rbpsym.teaching.papers.latex_paper import write_paper

    return compiled(write_paper(document, worksheet, is_key=is_key))


Engine = Callable[[Document, Worksheet, bool], bytes]
ENGINES: Mapping[str, Engine] = {"typst": by_typst, "pdflatex": by_pdflatex}
