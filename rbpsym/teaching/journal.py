"""The journal of a long run: what is done, one line a job, so that an interrupt loses nothing.

The first line says what the run is about; a journal of another run is put aside, not mixed in. A line
that was torn by a crash is dropped, and its job done again.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from types import TracebackType
from typing import BinaryIO

from rbpsym.errors import RbpsymError


class Journal:
    """Results by the place of their job. Without a path nothing is kept. Use it in a `with`."""

    def __init__(self, path: Path | None, about: str) -> None:
        self.path, self.about = path, about
        self.results: dict[int, str] = {}
        self._file: BinaryIO | None = None

    def __enter__(self) -> Journal:
        if self.path is not None:
            self._file = _opened(self.path)
            self._resume()
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def enter(self, results: dict[int, str]) -> None:
        """Note results; they are on the disk when this returns."""
        self.results.update(results)
        if self._file is not None:
            lines = (json.dumps([place, text], ensure_ascii=False) for place, text in results.items())
            self._file.write("".join(f"{line}\n" for line in lines).encode())
            self._file.flush()
            os.fsync(self._file.fileno())

    def remove(self) -> None:
        """Everything is written: the journal is not needed any more."""
        if self.path is not None:
            self.path.unlink(missing_ok=True)

    def _resume(self) -> None:
        assert self._file is not None
        head = (json.dumps({"about": self.about}) + "\n").encode()
        self._file.seek(0)
        if self._file.readline() != head:
            self._file.seek(0)
            self._file.truncate()
            self._file.write(head)
        self._read_lines()

    def _read_lines(self) -> None:
        """The results of whole lines; what follows them is cut off."""
        good = self._file.tell()
        for line in self._file:
            entry = _entry(line)
            if entry is None:
                break
            self.results[entry[0]] = entry[1]
            good += len(line)
        self._file.seek(good)
        self._file.truncate()


def _entry(line: bytes) -> tuple[int, str] | None:
    if not line.endswith(b"\n"):
        return None
    try:
        place, text = json.loads(line)
    except (ValueError, TypeError):
        return None
    return (place, text) if isinstance(place, int) and isinstance(text, str) else None


def _opened(path: Path) -> BinaryIO:
    """The journal, locked against a second run. Raises RbpsymError."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        file = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT, 0o600), "r+b")
    except OSError as error:
        raise RbpsymError(f"can't write {path}: {error.strerror}", instead="choose another folder with -o.") from error
    try:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except ImportError:
        pass
    except OSError:
        file.close()
        raise RbpsymError(f"another run works on {path.name} now", instead="wait until it ends, or stop it.") from None
    return file
