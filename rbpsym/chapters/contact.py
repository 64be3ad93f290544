"""Unknown forces as functions of position alone, where a contact is lost, how much friction is needed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rbpsym.decide.signs import sign
from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import LETTERS
from rbpsym.expr import tree as t
from rbpsym.field import UNITY, Scalar, cosine, depends_on, generator, is_zero, short, sine, substitute, symbol
from rbpsym.mechanics.events import Loss
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.pushing import asked, begins
from rbpsym.mechanics.sides import Side
from rbpsym.mechanics.stability import essential
from rbpsym.present.forms import atom_node
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD, PhraseRef, StepRef
from rbpsym.statement.model import Element

LONGEST = 60  # nodes of a formula that is worth showing in standard detail


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "contact"
    along = draft.study.reactions_along_motion
    if along and draft.study.squares:
        along_motion(draft, along)
        for loss in draft.study.losses:
            _loss(draft, loss, along)
    for side in draft.study.sides:
        if side.state != "lost":
            (_holds if side.state == "kept" else _asks)(draft, side)
    for need in draft.study.friction_needs:
        _friction(draft, need)
    for element, what, value in asked(draft.study) if draft.study.dynamics.accelerations else ():
        if what == "gain" and sign(value, draft.study.assumptions).kind != "positive":
            _slides(draft, element, value)


def _slides(draft: Draft, element: Element, value: Scalar) -> None:
    """From rest it slides in the stated sense only where friction lets it."""
    letter = draft.define(draft.free("a_s"), value)
    valid = begins(draft.study)
    draft.add(
        f"slides.{element.name}",
        "identity",
        t.equation(letter, draft.show(value, factor=True)),
        "contact.moves" if element.kind in LETTERS else "contact.slides",
        premises=ground(draft, *draft.study.system.coordinates),
        force=t.Sym(element.name),
        letter=letter,
        obligations=draft.asked(valid),
    )


def _with_tangent(draft: Draft, value: Scalar) -> t.Node:
    """With tan a, where sin a/cos a is all that is there of an angle a."""
    problem = draft.study.problem
    for name in (*(q.name for q in problem.parameters), *(c.name for c in problem.coordinates)):
        angle = symbol(name)
        if depends_on(value, name):
            rest = short(value * cosine(angle) / sine(angle))
            if not depends_on(rest, name):
                tangent = t.Fn("tan", t.Sym(name))
                return tangent if is_zero(rest - UNITY) else t.mul(draft.show(rest, factor=True), tangent)
    return draft.show(value, factor=True)


def along_motion(draft: Draft, along: Mapping[str, Scalar]) -> None:
    """Each unknown force with the speed put in."""
    for name, value in along.items():
        shown = draft.show(value, factor=True)
        constant = not any(depends_on(value, q) for q in (*draft.study.system.coordinates, "t"))
        level = STANDARD if constant or _is_contact(draft, name) or length(shown) <= LONGEST else FULL
        draft.add(
            f"along.{name}",
            "substitution",
            t.equation(t.Sym(name), shown),
            level=level,
            phrase="contact.along",
            premises=draft.those(f"reaction.{name}", *(f"square.{n}" for n in draft.study.squares)),
            force=t.Sym(name),
            sources=[StepRef(f"square.{n}") for n in draft.study.squares if draft.has(f"square.{n}")],
            reaction=StepRef(f"reaction.{name}"),
            is_result=_is_contact(draft, name),
        )


def _holds(draft: Draft, side: Side) -> None:
    """A force that is nowhere negative: the contact lasts, if need be up to where another is lost."""
    moving = any(depends_on(side.value, q) for q in (*draft.study.system.coordinates, "t"))
    kind = sign(side.value, draft.study.assumptions).kind
    begun = substitute(side.value, draft.study.system.scope.start)
    never = kind in ("nonnegative", "zero") or is_zero(begun)  # let go where it is about to go slack
    lasts = f"holds.{_manner(draft, side.force)}" if draft.study.system.independent else "stays"
    draft.add(
        f"holds.{side.force}",
        "stays",
        t.relation(t.Sym(side.force), ">=" if never else ">", t.ZERO),
        f"contact.{'until' if side.until else 'never' if never else lasts}",
        level=STANDARD if moving else FULL,
        premises=_told(draft, side.force, *([f"loss.{side.until}"] if side.until else ())),
        force=t.Sym(side.force),
        lost=t.Sym(side.until),
        data={"until": side.until},
    )


def _asks(draft: Draft, side: Side) -> None:
    """A force that is not negative under a condition only: on the parameters, or on the state."""
    is_short = length(draft.show(side.value, factor=True)) <= LONGEST
    shown = draft.show(essential(side.value, draft.study.assumptions), factor=True) if is_short else t.Sym(side.force)
    places = [bool(loss.at) for loss in draft.study.ended.open_ if loss.force == side.force]
    told = "asks" if side.state == "asked" else "open.place" if all(places) else "open.form"
    draft.add(
        f"asks.{side.force}",
        "asked",
        t.upright(t.relation(shown, ">=", t.ZERO)),
        f"contact.{told}",
        premises=_told(draft, side.force),
        is_result=True,
        lasts=_lasts(draft, side.force),
        data={"force": side.force},
    )


def _told(draft: Draft, name: str, *more: str) -> tuple[str, ...]:
    """Where the force was found: along the motion, or in each state of motion."""
    return draft.those(f"along.{name}", f"reaction.{name}", *more)


def _lasts(draft: Draft, name: str) -> PhraseRef:
    return PhraseRef(f"contact.lasts.{_manner(draft, name)}", {"force": t.Sym(name)})


def _manner(draft: Draft, name: str) -> str:
    """A string that pulls, or a contact that pushes."""
    is_tension = CONSTRAINTS[draft.study.system.element(name).kind].holds == "tension"
    return "string" if is_tension else "contact"


def _friction(draft: Draft, need: FrictionNeed) -> None:
    """How large the coefficient of static friction must be."""
    force, normal = t.Sym(need.friction), t.add(*map(t.Sym, need.normals))
    slots: dict[str, Any] = {"friction": force, "force": normal, "limit": draft.show(need.limit) if need.limit else t.Sym("mu")}
    forces = (need.friction, *need.normals)
    premises = draft.those(*(f"{kind}.{n}" for n in forces for kind in ("along", "reaction")))
    slots["obligations"] = (t.relation(normal, ">", t.ZERO),)
    if need.needed is None:
        shown = _with_tangent(draft, need.ratio)
        draft.add(
            f"friction.{need.constraint}",
            "substitution",
            t.equation(t.Div(force, normal), shown),
            "contact.endless",
            level=STANDARD if length(shown) <= LONGEST else FULL,
            premises=premises,
            **slots,
        )
        return
    if is_zero(need.needed):
        return
    single = len(draft.study.friction_needs) == 1
    letter = draft.define(draft.free("mu_min" if single else f"mu_min_{need.constraint}"), need.needed)
    size = t.Div(force, normal) if is_zero(need.ratio - need.needed) else t.neg(t.Div(force, normal))
    draft.add(
        f"friction.{need.constraint}",
        "substitution",
        t.equation(letter, size, _with_tangent(draft, need.needed)),
        "contact.needed",
        premises=premises,
        is_result=True,
        letter=letter,
        variant="stated" if need.limit else "open",
        **slots,
    )
    if need.holds:
        draft.add(
            f"enough.{need.constraint}",
            "inequality",
            t.relation(letter, "<=", slots["limit"]),
            "contact.enough",
            premises=[f"friction.{need.constraint}"],
            **slots,
        )


def _is_contact(draft: Draft, name: str) -> bool:
    return any(e.name == name and e.kind == "contact" for e in draft.study.problem.constraints)


def _loss(draft: Draft, loss: Loss, along: Mapping[str, Scalar]) -> None:
    """Where the force vanishes, and what the other forces are there."""
    place = loss.at.get(loss.coordinate)
    equation = _solved(draft, loss)
    draft.add(
        f"loss.{loss.force}",
        "vanishing",
        equation,
        f"contact.lost.{'first' if place is None else 'place'}",
        premises=[f"along.{loss.force}", *ground(draft, loss.coordinate)],
        lasts=_lasts(draft, loss.force),
        is_result=True,
        coordinate=t.Sym(loss.coordinate),
        obligations=draft.asked(loss.valid),
        data={"force": loss.force, "at": dict(loss.at), "factor": loss.factor, "name": loss.coordinate},
    )
    if place is None:
        return
    with_it = [other.force for other in draft.study.losses if other.at == loss.at]  # they are lost together
    if loss.force != with_it[0]:
        return
    for name, value in along.items():
        if name in with_it:
            continue
        there = short(substitute(value, loss.at))
        shown = draft.show(there, factor=True)
        if length(shown) > LONGEST:
            continue
        letter = draft.define(draft.free(f"{name}_end"), there)
        draft.add(
            f"at_loss.{loss.force}.{name}",
            "value_there",
            t.equation(letter, shown),
            "contact.grip" if there and _is_grip(draft, name, loss.force) else "contact.other_force",
            premises=[f"along.{name}", f"loss.{loss.force}"],
            force=t.Sym(name),
            lost=t.Sym(loss.force),
            data={"of": name, "at": dict(loss.at), "place": f"loss.{loss.force}"},
        )


def ground(draft: Draft, *names: str) -> list[str]:
    """The laws, the starts and the ranges of coordinates, on which it rests what may happen along the motion."""
    found = ["law.motion", *(f"start.{n}" for n in names), *(id for id in draft.context.facts if id.startswith("range."))]
    return [id for id in found if id in draft.context.facts]


def _is_grip(draft: Draft, name: str, normal: str) -> bool:
    """Is it the static friction of the very contact that is lost?"""
    element = draft.study.system.element(normal)
    return element.values.get("friction") == name and "limit" in element.values


def _solved(draft: Draft, loss: Loss) -> t.Node:
    """sin q = ... (or cos q, or q itself) from the factor that vanishes, else factor = 0."""
    for index in sorted(loss.factor.num.atoms()):
        if not depends_on(Scalar(generator(index)), loss.coordinate):
            continue
        parts = loss.factor.num.by_power(index)
        if set(parts) == {0, 1} and not any(depends_on(Scalar(p), loss.coordinate) for p in parts.values()):
            return t.equation(atom_node(index, draft.study.style), draft.show(-(Scalar(parts[0]) / Scalar(parts[1]))))
    return t.equation(draft.show(loss.factor, factor=True), t.ZERO)
