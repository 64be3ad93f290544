"""A worksheet file: which problems, which tasks, which numbers. Grammar: docs/worksheets.md.

Errors tell the place with a caret, as those of problem files do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from pathlib import Path

from rbpsym.document.needless import is_struck
from rbpsym.errors import RbpsymError
from rbpsym.field import names_in
from rbpsym.frozen import Frozen, field
from rbpsym.languages import languages
from rbpsym.present.forms import present
from rbpsym.proof.draft import length
from rbpsym.quantities import LENGTH
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, table_of
from rbpsym.statement.model import Problem
from rbpsym.statement.source import SourceItem, SourceTable, did_you_mean, kind_of
from rbpsym.teaching.bench import PHASE, Prepared, ProblemBench, formula_of
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.ranges import NumberRange, numbers_in
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, wanted
from rbpsym.teaching.tasks.registry import TASKS, tasks
from rbpsym.teaching.tasks.wish import Wish

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


def is_sheet(table: SourceTable) -> bool:
    """Whether a file is a worksheet (and not a problem): it lists problems."""
    return "problem" in table


def sheet_of_text(text: str, name: str = "worksheet") -> Sheet:
    """The worksheet in a text; files of problems are looked for in the current folder."""
    return sheet_of(table_of(text, name), name, Path())


def sheet_of(table: SourceTable, name: str, folder: Path) -> Sheet:
    """The worksheet in a table."""
    table.check_keys(SHEET_KEYS, "a worksheet")
    table.require("problem", "the worksheet", 'add [[problem]] with name = "..." and [[problem.task]] below it')
    parts = tuple(_part(row, folder) for row in _rows(table, "problem", "[[problem]]"))
    text = "\x00".join([table.source.index.text if table.source.index else "", *(part.problem.text for part in parts)])
    title = _texts(table, "title") or dict(parts[0].problem.title)
    return Sheet(name, title, parts, _language(table), _texts(table, "introduction"), text)


def _language(table: SourceTable) -> str:
    found = table.string("language", "en")
    if found not in languages():
        raise table.value_error("language", f"there are no worksheets in “{found}”", did_you_mean(found, languages()))
    return found


def _texts(table: SourceTable, key: str) -> dict[str, str]:
    """A text, or a text for each language."""
    if key not in table:
        return {}
    value = table.data[key]
    if isinstance(value, str):
        return dict.fromkeys(languages(), value)
    if not isinstance(value, Mapping):
        raise table.value_error(
            key, f"“{key}” must be a text, not {kind_of(value)}", f'write {key} = "..." or {key} = {{ en = "...", es = "..." }}'
        )
    inner = table.table(key, key)
    inner.check_keys(languages(), f"the languages of “{key}”")
    return {language: inner.string(language) for language in inner.names()}


def _rows(table: SourceTable, key: str, written: str) -> list[SourceTable]:
    """The tables of a list, at least one."""
    value = table.data[key]
    if not isinstance(value, (list, tuple)) or not value or not all(isinstance(row, Mapping) for row in value):
        raise table.error(f"“{key}” must be one or more tables", f"write {written} with two brackets, once for each", key)
    return table.rows(key, key)


def _part(row: SourceTable, folder: Path) -> SheetPart:
    row.check_keys(PROBLEM_KEYS, "a problem of a worksheet")
    problem = _problem(row, folder)
    row.require("task", f"“{problem.name}”", 'add [[problem.task]] with kind = "choose"')
    wishes = tuple(wish for task in _rows(row, "task", "[[problem.task]]") for wish in _wishes(task))
    if not isinstance(row.data.get("numbers", {}), Mapping):
        raise row.error("the numbers of a problem are one table", "write [problem.numbers] below it", "numbers")
    numbers = dict(numbers_in(row.table("numbers", "[problem.numbers]"), problem))
    return SheetPart(problem, numbers, wishes, row.item("numbers" if numbers else "name" if "name" in row else "file"))


def _problem(row: SourceTable, folder: Path) -> Problem:
    """By its name in the library, or a file beside the worksheet."""
    if ("name" in row) == ("file" in row):
        raise row.error("a problem is named or its file is given, one of both", 'write name = "sliding-..." or file = "my.toml"')
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


def _wishes(row: SourceTable) -> Iterator[Wish]:
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


def _wish(row: SourceTable, kind: str, level: int) -> Wish:
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


def _levels(row: SourceTable) -> list[int]:
    """One level, or several in a list."""
    value = row.data.get("level", 1)
    found = list(value) if isinstance(value, (list, tuple)) else [value]
    if not found or any(isinstance(one, bool) or one not in LEVELS for one in found):
        raise row.value_error(
            "level", "“level” must be a whole number from 0 (much help) to 3 (none), or a list of these", "write level = 1"
        )
    return found


def _strings(row: SourceTable, key: str) -> tuple[str, ...]:
    """A text or a list of texts."""
    value = row.data.get(key, ())
    if isinstance(value, str):
        return (value,)
    if not isinstance(value, (list, tuple)) or (key in row and not value) or not all(isinstance(item, str) for item in value):
        raise row.value_error(key, f"“{key}” must be a text or a list of texts", f'write {key} = ["..."]')
    return tuple(value)


def _points(row: SourceTable) -> Fraction | None:
    if "points" not in row:
        return None
    value = row.data["points"]
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 < value <= MOST_POINTS:
        raise row.value_error("points", f"“points” must be a number above 0 and up to {MOST_POINTS}", "write points = 3")
    return Fraction(str(value))


def _misconceptions(row: SourceTable) -> tuple[str, ...]:
    names = _strings(row, "misconceptions")
    for place, name in enumerate(names):
        if name not in MISCONCEPTIONS:
            item = row.item("misconceptions")
            at = item.items()[place] if isinstance(item.value, list) else item
            raise at.error(f"there is no misconception “{name}”", did_you_mean(name, MISCONCEPTIONS, "known"))
    return names


# --- the worksheet that is made of a problem when its author wrote none: a task of each kind that the problem offers


TRIES = 4  # quantities of one pattern that are tried
LONGEST = 100  # parts of a formula that is asked for or led to: about one line in print

# kinds (the first that can be made is), what to ask about, level: from much help to little, as a lesson goes
Row = tuple[tuple[str, ...], tuple[str, ...], int]
LESSON: tuple[Row, ...] = (
    (("compare",), ("frequency.*", "acceleration.*", "speed.*"), 2),
    (("signs",), ("",), 1),
    (("choose",), ("momentum.total", "momentum.*", "axis-moment.*", "moment.*"), 1),
    (("fill-in",), ("acceleration.*", "speed.*", "reaction.*"), 1),
    (("choose",), ("acceleration.*", "frequency.*", "work.theta.*", "reaction.*"), 1),
    (("order",), ("speed.*", "acceleration.*", "reaction.*"), 1),
    (("find-the-slip",), ("acceleration.*", "speed.*", "momentum.*", "work.*", "reaction.*"), 1),
    (("number",), ("speed.*", "acceleration.*"), 2),
    (("number",), ("reaction.*", "frequency.*", "work.*"), 2),
    (("explain",), (f"{PHASE}2.jump", f"{PHASE}2.kept", "workless", "work_energy", "combination", ""), 3),
)
LATER: tuple[Row, ...] = (  # of each later phase: how it begins, and what then goes on
    (("fill-in", "choose", "formula"), ("start.*_dot", "start.*"), 1),
    (("choose", "number", "formula"), ("acceleration.*", "reaction.*"), 2),
)
# how the questions of the problem itself are asked, by turns
QUESTIONS = (("formula", "choose", "number"), ("choose", "formula", "number"))
FILL_IN = ("fill-in",)
NO_QUESTIONS: Row = (("formula",), ("reaction.*", "acceleration.*", "speed.*"), 2)
# which kinds of tasks pick their quantity first, after the questions of the problem
PICKS = ("signs", "fill-in", "order", "find-the-slip", "number", "choose", "formula", "compare", "explain")


def standard_sheet(bench: ProblemBench, scenery: Scenery) -> Sheet:
    """A worksheet for the problem of a bench. Raises RbpsymError if nothing can be asked."""
    problem = bench.study.problem
    wishes = tuple(_usual_wishes(bench, scenery))
    if not wishes:
        raise RbpsymError(f"no task can be made of “{problem.name}”", instead="write a worksheet file with tasks of your own.")
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, wishes),), text=problem.text)


def bare_sheet(problem: Problem) -> Sheet:
    """A worksheet without tasks, for what is filled in later."""
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, ()),), text=problem.text)


def lesson(bench: ProblemBench) -> tuple[Row, ...]:
    """The rows of the lesson: before the explanation what begins later phases, and each question that the problem itself asks."""
    asked = [id for id, target in bench.targets.items() if target.kind in ("question", "given")]
    own: list[Row] = [(QUESTIONS[place % 2], (id,), 2) for place, id in enumerate(asked)]
    if bench.study.problem.unstated:
        return tuple(own)
    struck = is_struck(bench.study)
    rows = [row for row in map(_before_blow, LESSON) if row] if struck else LESSON
    later = [(kinds, tuple(f"{PHASE}{b.phase}.{a}" for a in about), level) for b in bench.later for kinds, about, level in LATER]
    return (*rows[:-1], *later, *(own or [NO_QUESTIONS] * (not struck)), rows[-1])


AT_BLOW = ("momentum", "axis-moment", "moment", "")  # what there is to ask of a motion that a blow ends at its start


def _before_blow(row: Row) -> Row | None:
    kinds, patterns, level = row
    kept = tuple(pattern for pattern in patterns if pattern.partition(".")[0] in AT_BLOW or pattern.startswith(PHASE))
    return (kinds, kept, level) if kept and kinds != ("signs",) else None


def _usual_wishes(bench: ProblemBench, scenery: Scenery) -> list[Wish]:
    """For each row of the lesson the first wish that gives away no answer of another task; the questions of the
    problem choose first, then those that train most. A derivation to be filled in comes before them if it does not print their
    answers: where it ends in one, that question is asked."""
    taken: dict[int, tuple[Wish, Content]] = {}
    rows = lesson(bench)
    own = [bench.targets[id] for kinds, (id, *_), _ in rows if kinds in QUESTIONS]
    answers = wanted(bench.study, [formula_of(bench, target) for target in own])
    for row in sorted(range(len(rows)), key=lambda row: _turn(rows[row][0])):
        kinds, patterns, level = rows[row]
        for wish, content in (made for kind in kinds for made in _possible(bench, scenery, kind, patterns, level)):
            if kinds == FILL_IN and content.prints & answers:
                continue
            if not any(content.spoils(other) for other in (bench.given, *(other for _, other in taken.values()))):
                taken[row] = (wish, content)
                break
    return [taken[row][0] for row in sorted(taken)]


def _turn(kinds: tuple[str, ...]) -> tuple[int, int]:
    return (0 if kinds == FILL_IN else 1 if kinds in QUESTIONS else 2, PICKS.index(kinds[0]))


def _possible(
    bench: ProblemBench, scenery: Scenery, kind: str, patterns: tuple[str, ...], level: int
) -> Iterator[tuple[Wish, Content]]:
    """Wishes for single quantities, in the order of the patterns; choices with four answers first."""
    for pattern in patterns:
        for options in (4, 3) if kind == "choose" else (4,):
            wish = Wish(kind, (pattern,) if pattern else (), level=level, options=options)
            for task in _made(bench, scenery, wish):
                if _is_long(bench, task) or _only_holds(task) or _is_asked(bench, task):
                    continue
                yield replace(wish, about=task.about or wish.about), task.content


def _only_holds(task: Prepared) -> bool:
    """Is it about the couple by which a joint keeps a body from turning, which stands in a statement alone?"""
    return task.target is not None and task.target.kind == "reaction" and task.target.unit_name == "torque"


def _is_asked(bench: ProblemBench, task: Prepared) -> bool:
    """Does a question of the problem ask for it already, or for the speed that is so many lengths times this angular one?"""
    if task.target is None or task.kind_asked != "start":
        return False
    lengths = {q.name for q in bench.study.problem.parameters if q.dimension == LENGTH}
    [value] = (task.target.value(later.study) for later in bench.later if task.phase == f"{PHASE}{later.phase}.")
    own = (target.value(bench.study) for target in bench.targets.values() if target.kind == "question")
    return value is not None and any(names_in(value / other) <= lengths for other in own if other)


def _is_long(bench: ProblemBench, task: Prepared) -> bool:
    """Is what it is about a formula that no one would write or read by hand?"""
    value = task.target.value(bench.study) if task.target else None
    return value is not None and length(present(value, bench.study.style)) > LONGEST


def _made(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """At most so many; none where the problem offers none."""
    with suppress(RbpsymError):
        yield from islice(tasks(bench, scenery, wish), TRIES)
