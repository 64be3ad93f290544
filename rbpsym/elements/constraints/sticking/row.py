"""N and static friction."""

from rbpsym.oracles.simulation_contacts import holding

rows = holding
