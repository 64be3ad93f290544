"""Speeds that are taken to be kept, since no acceleration is stated: told where an answer hangs on them."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from rbpsym.ask.found import Answer
from rbpsym.errors import RbpsymError, there
from rbpsym.expr import tree as t
from rbpsym.field import depends_on
from rbpsym.frozen import replace
from rbpsym.quantities import TIME, Quantity
from rbpsym.statement.completing import courses
from rbpsym.statement.letters import letters_of
from rbpsym.statement.model import Problem


def taken_for_kept(found: Answer, again: Callable[[Problem], Answer]) -> Answer:
    """The answer with the speeds that it takes to be kept: those with whose accelerations, if there were any, it would be another
    one, as is found when it is asked `again`."""
    problem, values = found.study.problem, None
    gains = {c.name: letters_of(problem).free(f"gain_{c.name}") for c in problem.kept}
    coordinates = tuple(replace(c, acceleration=t.Sym(gains[c.name])) if c.name in gains else c for c in problem.coordinates)
    added = tuple(Quantity(gains[c.name], c.quantity.dimension / TIME**2, sign="real") for c in problem.kept)
    doubted = replace(problem, coordinates=coordinates, parameters=(*problem.parameters, *added), led=courses(coordinates))
    with suppress(RbpsymError):
        values = again(doubted).values
    speeds = {c.name: t.equation(t.Sym(f"{c.name}_dot"), there(c.speed)) for c in problem.kept}
    told = (name for name in speeds if values is None or any(depends_on(value, gains[name]) for value in values))
    return replace(found, kept=tuple(speeds[name] for name in told))
