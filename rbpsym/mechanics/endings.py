"""How a phase of the motion ends: the state at the event that begins the next one.

In closed form where the accelerations are constant, or where one degree of freedom has a first
integral; the time is known in the first case only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, StatementError, there
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, names_in, short, substitute, symbol, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.field.roots import without_even_roots
from rbpsym.mechanics import strings
from rbpsym.mechanics.arrivals import (
    EDGE,
    ArrivalState,
    at_start,
    driven_to,
    first_met,
    mover,
    of_coordinate,
    positive_root,
    state_at,
    state_reached,
)
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.demands import Demand, existence, possible, settle
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.forms import gathered
from rbpsym.mechanics.friction import geometry_of, spare
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.numbers import floating, sample, samples
from rbpsym.mechanics.roots import factor_zeros, factors_in
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import by_letters
from rbpsym.statement.model import Coordinate, Element, Phase
from rbpsym.statement.scope import CLOCK

# --- events


def slip_ends(study: Study, phase: Phase) -> ArrivalState:
    """The moment at which a slip that changes uniformly has gone."""
    element = study.system.element(phase.subject)
    if element.values.get("coefficient") is None:
        raise _cannot_end(phase, element, "stops slipping, but it has no kinetic friction", 'give it a coefficient = "mu".')
    geometry = geometry_of(study.system)
    slip = short(substitute(slip_speed(geometry, meeting(element, geometry)), study.system.dependent))
    if not _are_uniform(study):
        return _at_rest(study, phase, slip)
    gain = short(substitute(time_derivative(slip, study.system.scope), _uniform(study, phase)))
    start = at_start(study)
    first = short(substitute(slip, by_letters(start.speeds) | dict(start.places)))
    if is_zero(first):
        cure = "where two contacts stop slipping at the same moment, let both roll from one phase on."
        raise _cannot_end(phase, element, "stops slipping, and it does not slip any more before", cure)
    asked, what = [Demand(-(first * gain))], "does not stop slipping"
    if is_zero(gain) or settle(asked, study.assumptions) is None:
        raise _never(study, phase, what=what)
    if all(floating(-(first / gain), numbers) < 0 for numbers in samples(study.problem)):
        raise _never(study, phase, UNKNOWN, what)
    return _after(study, phase, start, short(-(first / gain)), asked)


def _at_rest(study: Study, phase: Phase, slip: Scalar) -> ArrivalState:
    """Where the one coordinate that moves comes to rest, and with it the slip."""
    name = mover(study)
    if name is None or not is_zero(substitute(slip, {f"{name}_dot": NOTHING})):
        raise _not_uniform(phase)
    return _met(study, phase, name, "stops slipping", study.squares[name])


def contact_lost(study: Study, phase: Phase) -> ArrivalState:
    """The place at which a contact is lost, and the speed there from the first integral."""
    element = study.system.element(phase.subject)
    if not pushes(element):
        cure = "name a contact or a string, or let another event begin the phase."
        raise _cannot_end(phase, element, f"is lost, but a {element.kind} holds to both sides", cure)
    loss = next((item for item in study.losses if item.force == phase.subject and item.at), None)
    name, along = mover(study), study.reactions_along_motion
    if loss is not None and name is not None and name in loss.at:
        return replace(state_at(study, name, loss.at[name]), valid=loss.valid)
    if not along or name is None:
        raise _no_closed_form(f"the place where “{phase.subject}” is lost")
    return _met(study, phase, name, "is lost", along[phase.subject], gives_way=True)


def value_reached(study: Study, phase: Phase) -> ArrivalState:
    """The moment or the place at which a coordinate has a value."""
    value = scalar(there(phase.value))
    if found := state_reached(study, phase.subject, value):
        return found
    if _are_uniform(study):
        start, gain = at_start(study), _gain(study, phase, phase.subject)
        way = short(value - start.places[phase.subject])
        return _after(study, phase, start, *_time_until(study, phase, way, start.speeds[phase.subject], gain))
    name = mover(study, phase.subject)
    if name is None or f"{phase.subject}_dot" in study.kept_speeds:
        raise _no_closed_form(f"the moment at which “{phase.subject}” reaches its value")
    return _met(study, phase, name, "", of_coordinate(study, phase.subject)[0] - value)


def force_taken(study: Study, phase: Phase) -> ArrivalState:
    """The place at which an unknown force has a value."""
    along, name = study.reactions_along_motion, mover(study)
    if not along or name is None:
        raise _no_closed_form(f"the place where “{phase.subject}” has this value")
    return _met(study, phase, name, "", along[phase.subject] - scalar(there(phase.value)))


def grip_ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which static friction reaches its limit: |f| = μ N."""
    element = study.system.element(phase.subject)
    if element.values.get("limit") is None:
        raise _cannot_end(phase, element, "slips, but its static friction has no limit", 'give it a limit = "mu".')
    along, name = study.reactions_along_motion, mover(study)
    if not along or name is None:
        raise _no_closed_form(f"the place where “{phase.subject}” slips")
    return _met(study, phase, name, "slips", *spare(element, along.__getitem__), gives_way=True)


