"""Accelerations as a compiled function of numbers, for those who want to integrate the motion themselves.

M q̈ = f is never solved in symbols: the entries of M and f, which stay short, are compiled with
their common subexpressions evaluated once, and the small linear system is solved at each call.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rbpsym.algebra.calculus import names_in
from rbpsym.algebra.sympy_bridge import lambdified
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

    study = problem if isinstance(problem, Study) else Study(problem)
    system, dynamics = study.system, study.dynamics
    entries = [value for row in dynamics.mass_matrix for value in row] + list(dynamics.forcing)
    arguments = [*system.coordinates, *system.speeds]
    _check_numbers(entries, {*arguments, "t", *numbers}, study.problem)
    evaluate, size = lambdified(entries, ["t", *arguments, *numbers]), len(system.speeds)
    values = [float(value) for value in numbers.values()]

    def accelerations(t: float, q: Sequence[float], u: Sequence[float]):
        found = np.array(evaluate(t, *q, *u, *values), dtype=float)
        return np.linalg.solve(found[: size * size].reshape(size, size), found[size * size :])

    return accelerations


def _check_numbers(entries, known: set[str], problem: Problem) -> None:
    missing = sorted(set().union(*(names_in(value) for value in entries)) - known - {"pi"})
    if missing:
        raise StatementError(
            f"the accelerations of “{problem.name}” need a number for {', '.join(missing)}",
            instead="give every parameter a value: {" + ", ".join(f'"{name}": 1.0' for name in missing) + "}.",
        )
