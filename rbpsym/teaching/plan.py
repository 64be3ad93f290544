"""From a worksheet file or a problem to papers: the plan works all out once, then each student's variant is quick.

    plan = plan_of("rod-and-disk...")                 # a worksheet, a problem, or a file of one
    sheet = plan.worksheet(Student("ana", "Ana"), secret="...")

The variant of a student comes from SHA-256(secret, worksheet, student) and from nothing else.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from rbpsym.document.model import Block, Paragraph, words
from rbpsym.document.phrases import common_notation
from rbpsym.document.places import locator
from rbpsym.document.words import Words
from rbpsym.errors import RbpsymError, ReadError
from rbpsym.expr.glyphs import Notation
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field, replace
from rbpsym.languages import phrases
from rbpsym.proof.step import Derivation
from rbpsym.statement.library import course_files, find_problem, not_found, problem_files, worksheet_files
from rbpsym.statement.loader import load_problem, load_table
from rbpsym.statement.model import Problem
from rbpsym.teaching import codes
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench, evaluator, generic_state
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.distractors import in_phase, pool
from rbpsym.teaching.model import Item, Part, Student, Worksheet
from rbpsym.teaching.papers.solution import given_table, statement_blocks
from rbpsym.teaching.ranges import NumberRange
from rbpsym.teaching.sheet import Sheet, SheetPart, bare_sheet, is_sheet, sheet_of, standard_sheet
from rbpsym.teaching.situations import Scenery, Situation, scenery
from rbpsym.teaching.targets import targets
from rbpsym.teaching.tasks.registry import tasks
from rbpsym.teaching.tasks.wish import Wish

SPARE = 2  # tasks that are prepared beyond the number wanted, to draw from


class PlannedPart(Frozen):
    """One problem of a plan: its bench, its numbers, and the prepared tasks of each wish."""

    bench: ProblemBench
    scenery: Scenery
    wishes: tuple[tuple[Wish, tuple[Prepared, ...]], ...]
    evaluate: Callable[[Mapping[str, float]], list[list[float]]] = field(compare=False, repr=False)
    statements: dict[str, tuple[Block, ...]] = field(default_factory=dict, compare=False, repr=False)

    def tasks(self, draws: Draws) -> list[tuple[int, int]]:
        """(wish, task) for each item of a student: as many as wished, drawn from what was prepared."""
        found = []
        for place, (wish, prepared) in enumerate(self.wishes):
            order = range(len(prepared))
            picked = sorted(draws.shuffled(order)[: wish.number]) if len(prepared) > wish.number else order
            found += [(place, task) for task in picked]
        return found

    def statement(self, said: Words) -> tuple[Block, ...]:
        """The statement in a language, the same for all students."""
        if said.language not in self.statements:
            self.statements[said.language] = statement_blocks(self.bench.derivation, said)
        return self.statements[said.language]


class WorksheetPlan(Frozen):
    """A worksheet with everything worked out that does not depend on the student."""

    sheet: Sheet
    parts: tuple[PlannedPart, ...]

    @property
    def fingerprint(self) -> str:
        """Stands for the text of the worksheet and its problems: a form code holds for this text only."""
        return sha256(self.sheet.text.encode()).hexdigest()

    def require(self, fingerprint: str, source: str) -> None:
        """Raises RbpsymError if the worksheet of another machine, called `source` there, is not this one."""
        if self.fingerprint != fingerprint:
            what = f"the worksheet {source} of this worker is another one"
            raise RbpsymError(what, instead="give all machines the same files, and start the workers again.")

    def notation(self, language: str) -> Notation:
        """How the names of all its problems are printed."""
        return common_notation((part.bench.study.problem for part in self.parts), language)

    def worksheet(self, student: Student | None = None, secret: str = "", language: str = "") -> Worksheet:
        """The paper of a student (of nobody in particular if None), with its key."""
        seed = codes.seed_of(secret, self.sheet.name, "" if student is None else student.id)
        language = language or self.sheet.language
        phrases(language)  # that there are some
        return self._made(codes.FormCode(self.sheet.name, language, seed), student, secret)

    def from_code(self, text: str, secret: str = "", student: Student | None = None) -> Worksheet:
        """The paper with this form code. Raises RbpsymError if the code does not fit."""
        code = codes.read(text, secret, self.fingerprint)
        if code.worksheet != self.sheet.name:
            what = f"the form code is of the worksheet “{code.worksheet}”, not of “{self.sheet.name}”"
            raise RbpsymError(what, instead=f"give the file of “{code.worksheet}”.")
        return self._made(code, student, secret)

    def _made(self, code: codes.FormCode, student: Student | None, secret: str) -> Worksheet:
        said = Words(code.language)
        parts: list[Part] = []
        for place, part in enumerate(self.parts):
            before = tuple(item for made in parts for item in made.items)
            parts.append(_part(part, place, code, before))
        introduction = said.title(self.sheet.introduction) if self.sheet.introduction else ""
        return Worksheet(
            self.sheet.name,
            words(said.title(self.sheet.title)),
            code.language,
            codes.written(code, secret, self.fingerprint),
            tuple(parts),
            {bench.name: bench.study.problem for part in self.parts for bench in (part.bench, *part.bench.later)},
            self.notation(code.language),
            student,
            (Paragraph(words(introduction)),) if introduction else (),
        )

    @property
    def derivations(self) -> Mapping[str, Derivation]:
        """The derivations of its problems by name, for solutions."""
        return {part.bench.name: part.bench.derivation for part in self.parts}


def _part(part: PlannedPart, place: int, code: codes.FormCode, before: tuple[Item, ...]) -> Part:
    """The first numbers at which every item can be made."""
    seed, problem = code.seed.to_bytes(8, "big"), part.bench.study.problem
    said = Words(code.language, problem, f"{problem.name}.", locate=locator(part.bench.study))
    chosen = part.tasks(Draws(seed, f"tasks {place}"))
    for trial, situation in enumerate(part.scenery.situations(Draws(seed, f"numbers {place}"))):
        items = _items(part, chosen, situation, said, Draws(seed, f"items {place} {trial}"), before)
        if not isinstance(items, Wish):
            table = given_table(part.bench.derivation, situation, said)
            title = words(said.title(problem.title))
            return Part(problem.name, title, (*part.statement(said), *table), situation.given, items, place=situation.places)
    raise AssertionError("situations end with an error")


def _items(
    part: PlannedPart, chosen: list[tuple[int, int]], situation: Situation, said: Words, draws: Draws, before: tuple[Item, ...]
) -> tuple[Item, ...] | Wish:
    """The items; the wish of the first that can't be made at these numbers."""
    states = (generic_state(bench) for bench in (*part.bench.later, part.bench))
    values = part.evaluate({name: value for state in (*states, situation.numbers) for name, value in state.items()})
    found: list[Item] = []
    for wish, task in chosen:
        prepared = part.wishes[wish][1][task]
        own = values[_place(part, wish, task)]
        id = str(len(before) + len(found) + 1)
        item = prepared.make(ItemSetting(said, situation, part.scenery, draws, id, own, (*before, *found)))
        if item is None:
            return part.wishes[wish][0]
        found.append(item)
    return tuple(found)


