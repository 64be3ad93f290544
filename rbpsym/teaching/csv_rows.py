"""Tables in CSV files as spreadsheets save them: decoded, and cut into rows; what is wrong is told with its place."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path

from rbpsym.errors import Place, ReadError

HINT = "Save it as CSV UTF-8."
LONGEST_CELL = 20_000


def text_in(path: Path, most: int) -> str:
    """The text of a file of at most so many bytes. Raises ReadError."""
    try:
        if path.stat().st_size > most:
            raise ReadError(f"{path} has more than {most // 2**20} MiB", instead="Split it.")
        data = path.read_bytes()
    except OSError as error:
        why = error.strerror or "it can't be read"
        raise ReadError(f"can't read {path}: {why}", instead="Give the path of a CSV file.") from error
    try:
        return data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise ReadError(f"{path} is no UTF-8 text (byte {error.start})", instead=HINT) from None


def rows_in(text: str, file: str) -> Iterator[tuple[int, list[str]]]:
    """(line, cells) of all rows that hold something; commas, semicolons or tabs part them. Raises ReadError."""
    mark = max(",;\t", key=text.split("\n", 1)[0].count)
    csv.field_size_limit(2**30)
    reader = csv.reader(io.StringIO(text.replace("\x00", "\ufffd"), newline=""), delimiter=mark)
    try:
        for cells in reader:
            if any(cell.strip() for cell in cells):
                yield reader.line_num, [cell[:LONGEST_CELL] for cell in cells]
    except csv.Error as error:
        raise ReadError(f"this is no CSV: {error}", instead=HINT, place=Place(file, reader.line_num)) from None
