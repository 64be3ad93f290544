"""Speeds, accelerations and forces at the start, where formulas for every position grow too long.

With all coordinates free, the rates of the conditions are linear in the speeds; at the start their coefficients are
constants. The second rates are linear in the accelerations, Newton's and Euler's equations in these and the unknown
forces. Beer & Johnston, Dynamics, 15.4 and 16.4; Meriam & Kraige, Dynamics, 5/6 and 6/5.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, Scalar, is_zero, names_in, substitute, symbol, time_derivative
from rbpsym.frozen import Frozen
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.elimination import Solution, solve_linear
from rbpsym.mechanics.system import ConstraintCondition, System
from rbpsym.mechanics.unsolvable import contradictory, indistinct
from rbpsym.statement.model import Problem

Values = Mapping[str, Scalar]


class Instant(Frozen):
    """The start of a motion in which every coordinate is free.

    `places` and `speeds` of all coordinates; `sought`: the speeds that follow from the conditions; `rates`,
    `seconds`: the first and second rates of the conditions there, in the speeds that are sought and in the
    accelerations; `accelerations` of the free coordinates and `reactions`: the unknown forces.
    """

    places: Values
    speeds: Values
    sought: tuple[str, ...]
    rates: tuple[ConstraintCondition, ...]
    seconds: tuple[ConstraintCondition, ...]
    accelerations: Values
    reactions: Values
    followers: int = 0

    @property
    def freedom(self) -> int:
        """How many speeds are free (a dependent coordinate has none of its own)."""
        return len(self.accelerations) - self.followers - len(self.seconds)


def has_start(problem: Problem) -> bool:
    """Whether every coordinate has a place and a speed at the start."""
    return all(c.start is not None and c.speed is not None for c in problem.coordinates)


def start_of(system: System, tidy: Callable[[Scalar], Scalar]) -> Instant:
    """What holds at the start of a free system (`assemble(problem, free=True)`); `tidy` takes squares out of roots.

    Raises StatementError where the start contradicts the conditions, or these leave a speed or a force open there.
    """
    _check_places(system)
    given = system.scope.start
    rows = [ConstraintCondition(c.constraint, time_derivative(c.value, system.scope), c.what) for c in system.implicit]
    rows += system.speed_ties
    speeds, sought, first = _speeds(system, rows, tidy)
    here = {**given, **speeds}

    def at_start(value: Scalar) -> Scalar:
        return tidy(substitute(value, here))

    second = [ConstraintCondition(c.constraint, at_start(time_derivative(c.value, system.scope)), c.what) for c in rows]
    laws = [at_start(value) for _, _, value in newton_euler_rows(system)]
    unknowns = (*system.accelerations, *system.unknowns)
    solution = solve_linear([*(c.value for c in second), *laws], unknowns)
    _check_solved(system, solution)
    found = {name: tidy(value) for name, value in solution.values.items()}
    tied = system.tied()
    names = [c.name for c in system.problem.coordinates]
    kinds = [f"{name}{rate}" for name in names for rate in ("", "_dot", "_ddot")]
    there = {name: at_start(tied.get(name, symbol(name))) for name in kinds}
    return Instant(
        {name: there[name] for name in names},
        {name: there[f"{name}_dot"] for name in names},
        sought,
        first,
        tuple(second),
        {f"{name}_ddot": tidy(substitute(there[f"{name}_ddot"], found)) for name in names},
        {name: found[name] for name in system.unknowns},
        len(system.dependent),
    )


def _check_places(system: System) -> None:
    for condition in system.implicit:
        gap = substitute(condition.value, system.scope.start)
        if not is_zero(gap):
            element = next(e for e in system.problem.constraints if e.name == condition.constraint)
            raise StatementError(
                f"the places at the start contradict the constraint “{condition.constraint}” ({element.kind})",
                instead="mend the start of a coordinate, so that it holds there; each place at the start is stated.",
                place=element.place,
            )


def _speeds(
    system: System, rows: list[ConstraintCondition], tidy: Callable[[Scalar], Scalar]
) -> tuple[Values, tuple[str, ...], tuple[ConstraintCondition, ...]]:
    """All speeds at the start, those that follow from the others, and the rates of the conditions in these.

    A speed other than zero is given; the others follow where something moves, and nothing moves that they leave open.
    """
    given = system.scope.start
    known = {name: given[name] for name in system.speeds if not is_zero(given[name])}
    places = {name: given[name] for name in given if name not in system.speeds}
    first = [ConstraintCondition(c.constraint, tidy(substitute(c.value, {**places, **known})), c.what) for c in rows]
    _check_distinct(system, rows, places)
    resting = dict.fromkeys(system.speeds, NOTHING)
    if all(is_zero(substitute(c.value, resting)) for c in first):
        return {**resting, **known}, (), ()
    solution = solve_linear([c.value for c in first], system.speeds, keep_free=True)
    loose = set().union(*map(names_in, solution.values.values()), *map(names_in, solution.left)) & {*system.speeds}
    if any(not is_zero(value) for value in solution.left) or loose:
        raise _wrong_speeds(system, first, sorted(loose))
    found = {name: tidy(value) for name, value in solution.values.items()}
    return {**resting, **known, **found}, tuple(n for n in system.speeds if n in found), tuple(first)


def _check_distinct(system: System, rows: list[ConstraintCondition], places: Values) -> None:
    """No condition asks at the start for what the others ask: else they tie the speeds no more (bars in one line)."""
    here = [substitute(condition.value, places) for condition in rows]
    for place, condition in enumerate(rows):
        solution = solve_linear(here[: place + 1], (*system.speeds,), keep_free=True)
        if len(solution.values) <= place and not any(solution.left):
            raise StatementError(
                f"at the start the constraint “{condition.constraint}” asks of the speeds what others ask already: the "
                "bodies are in a singular position (bars in one line), or the constraint is one too many",
                instead="let it start a little beside this position, or drop a constraint.",
                place=system.element(condition.constraint).place,
            )


def _wrong_speeds(system: System, rows: list[ConstraintCondition], loose: list[str]) -> StatementError:
    names = ", ".join(f"“{name}”" for name in dict.fromkeys(c.constraint for c in rows))
    if loose:
        return StatementError(
            f"the start speeds do not say how the motion goes on: {names} leave open how fast "
            f"“{loose[0].removesuffix('_dot')}” moves",
            instead=f'give [coordinates.{loose[0].removesuffix("_dot")}] a speed = "...".',
            place=system.problem.constraints[0].place,
        )
    return StatementError(
        f"the start speeds contradict the constraints {names}",
        instead="give the speed of as many coordinates as can move freely; the others follow.",
        place=system.element(rows[0].constraint).place,
    )


def _check_solved(system: System, solution: Solution) -> None:
    if solution.free:
        forces = tuple(name for name in solution.free if name in system.unknowns)
        raise indistinct(system, forces or solution.free)
    if any(not is_zero(value) for value in solution.left):
        raise contradictory(system)

