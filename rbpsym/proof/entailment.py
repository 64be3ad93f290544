"""What follows from equations that hold: unknowns replaced one after another, and squares of speeds.

An equation is used for the unknown that stands in it linearly with the simplest coefficient; the coefficients that
were divided by are kept, since they must not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Set
from contextlib import suppress
from itertools import combinations
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import NoNumber
from rbpsym.field import NOTHING, ONE, UNITY, Monomial, Poly, Scalar, atoms, is_zero, short, times
from rbpsym.field.calculus import depends_on, derivative, names_in, substitute
from rbpsym.field.division import without_poles
from rbpsym.field.exponentials import with_squares
from rbpsym.field.modular import PRIME, NoImage, value_of
from rbpsym.frozen import Frozen
from rbpsym.mechanics.numbers import number
from rbpsym.proof.context import BareGround

TINY = 1e-9


class SourcedRow(Frozen):
    """A value that vanishes, and the premises that say so."""

    value: Scalar
    sources: frozenset[str]


class Pivot(Frozen):
    """name = value, by an equation in which the coefficient of the name is `divisor`; `row`: the equation as it was told."""

    name: str
    value: Scalar
    divisor: Scalar
    sources: frozenset[str]
    row: Scalar = NOTHING


class Known(Frozen):
    """Pivots in the order in which they are put in; squares of speeds."""

    pivots: tuple[Pivot, ...]
    squares: tuple[Pivot, ...]

    def reduced(self, found: Scalar, notes: BareGround) -> Scalar:
        """The value with all unknowns replaced of which something is known."""
        for pivot in self.pivots:
            if depends_on(found, pivot.name):
                _note(pivot, notes)
                found = short(substitute(found, {pivot.name: pivot.value}))
        return found

    def with_squares(self, found: Scalar, notes: BareGround) -> Scalar:
        """The value with squares of speeds replaced."""
        for pivot in self.squares:
            if depends_on(found, pivot.name):
                _note(pivot, notes)
                found = with_squares(found, {pivot.name.removesuffix("_dot"): pivot.value})
        return found

    def used(self, found: Scalar) -> list[Pivot]:
        """The equations by which a value is reduced."""
        made = []
        for pivot in (*self.pivots, *self.squares):
            if depends_on(found, pivot.name):
                made.append(pivot)
                found = substitute(found, {pivot.name: pivot.value}) if pivot in self.pivots else found
        return made


def _note(pivot: Pivot, notes: BareGround) -> None:
    for id in pivot.sources:
        notes.use(id)


# --- the same by numbers: whether it is worth while, and with which rows


Image = tuple[dict[Monomial, int], frozenset[str]]  # of a row, with its sources
Pivots = dict[Monomial, Image]  # rows by the unknown that they are used for, in order


def used_by_numbers(
    rows: Iterable[SourcedRow], goal: Scalar, unknown: Set[str], even: Set[str], known: dict[object, Any]
) -> frozenset[str] | None:
    """The sources of the rows of which a value is a linear combination, modulo a prime at one point; None if of none.

    `unknown`: the names (beside those with a prime) of which products are unknowns of their own; `even`: of these the
    ones of which only squares are; `known`: images that were found. Raises NoImage for a value without an image.
    """

    def counts(name: str) -> bool:
        return name in unknown or name.endswith("'")

    def image(value: Scalar) -> dict[Monomial, int]:
        key = ("image", value, names_in(value) & unknown, bool(even))
        if key not in known:
            known[key] = _image(value, counts, even)
        found: dict[Monomial, int] = known[key]
        return found

    images = [(image(row.value), row.sources) for row in rows]
    target = image(goal)
    left, sources = _reduced_image(target, _pivots(images))
    if any(len(key) > 1 for key in left):  # products of unknowns, of which one may be told
        by = {part for key in target for part in _parts(key)}
        left, sources = _reduced_image(target, _pivots([*images, *_products(images, by)]))
        if any(atoms.atom(index).kind == "root" for key in left for index, _ in key):
            raise NoImage  # of roots more is known than their squares tell
    return None if left else sources


def _pivots(images: Iterable[Image]) -> Pivots:
    pivots: Pivots = {}
    for image, told_by in images:
        found, sources = _reduced_image(image, pivots)
        if found:
            key = min(found)
            by = pow(found[key], -1, PRIME)
            pivots[key] = {k: v * by % PRIME for k, v in found.items()}, sources | told_by
    return pivots


def _parts(key: Monomial) -> Iterator[Monomial]:
    """By what a row may be multiplied to give this product: a part of it."""
    for size in range(1, len(key)):
        yield from combinations(key, size)


def _products(images: Iterable[Image], by: Iterable[Monomial]) -> Iterator[Image]:
    for part in sorted(by):
        for image, sources in images:
            yield {times(key, part): value for key, value in image.items()}, sources


def _reduced_image(found: dict[Monomial, int], pivots: Pivots) -> Image:
    if found.keys().isdisjoint(pivots):
        return found, frozenset()
    found, sources = dict(found), frozenset[str]()
    for key, (row, rests_on) in pivots.items():
        if factor := found.get(key, 0):
            sources |= rests_on
            for k, v in row.items():
                found[k] = (found.get(k, 0) - factor * v) % PRIME
    return {k: v for k, v in found.items() if v}, sources


def _image(value: Scalar, counts: Callable[[str], bool], even: Set[str]) -> dict[Monomial, int]:
    """A value as a linear form in products of what is unknown."""
    by = pow(_residue(Scalar(value.den), counts), -1, PRIME) if value.den is not ONE else 1
    found: dict[Monomial, int] = {}
    for m, c in value.num.terms.items():
        key, rest, factor = [], [], by
        for index, exponent in m:
            name, atom = atoms.symbol_name(index), atoms.atom(index)
            if atom.kind == "root":  # √x is an unknown of its own, of which the square is x
                factor = factor * pow(_residue(atom.arg, counts), exponent // 2, PRIME) % PRIME
                key += [(index, 1)] if exponent % 2 else []
                continue
            is_free = name is not None and counts(name)
            kept = 0 if not is_free else exponent - exponent % 2 if name in even else exponent
            key += [(index, kept)] if kept else []
            rest += [(index, exponent - kept)] if exponent != kept else []
        image = value_of(Poly({tuple(rest): c})) * factor
        found[tuple(key)] = (found.get(tuple(key), 0) + image) % PRIME
    return {k: v for k, v in found.items() if v}


def _residue(value: Scalar, counts: Callable[[str], bool]) -> int:
    """The image of what is known."""
    if any(counts(name) for name in names_in(value)):
        raise NoImage
    return value_of(value.num) * pow(value_of(value.den), -1, PRIME) % PRIME


def known_by(rows: Iterable[SourcedRow], wanted: Set[str], unknown: Callable[[str], int], speeds: Set[str]) -> Known:
    """What the rows say of the names that are `wanted`, and of those that they are tied to.

    `unknown` ranks the names that may be replaced (0: none of them); speeds are replaced by their squares alone.
    """
    pivots: list[Pivot] = []
    squares: list[Pivot] = []
    for row in _concerned(list(rows), wanted, lambda name: unknown(name) or name in speeds):
        value, sources = row.value, row.sources
        for pivot in pivots:
            if depends_on(value, pivot.name):
                value, sources = short(substitute(value, {pivot.name: pivot.value})), sources | pivot.sources
        names = [name for name in names_in(value) if unknown(name)]
        choice = min(filter(None, (_slope(value, name, unknown(name)) for name in names)), default=None)
        if choice is not None:
            pivots.append(_pivot(value, choice[-1], sources, row.value))
        elif not names:
            found = (_as_square(value, speed, sources) for speed in sorted(speeds & names_in(value)))
            squares += [square for square in found if square is not None]
    return Known(tuple(pivots), tuple(squares))


def _concerned(rows: list[SourcedRow], wanted: Set[str], counts: Callable[[str], object]) -> list[SourcedRow]:
    """The rows in which a wanted name stands, or one that stands in such a row, and so on; in their order."""
    names = [{name for name in names_in(row.value) if counts(name)} for row in rows]
    near, kept = set(wanted), set()
    while more := {k for k, own in enumerate(names) if k not in kept and own & near}:
        kept |= more
        near |= set().union(*(names[k] for k in more))
    return [rows[k] for k in sorted(kept)]


def _slope(value: Scalar, name: str, rank: int) -> tuple[int, bool, int, int, str] | None:
    """How simple it is to solve for the name: its rank, and the size of its coefficient; None if it stands not linearly."""
    if value.den is not ONE and depends_on(Scalar(value.den), name):
        return None
    slope = derivative(value, name)
    if not slope or depends_on(slope, name) or _may_vanish(slope):
        return None
    size = len(slope.num) + (len(slope.den) if slope.den is not ONE else 0)
    return (rank, slope.number() is None, size, sum(map(len, slope.num.terms)), name)


def _may_vanish(slope: Scalar) -> bool:
    """Whether it is zero, or a sum with roots that numbers can't tell from zero: √(p²) - p."""
    if is_zero(slope) or not any(atoms.atom(index).kind == "root" for index in slope.atoms()):
        return is_zero(slope)
    names = sorted(names_in(slope))
    for k in range(len(names) or 1):  # in another order where a root has no value: √(L² - h²)
        with suppress(NoNumber):
            return abs(number(slope, {name: 1 + n / 7 for n, name in enumerate(names[k:] + names[:k], 1)})) < TINY
    return True


