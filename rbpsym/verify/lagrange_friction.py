"""The virtual work of kinetic friction, for the Lagrange oracle.

Friction μN has no potential and N is no function of the state that the energies know: N is taken
from the derivation, the virtual displacement of the slip from the kinematics.
"""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.mechanics.contacts import meeting, slip_sense
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.friction import geometry_of
from rbpsym.statement.model import Element


def friction_forces(motion, dynamics: Dynamics) -> dict[str, Scalar]:
    """For each coordinate Σ -μN ∂(slip)/∂q̇ over the contacts with kinetic friction."""
    rough = [e for e in motion.system.problem.constraints if e.values.get("coefficient") is not None]
    return {name: sum((_share(motion, e, dynamics.reactions, name) for e in rough), NOTHING) for name in motion.names}


def _share(motion, element: Element, reactions: Mapping[str, Scalar], name: str) -> Scalar:
    geometry = geometry_of(motion.system)
    met = meeting(element, geometry)
    against = -slip_sense(element, geometry, met)
    slip = met.forward.dot(_velocity(motion, met.on, met.place) - _velocity(motion, met.by, met.place))
    return reactions[element.name] * scalar(element["coefficient"]) * against * derivative(slip, f"{name}_dot")


def _velocity(motion, body: str | None, place: Vector) -> Vector:
    """Velocity of the material point of a body at a place, every speed a free symbol."""
    if body is None:
        return ORIGIN
    state = motion.system.bodies[body]
    return motion.velocity(state.center) + (place - state.center).turned() * motion.rate(state.pose.angle)
