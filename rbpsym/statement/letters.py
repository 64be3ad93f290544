"""The letters that the program brings in: never one of the problem's own, nor one that is drawn as one of them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from functools import cached_property
from itertools import chain, count

from rbpsym.errors import StatementError
from rbpsym.expr.glyphs import ACCENTS, DOTS, Notation, notation_for
from rbpsym.expr.symbol_table import Drawn, drawn_glyph
from rbpsym.frozen import Frozen
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Problem

# what a part of a name means, unless it is what a body or a force is called
_SPECIAL = (*ACCENTS, *DOTS, "prime")


class Letters(Frozen):
    """The names of a problem's quantities and of its things, and how the quantities are drawn."""

    quantities: frozenset[str]
    things: frozenset[str]
    forces: frozenset[str]
    notation: Notation
    drawn: Mapping[Drawn, str]

    @property
    def names(self) -> frozenset[str]:
        """What is written as a letter: quantities, and vectors of forces."""
        return self.quantities | self.forces

    def free(self, wanted: str, *others: str, mark: str = "b", taken: Collection[str] | None = None) -> str:
        """`wanted`, one of `others`, or `wanted` with a mark: the first that nothing else is called or drawn as.

        `taken` are names besides those of quantities: the vectors of forces, unless it is said otherwise.
        """
        taken = self.forces if taken is None else taken
        marks = (each for each in chain((mark,), (f"{mark}{k}" for k in count(1))) if each not in self.things)
        names = (self.spelled(name) for name in chain((wanted, *others), (f"{wanted}_{each}" for each in marks)))
        return next(n for n in names if self._is_free(n) and n not in taken)

    def _is_free(self, name: str) -> bool:
        return name not in self.quantities and drawn_glyph(self.notation.glyph(name)) not in self.drawn

    @cached_property
    def _doubtful(self) -> frozenset[str]:
        """Parts of names of things that would be accents."""
        return frozenset(part for thing in self.things for part in thing.split("_") if part in _SPECIAL)

    def spelled(self, name: str) -> str:
        """The name with two underscores before what is a thing, and no accent: I__bar for the body “bar”."""
        for part in self._doubtful:
            name = re.sub(rf"(?<=[^_])_{part}(?=_|$)", f"__{part}", name)
        return name


def letters_of(problem: Problem) -> Letters:
    """The letters of a problem, those of its later phases among them. Raises StatementError for two that look alike."""
    coordinates = [c.name for c in problem.coordinates]
    found = [q.name for q in problem.parameters] + [f"{c}{rate}" for c in coordinates for rate in ("", "_dot", "_ddot")]
    forces: set[str] = set()
    for each in (problem, *(phase.problem for phase in problem.phases)):
        found += [name for element in each.constraints for name in unknowns_of(element) if not problem.unstated]
        forces |= {element.name for element in each.elements}
    notation = notation_for((*found, *forces), problem.notation)
    things = forces | {*problem.body_names, *problem.points}
    forces |= {f"{e.name}_{body}" for e in problem.interactions for body in problem.body_names}  # gravity on each body
    return Letters(frozenset(found), frozenset(things), frozenset(forces), notation, _drawn(found, notation))


def _drawn(names: Iterable[str], notation: Notation) -> Mapping[Drawn, str]:
    found: dict[Drawn, str] = {}
    for name in names:
        other = found.setdefault(drawn_glyph(notation.glyph(name)), name)
        if other != name:
            what = f"“{other}” and “{name}” are printed alike"
            raise StatementError(what, instead="give one of them another name, or another print under [notation].")
    return found
