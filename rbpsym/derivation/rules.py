"""The rules by which steps are made, and for each the checks that a step must pass.

A check shares nothing but formulas and arithmetic with the maker of the step. A new rule is a new entry.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rbpsym.derivation import checks as c
from rbpsym.derivation import checks_answers as answers
from rbpsym.derivation import checks_constraints as k
from rbpsym.derivation import checks_oscillations as o
from rbpsym.derivation import checks_parameters as parameters
from rbpsym.derivation import checks_phases as p
from rbpsym.derivation import checks_places as places
from rbpsym.derivation import checks_solutions as solved
from rbpsym.derivation import checks_stability as s
from rbpsym.derivation import checks_values as values
from rbpsym.derivation.context import Context
from rbpsym.derivation.duties import duties
from rbpsym.derivation.step import Certificate, Step
from rbpsym.derivation.view import seen_by
from rbpsym.equality.verdict import undecided

RULES: Mapping[str, tuple[c.Check, ...]] = {
    "statement": (c.identity,),
    "constraint": (c.identity,),
    "no_slip": (c.identity, k.no_slip),
    "taut": (c.identity, k.tension_without_power),
    "tied": (c.identity, k.conditions_kept),
    "mass_integral": (c.identity, c.integrals_by_differentiation),
    "parallel_axis": (c.identity, c.moment_over_mass),
    "mass_center": (c.identity, c.center_over_mass),
    "differentiation": (c.identity, c.derivatives_by_integration),
    "angular_momentum": (c.identity, c.momentum_over_mass),
    "kinetic_energy": (c.identity, c.energy_over_mass),
    "torque": (c.identity, c.torque_by_components),
    "force": (c.identity,),
    "potential": (c.identity, c.conservative),
    "balance": (c.on_motion,),
    "held": (k.kept_condition,),
    "start_rate": (k.rate_at_start,),
    "start_law": (k.law_at_start,),
    "identity": (c.identity,),
    "combination": (c.combination,),
    "solution": (c.on_motion,),
    "work": (c.rates,),
    "workless": (c.rates,),
    "power": (c.power_of_works,),
    "work_energy": (c.rates_on_motion,),
    "work_together": (c.rates_on_motion,),
    "work_integral": (c.rates,),
    "work_sum": (c.combination,),
    "work_done": (c.rates_on_motion,),
    "conservation": (c.identity, c.constant),
    "energy_rate": (c.identity, c.on_motion),
    "first_integral": (c.first_integral,),
    "substitution": (c.along_motion,),
    "stays": (places.stays,),
    "rest": (o.forces_at_rest,),
    "equilibrium": (o.place_stated, o.at_rest, s.stability_said, places.can_rest),
    "linearization": (o.series, s.stability_said),
    "open_balance": (o.force_vanishes,),
    "open_ends": (c.identity, o.force_at_ends),
    "open_linear": (o.series_in_balance,),
    "linear_system": (o.linear_rows,),
    "minors": (o.positive_minors,),
    "secular": (o.secular,),
    "normal_modes": (c.identity, o.characteristic),
    "mode_shape": (c.identity, o.mode_shape),
    "polynomial": (o.polynomial,),
    "rate_of_mode": (c.identity, o.rate_of_mode),
    "motion_of_mode": (c.identity, o.motion_of_mode),
    "critical": (c.identity, o.critical),
    "hurwitz": (c.identity, o.hurwitz),
    "asked": (places.has_sign_of_force,),
    "vanishing": (c.vanishing, c.holds_there, places.comes_first),
    "value_there": (c.identity, c.value_there),
    "value_then": (values.value_then,),
    "direction": (values.direction,),
    "value_told": (values.value_told,),
    "value_along": (values.value_along,),
    "vanishes_for": (parameters.place_told, parameters.vanishes_there),
    "holds_for": (parameters.bound_told, parameters.bounds_hold),
    "extreme": (parameters.extreme_told, parameters.extreme_there),
    "approached": (parameters.approached,),
    "limit": (parameters.limit_told, parameters.tends_to),
    "put_in": (answers.put_in,),
    "no_change": (answers.no_change,),
    "changes": (answers.changes,),
    "kept_or_not": (answers.kept_or_not,),
    "least_on_way": (answers.least_on_way,),
    "one_zero": (answers.one_zero,),
    "greatest_of": (answers.greatest_of,),
    "course": (solved.course,),
    "reached_in_time": (c.identity, solved.reached),
    "speed_along": (solved.speed_along,),
    "swing": (c.identity, solved.swing),
    "kept_speed": (values.kept_speed,),
    "followed": (values.followed,),
    "steady_place": (values.steady_place,),
    "steady_frequency": (c.identity, values.steady_frequency),
    "feature": (c.identity, solved.feature),
    "inequality": (c.identity,),
    "slip": (c.identity, p.slip),
    "event_time": (c.identity, p.reached_then, p.first_then),
    "event_place": (c.identity, p.reached_there, p.first_there),
    "kept_until": (c.identity, k.kept_until),
    "end_state": (c.identity, p.state_then),
    "jump": (c.on_motion, k.momenta_kept),
    "impulse": (c.on_motion, p.momentum_jump),
    "restitution": (c.on_motion, p.parting),
    "energy_jump": (c.on_motion, p.energy_jump),
}


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


def examined(context: Context, step: Step, premises: tuple[str, ...], *, hasty: bool = False) -> tuple[Certificate, set[str]]:
    """The certificate of the step with these premises, and which of them were used; a `hasty` one holds by numbers."""
    view = seen_by(context, step, premises, hasty=hasty)
    checks = RULES[step.rule]
    verdict = c.weakest(c.guarded(lambda check=check: check(view, step)) for check in checks)
    if verdict.is_proved and not view.is_hasty:
        verdict = replace(verdict, obligations=tuple(dict.fromkeys((*verdict.obligations, *duties(view, step)))))
    return Certificate(tuple(check.__name__ for check in checks), verdict), view.used
