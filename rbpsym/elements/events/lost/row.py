"""The multiplier of the contact."""

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    subject = phase.subject
    return lambda time, where, speed: bench.multipliers(where, speed)[subject]
