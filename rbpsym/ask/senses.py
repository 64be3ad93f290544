"""What holds in whichever sense the motion sets out: the same answer is asked of the motion of the other sense.

Where the sense is that of a start (sin θ₀ > 0), the other motion is the same problem with the start on the other side. Both
answers are certified; that they are one is exact algebra.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Answer
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat
from rbpsym.errors import RbpsymError, there
from rbpsym.expr import tree as t
from rbpsym.field import PI, depends_on, is_zero
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics.demands import Demand, assuming, settle
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft
from rbpsym.quantities import TIME, Quantity
from rbpsym.quantity.path import first_push
from rbpsym.statement.completing import courses
from rbpsym.statement.letters import letters_of
from rbpsym.statement.model import Problem


def whichever(asked: Asked, found: Answer, again: Callable[[Asked], Answer]) -> Answer:
    """The answer without the condition on the sense of the motion, if that of the other sense (asked `again`) is the same and
    asks for nothing more; where nothing sets the motion going, nothing is said."""
    for sense in of_sense(asked, _demands(found)) if found.verdict.is_proved else ():
        with suppress(RbpsymError):
            problem = _turned(asked.problem, asked.first.assumptions, sense)
            rest = [demand for demand in _demands(found) if not is_zero(demand.value - sense.value)]
            if problem is not None and _is_same(found, again(Asked(problem)), rest):
                nodes = Draft(found.study).asked([Demand(sense.value, "!=")])
                kept = (node for node in found.valid if not any(is_zero(d.value - sense.value) for d in _read(found.study, node)))
                found = replace(found, valid=(*nodes, *kept))
    return found


def turned(asked: Asked, stated: Sequence[Demand], name: str) -> Asked | None:
    """The same with a start on the other side, from which the motion sets out in the other sense; None if it does not tell."""
    for sense in of_sense(asked, [one for one in stated if depends_on(one.value, name)]):
        problem = _turned(asked.problem, asked.first.assumptions, sense)
        if problem is not None and name in {*asked.problem.implicit} - {*problem.implicit}:
            return Asked(problem)
    return None


def of_sense(asked: Asked, stated: Sequence[Demand]) -> Iterator[Demand]:
    """The conditions of an answer that tell the sense in which a coordinate sets out."""
    with suppress(RbpsymError):
        motion = asked.world(0).motion
        pushes = [first_push(motion, name) for name in motion.squares if name in motion.scope.start]
        either = (settle([Demand(push * way)], motion.assumptions) for push in pushes for way in (1, -1))
        told = [one for open_ in either if open_ is not None for one in open_]
        yield from (one for one in stated if one.op == ">" and any(is_zero(one.value - other.value) for other in told))


def _demands(found: Answer) -> list[Demand]:
    return [demand for node in found.valid for demand in _read(found.study, node)]


def _read(study: Study, node: t.Node) -> list[Demand]:
    rows = ((scalar(t.add(left, t.neg(right)), study.system.scope), op) for left, op, right in t.relations(node))
    return [Demand(gap if op in OPS else -gap, OPS.get(op, TURNED.get(op, op))) for gap, op in rows]


OPS, TURNED = {">": ">", ">=": ">=", "!=": "!="}, {"<": ">", "<=": ">="}


def _turned(problem: Problem, given: Assumptions, sense: Demand) -> Problem | None:
    """The problem in which the range of a start, or of another letter, says the contrary; None if no range does."""
    for quantity in problem.parameters:
        name = quantity.name
        is_round = name in problem.implicit and given.range_of(name) == (None, None)
        here = given.with_range(name, -PI, PI) if is_round else given  # what repeats itself starts in its first turn
        ends = assuming(here, [Demand(-sense.value)], tighter=True).range_of(name)
        if ends not in (here.range_of(name), (None, None)):
            lower, upper = (None if end is None else present(end) for end in ends)
            return narrowed(problem, replace(quantity, lower=lower, upper=upper))
    return None


def narrowed(problem: Problem, quantity: Quantity) -> Problem:
    """The problem, and all its phases, with another declaration of a parameter; of a start it is then a declared one."""
    parameters = tuple(quantity if each.name == quantity.name else each for each in problem.parameters)
    implicit = tuple(name for name in problem.implicit if name != quantity.name)
    phases = tuple(replace(phase, problem=narrowed(phase.problem, quantity)) for phase in problem.phases)
    return replace(problem, parameters=parameters, implicit=implicit, phases=phases)


def under(asked: Asked, found: Answer) -> Asked:
    """The problem with what the conditions of an answer say of single parameters as their bounds."""
    problem, given = asked.problem, asked.first.assumptions
    known = assuming(given, _demands(found), tighter=True)
    for quantity in problem.parameters:
        if (ends := known.range_of(quantity.name)) != given.range_of(quantity.name):
            lower, upper = (None if end is None else present(end) for end in ends)
            problem = narrowed(problem, replace(quantity, lower=lower, upper=upper))
    return Asked(problem)


def _is_same(found: Answer, other: Answer, rest: list[Demand]) -> bool:
    """Whether the other answer is proved to be the same, under no further condition."""
    given = assuming(other.study.assumptions, rest)
    told = (found.relation, found.says, found.holds_so, found.each, found.equation, found.at, len(found.values))
    return (
        other.verdict.is_proved
        and told == (other.relation, other.says, other.holds_so, other.each, other.equation, other.at, len(other.values))
        and all(is_zero(neat(a - b, given)) for a, b in zip(found.values, other.values, strict=True))
        and all(one in rest or settle([one], given) == () for one in _demands(other))
    )


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
