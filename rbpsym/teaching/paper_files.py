"""Files of papers, keys and solutions: PDF by the Typst wheel or by pdflatex, LaTeX sources in the exam class, HTML."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, partial
from importlib import import_module
from typing import Any

from rbpsym.errors import RbpsymError
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.layout import file_stem, key_document, paper_document, printable, solution_document

Made = Callable[[str], str | bytes]


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


def _papers(ending: str, worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One paper a student in PDF (by the engine that was chosen), in the exam class of LaTeX (“tex”) or in Typst (“typ”); with
    keys also a key and, if asked for, a solution each."""
    engine = {"tex": "pdflatex", "typ": "typst"}.get(ending, options.engine)
    if engine not in ENGINES:
        raise RbpsymError(f"unknown PDF engine “{engine}”", instead=f"known: {', '.join(ENGINES)}.")
    module, compiled = ENGINES[engine]
    write, files = import_module(module).write_paper, dict[str, str | bytes]()
    made: Made = compiled if ending == "pdf" else str
    for worksheet in (printable(worksheet, engine) for worksheet in worksheets):
        stem = file_stem(worksheet)
        files[f"{stem}.{ending}"] = made(write(paper_document(worksheet, options.studio), worksheet))
        if options.key:
            files[f"keys/{stem}-key.{ending}"] = made(write(key_document(worksheet), worksheet, is_key=True))
        if options.solution and options.derivations:
            document = solution_document(worksheet, options.derivations)
            files[f"keys/{stem}-solution.{ending}"] = made(write(document, worksheet, is_key=True))
    return Exported(files)


export_pdf, export_tex, export_typ = (partial(_papers, ending) for ending in ("pdf", "tex", "typ"))


def by_pdflatex(source: str) -> bytes:
    """PDF by pdflatex."""
    from rbpsym.document.writers.pdf import compiled

    return compiled(source)


def by_typst(source: str) -> bytes:
    """Tagged PDF by Typst."""
    import typst

    return typst.compile(source.encode(), pdf_standards=["ua-1"], font_paths=_fonts())


@cache
def _fonts() -> Any:
    """The fonts that come with Typst, looked up once for all papers."""
    import typst

    return typst.Fonts(include_system_fonts=False)


# engine -> what writes its sources, and what makes PDF of them
ENGINES: Mapping[str, tuple[str, Made]] = {
    "typst": ("rbpsym.teaching.papers.typst_paper", by_typst),
    "pdflatex": ("rbpsym.teaching.papers.latex_paper", by_pdflatex),
}
