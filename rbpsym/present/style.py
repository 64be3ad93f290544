"""How values are ordered on a page, and which quantities vary with time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

from rbpsym.field import atoms
from rbpsym.field.poly import Monomial, Poly
from rbpsym.field.scalar import Scalar, name_of
from rbpsym.frozen import Frozen, field, replace
from rbpsym.quantities import Dimension

Key = tuple[Any, ...]  # what is sorted by
DERIVED = ("_dot", "_ddot")
COEFFICIENT, OTHER = 0.4, 5  # ranks: a number such as μ is the first factor, but makes no term the first


def _open(sum_: Poly) -> int:
    return 0


class Style(Frozen):
    """Order of factors: `rank` sorts parameters, `moving` are names that vary with time.

    With `dimensions`, a sum of moments of inertia keeps its terms whole (m ℓ²/3 + M ℓ²). With
    `whole`, sums get whole coefficients, as above a bar whose denominator has them. `greater` holds
    pairs of parameters of which the first is known to be the greater one: R - a, never a - R.
    `sense` tells 1 of a sum that is surely not negative, -1 of one that is surely not positive, else 0: it is printed turned.
    With `tangents`, sin A / cos A is printed tan A. In a `gathered` sum, no factor is taken out of some of its terms.
    A root that is `called` by a letter (its atom, the letter, the length at which the spring is slack) is printed so.
    """

    rank: Mapping[str, Key] = field(default_factory=dict)
    moving: frozenset[str] = frozenset()
    dimensions: Mapping[str, Dimension] = field(default_factory=dict)
    whole: bool = False
    greater: frozenset[tuple[str, str]] = frozenset()
    tangents: bool = True
    gathered: bool = False
    sense: Callable[[Poly], int] = _open
    called: tuple[tuple[int, str, Scalar], ...] = ()

    @cached_property
    def _content(self) -> int:
        ways = (self.whole, self.greater, self.tangents, self.gathered, self.sense, self.called)
        return hash((frozenset(self.rank.items()), self.moving, *ways))

    def __hash__(self) -> int:
        return self._content


PLAIN = Style()


def unsigned(style: Style) -> Style:
    """Without what is known of signs: an arccos of what is negative is that of a difference, arccos((b - a)/c)."""
    return replace(style, greater=frozenset(), sense=_open)


def split(m: Monomial, style: Style) -> tuple[Monomial, Monomial]:
    """(parameters, moving part) of a monomial."""
    return tuple(i for i in m if not moves(i[0], style)), tuple(i for i in m if moves(i[0], style))


def moves(index: int, style: Style) -> bool:
    """Whether an atom varies with time."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return found.arg in style.moving or found.arg.endswith(DERIVED)
    return found.kind in ("cos", "sin") or (found.kind != "root" or bool(_root_moves(found.arg, style)))


def varies(index: int, style: Style) -> bool:
    """Whether an atom varies with time, as the sine of a fixed slope does not."""
    found = atoms.atom(index)
    return any(moves(i, style) for i in found.arg.atoms()) if found.kind in ("cos", "sin") else moves(index, style)


def _root_moves(radicand: Scalar, style: Style) -> bool:
    return any(moves(index, style) for index in radicand.atoms())


def is_quadratic(moving: Monomial) -> bool:
    """Whether a speed is squared (an energy): then the number stands as a fraction in front."""
    return any(e == 2 and (atoms.symbol_name(i) or "").endswith("_dot") for i, e in moving)


KIND_RANK = {"root": 6, "symbol": 5, "cos": 9, "sin": 8}


def atom_key(index: int, style: Style) -> Key:
    """Sorting key of a factor."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return style.rank.get(found.arg, _default_rank(found.arg))
    return KIND_RANK.get(found.kind, 10), name_of(index)


def _default_rank(name: str) -> Key:
    if name.endswith("_ddot"):
        return (7, 1, name)
    if name == "pi":  # a number
        return (0, 0, name)
    return (7, 0, name) if name.endswith("_dot") else (5, 0, name)


def term_key(m: Monomial, style: Style) -> Key:
    """Terms with accelerations first, then by parameters, constants of motion last."""
    names = [atoms.symbol_name(i) or "" for i, _ in m]
    second = 0 if any(n.endswith("_ddot") for n in names) else 1
    keys = sorted(((OTHER, *key[1:]) if (key := atom_key(i, style))[0] == COEFFICIENT else key, -e) for i, e in m)
    return (second, [(str(k), e) for k, e in keys])

