"""What the constraints make of the coordinates: solved for, tied by equations, tied in their speeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rbpsym.decide.assumptions import Assumptions
from rbpsym.errors import StatementError
from rbpsym.field import Meanings, Scalar, depends_on, is_zero, substitute, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.conditions import (
    all_conditions,
    from_start,
    full_rates,
    integrated,
    only_place,
    rate_conditions,
    solve_explicitly,
)
from rbpsym.mechanics.geometry import Geometry, start_numbers, unsaid
from rbpsym.mechanics.inertia import Inertia
from rbpsym.mechanics.placing import Inertias, locator
from rbpsym.mechanics.system import BodyState, ConstraintCondition, Pose, at_point
from rbpsym.present.forms import present
from rbpsym.statement.model import Problem
from rbpsym.typeset.machine import to_machine

Ties = tuple[ConstraintCondition, ...]
Rates = dict[int, ConstraintCondition]  # conditions on the speeds by their place among all of them


class Tied(Frozen):
    """`solved`: names in terms of the others; `implicit`: conditions that stay as equations;
    `speeds`: conditions on the speeds that are no rates; `conditions`: all on the position."""

    solved: Mapping[str, Scalar]
    implicit: Ties
    speeds: Ties
    conditions: Ties


def tie(
    problem: Problem, inertias: Inertias, given: Mapping[str, Pose], names: tuple[str, ...], *, is_whole: bool = False
) -> Tied:
    """Conditions on the position first; then those on the speeds, integrated one after the other (`is_whole`: see
    `conditions.solve_explicitly`)."""
    conditions = all_conditions(problem, _geometry(problem, inertias, given))
    solved, implicit = solve_explicitly(conditions, names, problem, is_whole=is_whole)
    waiting, done = _rates(problem, inertias, given, solved, names), set()
    while (step := _first_integral(waiting, names, problem)) is not None:
        place, found = step
        done.add(place)  # also where the place that follows has no closed form: its rate says nothing new
        conditions = (*conditions, found)
        solved, implicit = solve_explicitly(conditions, names, problem, is_whole=is_whole)
        try:
            rates = _rates(problem, inertias, given, solved, names)
        except StatementError as error:  # what was drawn well before is not with the constant that was taken
            raise _begins_nowhere(found, solved, problem) or error from None
        _check_kept(found, rates.get(place), solved, implicit, problem)
        waiting = {place: rate for place, rate in rates.items() if place not in done}
    return Tied(solved, implicit, tuple(waiting.values()), conditions)


def _check_kept(
    found: ConstraintCondition, again: ConstraintCondition | None, solved: Mapping[str, Scalar], implicit: Ties, problem: Problem
) -> None:
    """A condition that was solved holds from then on, unless its solution turned the geometry over (a string that
    would run upwards instead of downwards, since nothing says where its end is)."""
    if again is None or any(condition.constraint == found.constraint for condition in implicit):
        return
    used = [c for c in problem.coordinates if depends_on(found.value, c.name)]
    open_ones = [c.name for c in used if c.start is None]
    name = next((n for n in open_ones if n in solved), open_ones[0] if open_ones else used[-1].name)
    place = to_machine(present(solved[name])) if name in solved else "this place"
    raise StatementError(
        f"the constraint “{found.constraint}” can't be kept as it is drawn: with {name} = {place} it would run the "
        f"other way round",
        instead=f'say where things are at the start, so that its length is known: start = "{name}_0" for {name}.',
        place=next(e.place for e in problem.constraints if e.name == found.constraint),
    )


def _begins_nowhere(found: ConstraintCondition, solved: Mapping[str, Scalar], problem: Problem) -> StatementError | None:
    """The sentence for a place that follows up to a constant, of which nothing says where it begins."""
    for c in problem.coordinates:
        if c.start is None and c.name in solved and depends_on(found.value, c.name):
            return StatementError(
                f"the constraint “{found.constraint}” tells how “{c.name}” changes, but not where it begins",
                instead=f'say where it is at the start: start = "{c.name}_0".',
                place=c.place,
            )
    return None


def _geometry(problem: Problem, inertias: Inertias, placed: Mapping[str, Pose]) -> Geometry:
    return Geometry(locator(problem, inertias, placed), placed, start_numbers(problem), unsaid=unsaid(problem))


def _rates(
    problem: Problem, inertias: Inertias, given: Mapping[str, Pose], solved: Mapping[str, Scalar], names: Sequence[str]
) -> Rates:
    """The conditions on the speeds that do not hold identically, in the names that are left."""
    placed = {n: Pose(p.origin.substitute(solved), substitute(p.angle, solved)) for n, p in given.items()}
    scope = Meanings(rates=full_rates([name for name in names if name not in solved]))
    geometry = _geometry(problem, inertias, placed)
    states = {name: _state(name, inertias[name], pose, scope) for name, pose in placed.items()}
    moving = Geometry(geometry.where, placed, geometry.numbers, states, geometry.unsaid)
    return {place: c for place, c in enumerate(rate_conditions(problem, moving)) if not is_zero(c.value)}


def _state(name: str, own: Inertia, pose: Pose, scope: Meanings) -> BodyState:
    center = at_point(pose, (own.x, own.y)) if own.x or own.y else pose.origin
    return BodyState(name, own, pose, center, center.rate(scope.rates), time_derivative(pose.angle, scope))


def _first_integral(waiting: Rates, names: tuple[str, ...], problem: Problem) -> tuple[int, ConstraintCondition] | None:
    """The first condition that is the rate of a position, integrated from the start, with its place."""
    start = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    for place, condition in waiting.items():
        found = integrated(condition.value, names)
        if found is not None:
            return place, ConstraintCondition(condition.constraint, from_start(found, names, start), condition.what)
    return None


def placed_by(ties: Ties, names: Sequence[str], known: Mapping[str, Scalar], given: Assumptions) -> dict[str, Scalar]:
    """Where coordinates are of which ties to what is known leave one place in their range, whatever the parameters are."""
    found = dict[str, Scalar]()
    for tie in ties * len(ties):
        value = substitute(tie.value, {**known, **found})
        name, *others = [name for name in names if depends_on(value, name)] or [""]
        place = only_place(value, name, given.range_of(name), given) if name and not others else None
        found |= {} if place is None else {name: place}
    return found