def _pivot(value: Scalar, name: str, sources: frozenset[str], row: Scalar) -> Pivot:
    slope = derivative(value, name)
    return Pivot(name, short(-(substitute(value, {name: NOTHING}) / slope)), slope, sources, row)


Made = tuple[Pivot, Scalar, dict[int, Scalar]]  # an equation as it is used, and by what those before are multiplied in it


def cofactors(known: Known, goal: Scalar, given: Assumptions) -> list[Scalar] | None:
    """By what the equations are multiplied to give the goal as their sum, those that count; None if it is no such sum:
    if what is left of it does not vanish."""
    made: list[Made] = []
    for place, pivot in enumerate(known.pivots):
        made.append((pivot, *_combined(pivot.row, {place: UNITY}, made)))
    left, combination = _combined(goal, {}, made)
    if not scalars_equal(left, NOTHING, given).is_proved:
        return None
    return [without_poles(-c) for c in combination.values() if c]


def _combined(value: Scalar, combination: dict[int, Scalar], made: list[Made]) -> tuple[Scalar, dict[int, Scalar]]:
    for pivot, row, inner in made:
        if factor := derivative(value, pivot.name):
            factor = without_poles(factor / pivot.divisor)
            value = short(value - factor * row)
            combination = {k: combination.get(k, NOTHING) - factor * inner.get(k, NOTHING) for k in combination | inner}
    return value, combination


def _as_square(value: Scalar, speed: str, sources: frozenset[str]) -> Pivot | None:
    """q̇² from a q̇² + b = 0."""
    index = atoms.intern("symbol", speed)
    if index in value.den.atoms():
        return None
    parts = value.num.by_power(index)
    if set(parts) - {0, 2} or 2 not in parts:
        return None
    slope, rest = Scalar(parts[2]), Scalar(parts[0]) if 0 in parts else NOTHING
    return None if _may_vanish(slope) else Pivot(speed, -(rest / slope), slope, sources)
