"""Text files that users give, read within a bound of size; what is wrong with one is told with its place."""

from __future__ import annotations

from pathlib import Path

from rbpsym.errors import LimitError, Place, ReadError


def text_in(path: Path, most: int, what: str, instead: str = "", *, of_sheets: bool = False) -> str:
    """The text of a file of at most so many bytes; `what` it is for messages. Raises ReadError or LimitError.

    It is UTF-8; programs for spreadsheets (`of_sheets`) write UTF-16 too.
    """
    try:
        check_size(path.stat().st_size, most, what, str(path))
        data = path.read_bytes()
        return data.decode("utf-16" if of_sheets and data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError as error:
        why, instead = f"it is not a text file (byte {error.start + 1} is not UTF-8)", "save it as UTF-8."
    except OSError as error:
        why = (error.strerror or "it can't be opened").lower()
    except ValueError:
        why = "this is no name of a file"
    raise ReadError(f"can't read {what}: {why}", instead=instead, place=Place(str(path)))


def latin_or_utf8_in(path: Path, most: int, what: str) -> tuple[str, bool]:
    """(the text of a file, whether it is UTF-8): what is not is read as Latin-1. Raises as `text_in`."""
    try:
        return text_in(path, most, what), True
    except ReadError:
        data = path.read_bytes() if path.is_file() else b""
        if not data or b"\0" in data:
            raise
        return data.decode("latin-1"), False


def check_size(size: int, most: int, what: str, file: str) -> None:
    """Raises LimitError if a text has too many bytes."""
    if size > most:
        raise LimitError(f"{what} is too large: {size} bytes, {most} are allowed", place=Place(file))
