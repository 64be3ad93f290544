"""The impulse as it is given."""

from rbpsym.oracles.simulation_phases import Bench, Element, End, Strikes, along


def struck(element: Element, bench: Bench, end: End) -> Strikes:
    """A known impulse."""
    return along(bench, end, (element["on"], bench.placement.mechanism.pair(element["impulse"]))), []
