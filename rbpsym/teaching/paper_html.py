"""HTML papers, one file a student; with keys also one that checks itself."""

from __future__ import annotations

from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.html_paper import write_html
from rbpsym.teaching.papers.naming import file_stem


def export_html(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One page a student without any answer; with keys also one for practice, which holds them behind folds."""
    files: dict[str, str] = {}
    for worksheet in worksheets:
        stem = file_stem(worksheet)
        files[f"{stem}.html"] = write_html(worksheet)
        if options.key:
            files[f"keys/{stem}-key.html"] = write_html(worksheet, is_key=True)
    return Exported(files)
