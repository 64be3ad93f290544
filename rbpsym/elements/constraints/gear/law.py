"""The force of the teeth along the common tangent."""

from rbpsym.mechanics.contacts import meshing_force, no_slip, touching

JOINT = touching(meshing_force, rates=no_slip)
