"""How far the coordinate is from its value."""

import numpy as np

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch, there


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    target = bench.placement.mechanism.number(there(phase.value))
    place, near = bench.placement.names.index(phase.subject), [start.q]

    def ahead(time: float, where: np.ndarray, speed: np.ndarray) -> float:
        near[0] = bench.placement.coordinates(where.tolist(), near[0])
        return float(near[0][place]) - target

    return ahead
