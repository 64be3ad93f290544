"""The ground on which a claim's formulas are read and decided: symbols with their values, and a motion."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import Scope
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.algebra.vector import Space
from rbpsym.equality.assumptions import Assumptions
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.verify.claims_bound import Bound, Motion, World
from rbpsym.verify.claims_model import Setting
from rbpsym.verify.claims_symbols import Glossary


@dataclass(frozen=True)
class Ground:
    """Names of printed symbols with their bounds; what is defined on the way is kept in `defined`."""

    world: World
    glossary: Glossary
    bounds: Mapping[tuple[str, bool], Bound] = field(default_factory=dict)
    defined: dict[str, Scalar | Space] = field(default_factory=dict)
    premises: Mapping[str, Scalar] = field(default_factory=dict)
    assumed: Assumptions | None = None

    @cached_property
    def motion(self) -> Motion:
        """What is true of the motion, what is given and assumed included."""
        motion = self.world.motion
        if self.assumed is not None:
            motion = replace(motion, assumptions=self.assumed)
        if not self.premises:
            return motion
        return replace(motion, moved=lambda value: substitute(motion.moved(value), self.premises))

    def kind(self, name: str) -> str:
        """What kind of meaning a scalar or vector name has ("value" for a name that is defined by now)."""
        if name in self.defined:
            return "value"
        found = self.bounds.get((name, False)) or self.bounds.get((name, True))
        return found.kind if found else "unknown"

    def bound(self, name: str) -> Bound | None:
        """The bound of a name, with or without an arrow."""
        return self.bounds.get((name, True)) or self.bounds.get((name, False))

    @property
    def scope(self) -> Scope:
        """The scope in which trees are evaluated, with the ledger of works among the rates."""
        base, ledger = self.motion.scope, self.motion.ledger
        scalars, vectors = self._values()
        start = {**base.start, **{name: Scalar(ONE) * 0 for name in ledger}}
        return replace(base, scalars=scalars, vectors=vectors, rates={**base.rates, **ledger}, start=start)

    def _values(self) -> tuple[dict[str, Scalar], dict[str, Space]]:
        scalars: dict[str, Scalar] = {}
        vectors: dict[str, Space] = {}
        for (name, arrow), found in sorted(self.bounds.items(), key=lambda item: item[0][1], reverse=True):
            _enter(scalars, vectors, name, arrow, found)
        for name, value in self.defined.items():
            (vectors if isinstance(value, Space) else scalars)[name] = value
        return scalars, vectors

    def generator(self, name: str) -> str | None:
        """The generator that a printed symbol stands for, None if it is something composed."""
        found = self.scope.scalars.get(name)
        if found is None:
            return name
        terms = found.num.terms
        if found.den is ONE and len(terms) == 1 and list(terms.values()) == [1]:
            [monomial] = terms
            if len(monomial) == 1 and monomial[0][1] == 1:
                return atoms.symbol_name(monomial[0][0])
        return None


def _enter(scalars: dict, vectors: dict, name: str, arrow: bool, found: Bound) -> None:
    """An arrow's own meaning comes first for the vector, the plain symbol's for the scalar."""
    if found.kind in ("constant", "unknown", "defined here"):
        scalars[name] = symbol(f"{name} ")
        return
    if found.scalar is not None and (not arrow or name not in scalars):
        scalars[name] = found.scalar
    if found.vector is not None and (arrow or name not in vectors):
        vectors[name] = found.vector
    for k, value in enumerate(found.points):
        vectors[f"{name}#{k}"] = value
    if found.density is not None:
        vectors[f"{name}/dm"] = found.density


def grounded(setting: Setting, words: Glossary, world: World, names: Collection[str]) -> Ground:
    """The ground of formulas with some names. Raises StatementError at the phrase that means nothing."""
    bounds: dict[tuple[str, bool], Bound] = {}
    for latex, meaning in setting.symbols.items():
        if words.names[latex][0] not in names:
            continue
        try:
            bounds[words.names[latex]] = world.bound(meaning.phrase)
        except RbpsymError as error:
            raise StatementError(
                f"the meaning of {latex}: {error.what}", instead=error.instead, place=meaning.place
            ) from None
    return Ground(world, words, bounds)
