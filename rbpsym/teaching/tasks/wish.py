"""What a worksheet wants of one kind of task, and how its quantities are picked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Set
from contextlib import suppress
from fnmatch import fnmatchcase
from fractions import Fraction

from rbpsym.ask.asking import found_in
from rbpsym.document.model import Block
from rbpsym.errors import RbpsymError
from rbpsym.field import Scalar, names_in
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study
from rbpsym.statement.source import SourceItem as Entry
from rbpsym.statement.source import did_you_mean
from rbpsym.teaching import model as m
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.target import REFUSALS, Target


class Wish(Frozen):
    """One [[problem.task]] of a worksheet.

    about: ids of quantities, or patterns with *; number: how many items; level: 0 (much help) to 3 (none);
    points: each; options: how many to choose from; answers: "formula" or "number"; `at` tells where it stands in
    the file, None for a task that nobody wrote.
    """

    kind: str
    about: tuple[str, ...] = ()
    number: int = 1
    level: int = 1
    points: Fraction | None = None
    options: int = 4
    answers: str = "formula"
    misconceptions: tuple[str, ...] = ()
    at: Entry | None = None

    def worth(self, usual: int) -> Fraction:
        """The points that were wished for, else the usual ones."""
        return Fraction(usual) if self.points is None else self.points

    def item(
        self, setting: ItemSetting, asked: m.AskedQuantity, prompt: Iterable[Block], key: m.Key, usual: int, *,
        solution: Iterable[Block], rubric: Iterable[m.Criterion] = (), space: int = 0,
    ) -> m.Item:  # fmt: skip
        """An item as it was wished for; `usual`: its points if nobody says."""
        return m.Item(
            setting.id,
            self.kind,
            tuple(prompt),
            key,
            asked,
            self.worth(usual),
            tuple(rubric),
            tuple(solution),
            self.level,
            Fraction(space),
        )

    def error(self, what: str, instead: str = "") -> RbpsymError:
        """An error about the task, told where it stands in the file."""
        return self.at.error(what, instead) if self.at is not None else RbpsymError(what, instead=instead)


Prepare = Callable[[ProblemBench, Scenery, Wish], Iterator[Prepared]]


def wanted(bench: ProblemBench, wish: Wish, fits: Callable[[Target], bool], why: str) -> list[Target]:
    """The targets that a wish names and that fit. Raises an error if it names none, or none that fit (`why`)."""
    named = [x for x in bench.targets.values() if not wish.about or any(fnmatchcase(x.id, pattern) for pattern in wish.about)]
    if not named:
        hint = did_you_mean(wish.about[0], bench.ids, "quantities of this problem")
        raise wish.error(f"“{bench.name}” has no quantity “{', '.join(wish.about)}” (or it is zero)", hint)
    found = sorted((target for target in named if fits(target)), key=lambda target: _beside(bench, target))
    if not found:
        ids = ", ".join(x.id for x in bench.targets.values() if fits(x))
        raise wish.error(
            f"no {wish.kind} task can be made about “{', '.join(wish.about) or bench.name}”: {why}",
            f"quantities that can be asked so: {ids}." if ids else "choose another kind of task for this problem.",
        )
    return found


def _beside(bench: ProblemBench, target: Target) -> int:
    """How many parameters stand in it that no question of the problem is about: the mass of a truck, if its crate is."""
    about = bench.once("about", lambda: _asked_about(bench.study))
    value = target.value(bench.study) if about else None
    return 0 if value is None else len(names_in(value) & {q.name for q in bench.study.problem.parameters} - about)


def _asked_about(study: Study) -> Set[str]:
    """The parameters in the answers to a problem's questions, and in what decides them."""
    found: set[str] = set()
    for text in study.problem.questions:
        with suppress(*REFUSALS):
            answer = found_in(study, text)
            data = [part for _, told in getattr(answer, "grounds", ()) for part in told.values()]
            listed = (part if isinstance(part, (tuple, list)) else (part,) for part in (*data, answer.values))
            found |= {name for part in listed for one in part if isinstance(one, Scalar) for name in names_in(one)}
    return found
