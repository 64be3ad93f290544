"""The normal force, which pushes; with kinetic friction against the slip."""

from rbpsym.mechanics.contacts import normal_forces, touching

JOINT = touching(normal_forces, is_one_sided=True)
