"""Languages: each folder here is one, a file for the texts of notes, of worksheets, of the studio and of the library, and one
for the words with which answers are typed.

Nothing else lists them. A text is known by its dotted key, but for those of the library and of worded files, which are in
English: as in gettext, the English text is the key.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import TypeVar

from rbpsym.errors import RbpsymError

FOLDER = Path(__file__).parent
T = TypeVar("T")


def languages() -> tuple[str, ...]:
    """The codes of all languages."""
    return tuple(sorted(path.parent.name for path in FOLDER.glob("*/notes.toml")))


def phrases(language: str, part: str = "notes") -> Mapping[str, str]:
    """The texts of one file of a language by dotted key. Raises RbpsymError for a language that is not there."""
    found = _read(FOLDER / language / f"{part}.toml")
    if not found and language not in languages():  # looked for in the folder, which takes its time
        raise RbpsymError(f"there are no phrases in “{language}”", instead=f"languages: {', '.join(languages())}.")
    return found


@cache
def _read(path: Path) -> Mapping[str, str]:
    return dict(flatten("", tomllib.loads(path.read_text(encoding="utf-8")))) if path.is_file() else {}


def flatten(prefix: str, table: Mapping[str, object]) -> Iterator[tuple[str, str]]:
    """The leaves of a nested table with their dotted keys."""
    for name, value in table.items():
        if isinstance(value, Mapping):
            yield from flatten(f"{prefix}{name}.", value)
        else:
            yield f"{prefix}{name}", str(value)


def part_of(table: str, language: str, part: str = "notes") -> dict[str, str]:
    """The entries of one table of a file."""
    prefix = f"{table}."
    return {key.removeprefix(prefix): text for key, text in phrases(language, part).items() if key.startswith(prefix)}


def in_any(key: str, part: str = "answers") -> str:
    """What stands under a key in all languages, as alternatives of a pattern."""
    return "|".join(phrases(language, part)[key] for language in languages() if key in phrases(language, part))


def worded(text: str, language: str) -> str:
    """What an author said in English, if the language knows it from the library; else as it is.

    >>> worded("a text of one's own", "es")
    "a text of one's own"
    """
    return _read(FOLDER / language / "library.toml").get(text, text)


def in_language(told: Mapping[str, T], language: str, none: T) -> T:
    """What is told in a language, else in English, else in any."""
    return told.get(language) or told.get("en") or next(iter(told.values()), none)


def title_in(titles: Mapping[str, str], language: str) -> str:
    """A text in a language, else what is said of it in English as the library's words have it."""
    return worded(in_language(titles, language, ""), language)
