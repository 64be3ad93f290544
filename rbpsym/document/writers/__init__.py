"""One writer a format; each prints the same document tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

from rbpsym.document.model import Document, DocumentError

Writer = Callable[..., "str | bytes"]  # of a document

# format -> (module, function); imported when asked for
WRITERS: Mapping[str, tuple[str, str]] = {
    "tex": ("rbpsym.document.writers.latex", "write_latex"),
    "beamer": ("rbpsym.document.writers.slides", "write_slides"),
    "typ": ("rbpsym.document.writers.typst", "write_typst"),
    "html": ("rbpsym.document.writers.html", "write_html"),
    "pdf": ("rbpsym.document.writers.pdf", "write_pdf"),
    "md": ("rbpsym.document.writers.markdown", "write_markdown"),
    "ipynb": ("rbpsym.document.writers.notebook", "write_notebook"),
    "docx": ("rbpsym.document.writers.word", "write_word"),
}


def writer(format_name: str) -> Writer:
    """The writer of a format. Raises DocumentError with the known ones."""
    if format_name not in WRITERS:
        known = ", ".join(WRITERS)
        raise DocumentError(f"unknown format “{format_name}”", instead=f"known: {known}.")
    module, name = WRITERS[format_name]
    found: Writer = getattr(import_module(module), name)
    return found


Files = Callable[[Document, str], "Mapping[str, str | bytes]"]

# format -> (module, function) of those that are more than one file, or are called otherwise
SEVERAL: Mapping[str, tuple[str, str]] = {
    "md": ("rbpsym.document.writers.markdown", "markdown_files"),
    "beamer": ("rbpsym.document.writers.slides", "slides_files"),
}


def files(document: Document, format_name: str, stem: str, engine: str = "typst") -> Mapping[str, str | bytes]:
    """The files of a document in a format, by the names that they should have; `engine` makes the PDF."""
    if format_name in SEVERAL:
        module, name = SEVERAL[format_name]
        several: Files = getattr(import_module(module), name)
        return several(document, stem)
    write = writer(format_name)
    content = write(document, engine) if format_name == "pdf" else write(document)
    return {f"{stem}.{format_name}": content}
