"""Checks of conservation: momenta are summed over the mass itself, forces are put in one by one with what they are."""

from __future__ import annotations

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.derivation.checks import same
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
