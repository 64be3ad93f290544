"""The motion of a system in numbers, or why there is none that can be followed."""

from __future__ import annotations

import math

from rbpsym.document.plots.running import REST, Run, Stop
from rbpsym.document.plots.trajectory import Numbers, Trajectory
from rbpsym.errors import NotApplicable
from rbpsym.mechanics.study import Study

REASONS = {  # why there is no motion that can be followed
    "statics": "nothing moves: it is a problem of statics",
    "tied": "the speeds are tied by a condition that is no condition on the places",
    "no_start": "the statement does not say where the motion starts",
    "rest": REST,
}


def trajectory(
    study: Study, numbers: Numbers, end: float = math.inf, stop: Stop | None = None, *, displaced: bool = True
) -> Trajectory:
    """The motion from the start up to the time `end`, or to where `stop` changes its sign.

    What rests where it could move is `displaced` a little. Raises NotApplicable where the start or the
    accelerations are not known, or nothing moves.
    """
    require_motion(study)
    run = Run(study, dict(numbers), end, stop)
    return run.all(run.pushed(run.start()) if displaced else run.start())


def require_motion(study: Study) -> None:
    """Raises NotApplicable if there is no motion that could be followed."""
    system = study.system
    if not study.problem.coordinates:
        raise NotApplicable(REASONS["statics"])
    if system.speed_ties:
        raise NotApplicable(REASONS["tied"])
    if any(name not in system.scope.start for name in system.independent):
        raise NotApplicable(REASONS["no_start"])
