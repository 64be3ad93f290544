"""LaTeX sources of papers and keys, in the exam class."""

from __future__ import annotations

from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.latex_paper import write_paper
from rbpsym.teaching.papers.layout import key_document, paper_document, solution_document
from rbpsym.teaching.papers.letters import printable
from rbpsym.teaching.papers.naming import file_stem


def export_latex(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One source a student; with keys also a key and, if asked for, a solution each."""
    files: dict[str, str] = {}
    for worksheet in (printable(worksheet, "pdflatex") for worksheet in worksheets):
        stem = file_stem(worksheet)
        files[f"{stem}.tex"] = write_paper(paper_document(worksheet), worksheet)
        if options.key:
            files[f"keys/{stem}-key.tex"] = write_paper(key_document(worksheet), worksheet, is_key=True)
        if options.solution and options.derivations:
            document = solution_document(worksheet, options.derivations)
            files[f"keys/{stem}-solution.tex"] = write_paper(document, worksheet, is_key=True)
    return Exported(files)
