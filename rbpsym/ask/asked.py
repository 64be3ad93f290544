"""A problem of which something is asked, with its phases, and a moment of its motion."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import permutations

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.errors import Ambiguous, Indistinct, LimitError, NotApplicable, StatementError, Undecided, there
from rbpsym.field import NOTHING, Poly, Scalar, depends_on, derivative, kept, names_in, short, substitute, symbol
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.arrivals import ArrivalState, with_starts
from rbpsym.mechanics.at_start import StartStudy, study_of
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.instant import has_start
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.phases import HandOver, Stage, known_stages
from rbpsym.mechanics.pushing import check_start
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.stability import essential
from rbpsym.mechanics.study import Study
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.model import Phase, Problem
from rbpsym.statement.source import did_you_mean

MOST, HALF = 60, Fraction(1, 2)  # inequalities


def opened(study: Study, error: Indistinct) -> Study:
    """The same with forces of static friction left open until the equations of rest tell all others. Raises the error where
    these are not what they do not tell apart, or something moves."""
    system = study.system
    rough = [element["friction"] for element in system.problem.constraints if "limit" in element.values]
    name = next((name for name in reversed(rough) if name in error.free and name in system.unknowns), None)
    if name is None or system.independent:
        raise error
    forces = (replace(force, unknowns=tuple(n for n in force.unknowns if n != name)) for force in system.forces)
    other = study.of(replace(system, forces=tuple(forces)))
    try:
        known = other.dynamics
    except Indistinct as more:
        return opened(other, more)
    vars(other)["_dynamics"] = replace(known, reactions={**known.reactions, name: symbol(name)})
    return other


def left_open(study: Study) -> frozenset[str]:
    """The forces of static friction that are left open."""
    return frozenset(() if study.at_start else study.dynamics.reactions.keys() - {*study.system.unknowns})


def bearable(
    study: Study, held: Iterable[FrictionNeed], given: Assumptions, asked_for: str
) -> tuple[tuple[Scalar, ...], Assumptions, tuple[Demand, ...]]:
    """What must not be negative for the forces to be such as contacts and friction (`held`) can bear, with what is known and the
    case that is told, if there are several: that of the sample numbers, as far as it does not depend on what is asked for.
    Raises Undecided where it is not decided by conditions that all have to hold."""
    cases = dict[Scalar, Demand]()
    force = study.dynamics.reactions.__getitem__
    rows = [force(name) for element in study.problem.constraints for name in pushes(element)]
    for need in held:
        most = sum(map(force, need.normals), NOTHING) * there(need.limit)
        rows += [most + force(need.friction) * side for side in (-1, 1)]
    for name in left_open(study):
        lines = [(short(derivative(row, name)), short(substitute(row, {name: NOTHING}))) for row in rows]
        try:
            rows = _eliminated(lines, given)
        except Undecided:
            for a in (a for a, _ in lines if a and not sign(a, given).sense and not depends_on(a, asked_for)):
                way = 1 if floating(a, sample(study.problem, study.problem.example)) > 0 else -1
                cases.setdefault(essential(a, given), Demand(a * way))
            given = assuming(given, cases.values(), tighter=True, whole=True)
            rows = _eliminated(lines, given)
    return tuple(rows), given, tuple(cases.values())


def _eliminated(lines: Sequence[tuple[Scalar, Scalar]], given: Assumptions) -> list[Scalar]:
    rows = list(dict.fromkeys(row for row in _without(lines, given) if not sign(row, given).is_nonnegative))
    if len(rows) > MOST:
        raise Undecided(OPEN)
    return rows


OPEN = "whether forces that friction can bear keep it at rest is not decided by one condition"


def _without(lines: Sequence[tuple[Scalar, Scalar]], given: Assumptions) -> Iterator[Scalar]:
    """What a x + b ≥ 0 of all (a, b) ask for there to be such an x."""
    yield from (b for a, b in lines if not a)
    for (a, b), (c, d) in permutations([line for line in lines if line[0]], 2):
        signs = [sign(part, given).sense for part in (a, -c)]
        if -1 in signs:
            continue  # not a lower and an upper bound
        gap, open_ = short(a * d - c * b), [part for part, way in zip((a, -c), signs, strict=True) if not way]
        if _follows(gap, open_, given):
            continue
        if not all(_follows(gap, [-part], given) for part in open_):
            raise Undecided(OPEN)  # it is asked for in some cases only
        yield gap


def _follows(value: Scalar, known: Sequence[Scalar], given: Assumptions) -> bool:
    """Whether a value is sure not to be negative where what is known is not: at both ends to which that bounds a quantity in
    which the value is linear; or as a sum of multiples of what is known, and of what is positive."""
    if sign(value, given).is_nonnegative:
        return True
    for k, fact in enumerate(known):
        others = [*known[:k], *known[k + 1 :]]
        for name in sorted(names_in(fact)):
            gain, slope = short(derivative(value, name)), short(derivative(fact, name))
            way = 0 if depends_on(gain, name) or depends_on(slope, name) else sign(slope, given).sense
            ends = list(given.range_of(name)) if way else []
            ends = [NOTHING, *ends[1:]] if ends[:1] == [None] and given.sign_of(name) == "positive" else ends
            for side in {1: (0,), -1: (1,)}.get(way, ()):
                ends[side] = -substitute(fact, {name: NOTHING}) / slope
            turns = zip(ends, (-gain, gain), strict=bool(way))
            if way and all(_at_end(value, gone, name, end, others, given) for end, gone in turns):
                return True
        for m, c in value.num.terms.items():
            for n, e in fact.num.terms.items():
                share = short(Scalar(Poly({m: c})) / Scalar(Poly({n: e})) * Scalar(fact.den) / Scalar(value.den))
                parts = (1, HALF) if sign(share, given).sense > 0 else ()
                if any(_follows(short(value - fact * share * part), known[k + 1 :], given) for part in parts):
                    return True
    return False


def _at_end(value: Scalar, gain: Scalar, name: str, end: Scalar | None, known: Sequence[Scalar], given: Assumptions) -> bool:
    """The same at one end of the range of a name; where it has none, by what it gains on the way there."""
    if end is None:
        return _follows(gain, known, given)
    return _follows(short(substitute(value, {name: end})), [short(substitute(fact, {name: end})) for fact in known], given)


class NoClosedForm(Ambiguous):
    """What is asked has no closed form that is found here; with numbers it may be found."""


class NotMet(Ambiguous):
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
        struck = struck_phases(self.problem)
        known |= dict.fromkeys(("blow", "bounce", "collision", "impact", "impulse"), *struck) if len(struck) == 1 else {}
        if name not in known:
            hint = did_you_mean(name, list(known), "phases") if self.problem.phases else "the problem has no [[phases]]."
            raise StatementError(f"there is no phase or blow “{name}”", instead=hint)
        return known[name]


def struck_phases(problem: Problem) -> list[int]:
    """The places of the phases that begin with impulses: stated ones, or those with which a new constraint is met."""
    stages = (problem, *(phase.problem for phase in problem.phases))
    names = [{element.name for element in stage.constraints} for stage in stages]
    return [k for k, phase in enumerate(problem.phases, 1) if phase.impulses or names[k] - names[k - 1]]
