"""What is left of the time."""

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch, there


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    end = bench.placement.mechanism.number(there(phase.value))
    return lambda time, where, speed: time - end
