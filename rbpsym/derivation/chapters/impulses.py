"""Impulses at an instant: for each body the change of its momentum and spin, restitution, and the state after.

m ΔV = Σ Ĵ, I_cm Δω = Σ r × Ĵ. Only forces that can grow without bound count: those of constraints, and
the impulses that the statement names. Kleppner & Kolenkow 4.4; Meriam & Kraige, Dynamics, 6/8.
"""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on, substitute
from rbpsym.algebra.evaluate import Scope, scalar
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.derivation.chapters.endings import kinetic, speed_symbol
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import BodyRef, StepRef
from rbpsym.equality.rooted import neat
from rbpsym.equality.signs import sign
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.endings import State
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.impulse import approach, impulsive, is_holding, restitutions
from rbpsym.mechanics.phases import HandOver
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.statement.model import Element, Phase


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
    def forces(self) -> tuple[Force, ...]:
        """The impulses on all bodies, as forces."""
        return impulsive(self.after, self.phase.impulses)


def write(draft: Draft, blow: Blow) -> None:
    """The chapter, on the draft of the phase that ends."""
    _define(draft, blow)
    steps = [step for name in blow.after.bodies if (step := _balance(draft, blow, name)) is not None]
    laws = [(element, name) for element in blow.phase.impulses for name in restitutions(element)]
    steps += [_restitution(draft, blow, element, name) for element, name in laws]
    _solved(draft, blow, steps)
    for element in blow.phase.impulses:
        _friction(draft, blow, element)
    _lost(draft, blow)


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


def _define(draft: Draft, blow: Blow) -> None:
    for name in blow.after.independent:
        draft.context.scalars[after_name(draft, name)] = blow.began.speeds[name]
    for name, value in blow.began.impulses.items():
        draft.context.scalars[impulse_name(draft, name, blow)] = value


def _new(draft: Draft, blow: Blow, value: Scalar) -> Scalar:
    """A value after the impulse: its speeds and impulses as letters, at the place where it happens."""
    images = {f"{name}_dot": symbol(after_name(draft, name)) for name in blow.after.independent}
    images |= {name: symbol(impulse_name(draft, name, blow)) for name in blow.after.unknowns}
    return neat(substitute(substitute(value, images), blow.state.places), draft.study.assumptions)


def _old(draft: Draft, blow: Blow, value: Scalar) -> Scalar:
    """A value just before."""
    speeds = {f"{n}_dot": speed_symbol(draft, n, blow.number, v) for n, v in blow.state.speeds.items()}
    return neat(substitute(substitute(value, speeds), blow.state.places), draft.study.assumptions)


def _balance(draft: Draft, blow: Blow, name: str):
    """m ΔV (x and y) and I Δω of one body."""
    new, old = blow.after.bodies[name], blow.before.bodies[name]
    own = [force for force in blow.forces if force.on == name]
    pairs = [
        (new.velocity.x * new.mass, old.velocity.x * old.mass, [force.vector.x for force in own]),
        (new.velocity.y * new.mass, old.velocity.y * old.mass, [force.vector.y for force in own]),
        (new.omega * new.moment, old.omega * old.moment, [torque_about_center(force, new) for force in own]),
    ]
    rows = [row for after, before, parts in pairs if (row := _row(draft, blow, after, before, parts)) is not None]
    if not rows:
        return None
    return draft.add(
        f"impulse.{name}",
        "impulse",
        t.system(rows),
        "phases.impulse",
        premises=draft.those("state.speed", "state.place"),
        body=BodyRef(name),
        data={"body": name, "blow": blow},
    )


def _row(draft: Draft, blow: Blow, after: Scalar, before: Scalar, parts: list[Scalar]) -> t.Node | None:
    """(new) - (old) = Σ impulses; None where nothing happens."""
    new, old = _new(draft, blow, after), _old(draft, blow, before)
    sums = [shown for part in parts if (shown := draft.show(_new(draft, blow, part))) != t.ZERO]
    if not sums and is_zero(new - old):
        return None
    left = [draft.show(new)] if new else []
    left += [_minus(draft.show(old))] if old else []
    return t.equation(t.add(*left), t.add(*sums))


def _minus(node: t.Node) -> t.Node:
    return t.neg(t.Group(node)) if isinstance(node, t.Add) else t.neg(node)


