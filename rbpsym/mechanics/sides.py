"""What becomes of each one-sided force on the motion told, and of each friction that has a limit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.decide.assumptions import Assumptions
from rbpsym.field import Scalar, depends_on
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.events import Losses, pushes
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.system import System

LARGEST = 400  # terms: conditions on what is longer are left as they stand


class Side(Frozen):
    """A one-sided force with its `value` on the motion, and what becomes of it: it is "kept" (up to where the force `until`
    is lost), "lost", or not negative under the conditions `valid` only ("asked"; "open": whether they are met on the way
    is not decided, though the value is a function of the position alone)."""

    force: str
    value: Scalar
    state: str
    until: str = ""
    valid: tuple[Demand, ...] = ()


def sides(system: System, known: Mapping[str, Scalar], ended: Losses, given: Assumptions) -> tuple[Side, ...]:
    """All one-sided forces, from their values along the motion as far as these are known; each loss is a case of its own."""
    constraints = system.problem.constraints
    names = [name for element in constraints for name in pushes(element) if name in known]
    slips = any(element.values.get("limit") is not None for element in constraints)
    lost = {name: [loss for loss in ended.found if loss.force == name] for name in names}
    each = {name: [Side(name, known[name], "lost", "", loss.valid) for loss in losses] for name, losses in lost.items()}
    return tuple(side for name in names for side in each[name] or [_lasting(name, known[name], ended, given, slips, system)])


def _lasting(name: str, value: Scalar, ended: Losses, given: Assumptions, slips: bool, system: System) -> Side:
    """`slips`: a force that is nowhere lost may be so because something slips before. What is asked of the parameters alone is
    asked at the start already."""
    asked: tuple[Demand, ...] = (Demand(value, ">="),)
    if len(value.num) * len(value.den) <= LARGEST:
        asked = asked if (left := settle(asked, given)) is None else left
    if not asked:
        return Side(name, value, "kept")
    moving = any(depends_on(demand.value, q) for demand in asked for q in (*system.coordinates, *system.speeds, "t"))
    if ended.complete is True and (ended.found or not slips) and moving:
        return Side(name, value, "kept", next((loss.force for loss in ended.found), ""))
    return Side(name, value, "open" if any(loss.force == name for loss in ended.open_) else "asked", "", asked)


def lasting(found: tuple[Side, ...], needs: tuple[FrictionNeed, ...], given: Assumptions) -> tuple[Demand, ...]:
    """What a motion told for all time asks for: that no contact is lost before, no string is slack and nothing slips."""
    asked = [demand for one in found for demand in (one.valid if one.state in ("asked", "open") else (Demand(one.value, ">="),))]
    asked += grips(needs)
    return tuple(asked) if (left := settle(asked, given)) is None else left


def grips(needs: tuple[FrictionNeed, ...]) -> Iterator[Demand]:
    """What friction asks for to stay within the limits that are stated, where it is not sure to do so."""
    for need in needs:
        if need.limit is not None and not need.holds:
            sizes = (need.ratio, -need.ratio) if need.needed is None else (need.needed,)
            yield from (Demand(need.limit - size, ">=") for size in sizes)
