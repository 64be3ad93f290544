"""The force of the slot, normal to it."""

from rbpsym.mechanics.contacts import normal_forces, touching

JOINT = touching(normal_forces)
