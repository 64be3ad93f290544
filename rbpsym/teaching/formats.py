"""The table of formats: each exporter turns worksheets into files, and says what a format can't carry.

A new format is a module of `exports` with such a function `(worksheets, options) -> Exported`, and an entry here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field
from rbpsym.proof.step import Derivation
from rbpsym.teaching.model import Worksheet


class Options(Frozen):
    """key: write keys too; solution: and the worked solutions, from `derivations` (by problem);
    engine: what makes PDF ("typst" or "pdflatex"); studio: the address to which the codes on papers lead."""

    key: bool = False
    engine: str = "typst"
    solution: bool = False
    derivations: Mapping[str, Derivation] = field(default_factory=dict)
    studio: str = ""


class Exported(Frozen):
    """files: content by path within the output folder; left_out: a sentence for each thing that the
    format can't carry (never dropped silently)."""

    files: Mapping[str, str | bytes]
    left_out: tuple[str, ...] = field(default=())


Exporter = Callable[[tuple[Worksheet, ...], Options], Exported]

# format -> module with its function `export_<format>`; imported when asked for
EXPORTERS: Mapping[str, str] = {
    **dict.fromkeys(("pdf", "tex", "typ", "html"), "paper_files"),
    **{name: f"exports.{name}" for name in ("moodle", "qti", "canvas", "prairielearn", "gift")},
}


def exporter(name: str) -> Exporter:
    """The exporter of a format. Raises RbpsymError with the known ones."""
    if name not in EXPORTERS:
        raise RbpsymError(f"unknown format “{name}”", instead=f"known: {', '.join(EXPORTERS)}.")
    found: Exporter = getattr(import_module(f"rbpsym.teaching.{EXPORTERS[name]}"), f"export_{name}")
    return found