def _met(study: Study, phase: Phase, name: str, what: str, *gaps: Scalar, gives_way: bool = False) -> ArrivalState:
    """The state at the first place at which one of the values vanishes (what `gives_way` there holds at the start). Raises
    StatementError if it is never met, and for a coordinate that has its value at none of the numbers tried (`what` is empty)."""
    start = study.system.scope.start
    begun = [Demand(short(substitute(gap, start)), ">=") for gap in gaps] if gives_way else []
    found = first_met(study, name, *gaps, first=begun)
    factors = [factor for gap in gaps for factor in factors_in(gap, name)]
    if found is None and all(factor_zeros(factor, name, study.assumptions) for factor in factors) and what:
        raise NotApplicable(f"at none of the numbers that were tried the motion holds until “{phase.subject}” {what}")
    what = what or ("comes back to where it is first" if any(is_zero(short(substitute(gap, start))) for gap in gaps) else "")
    if found is None:
        raise _no_closed_form(f"the place where “{phase.subject}” {what}") if what else _never(study, phase, UNKNOWN)
    place, asked, sense = found
    return replace(state_at(study, name, place, sense), valid=possible(asked, study.assumptions, _never(study, phase)))


def comes_to_rest(study: Study, phase: Phase) -> ArrivalState:
    """The first moment or place after the start at which the speed of a coordinate vanishes."""
    if _are_uniform(study):
        start, gain = at_start(study), _gain(study, phase, phase.subject)
        speed = start.speeds[phase.subject]
        way = -1 if floating(speed, sample(study.problem)) < 0 else 1
        asked = [Demand(speed * way), Demand(-(gain * way))]
        if is_zero(gain) or settle(asked, study.assumptions) is None:
            raise _never(study, phase, what="does not come to rest")
        return _after(study, phase, start, short(-(speed / gain)), asked)
    name = mover(study, phase.subject)
    if name is None or f"{phase.subject}_dot" in study.kept_speeds or is_zero(of_coordinate(study, phase.subject)[1]):
        raise _no_closed_form(f"the place at which “{phase.subject}” comes to rest")
    return _met(study, phase, name, "comes to rest", study.squares[name])


def time_gone(study: Study, phase: Phase) -> ArrivalState:
    """The state after a stated time."""
    time = scalar(there(phase.value))
    return _after(study, phase, at_start(study), time, [Demand(time)])


def uniform_motion(study: Study, time: Scalar) -> ArrivalState:
    """All coordinates and speeds at a time after the start. Raises NotApplicable where the accelerations are not constant."""
    return _after(study, Phase("", "at once", "", (), study.problem), at_start(study), time, ())


def is_before(study: Study, first: ArrivalState, second: ArrivalState) -> bool:
    """Whether one state comes before another, or with it, at the sample numbers."""
    numbers, start = sample(study.problem), at_start(study)
    if first.time is not None and second.time is not None:
        return floating(first.time - second.time, numbers) <= EDGE
    ways = ((abs(floating(s.places[n] - start.places[n], numbers)) for s in (first, second)) for n in start.places)
    return all(one <= other + EDGE for one, other in ways)


