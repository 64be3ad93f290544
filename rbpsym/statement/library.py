"""The problems that ship with rbpsym: the files in `derivations/`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from rbpsym.errors import LimitError, Place, ReadError

_PACKAGE = Path(__file__).resolve().parent.parent
_OTHER_KINDS = {"claims", "courses", "worksheets"}
_FOLDERS = (_PACKAGE / "_data" / "derivations", _PACKAGE.parent / "derivations")  # in a wheel, in a checkout


def library_folder() -> Path:
    """The folder of the shipped files, in an installed package or in a checkout."""
    return next((folder for folder in _FOLDERS if folder.is_dir()), _FOLDERS[-1])


def problem_files() -> dict[str, Path]:
    """The files of the library by the name of their problem: all but those of the other kinds' folders."""
    return dict(_problems_in(library_folder()))


@cache
def _problems_in(folder: Path) -> Mapping[str, Path]:
    """Looked for once: what ships does not change while the program runs."""
    files = (path for path in folder.rglob("*.toml") if not _OTHER_KINDS & set(path.relative_to(folder).parts[:-1]))
    return {path.stem: path for path in sorted(files, key=lambda path: path.stem)}


def course_files() -> dict[str, Path]:
    """The courses of the library by name."""
    return {path.stem: path for path in sorted((library_folder() / "courses").glob("*.toml"))}


def worksheet_files() -> dict[str, Path]:
    """The worksheets of the library by name."""
    return {path.stem: path for path in sorted((library_folder() / "worksheets").glob("*.toml"))}


def not_found(name: str, known: Iterable[str], what: str) -> ReadError:
    """The error for a name that nothing has; `what` tells what was looked for ("problem")."""
    near = get_close_matches(name, list(known), n=1, cutoff=0.6)
    if Path(name).is_dir():
        return ReadError(f"“{name}” is a folder", instead="give a file in it.", place=Place(name))
    hint = f"did you mean “{near[0]}”?" if near else "“rbpsym list” shows what ships; else give the path of a file."
    return ReadError(f"there is no {what} and no file “{name}”", instead=hint, place=Place(name))


def find_problem(name_or_file: str, folder: Path = Path()) -> Path:
    """The file of a problem, by its name in the library or by its path from a folder, of which “.toml” may be left out."""
    files = problem_files()
    if name_or_file in files:
        return files[name_or_file]
    for path in (folder / name_or_file, folder / f"{name_or_file}.toml"):
        if path.is_file():
            return path
    raise not_found(name_or_file, files, "problem")


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
