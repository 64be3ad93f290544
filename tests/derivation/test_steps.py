"""Laws for every step of every shipped problem."""

import os
import zlib
from dataclasses import fields, replace

import pytest

from rbpsym.derivation.rules import RULES, certify
from rbpsym.notation import tree as t
from rbpsym.notation.tree import relations


def test_every_step_is_proved(draft):
    wrong = [(s.id, s.certificate.verdict) for s in draft.steps if not s.certificate.verdict.is_proved]
    assert not wrong


def test_ids_are_unique_and_premises_come_before(draft):
    seen = set()
    for step in draft.steps:
        assert step.id not in seen
        assert set(step.premises) <= seen | draft.context.facts.keys()
        assert set(step.cites) <= seen | draft.context.facts.keys()
        assert not set(step.premises) & set(step.cites)
        seen.add(step.id)


def test_no_premise_can_be_left_out(draft):
    """Of every step one premise, drawn by its name, is left out: it is proved no more."""
    idle = []
    for step in draft.steps:
        for id in _drawn(step):
            fewer = replace(step, premises=tuple(other for other in step.premises if other != id))
            if certify(draft.context, fewer).verdict.is_proved:
                idle.append((step.id, step.rule, id))
    assert not idle


def _drawn(step):
    if os.environ.get("RBPSYM_THOROUGH"):
        return step.premises
    return step.premises and [step.premises[zlib.crc32(step.id.encode()) % len(step.premises)]]


def test_a_premise_too_many_is_noticed(draft):
    """How the mass of a body is spread says nothing where no integral over it stands."""
    for step in draft.steps:
        idle = next((id for id in draft.context.facts if id.startswith("shape.") and id not in step.premises), None)
        if idle is not None:
            more = certify(draft.context, replace(step, premises=(*step.premises, idle)))
            assert not more.verdict.is_proved, (step.id, idle)


def test_an_unknown_premise_raises(draft):
    with pytest.raises(KeyError, match="nonsense"):
        certify(draft.context, replace(draft.steps[-1], premises=("nonsense",)))


def test_every_step_asserts_something(draft):
    for step in draft.steps:
        assert list(relations(step.statement)), step.id
        assert step.certificate.checks == tuple(check.__name__ for check in RULES[step.rule])


def test_a_wrong_statement_is_not_proved(draft):
    """Each relation of each step is spoilt in turn: no checker may let it pass."""
    passed = []
    for step in draft.steps:
        for place, spoilt in enumerate(_spoilt(step.statement)):
            if all(_passes(draft, step, wrong) for wrong in spoilt):
                passed.append((step.id, step.rule, place))
    assert not passed


def _passes(draft, step, statement):
    return certify(draft.context, replace(step, statement=statement)).verdict.is_proved


def _spoilt(statement):
    """The statement with the last item of one relation changed: doubled, and (if that is 0 on the motion) 1 more."""
    if isinstance(statement, t.System):
        for place, row in enumerate(statement.rows):
            for spoilt in _spoilt(row):
                yield [t.System((*statement.rows[:place], wrong, *statement.rows[place + 1 :])) for wrong in spoilt]
    elif isinstance(statement, t.Chain) and statement.ops[-1] == "=" and statement.items[0] != t.ZERO:
        yield [t.Chain((*statement.items[:-1], other), statement.ops) for other in _others(statement)]


def _others(statement):
    last = statement.items[-1]
    one = t.Unit("z") if any(isinstance(part, (t.Vec, t.Unit)) for part in t.walk(last)) else t.ONE
    if last != t.ZERO:
        return (t.Mul((t.TWO, last)), t.add(last, one))
    return (t.Unit("z") if any(isinstance(part, (t.Vec, t.Unit)) for part in t.walk(statement)) else t.ONE,)


def test_steps_are_values(draft):
    for step in draft.steps:
        assert step == replace(step)
        assert {f.name for f in fields(step)} >= {"id", "rule", "premises", "cites", "statement", "obligations", "certificate"}