def gap(element: Element, geometry: Geometry) -> Scalar:
    """What vanishes where a contact touches, or a string of given length is taut."""
    return there(strings.gap(element, geometry)) if "path" in element.values else meeting(element, geometry).gap


def gap_closes(study: Study, phase: Phase) -> ArrivalState:
    """The moment or the place at which what the phase brings closes: a body lands, a string goes taut."""
    value = short(substitute(gap(there(phase.gap), geometry_of(study.system)), study.system.dependent))
    name, start, numbers = mover(study), at_start(study), sample(study.problem)
    if name is not None:
        led = {name, *(speed.removesuffix("_dot") for speed in study.kept_speeds)}
        value = substitute(value, {n: place for n, place in start.places.items() if n not in led})
    if not _are_uniform(study):
        if name is None or names_in(value) & (led - {name}):
            raise _no_closed_form(f"the moment at which “{phase.subject}” begins")
        return _met(study, phase, name, "begins", value)
    if name is not None and (found := first_met(study, name, value)):
        way = short(found[0] - start.places[name])
        time, asked = _time_until(study, phase, way, start.speeds[name], _gain(study, phase, name))
        return _after(study, phase, start, time, [*asked, *found[1]])
    met = _met_in_time(study, phase, short(substitute(value, uniform_motion(study, symbol("t")).places)))
    first = min(met, key=lambda item: floating(item[0], numbers), default=None)
    if first is None:
        raise _never(study, phase, UNKNOWN, "does not begin")
    return _after(study, phase, start, *first)


def _met_in_time(study: Study, phase: Phase, course: Scalar) -> Iterator[tuple[Scalar, list[Demand]]]:
    """For each factor of a function of the time that has a zero ahead: the first, and where it is that. Raises NotApplicable
    for one of higher degree than two."""
    for factor in factors_in(course, "t"):
        rate = derivative(factor, "t")
        first, speed = (substitute(value, {"t": NOTHING}) for value in (factor, rate))
        if depends_on(gain := derivative(rate, "t"), "t"):
            raise _no_closed_form(f"the moment at which “{phase.subject}” begins")
        with suppress(StatementError):
            yield _time_until(study, phase, -first, speed, gain)


ENDINGS = {
    "at once": at_start,
    "no slip": slip_ends,
    "slips": grip_ends,
    "lost": contact_lost,
    "reaches": value_reached,
    "rests": comes_to_rest,
    "time": time_gone,
    "begins": gap_closes,
}


# --- uniform motion


def _are_uniform(study: Study, *besides: str) -> bool:
    """Whether the accelerations are constant, `besides` what they may depend on."""
    found, names = _gains(study), {*study.system.coordinates, *study.system.speeds, CLOCK} - {*besides}
    return found is not None and not any(depends_on(value, name) for value in found.values() for name in names)


def _gains(study: Study) -> dict[str, Scalar] | None:
    """The accelerations beside what stays at rest."""
    found = study.dynamics.accelerations
    return None if found is None else {name: substitute(value, study.resting) for name, value in found.items()}


def _uniform(study: Study, phase: Phase, *besides: str) -> Mapping[str, Scalar]:
    """The accelerations, if they are constants."""
    found = _gains(study)
    if found is None or not _are_uniform(study, *besides):
        raise _not_uniform(phase)
    return found


def _gain(study: Study, phase: Phase, name: str, *besides: str) -> Scalar:
    """The acceleration of any coordinate. Raises NotApplicable where it is no constant, as of what is tied to the time."""
    rate = of_coordinate(study, name)[1]
    gain = substitute(substitute(time_derivative(rate, study.system.scope), _uniform(study, phase, *besides)), study.resting)
    if names_in(gain) & ({*study.system.scope.rates, *study.system.speeds, CLOCK} - {*besides}):
        raise _no_closed_form(f"the moment at which “{name}” has its value: its acceleration is not constant")
    return gain


