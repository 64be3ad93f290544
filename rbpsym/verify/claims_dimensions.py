"""The dimensions of printed symbols, from the values they stand for: how an ambiguous formula is read."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.homogeneity import faults
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.symbol_table import SymbolTable
from rbpsym.quantities import ENERGY, NUMBER, Dimension
from rbpsym.verify.claims_bound import Bound, World
from rbpsym.verify.claims_ground import Glossary
from rbpsym.verify.claims_model import Setting


def with_dimensions(words: Glossary, setting: Setting, world: World) -> SymbolTable:
    """The table of a glossary that chooses readings by the dimensions of its symbols, looked up when asked for."""
    phrases = {words.names[latex][0]: meaning.phrase for latex, meaning in setting.symbols.items()}
    return replace(words.table, faults=_judge(phrases, world), varies=partial(_varies, phrases, world))


def _varies(phrases: Mapping[str, str], world: World, name: str) -> bool:
    """May the quantity of a name change during the motion?"""
    try:
        found = world.bound(phrases[name]) if name in phrases else None
    except (RbpsymError, ZeroDivisionError):
        found = None
    if found is None:
        return True
    if found.kind != "value" or found.vector is not None or found.scalar is None:
        return found.kind != "constant"
    motion = world.motion
    return phrases[name] == "t" or any(
        depends_on(found.scalar, other)
        for names in (motion.scope.rates, motion.ledger, motion.unsettled, motion.lawless)
        for other in names
    )


def _judge(phrases: Mapping[str, str], world: World) -> Callable[[t.Node], int]:
    known: dict[str, Dimension | None] = {}

    def judged(node: t.Node) -> int:
        for name in t.names(node) - known.keys():
            known[name] = _of_phrase(phrases.get(name), world)
        return faults(node, {name: found for name, found in known.items() if found is not None})

    return judged


def _of_phrase(phrase: str | None, world: World) -> Dimension | None:
    """None where nothing is known."""
    if phrase is None:
        return None
    with suppress(RbpsymError, ZeroDivisionError):
        return dimension_of_bound(
            world.bound(phrase), {**world.dimensions, **dict.fromkeys(world.motion.ledger, ENERGY)}
        )
    return None


def dimension_of_bound(found: Bound, known: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a meaning; None for one that has no value yet, or is zero."""
    if found.vector is not None:
        parts = [*found.vector.plane.parts.values(), found.vector.z]
        return next((d for part in parts if part and (d := dimension_of_value(part, known)) is not None), None)
    return None if found.scalar is None else dimension_of_value(found.scalar, known)


def dimension_of_value(value: Scalar, known: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a value, by one term of it; None for zero or where a name is not known."""
    top, low = (_of_poly(poly, known) for poly in (value.num, value.den))
    return None if top is None or low is None else top / low


def _of_poly(poly: Poly, known: Mapping[str, Dimension]) -> Dimension | None:
    monomial = next(iter(poly.terms), None)
    if monomial is None:
        return None
    found = NUMBER
    for index, exponent in monomial:
        part = _of_atom(index, known)
        if part is None:
            return None
        found = found * part**exponent
    return found


def _of_atom(index: int, known: Mapping[str, Dimension]) -> Dimension | None:
    atom = atoms.atom(index)
    if index == atoms.PI:
        return NUMBER
    if atom.kind == "symbol":
        return known.get(atom.arg)
    if atom.kind == "root":
        inner = dimension_of_value(atom.arg if isinstance(atom.arg, Scalar) else Scalar(atom.arg), known)
        return None if inner is None else inner ** Fraction(1, 2)
    return NUMBER
