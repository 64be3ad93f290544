"""Files that are written whole or not at all, the data that ship, and packages that only some formats need."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

from rbpsym.errors import RbpsymError


def write_whole(path: Path, content: str | bytes) -> Path:
    """Write `content` beside `path`, then rename: a reader never meets half a file."""
    data = content.encode() if isinstance(content, str) else content
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    except OSError as error:
        raise not_written(path, error) from error
    try:
        fill(handle, data)
        os.replace(name, path)
    except OSError as error:
        raise not_written(path, error) from error
    finally:
        with suppress(FileNotFoundError):
            os.unlink(name)
    return path


def write_all(folder: Path, contents: Mapping[str, str | bytes]) -> list[Path]:
    """Write files into a folder, each of them whole."""
    return [write_whole(folder / name, content) for name, content in contents.items()]


def fill(handle: int, data: bytes) -> None:
    """Write the data to an open handle, readable as any new file would be."""
    mask = os.umask(0)
    os.umask(mask)
    with os.fdopen(handle, "wb") as file:
        os.fchmod(file.fileno(), 0o666 & ~mask)
        file.write(data)


def not_written(path: Path, error: OSError) -> RbpsymError:
    """The sentence for a file that can't be written."""
    why = error.strerror or str(error)
    return RbpsymError(f"can't write {path}: {why}", instead="choose another folder with -o.")


# --- where the files live that are data and not code: templates and derivations


PACKAGE = Path(__file__).resolve().parents[1]


@cache
def data_folder(name: str) -> Path:
    """The folder `name` in an installed wheel (rbpsym/_data) or in the checkout."""
    for folder in (PACKAGE / "_data" / name, PACKAGE.parent / name):
        if folder.is_dir():
            return folder
    raise RbpsymError(f"the folder “{name}” of rbpsym is missing", instead="install rbpsym again with pip.")


# --- packages that only some formats need: met late, and missed with a sentence that says what to install


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
