"""What a phrase means: values, and the world in which they hold."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Protocol

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import Condition
from rbpsym.errors import StatementError, Undecided
from rbpsym.field import NOTHING, Meanings, Scalar, Space, Vector, depends_on, function, shorten, symbol
from rbpsym.frozen import Frozen, field
from rbpsym.quantities import Dimension


class Bound(Frozen):
    """The meaning of a symbol.

    scalar, vector: its value; a quantity along the axis has both. kind: "value", "constant" (some
    constant of the motion), "unknown", "defined here", "up to a constant". points: the values at
    the points where the external forces act; density: what d(it) is for a mass element, over dm.
    told: the chapter of a derivation that says it, for what is found there and not from its definition. in_plane: whether
    it is a vector in the plane, also where that vanishes. about: of which bodies it tells how the mass is spread, about which
    point (None: the centre of mass of each). values: several at once, in place of one.
    """

    scalar: Scalar | None = None
    vector: Space | None = None
    kind: str = "value"
    points: tuple[Space, ...] = ()
    density: Space | None = None
    told: str = ""
    in_plane: bool = False
    about: tuple[str, str | None] | None = None
    values: tuple[Scalar, ...] = ()

    @property
    def number(self) -> Scalar:
        """Its one value. Raises StatementError for a vector without one, and for several values."""
        if self.scalar is None:
            what = "several values" if self.values else "a vector" if self.vector is not None else "a word"
            raise StatementError(f"a number belongs here, and this is {what}", instead="name a quantity that has one value.")
        return self.scalar

    @property
    def arrow(self) -> Space:
        """It as a vector. Raises StatementError for what is none."""
        if self.vector is None:
            raise StatementError("a vector belongs here, and this is none", instead="name a force, a velocity, an acceleration.")
        return self.vector


def axial(value: Scalar) -> Bound:
    """A quantity along the axis of rotation, counter-clockwise positive."""
    return Bound(value, Space(z=value))


def plane(value: Vector | Space) -> Bound:
    """A vector; as a scalar, its magnitude."""
    space = value if isinstance(value, Space) else Space(value)
    square = space.dot(space)
    return Bound(function("sqrt", Scalar(shorten(square.num), square.den)), space, in_plane=True)


def without_articles(text: str) -> str:
    """Words in which “the” tells nothing."""
    return re.sub(r"\bthe (?=\S)", "", text)


def number(value: Scalar, told: str = "") -> Bound:
    """A scalar."""
    return Bound(value, told=told)


def parts(bound: Bound) -> tuple[Scalar, ...]:
    """The value of a quantity, or both components of a vector in the plane. Raises StatementError if it has none."""
    if bound.vector is not None and (bound.scalar is None or bound.in_plane or bound.vector.plane.parts):
        return bound.vector.plane.x, bound.vector.plane.y
    if bound.values or bound.scalar is not None:
        return bound.values or (bound.number,)
    raise StatementError("this has no value of its own", instead="name a quantity.")


class Motion(Frozen):
    """What is true of the motion: how values are seen at three depths.

    scope: rates and start values; moved: accelerations and unknown forces replaced; squares: of the
    speeds, from the start; ledger: the rates of quantities that are zero at the start (works);
    unsettled: unknown forces and accelerations; lawless: what changes with time in a way that is
    not known, if not replaced; is_free: any state may be the start. is_tied: conditions that are
    not solved tie the coordinates. kept: what the declared ranges of tied coordinates ask for;
    pushed: that contacts push and strings pull. energy: what is conserved of it, None if that is not
    known. states: seeds with the numbers that they give, once looked at.
    """

    scope: Meanings
    assumptions: Assumptions
    moved: Callable[[Scalar], Scalar]
    squares: Mapping[str, Scalar] = field(default_factory=dict)
    speeds: tuple[str, ...] = ()
    starts: frozenset[str] = frozenset()
    unsettled: frozenset[str] = frozenset()
    lawless: frozenset[str] = frozenset()
    is_free: bool = False
    is_tied: bool = False
    kept: tuple[Condition, ...] = ()
    pushed: Callable[[], tuple[Condition, ...]] = tuple
    energy: Scalar | None = None
    ledger: dict[str, Scalar] = field(default_factory=dict)
    states: list[tuple[int, dict[str, float]]] = field(default_factory=list, compare=False, repr=False)

    def is_lawless(self, value: Scalar) -> bool:
        """Does it hold something of which no rate is known?"""
        return any(depends_on(value, name) for name in self.lawless)

    def settled(self, value: Scalar) -> Scalar:
        """The value, as it is on the motion if it holds unknown forces. Raises Undecided if its rate is not known."""
        if self.is_lawless(value):
            value = self.moved(value)
        if self.is_lawless(value):
            raise Undecided("it is not known how this changes with time")
        return value

    def work(self, power: Scalar) -> Scalar:
        """The quantity that grows at this rate from zero at the start."""
        if not power:
            return NOTHING
        name = next((name for name, rate in self.ledger.items() if rate == power), None)
        if name is None:
            name = f"work_{len(self.ledger) + 1}"
            self.ledger[name] = power
        return symbol(name)


# how it is written, what finds its value, and what is offered of it to who writes something else
Phrase = tuple[str, Callable[..., Bound], str]


class World(Protocol):
    """A problem or a theory as claims see it."""

    @property
    def motion(self) -> Motion:
        """What is true of its motion."""

    @property
    def symbols(self) -> Mapping[str, str]:
        """What its own names are printed as, with the names."""

    @property
    def dimensions(self) -> Mapping[str, Dimension]:
        """Those of the generators of its values."""

    def bound(self, phrase: str) -> Bound:
        """What a phrase means. Raises StatementError with what is known for one that means nothing."""
