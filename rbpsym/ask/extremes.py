"""The greatest or least value of a function of one quantity on its range, from the signs of its slope."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress

from rbpsym.ask.limits import leading
from rbpsym.ask.zeros import Crossing, SignTable, settled_sign, sign_table, where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.rooted import neat, over_growth
from rbpsym.decide.signs import sign
from rbpsym.errors import all_there
from rbpsym.field import Scalar, depends_on, derivative, is_zero, names_in, short, substitute
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.events import Way

ENDS = ("at the lower end", "at the upper end")


class Extreme(Frozen):
    """A greatest (least) value, where `asked` is met; of the whole range, or of a neighbourhood.

    place: where, None at infinity. value: None if the function has no bound there. where: "" for a place inside the range,
    else the end that is approached. beside: the sign there of what vanishes at an end. table: the signs of the
    slope (None: it is constant). crossing: instead of a place in closed form.
    """

    place: Scalar | None
    value: Scalar | None
    where: str = ""
    asked: tuple[Demand, ...] = ()
    table: SignTable | None = None
    beside: int = 0
    crossing: Crossing | None = None


def extreme(value: Scalar, name: str, given: Assumptions, sense: int, way: Way | None = None) -> Extreme | None:
    """The greatest value (`sense` 1) or the least one (-1) on the range; None if it is not decided. Of several places that
    have it, that to which a way comes first.

    Ends of the range are looked at as limits; whether they belong to it is for the caller to say.
    """
    found = extremes(value, name, given, sense)
    if found is None:
        return None
    given = where_met(given, found[0].asked) if found else given
    without = next((item for item in found if item.value is None), None)
    best = [item for item in found if all(_is_beyond(item, other, given, sense) for other in found)]
    far = [(way.ahead(item.place), item) for item in best if way and item.place is not None]
    ahead = [(distance, item) for distance, item in far if settled_sign(distance, given) in (0, 1)]
    first = (item for distance, item in ahead if all(settled_sign(other - distance, given) in (0, 1) for other, _ in ahead))
    return without or next(first, best[0] if best else None)


def _is_beyond(item: Extreme, other: Extreme, given: Assumptions, sense: int) -> bool:
    if item is other or item.value is None or other.value is None:
        return item is other
    return settled_sign((item.value - other.value) * sense, given) in (0, 1)


def extremes(value: Scalar, name: str, given: Assumptions, sense: int) -> list[Extreme] | None:
    """Where the slope goes from the sense to its opposite, and the ends towards which the function goes on."""
    slope = derivative(value, name)
    if is_zero(slope):
        return [Extreme(None, value, "everywhere")]
    table = sign_table(slope, name, given)
    if not table.is_whole:
        return None
    limits, given = of_symbol(name, given), where_met(given, table.zeros.asked)
    found = [
        _near(value, name, (zero.place, 0), "", given, table)
        for zero, before, after in zip(table.zeros.found, table.signs, table.signs[1:], strict=False)
        if before == sense and after == -sense
    ]
    if table.zeros.crossings and table.signs[0] == sense:
        found.append(Extreme(None, None, "", table.zeros.asked, table, 0, table.zeros.crossings[0]))
    for end, is_open, side, where in (
        (limits.lower, table.signs[0] == -sense, 1, ENDS[0]),
        (limits.upper, table.signs[-1] == sense, -1, ENDS[1]),
    ):
        if is_open:
            found.append(_near(value, name, (end, side if end is not None else -side), where, given, table))
    return all_there(found)


def least(
    value: Scalar, along: str, given: Assumptions, fits: Callable[[Extreme], bool]
) -> tuple[Scalar, list[Extreme]] | None:
    """A value, or another one of the same sign, and where it is least on a way; None where none of them `fits`."""
    other = over_growth(value, along)  # in which the slope of an exponential is none: with it the value is told as it is
    for each in (value, *([] if other is None else [other]), *_by_linear(value, along, given)):
        found = extremes(each, along, given, -1)
        if found is not None and all(low.crossing is None and fits(low) for low in found):
            own = (low.place is not None and low.value and short(substitute(value, {along: low.place})) for low in found)
            lows = [replace(low, value=one) if one else low for low, one in zip(found, own, strict=True)]
            return (value, lows) if each is other else (each, found)
    return None


def _by_linear(value: Scalar, along: str, given: Assumptions) -> Iterator[Scalar]:
    """p + b/a for a p + b with a positive a: it has the sign of the value, and is least in a place that p does not move."""
    for name in sorted(names_in(value) - {along}):
        slope = derivative(value, name)
        if not depends_on(slope, name) and sign(slope, given).kind == "positive":
            yield value / slope


def _near(
    value: Scalar, name: str, at: tuple[Scalar | None, int], where: str, given: Assumptions, table: SignTable
) -> Extreme | None:
    place, side = at
    if place is not None:
        with suppress(ZeroDivisionError):
            there = neat(substitute(value, {name: place}), given)
            if not where or not is_zero(there):
                return Extreme(place, there, where, table.zeros.asked, table)
    near = leading(value, name, place, given, side or 1)
    if near is None:
        return None
    size = near.limit if near.limit is None else neat(near.limit, given)
    return Extreme(place, size, where, table.zeros.asked, table, settled_sign(near.coefficient, given) or 0)
