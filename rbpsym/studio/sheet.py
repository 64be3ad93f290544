"""One phase of a motion as the tutor judges it: a line is read with all letters of the derivation, and decided by its checks.

A line is a step if it is printed alike, says the same quantity to be the same value, or is the same equation multiplied by a
constant. Else it holds if one of the checks of steps proves it: as an identity, on the motion, or along it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cached_property, partial
from types import MappingProxyType

from rbpsym.ask.asking import answered_all, letters
from rbpsym.ask.found import Answer
from rbpsym.claims.conditions import relations
from rbpsym.decide.verdict import PROVED, Verdict, undecided
from rbpsym.document.notes import notation_of
from rbpsym.errors import LimitError, RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.infix import Ways, read_relation
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.field import NOTHING, Scalar, Value, is_zero, names_in, symbol
from rbpsym.frozen import Frozen, field, replace
from rbpsym.proof.checks import of_steps as checks
from rbpsym.proof.context import Context
from rbpsym.proof.step import Derivation, Step
from rbpsym.quantity.path import on_path
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.studio.refuting import Refuter
from rbpsym.studio.slips import LineSlip, slip
from rbpsym.studio.untold import Untold
from rbpsym.teaching.grading.ground import Book, GradingGround, book, ground_of
from rbpsym.teaching.grading.reading import meanings, read_all, read_formula
from rbpsym.typeset.latex import to_latex

CHECKS = (checks.identity, checks.on_motion, checks.rates, checks.rates_on_motion, checks.along_motion)
NAMED = frozenset({"E", "I", "K", "U"})  # energies, moments of inertia: what else of the derivation's letters a student types
IN_STATES, ORDERS = (checks.identity, checks.on_motion, checks.along_motion), ("<", "<=", ">", ">=")
INEQUALITY, PRINTED = re.compile(r"[<>≤≥]"), re.compile(r"[\\']")


class PhaseSheet(Frozen):
    """The steps of one phase; ids begin with `prefix`."""

    derivation: Derivation
    language: str = "en"
    prefix: str = ""
    begins: tuple[Step, ...] = ()
    _values: dict[t.Node, Value | None] = field(default_factory=dict)

    @cached_property
    def notation(self) -> Notation:
        """How the problem's names are printed."""
        return notation_of(self.derivation, self.language)

    @cached_property
    def steps(self) -> dict[str, Step]:
        """The proved steps by id, in their order."""
        steps = (*self.begins, *self.derivation.steps)
        return {self.prefix + step.id: step for step in steps if step.certificate.verdict.is_proved}

    @cached_property
    def own(self) -> frozenset[str]:
        """The letters of the steps, with those over which is integrated."""
        parts = [part for step in self.steps.values() for part in t.walk(step.statement)]
        bound = frozenset(part.var for part in parts if isinstance(part, t.Integral))
        return bound.union(*(t.names(step.statement) for step in self.steps.values()))

    @property
    def names(self) -> frozenset[str]:
        """All letters of the statement and of the derivation."""
        return self.own | self.statement_names

    @property
    def statement_names(self) -> frozenset[str]:
        """The letters of the statement."""
        return self._ground.book.names

    @cached_property
    def _ground(self) -> GradingGround:
        return ground_of(self.derivation.study, self.language)

    @cached_property
    def context(self) -> Context:
        """What the letters mean: those of the derivation, and those that students may use untold (I, ω, α of the only body)."""
        own: Context = self.derivation.letters
        study = self.derivation.study  # under the words of the last edit, which `own` has not
        found = answered_all(study, letters(study))
        values = (one.values if isinstance(one, Answer) and one.verdict.is_proved else () for one in found)
        asked = {name: one[0] for name, one in zip(self.asked, values, strict=True) if len(one) == 1}
        return replace(own, scalars={**asked, **self._untold.values, **self._ground.scope.scalars, **own.scalars})

    @cached_property
    def _book(self) -> Book:
        """How all these letters may be typed; those of the statement as they may be without the others (l for ℓ beside L)."""
        problem = self.derivation.study.problem
        found = book(self.names | self._rates.keys(), problem.notation, self.language, problem.names_in(self.language))
        free = {way: name for way, name in self._ground.book.typed.items() if way not in found.names}
        stems = [name.partition("_")[0] for name in self.named]
        alone = {stem: name for stem, name in zip(stems, self.named, strict=True) if stems.count(stem) == 1}
        typed = {**alone, **free, **found.typed}
        asked = {name.partition(".")[0] for name in self.asked}
        wide = book(found.names | (self._untold.names | asked) - typed.keys(), problem.notation, self.language)
        return replace(wide, typed=MappingProxyType({**wide.typed, **typed}))

    @cached_property
    def asked(self) -> Mapping[str, str]:
        """The questions of the problem, each under what the letter of its answer is called in `readings`."""
        return {f"{letter}.{number}.asked": text for number, (text, letter) in enumerate(letters(self.derivation.study).items())}

    @cached_property
    def _untold(self) -> Untold:
        """What else students type; a letter that only vectors have here is free."""
        own: Context = self.derivation.letters
        return Untold(self.derivation.study, self.names - (own.vectors.keys() - own.scalars.keys() - self.statement_names))

    @cached_property
    def named(self) -> tuple[str, ...]:
        """The energies and moments of inertia that the derivation has letters for; the stem of one alone may be typed (U)."""
        return tuple(sorted(n for n in self.own & self.context.scalars.keys() if n.partition("_")[0] in NAMED))

    @cached_property
    def _rates(self) -> dict[str, t.Deriv]:
        """The rates of places that the derivation has letters for, as they may be typed: x_cm_ddot."""
        places = {name for name, value in self.context.scalars.items() if isinstance(value, Scalar) and self._is_place(value)}
        turns = self._untold.names & {"L", "p", "v", "x", "y"}
        found = {f"{name}_{'d' * n}ot": t.Deriv(t.Sym(name), "t", n) for name in places & self.names | turns for n in (1, 2)}
        return {name: node for name, node in found.items() if name not in self.names}

    def _is_place(self, value: Scalar) -> bool:
        system = self.derivation.study.system
        return bool(names_in(value) & {*system.coordinates}) and names_in(value) <= self._given | {*system.coordinates}

    @cached_property
    def printed(self) -> dict[str, tuple[str, ...]]:
        """The ids of the steps that a printed line is or holds."""
        found: dict[str, tuple[str, ...]] = {}
        for id, step in self.steps.items():
            for line in {self.line(row): row for row in (step.statement, *relations(step.statement))}:
                found[line] = (*found.get(line, ()), id)
        return found

    @cached_property
    def _rows(self) -> list[tuple[str, t.Chain]]:
        """The equations of the steps; of a chain, that of its ends too."""
        rows = ((id, row) for id, step in self.steps.items() for row in (*relations(step.statement), *_ends(step.statement)))
        return [(id, row) for id, row in rows if set(row.ops) == {"="}]

    def line(self, node: t.Node) -> str:
        """The LaTeX of a formula without spaces."""
        return "".join(to_latex(node, self.notation).split())

    def ways(self, line: str) -> Ways:
        """The trees of a line, typed plainly or LaTeX: several where a factor is above or below a slash. Raises ReadError."""
        if not PRINTED.search(line):
            return _one(read_relation(line, self.names)) if INEQUALITY.search(line) else self._typed(line)
        with suppress(ReadError):
            return _one(read_latex(line, symbol_table(sorted(self.own), self.notation)))
        try:
            return _one(read_latex(line, symbol_table(sorted(self.names), self.notation)))
        except ReadError as error:
            with suppress(ReadError):  # in letters that students use untold
                return self._typed(line)
            raise error

    def readings(self, tree: t.Node) -> Iterator[t.Node]:
        """What its letters may mean; one may be what is asked, and is that if it is nothing else."""
        found = {name.partition(".")[0]: t.Sym(name) for name in self.asked if name in self.context.scalars}
        known = t.renamed(tree, {sym: to for sym, to in found.items() if sym not in self.names | self._untold.names})
        for read in meanings(known, self.own, self.named):
            yield from self._untold.readings(read)
        if (also := t.renamed(known, found)) != known:
            yield also

    def _typed(self, line: str) -> Ways:
        try:
            ways = _one(read_formula(line, self._book, labels=False))
        except ReadError:
            ways = read_all(line, self._book, labels=False)
        return replace(ways, trees=tuple(map(self._with_rates, ways.trees)))

    def _with_rates(self, node: t.Node) -> t.Node:
        rate = self._rates.get(node.name) if isinstance(node, t.Sym) else None
        return rate or t.mapped(node, self._with_rates)

    def value(self, node: t.Node) -> Value | None:
        """In coordinates, speeds, accelerations and unknown forces; None where it has none."""
        if node not in self._values:
            self._values[node] = None
            with suppress(RbpsymError, ZeroDivisionError):
                self._values[node] = self.context.value(node)
        return self._values[node]

    def rate(self, node: t.Node) -> Value | None:
        """How what is summed up along the motion grows."""
        key = t.Deriv(node, "t")
        if key not in self._values:
            self._values[key] = None
            with suppress(RbpsymError, ZeroDivisionError):
                self._values[key] = self.context.on_motion(self.context.rate(node)) if self.context.grows(node) else None
        return self._values[key]

    def step_of(self, read: t.Node) -> str:
        """The id of the step that the line is; "" if it is none."""
        if ids := self.printed.get(self.line(read)):
            return ids[0]
        rows = [row for row in relations(read) if set(row.ops) == {"="}]
        return self._equal_row(rows[0]) if len(rows) == 1 else ""

    def _equal_row(self, read: t.Chain) -> str:
        """The step of which it is another form."""
        ends, gap = (read.items[0], read.items[-1]), self._gap(read)
        pairs = [(this, self.value(other)) for this, other in (ends, ends[::-1])] if ends[0] != ends[1] else []
        rows = [(id, row.items[0], self.value(row.items[-1])) for id, row in self._rows]
        named = (id for id, left, right in rows for this, other in pairs if this == left and is_same(other, right))
        alike = [(id, its) for id, its in self._gaps if gap is not None and self._is_multiple(gap, its)]
        scaled = (id for id, its in alike if self._is_kept(its) or not self._tells(ends))
        is_identity = is_same(*map(self.value, ends))
        valued = (id for id, _, right in rows for _, other in pairs[:1] if is_same(other, right))
        found = list(named) or list(scaled) or list(valued if is_identity else ())
        return min(found, key=lambda id: not self.steps[id].is_result, default="")

    def _gap(self, row: t.Chain) -> Scalar | None:
        """Left less right, where it is a number that does not vanish."""
        left, right = self.value(row.items[0]), self.value(row.items[-1])
        gap = left - right if isinstance(left, Scalar) and isinstance(right, Scalar) else NOTHING
        return None if is_zero(gap) else gap

    @cached_property
    def _gaps(self) -> list[tuple[str, Scalar]]:
        """Those of the steps."""
        return [(id, gap) for id, row in self._rows if (gap := self._gap(row)) is not None and names_in(gap) - self._given]

    @cached_property
    def _given(self) -> frozenset[str]:
        return frozenset(quantity.name for quantity in self.derivation.study.problem.parameters)

    def _is_kept(self, gap: Scalar) -> bool:
        """Does it vanish all along the motion, and not at a rest or a moment only?"""
        try:
            found = self.context.on_motion(gap)
        except LimitError:  # known at the start alone
            return False
        return isinstance(found, Scalar) and is_zero(found)

    def _tells(self, ends: tuple[t.Node, t.Node]) -> bool:
        """Does an equation say what a letter is that has a value, and not only where it vanishes?"""
        known = [isinstance(end, t.Sym) and self.value(end) not in (None, symbol(end.name)) for end in ends]
        return any(is_known and self.value(other) != NOTHING for is_known, other in zip(known, ends[::-1], strict=True))

    def _is_multiple(self, one: Scalar, other: Scalar) -> bool:
        """Is it the other one times a constant?"""
        return names_in(one) - self._given == names_in(other) - self._given and names_in(one / other) <= self._given

    def holds(self, read: t.Node) -> Verdict:
        """REFUTED with a state of the motion; else what the checks of steps find: the first proof, or UNDECIDED."""
        found = self.refutation(read)
        if not found.is_refuted and (shown := proof(self.context, read)).is_proved:
            return shown
        rows = relations(read) if not found.is_refuted else ()
        return Verdict(PROVED, "the speeds along the way put in") if rows and all(map(self._is_so_on_way, rows)) else found

    def _is_so_on_way(self, row: t.Chain) -> bool:
        """Does what holds a root, the speeds being what they are from the start until the first rest, in each possible sense?"""
        has_root = any(isinstance(part, t.Sqrt) for part in t.walk(row))
        gap = self._gap(row) if has_root and set(row.ops) == {"="} and not self.prefix else None
        motion = ProblemWorld(self.derivation.study).motion
        return gap is not None and all(is_zero(value) for (value,), _ in on_path((gap,), motion))

    def refutation(self, read: t.Node) -> Verdict:
        """REFUTED with a state of the motion, or UNDECIDED with the reason."""
        return self._refuter.refutation(read)

    @cached_property
    def _refuter(self) -> Refuter:
        return Refuter(self.context, tuple(self.steps.values()), self.begins)

    def slip(self, read: t.Node) -> LineSlip:
        """How a wrong line differs from a step; of a root, how its square does."""
        steps, best = [row for _, row in self._rows], LineSlip()
        for row in (row for row in relations(read) if row.ops == ("=",)):
            has_root = any(isinstance(part, t.Sqrt) for end in row.items for part in _factors(end))
            squared = t.equation(*map(_squared, row.items)) if has_root else row
            if squared is not row and self._equal_row(squared):
                return LineSlip("root")
            for valued in (self.value, self.rate):
                own = [t.equation(end, end) for end in squared.items if isinstance(getattr(end, "base", end), t.Sym)]
                if (one := slip(squared, [*steps, *own], valued)).kind:
                    return one
                best = max(best, one, key=lambda each: each.right)
        return best


