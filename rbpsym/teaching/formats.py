"""The table of formats: each exporter turns worksheets into files, and says what a format can't carry.

A new format is a module of `exports` with a function `(worksheets, options) -> Exported`, and an entry here.
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

# format -> (module, function); imported when asked for
EXPORTERS: Mapping[str, tuple[str, str]] = {
    "pdf": ("rbpsym.teaching.paper_files", "export_pdf"),
    "tex": ("rbpsym.teaching.paper_files", "export_latex"),
    "typ": ("rbpsym.teaching.paper_files", "export_typst"),
    "html": ("rbpsym.teaching.paper_files", "export_html"),
    "moodle": ("rbpsym.teaching.exports.moodle", "export_moodle"),
    "qti": ("rbpsym.teaching.exports.qti", "export_qti"),
    "canvas": ("rbpsym.teaching.exports.canvas", "export_canvas"),
    "prairielearn": ("rbpsym.teaching.exports.prairielearn", "export_prairielearn"),
    "gift": ("rbpsym.teaching.exports.gift", "export_gift"),
}


def exporter(name: str) -> Exporter:
    """The exporter of a format. Raises RbpsymError with the known ones."""
    if name not in EXPORTERS:
        raise RbpsymError(f"unknown format “{name}”", instead=f"known: {', '.join(EXPORTERS)}.")
    module, function = EXPORTERS[name]
    found: Exporter = getattr(import_module(module), function)
    return found
