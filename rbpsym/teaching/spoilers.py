"""What a task prints and what it asks for: none of a worksheet's tasks may give away the answer to another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from rbpsym.notation import tree as t

Claim = tuple[t.Node, t.Node]  # the left side and the last right side of a row


@dataclass(frozen=True, slots=True)
class Content:
    """Rows of formulas that a task prints, those in which something is to be found, those that it wants as a number.

    A formula that is printed may well be asked for as a number: that is how a lesson goes on.
    """

    prints: frozenset[Claim] = frozenset()
    asks: frozenset[Claim] = frozenset()
    numbers: frozenset[Claim] = frozenset()

    def spoils(self, other: Content) -> bool:
        """Whether one of the two gives away what the other asks for, or asks for the same."""
        wanted = self.asks & (other.asks | other.prints | other.numbers)
        return bool(wanted or (self.prints | self.numbers) & other.asks or self.numbers & other.numbers)


def claims(statements: Iterable[t.Node]) -> frozenset[Claim]:
    """What statements say, row by row; 0 = 0 and the like give nothing away."""
    return frozenset(claim for statement in statements for claim in _claims(statement))


def _claims(statement: t.Node) -> Iterator[Claim]:
    for row in t.rows(statement):
        if isinstance(row, t.Chain) and len(row.items) > 1 and row.items[-1] != t.ZERO:
            yield row.items[0], row.items[-1]
