"""A unit impulse on the second body and its opposite on the first."""

import numpy as np

from rbpsym.oracles.simulation_phases import Bench, Element, End, Parting, Strikes, along


def struck(element: Element, bench: Bench, end: End) -> Strikes:
    """They part with the restitution times the speed of approach."""
    mechanism, (first, second) = bench.placement.mechanism, element["points"]
    x, y = mechanism.pair(element["along"])
    line = along(bench, end, (first, (-x, -y)), (second, (x, y)))
    wanted = -mechanism.number(element["restitution"]) * float(line @ end.speed)
    return 0.0, [Parting(element.name, line, np.zeros(line.size), wanted)]
