"""The paper that is made of each problem of the library, made once for all laws that look at it."""

from __future__ import annotations

from functools import cache

from rbpsym.errors import RbpsymError
from rbpsym.statement.library import problem_files
from rbpsym.teaching.bench import ProblemBench
from rbpsym.teaching.model import Item, Student, Worksheet
from rbpsym.teaching.plan import WorksheetPlan, plan_of

NAMES = tuple(sorted(problem_files()))
# problems of which no worksheet can be made: their equations of motion are not solved, or no numbers are found
NONE = frozenset(
    {"bar-on-slanting-strings", "four-bar-linkage", "weight-over-rough-pin"}
)  # fmt: skip


@cache
def paper(name: str) -> tuple[WorksheetPlan, Worksheet] | None:
    """The plan and the paper of one student; None if no worksheet can be made of the problem."""
    try:
        plan = plan_of(name)
        return plan, plan.worksheet(Student("ana", "Ana"), "secret")
    except RbpsymError:
        return None


def bench_of(plan: WorksheetPlan, item: Item) -> ProblemBench:
    """What a task is made of: the first phase of its problem, or the later one about which it asks."""
    first = plan.parts[0].bench
    return next(bench for bench in (first, *first.later) if bench.name == item.asked.problem)
