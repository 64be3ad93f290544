"""Distractors over the whole library: none may equal the key or another one, also not in print.

    python benchmarks/slow/distractors.py [SEEDS] [NAME ...]

For every problem and every quantity that can be asked, as a formula and as a number, the options of SEEDS students
(200) are looked at: each pair of formulas is decided anew from the printed trees (it must be REFUTED), and their
numbers at the student's values, rounded as printed, must differ. Exit code 1 if one does not.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterator

from rbpsym.decide.equal import equal
from rbpsym.errors import RbpsymError
from rbpsym.field.evaluate import scalar
from rbpsym.statement.library import find_problem, problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.bench import ProblemBench, generic_state, is_number
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.distractors import without_noise
from rbpsym.teaching.model import ChoiceKey, Item, NumberKey, Student
from rbpsym.teaching.plan import WorksheetPlan, _planned, bench_of
from rbpsym.teaching.ranges import digits_text, measured, si
from rbpsym.teaching.sheet import Sheet, SheetPart
from rbpsym.teaching.situations import Scenery, scenery
from rbpsym.teaching.tasks.wish import Wish

SEEDS = 200


def wishes(bench: ProblemBench, sight: Scenery) -> Iterator[Wish]:
    """Every quantity with at least two distractors, as a formula and, where it is one, as a number."""
    for target in bench.targets.values():
        count = len(bench.pool.of(target))
        if count < 2:
            continue
        yield Wish("choose", (target.id,), options=min(4, count + 1))
        if is_number(bench, target, sight):
            yield Wish("number", (target.id,))


def plans(name: str) -> Iterator[WorksheetPlan]:
    """One plan for each quantity and kind: what one set of numbers does not allow says nothing about another."""
    bench = bench_of(load_problem(find_problem(name)))
    sight = scenery(bench.study, {}, False)
    for wish in wishes(bench, sight):
        part = SheetPart(bench.study.problem, {}, (wish,))
        sheet = Sheet(name, bench.study.problem.title, (part,), text=name)
        yield WorksheetPlan(sheet, (_planned(bench, sight, part),))


def faults(plan: WorksheetPlan, seeds: int, seen: dict, counts: Counter) -> Iterator[str]:
    """What is wrong with the options of so many students."""
    bench = plan.parts[0].bench
    for seed in range(seeds):
        try:
            sheet = plan.worksheet(Student(str(seed)))
        except RbpsymError as error:
            counts["refused"] += 1
            yield f"refused: {error.what}"
            return
        for item in sheet.items:
            yield from _faults_of(item, {**generic_state(bench), **_numbers(sheet, item)}, bench, seen, counts)


def _numbers(sheet, item: Item) -> dict[str, float]:
    part = sheet.part_of(item.id)
    return {name: si(measure) for name, measure in {**part.given, **part.place}.items()}


def _faults_of(item: Item, numbers: dict[str, float], bench: ProblemBench, seen: dict, counts: Counter) -> Iterator[str]:
    if isinstance(item.key, NumberKey):
        printed = [digits_text(item.key.measure), *(digits_text(a.number) for a in item.key.anticipated)]
        counts["numbers"] += len(printed) - 1
        if len(set(printed)) < len(printed):
            yield f"{item.asked.quantity}: {printed}"
        return
    assert isinstance(item.key, ChoiceKey)
    formulas = [option.formula for option in item.key.options]
    counts["options"] += len(formulas) - 1
    for place, a in enumerate(formulas):
        for b in formulas[:place]:
            if (a, b) not in seen:
                seen[a, b] = equal(a, b, bench.study.assumptions).is_refuted
                counts["pairs"] += 1
            if not seen[a, b]:
                yield f"{item.asked.quantity}: not refuted"
    place = same_in_print(formulas, numbers, seen)
    if place is not None:
        yield f"{item.asked.quantity}: {place}"


def same_in_print(formulas, numbers: dict[str, float], seen: dict) -> list[str] | None:
    """The printed numbers, if two are the same."""
    key = ("evaluate", *formulas)
    if key not in seen:
        seen[key] = compiled([scalar(formula) for formula in formulas])
    try:
        printed = [digits_text(measured(value, "", 3)) for value in without_noise(seen[key](numbers))]
    except ValueError:
        return None
    return printed if len(set(printed)) < len(printed) else None


def main(arguments: list[str]) -> int:
    """Runs and tells."""
    seeds = int(arguments[0]) if arguments else SEEDS
    bad, total = 0, Counter()
    for name in arguments[1:] or problem_files():
        begun, counts, told = time.perf_counter(), Counter(), []
        try:
            for plan in plans(name):
                told += faults(plan, seeds, {}, counts)
        except RbpsymError as error:
            told.append(f"refused: {error.what}")
        wrong = [line for line in told if not line.startswith("refused")]
        bad += len(wrong)
        total += counts
        print(f"{name}: {dict(counts)} {time.perf_counter() - begun:.1f} s", *told[:5], sep="\n    ", flush=True)
    print(f"{seeds} seeds: {dict(total)}; {bad} options equal to the key or to each other")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
