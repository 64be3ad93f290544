"""A blow, the names of what it changes, and what it leaves as it is: one equation for each momentum that no unknown impulse
changes.
"""

from __future__ import annotations

from rbpsym.chapters.endings import speed_symbol
from rbpsym.decide.rooted import neat
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, substitute, symbol
from rbpsym.frozen import Frozen
from rbpsym.mechanics.arrivals import ArrivalState
from rbpsym.mechanics.impulse import BeforeAndAfter, impulsive, restitutions
from rbpsym.mechanics.jumps import Jump, road
from rbpsym.mechanics.phases import HandOver
from rbpsym.mechanics.placing import origins
from rbpsym.mechanics.system import Force, System
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import PhraseRef, Step, bodies_named
from rbpsym.statement.model import Phase


class Blow(Frozen):
    """The systems before and after, the state at the instant, what is found; `number` of the phase that ends."""

    before: System
    after: System
    phase: Phase
    began: HandOver
    number: int

    @property
    def state(self) -> ArrivalState:
        """Places and speeds just before."""
        return self.began.before

    @property
    def moment(self) -> BeforeAndAfter:
        """The configuration in which it happens."""
        return BeforeAndAfter(self.before, self.after, self.state.places, self.state.speeds)

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


def write(draft: Draft, blow: Blow) -> list[Step]:
    """The equations that give the speeds just after; none where those of the single bodies are as few."""
    return [_step(draft, blow, jump) for jump in road(blow.moment, blow.phase.impulses)]


def _step(draft: Draft, blow: Blow, jump: Jump) -> Step:
    kind = "torque" if jump.is_turning else "force"
    letters, silent = draft.study.letters, list(dict.fromkeys(force.name for force in jump.silent))
    names = [t.Vec(name) for name in silent]
    point = t.Sym(jump.label or letters.free("C", taken=letters.things))
    axis = {"x": t.Unit("x"), "y": t.Unit("y")}.get(jump.label, draft.show_vector(jump.where))
    is_known = jump.label in origins(blow.moment.before)
    where = ("named" if is_known else "there") if jump.is_turning else "along"
    reason = {"forces": names, "count": len(names), "point": point, "axis": axis}
    return draft.add(
        f"jump.{kind}.{jump.label or 'there'}.{'.'.join(jump.bodies)}",
        "jump",
        _statement(draft, blow, jump),
        f"phases.{'grown' if jump.given else 'kept'}.{where}",
        premises=draft.those("state.speed", "state.place", *(f"law.blow.{body}" for body in jump.bodies)),
        bodies=bodies_named(jump.bodies),
        point=point,
        place=draft.show_vector(jump.where),
        axis=axis,
        silent=PhraseRef(f"phases.silent.{kind if names else 'inner'}", reason),
        data={"jump": jump, "blow": blow},
    )


def _statement(draft: Draft, blow: Blow, jump: Jump) -> t.Node:
    """after = before, or after - before = what is given; turned round where both sides are negative."""
    after, given = (new_value(draft, blow, value) for value in (jump.after, jump.given))
    before = old_value(draft, blow, jump.before)
    if isinstance(draft.show(after), t.Neg):
        after, before, given = -after, -before, -given
    shown = [draft.show(value) for value in (after, before, given)]
    if not given:
        return t.equation(*shown[:2])
    return t.equation(t.add(shown[0], *([minus(shown[1])] if before else [])), shown[2])
