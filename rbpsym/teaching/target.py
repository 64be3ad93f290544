"""A quantity that a worksheet can ask for: how its value is found in any study, and what a number is read off it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, short
from rbpsym.field.roots import has_squared_roots, without_even_roots
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.motion import along_motion
from rbpsym.mechanics.study import Study
from rbpsym.quantities import Dimension


class RootReading(Frozen):
    """The number that is asked for, where it is not the value itself: v from v², T from ϑ²."""

    left: t.Node
    node: Callable[[t.Node], t.Node]
    number: Callable[[float], float]
    dimension: Dimension
    unit_name: str = ""


class Target(Frozen):
    """A quantity to be asked for.

    id is unique in the problem and begins with the kind, a key of `KINDS`; `left` its symbol; `of(study)` its
    value, None where a study gives none; `dimension` with `unit_name` (torque and energy have one dimension);
    `step` the id of the step that shows it, if it is another; `slots` fill the phrases `ask.<kind>`.
    `reading`: how a number is read off it.
    """

    id: str
    left: t.Node
    of: Callable[[Study], Scalar | None]
    dimension: Dimension
    step: str = ""
    slots: Mapping[str, Any] = field(default_factory=dict)
    unit_name: str = ""
    reading: RootReading | None = None

    @property
    def kind(self) -> str:
        """The key in `KINDS`."""
        return self.id.partition(".")[0]

    def value(self, study: Study) -> Scalar | None:
        """The value in a study; None where it has none or the mechanics refuses."""
        try:
            found = self.of(study)
        except REFUSALS:
            return None
        return None if found is None else short(without_even_roots(found) if has_squared_roots(found) else found)

    def known(self, study: Study, *, along: bool = False) -> Scalar:
        """The value in the right study (`along` its motion), which has one: else it is not asked for."""
        found = self.along(study) if along else self.value(study)
        assert found is not None, self.id
        return found

    def along(self, study: Study, value: Scalar | None = None) -> Scalar | None:
        """The value (as it was found, if it is given) as a function of the position alone, with the speeds from the start."""
        found = self.value(study) if value is None else value
        try:
            return None if found is None else along_motion(found, study.squares)
        except REFUSALS:
            return None


# how the mechanics says that a changed system has no such value
REFUSALS = (RbpsymError, ZeroDivisionError, KeyError, ValueError, IndexError, StopIteration)
