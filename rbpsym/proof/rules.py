"""The rules by which steps are made, and for each the checks that a step must pass.

A check shares nothing but formulas and arithmetic with the maker of the step. A new rule is a new entry.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache, partial
from importlib import import_module

from rbpsym.decide.verdict import undecided
from rbpsym.proof.checks import of_steps as c
from rbpsym.proof.context import DECIDED, EXACT, Context
from rbpsym.proof.duties import duties
from rbpsym.proof.step import Certificate, Step
from rbpsym.proof.view import seen_by

# rules -> their checks, each with the module of `proof.checks` in which it stands (else in `of_steps`); * is the name of the rule
CHECKED: Mapping[str, str] = {rule: checks.replace("*", rule) for rules, checks in {
    "statement constraint force inequality": "identity",
    "identity combination first_integral": "*",
    "no_slip kept_until": "identity constraints.*",
    "taut": "identity constraints.tension_without_power",
    "tied": "identity constraints.conditions_kept",
    "mass_integral": "identity integrals_by_differentiation",
    "parallel_axis": "identity moment_over_mass",
    "mass_center": "identity center_over_mass",
    "differentiation": "identity derivatives_by_integration",
    "angular_momentum": "identity momentum_over_mass",
    "kinetic_energy": "identity energy_over_mass",
    "torque": "identity torque_by_components",
    "potential": "identity conservative",
    "balance solution": "on_motion",
    "held": "constraints.kept_condition",
    "start_rate": "constraints.rate_at_start",
    "start_law": "constraints.law_at_start",
    "work_sum": "combination",
    "work workless work_integral": "rates",
    "power": "power_of_works",
    "work_energy work_together work_done": "rates_on_motion",
    "conservation": "identity constant",
    "energy_rate": "identity on_motion",
    "substitution": "along_motion",
    "stays": "places.*",
    "rest": "oscillations.forces_at_rest",
    "equilibrium": "oscillations.place_stated oscillations.at_rest stability.stability_said places.can_rest",
    "linearization": "oscillations.series stability.stability_said",
    "open_balance": "oscillations.force_vanishes",
    "open_ends": "identity oscillations.force_at_ends",
    "open_linear": "oscillations.series_in_balance",
    "linear_system": "oscillations.linear_rows",
    "minors": "oscillations.positive_minors",
    "secular polynomial": "oscillations.*",
    "normal_modes": "identity oscillations.characteristic",
    "mode_shape rate_of_mode motion_of_mode critical hurwitz": "identity oscillations.*",
    "asked": "places.has_sign_of_force",
    "vanishing": "* holds_there places.comes_first",
    "value_there": "identity *",
    "value_then direction value_told value_along kept_speed followed steady_place": "values.*",
    "vanishes_for": "parameters.place_told parameters.vanishes_there",
    "holds_for": "parameters.bound_told parameters.bounds_hold",
    "extreme": "parameters.extreme_told parameters.extreme_there",
    "approached": "parameters.*",
    "limit": "parameters.limit_told parameters.tends_to",
    "put_in no_change changes kept_or_not least_on_way one_zero greatest_of": "answers.*",
    "course by_speed speed_along": "solutions.*",
    "reached_in_time": "identity solutions.reached",
    "swing feature": "identity solutions.*",
    "steady_frequency": "identity values.*",
    "slip": "identity phases.*",
    "event_time": "identity phases.reached_then phases.first_then",
    "event_place": "identity phases.reached_there phases.first_there",
    "end_state": "identity phases.state_then",
    "jump": "on_motion constraints.momenta_kept",
    "impulse": "on_motion phases.momentum_jump",
    "restitution": "on_motion phases.parting",
    "energy_jump": "on_motion phases.*",
}.items() for rule in rules.split()}  # fmt: skip


class Rules(dict[str, tuple[c.Check, ...]]):
    """The checks of each rule; a module of checks is loaded when a rule asks for it."""

    def __missing__(self, rule: str) -> tuple[c.Check, ...]:
        found = self[rule] = tuple(map(_check, CHECKED[rule].split()))
        return found


@cache
def _check(name: str) -> c.Check:
    module, _, function = name.rpartition(".")
    found: c.Check = getattr(import_module(f"rbpsym.proof.checks.{module}" if module else c.__name__), function)
    return found


RULES = Rules()


def certify(context: Context, step: Step) -> Certificate:
    """What the checks of the step's rule find with its premises and the declared signs, and with nothing else.

    A premise that is not known raises KeyError; one that no check asked for makes the step UNDECIDED.
    """
    for id in step.premises:
        if id not in context.steps and id not in context.facts:
            raise KeyError(f"the step “{step.id}” names the premise “{id}”, which is none")
    found, used = examined(context, step, step.premises)
    idle = [id for id in step.premises if id not in used]
    if found.verdict.is_proved and idle:
        return Certificate(found.checks, undecided(f"nothing is concluded from “{idle[0]}”"))
    return found


def examined(context: Context, step: Step, premises: tuple[str, ...], *, by_numbers: int = EXACT) -> tuple[Certificate, set[str]]:
    """The certificate of the step with these premises, and which of them were used; `by_numbers`: with what these are trusted.

    What follows from a step that is not proved is not proved.
    """
    view = seen_by(context, step, premises, by_numbers=by_numbers)
    checks = RULES[step.rule]
    verdict = c.weakest(c.guarded(partial(check, view, step)) for check in checks)
    open_ = [id for id in view.used if id in context.steps and not context.steps[id].certificate.verdict.is_proved]
    if verdict.is_proved and open_:
        verdict = undecided(f"it follows from “{min(open_)}”, which is not proved")
    if verdict.is_proved and by_numbers != DECIDED:
        verdict = replace(verdict, obligations=tuple(dict.fromkeys((*verdict.obligations, *duties(view, step)))))
    return Certificate(tuple(check.__name__ for check in checks), verdict), view.used
