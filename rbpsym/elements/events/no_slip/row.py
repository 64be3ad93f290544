"""The speed of the slip."""

from rbpsym.oracles.simulation_contacts import slipping
from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch, stated_element
from rbpsym.oracles.simulation_placement import dotted


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    element = stated_element(bench, phase.subject)
    row = slipping(element, bench.placement.mechanism, start.where.tolist())
    return lambda time, where, speed: dotted(row.at(where.tolist(), speed.tolist()).entries, speed.tolist())
