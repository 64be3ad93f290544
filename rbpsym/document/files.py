"""Files that are written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

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
