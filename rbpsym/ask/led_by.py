"""What leads to a value: laws, squares of speeds and what else is used of the motion, each as a step."""

from __future__ import annotations

from collections.abc import Set

from rbpsym.ask.asked import Moment
from rbpsym.ask.found import Found
from rbpsym.chapters import contact, course, instant, moments, momentum
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, names_in, substitute, symbol
from rbpsym.proof.draft import Draft
from rbpsym.quantity.problem import ProblemWorld


def write(draft: Draft, found: Found) -> None:
    """What the laws make of the accelerations and forces that are needed, and the squares of speeds from the start."""
    if draft.study.at_start:
        instant.write(draft)
        return
    study = draft.study
    named, speeds, moment = _named(found), _speeds(found), found.moment
    moved = (*speeds, *found.places, *found.speeds)
    if (moment is not None and (arrives(moment) or moment.courses)) or any("t" in names_in(value) for value in found.values):
        moved = (*moved, *study.system.independent)
    laws(draft, {*(name for value in named for name in names_in(value)), *(f"{name}_ddot" for name in moved)})
    for name in speeds:
        square = t.equation(t.Pow(t.Sym(f"{name}_dot"), t.TWO), draft.show(study.squares[name], factor=True))
        draft.add(f"square.{name}", "first_integral", square, "ask.speed", premises=draft.those(f"motion.{name}"),
                  data={"name": name, "value": study.squares[name]})  # fmt: skip
    met = () if moment is None or moment.state.time is not None else _met(moment)
    contact.along_motion(draft, {name: value for name, value in (study.reactions_along_motion or {}).items() if name in met})
    for name, value in found.speeds.items():
        course.speed(draft, name, value)
    if found.kept:
        momentum.kept_speeds(draft, found.kept)
    for name, place in found.places.items():
        if f"{name}_dot" in study.kept_speeds:
            momentum.kept_speeds(draft, [f"{name}_dot"])
        draft.add(f"place_at.{name}", "followed", t.equation(t.Sym(name), draft.show(place, factor=True)), "course.followed",
                  premises=draft.those(f"speed_at.{name}", *(f"motion.{n}" for n in study.system.independent)), name=t.Sym(name),
                  is_result=True, data={"name": name})  # fmt: skip
    for letter, (power, done) in found.works.items():
        draft.context.works[letter] = power
        draft.add(f"done.{letter}", "work_done", t.equation(t.Sym(letter), draft.show(done, factor=True)), "ask.work",
                  premises=draft.those(*(step.id for step in draft.steps)))  # fmt: skip


def laws(draft: Draft, names: Set[str]) -> None:
    """What the laws make of those of the accelerations and unknown forces that have these names."""
    dynamics = draft.study.dynamics
    known = {**(dynamics.accelerations or {}), **dynamics.reactions}
    facts = [id for id, fact in draft.context.facts.items() if fact.kind == "law" and fact.subject]
    for name in sorted(names & known.keys()):
        kind = f"motion.{name.removesuffix('_ddot')}" if name.endswith("_ddot") else f"reaction.{name}"
        draft.add(kind, "solution", t.equation(t.Sym(name), draft.show(known[name])), "ask.law", premises=facts)


def spread(draft: Draft, found: Found, name: str, about: str | None) -> None:
    """How the mass of the bodies that are named is spread: about the point, or each about its centre of mass."""
    world = ProblemWorld(found.study)
    names = tuple(state.name for state in world.bodies(name))
    if about is not None:
        moments.about(draft, names, about, world.place(about, name))
        return
    for each in names:
        if len(found.values) > 1:
            moments.center(draft, each)
        else:
            moments.about(draft, (each,), moments.CENTER)


def _speeds(found: Found) -> list[str]:
    """The coordinates whose speeds are needed as functions of the place."""
    if found.study.at_start:
        return []
    on_motion = (substitute(found.study.on_motion(value), found.kept) for value in _named(found))
    told = {name for value in on_motion for name in names_in(value)}
    is_there = found.moment is not None and arrives(found.moment) and found.moment.state.time is None  # else by the time
    needed = found.of == "position" or bool(found.works) or is_there
    told |= {f"{name}_dot" for name in _met(found.moment)} if is_there and found.moment else set()  # whose speed may vanish
    return [name for name in found.study.squares if needed and f"{name}_dot" in told]


def _named(found: Found) -> list[Scalar]:
    """What is asked for, the rates of the works in it, and the force of which a value is met."""
    met = map(symbol, _met(found.moment) & found.study.dynamics.reactions.keys() if found.moment else ())
    return [*found.named, *(power for power, _ in found.works.values()), *met]


def _met(moment: Moment) -> Set[str]:
    """What has a value at the end of a way."""
    return {moment.phase.subject} if moment.phase is not None and moment.phase.event != "at once" else set()


def arrives(moment: Moment) -> bool:
    """Is it the end of a way?"""
    return bool(_met(moment))
