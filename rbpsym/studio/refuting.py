"""Whether a student's line is false: refuted on the motion, and at every place of which the derivation tells.

A line may be meant of the whole motion, of a moment of it, or of a rest; it is wrong if it fails in each of these senses.
An inequality is wrong if its contrary is proved.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property, partial

from rbpsym.decide.verdict import REFUTED, Verdict, undecided
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import relations
from rbpsym.field import NOTHING, Scalar, Space, Value, names_in, substitute
from rbpsym.frozen import Frozen
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.proof.checks.of_steps import begin, guarded
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step
from rbpsym.studio import following as f

REASONS = ("several", "near", "passing", "place", "rest", "no_state", "nowhere")  # phrases “tutor.why.REASON”
CONTRARY = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}


class Refuter(Frozen):
    """What refutes the lines of one phase: its steps, what their letters mean, and the steps about how it begins."""

    context: Context
    steps: tuple[Step, ...]
    begins: tuple[Step, ...] = ()

    @cached_property
    def _own(self) -> frozenset[str]:
        """The names that parameters and the motion have."""
        study = self.context.study
        moving = study.system.scope.rates.keys() | study.system.tied().keys()
        declared = (quantity.name for quantity in study.problem.parameters)
        return frozenset(moving).union(declared, study.system.unknowns, study.system.accelerations, "t")

    @property
    def _moving(self) -> frozenset[str]:
        return self._own - {q.name for q in self.context.study.problem.parameters}

    @cached_property
    def letters(self) -> dict[str, Scalar]:
        """The values that steps find for letters of the derivation; a letter with several has none."""
        found: dict[str, list[Scalar]] = {}
        for name, node in _solved(self.steps):
            value = self._value(node) if name not in self._own and not t.names(node) & self._moving else None
            if isinstance(value, Scalar) and name not in names_in(value):
                found.setdefault(name, []).append(value)
        return {name: values[-1] for name, values in found.items() if len({substitute(value, {}) for value in values}) == 1}

    @cached_property
    def _passing(self) -> frozenset[str]:
        """The letters of the steps about how the phase begins, of which no value is known."""
        given = {q.name for q in self.context.study.problem.parameters}
        known = {name for name, value in self.letters.items() if names_in(value) <= given}
        own = {name for name, _ in _solved(tuple(step for step in self.steps if step not in self.begins))}
        return frozenset(name for step in self.begins for name in t.names(step.statement)) - self._own - known - own

    def _value(self, node: t.Node) -> Value | None:
        with suppress(RbpsymError, ZeroDivisionError):
            found: Value = self.context.value(node)
            return found
        return None

    @cached_property
    def _motion(self) -> list[f.FollowedPoint]:
        return f.motion_looks(self.context.study, self.letters)

    @cached_property
    def _places(self) -> list[list[f.FollowedPoint]]:
        resting = [dict(one.at) for one in self._equilibria]
        told = [at for step in self.steps if (at := step.data.get("at")) and dict(at) not in resting]
        found = f.places(self.context.study, told, self.letters)
        return [f.first_looks(course, self.context.study) for course in found]

    @cached_property
    def _equilibria(self) -> tuple[Equilibrium, ...]:
        return () if self.context.study.at_start else self.context.study.equilibria

    @cached_property
    def _rests(self) -> list[list[f.FollowedPoint]]:
        study = self.context.study
        return [f.first_looks(course, study) for course in f.rests(study, self._equilibria, self.letters)]

    @cached_property
    def _is_open(self) -> bool:
        """Are there places of which no formula is known?"""
        study = self.context.study
        without = any("factor" in step.data and not step.data.get("at") for step in self.steps)
        return not study.at_start and (bool(study.rest.open_) or without)

    def refutation(self, read: t.Node) -> Verdict:
        """REFUTED with a state of the motion, or UNDECIDED with the reason."""
        found = undecided("several")
        for row in relations(read) if not t.names(read) & self._ambiguous else ():
            found = guarded(partial(self._of, *row))
            if found.is_refuted:
                break
        return found

    @cached_property
    def _ambiguous(self) -> frozenset[str]:
        """The letters of which steps say what does not go together: they mean several things (P_x of one body and of another)."""
        rows = [(t.Sym(name), node) for name, node in _solved(self.steps) if name not in self._own]
        return frozenset(sym.name for sym, node in rows if guarded(partial(self._of, sym, "=", node)).is_refuted)

    def _of(self, left: t.Node, op: str, right: t.Node) -> Verdict:
        if op in CONTRARY:
            return self._by_contrary(t.relation(left, CONTRARY[op], right))
        if op != "=":
            return undecided("near")
        found = undecided("")
        if (t.names(left) | t.names(right)) & self._passing:
            return undecided("passing")
        for pairs in self._senses(left, right):
            found = f.failing(pairs, self._motion)
            if found.is_refuted:
                return self._everywhere(found, pairs, left, right)
        return found

    def _everywhere(self, found: Verdict, pairs: list[f.Gap], left: t.Node, right: t.Node) -> Verdict:
        """What was refuted on the motion, if it may not be meant of a place or a rest where it does not fail."""
        if not self._may_be_there(left, right):
            return found
        may_rest = self._may_be_rest(pairs)
        if may_rest and self._is_open:
            return undecided("place")
        if not all(f.failing(pairs, seen).is_refuted for seen in (*self._places, *(self._rests if may_rest else ()))):
            return undecided("rest")
        return found

    def _may_be_there(self, left: t.Node, right: t.Node) -> bool:
        """Does it hold something that moves, no rate of a speed, no letter that the derivation defines, and no force that
        vanishes there but as “N = 0”?"""
        names, parts = t.names(left) | t.names(right), (*t.walk(left), *t.walk(right))
        vanishing = {step.data.get("force") for step in self.steps if step.data.get("at")}
        is_zero = t.ZERO in (left, right)
        moves = names & self._moving and not any(isinstance(p, t.Deriv) or p in self._accelerations for p in parts)
        return bool(moves) and names <= self._own | {"pi"} and (is_zero or not names & vanishing)

    @cached_property
    def _accelerations(self) -> frozenset[t.Node]:
        return frozenset(t.Sym(name) for name in self.context.study.system.accelerations)

    def _may_be_rest(self, pairs: list[f.Gap]) -> bool:
        """Does it hold no speed and not the start?"""
        scope = self.context.study.system.scope
        start = {name for value in scope.start.values() for name in names_in(value)} - self._lasting - {"pi"}
        speeds = {name for name in scope.rates if name.endswith("_dot")}
        return not any(names_in(value) & (start | speeds) for pair in pairs for value in pair)

    @cached_property
    def _lasting(self) -> frozenset[str]:
        """The parameters that the equations of motion hold."""
        return frozenset(name for value in f.solved(self.context.study).values() for name in names_in(value))

    def _by_contrary(self, contrary: t.Node) -> Verdict:
        from rbpsym.studio.sheet import proof

        found = proof(self.context, contrary)
        return Verdict(REFUTED, f"the contrary is proved: {found.how}") if found.is_proved else undecided(found.reason)

    def _senses(self, left: t.Node, right: t.Node) -> Iterator[list[f.Gap]]:
        """What must agree: the sides; where something is summed up along the motion, how they begin and how they grow."""
        sides = (left, right)
        if not any(map(self.context.grows, sides)) or not self._is_summed_up(sides):
            yield _pairs(*map(self.context.value, sides))
        elif any(isinstance(side, t.Deriv) for side in sides):
            yield _pairs(*map(self._rate, sides))
        else:
            rates = [self.context.rate(side) for side in sides]
            with suppress(RbpsymError):
                is_vector = any(isinstance(rate, Space) for rate in rates)
                yield [] if is_vector else _pairs(*(begin(self.context, side) for side in sides))
            yield _pairs(*rates)

    def _is_summed_up(self, sides: tuple[t.Node, ...]) -> bool:
        """Is it so along the motion, and not over a body?"""
        parts = [part for side in sides for part in t.walk(side)]
        over = {part.var for part in parts if isinstance(part, t.Integral)}
        moving = self.context.study.system.scope.rates.keys() | {*self.context.study.system.coordinates, "t"}
        held = {part.name for part in parts if isinstance(part, (t.Sym, t.Vec))}
        others = any(isinstance(part, (t.PathIntegral, t.Delta)) for part in parts)
        return bool(over & moving) or others or bool(held & self.context.works.keys())

    def _rate(self, side: t.Node) -> Value:
        """The value of d(…)/dt of what is summed up along the motion, or of what is not."""
        return self.context.rate(side.of) if isinstance(side, t.Deriv) and side.order == 1 else self.context.value(side)


def _pairs(a: Value, b: Value) -> list[f.Gap]:
    """The components that must agree."""
    if isinstance(a, Scalar) and isinstance(b, Scalar):
        return [(a, b)]
    sides = (value.components() if isinstance(value, Space) else (NOTHING, NOTHING, value) for value in (a, b))
    return list(zip(*sides, strict=True))


def _solved(steps: tuple[Step, ...]) -> Iterator[tuple[str, t.Node]]:
    """(letter, what it is) of the rows of steps that give one."""
    for step in steps:
        for left, op, right in relations(step.statement):
            if op == "=" and isinstance(left, t.Sym):
                yield left.name, right
