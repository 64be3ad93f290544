"""The vocabulary of a statement: what a kind of shape, interaction or constraint is made of.

The loader, the Python functions, the error messages, the reference pages and `rbpsym new`
all read these tables; the mechanics of a kind stands in `mechanics` under the same name.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.quantities import Dimension


@dataclass(frozen=True, slots=True)
class Field:
    """One key of a kind.

    `kind` is "expression", "pair", "point", "points" (two), "line", "body", "bodies" (any
    number), "two bodies", "choice", "name" (of its own), "constraint" (the name of another one),
    "path" or (of a composite) "parts". `dimension` is that of the expression(s), None if free;
    `default` is what an absent key means, written as in the file (None: the key is required; "":
    absent, or left to the mechanics). `may_use` says of what the expression may be made:
    "parameters", "time" (and parameters), "coordinates" (and those), "speeds" (and all) or "forces" (and the unknown
    ones); `variables` are names that only it knows, with their dimensions. `sign`
    is "positive" or "nonnegative" where a value that is not known to be so is refused.
    """

    name: str
    kind: str
    meaning: str
    dimension: Dimension | None = None
    default: object = None
    choices: tuple[str, ...] = ()
    may_use: str = "parameters"
    sign: str = ""
    variables: tuple[tuple[str, Dimension], ...] = ()


@dataclass(frozen=True, slots=True)
class ElementKind:
    """A kind of shape, interaction or constraint: name, meaning, keys, other names for it.

    `unknowns` are the forces and couples that a constraint brings in: templates over the
    element's `name` and its fields ("{name}_x", "{couple}") with their dimensions. `read_as`: the kind
    as a special case of which it is read.
    """

    name: str
    meaning: str
    fields: tuple[Field, ...] = ()
    aliases: tuple[str, ...] = ()
    unknowns: tuple[tuple[str, Dimension], ...] = ()
    read_as: str = ""


@dataclass(frozen=True, slots=True)
class ElementText:
    """A mass element as infix text in the sizes of the shape (see `model.MassElement`)."""

    ranges: tuple[tuple[str, str, str], ...]
    x: str
    y: str
    measure: str = "1"
    kind: str = "surface"


@dataclass(frozen=True, slots=True)
class ShapeKind(ElementKind):
    """A shape as data: how its mass is spread, its size and its points, all as infix text.

    `size` is the total length, area or volume. `points` are places in the body frame.
    `density` maps each variable that the author's own density may use to its meaning in
    the variables of the element; empty if the shape takes a mass only.
    """

    element: ElementText | None = None
    size: str = ""
    points: tuple[tuple[str, str, str], ...] = ()
    density: tuple[tuple[str, str], ...] = ()
    has_angle: bool = True

    @property
    def point_names(self) -> tuple[str, ...]:
        """Names of the shape's points."""
        return tuple(name for name, _, _ in self.points)


def registry(*kinds: ElementKind) -> dict[str, ElementKind]:
    """The kinds by name, in order."""
    return {kind.name: kind for kind in kinds}


def known_names(kinds: Mapping[str, ElementKind]) -> dict[str, str]:
    """Every name by which a kind may be called, with the kind's own name."""
    own = {name: name for name in kinds}
    return own | {alias: kind.name for kind in kinds.values() for alias in kind.aliases}
