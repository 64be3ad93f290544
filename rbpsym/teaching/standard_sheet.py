"""The worksheet that is made of a problem when its author wrote none: a task of each kind that the problem offers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import islice

from rbpsym.document.needless import is_struck
from rbpsym.errors import RbpsymError
from rbpsym.field import names_in
from rbpsym.present.forms import present
from rbpsym.proof.draft import length
from rbpsym.quantities import LENGTH
from rbpsym.statement.model import Problem
from rbpsym.teaching.bench import PHASE, Prepared, ProblemBench, formula_of
from rbpsym.teaching.sheet import Sheet, SheetPart
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, wanted
from rbpsym.teaching.tasks.registry import tasks
from rbpsym.teaching.tasks.wish import Wish

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
    wishes = tuple(_wishes(bench, scenery))
    if not wishes:
        raise RbpsymError(
            f"no task can be made of “{problem.name}”", instead="write a worksheet file with tasks of your own."
        )
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, wishes),), text=problem.text)


def bare_sheet(problem: Problem) -> Sheet:
    """A worksheet without tasks, for what is filled in later."""
    return Sheet(problem.name, dict(problem.title), (SheetPart(problem, {}, ()),), text=problem.text)


def lesson(bench: ProblemBench) -> tuple[Row, ...]:
    """The rows of the lesson: before the explanation what begins later phases, and each question that the problem itself asks."""
    asked = [id for id, target in bench.targets.items() if target.kind == "question"]
    own: list[Row] = [(QUESTIONS[place % 2], (id,), 2) for place, id in enumerate(asked)]
    rows = [row for row in map(_before_blow, LESSON) if row] if is_struck(bench.derivation) else LESSON
    later = [(kinds, tuple(f"{PHASE}{b.phase}.{a}" for a in about), level) for b in bench.later for kinds, about, level in LATER]
    return (*rows[:-1], *later, *(own or [NO_QUESTIONS]), rows[-1])


AT_BLOW = ("momentum", "axis-moment", "moment", "")  # what there is to ask of a motion that a blow ends at its start


def _before_blow(row: Row) -> Row | None:
    kinds, patterns, level = row
    kept = tuple(pattern for pattern in patterns if pattern.partition(".")[0] in AT_BLOW or pattern.startswith(PHASE))
    return (kinds, kept, level) if kept and kinds != ("signs",) else None


def _wishes(bench: ProblemBench, scenery: Scenery) -> list[Wish]:
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
