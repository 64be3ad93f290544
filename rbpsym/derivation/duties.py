"""The obligations of a step: what must not vanish, or not be negative, for it to have a meaning and to follow.

They come from the formulas as they stand (denominators, roots, functions, integrals), from the coefficients by which
its proof has divided, and from its author. Each is discharged by the declared signs and ranges, or stays open: then
the step holds where it does, and a page says so.
"""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.algebra.present import present
from rbpsym.derivation.step import Step
from rbpsym.derivation.view import View
from rbpsym.equality.domain import Condition, conditions, obligations
from rbpsym.equality.verdict import Obligation
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t


def duties(view: View, step: Step) -> tuple[Obligation, ...]:
    """The obligations of a step that was proved, with what discharges them."""
    given = view.whole.assumptions
    found: dict[Condition, None] = dict.fromkeys(_conditions(view, step))
    return tuple(made for one in found for made in _known(view, one) or _made(view, one, given))


def _conditions(view: View, step: Step) -> Iterator[Condition]:
    for left, _, right in t.relations(step.statement):
        for node in (left, right):
            try:
                yield from conditions(node, view.scope)
            except (RbpsymError, ZeroDivisionError):  # no value of its own (a work): its parts have theirs elsewhere
                continue
    for divisor in view.divisors:
        yield Condition(present(divisor, view.whole.style, factor=True), "!=", divisor)
    for node in step.obligations:
        yield Condition(node.items[0], node.ops[0], view.value(node.items[0]))


def _known(view: View, one: Condition) -> list[Obligation]:
    return view.rows.get(("duty", one), [])


def _made(view: View, one: Condition, given) -> list[Obligation]:
    view.rows[("duty", one)] = obligations([one], given)
    return view.rows[("duty", one)]
