"""The remarks on the results of a derivation: in a fixed order of what matters, each of them once in a text.

What drops out, and because of which pair of forces; what the result does not depend on; what it would be without an
interaction; what it becomes where something is small; which way it goes with its parameters. docs/remarks.md tells the rule.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from rbpsym.algebra.effort import at_most
from rbpsym.derivation.step import Derivation, Step
from rbpsym.errors import RbpsymError
from rbpsym.remarks.dependence import free_of, monotone
from rbpsym.remarks.limiting import small, without
from rbpsym.remarks.made import Made
from rbpsym.remarks.result import Result, results
from rbpsym.remarks.silent import drops_out

KINDS = (drops_out, free_of, without, small, monotone)  # from what matters most to what matters least
MOST: Mapping[str, int | None] = {"brief": 2, "standard": 3, "full": None}  # remarks on a result
ONCE = (drops_out, without, small, monotone)  # kinds of which shorter notes have one remark in a text
MOST_PRODUCTS = 100_000


def remarks(derivation: Derivation, detail: str) -> list[dict[str, list[Step]]]:
    """The sentences about each result by the id of its step, for each phase; what is refuted or not decided is not said."""
    before: set[object] = set()
    parts = (derivation, *(phase.derivation for phase in derivation.phases))
    return [{found.step.id: list(_chosen(found, detail, before)) for found in results(part)} for part in parts]


def _chosen(result: Result, detail: str, before: set[object]) -> Iterator[Step]:
    is_short, count = detail != "full", 0
    for kind in KINDS:
        for made in () if kind in before else guarded(kind, result):
            step = made.said()
            if not step.phrase or made.about in before or count == MOST[detail]:
                continue
            before.add(made.about)
            count += 1
            yield step
            if is_short and kind in ONCE:
                before.add(kind)
                break


def guarded(kind: Callable[[Result], Iterable[Made]], result: Result) -> list[Made]:
    """What cannot be decided is not said."""
    try:
        with at_most(MOST_PRODUCTS):
            return list(kind(result))
    except (RbpsymError, ZeroDivisionError):
        return []
