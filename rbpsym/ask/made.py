"""Quantities that are made of others: ratios, multiples, and what vibrations are described by."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress

from rbpsym.ask.finding import Finding
from rbpsym.ask.question import is_jump, read_question
from rbpsym.ask.seen import PLACE, AskedPhase, moving, never_told, parts_seen, seen
from rbpsym.decide.rooted import neat
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import Meanings, Scalar, short
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.demands import existence, possible
from rbpsym.quantity.vectors import swinging

WHEN = re.compile(r" (?:where|when|at|until|up to|during|in phase|(?:just|right) (?:after|before|when|where)|from|begins)\b")


def _times(world: AskedPhase, factor: str, text: str) -> t.Node:
    return t.mul(read_infix(factor, world.names), form_of(world, text))


def _ratio(world: AskedPhase, text: str) -> t.Node:
    """The quotient of two quantities, “A to B”, cut at the last “to” that leaves two."""
    used, words, refused = len(world.used), text.split(" to "), None
    for cut in range(len(words) - 1, 0, -1):
        try:
            return _quotient(world, " to ".join(words[:cut]), " to ".join(words[cut:]))
        except RbpsymError as error:
            refused = refused or error
            del world.used[used:]
    raise refused or StatementError("a ratio has two parts", instead="write “ratio of QUANTITY to QUANTITY”.")


def _quotient(world: AskedPhase, above: str, below: str) -> t.Node:
    place = PLACE.fullmatch(below)
    is_placed = WHEN.search(above) or is_jump(read_question(above).quantity)
    above = above if place is None or is_placed else above + place[2]  # “ratio of A to B where …” is of both
    if above == below:
        raise StatementError("both parts of this ratio are the same, with the same values", instead="ask for each of them alone.")
    found = t.Div(*(form_of(world, text, of_vectors=True) for text in (above, below)))
    used = len(world.used)
    if not WHEN.search(below) and moving(world, (_valued(world, found, above),)):  # what only the time ties
        with suppress(RbpsymError):
            timed = t.Div(*(form_of(world, f"{text} as a function of t") for text in (above, below)))
            if not moving(world, (_valued(world, timed, above),)):
                return timed
        del world.used[used:]
    return found


def _pendulum(world: AskedPhase, name: str | None) -> t.Node:
    """The length g/ϑ² of the simple pendulum with the same period."""
    [gravity, *more] = {element["g"] for element in world.study.problem.interactions if element.kind == "gravity"} or (None,)
    if gravity is None or more:
        raise StatementError("a simple pendulum of equal period needs one acceleration of gravity")
    return t.Div(gravity, t.Pow(_leaf(world, f"frequency of {name or swinging(world)[0]}"), t.TWO))


def _magnitude(world: AskedPhase, force: str, when: str) -> t.Node:
    if len(parts_seen(world.afresh(), f"impulse of {force}{when}")) == 1:
        return t.Abs(_leaf(world, f"impulse of {force}{when}"))
    return t.Sqrt(t.add(*(t.Pow(_leaf(world, f"impulse of {force}_{axis}{when}"), t.TWO) for axis in "xy")))


_DURING = r" (?:until|up to|from) .+"
GATHERED = {"velocity": "displacement of", "angular velocity": "angle turned by", "power": "work of", "force": "impulse of"}
TURN = t.mul(t.TWO, t.Sym("pi"))
MADE: tuple[tuple[str, Callable[..., t.Node]], ...] = (
    (r"damped period of (\w+)", lambda world, name: t.Div(TURN, _leaf(world, f"damped frequency of {name}"))),
    (r"damping ratio of (\w+)", lambda world, name: _quotient(world, f"decay rate of {name}", f"undamped frequency of {name}")),
    (r"logarithmic decrement of (\w+)",
     lambda world, name: t.mul(TURN, _quotient(world, f"decay rate of {name}", f"damped frequency of {name}"))),
    (r"(?:length of (?:simple pendulum with (?:equal|same) period|equivalent simple pendulum)|equivalent length)(?: of (\w+))?",
     _pendulum),
    (r"magnitude of impulse of (\w+)((?: when \w+ begins)?)", _magnitude),
    (rf"(?:average|mean) ({'|'.join(GATHERED)}) (?:of )?([\w-]+)({_DURING})",
     lambda world, rate, name, end: _quotient(world, f"{GATHERED[rate]} {name}{end}", f"time{end}")),
    (r"twice (.+)", lambda world, text: _times(world, "2", text)),
    (r"([\w./^]+?) ?(?:\*|times) ?((?!.* [+-] ).+ .+)", _times),
    (r"ratio of (?!.* mode$)(.+ to .+)", _ratio),
)  # fmt: skip


SIGNS = (("+", t.add), ("-", lambda first, second: t.add(first, t.neg(second)))), (("*", t.mul), ("/", t.Div))
VALUED = re.compile(r"=|\b(?:is|equals|reaches|comes to)\b(?! rest)")


def _may_cut(first: str, second: str, sign_: str) -> bool:
    """Whether a sign stands between two quantities: after the value of a place it belongs to that value, unless another
    moment follows; and a product is a part of a sum."""
    told = list(WHEN.finditer(first))
    in_value = bool(told and VALUED.search(first, told[-1].end())) and not WHEN.search(second)
    return not in_value and (sign_ in "+-" or not any(" - " in part or " + " in part for part in (first, second)))


def form_of(world: AskedPhase, text: str, *, of_vectors: bool = False) -> t.Node:
    """How a quantity is made of others, each of which stands in it under the text of its question; one alone as itself, or
    as its magnitude where it is that `of_vectors`. Raises StatementError or ReadError for what means nothing."""
    used, refused = len(world.used), list[RbpsymError]()
    phrases = (text, f"magnitude of {text}")[: 1 + of_vectors]
    for phrase in phrases:
        try:
            return _leaf(world, phrase)
        except RbpsymError as error:
            refused.append(error)
    for phrase in phrases:
        for pattern, make in MADE:
            if said := re.fullmatch(pattern, phrase):
                return make(world, *said.groups())
    for signs in SIGNS:
        for cut in sorted((k for sign_, _ in signs for k in range(1, len(text)) if text[k] == sign_), reverse=True):
            del world.used[used:]
            if not _may_cut(text[:cut], text[cut + 1 :], text[cut]):
                continue
            with suppress(RbpsymError):
                first, second = (form_of(world, part.strip()) for part in (text[:cut], text[cut + 1 :]))
                made: t.Node = dict(signs)[text[cut]](first, second)
                return made
    raise refused[0]


def _leaf(world: AskedPhase, phrase: str) -> t.Sym:
    seen(world, phrase)
    return t.Sym(world.used[-1][0].text)


def value_of(world: AskedPhase, text: str, *, of_vectors: bool = False) -> Scalar:
    """The value of such a quantity. Raises as `form_of`, and StatementError where something is divided by zero."""
    return _valued(world, form_of(world, text, of_vectors=of_vectors), text)


def _valued(world: AskedPhase, form: t.Node, text: str) -> Scalar:
    said = {question.text: neat(found.values[0], world.motion.assumptions) for question, found in world.used}
    try:
        found = scalar(form, Meanings(said))
    except ZeroDivisionError:
        raise StatementError(f"“{text}” has no value: something is divided by zero") from None
    return found if isinstance(form, t.Sym) else short(found)


def of_mode(world: AskedPhase, first: str, second: str, mode: str) -> Finding:
    """The ratio of two amplitudes in a mode by those to a third one, relative to which the shape of the mode is told.
    Raises StatementError."""
    refused = None
    for name in (name for name in world.study.system.independent if name not in (first, second)):
        try:
            both = [_leaf(world, f"ratio of {each} to {name} {mode}") for each in (first, second)]
            return made(world, f"ratio of {first} to {second} {mode}", t.Div(*both))
        except StatementError as error:
            refused = error
    raise refused or StatementError(f"nothing ties {first} and {second}")


def made(world: AskedPhase, text: str, form: t.Node | None = None) -> Finding:
    """What is found for such a quantity: it is what the others in it are said to be."""
    form = form or form_of(world, text)
    value = neat(_valued(world, form, text), world.motion.assumptions)
    if left := moving(world, (value,)):
        raise StatementError(f"“{text}” still depends on {left[0]}", instead="say where, of each of them.")
    demands = [demand for _, found in world.used for part in found.values for demand in existence(part)]
    demands += [demand for demand in (*world.standing, *world.lasting) if not moving(world, (demand.value,))]  # of its parts
    valid = possible(demands, world.motion.assumptions, never_told(text))
    return Finding(values=(value,), valid=valid, grounds=(("identity", {}),), form=form)
