"""The problems that ship with rbpsym: the files in `derivations/`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from rbpsym.errors import Place, ReadError

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
