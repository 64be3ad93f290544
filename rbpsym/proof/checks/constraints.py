"""Checks of what constraints and laws say at a moment: of the conditions in the poses that were found, of what is kept through
a blow or until a slip has gone, and of what holds at the start, where conditions are expanded in the time.

Momenta are summed over the mass itself, forces are put in one by one with what they are.
"""

from __future__ import annotations

from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ORIGIN, UNITY, Scalar, Vector, short, symbol, tidy, time_derivative
from rbpsym.field.calculus import depends_on, derivative, names_in, substitute
from rbpsym.mechanics.conditions import all_conditions, rate_conditions
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.system import BodyState, ConstraintCondition, System, at_point, by_letters, in_state
from rbpsym.proof.checks.of_steps import agree, difference, differences, first_proved, same, weakest
from rbpsym.proof.context import Context
from rbpsym.proof.facts import MOTION, law_rows
from rbpsym.proof.mass import angular_momentum, power, torque
from rbpsym.proof.step import Step
from rbpsym.statement.curves import curve_body, toucher
from rbpsym.statement.model import Element
from rbpsym.statement.scope import CLOCK

LOCAL = ("x_fixed_in_the_body", "y_fixed_in_the_body")


def conditions_kept(context: Context, step: Step) -> Verdict:
    """All conditions of the constraints hold in the poses as found, and so do their time derivatives (of those that stay
    as equations, where the speeds are told at the start alone, not); known forces on what has no mass balance."""
    system = context.study.system
    geometry = geometry_of(system)
    open_ = (*system.implicit, *system.speed_ties) if context.study.at_start else ()
    names = {condition.constraint for condition in open_}
    rates = [c for c in rate_conditions(system.problem, geometry) if c.constraint not in names]
    closed = [c for c in system.implicit if c not in open_]
    rates += [ConstraintCondition(c.constraint, time_derivative(c.value, system.scope)) for c in closed]
    _use_conditions(context, step)
    values = [substitute(c.value, system.dependent) for c in (*all_conditions(system.problem, geometry), *rates)]
    light = (s for s in system.bodies.values() if not (s.mass or s.moment or any(f.unknowns for f in system.on(s.name))))
    values += [force for state in light for force in _push_on(system, state)]
    return weakest([same(context, value, NOTHING) for value in values])


def _push_on(system: System, state: BodyState) -> tuple[Scalar, ...]:
    """The force on a body along x and y, and its torque about the centre of mass."""
    forces = system.on(state.name)
    pushes = ((f.vector.x, f.vector.y, f.torque(state.center)) for f in forces)
    return tuple(sum(parts, NOTHING) for parts in zip(*pushes, strict=True))


def _use_conditions(context: Context, step: Step) -> None:
    """The steps that tell of the conditions in which the quantity stands, and what other tied speeds there are; where it starts,
    if only its rate is tied."""
    kept = context.study.system.conditions
    for left, _, _ in t.relations(step.statement):
        name = getattr(left, "name", "")
        tying = {c.constraint for c in kept if depends_on(c.value, name.removesuffix("_dot"))}
        for id in (f"{kind}.{one}" for one in sorted(tying) for kind in ("condition", "no_slip", "taut")):
            if id in context.steps:
                context.use(id)
                own = t.names(context.steps[id].statement) - {name, f"{name}_dot"}
                for fact in sorted(context.facts.keys() & {f"def.{n}" for n in own}):
                    context.use(fact)
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
    return tidy(met.forward.dot(apart))


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
    system, name = context.study.system, step.data["tension"]
    strings, geometry = system.problem.of_kind("string", "link"), geometry_of(system)
    pulls = [force for e in strings for force in JOINTS[e.kind].forces(e, geometry) if name in force.unknowns]
    return same(context, power(system, pulls), NOTHING)


