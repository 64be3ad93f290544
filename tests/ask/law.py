"""The law of answers: what is PROVED is stated by a step that a rule has checked, and that does not pass where it is spoiled."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from rbpsym.ask.certified import LETTER
from rbpsym.ask.found import Answer
from rbpsym.decide.verdict import all_of
from rbpsym.expr import tree as t
from rbpsym.field.calculus import depends_on, substitute
from rbpsym.field.scalar import UNITY, Scalar, symbol
from rbpsym.proof.checks.of_steps import guarded
from rbpsym.proof.context import Context
from rbpsym.proof.rules import RULES
from rbpsym.proof.step import Step

STATED = {"value_then", "value_along", "value_told", "solution", "direction"}  # of a quantity, certified by a draft


def keep(found: Answer) -> None:
    """Raises AssertionError where a PROVED answer breaks the law, or tells a condition twice."""
    assert len({*found.valid}) == len(found.valid), (found.question.text, found.valid)
    if not found.verdict.is_proved:
        return
    if found.conclusion is None:
        assert found.steps[-1].rule in STATED and found.steps[-1].certificate.verdict.is_proved
        return
    said = found.conclusion.certificate
    assert said.verdict.is_proved and (said.checks or found.steps), found.question.text
    for step in found.grounds:
        for spoiled in _spoiled(step):
            assert not _passes(found, spoiled), f"{found.question.text}: {step.rule} lets {spoiled.data} pass"
    rows = list(t.relations(found.conclusion.statement)) if found.grounds else ()
    for left, op, right in rows:
        wrong = t.relation(left, op, t.mul(t.Num(3), right) if right != t.ZERO else t.ONE)
        letters = {row[0].name: found.values[0] for row in rows[:1] if found.conclusion.rule == "identity"}
        own = (replace(step, statement=wrong) for step in found.grounds if step.rule == found.conclusion.rule)
        assert not any(_passes(found, step, letters) for step in own), wrong


def one_value_a_letter(found: Answer) -> None:
    """Raises AssertionError where a letter of the program's own is said to be two things."""
    values: dict[str, t.Node] = {}
    for left, _, right in (row for step in found.steps for row in t.relations(step.statement)):
        if isinstance(left, t.Sym) and left.name.startswith(LETTER):
            assert values.setdefault(left.name, right) == right, (found.question.text, left.name)


def _passes(found: Answer, step: Step, letters: dict[str, Scalar] | None = None) -> bool:
    context = Context(found.study)
    context.scalars.update(letters or {})
    return all_of([guarded(lambda check=check: check(context, step)) for check in RULES[step.rule]]).is_proved


def _spoiled(step: Step) -> Iterator[Step]:
    """The step with something else in its data."""
    for changed in SPOILERS.get(step.rule, lambda data: ())(step.data):
        yield replace(step, data={**step.data, **changed})


def _other(value: Scalar) -> Scalar:
    return value * 3 if value else UNITY


def _places(data) -> Iterator[dict[str, Any]]:
    name, value = data["name"], data["value"]
    if data["places"]:
        yield {"places": [_other(place) for place in data["places"]]}
    elif depends_on(value, name):
        yield {"value": value - substitute(value, {name: symbol("somewhere")})}


def _bounds(data) -> Iterator[dict[str, Any]]:
    yield {"ends": {side: None if end is None else _other(end) for side, end in data["ends"].items()}}


def _extreme(data) -> Iterator[dict[str, Any]]:
    if not data["at_end"]:
        yield {"sense": -data["sense"]}


def _least(data) -> Iterator[dict[str, Any]]:
    if data["holds"] is not None:
        yield {"holds": not data["holds"]}
    else:
        yield {"parts": tuple((value, place, _other(low)) for value, place, low in data["parts"])}


def _greatest(data) -> Iterator[dict[str, Any]]:
    if any(value != data["best"] for value, _ in data["others"]):
        yield {"sense": -data["sense"]}


SPOILERS = {
    "vanishes_for": _places,
    "holds_for": _bounds,
    "approached": lambda data: ({"value": data["value"] + UNITY},),
    "extreme": _extreme,
    "limit": lambda data: ({"coefficient": _other(data["coefficient"])},),
    "no_change": lambda data: ({"best": _other(data["best"])},),
    "changes": lambda data: ({"value": substitute(data["value"], {data["name"]: UNITY})},),
    "kept_or_not": lambda data: ({"kept": not data["kept"]},),
    "least_on_way": _least,
    "one_zero": lambda data: ({"equation": data["equation"] ** 2 + 1},),
    "greatest_of": _greatest,
}
