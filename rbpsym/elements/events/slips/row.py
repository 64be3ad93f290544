"""What friction has left of its limit."""

import numpy as np

from rbpsym.oracles.simulation_phases import Bench, Phase, Start, Watch, stated_element


def watch(bench: Bench, phase: Phase, start: Start) -> Watch:
    """A function of time, places and speeds that vanishes at the event."""
    element = stated_element(bench, phase.subject)
    limit = bench.placement.mechanism.number(element["limit"])

    def left(time: float, where: np.ndarray, speed: np.ndarray) -> float:
        forces = bench.multipliers(where, speed)
        return limit * sum(forces[name] for name in element.normals) - abs(forces[element["friction"]])

    return left