def _place(part: PlannedPart, wish: int, task: int) -> int:
    """Where the values of a task stand among those of all tasks."""
    return sum(len(prepared) for _, prepared in part.wishes[:wish]) + task


# --- making a plan


def plan_of(source: str | Path | Problem | Sheet) -> WorksheetPlan:
    """The plan of a worksheet or of a problem: a name that ships, a file, a `Problem` or a `Sheet`.

    Raises RbpsymError with the place of what is wrong.
    """
    sheet = source if isinstance(source, Sheet) else _sheet(source)
    parts = []
    for part in sheet.parts:
        bench = bench_of(part.problem, part.numbers)
        sight = _scenery(bench, part.wishes)
        _check_numbers(sight, part)
        if not part.wishes:
            sheet = standard_sheet(bench, sight)
            part = _makeable(bench, sight, sheet.parts[0])
            sheet = replace(sheet, parts=(part,))
        parts.append(_planned(bench, sight, part))
    return WorksheetPlan(sheet, tuple(parts))


TRIALS = 10


def _makeable(bench: ProblemBench, sight: Scenery, part: SheetPart) -> SheetPart:
    """Without the tasks for which some of the first numbers never do: right and wrong answers look alike in print, say."""
    kept, said = part, Words("en", bench.study.problem, f"{bench.name}.", locate=locator(bench.study))
    while kept.wishes:
        planned, stuck, draws = _planned(bench, sight, kept), Counter[Wish](), Draws(b"trial", bench.name)
        with suppress(RbpsymError):  # there are fewer numbers than trials
            for _, situation in zip(range(TRIALS), sight.situations(draws), strict=False):
                items = _items(planned, planned.tasks(draws), situation, said, draws, ())
                if not isinstance(items, Wish):
                    return kept
                stuck[items] += 1
        if not stuck:
            return kept
        [(worst, _)] = stuck.most_common(1)
        kept = _without(bench, sight, kept, worst)
    return part  # whose papers say why there are none


