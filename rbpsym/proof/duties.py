"""The obligations of a step: what must not vanish, or not be negative, for it to have a meaning and to follow.

They come from the formulas as they stand (denominators, roots, functions, integrals), from the coefficients by which
its proof has divided, and from its author. Each is discharged by the declared signs and ranges, or stays open: then
the step holds where it does, and a page says so.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import Condition, conditions, divisors, nonzero, obligations
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Obligation
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import UNITY, Scalar, factors, generator, inverse
from rbpsym.present.forms import present
from rbpsym.proof.checks.of_steps import divides
from rbpsym.proof.step import Step
from rbpsym.proof.view import View
from rbpsym.typeset.machine import to_machine

WAYS = {"positive": 1, "negative": -1}


def duties(view: View, step: Step) -> tuple[Obligation, ...]:
    """The obligations of a step that was proved, with what discharges them."""
    found: dict[Condition, None] = dict.fromkeys(_conditions(view, step))
    firm = [value for one in found if one.op == ">" for value in (one.value, _along(view, one.value)) if value is not None]
    kept = (one for one in found if one.value.number() is None and not _is_said(one, firm))
    made = [_discharged(view, one) for one in kept]
    left = merged(duty.relation for duty in made if not duty.is_discharged)
    return (*(duty for duty in made if duty.is_discharged), *map(Obligation, left))


def merged(relations: Iterable[Any]) -> tuple[t.Node, ...]:
    """Conditions of the form “… > 0”, “… ≥ 0” or “… ≠ 0”, each quantity once: what is positive is not zero."""
    ops: dict[t.Node, set[str]] = {}
    for one in relations:
        ops.setdefault(one.items[0], set()).update(one.ops)
    return tuple(t.relation(node, found.pop() if len(found) == 1 else ">", t.ZERO) for node, found in ops.items())


def _is_said(one: Condition, firm: list[Scalar]) -> bool:
    """Whether what is positive says it already: ≥ 0 of the very value, ≠ 0 of each factor, or of its root."""
    if one.op == ">=":
        return one.value in firm
    return one.op == "!=" and bool(firm) and any(_is_in(value, firm) for value in (one.value, one.value**2))


def _is_in(value: Scalar, others: list[Scalar]) -> bool:
    """Whether it can't vanish where the others don't: it is one of them, or a factor of one."""
    return any(value == other or divides(value, other).is_proved for other in others)


def _conditions(view: View, step: Step) -> Iterator[Condition]:
    for left, _, right in t.relations(step.statement):
        for node in (left, right):
            try:
                yield from conditions(node, view.scope)
            except (RbpsymError, ZeroDivisionError):  # no value of its own (a work): its parts have theirs elsewhere
                continue
    for factor in view.divisors():
        yield from _poles(view, factor)
    for node in step.obligations:
        yield Condition(node.items[0], node.ops[0], view.value(node.items[0]))


def _poles(view: View, factor: Scalar) -> Iterator[Condition]:
    """What must not vanish for the factor to have a value, each as it is printed, whose sign is seen more easily."""
    for node in (present(value, view.whole.style, factor=True) for value in divisors(factor)):
        yield from nonzero(node, view.scope)


def _discharged(view: View, one: Condition) -> Obligation:
    """With what implies it: the declared signs and ranges, or what the premises say of the quantity in it."""
    key = ("duty", one.op, one.value)
    if key not in view.rows:
        [made] = obligations([one], view.whole.assumptions)
        if not made.is_discharged and (seen := _along(view, one.value)) is not None:
            [other] = obligations([Condition(one.node, one.op, seen)], view.whole.assumptions)
            made = replace(made, why=other.why)
        view.rows[key] = made if made.is_discharged else _open(view, one)
    known: Obligation = view.rows[key]
    return replace(known, relation=one.relation) if known.is_discharged else known


def _open(view: View, one: Condition) -> Obligation:
    """What is not discharged by signs and ranges: told by a step, or open, in the form in which the derivation has it first:
    a - b ≠ 0 is not asked for beside b - a ≠ 0, nor with a factor of known sign."""
    if told := _told(view, one):
        return Obligation(one.relation, told)
    core, either = _core(one.value, view.whole.assumptions), one.op == "!="
    keys = [("open", either, value) for value in ((core, -core) if either else (core,))]
    node = next((view.rows[key] for key in keys if key in view.rows), None)
    if node is None:
        short = [present(value, view.whole.style, factor=True) for *_, value in keys]
        forms = [one.node, *sorted(short, key=to_machine)]
        node = view.rows[keys[0]] = min(forms, key=lambda form: sum(1 for _ in t.walk(form)))
    return Obligation(t.relation(node, one.op, t.ZERO))


def _core(value: Scalar, given: Assumptions) -> Scalar:
    """The value without factors of known sign; itself where another one stands in a power or below the line."""
    _, powers = value.num.content()
    try:
        coefficient, found = factors(value.num.scaled(1, inverse(powers)))
    except RbpsymError:
        return value
    core = UNITY if coefficient > 0 else -UNITY
    for part, exponent in (*found, *((generator(index), power) for index, power in powers), (value.den, -1)):
        way = WAYS.get(sign(Scalar(part), given).kind or "")
        if way is None and exponent != 1:
            return value
        core = core * Scalar(part) if way is None else core * way**exponent
    return core


def _told(view: View, one: Condition) -> str:
    """The step before it that says so of the very letter, if that was proved."""
    said = t.relation(one.node, ">", t.ZERO)
    told = (step for step in view.steps.values() if step.rule == "stays" and step.statement == said)
    return next((step.id for step in told if step.certificate.verdict.is_proved), "")


def _along(view: View, value: Scalar) -> Scalar | None:
    with suppress(RbpsymError, ZeroDivisionError), view.noting():
        seen = view.along(value)
        return None if seen == value else seen
    return None
