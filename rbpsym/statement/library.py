"""The problems that ship with rbpsym: the files in `derivations/`."""

from __future__ import annotations

from pathlib import Path

from rbpsym.errors import Place, ReadError
from rbpsym.statement.source import did_you_mean

_PACKAGE = Path(__file__).resolve().parent.parent
_OTHER_KINDS = {"claims", "courses", "worksheets"}
_FOLDERS = (_PACKAGE / "_data" / "derivations", _PACKAGE.parent / "derivations")  # in a wheel, in a checkout


def library_folder() -> Path:
    """The folder of the shipped files, in an installed package or in a checkout."""
    return next((folder for folder in _FOLDERS if folder.is_dir()), _FOLDERS[-1])


def problem_files() -> dict[str, Path]:
    """The files of the library by the name of their problem: all but those of the other kinds' folders."""
    files = (path for path in library_folder().rglob("*.toml") if _is_problem(path))
    return {path.stem: path for path in sorted(files, key=lambda path: path.stem)}


def _is_problem(path: Path) -> bool:
    return not _OTHER_KINDS & set(path.relative_to(library_folder()).parts[:-1])


def course_files() -> dict[str, Path]:
    """The courses of the library by name."""
    return {path.stem: path for path in sorted((library_folder() / "courses").glob("*.toml"))}


def find_problem(name_or_file: str) -> Path:
    """The file of a problem, by its name in the library or by its path."""
    files = problem_files()
    if name_or_file in files:
        return files[name_or_file]
    path = Path(name_or_file)
    if path.is_file():
        return path
    hint = did_you_mean(name_or_file, files, "problems in the library")
    raise ReadError(f"there is no problem and no file “{name_or_file}”", instead=hint, place=Place(name_or_file))
