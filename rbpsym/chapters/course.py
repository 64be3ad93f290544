"""The motion as a function of the time, where the acceleration of a coordinate has a form that can be integrated."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, is_zero, substitute, symbol
from rbpsym.frozen import replace
from rbpsym.mechanics import solutions, solved
from rbpsym.mechanics.arrivals import ArrivalState
from rbpsym.mechanics.demands import settle
from rbpsym.mechanics.orbit import swing_of
from rbpsym.mechanics.sides import lasting
from rbpsym.mechanics.solutions import STEADY, Given, InTime
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Step

TOLD = ("amplitude", "terminal speed", "total way")
DRIVEN = {"phase lag": ("", ".force"), **dict.fromkeys(("amplitude", "greatest speed"), (".free", ".driven"))}


def write(draft: Draft) -> None:
    """The chapter: oscillations that are exactly linear, and motions with resistance, from their start."""
    draft.chapter = "course"
    for name in draft.study.system.independent:
        known = solutions.given(draft.study, name)
        if known is None or not (known.form.stiffness or known.form.damping or known.form.drag or known.form.law):
            continue
        asked = lasting(draft.study.sides, draft.study.friction_needs, draft.study.assumptions)
        for one in solutions.courses(known) if not known.form.drive else (solutions.driven(known),):
            told(draft, name, replace(one, valid=(*one.valid, *asked)))
        for key in TOLD if known.speed or known.form.drive or known.form.drag else ():
            feature(draft, known, name, key)


def told(draft: Draft, name: str, one: InTime, law: str = "", beside: Mapping[str, InTime] | None = None) -> str:
    """The id of the step that says a solution, with those `beside` it that the law ties to it; before it one for each of its
    letters that is new."""
    letters = {letter: _letter(draft, letter, value) for letter, value in one.letters.items()}
    said = {step.id for step in draft.steps for letter in letters.values() if _tells(step, letter)}
    place = substitute(one.place, {old: symbol(new) for old, new in letters.items()})
    relation = t.relation(t.Sym(name), "~" if law else "=", draft.show(place, met=one.valid or None))
    where = None if one.where is None else t.equation(t.Sym(one.where[0]), draft.show(one.where[1]))
    kind = "left" if one.is_left else one.case or ("small" if law else "plain")
    return draft.add(
        f"course.{name}" + (f".{one.case}" if one.case else ""), "course", relation, f"course.{kind}",
        premises=draft.those(f"motion.{name}", law, *said), is_result=True, obligations=draft.asked(one.valid), name=t.Sym(name),
        where=where, data={"name": name, "law": law, "steady": one.case == STEADY,
                          "beside": {n: each.whole for n, each in (beside or {}).items()}},
    ).id  # fmt: skip


def _tells(step: Step, letter: str) -> bool:
    """Whether the step says what a letter, or its square, is."""
    return any(t.Sym(letter) in (left, getattr(left, "base", None)) for left, _, _ in t.relations(step.statement))


def _letter(draft: Draft, letter: str, value: Scalar) -> str:
    """The letter for a value: the one that it has already, or a new one."""
    known = next((n for n, v in draft.context.scalars.items() if n.startswith(letter) and is_zero(v - value)), None)
    shown = draft.show(value, factor=True)
    if known is None and isinstance(shown, t.Sym):
        known = shown.name
    if known is not None:
        return known
    taken = draft.context.scalars.keys()
    found = letter if letter not in taken else draft.free(f"{letter}_s", taken=taken)
    draft.define(found, value)
    draft.add(f"letter.{found}", "identity", t.equation(t.Sym(found), shown), "course.letter", letter=t.Sym(found))  # fmt: skip
    return found


def reached(draft: Draft, subject: str, value: Scalar, time: Scalar, state: ArrivalState, letters: Mapping[str, Scalar]) -> str:
    """The id of the step that says when a coordinate or a speed has a value; the time is said in letters."""
    named = {letter: symbol(_letter(draft, letter, value)) for letter, value in letters.items()}
    assert state.time is not None, subject
    made = draft.define(draft.free("t_1"), state.time)
    return draft.add("moment", "reached_in_time", t.equation(made, draft.show(substitute(time, named), factor=True)),
                     "course.reached", premises=[step.id for step in draft.steps if step.rule == "course"], name=t.Sym(subject),
                     value=draft.show(value), letter=made, is_result=True, obligations=draft.asked(state.valid),
                     data={"subject": subject, "value": value}).id  # fmt: skip


def by_speed(draft: Draft, subject: str, value: Scalar, state: ArrivalState) -> str:
    """The id of the step that says when, and where, a coordinate has a speed of which its acceleration is a function."""
    name, letter = subject.removesuffix("_dot"), draft.study.letters.free("u")
    known = solutions.given(draft.study, name)
    found = known and solved.by_speed(known, letter)
    assert found, subject
    told = [(old, new) for old, new in (("t", state.time), (name, state.places[name])) if new is not None]
    rows = [t.equation(draft.define(draft.free(f"{old}_1"), new), draft.show(new, factor=True)) for old, new in told]
    return draft.add("moment", "by_speed", t.Relations(tuple(rows)) if len(rows) > 1 else rows[0], "course.by_speed",
                     premises=draft.those(f"motion.{name}"), name=t.Sym(name), speed=t.Sym(subject), value=draft.show(value),
                     obligations=draft.asked(state.valid), is_result=True,
                     data={"name": name, "value": value, "letter": letter, "time": found[1], "place": found[2]}).id  # fmt: skip


def feature(draft: Draft, known: Given, name: str, key: str, law: str = "") -> None:
    """A step for what is asked of the solution, by the linear law if one is named, if it has that."""
    letter, value = solved.FEATURES[key][0], solved.feature(known, key)
    valid = settle((*known.valid, *solved.swings(known, key)), known.study.assumptions)
    if value is None or valid is None:
        return
    cause = solved.support(known) if key == "phase lag" else None
    more: dict[str, Any] = {} if cause is None else {"cause": draft.show(cause)}
    kind = ".support" if more else DRIVEN.get(key, ("", ""))[bool(known.form.drive)]
    is_one = len(draft.study.system.independent) == 1
    made = draft.define(draft.free(letter if is_one else f"{letter}_{name}", taken=draft.context.scalars.keys()), value)
    shown = _quotient(draft, known) if key == "amplitude" and known.form.drive else draft.show(value, factor=True)
    phrase = "mode" if key in solved.OF_MODE else f"{key.replace(' ', '_')}{kind}"
    data = {"name": name, "law": law, "key": key, "form": known.form, "steady": solutions.steady(known)}
    draft.add(f"{key.replace(' ', '_')}.{name}", "feature", t.equation(made, shown), f"course.{phrase}",
              premises=draft.those(law or f"motion.{name}"), name=t.Sym(name), letter=made, is_result=True, data=data,
              obligations=draft.asked(valid), **more)  # fmt: skip


def _quotient(draft: Draft, known: Given) -> t.Node:
    """The amplitude of what is driven over the root of two squares, which tell of resonance."""
    swing, gap, drag = solved.resonance(known)
    squares = t.add(t.Pow(t.Group(draft.show(gap)), t.TWO), *([t.Pow(t.Group(draft.show(drag)), t.TWO)] if drag else []))
    return t.div(draft.show(swing, factor=True), t.Sqrt(squares))


def swing(draft: Draft, name: str, quarters: int) -> str:
    """The id of the step that says what so many quarters of the period of a swing of any size take, after its speed."""
    known, square = swing_of(draft.study, name), draft.study.squares[name]
    draft.chapter = "course"
    stated = t.equation(t.Pow(t.Sym(f"{name}_dot"), t.TWO), draft.show(square, factor=True))
    draft.add(f"square.{name}", "first_integral", stated, "ask.speed", premises=draft.those(f"motion.{name}"),
              data={"name": name, "value": square})  # fmt: skip
    value = known.time(draft.study, quarters)
    made = draft.define(draft.free("T"), value)
    told, place = t.equation(made, draft.show(value, factor=True)), t.equation(t.Sym(name), draft.show(known.rest))
    data = {"name": name, "quarters": quarters, "part": known.part, "height": known.height}
    kind = "swing" if known.height is None else "isochrone"
    return draft.add(f"swing.{name}", "swing", told, f"course.{kind}.{SWINGS[quarters]}", premises=draft.those(f"square.{name}"),
                     name=t.Sym(name), letter=made, is_result=True, rest=draft.show(known.rest), place=place, data=data,
                     obligations=draft.asked(known.valid)).id  # fmt: skip


SWINGS = {1: "quarter", 2: "half", 4: "whole"}


def speed(draft: Draft, name: str, value: Scalar) -> str:
    """The id of the step that says this speed as a function of the place."""
    known = solutions.given(draft.study, name)
    assert known is not None, name
    return draft.add(f"speed_at.{name}", "speed_along", t.equation(t.Sym(f"{name}_dot"), draft.show(value)), "course.speed",
                     premises=draft.those(f"motion.{name}"), name=t.Sym(name), is_result=True,
                     obligations=draft.asked(solved.sets_out(known)),
                     data={"name": name, "way": known.sense(known.speed or known.form.constant)}).id  # fmt: skip
