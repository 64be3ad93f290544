"""Checks of steady motions: the acceleration, with the speeds that kept momenta give, and its slope."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, Scalar, derivative, substitute, symbol
from rbpsym.derivation.checks import relations, same, weakest
from rbpsym.derivation.checks_places import under
from rbpsym.derivation.context import Context
from rbpsym.derivation.step import Step
from rbpsym.equality.decide import compare
from rbpsym.equality.verdict import Verdict


def steady_place(context: Context, step: Step) -> Verdict:
    """At the stated place, and at rest there, the acceleration vanishes (`data`: "name", "speeds", the steps that give the
    speeds of the others, "place")."""
    [(_, _, right)] = relations(step.statement)
    place = context.value(right)
    there = substitute(_gain(context, step), {step.data["name"]: place})
    return weakest([same(context, there, NOTHING), same(context, place, step.data["place"])])


def steady_frequency(context: Context, step: Step) -> Verdict:
    """What is stated is minus the slope of the acceleration at the place, and positive; the speed itself has no part in first
    order (`data`: the same)."""
    [(_, _, right)] = relations(step.statement)
    name, still = step.data["name"], {f"{step.data['name']}_dot": NOTHING}
    drag = derivative(context.on_motion(symbol(f"{name}_ddot")), f"{name}_dot") if not step.data["speeds"] else NOTHING
    slope = derivative(_gain(context, step), name)
    found = same(context, context.value(right), -substitute(slope, {step.data["name"]: step.data["place"]}))
    found = weakest([found, same(context, substitute(drag, {**still, name: step.data["place"]}), NOTHING)])
    return weakest([found, compare(NOTHING, context.value(right), under(context, step, ">").assumptions)])


def _gain(context: Context, step: Step) -> Scalar:
    """The acceleration at rest with what the other steps say of the other speeds, as a function of the place."""
    said = {}
    for id in step.data["speeds"]:
        context.use(id)
        [(left, _, right)] = relations(context.steps[id].statement)
        said[left.name] = context.value(right)
    name = step.data["name"]
    gained = substitute(context.on_motion(symbol(f"{name}_ddot")), said)
    return substitute(gained, {f"{name}_dot": NOTHING})