def momenta_kept(context: Context, step: Step) -> Verdict:
    """The momentum of the set grows by what all impulses on it give, unknown ones too (`data`: "jump", "blow").

    That along a direction d is the difference of two angular momenta: about a point displaced across d, and about O.
    """
    jump, blow = step.data["jump"], step.data["blow"]
    points = (jump.where,) if jump.is_turning else (jump.where.turned(), ORIGIN)

    def seen(system: System, speeds: dict[str, Scalar], about: Vector) -> Scalar:
        total = sum((angular_momentum(system, body, about) for body in jump.bodies), NOTHING)
        return in_state(total, blow.state.places, speeds)

    def pushed(about: Vector) -> Scalar:
        found = torque([force for force in blow.forces if force.on in jump.bodies], about)
        return substitute(substitute(found, blow.began.impulses), blow.state.places)

    gains = [seen(blow.after, blow.began.speeds, p) - seen(blow.before, blow.state.speeds, p) - pushed(p) for p in points]
    return same(context, gains[0], gains[1] if len(gains) > 1 else NOTHING)


def kept_until(context: Context, step: Step) -> Verdict:
    """The angular momentum, summed over the mass, does not change on the motion, and is at the end what it was at the start;
    the points that touch, each fixed in its body, have the same velocity then (`data`: "kept", "ending")."""
    kept, ending = step.data["kept"], step.data["ending"]
    system, state = context.study.system, ending.state
    total = sum((angular_momentum(system, body, kept.where) for body in kept.bodies), NOTHING)
    speeds = by_letters(state.speeds)
    end, slip = (
        substitute(short(substitute(value, speeds)), state.places)  # sin² + cos² of an angle before its long place
        for value in (total, slip_at(system, system.element(ending.phase.subject)))
    )
    steady = agree(context, context.rate_of(total), NOTHING, "motion")
    return weakest([steady, same(context, end, context.start(total)), same(context, slip, NOTHING)])


MOMENT = "time_since_the_start"


def kept_condition(context: Context, step: Step) -> Verdict:
    """What is stated, times a positive constant, is a condition of the constraint (`data`: "constraint", "factor")."""
    context.use(MOTION)
    system, stated = context.study.system, difference(context, step.statement) * step.data["factor"]
    kept = (c.value for c in (*system.implicit, *system.speed_ties) if c.constraint == step.data["constraint"])
    return first_proved((same(context, value, stated) for value in kept), NOT_KNOWN)


NOT_KNOWN = undecided("it is not among what is known at the start")


def rate_at_start(context: Context, step: Step) -> Verdict:
    """The derivative of that order of a condition, expanded from the start (`data`: "of", "order", "factor")."""
    context.use(step.data["of"])
    value = _expanded(context, difference(context, context.steps[step.data["of"]].statement))
    for _ in range(step.data["order"]):
        value = derivative(value, MOMENT)
    found = substitute(value, {MOMENT: NOTHING})
    return agree(context, found, difference(context, step.statement) * step.data["factor"], "motion")


def _expanded(context: Context, value: Scalar) -> Scalar:
    """A value with q + q̇ t + q̈ t²/2 from the start for every coordinate."""
    moment, images, held = symbol(MOMENT), {CLOCK: symbol(MOMENT)}, names_in(value)
    for name in context.study.system.coordinates:
        if held & {name, f"{name}_dot"}:
            place, speed, gain = (context.start(symbol(f"{name}{tail}")) for tail in ("", "_dot", "_ddot"))
            images |= {name: place + speed * moment + gain * moment * moment / 2, f"{name}_dot": speed + gain * moment}
    return substitute(value, images)


def law_at_start(context: Context, step: Step) -> Verdict:
    """Each relation is one of the equations of a law where the motion starts, up to its sign (`data`: "law")."""
    context.use(step.data["law"])
    rows = [context.start(row) for row in law_rows(context.whole, context.facts[step.data["law"]])]
    gaps = differences(context, step.statement)
    found = ((agree(context, row, way, "motion") for row in rows for way in (gap, -gap)) for gap in gaps)
    return weakest([first_proved(verdicts, NOT_KNOWN) for verdicts in found])
