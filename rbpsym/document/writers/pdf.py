"""PDF: by the Typst wheel (nothing else is needed), or by pdflatex where TeX is installed."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from rbpsym.document.model import Document, DocumentError
from rbpsym.errors import RbpsymError


def write_pdf(document: Document, engine: str = "typst") -> bytes:
    """The document as a PDF file. Raises RbpsymError if the engine is unknown or missing."""
    if engine not in ENGINES:
        known = ", ".join(ENGINES)
        raise DocumentError(f"unknown PDF engine “{engine}”", instead=f"known: {known}.")
    return ENGINES[engine](document)


def by_typst(document: Document) -> bytes:
    """Tagged PDF (PDF/UA-1): formulas and figures carry their spoken form."""
    from rbpsym.document.writers.typst import write_typst

    return readable_aloud(write_typst(document))


def readable_aloud(source: str) -> bytes:
    """The PDF/UA-1 of a Typst source; a character that no font shows is told by its name."""
    import typst

    from rbpsym.document.writers.rare_letters import without_lacking

    source = without_last_lines(source)
    while True:
        try:
            return typst.compile(source.encode(), pdf_standards=["ua-1"])
        except typst.TypstError as complaint:
            changed = without_lacking(source, str(complaint))
            if changed is None:
                raise
            source = changed


FEW = 0.4  # of the height of a page, its margin too: what stands on a last page that is not worth turning to


def without_last_lines(source: str) -> str:
    """The source set a little closer, where that saves a last page of a few lines."""
    closer = source.replace("#let closer = false", "#let closer = true", 1)
    pages, filled = end_of(source)
    return closer if pages > 1 and filled < FEW and end_of(closer)[0] < pages else source


def end_of(source: str) -> tuple[int, float]:
    """On which page the text ends, and where on it."""
    import typst

    page, place = json.loads(typst.query(source.encode(), "<the-end>", field="value", one=True))
    return page, place


def by_pdflatex(document: Document) -> bytes:
    """Three passes at most: references settle in the second, page breaks in the third."""
    from rbpsym.document.writers.latex import write_latex

    if not has_pdflatex():
        raise RbpsymError("pdflatex is not installed", instead="leave out --engine: Typst needs no TeX.")
    return compiled(write_latex(document))


def has_pdflatex() -> bool:
    """Is TeX installed?"""
    return shutil.which("pdflatex") is not None


def compiled(source: str) -> bytes:
    """The PDF of a LaTeX source. Raises RbpsymError with TeX's own sentence."""
    with tempfile.TemporaryDirectory(prefix="rbpsym-") as name:
        folder = Path(name)
        (folder / "notes.tex").write_text(source, encoding="utf-8")
        for _ in range(3):
            log = run_once(folder)
            if "Rerun to get" not in log:
                break
        return (folder / "notes.pdf").read_bytes()


def run_once(folder: Path) -> str:
    """One pass; its log."""
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape"]
    done = subprocess.run([*command, "notes.tex"], cwd=folder, capture_output=True, timeout=120, check=False)
    log = done.stdout.decode("utf-8", "replace")
    if done.returncode:
        raise RbpsymError(f"pdflatex stopped: {complaint(log)}")
    return log


def complaint(log: str) -> str:
    """The first error of a log, with the line it points at."""
    lines = log.splitlines()
    starts = [place for place, line in enumerate(lines) if line.startswith("!")]
    return " ".join(lines[starts[0] : starts[0] + 4]) if starts else lines[-1] if lines else "?"


ENGINES: Mapping[str, Callable[[Document], bytes]] = {
    "typst": by_typst,
    "pdflatex": by_pdflatex,
}
