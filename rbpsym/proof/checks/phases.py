"""Checks of how a phase of the motion ends and how the next begins.

Moments are put into a motion that is integrated twice from the start; momenta and energies are
summed over the mass itself; points are followed as points fixed in their bodies.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import Condition
from rbpsym.decide.equal import compare, refuted_only_where
from rbpsym.decide.rooted import sign_along
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import PROVED, Verdict, proved, undecided
from rbpsym.elements.events import EVENTS
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ORIGIN, UNITY, Scalar, atoms, depends_on, derivative, names_in, short, substitute, symbol
from rbpsym.field.evaluate import scalar, time_derivative
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.system import System, by_letters, in_state
from rbpsym.proof.checks.constraints import slip_at
from rbpsym.proof.checks.courses import (
    CHECKS,
    at_time,
    closing,
    led_then,
    moved_to,
)
from rbpsym.proof.checks.of_steps import agree, named_sides, premise_says, right_side, right_sides, same, weakest
from rbpsym.proof.checks.places import UNSEEN, demanded, own_place, under, way_to
from rbpsym.proof.context import Context
from rbpsym.proof.mass import angular_momentum, kinetic_energy, primitive, torque
from rbpsym.proof.step import Step
from rbpsym.statement.model import Element

Values = Mapping[str, Scalar]
SENSES = {"positive": 1, "negative": -1, "nonzero": -1}  # 1: surely positive


def slip(context: Context, step: Step) -> Verdict:
    """The stated speed is that of the two material points at the contact (`data`: "element")."""
    found = slip_at(context.study.system, step.data["element"])
    return weakest(same(context, value, found) for value in right_sides(context, step))


def reached_then(context: Context, step: Step) -> Verdict:
    """At the stated time the slip has gone, or the coordinate has its value (`data`: "ending")."""
    return same(context, at_time(right_side(context, step), _left(context, step)), NOTHING)


def first_then(context: Context, step: Step) -> Verdict:
    """The stated time comes after the start, and what vanishes then does not vanish before."""
    context, time = under(context, step, ">"), right_side(context, step)
    with refuted_only_where(Condition(t.ZERO, demand.op, demand.value) for demand in demanded(context, step)):
        ahead = compare(NOTHING, time, context.assumptions)
    left = _left(context, step)
    turned, then = _in_turns(left, time, context.assumptions)
    before = context.assumptions.with_range("t", NOTHING, then)
    kept = any(sign(value, before).is_nonzero for value in (turned, derivative(turned, "t")))
    kept = kept or _has_no_other_root(left, time, context.assumptions)
    if not ahead.is_proved and _is_square(left):  # a + b T + c T² = 0: T is -a over the mean speed b + c T
        gone, (mean, _) = -at_time(NOTHING, left), _mean_and_last(left, time)
        ahead = compare(NOTHING, gone * mean, context.assumptions)
    return weakest([ahead, Verdict(PROVED) if kept else UNSEEN])


def _in_turns(left: Scalar, time: Scalar, given: Assumptions) -> tuple[Scalar, Scalar]:
    """The value as a function of ω t, and what that is at the time, where its only angle runs evenly, with ω > 0; else both as
    they are."""
    angles = [Scalar(atom.arg) for index in left.atoms() if (atom := atoms.atom(index)).kind in ("sin", "cos")]
    rates = {derivative(angle, "t") for angle in angles if depends_on(angle, "t")}
    rate = rates.pop() if len(rates) == 1 else NOTHING
    if depends_on(rate, "t") or sign(rate, given).kind != "positive":
        return left, time
    return substitute(left, {"t": symbol("t") / rate}), short(time * rate)


def _has_no_other_root(left: Scalar, time: Scalar, given: Assumptions) -> bool:
    """Whether a + b t + c t², which vanishes at a time T, does not vanish between 0 and T: c (t + T) + b keeps its sign."""
    if not _is_square(left):
        return False
    mean, last = (sign(value, given) for value in _mean_and_last(left, time))
    ends = {"positive": ("positive", "nonnegative", "zero"), "negative": ("negative", "nonpositive", "zero")}
    pairs = ((mean.kind, last.kind), (last.kind, mean.kind))
    return any(other in ends.get(kind or "", ()) for kind, other in pairs)


def _is_square(left: Scalar) -> bool:
    """Whether it is of the form a + b t + c t²."""
    return not depends_on(derivative(derivative(left, "t"), "t"), "t")


def _mean_and_last(left: Scalar, time: Scalar) -> tuple[Scalar, Scalar]:
    """The mean rate of a + b t + c t² up to a time T, b + c T, and the last one, b + 2 c T."""
    half = derivative(derivative(left, "t"), "t") / 2
    begin = substitute(derivative(left, "t"), {"t": NOTHING})
    return short(half * time + begin), short(half * time * 2 + begin)


def _left(context: Context, step: Step) -> Any:
    """What is left of the slip, or of the way to the value, as a function of the time."""
    phase = step.data["ending"].phase
    return CHECKS[phase.event].then(context, phase)


def reached_there(context: Context, step: Step) -> Verdict:
    """At the stated place the force vanishes, friction is at its limit, or the value is there (`data`: "ending", "name")."""
    gap = CHECKS[step.data["ending"].phase.event].there(context, step.data["ending"].phase)
    return same(context, substitute(gap, {step.data["name"]: right_side(context, step)}), NOTHING)


def first_there(context: Context, step: Step) -> Verdict:
    """Up to the stated place the speed is not zero, and what vanishes there does not vanish before; what gives way there holds
    before."""
    printed, context = demanded(context, step), under(context, step, ">")
    place = right_side(context, step)
    with refuted_only_where(Condition(t.ZERO, demand.op, demand.value) for demand in printed):
        verdicts, between = way_to(context, step.data["name"], place, printed)
        goes = weakest(verdicts)
    if not goes.is_proved:
        return goes
    phase, name = step.data["ending"].phase, step.data["name"]
    gap = CHECKS[phase.event].there(context, phase)
    way = SENSES.get(sign(gap, between).kind or "") or sign_along(gap, name, between)
    is_free = way > 0 if EVENTS[phase.event].gives_way else bool(way)
    return Verdict(PROVED) if is_free else UNSEEN


def state_then(context: Context, step: Step) -> Verdict:
    """Places and speeds at the end, from a motion integrated anew (`data`: "ending", "what", "letters")."""
    ending, letters, stated = step.data["ending"], step.data["letters"], named_sides(context, step)
    if any(letter not in letters for letter, _ in stated):
        return undecided("the step does not say of what it gives the value")
    see, context = _by_what(context, ending), under(context, step, ">")
    return weakest([see(context, ending, step.data["what"], letters[letter], value) for letter, value in stated])


def _by_what(context: Context, ending: Any) -> Callable[..., Verdict]:
    """What checks a state: the tie to the time, a motion that is integrated twice, or the first integral."""
    if context.study.ties and not context.study.system.independent:
        return led_then
    return _uniform if ending.state.time is not None else _placed


def _uniform(context: Context, ending: Any, what: str, name: str, stated: Scalar) -> Verdict:
    place, speed = moved_to(context, own_place(context, name), ending.state.time)
    return same(context, place if what == "place" else speed, stated)


def _placed(context: Context, ending: Any, what: str, name: str, stated: Scalar) -> Verdict:
    """By the first integral: the square of the stated speed is that of the motion at the stated place; by momenta that are
    kept, where they give it."""
    here = {n: v for n, v in ending.state.places.items() if n in context.study.system.independent}
    value = own_place(context, name)
    if f"{name}_dot" in context.study.kept_speeds:
        return _kept(context, ending, what, name, stated)
    if what == "place":
        return same(context, substitute(value, here), stated)
    rate = time_derivative(value, context.study.system.scope)
    if names_in(rate) & context.study.kept_speeds.keys():  # tied to what kept momenta give: each of these, and the tie
        moving = [n for n in context.study.system.independent if depends_on(rate, f"{n}_dot")]
        then = {f"{n}_dot": ending.state.speeds[n] for n in moving}
        each = [_placed(context, ending, what, n, ending.state.speeds[n]) for n in moving]
        return weakest([*each, same(context, substitute(substitute(rate, then), here), stated)])
    return same(context, substitute(context.along(rate * rate), here), stated * stated)


def _kept(context: Context, ending: Any, what: str, name: str, stated: Scalar) -> Verdict:
    """With the speeds of the state each momentum that is kept is what it was. Where all of them are zero, the way is the
    integral of the speed, that of the coordinate which moves being 1."""
    [mover], state, momenta = context.study.squares, ending.state, context.study.kept_momenta.values()
    found = [agree(context, context.rate_of(momentum), NOTHING, "motion") for momentum in momenta]
    then = by_letters(state.speeds)
    if what == "speed":
        gaps = (substitute(substitute(p, then), state.places) - context.start(p) for p in momenta)
        return weakest([*found, *(same(context, gap, NOTHING) for gap in gaps), same(context, then[f"{name}_dot"], stated)])
    one = {f"{mover}_dot": UNITY}
    slopes = {speed: substitute(value, one) for speed, value in context.study.kept_speeds.items()}
    zeros = (value for p in momenta for value in (context.start(p), substitute(p, slopes | one)))
    way, ends = primitive(slopes[f"{name}_dot"], mover), (context.start(symbol(mover)), state.places[mover])
    begin, end = (substitute(way, {mover: place}) for place in ends)
    gone = same(context, stated - context.start(symbol(name)), end - begin)
    return weakest([*found, *(same(context, value, NOTHING) for value in zeros), gone])


def seen_then(context: Context, moment: Any, value: Scalar) -> tuple[Verdict, Scalar]:
    """The value with the places and speeds of a moment, and whether these are those of the motion, or of rest."""
    state, found, image = moment.state, [proved("nothing in it moves")], {}
    for name in names_in(value) & {*state.places, *(f"{n}_dot" for n in state.speeds), "t"}:
        coordinate = name.removesuffix("_dot")
        if name == "t":
            image[name] = state.time
            continue
        what = "place" if name == coordinate else "speed"
        image[name] = (state.places if what == "place" else state.speeds)[coordinate]
        if moment.how == "time" and (said := said_of(context, coordinate)):
            found.append(same(context, at_time(state.time, said if what == "place" else derivative(said, "t")), image[name]))
        elif (step := context.steps.get("moment")) and step.rule == "by_speed":
            stated = named_sides(context, step)[-1][1] if what == "place" else step.data["value"]
            found.append(same(context, stated, image[name]))
        elif moment.how == "rest":
            found.append(_stays(context, state, coordinate))
        else:
            found.append(_by_what(context, moment)(context, moment, what, coordinate, image[name]))
    for id in ("moment", "place"):
        if id in context.steps and (moment.how == "event" or moment.watched):
            context.use(id)
    return weakest(found), substitute(value, image)


def _stays(context: Context, state: Any, name: str) -> Verdict:
    """Whether nothing moves a coordinate at rest there, if that is no place of rest of all."""
    if any(item.at.get(name) == state.places[name] for item in context.study.equilibria):
        return proved("it is a place of rest")
    return same(context, in_state(context.on_motion(symbol(f"{name}_ddot")), state.places, state.speeds), NOTHING)


def said_of(context: Context, coordinate: str) -> Scalar | None:
    """The coordinate as a function of the time, as another step says it."""
    said = [step for step in context.steps.values() if step.rule == "course" and step.data["name"] == coordinate]
    return premise_says(context, said[-1].id) if said else None


def momentum_jump(context: Context, step: Step) -> Verdict:
    """The angular momentum about O, summed over the mass, grows by the torque of the impulses (`data`: "blow", "body")."""
    blow, body = step.data["blow"], step.data["body"]
    places = blow.state.places
    after = in_state(angular_momentum(blow.after, body, ORIGIN), places, blow.began.speeds)
    before = in_state(angular_momentum(blow.before, body, ORIGIN), places, blow.state.speeds)
    push = substitute(torque([f for f in blow.forces if f.on == body], ORIGIN), blow.began.impulses)
    return same(context, after - before, in_state(push, places, blow.began.speeds))


def parting(context: Context, step: Step) -> Verdict:
    """They part at e times the speed of their approach, their positions differentiated; what does not slip does so with the
    material points at the contact (`data`: "blow", "element", "name")."""
    blow, element = step.data["blow"], step.data["element"]
    is_normal = step.data["name"] == element.name
    after, before = ((_approach if is_normal else slip_at)(system, element) for system in (blow.after, blow.before))
    gone = scalar(element["restitution" if is_normal else "tangential"]) * in_state(before, blow.state.places, blow.state.speeds)
    return same(context, in_state(after, blow.state.places, blow.began.speeds) + gone, NOTHING)


def _approach(system: System, element: Element) -> Scalar:
    if element.kind == "bounce":
        return time_derivative(closing(system, element), system.scope)
    where = geometry_of(system).where
    first, second = (where(ref) for ref in element["points"])
    return pair(element["along"]).dot((second - first).rate(system.scope.rates))


def energy_jump(context: Context, step: Step) -> Verdict:
    """The difference of the kinetic energies of both states, summed over the mass (`data`: "states")."""
    first, second = (_energy(*state) for state in step.data["states"])
    return same(context, first - second, right_side(context, step))


def _energy(system: System, places: Values, speeds: Values) -> Scalar:
    return in_state(sum((kinetic_energy(system, body) for body in system.bodies), NOTHING), places, speeds)
