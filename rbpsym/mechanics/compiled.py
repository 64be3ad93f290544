"""Accelerations as a compiled function of numbers, for those who want to integrate the motion themselves.

M q̈ = f is never solved in symbols: the entries of M and f, which stay short, are compiled,
and the small linear system is solved at each call.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rbpsym.errors import StatementError
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Problem

Compiled = Callable[..., Any]


def compiled_accelerations(problem: Problem | Study, numbers: Mapping[str, float]) -> Compiled:
    """f(t, q, u) → q̈, a numpy array.

    `numbers` are the parameters' values (in units that agree, SI say; angles in radians); q the
    coordinates in the order of `study.system.coordinates`, u the speeds and q̈ the accelerations of
    `study.system.independent` (the same, unless conditions tie them). Raises StatementError if a
    parameter has no value.

    >>> from rbpsym import load_text
    >>> pendulum = load_text('''[parameters]
    ... m = "mass"
    ... l = "length"
    ... g = "acceleration"
    ... [coordinates.theta]
    ... [bodies.rod]
    ... shape = "rod"
    ... mass = "m"
    ... length = "l"
    ... angle = "theta - pi/2"
    ... [interactions.W]
    ... type = "gravity"
    ... [constraints.P]
    ... type = "pivot"
    ... point = "rod.start"
    ... at = "O"
    ... ''')
    >>> f = compiled_accelerations(pendulum, {"m": 1.0, "l": 1.5, "g": 10.0})
    >>> float(f(0.0, [1.5707963267948966], [0.0])[0])
    -10.0
    """
    import numpy as np

    from rbpsym.numeric.formulas import compiled

    study = problem if isinstance(problem, Study) else Study(problem)
    system, dynamics = study.system, study.dynamics
    evaluate = compiled([*(value for row in dynamics.mass_matrix for value in row), *dynamics.forcing])
    arguments, size = (*system.coordinates, *system.speeds), len(system.speeds)
    _check_numbers(set(evaluate.names) - {*arguments, "t", "pi", *numbers}, study.problem)

    def accelerations(t: float, q: Sequence[float], u: Sequence[float]):
        found = evaluate({**numbers, "t": t, **dict(zip(arguments, (*q, *u), strict=True))})
        return np.linalg.solve(found[: size * size].reshape(size, size), found[size * size :])

    return accelerations


def _check_numbers(missing: set[str], problem: Problem) -> None:
    if missing:
        told = ", ".join(f'"{name}": 1.0' for name in sorted(missing))
        raise StatementError(
            f"the accelerations of “{problem.name}” need a number for {', '.join(sorted(missing))}",
            instead=f"give every parameter a value: {{{told}}}.",
        )
