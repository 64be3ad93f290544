"""The time in phases: it counts from the beginning of each, so what is given as a function of the time is shifted.

A drive s = v t of the first phase is s = v (t₁ + t) in the one that begins at t₁.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.errors import NotApplicable
from rbpsym.notation.tree import Node, Sym, add
from rbpsym.statement.model import Body, Element, Phase, Problem
from rbpsym.statement.scope import CLOCK
from rbpsym.statement.substitution import substitute


def shifted(phase: Phase, begins: Scalar | None) -> Problem:
    """The problem of a phase with t counted from its beginning. Raises NotApplicable where that moment has no
    closed form (None) and something is given as a function of the time."""
    problem = phase.problem
    if begins == NOTHING or not any(map(_runs, _given(problem))):
        return problem
    if begins is None:
        raise NotApplicable(
            f"the moment at which the phase “{phase.name}” begins has no closed form, and in it something is given as "
            f"a function of the time",
            instead="state this phase as a problem of its own.",
        )
    later = {CLOCK: add(present(begins), Sym(CLOCK))}
    return replace(
        problem,
        bodies=tuple(_body(body, later) for body in problem.bodies),
        interactions=tuple(_element(element, later) for element in problem.interactions),
        constraints=tuple(_element(element, later) for element in problem.constraints),
    )


def _given(problem: Problem) -> list[Node]:
    elements = (*problem.interactions, *problem.constraints)
    found = [value for element in elements for value in element.values.values()]
    found += [part for body in problem.bodies for part in (body.angle, body.placed and body.placed[1])]
    parts = [part for value in found for part in (value if isinstance(value, tuple) else (value,))]
    return [part for part in parts if isinstance(part, Node)]


def _runs(node: Node) -> bool:
    return depends_on(scalar(node), CLOCK)


def _element(element: Element, later: Mapping[str, Node]) -> Element:
    return replace(element, values={key: _later(value, later) for key, value in element.values.items()})


def _body(body: Body, later: Mapping[str, Node]) -> Body:
    placed = body.placed and (body.placed[0], _later(body.placed[1], later))
    return replace(body, angle=_later(body.angle, later), placed=placed)


def _later(value: object, later: Mapping[str, Node]) -> object:
    if isinstance(value, tuple):
        return tuple(_later(part, later) for part in value)
    return substitute(value, later) if isinstance(value, Node) else value
