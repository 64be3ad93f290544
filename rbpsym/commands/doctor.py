"""`rbpsym doctor`: what is found on this machine, and what each thing gives."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterator, Mapping

import click

from rbpsym.typeset.escaping import columns, padded

# distribution -> (what it gives, how one gets it); the first are required
PACKAGES: Mapping[str, tuple[str, str]] = {
    "sympy": ("sympy in and out", "pip install sympy"),
    "python-flint": ("fast factors and common divisors; sympy finds them without it", "pip install python-flint"),
    "scipy": ("the numerical oracle through phases", "pip install scipy"),
    "typst": ("PDF and pictures", "pip install typst"),
    "python-docx": ("notes and worksheets for Word", "pip install 'rbpsym[docx]'"),
    "distributed": ("worksheets for thousands on several machines", "pip install 'rbpsym[cluster]'"),
}
PROGRAMS: Mapping[str, tuple[str, str]] = {
    "pdflatex": ("PDF by LaTeX (--engine pdflatex); Typst makes it without", "a TeX distribution"),
    "coqc": ("certify: each step proved anew by Rocq", "the package coq with coquelicot"),
}


@click.command("doctor")
def command() -> None:
    """Say what is found on this machine, and what each thing gives or would give.

    \b
    Examples:
      rbpsym doctor

    Nothing here is needed for more than what is said beside it.
    """
    version = ".".join(map(str, sys.version_info[:3]))
    rows = [("✓", "Python", version, "everything"), *packages(), *programs()]
    widths = [max(map(columns, cells)) for cells in zip(*rows, strict=True)]
    for row in rows:
        click.echo("  ".join(map(padded, row, widths)).rstrip())


def packages() -> Iterator[tuple[str, ...]]:
    """A row for each package of Python."""
    from importlib.metadata import PackageNotFoundError, version

    for name, (gives, get) in PACKAGES.items():
        try:
            yield "✓", name, version(name), gives
        except PackageNotFoundError:
            yield "–", name, "not found", f"{gives}: {get}"


def programs() -> Iterator[tuple[str, ...]]:
    """A row for each program."""
    for name, (gives, get) in PROGRAMS.items():
        place = shutil.which(name)
        yield ("✓", name, place, gives) if place else ("–", name, "not found", f"{gives}: {get}")
