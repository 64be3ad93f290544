"""Checks of conservation: momenta are summed over the mass itself, forces are put in one by one with what they are."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, ORIGIN, Scalar, Vector, short, substitute
from rbpsym.derivation.checks import agree, same, weakest
from rbpsym.derivation.checks_constraints import slip_at
from rbpsym.derivation.context import Context
from rbpsym.derivation.mass import angular_momentum, torque
from rbpsym.derivation.step import Step
from rbpsym.equality.verdict import Verdict
from rbpsym.mechanics.system import System


def momenta_kept(context: Context, step: Step) -> Verdict:
    """The momentum of the set grows by what all impulses on it give, unknown ones too (`data`: "jump", "blow").

    That along a direction d is the difference of two angular momenta: about a point displaced across d, and about O.
    """
    jump, blow = step.data["jump"], step.data["blow"]
    points = (jump.where,) if jump.is_turning else (jump.where.turned(), ORIGIN)

    def seen(system: System, speeds: dict[str, Scalar], about: Vector) -> Scalar:
        total = sum((angular_momentum(system, body, about) for body in jump.bodies), NOTHING)
        return substitute(substitute(total, {f"{name}_dot": speed for name, speed in speeds.items()}), blow.state.places)

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
    speeds = {f"{name}_dot": speed for name, speed in state.speeds.items()}
    end, slip = (
        substitute(short(substitute(value, speeds)), state.places)  # sin² + cos² of an angle before its long place
        for value in (total, slip_at(system, system.element(ending.phase.subject)))
    )
    steady = agree(context, context.rate_of(total), NOTHING, "motion")
    return weakest([steady, same(context, end, context.start(total)), same(context, slip, NOTHING)])
