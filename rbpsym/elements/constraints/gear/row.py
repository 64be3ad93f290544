"""The force of the teeth."""

from rbpsym.oracles.simulation_contacts import meshing

rows = meshing