def _without(bench: ProblemBench, sight: Scenery, part: SheetPart, worst: Wish) -> SheetPart:
    """A choice is asked as a formula, as there is none to choose from; what can't be asked so is left out."""
    with suppress(RbpsymError):
        wishes = tuple(replace(wish, kind="formula") if wish == worst else wish for wish in part.wishes)
        asked = replace(part, wishes=wishes)
        if worst.kind == "choose" and _planned(bench, sight, asked):
            return asked
    return replace(part, wishes=tuple(wish for wish in part.wishes if wish != worst))


def _check_numbers(sight: Scenery, part: SheetPart) -> None:
    """Raises an error, told at its place, if the worksheet's own numbers leave no motion to look at."""
    try:
        next(sight.situations(Draws(b"check", part.problem.name)))
    except RbpsymError as error:
        raise part.error(error) from None


def _sheet(source: str | Path | Problem) -> Sheet:
    if isinstance(source, Problem):
        return bare_sheet(source)
    name = str(source)
    if name in worksheet_files():
        path = worksheet_files()[name]
    elif name in problem_files() or not Path(name).is_file():
        return bare_sheet(load_problem(_found(name)))
    else:
        path = Path(name)
    table = load_table(path)
    return sheet_of(table, path.stem, path.parent) if is_sheet(table) else bare_sheet(load_problem(path))


def _found(name: str) -> Path:
    """A problem of the library or a file; the error names worksheets too."""
    try:
        return find_problem(name)
    except ReadError:
        if name in course_files():
            what = f"“{name}” is a course; a worksheet is made of a worksheet file or of one problem"
            raise ReadError(what, instead="give one of its problems, or a file that lists several.") from None
        raise not_found(name, [*worksheet_files(), *problem_files()], "worksheet, no problem") from None


def bench_of(problem: Problem, numbers: Mapping[str, NumberRange] | None = None) -> ProblemBench:
    """A problem derived, with its targets and its wrong studies."""
    from rbpsym.derive import derive

    derivation, wishes = derive(problem, simulation=False), dict(numbers or {})
    first, later = pool(derivation), []
    for number, phase in enumerate(derivation.phases, 2):
        own = replace(phase.derivation, steps=(*phase.begins, *phase.derivation.steps))
        later.append(ProblemBench(own, {x.id: x for x in targets(own)}, in_phase(first, own, number), wishes, number))
    return ProblemBench(derivation, {x.id: x for x in targets(derivation)}, first, wishes, later=tuple(later))


def _scenery(bench: ProblemBench, wishes: tuple[Wish, ...]) -> Scenery:
    """An oscillation is timed if a frequency may be asked for."""
    is_timed = not wishes or any(not w.about or any(a.startswith(("frequency", "*")) for a in w.about) for w in wishes)
    begun = bench.later[0].study.problem.coordinates if bench.later else ()
    ends = {each.name: scalar(each.start) for each in begun if each.start is not None}
    return scenery(bench.study, bench.wishes, is_timed, ends)


def _planned(bench: ProblemBench, sight: Scenery, part: SheetPart) -> PlannedPart:
    prepared: list[tuple[Wish, tuple[Prepared, ...]]] = []
    used: set[str] = set()
    for wish in part.wishes:
        found = _prepared(bench, sight, wish, used)
        if len(found) < wish.number:
            raise wish.error(
                f"“{bench.name}” has only {len(found)} such tasks, {wish.number} are wanted",
                f"write number = {len(found)}, or widen “about”." if found else "ask for another kind of task.",
            )
        used |= {f"{task.kind} {task.about}" for task in found[: wish.number] if task.target}
        prepared.append((wish, tuple(found)))
    return PlannedPart(bench, sight, tuple(prepared), evaluator(task for _, tasks in prepared for task in tasks))


def _prepared(bench: ProblemBench, sight: Scenery, wish: Wish, used: set[str]) -> list[Prepared]:
    """As many as wished and some to spare; what was asked so already comes last."""
    fresh: list[Prepared] = []
    again: list[Prepared] = []
    for task in tasks(bench, sight, wish):
        (again if f"{task.kind} {task.about}" in used else fresh).append(task)
        if len(fresh) >= wish.number + SPARE:
            break
    found = fresh if len(fresh) >= wish.number else [*fresh, *again]
    may_vary = len(wish.about) != 1 or any(mark in wish.about[0] for mark in "*?[")
    return found if may_vary else found[: wish.number]