def _restitution(draft: Draft, blow: Blow, element: Element, name: str):
    """n·(v₂' - v₁') = -e n·(v₂ - v₁); the same along the tangent for the friction of a bounce that does not slip."""
    seen = ((blow.after, _new), (blow.before, _old))
    speeds = [draft.show(show(draft, blow, approach(system, element, name, blow.after))) for system, show in seen]
    is_normal = name == element.name
    factor, before = element["restitution" if is_normal else "tangential"], speeds[1]
    around = t.Group(before) if isinstance(before, t.Add) else before
    right = t.ZERO if factor == t.ZERO else t.neg(t.mul(factor, around)) if before != t.ZERO else t.ZERO
    kind = "restitution" if is_normal else "tangential"
    return draft.add(
        f"{kind}.{element.name}",
        "restitution",
        t.equation(speeds[0], _positive(right)),
        f"phases.{kind}.{'taut.' * ('path' in element.values)}{'sticks' if scalar(factor).number() == 0 else 'parts'}",
        coefficient=factor,
        obligations=tuple(t.relation(part, ">=", t.ZERO) for part in (factor, t.add(t.ONE, t.neg(factor)))),
        data={"element": element, "name": name, "blow": blow},
    )


def _friction(draft: Draft, blow: Blow, element: Element) -> None:
    """How much friction is needed to hold, or how fast it slips on: what a bounce asks for."""
    found = blow.began.impulses
    if element.values.get("coefficient") is None:
        return
    if is_holding(element):
        letters = (impulse_name(draft, name, blow) for name in (element["friction"], element.name))
        left, value = t.div(*map(t.Sym, letters)), short(found[element["friction"]] / found[element.name])
    else:
        geometry = geometry_of(blow.after)
        slip = slip_speed(geometry, meeting(element, geometry))
        left = draft.show(_new(draft, blow, slip))
        value = short(substitute(_new(draft, blow, slip), draft.context.scalars))
    draft.add(
        f"friction.{element.name}",
        "identity",
        t.equation(left, draft.show(value, factor=True)),
        f"phases.friction.{'holds' if is_holding(element) else 'slips'}",
        premises=["after.speeds", *draft.those("after.impulses")],
        coefficient=element["coefficient"],
        is_result=True,
        obligations=draft.asked(blow.began.held[element.name]),
    )


def _positive(node: t.Node) -> t.Node:
    """-(e (-v)) as e v."""
    if isinstance(node, t.Neg) and isinstance(node.arg, t.Mul) and isinstance(node.arg.factors[-1], t.Neg):
        return t.mul(*node.arg.factors[:-1], node.arg.factors[-1].arg)
    return node


def _solved(draft: Draft, blow: Blow, steps: list) -> None:
    """The speeds just after, then the impulses."""
    values = {after_name(draft, name): blow.began.speeds[name] for name in blow.after.independent}
    found = {impulse_name(draft, name, blow): value for name, value in blow.began.impulses.items()}
    scope = Scope({n: v for n, v in draft.context.scalars.items() if n not in {**values, **found}})
    rows = [row for step in steps for row in _equations(step.statement, scope)]
    used = {n for n in (*values, *found) if any(depends_on(row, n) for row in rows)}
    rough = {e.name for e in blow.phase.impulses if e.values.get("coefficient") is not None}  # told with their friction
    others = [demand for name, asked in blow.began.held.items() if name not in rough for demand in asked]
    for kind, group in (("speeds", values), ("impulses", found)):
        shown = [
            t.equation(t.Sym(n), draft.show(v, factor=True)) for n, v in group.items() if n in used or kind == "speeds"
        ]
        shown = [row for row in shown if kind == "speeds" or row.items[-1] != t.ZERO]
        if shown:
            draft.add(
                f"after.{kind}",
                "solution",
                t.system(shown),
                f"phases.after.{kind}",
                premises=[step.id for step in steps],
                sources=[StepRef(step.id) for step in steps],
                count=len(shown),
                is_result=True,
                obligations=draft.asked(others if kind == "impulses" else ()),
            )


def _equations(statement: t.Node, scope: Scope) -> list[Scalar]:
    """Left minus right of each row, with the letters of what is unknown."""
    rows = t.rows(statement)
    return [scalar(row.items[0], scope) - scalar(row.items[-1], scope) for row in rows]


def _lost(draft: Draft, blow: Blow) -> None:
    """The kinetic energy before less that after."""
    value, before = blow.began.energy_lost, kinetic(draft, blow.state.places, blow.state.speeds)
    first = draft.define(draft.free("K"), before)
    second = draft.define(draft.free("K_prime"), before - value)
    states = (
        (blow.before, blow.state.places, blow.state.speeds),
        (blow.after, blow.state.places, blow.began.speeds),
    )
    gained = sign(value, draft.study.assumptions).kind == "negative"
    draft.add(
        "energy.lost",
        "energy_jump",
        t.equation(t.add(second, t.neg(first)), draft.show(-value, factor=True))
        if gained
        else t.equation(t.add(first, t.neg(second)), draft.show(value, factor=True)),
        f"phases.lost.{'none' if is_zero(value) else 'gained' if gained else 'some'}",
        premises=["after.speeds"],
        is_result=True,
        data={"states": states[::-1] if gained else states},
    )
