"""N; with kinetic friction μN against the slip."""

from rbpsym.oracles.simulation_contacts import sliding

rows = sliding
