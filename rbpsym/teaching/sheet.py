"""A worksheet file: which problems, which tasks, which numbers. Grammar: docs/worksheets.md.

Errors tell the place with a caret, as those of problem files do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from pathlib import Path

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, table_of
from rbpsym.statement.model import Problem
from rbpsym.statement.source import SourceItem, Table, did_you_mean, kind_of
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.ranges import NumberRange, numbers_in
from rbpsym.teaching.tasks.registry import TASKS
from rbpsym.teaching.tasks.wish import Wish
from rbpsym.teaching.wording import languages

SHEET_KEYS = ("title", "language", "introduction", "problem")
PROBLEM_KEYS = ("name", "file", "numbers", "task")
TASK_KEYS = ("kind", "about", "number", "level", "points", "options", "answers", "misconceptions")
ANSWERS = ("formula", "number")
LEVELS = (0, 1, 2, 3)
MOST_ITEMS, MOST_POINTS = 40, 1000


class SheetPart(Frozen):
    """One [[problem]] of a worksheet: the problem, the wishes for its numbers, and its tasks."""

    problem: Problem
    numbers: Mapping[str, NumberRange]
    wishes: tuple[Wish, ...]
    at: SourceItem | None = field(default=None, compare=False, repr=False)

    def error(self, error: RbpsymError) -> RbpsymError:
        """An error about its numbers, told where the problem stands in the file."""
        return error if self.at is None else self.at.error(error.what, error.instead)


class Sheet(Frozen):
    """A worksheet as its author wrote it. `text` stands for all that it is made of, its problems included."""

    name: str
    title: Mapping[str, str]
    parts: tuple[SheetPart, ...]
    language: str = "en"
    introduction: Mapping[str, str] = field(default_factory=dict)
    text: str = ""


def is_sheet(table: Table) -> bool:
    """Whether a file is a worksheet (and not a problem): it lists problems."""
    return "problem" in table


def sheet_of_text(text: str, name: str = "worksheet") -> Sheet:
    """The worksheet in a text; files of problems are looked for in the current folder."""
    return sheet_of(table_of(text, name), name, Path())


def sheet_of(table: Table, name: str, folder: Path) -> Sheet:
    """The worksheet in a table."""
    table.check_keys(SHEET_KEYS, "a worksheet")
    table.require("problem", "the worksheet", 'add [[problem]] with name = "..." and [[problem.task]] below it')
    parts = tuple(_part(row, folder) for row in _rows(table, "problem", "[[problem]]"))
    text = "\x00".join([table.source.index.text if table.source.index else "", *(part.problem.text for part in parts)])
    title = _texts(table, "title") or dict(parts[0].problem.title)
    return Sheet(name, title, parts, _language(table), _texts(table, "introduction"), text)


def _language(table: Table) -> str:
    found = table.string("language", "en")
    if found not in languages():
        raise table.value_error("language", f"there are no worksheets in “{found}”", did_you_mean(found, languages()))
    return found


def _texts(table: Table, key: str) -> dict[str, str]:
    """A text, or a text for each language."""
    if key not in table:
        return {}
    value = table.data[key]
    if isinstance(value, str):
        return dict.fromkeys(languages(), value)
    if not isinstance(value, Mapping):
        raise table.value_error(
            key,
            f"“{key}” must be a text, not {kind_of(value)}",
            f'write {key} = "..." or {key} = {{ en = "...", es = "..." }}',
        )
    inner = table.table(key, key)
    inner.check_keys(languages(), f"the languages of “{key}”")
    return {language: inner.string(language) for language in inner.names()}


def _rows(table: Table, key: str, written: str) -> list[Table]:
    """The tables of a list, at least one."""
    value = table.data[key]
    if not isinstance(value, (list, tuple)) or not value or not all(isinstance(row, Mapping) for row in value):
        raise table.error(
            f"“{key}” must be one or more tables", f"write {written} with two brackets, once for each", key
        )
    return table.rows(key, key)


def _part(row: Table, folder: Path) -> SheetPart:
    row.check_keys(PROBLEM_KEYS, "a problem of a worksheet")
    problem = _problem(row, folder)
    row.require("task", f"“{problem.name}”", 'add [[problem.task]] with kind = "choose"')
    wishes = tuple(wish for task in _rows(row, "task", "[[problem.task]]") for wish in _wishes(task))
    if not isinstance(row.data.get("numbers", {}), Mapping):
        raise row.error("the numbers of a problem are one table", "write [problem.numbers] below it", "numbers")
    numbers = dict(numbers_in(row.table("numbers", "[problem.numbers]"), problem))
    return SheetPart(problem, numbers, wishes, row.item("numbers" if numbers else "name" if "name" in row else "file"))


def _problem(row: Table, folder: Path) -> Problem:
    """By its name in the library, or a file beside the worksheet."""
    if ("name" in row) == ("file" in row):
        raise row.error(
            "a problem is named or its file is given, one of both", 'write name = "sliding-..." or file = "my.toml"'
        )
    try:
        if "name" in row:
            return load_problem(find_problem(row.string("name")))
        return load_problem(folder / row.string("file"))
    except RbpsymError as error:
        if error.place is not None and error.place.line:
            raise
        raise row.value_error("name" if "name" in row else "file", error.what, error.instead) from None


# --- tasks


ONLY_FOR: Mapping[str, tuple[str, ...]] = {
    "options": ("choose",),
    "answers": ("choose",),
    "misconceptions": ("find-the-slip",),
    "about": tuple(kind for kind in TASKS if kind != "signs"),
}


def _wishes(row: Table) -> Iterator[Wish]:
    """A task; a list of levels makes a task of each, from one quantity to the next."""
    row.check_keys(TASK_KEYS, "a task")
    row.require("kind", "the task", f'write kind = "{next(iter(TASKS))}" or another of {", ".join(TASKS)}')
    kind = row.string("kind")
    if kind not in TASKS:
        raise row.value_error("kind", f"there is no kind of task “{kind}”", did_you_mean(kind, TASKS, "kinds"))
    for key, kinds in ONLY_FOR.items():
        if key in row and kind not in kinds:
            raise row.error(f"“{key}” has no meaning for {kind}", f"leave it out; it is for {', '.join(kinds)}", key)
    for level in _levels(row):
        yield _wish(row, kind, level)


def _wish(row: Table, kind: str, level: int) -> Wish:
    return Wish(
        kind,
        _strings(row, "about"),
        row.whole("number", 1, 1, MOST_ITEMS),
        level,
        _points(row),
        row.whole("options", 4, 2, 6),
        row.choice("answers", ANSWERS, "formula"),
        _misconceptions(row),
        row.item("kind"),
    )


def _levels(row: Table) -> list[int]:
    """One level, or several in a list."""
    value = row.data.get("level", 1)
    found = list(value) if isinstance(value, (list, tuple)) else [value]
    if not found or any(isinstance(one, bool) or one not in LEVELS for one in found):
        raise row.value_error(
            "level",
            "“level” must be a whole number from 0 (much help) to 3 (none), or a list of these",
            "write level = 1",
        )
    return found


def _strings(row: Table, key: str) -> tuple[str, ...]:
    """A text or a list of texts."""
    value = row.data.get(key, ())
    if isinstance(value, str):
        return (value,)
    if (
        not isinstance(value, (list, tuple))
        or (key in row and not value)
        or not all(isinstance(item, str) for item in value)
    ):
        raise row.value_error(key, f"“{key}” must be a text or a list of texts", f'write {key} = ["..."]')
    return tuple(value)


def _points(row: Table) -> Fraction | None:
    if "points" not in row:
        return None
    value = row.data["points"]
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 < value <= MOST_POINTS:
        raise row.value_error(
            "points", f"“points” must be a number above 0 and up to {MOST_POINTS}", "write points = 3"
        )
    return Fraction(str(value))


def _misconceptions(row: Table) -> tuple[str, ...]:
    names = _strings(row, "misconceptions")
    for place, name in enumerate(names):
        if name not in MISCONCEPTIONS:
            item = row.item("misconceptions")
            at = item.items()[place] if isinstance(item.value, list) else item
            raise at.error(f"there is no misconception “{name}”", did_you_mean(name, MISCONCEPTIONS, "known"))
    return names
