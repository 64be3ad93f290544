"""A problem from a TOML file or text.

Grammar: the keys of a file are those of `assemble.SECTIONS`; the kinds stand in `shapes`,
`interactions` and `constraints`. `rbpsym.statement.build` makes the same from Python.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path

from rbpsym.errors import LimitError, Place, ReadError
from rbpsym.statement.assemble import assemble
from rbpsym.statement.library import check_size, problem_files, text_in
from rbpsym.statement.model import Problem
from rbpsym.statement.positions import index_positions, place_at
from rbpsym.statement.source import Source, SourceTable, check_characters, kind_of

MAX_BYTES = 64 * 1024
WHAT = "the problem file"
MAX_DEPTH = 12


def load_problem(path_or_text: str | Path) -> Problem:
    """The problem in a file, in a text (a str of more than one line), or the one of that name that ships."""
    if isinstance(path_or_text, str) and "\n" in path_or_text:
        return load_text(path_or_text)
    if not isinstance(path_or_text, (str, PathLike)):
        what = f"the name of a problem is a text or a path, not {kind_of(path_or_text)}"
        raise ReadError(what, instead='write load_problem("my-problem.toml"), or the name of one that ships.')
    path = Path(path_or_text)
    if _ships(path):
        path = problem_files()[str(path_or_text)]
    return load_text(_content(path, MAX_BYTES), file=str(path), name=path.stem)


def _ships(path: Path) -> bool:
    """Whether a bare name is one of the library's, and of no file."""
    return not path.suffix and len(path.parts) == 1 and not path.exists() and str(path) in problem_files()


def load_text(text: str, file: str = "", name: str = "") -> Problem:
    """The problem in a TOML text; `file` is what errors call it."""
    table = table_of(text, file)
    return replace(assemble(table, name or Path(file).stem or "problem"), text=table.source.text)


def table_of(text: str, file: str = "", most: int = MAX_BYTES) -> SourceTable:
    """A TOML text as a table that knows its places, within the bounds of size and depth."""
    text = text.removeprefix("\ufeff").replace("\r\n", "\n")
    check_size(len(text.encode("utf-8", "surrogatepass")), most, WHAT, file)
    data = _parse(text, file)
    _check_depth(data, file)
    table = SourceTable(Source(file, index_positions(text)), (), data)
    check_characters(table)
    return table


def load_table(path: Path, most: int = MAX_BYTES) -> SourceTable:
    """The table in a TOML file."""
    return table_of(_content(path, most), str(path), most)


def _content(path: Path, most: int) -> str:
    return text_in(path, most, WHAT, "give the name of a problem file (.toml); “rbpsym new” writes one to start from.")


def _check_depth(data: object, file: str, depth: int = 0) -> None:
    if depth > MAX_DEPTH:
        raise LimitError(f"tables and lists are nested more than {MAX_DEPTH} deep", place=Place(file))
    for part in data.values() if isinstance(data, Mapping) else data if isinstance(data, list) else ():
        _check_depth(part, file, depth + 1)


# --- TOML that is none

_FAULTS: tuple[tuple[str, str, str], ...] = (
    (r"Expected '=' after a key", "a key must be followed by “=” and its value", 'write key = "value"'),
    (r"Invalid value", "this is not a value", 'put expressions in quotes: mass = "M"'),
    (r"Unterminated string|Illegal character '\\n'", "a quote is missing at the end of this text", 'end it with "'),
    (
        r"Expected newline or end of document",
        "there is something after the value",
        "write one key = value a line; put the whole expression in quotes.",
    ),
    (r"Cannot declare .* twice", "this table is there already", "join the two tables, or rename one."),
    (
        r"Cannot overwrite a value|Duplicate inline table key|Cannot mutate",
        "this key is there already",
        "remove one of the two, or rename it.",
    ),
    (r"Unclosed array", "a list is not closed", "end it with ]"),
    (r"Unclosed inline table", "a table in braces is not closed on its line", "end it with }"),
    (r"Invalid initial character for a key", "a key must begin here", "a key is letters, digits, “_” and “-”."),
    (r"Expected '\]", "the name of the table is not closed", "write [name] or [[name]]"),
    (r"Unescaped '\\'|hex|unicode", "a backslash in double quotes starts an escape", "use single quotes, or \\\\."),
    (r"Invalid statement", "a line must be a [table] or key = value", ""),
    (r"Illegal character|invalid character", "a character that can't stand in a TOML file", ""),
)
_AT = re.compile(r" \(at (?:line (\d+), column (\d+)|end of document)\)$")


def _parse(text: str, file: str) -> dict[str, object]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _syntax_error(str(error), text, file) from None
    except RecursionError:
        raise LimitError(f"tables and lists are nested more than {MAX_DEPTH} deep", place=Place(file)) from None
    except ValueError as error:  # dates that don't exist, numbers with too many digits
        raise ReadError(f"not a value that can be read: {error}", place=Place(file)) from None


def _syntax_error(message: str, text: str, file: str) -> ReadError:
    found = _AT.search(message)
    fault = message[: found.start()] if found else message
    what, instead = next(((what, hint) for pattern, what, hint in _FAULTS if re.search(pattern, fault)), (fault, ""))
    return ReadError(what, instead=instead, place=_syntax_place(found, fault, text, file))


def _syntax_place(found: re.Match[str] | None, fault: str, text: str, file: str) -> Place:
    """Where the fault is; of a repeated key or table, the beginning of its line."""
    if found is None or found[1] is None:
        return place_at(file, text, len(text.rstrip()))
    line, column = int(found[1]), int(found[2])
    start = sum(len(row) + 1 for row in text.split("\n")[: line - 1])
    row = text[start:].split("\n", 1)[0]
    if re.match("Cannot|Duplicate", fault):
        return place_at(file, text, start, len(row.split("=")[0].rstrip()))
    behind = 2 if fault.startswith("Unescaped") else 0  # tomllib tells the place after the escape
    return place_at(file, text, start + min(column - 1 - behind, len(row)), 1 + behind // 2)