def _factors(node: t.Node) -> tuple[t.Node, ...]:
    bare = node.arg if isinstance(node, t.Neg) else node
    return bare.factors if isinstance(bare, t.Mul) else (bare,)


def _squared(node: t.Node) -> t.Node:
    return t.mul(*(part.arg if isinstance(part, t.Sqrt) else t.Pow(part, t.Num(2)) for part in _factors(node)))


def proof(context: Context, read: t.Node) -> Verdict:
    """The first proof that a check of steps finds, else what the last says."""
    step, ops = Step("line", "identity", read, "", ""), {op for _, op, _ in t.relations(read)}
    if not ops <= {"=", *ORDERS}:
        return undecided("only equations and inequalities are decided")
    for check in CHECKS if ops == {"="} else IN_STATES:
        found = checks.guarded(partial(check, context, step))
        if found.is_proved:
            break
    return found


def _one(tree: t.Node) -> Ways:
    return Ways((tree,), None, ((),))


def _ends(statement: t.Node) -> list[t.Chain]:
    if not isinstance(statement, t.Chain) or len(statement.items) <= 2 or set(statement.ops) != {"="}:
        return []
    return [t.equation(statement.items[0], statement.items[-1])]


def is_same(one: Value | None, other: Value | None) -> bool:
    """Are both known, and equal for every state?"""
    if isinstance(one, Scalar) and isinstance(other, Scalar):
        return one == other or is_zero(one - other)
    return one is not None and one == other


def sheets(derivation: Derivation, language: str) -> Mapping[str, PhaseSheet]:
    """The phases of a derivation by their names; the first is ""."""
    found = {"": PhaseSheet(derivation, language)}
    for number, phase in enumerate(derivation.phases, 2):
        found[phase.name] = PhaseSheet(phase.derivation, language, f"phase{number}.", phase.begins)
    return found
