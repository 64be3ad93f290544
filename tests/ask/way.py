"""What answers say of the way to a place, put to the simulation with one-sided contacts: does the motion come there as it is
stated, at numbers inside the conditions that are told, and does it not where they say so?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.found import Answer
from rbpsym.errors import NoNumber, NotApplicable, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import names_in
from rbpsym.field.evaluate import scalar
from rbpsym.field.evaluate import value as value_of
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.quantities import NUMBER
from rbpsym.typeset.machine import to_machine
from tests.oracles.compare import _bench
from tests.oracles.motion import Unfit, declared_start, follow
from tests.oracles.sets import drawn

NEAR, MOST_DRAWS, LONGEST = 1e-6, 3, 20.0
ANGLES, LENGTHS = ("pi/2", "pi/6", "-pi/4"), ("+ {}/3", "- {}/2")
REFUSES = ("vanishes before", "ends there", "never comes there")  # what a sentence says of a motion that does not come so far


@dataclass
class Told:
    """How many answers said something that the simulation decides, and which of them are wrong."""

    compared: int = 0
    wrong: list[tuple] = field(default_factory=list)


def told_of_the_way(asked: Asked, sets: int, seed: int = 2031) -> Told:
    """The answers about some places, each at that many sets of parameters at which the simulation decides what they say."""
    found, study = Told(), asked.first
    if asked.problem.phases or study.at_start or len(study.system.independent) != 1 or study.system.has_clock:
        return found
    [name] = study.system.independent
    for text in _places(study, name):
        place = scalar(read_infix(text, asked.world(0).names))
        seen = list(_seen(study, name, place, sets, seed))
        for question in _questions(study, name, text) if seen else ():
            _compare(asked, question, seen, found)
    return found


def _compare(asked: Asked, question: str, seen: list, found: Told) -> None:
    try:
        answer, refusal = answered(asked, question), ""
    except RbpsymError as error:
        answer, refusal = None, error.what
    is_loss = " vanish " in question
    never = not is_loss and any(reason in refusal for reason in REFUSES)
    for numbers, comes, ended in seen:
        said = _said(answer, question, numbers) if answer else False if never else None
        if said is None or (is_loss and ended not in (True, f"lost {question.split()[1]}")):
            continue
        found.compared += 1
        if said is not (comes != is_loss):
            found.wrong.append((question, refusal or answer.text, said, ended, numbers))


def _places(study: Study, name: str) -> Iterator[str]:
    start, dimension = study.system.scope.start.get(name), study.problem.coordinate(name).quantity.dimension
    if start is not None and dimension == NUMBER:
        yield from ANGLES
    elif start is not None:
        known = [q.name for q in study.problem.parameters if q.dimension == dimension][:1]
        yield from (f"{to_machine(present(start))} {step}".format(one) for one in known for step in LENGTHS)


def _questions(study: Study, name: str, place: str) -> Iterator[str]:
    """A value, a time, yes or no, and a bound of the first and the last parameter."""
    known, elements = [one.name for one in study.problem.parameters], study.problem.constraints
    yield from (f"speed of {name} where {name} = {place}", f"time until {name} = {place}", f"does {name} reach {place}")
    yield from (f"{one} for which {name} reaches {place}" for one in dict.fromkeys((*known[:1], *known[-1:])))
    yield from (f"does {force} vanish until {name} = {place}" for element in elements for force in pushes(element)[:1])


def _seen(study: Study, name: str, place, sets: int, seed: int) -> Iterator[tuple[Mapping[str, float], bool, str | bool]]:
    """(numbers, whether it comes there first, what ends before) where the simulation decides it."""
    count = 0
    for draws, numbers in enumerate(drawn(study, seed)):
        if count >= sets or draws >= MOST_DRAWS * sets:
            return
        try:
            comes = _comes(study, name, number(place, numbers), numbers)
        except (Unfit, NotApplicable, NoNumber, np.linalg.LinAlgError):
            continue
        if comes is not None:
            count += 1
            yield numbers, comes is True, comes


def _comes(study: Study, name: str, place: float, numbers: Mapping[str, float]) -> bool | str | None:
    """True where it comes to the place without turning round before, else what ends before; None if that is not decided."""
    bench = _bench(study, numbers)
    start = declared_start(bench)
    if start is None:
        return None
    done = follow(bench, study, start, longest=LONGEST)
    states, size = [*done.states, *([done.event.state] if done.event else [])], bench.equations.size
    near, at, gaps, rates = start.q, bench.placement.names.index(name), [], []
    for state in states:
        near, speed = bench.placement.state(state[:size].tolist(), state[size : 2 * size].tolist(), near)
        gaps.append(float(near[at]) - place)
        rates.append(float(speed[at]))
    if any(abs(gap) < NEAR * (1 + abs(place)) for gap in gaps):
        return None
    met = next((k for k in range(1, len(gaps)) if gaps[k] * gaps[k - 1] < 0), None)
    turns = next((k for k in range(1, len(rates)) if rates[k] * rates[k - 1] < 0), None)
    if met is not None and (turns is None or met < turns):
        return True
    if met is not None or (done.event is not None and done.event.kind == "string"):
        return None  # after a turn, or where a string has run out, which no statement speaks of
    return f"{done.event.kind} {done.event.of}" if done.event else "turns round" if done.is_whole and turns is not None else None


def _said(answer: Answer, question: str, numbers: Mapping[str, float]) -> bool | None:
    """What an answer says at these numbers; None where it says nothing."""
    holds = _holds(answer, numbers)
    if not answer.verdict.is_proved or holds is None or answer.each or "if the contacts" in answer.says:
        return None
    if " for which " not in question and not question.startswith("does"):
        return True if holds else None  # beyond its conditions it may come there too
    if not holds and "else" not in answer.says:
        return None
    if question.startswith("does"):
        return answer.holds_so if answer.holds_so is not None else holds if answer.says.startswith("yes") else None
    if not holds or not answer.values:
        words = answer.says.rpartition("else")[2]
        return True if "holds for every" in words or "holds for all" in words else False if "there is no such" in words else None
    bounds = [number(value, numbers) for value in answer.values]
    here = numbers[answer.symbol]
    if any(abs(bound - here) <= NEAR * abs(here) for bound in bounds):
        return None
    told = {">": here > bounds[0], "<": here < bounds[0], "between": bounds[0] < here < bounds[-1]}
    return told.get(answer.relation.rstrip("="))


def _holds(answer: Answer, numbers: Mapping[str, float]) -> bool | None:
    """Whether all conditions are met; None at the very edge of one, or where it is one of the state."""
    met = True
    for left, op, right in (row for node in answer.valid for row in t.relations(node)):
        gap = value_of(t.add(left, t.neg(right)), answer.study.system.scope)
        if not names_in(gap) <= {*numbers, "pi"} or names_in(gap) & set(answer.study.system.coordinates):
            return None
        try:
            size = number(gap, numbers)
        except NoNumber:
            return False
        if abs(size) < NEAR:
            return None
        met = met and (op == "!=" or (size > 0) == (op in (">", ">=")))
    return met
