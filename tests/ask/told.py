"""The law of assumptions: what the checks of an answer take as given is declared, or told with the answer.

Each check is handed what it may take as given. Wherever the declared signs and ranges and all conditions that are told with an
answer hold, that has to hold too; it is looked at in many numbers. What is said of the quantity on which a way runs is that way.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from rbpsym.ask.found import Answer
from rbpsym.decide.assumptions import Assumptions
from rbpsym.expr import tree as t
from rbpsym.field import UNITY, Scalar, names_in, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.numeric.formulas import compiled
from rbpsym.proof.step import Step

COUNT, CLEAR = 4000, 1e-9
SIGNED = ("positive", "nonnegative")
Numbers = dict[str, np.ndarray]


def keep(found: Answer) -> None:
    """Raises AssertionError where a PROVED answer rests on a fact of the parameters that is neither declared nor told: it holds
    for some of the numbers with which the answer is told, but not for all. (It holds for none where the contrary of the answer
    is checked. A claim may be checked in several cases, of which one holds.)"""
    declared, fixed = set(facts(found.study.assumptions)), {"pi", *(q.name for q in found.study.problem.parameters)}
    claims = dict[tuple[str, str], list[list[Scalar]]]()
    for step in found.grounds:
        claim = step.rule, str([step.data.get(key) for key in ("value", "values", "holds")])
        own = [fact for fact in supposed(step, found) if fact not in declared and names_in(fact) <= fixed]
        claims.setdefault(claim, []).append(own)
    if not any(map(any, claims.values())) or not found.verdict.is_proved:
        return
    places = [drawn(found, [one for one in (*declared, *told) if names_in(one) <= fixed], image) for told, image in cases(found)]
    for (rule, _), grounds in claims.items():
        met = [np.any([np.all([holds(one, numbers) for one in (UNITY, *own)], 0) for own in grounds], 0) for numbers in places]
        said = f"the check “{rule}” of “{found.question.text}” supposes {grounds}, which is not told"
        assert any(each.all() for each in met) or not any(each.any() for each in met), said


def supposed(step: Step, found: Answer) -> Iterator[Scalar]:
    """What a check takes as given, but for what it says of that along which it looks, and of a symbol that has no value."""
    looked = {step.data.get("along"), *([found.symbol] if not found.values else []), step.data.get("name")}
    looked -= {found.symbol} if found.values else set()
    yield from (fact for given in given_in(step.data) for fact in facts(given) if not names_in(fact) & looked)


def given_in(data: object) -> Iterator[Assumptions]:
    """All assumptions in the data of a check."""
    if isinstance(data, Assumptions):
        yield data
    elif isinstance(data, Mapping | tuple | list):
        for part in data.values() if isinstance(data, Mapping) else data:
            yield from given_in(part)


def facts(given: Assumptions) -> Iterator[Scalar]:
    """What is not negative, by the assumptions."""
    yield from (symbol(name) for name, sign in given.signs.items() if sign in SIGNED)
    for name, (lower, upper) in given.ranges.items():
        yield from () if lower is None else [symbol(name) - lower]
        yield from () if upper is None else [upper - symbol(name)]
    yield from (value for value, _ in given.known)


def cases(found: Answer) -> Iterator[tuple[list[Scalar], dict[str, Scalar]]]:
    """What is told with each value of the answer, and what the symbol is there."""
    values = found.values or (None,)
    for value, own in zip(values, found.each or ((),) * len(values), strict=False):
        told = [one for node in (*found.valid, *own) for one in said(t.relations(node))]
        if value is None or not found.symbol:
            yield told, {}
        elif found.relation == "=":
            yield told, {found.symbol: value}
        else:
            pairs = zip("><", found.values, strict=True) if found.relation == "between" else [(found.relation, value)]
            ends = ((symbol(found.symbol) - end) * WAYS.get(op[0], 0) for op, end in pairs)
            yield [*told, *ends], {}


WAYS = {">": 1, "<": -1}


def said(rows: Iterable[tuple[t.Node, str, t.Node]]) -> Iterator[Scalar]:
    yield from ((scalar(left) - scalar(right)) * WAYS[op[0]] for left, op, right in rows if op[0] in WAYS)


def drawn(found: Answer, known: list[Scalar], image: dict[str, Scalar]) -> Numbers:
    """Numbers at which all that is known is not negative."""
    chance, numbers = np.random.default_rng(1), Numbers()
    for q in found.study.problem.parameters:
        size = np.exp(chance.uniform(-2.5, 2.5, COUNT))
        numbers[q.name] = size if q.sign in SIGNED else size * chance.choice([-1, 1], COUNT)
    numbers |= {name: at(value, numbers) for name, value in image.items()}
    for value in known:
        fits = holds(value, numbers)
        numbers = {name: each[fits] for name, each in numbers.items()}
    return numbers


def holds(fact: Scalar, numbers: Numbers) -> np.ndarray:
    """Where it is not negative."""
    return at(fact, numbers) > -CLEAR


def at(value: Scalar, numbers: Numbers) -> np.ndarray:
    """Its numbers, where there is none not one."""
    count = len(next(iter(numbers.values()), ()))
    return np.broadcast_to(compiled([value])(numbers)[0], count) if count else np.zeros(0)
