"""Packages that only some formats need: met late, and missed with a sentence that says what to install."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from types import ModuleType

from rbpsym.errors import RbpsymError

# module -> (package, the extra of rbpsym that brings it)
EXTRAS: Mapping[str, tuple[str, str]] = {
    "docx": ("python-docx", "docx"),
}


def extra(module: str) -> ModuleType:
    """The module, or one inside it. Raises RbpsymError with the line that installs it."""
    package, name = EXTRAS[module.partition(".")[0]]
    try:
        return import_module(module)
    except ImportError as error:
        raise RbpsymError(f"{package} is not installed", instead=f"pip install 'rbpsym[{name}]' brings it.") from error
