"""A derivation told with the physics of a misconception: the same chapters and methods, the wrong study."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import Step
from rbpsym.derive import AFTER, BEFORE
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.study import Study
from rbpsym.methods.registry import METHODS


def retold(wrong: Study) -> Mapping[str, Step]:
    """The steps by id; a chapter that the wrong physics has no answer to ends where it fails.

    The certificates say how each step fares *within* the wrong physics, no more.
    """
    draft = Draft(wrong)
    for write in (*BEFORE, *METHODS.values(), *AFTER):
        _tried(write, draft)
    return {step.id: step for step in draft.steps}


def _tried(write: Callable[[Draft], object], draft: Draft) -> None:
    try:
        write(draft)
    except (RbpsymError, KeyError, ValueError, ZeroDivisionError, StopIteration, IndexError):
        return
