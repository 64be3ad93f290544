"""A problem of which only the start is told, because formulas for every position would grow too long."""

from __future__ import annotations

from types import MappingProxyType

from rbpsym.decide.rooted import neat
from rbpsym.errors import LimitError
from rbpsym.field import Scalar, apart, at_most, kept, substitute
from rbpsym.frozen import replace
from rbpsym.mechanics.assemble import assemble
from rbpsym.mechanics.dynamics import FEW_PRODUCTS
from rbpsym.mechanics.events import Losses
from rbpsym.mechanics.friction import FrictionNeed, friction_needs
from rbpsym.mechanics.instant import Instant, has_start, start_of
from rbpsym.mechanics.rest import Rest
from rbpsym.mechanics.study import MOST_PRODUCTS, Study
from rbpsym.mechanics.system import ConstraintCondition, System, by_letters
from rbpsym.mechanics.unsolvable import too_long
from rbpsym.statement.completing import course, has_plain_speed
from rbpsym.statement.model import Problem

ONLY_THERE = "formulas for every position would be long: accelerations and unknown forces are told at the start alone"


def study_of(problem: Problem) -> Study:
    """The mechanics of a problem: for every position, or else (`StartStudy`) at its start.

    That is where coordinates stay tied to each other, their start is stated in full, and the equations of motion grow
    too long or have no value there.
    """
    study = Study(problem := _evenly(problem))
    return StartStudy(problem) if has_start(problem) and StartStudy(problem).ties and _is_lost(study) else study


def _evenly(problem: Problem) -> Problem:
    """Where masses are not stated, and something is free, what begins with a plain speed is taken to keep it."""
    for c in problem.coordinates if problem.unstated else ():
        if has_plain_speed(c, problem) and assemble(problem).independent:
            problem = replace(problem, led={**problem.led, c.name: course(c)})
    return problem


def _is_lost(study: Study) -> bool:
    """Whether nothing is told for every position (where nothing is free to move, all that there is, is the start)."""
    try:
        with apart(), at_most(FEW_PRODUCTS):
            system = vars(study)["system"] = assemble(study.problem)  # here, since what is kept spends apart from this bound
            for name in system.coordinates:
                substitute(system.scope.rates[name], system.scope.start)
        study.dynamics  # noqa: B018
        return not (study.system.independent or study.system.has_clock)
    except (LimitError, ZeroDivisionError):
        return True


class StartStudy(Study):
    """All coordinates are free in its system; of the motion, only its start is known (`instant`)."""

    at_start = True  # only the start is told

    @kept
    def system(self) -> System:
        """Kinematics and forces, with the speeds at the start as the conditions make them."""
        if not has_start(self.problem):
            return self._free
        scope, speeds = self._free.scope, by_letters(self.instant.speeds)
        start = {name: speeds.get(name, value) for name, value in scope.start.items()}
        return replace(self._free, scope=replace(scope, start=start))

    @property
    def has_clock(self) -> bool:
        """Whether something depends on the time explicitly: asked before the speeds at the start are known."""
        return self._free.has_clock

    @property
    def ties(self) -> tuple[ConstraintCondition, ...]:
        """The conditions that tie coordinates to each other without an explicit solution."""
        return self._free.implicit

    @property
    def _dynamics(self) -> LimitError:
        return too_long(self.system)

    @kept
    def _free(self) -> System:
        return assemble(self.problem, free=True)

    @kept
    def instant(self) -> Instant:
        """What holds at the start. Raises StatementError where the start contradicts the conditions."""
        with apart(), at_most(MOST_PRODUCTS):
            return start_of(self._free, self.tidied)

    def tidied(self, value: Scalar) -> Scalar:
        """The value with what is known to be a square out of its roots."""
        return neat(value, self.assumptions)

    def begun(self, value: Scalar) -> Scalar:
        """The value with accelerations and unknown forces replaced by what they are at the start."""
        return substitute(substitute(value, self.instant.reactions), self.instant.accelerations)

    # what is not looked for, and not known
    first_integral = reactions_along_motion = open_balance = None
    squares = MappingProxyType({})
    works = equilibria = sides = ()
    rest = Rest(complete=None, reason=ONLY_THERE)
    ended = Losses(complete=None, reason=ONLY_THERE)

    @kept
    def friction_needs(self) -> tuple[FrictionNeed, ...]:
        """How much static friction the contacts need at the start."""
        return friction_needs(self.system, self.instant.reactions, self.assumptions)
