"""A worksheet file: which problems, which tasks, which numbers. Grammar: docs/worksheets.md.

Errors tell the place with a caret, as those of problem files do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from rbpsym.errors import RbpsymError
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_table, table_of
from rbpsym.statement.model import Problem
from rbpsym.statement.source import Item, Table, did_you_mean, kind_of
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.ranges import Range, named_quantities, read_measure
from rbpsym.teaching.tasks.registry import TASKS
from rbpsym.teaching.tasks.wish import Wish
from rbpsym.teaching.wording import languages

SHEET_KEYS = ("title", "language", "introduction", "problem")
PROBLEM_KEYS = ("name", "file", "numbers", "task")
TASK_KEYS = ("kind", "about", "number", "level", "points", "options", "answers", "misconceptions")
RANGE_KEYS = ("from", "to", "step", "digits")
ANSWERS = ("formula", "number")
MOST_ITEMS, MOST_POINTS = 40, 1000


@dataclass(frozen=True)
class SheetPart:
    """One [[problem]] of a worksheet: the problem, the wishes for its numbers, and its tasks."""

    problem: Problem
    numbers: Mapping[str, Range]
    wishes: tuple[Wish, ...]


@dataclass(frozen=True)
class Sheet:
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


def load_sheet(path: Path) -> Sheet:
    """The worksheet in a file. Raises StatementError or ReadError with the place of what is wrong."""
    return sheet_of(load_table(path), path.stem, path.parent)


def sheet_of_text(text: str, name: str = "worksheet") -> Sheet:
    """The worksheet in a text; files of problems are looked for in the current folder."""
    return sheet_of(table_of(text, name), name, Path())


def sheet_of(table: Table, name: str, folder: Path) -> Sheet:
    """The worksheet in a table."""
    table.check_keys(SHEET_KEYS, "a worksheet")
    table.require("problem", "the worksheet", 'add [[problem]] with name = "..." and [[problem.task]] below it')
    parts = tuple(_part(row, folder) for row in table.rows("problem", "problem"))
    text = "\x00".join([table.source.index.text, *(part.problem.text for part in parts)])
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
        return {"en": value}
    inner = table.table(key, key)
    return {language: inner.string(language) for language in inner.names()}


def _part(row: Table, folder: Path) -> SheetPart:
    row.check_keys(PROBLEM_KEYS, "a problem of a worksheet")
    problem = _problem(row, folder)
    row.require("task", f"“{problem.name}”", 'add [[problem.task]] with kind = "choose"')
    wishes = tuple(_wish(task) for task in row.rows("task", "task"))
    return SheetPart(problem, dict(_numbers(row.table("numbers", "numbers"), problem)), wishes)


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


def _wish(row: Table) -> Wish:
    row.check_keys(TASK_KEYS, "a task")
    row.require("kind", "the task", f'write kind = "{next(iter(TASKS))}" or another of {", ".join(TASKS)}')
    kind = row.string("kind")
    if kind not in TASKS:
        raise row.value_error("kind", f"there is no kind of task “{kind}”", did_you_mean(kind, TASKS, "kinds"))
    answers = row.string("answers", "formula")
    if answers not in ANSWERS:
        raise row.value_error("answers", f"answers are “formula” or “number”, not “{answers}”", "write one of the two")
    return Wish(
        kind,
        _strings(row, "about"),
        _whole(row, "number", 1, 1, MOST_ITEMS),
        _whole(row, "level", 1, 0, 3),
        _points(row),
        _whole(row, "options", 4, 2, 6),
        answers,
        _misconceptions(row),
        row.item("kind"),
    )


def _strings(row: Table, key: str) -> tuple[str, ...]:
    """A text or a list of texts."""
    value = row.data.get(key, ())
    if isinstance(value, str):
        return (value,)
    if not isinstance(value, (list, tuple)) or not all(isinstance(item, str) for item in value):
        raise row.value_error(key, f"“{key}” must be a text or a list of texts", f'write {key} = ["..."]')
    return tuple(value)


def _whole(row: Table, key: str, default: int, low: int, high: int) -> int:
    value = row.data.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise row.value_error(key, f"“{key}” must be a whole number from {low} to {high}", f"write {key} = {default}")
    return value


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


# --- numbers


def _numbers(table: Table, problem: Problem) -> Iterator[tuple[str, Range]]:
    known = {**named_quantities(problem), **{c.name: c.quantity.dimension for c in problem.coordinates}}
    table.check_keys(known, f"the numbers of “{problem.name}”")
    for name in table.names():
        yield name, _range(table, name, lambda text, what, name=name: read_measure(text, known[name], what))


Read = Callable[[str, str], object]


def _range(table: Table, name: str, read: Read) -> Range:
    """A fixed number "60 deg", or { from, to, step, digits }."""
    value = table.data[name]
    if isinstance(value, str):
        measure = _told(table.item(name), lambda: read(value, f"“{name}”"))
        return Range(measure.value, measure.value, Fraction(0), measure.unit)
    if not isinstance(value, Mapping):
        raise table.value_error(
            name, f"“{name}” must be a number with its unit or a range, not {kind_of(value)}",
            f'write {name} = "0.5 kg" or {name} = {{ from = "0.4 kg", to = "0.6 kg", step = "0.05 kg" }}',
        )  # fmt: skip
    row = table.table(name, name)
    row.check_keys(RANGE_KEYS, "a range")
    for key in RANGE_KEYS[:3]:
        row.require(key, f"the range of “{name}”")
    low, high, step = (
        _told(row.item(key), lambda key=key: read(row.string(key), f"“{key}”")) for key in RANGE_KEYS[:3]
    )
    _check_range(row, low, high, step)
    return Range(low.value, high.value, step.value, low.unit, _whole(row, "digits", 3, 1, 6))


def _check_range(row: Table, low, high, step) -> None:
    if len({low.unit, high.unit, step.unit}) > 1:
        raise row.value_error("step", "“from”, “to” and “step” must be in the same unit", f"write all in {low.unit}")
    if step.value <= 0:
        raise row.value_error(
            "step", "the step must be greater than 0", f'write a fixed number: "{row.data["from"]}", or a step'
        )
    if low.value > high.value:
        raise row.value_error("to", "the range ends before it begins", "exchange “from” and “to”")


def _told(item: Item, call: Callable[[], object]):
    """The result of a reader, its error told at the place of what it read."""
    try:
        return call()
    except RbpsymError as error:
        raise item.error(error.what, error.instead) from None
