"""What is asked of a parameter on which the sense of a slip, or of a motion, depends: both motions are looked at."""

from __future__ import annotations

from dataclasses import replace

from rbpsym.ask.asked import Asked
from rbpsym.ask.concluded import concluded
from rbpsym.ask.finding import Finding
from rbpsym.ask.found import Answer
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.seen import AskedPhase
from rbpsym.ask.senses import narrowed, of_sense
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import all_of, undecided
from rbpsym.field import depends_on, derivative
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.pushing import asked as asked_of_start
from rbpsym.mechanics.roots import zeros
from rbpsym.present.forms import present

Part = tuple[AskedPhase, Finding]
ONE_SENSE = "in the motion of the other sense it may be otherwise"


def beyond(world: AskedPhase, name: str) -> tuple[Asked, int] | None:
    """The problem with the parameter where what slips at the start does so the other way, or where the motion sets out
    otherwise, which it does for greater (1) or lesser (-1) values; None where that does not depend on it, or is declared."""
    problem, given = world.asked.problem, world.asked.first.assumptions
    quantity = next((each for each in problem.parameters if each.name == name), None)
    starts = asked_of_start(world.asked.first) if quantity is not None else ()
    slips = [value for element, what, value in starts if what == "slip" and element.values.get("slip") == "auto"]
    ways = of_sense(world.asked, world.senses)
    moments = [demand.value for demand in (*world.demands, *ways) if demand.op == ">"]
    if quantity is None:
        return None
    for value in (*slips, *moments):
        ends = [end for end in zeros(value, name) if sign(end, given).kind == "positive"] if depends_on(value, name) else []
        top = given.range_of(name)[1]
        ends = [end for end in ends if top is None or settle([Demand(top - end)], given) is not None]
        side = {"positive": "upper", "negative": "lower"}.get(sign(derivative(value, name), given).kind or "")
        if len(ends) == 1 and side and sign(value, given).kind is None and getattr(quantity, side) is None:
            end, is_below = present(ends[0]), side == "lower"
            other = replace(quantity, lower=end) if is_below else replace(quantity, upper=end)
            return Asked(narrowed(problem, other)), 1 if is_below else -1
    return None


def joined(text: str, here: Part, there: Part, way: int, letter: str) -> Answer:
    """The answer from what was found with the one sense and with the other one, which it has for greater (1) or
    lesser (-1) values."""
    (world, first), (_, second) = here, there
    if first.is_none and second.is_none:
        firm = tuple(demand for demand in first.valid if not depends_on(demand.value, first.symbol))
        return concluded(world, text, replace(first, valid=firm, met=True), letter)
    best = SUPERLATIVES.get(text.partition(" ")[0], 0)
    is_beyond = best == way and first.relation == second.relation == "=" and second.values
    if first.is_none or is_beyond:
        return concluded(there[0], text, second, letter)
    made = concluded(world, text, first, letter)
    if second.is_none or (best == -way and first.relation == "=" and first.values):
        return made
    if first.rule == second.rule == "vanishes_for":
        return _both(made, concluded(there[0], text, second, letter))
    return replace(made, verdict=all_of((made.verdict, undecided(ONE_SENSE))))


def either(text: str, here: Part, there: Part, letter: str) -> Answer:
    """The values from what was found with a start on one side, and on the other one."""
    made, second = concluded(here[0], text, here[1], letter), there[1]
    if second.is_none and second.verdict is not None and second.verdict.is_proved:
        return made
    if second.values and second.rule == here[1].rule:
        return _both(made, concluded(there[0], text, second, letter))
    return replace(made, verdict=all_of((made.verdict, undecided(ONE_SENSE))))


def _both(first: Answer, second: Answer) -> Answer:
    """The values of both, each under its conditions."""
    each = [(*one.valid, *own) for one in (first, second) for own in one.each or ((),) * len(one.values)]
    steps = tuple(replace(step, id=f"other.{step.id}") for step in second.steps if step not in first.steps)
    return replace(
        first,
        values=(*first.values, *second.values),
        nodes=(*first.nodes, *second.nodes),
        verdict=all_of((first.verdict, second.verdict)),
        valid=(),
        each=tuple(each) if any(each) else (),
        steps=(*first.steps, *steps),
    )
