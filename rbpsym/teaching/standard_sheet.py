"""The worksheet that is made of a problem when its author wrote none: a task of each kind that the problem offers."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.errors import RbpsymError
from rbpsym.statement.model import Problem
from rbpsym.teaching.bench import Bench
from rbpsym.teaching.sheet import Sheet, SheetPart
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.tasks.registry import TASKS
from rbpsym.teaching.tasks.wish import Wish

# kind, what to ask about (the first that can be asked is), level: from much help to little, as a lesson goes
LESSON: tuple[tuple[str, tuple[str, ...], int], ...] = (
    ("signs", ("",), 1),
    ("choose", ("momentum.total", "momentum.*", "axis-moment.*", "moment.*"), 1),
    ("fill-in", ("acceleration.*", "speed.*", "reaction.*"), 1),
    ("choose", ("acceleration.*", "frequency.*", "work.theta.*", "reaction.*"), 1),
    ("order", ("speed.*", "acceleration.*", "reaction.*"), 1),
    ("find-the-slip", ("acceleration.*", "speed.*", "momentum.*", "work.*", "reaction.*"), 1),
    ("number", ("speed.*", "acceleration.*"), 2),
    ("number", ("reaction.*", "frequency.*", "work.*"), 2),
    ("formula", ("reaction.*", "acceleration.*", "speed.*"), 2),
    ("compare", ("frequency.*", "acceleration.*", "speed.*"), 2),
    ("explain", ("workless", "work_energy", "combination", ""), 3),
)


def standard_sheet(bench: Bench, scenery: Scenery) -> Sheet:
    """A worksheet for the problem of a bench. Raises RbpsymError if nothing can be asked."""
    problem = bench.study.problem
    wishes = tuple(_wishes(bench, scenery))
    if not wishes:
        raise RbpsymError(
            f"no task can be made of “{problem.name}”", instead="write a worksheet file with tasks of your own."
        )
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, wishes),), text=problem.text)


def bare_sheet(problem: Problem) -> Sheet:
    """A worksheet without tasks, for what is filled in later."""
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, ()),), text=problem.text)


def _wishes(bench: Bench, scenery: Scenery) -> Iterator[Wish]:
    asked: set[str] = set()
    for kind, patterns, level in LESSON:
        for pattern in patterns:
            options = (4, 3) if kind == "choose" else (4,)
            found = next((w for n in options if (w := _possible(bench, scenery, kind, pattern, level, n, asked))), None)
            if found is not None:
                asked |= {f"{kind} {id}" for id in found.about}
                yield found
                break


def _possible(bench, scenery, kind: str, pattern: str, level: int, options: int, asked: set[str]) -> Wish | None:
    """The wish for the first quantity of a pattern that can be asked so and was not yet."""
    wish = Wish(kind, (pattern,) if pattern else (), level=level, options=options)
    try:
        for task in TASKS[kind](bench, scenery, wish):
            if task.target is None:
                return wish
            if f"{kind} {task.target.id}" not in asked:
                return Wish(kind, (task.target.id,), level=level, options=options)
    except RbpsymError:
        return None
    return None
