"""Checks of what the constraints ask: the conditions hold in the poses that were found for them."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, UNITY, Scalar, Vector, depends_on, substitute, symbol, time_derivative
from rbpsym.derivation.checks import same, weakest
from rbpsym.derivation.context import Context
from rbpsym.derivation.step import Step
from rbpsym.equality.verdict import Verdict
from rbpsym.mechanics.conditions import all_conditions, rate_conditions
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.system import Condition, System, at_point
from rbpsym.notation.tree import relations
from rbpsym.statement.curves import curve_body, toucher
from rbpsym.statement.model import Element

LOCAL = ("x_fixed_in_the_body", "y_fixed_in_the_body")


def conditions_kept(context: Context, step: Step) -> Verdict:
    """All conditions of the constraints hold in the poses as found, and so do their time derivatives (of those that stay
    as equations, where the speeds are told at the start alone, not)."""
    system = context.study.system
    geometry = geometry_of(system)
    open_ = (*system.implicit, *system.speed_ties) if context.study.at_start else ()
    names = {condition.constraint for condition in open_}
    rates = [c for c in rate_conditions(system.problem, geometry) if c.constraint not in names]
    rates += [Condition(c.constraint, time_derivative(c.value, system.scope)) for c in system.implicit if c not in open_]
    _use_conditions(context, step)
    values = [c.value for c in (*all_conditions(system.problem, geometry), *rates)]
    return weakest([same(context, value, NOTHING) for value in values])


def _use_conditions(context: Context, step: Step) -> None:
    """The steps that tell of the conditions in which the quantity stands; where it starts, if only its rate is tied."""
    kept = context.study.system.conditions
    for left, _, _ in relations(step.statement):
        name = getattr(left, "name", "")
        tying = {c.constraint for c in kept if depends_on(c.value, name.removesuffix("_dot"))}
        for id in (f"{kind}.{one}" for one in sorted(tying) for kind in ("condition", "no_slip", "taut")):
            if id in context.steps:
                context.use(id)
        if step.slots.get("variant") == "rate":
            context.use(f"start.{name}")


def no_slip(context: Context, step: Step) -> Verdict:
    """The two material points at the contact have the same velocity along it (`data`: "element")."""
    return same(context, slip_at(context.study.system, step.data["element"]), NOTHING)


def slip_at(system: System, element: Element) -> Scalar:
    """Speed of what touches over what it touches, forward positive.

    Each point is followed as one that is fixed in its body, and its position is differentiated.
    """
    met = meeting(element, geometry_of(system))
    apart = _velocity(system, toucher(element), met.place) - _velocity(system, curve_body(element), met.place)
    return met.forward.dot(apart)


def _velocity(system: System, body: str | None, place: Vector) -> Vector:
    """d/dt of a point fixed in the body, at the moment when it is at `place`."""
    if body is None:
        return Vector({})
    pose = system.bodies[body].pose
    moving = at_point(pose, (symbol(LOCAL[0]), symbol(LOCAL[1]))).rate(system.scope.rates)
    arm = place - pose.origin
    along, across = (at_point(pose, unit) - pose.origin for unit in ((UNITY, NOTHING), (NOTHING, UNITY)))
    here = {LOCAL[0]: arm.dot(along), LOCAL[1]: arm.dot(across)}
    return Vector({angle: substitute(length, here) for angle, length in moving.parts.items()})


def tension_without_power(context: Context, step: Step) -> Verdict:
    """The pulls of the tension, taken together, do no work at any moment (`data`: "tension")."""
    from rbpsym.derivation.mass import power

    system, name = context.study.system, step.data["tension"]
    pulls = [force for force in system.forces if name in force.unknowns]
    return same(context, power(system, pulls), NOTHING)
