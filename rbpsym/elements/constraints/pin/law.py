"""The unknown force at a joint, and its opposite."""

from rbpsym.mechanics.constraints import Joint, pair_of_forces

JOINT = Joint(pair_of_forces, joins=lambda element: (tuple(element["points"]),))
