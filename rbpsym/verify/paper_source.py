"""The text of a LaTeX file with the files it inputs, comments taken out, every character's line known."""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass
from pathlib import Path

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError

MAX_BYTES = 4 * 1024 * 1024
MAX_LINE = 200_000
MAX_FILES = 100
_INPUT = re.compile(r"\\(?:input|include)(?![A-Za-z])\s*(?:\{([^{}\n]*)\}|([\w./-]+))")
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%.*")
_VERBATIM = re.compile(r"\\begin\{(verbatim\*?|comment|lstlisting)\}.*?\\end\{\1\}|\\verb\*?([^A-Za-z\s*]).*?\2", re.S)


@dataclass(frozen=True, slots=True)
class Text:
    """A text; `starts` and `origins` tell from which offset on it is which line of which file."""

    text: str
    starts: tuple[int, ...]
    origins: tuple[tuple[str, int], ...]

    def origin(self, offset: int) -> tuple[str, int]:
        """(file, line) of a character."""
        place = bisect_right(self.starts, offset) - 1
        return self.origins[max(place, 0)] if self.origins else ("", 1)

    def place(self, offset: int) -> Place:
        """The place of a character, for an error."""
        file, line = self.origin(offset)
        start = self.text.rfind("\n", 0, offset) + 1
        shown = self.text[start:].split("\n", 1)[0][:200]
        column = offset - start + 1
        return Place(file, line, column, shown if column <= 200 else "")


def read_source(path: Path) -> Text:
    """The text of a file. Raises ReadError or LimitError with the place of what can't be read."""
    lines = list(_lines(path, path.resolve().parent, (), [0]))
    starts, offset = [], 0
    for text, _, _ in lines:
        starts.append(offset)
        offset += len(text) + 1
    whole = "\n".join(text for text, _, _ in lines)
    whole = _VERBATIM.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), whole)
    return Text(whole, tuple(starts), tuple((file, number) for _, file, number in lines))


def _lines(path: Path, folder: Path, around: tuple[Path, ...], size: list[int]):
    """(text, file, number) of each line, inputs put in; `size` counts the bytes of all files."""
    for number, raw in enumerate(_content(path, size).split("\n"), 1):
        if len(raw) > MAX_LINE:
            raise LimitError(f"a line of more than {MAX_LINE} characters", place=Place(str(path), number))
        line = _COMMENT.sub(r"\1", raw)
        begin = 0
        for found in _INPUT.finditer(line):
            yield line[begin : found.start()], str(path), number
            inner = _beside(found, path, folder, number, around)
            yield from _lines(inner, folder, (*around, path.resolve()), size)
            begin = found.end()
        yield line[begin:], str(path), number


def _content(path: Path, size: list[int]) -> str:
    try:
        size[0] += path.stat().st_size
        if size[0] > MAX_BYTES:
            raise LimitError(f"the text is larger than {MAX_BYTES} bytes", place=Place(str(path)))
        return path.read_bytes().decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        what = f"byte {error.start + 1} is not UTF-8; save it as UTF-8"
    except OSError as error:
        what = (error.strerror or "it can't be opened").lower()
    except ValueError:
        what = "no name of a file"
    raise ReadError(f"can't read {path.name}: {what}", place=Place(str(path)))


def _beside(found: re.Match[str], path: Path, folder: Path, line: int, around: tuple[Path, ...]) -> Path:
    r"""The file of an \input, which must be in the folder of the text or below it."""
    name = (found[1] if found[1] is not None else found[2]).strip()
    place = Place(str(path), line, found.start() + 1)
    try:
        target = _existing(folder, name)
    except (OSError, ValueError):
        raise ReadError(f"“{name[:60]}” is no name of a file", place=place) from None
    _check_inside(target, folder, name, place)
    if target in around or target == path.resolve():
        raise ReadError(f"“{name}” inputs itself", place=place)
    if len(around) >= MAX_FILES:
        raise LimitError(f"more than {MAX_FILES} files are nested", place=place)
    if not target.is_file():
        raise ReadError(f"there is no file “{name}” beside the text", place=place)
    return target


def _existing(folder: Path, name: str) -> Path:
    plain, tex = folder / name, folder / f"{name}.tex"
    return (plain if plain.is_file() else tex).resolve()


def _check_inside(target: Path, folder: Path, name: str, place: Place) -> None:
    if not target.is_relative_to(folder):
        raise ReadError(
            f"“{name[:60]}” is outside the folder of the text", instead="only files beside it are read.", place=place
        )


def told_at(error: RbpsymError, text: Text, offset: int) -> RbpsymError:
    """The error of a reader of a formula, told in the file's line."""
    file, line = text.origin(offset)
    inner = error.place or Place(column=1)
    below = max(inner.line, 1) - 1
    return type(error)(
        error.what, instead=error.instead, place=Place(file, line + below, inner.column, inner.text, inner.width)
    )
