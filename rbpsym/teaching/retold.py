"""A derivation told with the physics of a misconception: the same chapters and methods, the wrong study."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from rbpsym.algebra.effort import at_most
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import Step
from rbpsym.derive import AFTER, BEFORE
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.study import Study
from rbpsym.methods.registry import METHODS

MOST_PRODUCTS = 400_000  # for one chapter; what grows beyond is no line of a student's paper
Write = Callable[[Draft], object]


class Retelling:
    """The steps of a wrong study by id, chapter by chapter, as far as they are asked for.

    A chapter that the wrong physics has no answer to ends where it fails. No step has a certificate: it is wrong.
    """

    def __init__(self, wrong: Study) -> None:
        self._draft = _Unchecked(wrong)
        self._waiting: Iterator[Write] = iter((*BEFORE, *METHODS.values(), *AFTER))

    def steps(self, ids: Iterable[str]) -> tuple[Step, ...] | None:
        """The steps with these ids; None if the wrong derivation lacks one."""
        wanted = tuple(ids)
        while not all(map(self._draft.has, wanted)):
            write = next(self._waiting, None)
            if write is None:
                return None
            _tried(write, self._draft)
        known = {step.id: step for step in self._draft.steps}
        return tuple(known[id] for id in wanted)


class _Unchecked(Draft):
    def certified(self, step: Step, named: tuple[str, ...]) -> Step:
        """The step as it is, with what its author names."""
        return replace(step, cites=named)


def _tried(write: Write, draft: Draft) -> None:
    try:
        with at_most(MOST_PRODUCTS):
            write(draft)
    except (RbpsymError, KeyError, ZeroDivisionError):  # KeyError: a premise that the wrong physics has not
        return
