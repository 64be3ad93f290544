"""The rules by which steps are made, and for each the checks that a step must pass.

A check shares nothing but formulas and arithmetic with the maker of the step. A new rule is a new entry.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache, partial
from importlib import import_module

from rbpsym.decide.verdict import undecided
from rbpsym.proof.checks import of_steps as c
from rbpsym.proof.context import DECIDED, EXACT, Context
from rbpsym.proof.duties import duties
from rbpsym.proof.step import Certificate, Step
from rbpsym.proof.view import seen_by

# rule -> its checks, each with the module of `proof.checks` in which it stands (without one: `of_steps`)
CHECKED: Mapping[str, str] = {
    "statement": "identity",
    "constraint": "identity",
    "no_slip": "identity constraints.no_slip",
    "taut": "identity constraints.tension_without_power",
    "tied": "identity constraints.conditions_kept",
    "mass_integral": "identity integrals_by_differentiation",
    "parallel_axis": "identity moment_over_mass",
    "mass_center": "identity center_over_mass",
    "differentiation": "identity derivatives_by_integration",
    "angular_momentum": "identity momentum_over_mass",
    "kinetic_energy": "identity energy_over_mass",
    "torque": "identity torque_by_components",
    "force": "identity",
    "potential": "identity conservative",
    "balance": "on_motion",
    "held": "constraints.kept_condition",
    "start_rate": "constraints.rate_at_start",
    "start_law": "constraints.law_at_start",
    "identity": "identity",
    "combination": "combination",
    "solution": "on_motion",
    "work": "rates",
    "workless": "rates",
    "power": "power_of_works",
    "work_energy": "rates_on_motion",
    "work_together": "rates_on_motion",
    "work_integral": "rates",
    "work_sum": "combination",
    "work_done": "rates_on_motion",
    "conservation": "identity constant",
    "energy_rate": "identity on_motion",
    "first_integral": "first_integral",
    "substitution": "along_motion",
    "stays": "places.stays",
    "rest": "oscillations.forces_at_rest",
    "equilibrium": "oscillations.place_stated oscillations.at_rest stability.stability_said places.can_rest",
    "linearization": "oscillations.series stability.stability_said",
    "open_balance": "oscillations.force_vanishes",
    "open_ends": "identity oscillations.force_at_ends",
    "open_linear": "oscillations.series_in_balance",
    "linear_system": "oscillations.linear_rows",
    "minors": "oscillations.positive_minors",
    "secular": "oscillations.secular",
    "normal_modes": "identity oscillations.characteristic",
    "mode_shape": "identity oscillations.mode_shape",
    "polynomial": "oscillations.polynomial",
    "rate_of_mode": "identity oscillations.rate_of_mode",
    "motion_of_mode": "identity oscillations.motion_of_mode",
    "critical": "identity oscillations.critical",
    "hurwitz": "identity oscillations.hurwitz",
    "asked": "places.has_sign_of_force",
    "vanishing": "vanishing holds_there places.comes_first",
    "value_there": "identity value_there",
    "value_then": "values.value_then",
    "direction": "values.direction",
    "value_told": "values.value_told",
    "value_along": "values.value_along",
    "vanishes_for": "parameters.place_told parameters.vanishes_there",
    "holds_for": "parameters.bound_told parameters.bounds_hold",
    "extreme": "parameters.extreme_told parameters.extreme_there",
    "approached": "parameters.approached",
    "limit": "parameters.limit_told parameters.tends_to",
    "put_in": "answers.put_in",
    "no_change": "answers.no_change",
    "changes": "answers.changes",
    "kept_or_not": "answers.kept_or_not",
    "least_on_way": "answers.least_on_way",
    "one_zero": "answers.one_zero",
    "greatest_of": "answers.greatest_of",
    "course": "solutions.course",
    "reached_in_time": "identity solutions.reached",
    "by_speed": "solutions.by_speed",
    "speed_along": "solutions.speed_along",
    "swing": "identity solutions.swing",
    "kept_speed": "values.kept_speed",
    "followed": "values.followed",
    "steady_place": "values.steady_place",
    "steady_frequency": "identity values.steady_frequency",
    "feature": "identity solutions.feature",
    "inequality": "identity",
    "slip": "identity phases.slip",
    "event_time": "identity phases.reached_then phases.first_then",
    "event_place": "identity phases.reached_there phases.first_there",
    "kept_until": "identity constraints.kept_until",
    "end_state": "identity phases.state_then",
    "jump": "on_motion constraints.momenta_kept",
    "impulse": "on_motion phases.momentum_jump",
    "restitution": "on_motion phases.parting",
    "energy_jump": "on_motion phases.energy_jump",
}


class Rules(Mapping[str, tuple[c.Check, ...]]):
    """The checks of each rule; a module of checks is loaded when a rule asks for it."""

    def __getitem__(self, rule: str) -> tuple[c.Check, ...]:
        return tuple(map(_check, CHECKED[rule].split()))

    def __iter__(self) -> Iterator[str]:
        return iter(CHECKED)

    def __len__(self) -> int:
        return len(CHECKED)


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
