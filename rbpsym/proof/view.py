"""What a step may use: the letters, laws, starts and ranges that its premises grant, and nothing else.

A letter whose definition is not among the premises is a quantity of which nothing is known; an acceleration,
an unknown force or the square of a speed is known only where a premise tells it. What was used is noted:
a premise that no check asked for is no premise.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import fields
from functools import cached_property
from typing import Any
from weakref import proxy

from rbpsym.decide.assumptions import Assumptions
from rbpsym.errors import RbpsymError, Undecided
from rbpsym.expr import tree as t
from rbpsym.field import EX, EY, Meanings, Scalar, Space, Value, depends_on, names_in, substitute, symbol, value, with_squares
from rbpsym.field.modular import NoImage
from rbpsym.frozen import field
from rbpsym.mechanics.system import ConstraintCondition
from rbpsym.proof.context import DECIDED, EXACT, Context
from rbpsym.proof.entailment import Known, SourcedRow, cofactors, known_by, used_by_numbers
from rbpsym.proof.facts import MOTION, law_rows
from rbpsym.proof.letters import fixed, introducers
from rbpsym.proof.step import Step
from rbpsym.proof.told import READERS

NOTHING_KNOWN = Known((), ())
SHARED = tuple(item.name for item in fields(Context))
GRANTS = dict.fromkeys((  # what of the mechanics has to be granted by a premise
    "dynamics", "kinetic", "potential", "on_motion", "motion_rows", "power_balance", "newton_euler_rows", "first_integral",
    "squares", "reactions_along_motion", "works",
), MOTION)  # fmt: skip


class Granted:
    """A study of which only what the premises grant can be asked."""

    def __init__(self, view: View) -> None:
        self._view = view

    def __getattr__(self, name: str) -> Any:
        view = object.__getattribute__(self, "_view")
        if name in GRANTS:
            view.use(GRANTS[name])
        return getattr(view.whole, name)


class View(Context):
    """A context as one step sees it. `order`: ids that it may use; `used`: those that it did use. `by_numbers`: with
    what these are trusted."""

    step: Any = None
    order: tuple[str, ...] = ()
    by_numbers: int = EXACT
    trail: list[set[str]] = field(default_factory=lambda: [set()])
    goals: list[Scalar] = field(default_factory=list)
    opaque: set[str] = field(default_factory=set)

    @cached_property
    def premises(self) -> frozenset[str]:
        """Ids that the step may use."""
        return frozenset(self.order)

    @property
    def used(self) -> set[str]:
        """Ids of the premises that were used so far."""
        return self.trail[-1]

    def use(self, id: str) -> None:
        """Notes that a premise is used. Raises Undecided if it is none of the step's."""
        if id not in self.premises:
            raise Undecided(f"“{id}” is not among the premises")
        self.trail[-1].add(id)

    @contextmanager
    def noting(self) -> Iterator[set[str]]:
        """Within it, uses are noted apart."""
        self.trail.append(set())
        try:
            yield self.trail[-1]
        finally:
            self.trail.pop()

    def _with_opaque(self, find: Callable[[], Any]) -> tuple[Any, frozenset[str]]:
        """What is found, and the letters without meaning that are met, those that were met before too."""
        before = set(self.opaque)
        self.opaque.clear()
        try:
            return find(), frozenset(self.opaque)
        finally:
            self.opaque.update(before)

    @property
    def study(self) -> Any:
        """The mechanics, as far as the premises grant it."""
        return Granted(self)

    @property
    def ties(self) -> tuple[ConstraintCondition, ...]:
        """The conditions that tie coordinates: part of what the law of motion says."""
        if self.whole.at_start and MOTION not in self.premises:
            return ()
        if self.whole.ties:
            self.use(MOTION)
        return self.whole.ties

    @cached_property
    def assumptions(self) -> Assumptions:
        """Declared signs, and the ranges of parameters and of those coordinates that are premises."""
        if self.assumed is not None:
            return self.assumed
        given = self.whole.assumptions
        moving = {c.name for c in self.whole.problem.coordinates} | set(self.whole.problem.implicit)
        free = {n: r for n, r in given.ranges.items() if n not in moving or f"range.{n}" in self.premises}
        self.trail[0].update(f"range.{n}" for n in free if n in moving)
        return Assumptions(given.signs, free)

    # --- letters

    @cached_property
    def scope(self) -> Meanings:
        """The meanings that the premises grant; the start state as far as it is a premise."""
        view = proxy(self)  # no circle: a view goes when nobody holds it any more
        kinds = (("scalars", View._opaque), ("vectors", View._opaque_vector), ("works", lambda _, name: symbol(f"{name}'")))
        scalars, vectors, works = (_Letters(view, getattr(self, kind), opaque) for kind, opaque in kinds)
        return Meanings(scalars, vectors, self._rates, self._starts, lambda f, body: view.body_integral(f, body), works)

    @cached_property
    def _rates(self) -> dict[str, Scalar]:
        return dict(super().scope.rates)

    @cached_property
    def _starts(self) -> dict[str, Scalar]:
        """What the premises say of the start; an unknown force is another one there."""
        granted = {key: found for key, found in super().scope.start.items() if self._is_granted_start(key)}
        return granted | {name: symbol(f"{name}°'") for name in self.whole.system.unsettled.union(self._sought)}

    @cached_property
    def _sought(self) -> frozenset[str]:
        """Speeds at the start that are not declared but follow from the conditions."""
        instant = self.whole.instant if self.whole.at_start else None
        return frozenset(instant.sought if instant else ())

    @property
    def unsettled(self) -> frozenset[str]:
        """Letters without meaning, too."""
        return super().unsettled.union(self.opaque, (f"{name}'" for name in self.opaque))

    def _is_granted_start(self, key: str) -> bool:
        id = f"start.{key.removesuffix('_dot')}"
        return id not in self.facts or id in self.premises

    def meaning(self, letter: str, table: Mapping[str, Value], opaque: Callable[[View, str], Value]) -> Any:
        """What a letter stands for: as the step that introduced it says, if this is the step itself or a premise."""
        id, said = self.introduced.get(letter, ("", None))
        if self.step is not None and id == self.step.id:
            return table[letter]
        if id not in self.premises:
            return opaque(self, letter)
        self.use(id)
        if said is None:
            return self._sealed(table[letter])
        return self.rate(said) if table is self.works else self.value(said)

    def _sealed(self, found: Value) -> Value:
        """A meaning; the letters in it that laws alone tell of are known to be such."""
        for name in names_in(found) & self._untold if isinstance(found, Scalar) else ():
            self._opaque(name)
        return found

    @cached_property
    def _untold(self) -> frozenset[str]:
        return frozenset(name for name, (id, _) in self.introduced.items() if not id)

    def _opaque(self, name: str) -> Scalar:
        if name not in self.opaque:
            self.opaque.add(name)
            for letter in (name, f"{name}'"):
                self._rates.setdefault(letter, symbol(f"{letter}'"))
                self._starts.setdefault(letter, symbol(f"{letter}°'"))
        return symbol(name)

    def _opaque_vector(self, name: str) -> Space:
        x, y, z = (self._opaque(f"{name}.{axis}") for axis in "xyz")
        return Space(EX * x + EY * y, z)

    def body_integral(self, integrand: Scalar, body: str) -> Scalar:
        """∫ f dm, where the shape of the body is a premise."""
        self.use(f"shape.{body}")
        return super().body_integral(integrand, body)

    # --- values

    def start(self, found: Scalar) -> Scalar:
        """The value in the start state, where that is a premise."""
        for name in (names_in(found) & self.whole.system.scope.start.keys()) - self._sought:
            id = f"start.{name.removesuffix('_dot')}"
            if id in self.facts:
                self.use(id)
        return super().start(found)

    def rate(self, node: t.Node) -> Scalar:
        """d/dt of a tree; an integral along the motion begins at the start, which must be a premise."""
        found: Scalar = self._once("rate", node, self._rate)
        return found

    def value(self, node: t.Node) -> Any:
        """The value of a tree in what the premises grant."""
        return self._once("value", node, self._value)

    def _rate(self, node: t.Node) -> Scalar:
        for part in self.parts(node, t.Integral):
            self.start(symbol(part.var))
        return super().rate(node)

    def _value(self, node: t.Node) -> Any:
        for part in self.parts(node, t.Delta, t.At):
            inner: Any = value(part.arg, self.scope)
            self.start(inner)
        return super().value(node)

    def _once(self, kind: str, node: t.Node, find: Callable[[t.Node], Value]) -> Any:
        """What is found, if no other view with the same premises for these letters has found it already."""
        same, rests = self._resting(node)
        key = (kind, id(same), self.step.id if self.step.id in rests else "", (rests | fixed(self)) & self.premises)
        if key not in self.rows:
            with self.noting() as noted:
                found, opaque = self._with_opaque(lambda: find(node))
            self.rows[key] = (found, frozenset(noted), opaque)
        found, noted, opaque = self.rows[key]
        self.trail[-1] |= noted
        for name in opaque:
            self._opaque(name)
        return found

    def _resting(self, node: t.Node) -> tuple[t.Node, frozenset[str]]:
        """The first node that was equal to this one, whose address is its name, and on which introductions it rests."""
        key = ("resting", id(node), len(self.introduced))
        if key not in self.rows:
            same = self.rows.setdefault(("node", node), node)
            self.rows[key] = (node, same, frozenset(introducers(self, [node])))
        _, same, rests = self.rows[key]
        return same, rests

    def on_motion(self, found: Any) -> Any:
        """Accelerations, unknown forces and letters replaced by what the premises say of them."""
        if isinstance(found, Space):
            x, y, z = (self.on_motion(part) for part in found.components())
            return Space(EX * x + EY * y, z)
        found = self._by_laws(found)
        return self._known(found).reduced(found, self)

    def _by_laws(self, found: Scalar) -> Scalar:
        """Accelerations and unknown forces replaced by what all laws together make of them, where that is a premise."""
        if MOTION not in self.premises or self.whole.at_start or not names_in(found) & self.whole.system.unsettled:
            return found
        self.use(MOTION)
        return self.whole.on_motion(found)

    def along(self, found: Scalar) -> Scalar:
        """Squares of speeds replaced too."""
        found = self.on_motion(found)
        found = self._known(found).with_squares(found, self)
        if MOTION not in self.premises or not any(depends_on(found, f"{n}_dot") for n in self.whole.squares):
            return found
        self.use(MOTION)
        for name in self.whole.squares:
            self.use(f"start.{name}")
        return with_squares(found, self.whole.squares)

    # --- what the premises say

    def reach(self, goal: Scalar) -> None:
        """Notes a goal."""
        self.goals.append(goal)

    def agree_by_numbers(self, gap: Scalar, depth: str) -> bool | None:
        """Whether a gap seems to close at that depth, with what is used noted; None if numbers do not tell."""
        speeds = frozenset(self.whole.system.speeds) if depth == "along" else frozenset()
        rows = [row for one in self._keys for row in self.rows[one][0]] if depth != "state" else []
        gap = self._by_laws(gap) if depth != "state" else gap
        if depth == "along" and MOTION in self.premises:
            return None
        try:
            unknown = speeds | self.opaque | self.whole.system.unsettled
            sources = used_by_numbers(rows, gap, unknown, speeds, self.rows)
        except (NoImage, ValueError, ZeroDivisionError):
            return None
        if self.by_numbers == DECIDED:
            self.trail[-1] |= sources or set()
        return sources is not None

    def divisors(self) -> list[Scalar]:
        """What was divided by to reach the goals: no factor by which an equation is multiplied may have a pole."""
        found = []
        for goal in self.goals:
            known = self._known(goal)
            if all(pivot.divisor.number() is not None for pivot in (*known.pivots, *known.squares)):
                continue
            factors = cofactors(known, goal, self.whole.assumptions)
            found += [pivot.divisor.inverse() for pivot in known.used(goal)] if factors is None else factors
        return found

    def _known(self, found: Scalar) -> Known:
        """What follows for the accelerations, unknown forces, letters and squares of speeds in a value."""
        speeds = frozenset(self.whole.system.speeds)
        wanted = frozenset(name for name in names_in(found) if self._rank(name) or name in speeds)
        key = (wanted, *self._keys)
        if wanted and key not in self.rows:
            rows = [row for one in self._keys for row in self.rows[one][0]]
            self.rows[key] = known_by(rows, wanted, self._rank, speeds)
        known: Known = self.rows[key] if wanted else NOTHING_KNOWN
        return known

    @cached_property
    def _keys(self) -> tuple[object, ...]:
        """The premises that say something, as keys under which their rows are found."""
        return tuple(key for id in self.order if self.rows[key := self._told(id)][0])

    def _rank(self, name: str) -> int:
        """1 for a letter without meaning, 2 for an acceleration or an unknown force, 0 for what stays."""
        return 2 if name in self.whole.system.unsettled else 1 if name in self.opaque or name.endswith("'") else 0

    def _told(self, id: str) -> object:
        """The key of a premise's rows, which other views may have worked out with the same premises in use."""
        key = (id, self.rests.get(id, frozenset()) & self.premises, MOTION in self.premises)
        if key not in self.rows:
            self.rows[key] = self._with_opaque(lambda: tuple(row for row in self._rows_of(id) if row.value))
        for name in self.rows[key][1]:
            self._opaque(name)
        return key

    def _rows_of(self, id: str) -> Iterator[SourcedRow]:
        """Values that vanish because of a premise, each with all that they rest on."""
        made = self.steps.get(id)
        if made is None:
            fact = self.facts.get(id)
            for row in law_rows(self.whole, fact) if fact is not None and fact.kind == "law" and fact.subject else ():
                with self.noting() as noted:
                    told = substitute(row, {name: self.scope.scalars[name] for name in names_in(row) & self.scalars.keys()})
                yield SourcedRow(told, frozenset((id, *noted)))
            return
        for read in READERS:
            with suppress(RbpsymError, ZeroDivisionError), self.noting() as noted:
                for row in read(self, made):
                    yield SourcedRow(self._by_laws(row), frozenset((id, *noted)))


def seen_by(context: Context, step: Step, premises: tuple[str, ...], *, by_numbers: int = EXACT) -> View:
    """The context as a step with these premises sees it."""
    shared = {name: getattr(context, name) for name in SHARED}
    return View(**shared, step=step, order=premises, by_numbers=by_numbers)


class _Letters(Mapping[str, Any]):
    """A table of letters that gives those meanings alone which the view grants."""

    def __init__(self, view: View, table: Mapping[str, Value], opaque: Callable[[View, str], Value]) -> None:
        self._view, self._table, self._opaque = view, table, opaque

    def __getitem__(self, name: str) -> Any:
        if name not in self._table:
            raise KeyError(name)
        return self._view.meaning(name, self._table, self._opaque)

    def __contains__(self, name: object) -> bool:
        return name in self._table

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)
