"""A blow as the chapters on it see it, and how what it changes is called: θ̇′ just after, P̂ for the impulse of P."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra import Scalar, substitute, symbol
from rbpsym.derivation.chapters.endings import speed_symbol
from rbpsym.derivation.draft import Draft
from rbpsym.equality.rooted import neat
from rbpsym.mechanics.endings import State
from rbpsym.mechanics.impulse import Moment, impulsive, restitutions
from rbpsym.mechanics.phases import HandOver
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.statement.model import Phase


@dataclass(frozen=True)
class Blow:
    """The systems before and after, the state at the instant, what is found; `number` of the phase that ends."""

    before: System
    after: System
    phase: Phase
    began: HandOver
    number: int

    @property
    def state(self) -> State:
        """Places and speeds just before."""
        return self.began.before

    @property
    def moment(self) -> Moment:
        """The configuration in which it happens."""
        return Moment(self.before, self.after, self.state.places, self.state.speeds)

    @property
    def forces(self) -> tuple[Force, ...]:
        """The impulses on all bodies, as forces."""
        return impulsive(self.after, self.phase.impulses)


def after_name(draft: Draft, coordinate: str) -> str:
    """θ̇′, or ω′ where the speed is called ω."""
    alias = draft.study.problem.notation.get(f"{coordinate}_dot", f"{coordinate}_dot")
    return draft.free(f"{alias}_prime")


def impulse_name(draft: Draft, name: str, blow: Blow) -> str:
    """P̂_x for the impulse of the force P_x; a collision's impulse has its own name."""
    if any(name in restitutions(element) for element in blow.phase.impulses):
        return name
    first, _, rest = name.partition("_")
    return draft.free(f"{first}_hat_{rest}" if rest else f"{first}_hat")


def new_value(draft: Draft, blow: Blow, value: Scalar) -> Scalar:
    """A value after the impulse: its speeds and impulses as letters, at the place where it happens."""
    images = {f"{name}_dot": symbol(after_name(draft, name)) for name in blow.after.independent}
    images |= {name: symbol(impulse_name(draft, name, blow)) for name in blow.after.unknowns}
    return neat(substitute(substitute(value, images), blow.state.places), draft.study.assumptions)


def old_value(draft: Draft, blow: Blow, value: Scalar) -> Scalar:
    """A value just before."""
    speeds = {f"{n}_dot": speed_symbol(draft, n, blow.number, v) for n, v in blow.state.speeds.items()}
    return neat(substitute(substitute(value, speeds), blow.state.places), draft.study.assumptions)


def minus(node: t.Node) -> t.Node:
    """-(a + b), or -a."""
    return t.neg(t.Group(node)) if isinstance(node, t.Add) else t.neg(node)
