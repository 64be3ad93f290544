"""The unit impulses of what would keep a contact or a string; friction acts against the slip that there is just before."""

from copy import copy

from rbpsym.oracles.simulation_contacts import slipping
from rbpsym.oracles.simulation_phases import Bench, Element, End, Strikes, dense, met, parting


def struck(element: Element, bench: Bench, end: End) -> Strikes:
    """Each parts with its restitution times the speed of approach."""
    begun = bench.declared_start() or end
    where, mechanism, start = end.where.tolist(), copy(bench.placement.mechanism), begun.where.tolist()
    if "path" not in element.values:
        slip = slipping(element, mechanism, start).at(where, end.speed.tolist())
        mechanism.slips = {element.name: 1 if dense(slip.entries, end.speed.size) @ end.speed > 0 else -1}
    factors = [mechanism.number(element[key]) for key in ("restitution", "tangential")]
    rows = zip(met(element, mechanism, start), factors, strict=False)
    lines = ((kept, factor, dense(kept.at(where, end.speed.tolist()).entries, end.speed.size)) for kept, factor in rows)
    return 0.0, [parting(kept, end, -factor * float(line @ end.speed)) for kept, factor, line in lines]
