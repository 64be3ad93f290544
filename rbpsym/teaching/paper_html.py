"""HTML papers that check themselves, one file a student."""

from __future__ import annotations

from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.html_paper import write_html
from rbpsym.teaching.papers.naming import file_stem


def export_html(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """One page a student; each holds its key behind a fold, so it is for practice, not for marks."""
    return Exported({f"{file_stem(worksheet)}.html": write_html(worksheet) for worksheet in worksheets})
