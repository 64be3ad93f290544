"""What may be assumed of the quantities in a claim: signs and open ranges."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

from rbpsym.field import Scalar, names_in
from rbpsym.frozen import Frozen, field, replace

Range = tuple[Scalar | None, Scalar | None]
SIGNS = ("positive", "nonnegative", "nonzero", "real")


class Assumptions(Frozen):
    """signs: name → "positive", "nonnegative", "nonzero" or "real" (also for names not listed).

    ranges: name → (lower, upper), an open interval; a bound may hold other names (θ₀ < θ), None
    means no bound. A name that has a range with lower bound 0 counts as positive.
    reached: (name, side) of each bound that the quantity may have itself, side being 0 (lower) or 1.
    known: values that are positive ("nonnegative" if True stands beside), where no bound of one name says so.
    """

    signs: Mapping[str, str] = field(default_factory=dict)
    ranges: Mapping[str, Range] = field(default_factory=dict)
    reached: frozenset[tuple[str, int]] = frozenset()
    known: frozenset[tuple[Scalar, bool]] = frozenset()

    @cached_property
    def _content(self) -> int:
        return hash((frozenset(self.signs.items()), frozenset(self.ranges.items()), self.reached, self.known))

    def __hash__(self) -> int:
        return self._content

    def sign_of(self, name: str) -> str:
        """The declared sign of a name."""
        return self.signs.get(name, "real")

    def range_of(self, name: str) -> Range:
        """The declared range of a name."""
        return self.ranges.get(name, (None, None))

    def with_signs(self, more: Mapping[str, str]) -> Assumptions:
        """The same with further (or other) signs."""
        return replace(self, signs={**self.signs, **more})

    def with_range(self, name: str, lower: Scalar | None, upper: Scalar | None, reached: Iterable[int] = ()) -> Assumptions:
        """The same with another range of one name; `reached` are the sides (0, 1) that belong to it."""
        sides = {(n, side) for n, side in self.reached if n != name} | {(name, side) for side in reached}
        ranges = {**self.ranges, name: (lower, upper)}
        # signs are found by putting ends in for names, one after the other: none may lead back to where it began
        for other in (behind(self, lower) | behind(self, upper)) - {name}:
            if other in ranges:
                low, high = (None if end is not None and name in names_in(end) else end for end in ranges[other])
                ranges[other] = low, high
        return Assumptions(self.signs, ranges, frozenset(sides), self._known_without(name))

    def sides_of(self, name: str) -> frozenset[int]:
        """The sides (0, 1) of its range that a name may reach."""
        return frozenset(side for n, side in self.reached if n == name)

    def without(self, *names: str) -> Assumptions:
        """The same with nothing assumed of these names."""
        signs = {name: sign for name, sign in self.signs.items() if name not in names}
        ranges = {name: r for name, r in self.ranges.items() if name not in names}
        reached = frozenset(end for end in self.reached if end[0] not in names)
        return Assumptions(signs, ranges, reached, self._known_without(*names))

    def _known_without(self, *names: str) -> frozenset[tuple[Scalar, bool]]:
        return frozenset(item for item in self.known if not names_in(item[0]) & {*names})


def behind(given: Assumptions, bound: Scalar | None) -> set[str]:
    """The names on which a bound depends, through the ranges of its own names too."""
    found: set[str] = set()
    left = set() if bound is None else names_in(bound)
    while left:
        found |= left
        left = {n for name in left for end in given.range_of(name) if end is not None for n in names_in(end)} - found
    return found


NONE = Assumptions()


def positive(*names: str) -> Assumptions:
    """All these names are positive."""
    return Assumptions(dict.fromkeys(names, "positive"))
