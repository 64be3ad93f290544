"""What a worksheet wants of one kind of task, and how its quantities are picked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fnmatch import fnmatchcase
from fractions import Fraction

from rbpsym.document.model import Block
from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen
from rbpsym.statement.source import SourceItem as Entry
from rbpsym.statement.source import did_you_mean
from rbpsym.teaching import model as m
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.targets import Target


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
    named = [x for x in bench.targets.values() if not wish.about or _is_named(x.id, wish)]
    if not named:
        hint = did_you_mean(wish.about[0], bench.ids, "quantities of this problem")
        raise wish.error(f"“{bench.name}” has no quantity “{', '.join(wish.about)}” (or it is zero)", hint)
    found = [target for target in named if fits(target)]
    if not found:
        ids = ", ".join(x.id for x in bench.targets.values() if fits(x))
        raise wish.error(
            f"no {wish.kind} task can be made about “{', '.join(wish.about) or bench.name}”: {why}",
            f"quantities that can be asked so: {ids}." if ids else "choose another kind of task for this problem.",
        )
    return found


def _is_named(id: str, wish: Wish) -> bool:
    return any(fnmatchcase(id, pattern) for pattern in wish.about)
