"""A problem of which something is asked, with its phases, and a moment of its motion."""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import suppress

from rbpsym.ask.undetermined import opened
from rbpsym.errors import Indistinct, LimitError, NotApplicable, StatementError, there
from rbpsym.field import Scalar, kept
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.arrivals import ArrivalState, with_starts
from rbpsym.mechanics.at_start import StartStudy, study_of
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.instant import has_start
from rbpsym.mechanics.phases import HandOver, Stage, known_stages
from rbpsym.mechanics.pushing import check_start
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.study import Study
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.model import Phase, Problem
from rbpsym.statement.source import did_you_mean


class NoClosedForm(StatementError):
    """What is asked has no closed form that is found here; with numbers it may be found."""


class NotMet(StatementError):
    """A moment does not come at any of the numbers that were tried."""


class Moment(Frozen):
    """A state in a phase: its place among the phases, what is true there, how it is met: at the "start", at the "event" with
    which `phase` would begin, at "rest", at a "time"; the `courses` of the coordinates that lead there,
    those of `is_small` oscillations or of the motion; whether it `is_open` that
    the motion comes there; what is `watched` there, its value, and the time in letters."""

    place: int
    state: ArrivalState
    how: str = "start"
    phase: Phase | None = None
    courses: Mapping[str, InTime] = field(default_factory=dict)
    is_small: bool = False
    is_open: bool = False
    watched: tuple[str, Scalar, Scalar | None] | None = None


class Asked(Frozen):
    """A problem that is asked, its phases worked out when a question needs them; `known`: the mechanics, if it was made."""

    problem: Problem
    known: Study | None = None

    @kept
    def _known(self) -> tuple[tuple[Stage, ...], NotApplicable | None]:
        return known_stages(self.problem)

    @kept
    def first(self) -> Study:
        """The mechanics of the first phase. Raises StatementError where it surely does not begin as stated."""
        if self.known is not None and not self.problem.phases:
            return self.known
        study = study_of(replace(self.problem, phases=()))
        try:
            with suppress(LimitError):
                check_start(study, moves=not self.lasting)
        except Indistinct as error:
            return opened(study, error)
        return study

    @kept
    def begun(self) -> Asked | None:
        """The same of which only the start is told, where its conditions may be solved there; with the starts that they tell."""
        start = StartStudy(with_starts(self.first) if self.first.ties else replace(self.problem, phases=()))
        return Asked(start.problem, start) if has_start(start.problem) and start.ties and not self.first.at_start else None

    @property
    def names(self) -> list[str]:
        """Names of all phases; the first is called as the problem is, unless a later one is."""
        later = [phase.name for phase in self.problem.phases]
        return ["first" if self.problem.name in later else self.problem.name, *later]

    def study(self, place: int) -> Study:
        """The mechanics of a phase. Raises NotApplicable where its beginning has no closed form."""
        if place == 0:
            return self.first
        stages, reason = self._known
        if place >= len(stages):
            raise there(reason)
        return stages[place].study

    def stage(self, place: int) -> Stage:
        """A phase with how it began. Raises NotApplicable."""
        self.study(place)
        return self._known[0][place]

    def began(self, place: int) -> HandOver:
        """How a later phase begins. Raises NotApplicable."""
        return there(self.stage(place).began)

    @property
    def held(self) -> list[str]:
        """Names of all constraints."""
        problems = (self.problem, *(phase.problem for phase in self.problem.phases))
        return list(dict.fromkeys(element.name for each in problems for element in each.constraints))

    @kept
    def whole(self) -> ProblemWorld:
        """The quantities of the whole motion: what happens when its phases begin."""
        return ProblemWorld(study_of(self.problem))

    @kept
    def lasted(self) -> dict[int, tuple[tuple[Demand, ...], tuple[str, ...]]]:
        """What phases ask for to last up to their ends, as far as that was looked at."""
        return {}

    @kept
    def _worlds(self) -> dict[int, ProblemWorld]:
        return {}

    def world(self, place: int) -> ProblemWorld:
        """The quantities of a phase by their names."""
        if place not in self._worlds:
            self._worlds[place] = ProblemWorld(self.study(place))
        return self._worlds[place]

    def place(self, study: Study) -> int:
        """The place of the phase of which this is the mechanics."""
        return next((k for k in range(len(self.names)) if self.study(k) is study), 0)

    @property
    def lasting(self) -> int:
        """The place of the first phase that does not end at once."""
        phases = self.problem.phases
        return next((k for k, phase in enumerate(phases) if phase.event != "at once"), len(phases))

    def meant(self, place: int | None) -> int:
        """The place of the phase that is named, else of the first that does not end at once."""
        return self.lasting if place is None else place

    def named(self, name: str) -> int:
        """The place of a phase, by its name or that of a blow at its beginning. Raises StatementError."""
        name = re.sub(r"^(?:phase |blow |collision |impulse )?", "", name)
        blows = {e.name: k for k, phase in enumerate(self.problem.phases, 1) for e in phase.impulses}
        known = {"first": 0} | {name: k for k, name in enumerate(self.names)} | blows
        before = (self.problem, *(phase.problem for phase in self.problem.phases))
        struck = {k for k, phase in enumerate(self.problem.phases, 1) if _is_struck(phase, before[k - 1])}
        known |= dict.fromkeys(("blow", "bounce", "collision", "impact", "impulse"), *struck) if len(struck) == 1 else {}
        if name not in known:
            hint = did_you_mean(name, list(known), "phases") if self.problem.phases else "the problem has no [[phases]]."
            raise StatementError(f"there is no phase or blow “{name}”", instead=hint)
        return known[name]


def _is_struck(phase: Phase, before: Problem) -> bool:
    """Whether impulses act when it begins: stated ones, or those with which a new constraint is met."""
    new = {element.name for element in phase.problem.constraints} - {element.name for element in before.constraints}
    return bool(phase.impulses or new)
