"""A question about two values: on which ground, how deep one may look, what is the same there."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, substitute
from rbpsym.algebra.evaluate import time_derivative
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.squares import with_squares
from rbpsym.equality.constants import is_algebraic
from rbpsym.equality.decide import PLAIN, cross_difference, scalars_equal
from rbpsym.equality.points import all_atoms
from rbpsym.errors import Undecided
from rbpsym.verify.claims_bound import Motion
from rbpsym.verify.claims_ground import Ground

DEPTHS = ("identity", "motion", "start")
HOW = {
    "identity": "identity",
    "motion": "on the motion",
    "start": "along the motion from the start",
    "sense": "along the motion from the start until it first comes to rest",
    "rates": "equal at the start and in rate",
    "constant": "its rate vanishes on the motion",
}


@dataclass(frozen=True)
class Question:
    """Two values, and how deep one may look for their equality."""

    ground: Ground
    depth: str = ""
    witnesses: bool = True

    @property
    def motion(self) -> Motion:
        """What is true of the motion."""
        return self.ground.motion

    @property
    def depths(self) -> tuple[str, ...]:
        """The depths that may be tried, from the strongest claim to the weakest."""
        return DEPTHS[: DEPTHS.index(self.depth) + 1] if self.depth else DEPTHS

    def seen(self, found: Scalar, depth: str) -> Scalar:
        """A value at some depth."""
        if depth == "identity":
            return found
        found = self.motion.moved(found)
        return with_squares(found, self.motion.squares) if depth == "start" else found

    def rate(self, found: Scalar, depth: str = "motion") -> Scalar:
        """d/dt, works and integrals included. Raises Undecided where it is not known (an unknown force's, say)."""
        if depth == "identity" and self.motion.is_lawless(found):
            raise Undecided("it is not known how this changes with time")
        return time_derivative(self.motion.settled(found), self.ground.scope)

    def begin(self, found: Scalar) -> Scalar:
        """The value in the start state."""
        return substitute(self.motion.moved(found), self.ground.scope.start)


def are_same(a: Scalar, b: Scalar, question: Question) -> bool:
    """Whether equality is PROVED; no witness is looked for where the normal form says no."""
    gap = cross_difference(a, b)
    if not is_zero(gap) and _is_plain(gap):
        return False
    return scalars_equal(a, b, question.motion.assumptions).is_proved


def _is_plain(value: Scalar) -> bool:
    """Is the normal form that of a field, in which only 0 is zero?"""
    return all(atoms.atom(index).kind in PLAIN and not is_algebraic(index) for index in all_atoms([value]))


def tells_of_start(value: Scalar, question: Question) -> bool:
    """Does it hold start values, works or integrals from the start?"""
    names = (*question.motion.starts, *question.motion.ledger)
    return any(depends_on(value, name) for name in names)


def holds_unknowns(value: Scalar, question: Question) -> bool:
    """Does it hold unknown forces or accelerations?"""
    return any(depends_on(value, name) for name in question.motion.unsettled)
