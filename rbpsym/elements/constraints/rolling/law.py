"""The normal force, which pushes, and static friction."""

from rbpsym.mechanics.contacts import holding_forces, no_slip, touching

JOINT = touching(holding_forces, rates=no_slip, is_one_sided=True)
