"""The steps from which an answer follows, each certified by the rules of derivations."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

from rbpsym.ask import in_time, led_by
from rbpsym.ask.asked import Asked, Moment
from rbpsym.ask.finding import before, needed, resting_on
from rbpsym.ask.found import Answer, Found
from rbpsym.ask.lasting import asks
from rbpsym.ask.question import Question, is_jump
from rbpsym.chapters import contact, course, endings, instant, momentum, oscillations
from rbpsym.chapters.impulses import hand_over
from rbpsym.decide.rooted import neat, rationalised
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import all_of, undecided
from rbpsym.errors import RbpsymError, StatementError, there
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import NOTHING, PI, UNITY, Scalar, function, is_zero, names_in, substitute, symbol
from rbpsym.mechanics import solutions
from rbpsym.mechanics.arrivals import value_in
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.elimination import determinant
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.orbit import orbits
from rbpsym.mechanics.solved import OF_MODE
from rbpsym.mechanics.stability import essential
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.checks.values import TURNED, told_as
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Derivation, Step
from rbpsym.typeset.machine import to_machine
from rbpsym.typeset.text import to_text

LETTER = "Q"
ANSWER = "ask.answer"
COMES = undecided("whether the motion comes so far is not decided: the speed may vanish before, at a place that was not found")
LONGEST_NAME = 6  # nodes of what a step gives a value: ϑ², f/(N + C), K_0 - K_1
TOLD = (
    "solution", "first_integral", "work_done", "event_time", "event_place", "end_state",
    "course", "speed_along", "kept_speed", "followed", "reached_in_time", "by_speed",
    "parallel_axis", "mass_integral", "mass_center",
)  # fmt: skip


def certified(
    asked: Asked, question: Question, found: Found, letter: str = LETTER, *, is_ground: bool = False, apart: Container[str] = ()
) -> Answer:
    """The answer, which is given the letter (its own one, where that is none of those that it has to be kept `apart` from),
    with its steps and its verdict; the ground of another answer (`is_ground`) is a formula, and does not say how far the
    motion lasts."""
    place = found.moment.place if found.moment else asked.place(found.study)
    begun, earlier, each = before(asked, place, found)
    for k, part in enumerate(found.since):
        first = certified(asked, question, part, f"{letter}_{k}")
        parts = (replace(step, phrase="ask.part") if step.phrase == ANSWER else step for step in first.steps)
        earlier += tuple(replace(step, id=f"since.{k}.{step.id}") for step in parts if step not in earlier)
        each += first.derivations
    draft = _told_by(asked, found) if found.told else Draft(found.study)
    if found.about is not None:
        led_by.spread(draft, found, *found.about)
    draft.chapter = "ask"
    led_by.write(draft, found)
    if found.moment is not None and found.moment.phase is not None and led_by.arrives(found.moment):
        endings.write(draft, endings.Ending(found.moment.phase, place + 1, found.moment.state))
    is_free = bool(found.study.system.independent)  # else all is a function of the time as it is stated
    if found.moment is not None and (found.moment.courses or (found.moment.watched and is_free)):
        in_time.write(draft, found.moment)
        draft.chapter = "ask"
    lasts, open_ = ((), ()) if is_ground else asks(asked, found)
    last, values = _last(draft, found, letter, lasts, apart), found.values
    if question.is_direction:
        last, values = _direction(draft, question, found)
    asking = [step.id for step in draft.steps if step.obligations] if found.told.startswith("phase ") else ()
    own = needed(draft.steps, last.id, *asking)
    each.append(Derivation(draft.study, own, letters=draft.context))
    steps = tuple(resting_on(begun, step) for step in own)
    held = tuple(step.slots["where"] for step in steps if step.slots.get("where"))
    comes = [COMES] if found.moment is not None and found.moment.is_open else []
    comes += map(undecided, open_)
    verdict = all_of([*comes, *(step.certificate.verdict for step in (*earlier, *steps))])
    nodes = _last_sides(last.statement)
    valid = _valid(draft, found, lasts, earlier, steps)
    is_later = place > asked.lasting and not (found.moment or question.phase or is_jump(question.quantity))
    says = f"in the phase “{asked.names[place]}”, the first in which it is known" if is_later else ""
    says = _behind(draft, last) if found.told.endswith("phase lag") else says
    says = OTHERS if "equilibri" in question.quantity and found.told == "oscillations" and not found.study.rest.complete else says
    asked_ = tuple(dict.fromkeys((*held, *valid)))
    return Answer(question, found.study, values, nodes, verdict, found.of, asked_, (*earlier, *steps), says=says,
                  derivations=tuple(each))  # fmt: skip


OTHERS = "others are not excluded"


def _behind(draft: Draft, last: Step) -> str:
    """Behind what a phase lag is."""
    cause = draft.context.steps[last.data["told"][0]].slots.get("cause")
    return f"behind {'the force' if cause is None else to_text(cause, Notation(draft.study.problem.notation))}"


def _last(draft: Draft, found: Found, name: str, lasts: tuple[Demand, ...], apart: Container[str]) -> Step:
    """The step that states the answer."""
    met = (*found.asked, *(found.moment.state.valid if found.moment else ()), *lasts)
    parted = f"{name}_"
    marks = "xy" if not found.told.startswith("osc") else range(1, len(found.values) + 1)
    own = _own_letter(found)
    letters = [own if own and own not in apart else name] if len(found.values) == 1 else [f"{parted}{mark}" for mark in marks]
    letters = [draft.free(letter) for letter in letters]
    shown = [draft.show(value, factor=True, met=met) for value in found.values]
    of = dict(zip(letters, found.named, strict=True))
    rule = "value_told" if found.told else "value_along" if found.moment is None else "value_then"
    speeds = (name.removesuffix("_dot") for name in (*found.speeds, *found.kept))
    data = {"of": of, "works": {n: f"done.{n}" for n in found.works}}
    data |= {"moment": found.moment, "ways": found.ways, "speeds": tuple(speeds), "places": tuple(found.places)}
    said = _said(draft, found)
    data |= {"constant": found.constant, **said}
    for letter, value in of.items():
        draft.define(letter, value)
    lefts: list[t.Node] = [t.Sym(letter) for letter in letters]
    if found.study.at_start:
        rule, lefts = "solution", [instant.at_start(draft.show(value)) for value in found.named]
    if said.get("turned") == ("itself",) and said["told"][0]:
        sides = [row[-1] for row in t.relations(draft.context.steps[said["told"][0]].statement)]
        told = next((node for node in sides if _is_same(draft, draft.context.value(node), found.values[0])), None)
        if told is not None and not _letters(told, found.values[0]):
            lefts, shown = [t.Sym(letters[0])], [told]
    for k, (id, turned) in enumerate(zip(said.get("told", ()), said.get("turned", ()), strict=True)):
        if id and turned == "its square":
            shown[k] = _root_of_sum(draft, draft.context.steps[id], found.values[k]) or shown[k]
    rows = tuple(map(t.equation, lefts, shown))
    statement = rows[0] if len(rows) == 1 else t.Relations(rows)
    ids = [step.id for step in draft.steps if step.rule in TOLD]
    if found.study.at_start:
        held = {name for value in found.named for name in names_in(value)}
        ids = [id for id in ids if draft.context.steps[id].slots["quantity"].name in held]
    named = draft.those(*(filter(None, said["told"]) if found.told else ids), "law.motion")
    step = draft.add("answer", rule, statement, ANSWER, premises=named, is_result=True, data=data,
                     obligations=draft.asked(found.asked), letters=[t.Sym(letter) for letter in letters])  # fmt: skip
    made = draft.context.steps
    if not made.keys().isdisjoint(step.premises):  # what it follows from is its road, and what says it already
        cited = (made[id] for id in step.cites if id in made)
        laws = {f"reaction.{name}" for value in found.named for name in names_in(value)}  # of the force that is asked for
        saying = (one.id for one in cited if one.id in laws or not {*_last_sides(one.statement)}.isdisjoint(shown))
        step = draft.steps[-1] = replace(step, cites=tuple(saying))
    return step


def _root_of_sum(draft: Draft, step: Step, value: Scalar) -> t.Node | None:
    """√(k/m + g/ℓ) of what a step tells as the square k/m + g/ℓ; None for other squares."""
    sums = (right for _, op, right in t.relations(step.statement) if op == "=" and isinstance(right, t.Add))
    told = next((node for node in sums if _is_same(draft, draft.context.value(node), value * value)), None)
    return None if told is None or _letters(told, value) else t.Sqrt(told)


def _is_same(draft: Draft, *values: Scalar) -> bool:
    """Whether two values are one in their shortest forms."""
    first, second = (rationalised(neat(value, draft.study.assumptions)) for value in values)
    return is_zero(first - second)


def _own_letter(found: Found) -> str:
    """At a moment a quantity that has a name keeps it: N_0 at the start, N_1 later, v_1; "" for others."""
    names = names_in(found.named[0])
    if found.moment is None or found.study.at_start or found.told or len(names) != 1 or found.named[0] != symbol(*names):
        return ""
    [own] = names
    number = 0 if found.moment.how == "start" else 1
    base, dot, rate = own.rpartition("_")
    if alias := found.study.problem.notation.get(own):
        return f"{alias}_{number}"
    return f"{base}_{number}_{rate}" if dot and rate in ("dot", "ddot") else f"{own}_{number}"


def _direction(draft: Draft, question: Question, found: Found) -> tuple[Step, tuple[Scalar]]:
    """The angle of a vector from +x, counter-clockwise, and the step that says it. Raises StatementError for what is none."""
    if len(found.values) != 2:
        raise StatementError(f"“{question.quantity}” is no vector", instead="name a force, a velocity, an acceleration.")
    x, y = found.values
    kind = sign(x, draft.study.assumptions).kind
    if kind == "zero":
        side = sign(y, draft.study.assumptions).kind
        if side not in ("positive", "negative"):
            raise StatementError(f"which way “{question.quantity}” points is not decided", instead="ask for it itself.")
        angle, asked = PI / 2 * (1 if side == "positive" else -1), list[Demand]()
    else:
        way = sign(x, draft.study.assumptions).sense or (1 if number(x, sample(draft.study.problem)) > 0 else -1)
        angle, asked = function("atan", y / x) + (NOTHING if way > 0 else PI), [Demand(x * way)]
    letter = draft.define(draft.free("varphi"), angle)
    step = draft.add("direction", "direction", t.equation(letter, draft.show(angle)), ANSWER, premises=["answer"],
                     is_result=True, data={"of": "answer"}, obligations=draft.asked(asked))  # fmt: skip
    return step, (angle,)


def _told_by(asked: Asked, found: Found) -> Draft:
    """The draft of the chapter that says what is asked for."""
    kind, _, place = found.told.partition(" ")
    if kind == "phase":
        k = int(place)
        return hand_over(k, asked.problem.phases[k - 1], asked.stage(k - 1), asked.stage(k))
    draft = Draft(found.study)
    if kind == "orbit":
        name, _, number_ = place.partition(" ")
        momentum.steady_motion(draft, name, orbits(found.study, name)[int(number_)])
    elif kind == "swing":
        name, _, quarters = place.partition(" ")
        course.swing(draft, name, int(quarters))
    elif kind == "course":
        name, _, key = place.partition(" ")
        key, small = key.removesuffix(f" {solutions.SMALL}"), key.endswith(f" {solutions.SMALL}")
        law = oscillations.laws(draft)[name] if small else ""
        draft.chapter = "ask"
        led_by.laws(draft, {f"{name}_ddot"})
        draft.chapter = kind
        known = solutions.given(found.study, name, small=small)
        if known is None:
            known = solutions.Given(there(solutions.form_along(found.study, name)), NOTHING, NOTHING, found.study, name)
        course.feature(draft, known, name, key, law)
    else:
        CHAPTERS[kind](draft)
    return draft


CHAPTERS: Mapping[str, Callable[[Draft], None]] = {
    "oscillations": partial(oscillations.write, where_stable=True),
    "contact": contact.write,
}


def _said(draft: Draft, found: Found) -> dict[str, tuple[str, ...]]:
    """The steps that say what is asked for, and how that is made of them."""
    if not found.told:
        return {}
    if found.told.startswith("swing") or (found.told.startswith("course") and not found.told.endswith(OF_MODE)):
        return {"told": (draft.steps[-1].id,), "turned": ("itself",)}
    said = [_said_of(draft, value) for value in found.values]
    return {"told": tuple(id for id, _ in said), "turned": tuple(turned for _, turned in said)}


def _said_of(draft: Draft, asked: Scalar) -> tuple[str, str]:
    """The step that says a value, and how that is made of it."""
    known = draft.study.assumptions
    for turned, turn in TURNED.items():
        value = rationalised(neat(turn(asked) if asked else asked, known))
        saying = []
        for step in draft.steps:
            for left, op, right in t.relations(step.statement):
                is_name = op == "=" and len(list(t.walk(left))) <= LONGEST_NAME and not draft.context.grows(right)
                said = draft.context.value(right) if is_name else None
                if isinstance(said, Scalar) and is_zero(rationalised(neat(told_as(said, turned), known)) - value):
                    saying.append((len(_letters(right, value)), step.id))
        if saying:
            return min(saying, key=lambda pair: pair[0])[1], turned
    return "", "itself"


def _letters(node: t.Node, value: Scalar) -> set[str]:
    """The letters of what is said that stand for a part of the value and are not in it."""
    return {part.name for part in t.walk(node) if isinstance(part, t.Sym)} - names_in(value)


def _last_sides(statement: t.Node) -> tuple[t.Node, ...]:
    rows = statement.rows if isinstance(statement, t.Relations) else (statement,)
    return tuple(row.items[-1] for row in rows if isinstance(row, t.Chain))


def _valid(
    draft: Draft, found: Found, lasts: tuple[Demand, ...], before: tuple[Step, ...], steps: tuple[Step, ...]
) -> tuple[t.Node, ...]:
    """The conditions under which it holds: what the steps, and those `before` its phase, ask for, and the motion that is
    stated, which `lasts` so far."""
    moment, parts = found.moment, (before, [s for s in steps if s.rule != "solution"], [s for s in steps if s.rule == "solution"])
    duties = [duty for part in parts for duty in _duties(part)]
    first, asked, solved = (_asked(draft, _duties(part)) for part in parts)
    if moment is not None and moment.how in ("start", "event", "rest"):
        with suppress(ZeroDivisionError):  # the laws are asked for their solution there only
            solved = [_there(found.study, one, moment) for one in solved]
            asked = [_there(found.study, one, moment) for one in asked] if moment.how != "event" else asked
    asked = [*asked, *solved]
    if found.told == "oscillations" or (moment is not None and moment.is_small):  # only close to the place of rest
        rest: dict[str, Scalar] = next((step.data["at"] for step in reversed(steps) if "at" in step.data), {})
        image = dict.fromkeys(found.study.system.speeds, NOTHING) | rest
        asked = [Demand(substitute(one.value, image), one.op) for one in asked]
    asked = [*first, *asked]
    if moment is not None and moment.state.time is not None and (moment.watched or (moment.courses and moment.how == "time")):
        at, given = {"t": moment.state.time}, found.study.assumptions
        asked = [Demand(neat(substitute(one.value, at), given), one.op) for one in asked]
    timed = [one.moment.state.time for one in found.since if one.moment and one.moment.courses]
    if len(timed) == 1 and timed[0] is not None:  # what a solution asks up to the end of the phase before
        asked = [Demand(neat(substitute(one.value, {"t": timed[0]}), found.study.assumptions), one.op) for one in asked]
    stated = (*(moment.state.valid if moment else ()), *lasts)
    wanted = (*stated, *asked)
    never = next((one for one in wanted if settle([one], found.study.assumptions) is None), None)
    if never is not None:
        what = to_machine(present(never.value))
        raise StatementError(f"this motion never comes about: it needs {what} {never.op} 0", instead="change the statement.")
    left = settle(wanted, found.study.assumptions) if len(asked) == len(duties) else None
    if left is None:
        return tuple(dict.fromkeys((*duties, *draft.asked(stated))))
    return draft.asked(_told_by_forces(left, found.study))


def _there(study: Study, demand: Demand, moment: Moment) -> Demand:
    """A demand at that moment. What the way of solving divides by may vanish there alone: the value is that of its
    neighbours, to which it is bound where the mass matrix is regular."""
    then = Demand(value_in(study, demand.value, moment.state), demand.op)
    if demand.op != "!=" or study.at_start or not is_zero(then.value):
        return then
    inertia = tuple(tuple(value_in(study, entry, moment.state) for entry in row) for row in study.dynamics.mass_matrix)
    return then if is_zero(determinant(inertia)) else Demand(UNITY)


def _told_by_forces(demands: tuple[Demand, ...], study: Study) -> list[Demand]:
    """Without what is said of an unknown force already: N > 0 says that 11 cos θ - 6 is not zero."""
    along = (not study.at_start and study.reactions_along_motion) or {}
    said = {d: essential(substitute(d.value, along), study.assumptions) for d in demands if names_in(d.value) & along.keys()}
    firm = [value for demand, value in said.items() if demand.op == ">"]
    return [d for d in demands if d in said or (d.value not in firm and not (d.op == "!=" and -d.value in firm))]


def _duties(steps: Sequence[Step]) -> list[t.Node]:
    told = (step.certificate.verdict.open_obligations for step in steps)
    return [duty.relation for open_ in told for duty in open_]


def _asked(draft: Draft, duties: Sequence[t.Node]) -> list[Demand]:
    rows = (row for duty in duties for row in t.relations(duty))
    return [Demand(value, op) for left, op, _ in rows if (value := _valued(draft, left)) is not None]


def _valued(draft: Draft, node: t.Node) -> Scalar | None:
    """The value of one side of a condition; None where a letter of another phase stands in it."""
    try:
        found: Scalar = draft.context.value(node)
        return found
    except RbpsymError:
        return None
