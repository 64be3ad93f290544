"""The force of the slot."""

from rbpsym.oracles.simulation_contacts import sliding

rows = sliding
