"""The speed of the coordinate."""

import numpy as np

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    place, near = bench.placement.names.index(phase.subject), [start.q]

    def left(time: float, where: np.ndarray, speed: np.ndarray) -> float:
        near[0] = bench.placement.coordinates(where.tolist(), near[0])
        return float(bench.placement.speeds(near[0], where.tolist(), speed.tolist())[place])

    return left
