"""The kinds of tasks by name. A new kind is a function `(bench, scenery, wish)`, an entry here and a key class in `model`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fnmatch import fnmatchcase

from rbpsym.document.model import Paragraph
from rbpsym.document.needless import is_struck
from rbpsym.frozen import replace
from rbpsym.teaching.bench import PHASE, ItemSetting, Prepared, ProblemBench
from rbpsym.teaching.model import Item
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.tasks import compare, derivations, results, signs, slip
from rbpsym.teaching.tasks.wish import Prepare, Wish
from rbpsym.teaching.wording import spoken

TASKS: Mapping[str, Prepare] = {
    "fill-in": derivations.blanks,
    "choose": results.choices,
    "order": derivations.orders,
    "find-the-slip": slip.prepare,
    "signs": signs.prepare,
    "formula": results.formulas,
    "number": results.numbers,
    "compare": compare.prepare,
    "explain": derivations.explanations,
}
FROM_THE_START = ("compare", "signs")  # another system begins a later phase in another way


def tasks(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """What can be made of a wish in each phase that it names; of a motion in phases each task says in which one it asks."""
    of_phase = [(b, tuple(a.partition(".")[2] for a in wish.about if _is_of(a, b))) for b in bench.later]
    own = tuple(a for a in wish.about if not any(_is_of(a, b) for b in bench.later))
    phases = () if is_struck(bench.study) else bench.study.problem.phases  # what is struck at once has no phase before
    for task in TASKS[wish.kind](bench, scenery, replace(wish, about=own)) if own or not wish.about else ():
        yield _told(task, "lead.first", phases[0].name) if phases and task.kind_asked != "question" else task
    for later, about in of_phase:
        if not about:
            continue
        if wish.kind in FROM_THE_START:
            raise wish.error(f"{wish.kind} asks about the first phase alone", f"leave out “{PHASE}{later.phase}.”.")
        for task in TASKS[wish.kind](later, replace(scenery, coordinate=None), replace(wish, about=about)):
            begins = task.kind_asked == "start" or (task.step and later.derivation.step(task.step).chapter == "phase")
            name = bench.study.problem.phases[later.phase - 2].name
            told = _told(task, "lead.begins" if begins else "lead.later", name)
            yield replace(told, phase=f"{PHASE}{later.phase}.")


def _is_of(pattern: str, bench: ProblemBench) -> bool:
    return pattern.startswith(PHASE) and fnmatchcase(f"{PHASE}{bench.phase}", pattern.partition(".")[0])


def _told(task: Prepared, lead: str, phase: str) -> Prepared:
    """The task with its phase said first."""

    def make(setting: ItemSetting) -> Item | None:
        item, said = task.make(setting), setting.said
        if item is None:
            return None
        (first, *rest), name = item.prompt, said.say("statement.phase", name=said.named(phase))
        assert isinstance(first, Paragraph)  # each task begins with what is to be done
        return replace(item, prompt=(Paragraph((*spoken(said, lead, phase=name), *first.inlines)), *rest))

    return replace(task, make=make)