def _after(study: Study, phase: Phase, start: ArrivalState, time: Scalar, asked: Iterable[Demand]) -> ArrivalState:
    """The places and speeds that the accelerations, constants or functions of the time, give; what follows from these and the
    time, from its formula. Raises StatementError if what is asked is never met."""
    valid = possible(asked, study.assumptions, _never(study, phase))
    image, to = driven_to(study, {CLOCK: time}), {CLOCK: time}
    for name in study.system.independent:
        gone = gathered(_gain(study, phase, name, CLOCK))
        way = None if gone is None else gathered(gone)
        if gone is None or way is None:
            raise _no_closed_form(f"the motion of “{name}” as a function of the time")
        speed = start.speeds[name]
        image |= {name: start.places[name] + speed * time + substitute(way, to), f"{name}_dot": speed + substitute(gone, to)}
    pairs = {name: [substitute(value, image) for value in of_coordinate(study, name)] for name in start.places}
    places = {name: short(without_even_roots(place)) for name, (place, _) in pairs.items()}
    return ArrivalState(time, places, {name: short(without_even_roots(speed)) for name, (_, speed) in pairs.items()}, valid)


def _time_until(study: Study, phase: Phase, way: Scalar, speed: Scalar, gain: Scalar) -> tuple[Scalar, list[Demand]]:
    """The first t > 0 with q̇ t + ½ q̈ t² = way at the first sample numbers at which there is one, and where it is
    the first: the roots have the product -2 way/q̈ and the sum -2 q̇/q̈."""
    if is_zero(gain):
        times = [] if is_zero(speed) else [short(way / speed)]
    else:
        spread = positive_root(study, speed * speed + way * gain * 2)
        times = [short((spread * side - speed) / gain) for side in (1, -1)]
    tried = ((numbers, [time for time in times if floating(time, numbers) > EDGE]) for numbers in samples(study.problem))
    numbers, ahead = next((item for item in tried if item[1]), ({}, []))
    if not ahead:
        may_be = any(settle(existence(time), study.assumptions) is not None for time in times)
        raise _never(study, phase, UNKNOWN) if may_be else _never(study, phase)
    first = min(ahead, key=lambda time: floating(time, numbers))
    if is_zero(gain):
        return first, [Demand(way * speed)]
    going = sign(speed, study.assumptions).sense
    if going and sign(way, study.assumptions).sense == going and sign(gain, study.assumptions).kind is None:
        return first, [Demand(gain, "!="), Demand(speed * speed + way * gain * 2, ">=")]  # whatever the sense of the gain
    sense = 1 if floating(gain, numbers) > 0 else -1
    if len(ahead) == 1 and not is_zero(way):
        return first, [Demand(gain * sense), Demand(way * sense)]
    back = [] if is_zero(way) else [Demand(-(way * sense))]
    return first, [*existence(first), Demand(gain * sense), Demand(-(speed * sense)), *back]


UNKNOWN = "not reached at any of the numbers that were tried"


def _never(study: Study, phase: Phase, how: str = "never reached", what: str = "does not come to its value") -> StatementError:
    elements = (*study.problem.constraints, *phase.impulses, *phase.problem.constraints)
    stated: tuple[Coordinate | Element, ...] = (*study.problem.coordinates, *elements)
    return StatementError(
        f"the phase “{phase.name}” is {how}: “{phase.subject}” {what}",
        instead="check the start, the start speeds, the value, and the sense of a slip.",
        place=next((one.place for one in stated if one.name == phase.subject), None),
    )


def _cannot_end(phase: Phase, element: Element, what: str, instead: str) -> StatementError:
    return StatementError(f"the phase “{phase.name}” begins when “{phase.subject}” {what}", instead=instead, place=element.place)


def _not_uniform(phase: Phase) -> NotApplicable:
    return NotApplicable(
        f"no closed form was found for the end of the phase before “{phase.name}”: the accelerations are not constant",
        instead="state this phase as a problem of its own, or follow it in the simulation.",
    )


def _no_closed_form(what: str) -> NotApplicable:
    return NotApplicable(
        f"no closed form was found for {what}",
        instead="state the phase after it as a problem of its own, or follow it in the simulation.",
    )
