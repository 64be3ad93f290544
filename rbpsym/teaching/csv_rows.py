"""Tables in CSV files as spreadsheets save them: decoded, and cut into rows; what is wrong is told with its place."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator

from rbpsym.errors import Place, ReadError

HINT = "Save it as CSV UTF-8."
LONGEST_CELL = 20_000


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
