"""Impulses at an instant: for each body the change of its momentum and spin, restitution, and the state after.

m ΔV = Σ Ĵ, I_cm Δω = Σ r × Ĵ. Only forces that can grow without bound count: those of constraints, and
the impulses that the statement names. Kleppner & Kolenkow 4.4; Meriam & Kraige, Dynamics, 6/8.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rbpsym.chapters import endings, jumps
from rbpsym.chapters.endings import Ending, kinetic
from rbpsym.chapters.jumps import Blow, after_name, impulse_name, minus, new_value, old_value
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Meanings, Scalar, depends_on, is_zero, names_in, short, substitute, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.energy import kinetic_energy
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.impulse import approach, is_holding, restitutions
from rbpsym.mechanics.phases import Stage, known_stages
from rbpsym.proof.draft import Draft
from rbpsym.proof.facts import Fact
from rbpsym.proof.step import FULL, STANDARD, BodyRef, Step, StepRef
from rbpsym.statement.model import Element, Phase, Problem


def write(draft: Draft, blow: Blow) -> None:
    """The chapter, on the draft of the phase that ends."""
    _define(draft, blow)
    kept = jumps.write(draft, blow)
    single = [] if kept else _single(draft, blow, STANDARD)
    parted = [_restitution(draft, blow, element, name) for element, name, _ in _partings(blow)]
    _speeds(draft, blow, [*(kept or single), *parted])
    level = FULL if kept and not _is_asked(draft, blow) else STANDARD
    _impulses(draft, blow, [*(single or _single(draft, blow, level)), *parted], level)
    for element in blow.phase.impulses:
        _friction(draft, blow, element)
    _lost(draft, blow)


def _define(draft: Draft, blow: Blow) -> None:
    """Letters of speeds just after and of impulses, of which nothing is known but what the laws of the blow say."""
    found = {after_name(draft, name): blow.began.speeds[name] for name in blow.after.independent}
    found |= {impulse_name(draft, name, blow): value for name, value in blow.began.impulses.items()}
    draft.context.scalars.update(found)
    draft.context.introduced.update(dict.fromkeys(found, ("", None)))
    for body in blow.after.bodies:
        rows = (
            new_value(draft, blow, after - sum(parts, NOTHING)) - old_value(draft, blow, before)
            for after, before, parts in _changes(blow, body)
        )
        _state_law(draft, f"law.blow.{body}", body, rows)
    for element, name, factor in _partings(blow):
        new, old = (approach(system, element, name, blow.after) for system in (blow.after, blow.before))
        _state_law(draft, f"law.parting.{name}", name, [new_value(draft, blow, new) + factor * old_value(draft, blow, old)])
    ties = [time_derivative(c.value, blow.after.scope) for c in blow.after.implicit] + [c.value for c in blow.after.speed_ties]
    _state_law(draft, TIED, "all", (new_value(draft, blow, value) for value in ties))


TIED = "law.tied"


def _state_law(draft: Draft, id: str, subject: str, rows: Iterable[Scalar]) -> None:
    """What holds at the instant, as a fact; it rests on what the letters of the state just before rest on."""
    if rows := tuple(row for row in rows if row):
        draft.context.facts[id] = Fact(id, "law", subject, rows)
        made = (draft.context.introduced.get(name, ("",))[0] for row in rows for name in names_in(row))
        draft.context.rests[id] = frozenset(filter(None, made))


def _partings(blow: Blow) -> list[tuple[Element, str, Scalar]]:
    """Each collision or bounce with its impulses, and the speed of parting over that of approach."""
    return [(element, name, e) for element in blow.phase.impulses for name, e in restitutions(element).items()]


def _changes(blow: Blow, name: str) -> list[tuple[Scalar, Scalar, list[Scalar]]]:
    """Momentum (x and y) and spin of a body just after and just before, and the impulses that change it."""
    new, old = blow.after.bodies[name], blow.before.bodies[name]
    own = [force for force in blow.forces if force.on == name]
    return [
        (new.velocity.x * new.mass, old.velocity.x * old.mass, [force.vector.x for force in own]),
        (new.velocity.y * new.mass, old.velocity.y * old.mass, [force.vector.y for force in own]),
        (new.omega * new.moment, old.omega * old.moment, [torque_about_center(force, new) for force in own]),
    ]


def _is_asked(draft: Draft, blow: Blow) -> bool:
    """Whether impulses are needed: because a contact must push, for friction, or since the question is about one."""
    asks = any("impulse" in question.split() for question in draft.study.problem.questions)
    return asks or bool(_demands(blow)) or any(e.values.get("coefficient") is not None for e in blow.phase.impulses)


def _demands(blow: Blow) -> list[Demand]:
    """What contacts ask of the impulses, but for those that are told with their friction."""
    rough = {e.name for e in blow.phase.impulses if e.values.get("coefficient") is not None}
    return [demand for name, asked in blow.began.held.items() if name not in rough for demand in asked]


def _single(draft: Draft, blow: Blow, level: int) -> list[Step]:
    return [step for name in blow.after.bodies if (step := _balance(draft, blow, name, level)) is not None]


def _balance(draft: Draft, blow: Blow, name: str, level: int) -> Step | None:
    """m ΔV (x and y) and I Δω of one body."""
    rows = [row for change in _changes(blow, name) if (row := _row(draft, blow, *change)) is not None]
    if not rows:
        return None
    return draft.add(
        f"impulse.{name}",
        "impulse",
        t.system(rows),
        "phases.impulse",
        premises=draft.those("state.speed", "state.place", f"law.blow.{name}"),
        level=level,
        body=BodyRef(name),
        data={"body": name, "blow": blow},
    )


def _row(draft: Draft, blow: Blow, after: Scalar, before: Scalar, parts: list[Scalar]) -> t.Node | None:
    """(new) - (old) = Σ impulses; None where nothing happens."""
    new, old = new_value(draft, blow, after), old_value(draft, blow, before)
    sums = [shown for part in parts if (shown := draft.show(new_value(draft, blow, part))) != t.ZERO]
    if not sums and is_zero(new - old):
        return None
    left = [draft.show(new)] if new else []
    left += [minus(draft.show(old))] if old else []
    return t.equation(t.add(*left), t.add(*sums))


MANNERS: Mapping[object, str] = {0: "sticks", 1: "whole"}  # by the coefficient


def _restitution(draft: Draft, blow: Blow, element: Element, name: str) -> Step:
    """n·(v₂' - v₁') = -e n·(v₂ - v₁); the same along the tangent for the friction of a bounce that does not slip."""
    seen = ((blow.after, new_value), (blow.before, old_value))
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
        f"phases.{kind}.{'taut.' * ('path' in element.values)}{MANNERS.get(scalar(factor).number(), 'parts')}",
        premises=[f"law.parting.{name}"],
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
        left = draft.show(new_value(draft, blow, slip))
        value = short(substitute(new_value(draft, blow, slip), draft.context.scalars))
    draft.add(
        f"friction.{element.name}",
        "substitution",
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


def _speeds(draft: Draft, blow: Blow, steps: list[Step]) -> None:
    """The speeds just after."""
    values = {after_name(draft, name): blow.began.speeds[name] for name in blow.after.independent}
    _solved(draft, "speeds", values, steps)


def _impulses(draft: Draft, blow: Blow, steps: list[Step], level: int) -> None:
    """The impulses that the equations hold and that are not zero."""
    found = {impulse_name(draft, name, blow): value for name, value in blow.began.impulses.items()}
    scope = Meanings({n: v for n, v in draft.context.scalars.items() if n not in found})
    rows = [row for step in steps for row in _equations(step.statement, scope)]
    values = {n: v for n, v in found.items() if v and any(depends_on(row, n) for row in rows)}
    _solved(draft, "impulses", values, steps, level=level, obligations=draft.asked(_demands(blow)))


def _solved(
    draft: Draft,
    kind: str,
    values: Mapping[str, Scalar],
    steps: list[Step],
    level: int = STANDARD,
    obligations: tuple[t.Chain, ...] = (),
) -> None:
    if not values:
        return
    draft.add(
        f"after.{kind}",
        "solution",
        t.system([t.equation(t.Sym(name), draft.show(value, factor=True)) for name, value in values.items()]),
        f"phases.after.{kind}",
        premises=draft.those(*(step.id for step in steps), TIED, "after.speeds"),
        sources=[StepRef(step.id) for step in steps],
        count=len(values),
        level=level,
        is_result=level <= STANDARD,
        obligations=obligations,
    )


def _equations(statement: t.Node, scope: Meanings) -> list[Scalar]:
    """Left minus right of each row, with the letters of what is unknown."""
    rows = t.rows(statement)
    return [scalar(row.items[0], scope) - scalar(row.items[-1], scope) for row in rows]


def _lost(draft: Draft, blow: Blow) -> None:
    """The kinetic energy before less that after."""
    value, before = blow.began.energy_lost, kinetic(draft, blow.state.places, blow.state.speeds)
    taken = draft.study.letters.forces | blow.began.impulses.keys()  # an impulse may be called K
    first = draft.define(draft.free("K", taken=taken), before)
    after = new_value(draft, blow, sum(kinetic_energy(blow.after), NOTHING))
    second = draft.define(draft.free("K_prime", taken=taken), after)
    states = ((blow.before, blow.state.places, blow.state.speeds), (blow.after, blow.state.places, blow.began.speeds))
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


def hand_overs(problem: Problem) -> list[tuple[Phase, Stage, Draft]]:
    """Each later phase that is known, its mechanics, and the draft of the steps from the end of the one before to its start."""
    found, _ = known_stages(problem)
    rows = zip(problem.phases, found, found[1:], strict=False)
    return [(phase, stage, hand_over(k, phase, before, stage)) for k, (phase, before, stage) in enumerate(rows, 1)]


def hand_over(number: int, phase: Phase, before: Stage, stage: Stage) -> Draft:
    """The draft of the steps from the end of the phase of that number (from 1) to the start of the next one."""
    draft, began = Draft(before.study), stage.began
    assert began is not None, phase.name
    draft.chapter = "phase"
    endings.write(draft, Ending(phase, number, began.before))
    if began.is_blow and began.phase is not None:
        write(draft, Blow(before.study.system, stage.study.system, began.phase, began, number))
    return draft
