"""Accelerations as a compiled function of numbers, for those who want to integrate the motion themselves.

M q̈ = f is never solved in symbols: the entries of M and f, which stay short, are compiled,
and the small linear system is solved at each call.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rbpsym.errors import NotApplicable, StatementError
from rbpsym.field import Scalar
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.unsolvable import untold
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
    study = problem if isinstance(problem, Study) else Study(problem)
    rates, places = compiled_rates(study, numbers), len(study.system.coordinates)
    return lambda t, q, u: rates(t, (*q, *u))[places:]


def compiled_rates(study: Study, numbers: Mapping[str, float], others: Sequence[str] = ()) -> Compiled:
    """f(t, y, *values) → ẏ for y = (q, u): the rates of all coordinates and of the independent speeds, a numpy array.

    `values` are those of the parameters `others`. Raises StatementError for a parameter that has no value, NotApplicable
    where masses are not stated and a coordinate is free.
    """
    import numpy as np

    if study.problem.unstated and study.system.independent:
        raise NotApplicable(untold(study.system).what)
    evaluate, size = compiled_values(study, entries_of(study), numbers, others), len(study.system.speeds)

    def rates(t: float, y: Sequence[float], *values: float) -> Any:
        mass, force, speeds = np.split(evaluate(t, y, *values), [size * size, size * size + size])
        return np.concatenate((speeds, np.linalg.solve(mass.reshape(size, size), force)))

    return rates


def compiled_values(study: Study, values: Sequence[Scalar], numbers: Mapping[str, float], others: Sequence[str] = ()) -> Compiled:
    """f(t, y, *values) → a numpy array of the values, each an array where t and the parts of y are arrays.

    y and the arguments behind it are those of `compiled_rates`, which raises the same errors.
    """
    import numpy as np

    from rbpsym.numeric.formulas import compiled

    evaluate, arguments = compiled(values), ("t", *study.system.coordinates, *study.system.speeds, *others)
    _check_numbers(set(evaluate.names) - {*arguments, "pi", *numbers}, study.problem)

    def evaluated(t: Any, y: Any, *rest: float) -> Any:
        found = evaluate({**numbers, **dict(zip(arguments, (t, *y, *rest), strict=True))})
        return np.array([value + 0.0 * np.asarray(t) for value in found])  # a constant has a value at each moment

    return evaluated


def entries_of(study: Study) -> list[Scalar]:
    """What is compiled: the entries of M, row by row, those of f, and the rates of the coordinates."""
    system, dynamics = study.system, study.dynamics
    inertia = [value for row in dynamics.mass_matrix for value in row]
    return [*inertia, *dynamics.forcing, *(system.scope.rates[name] for name in system.coordinates)]


def _check_numbers(missing: set[str], problem: Problem) -> None:
    if missing:
        told = ", ".join(f'"{name}": 1.0' for name in sorted(missing))
        what = f"the formulas of “{problem.name}” need a number for {', '.join(sorted(missing))}"
        raise StatementError(what, instead=f"give every parameter a value: {{{told}}}.")
