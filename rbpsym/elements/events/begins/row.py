"""What is left of the gap."""

from copy import copy

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch, met, there


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    mechanism, gap = copy(bench.placement.mechanism), there(phase.gap)
    mechanism.slips = {gap.name: 1}  # whatever it is: the gap does not ask
    [kept, *_] = met(gap, mechanism, start.where.tolist())
    return lambda time, where, speed: kept.at(where.tolist(), speed.tolist()).value
