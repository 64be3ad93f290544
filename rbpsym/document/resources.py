"""Where the files live that are data and not code: templates and derivations."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rbpsym.errors import RbpsymError

PACKAGE = Path(__file__).resolve().parents[1]


@cache
def data_folder(name: str) -> Path:
    """The folder `name` in an installed wheel (rbpsym/_data) or in the checkout."""
    for folder in (PACKAGE / "_data" / name, PACKAGE.parent / name):
        if folder.is_dir():
            return folder
    raise RbpsymError(f"the folder “{name}” of rbpsym is missing", instead="install rbpsym again with pip.")
