"""How a phase of the motion ends: the state at the event that begins the next one.

In closed form where the accelerations are constant, or where one degree of freedom has a first
integral; the time is known in the first case only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from rbpsym.decide.signs import sign
from rbpsym.elements.events import EVENTS
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import NotApplicable, StatementError, Undecided, there
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, names_in, short, substitute, symbol, time_derivative
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen
from rbpsym.mechanics import strings
from rbpsym.mechanics.arrivals import EDGE, ArrivalState, at_start, first_met, mover, of_coordinate, positive_root, state_at
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.demands import Demand, existence, possible, settle
from rbpsym.mechanics.forms import AccelerationForm, gathered
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.led import led_to, put
from rbpsym.mechanics.numbers import floating, sample, samples
from rbpsym.mechanics.roots import factor_zeros, factors_in
from rbpsym.mechanics.solutions import Given
from rbpsym.mechanics.solved import time_to
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Coordinate, Element, Phase
from rbpsym.statement.scope import CLOCK

# --- events


def first_place(study: Study, phase: Phase, name: str, what: str, *gaps: Scalar, gives_way: bool = False) -> ArrivalState:
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
        raise no_closed_form(f"the place where “{phase.subject}” {what}") if what else never(study, phase, UNKNOWN)
    place, asked, sense = found
    return replace(state_at(study, name, place, sense), valid=possible(asked, study.assumptions, never(study, phase)))


def first_moment(study: Study, phase: Phase, what: str, *gaps: Scalar, gives_way: bool = False) -> ArrivalState:
    """The same where the accelerations are functions of the time alone: the state at the first moment."""
    if not are_uniform(study, CLOCK):
        raise no_closed_form(f"the place where “{phase.subject}” {what}")
    course, now = after(study, phase, at_start(study), symbol(CLOCK), ()).image, {CLOCK: NOTHING}
    known = Given(AccelerationForm(NOTHING), NOTHING, NOTHING, study, "")  # signs are all that is asked of it
    values = [short(substitute(study.on_motion(gap), course)) for gap in gaps]
    asked = [Demand(short(substitute(value, now)), ">=") for value in values] if gives_way else []
    times = [time_to(value, known, {}) for value in values if depends_on(value, CLOCK)]
    if not all(times):
        raise no_closed_form(f"the moment at which “{phase.subject}” {what}")
    met = [(time, demands) for time, demands in map(there, times) if settle(demands, study.assumptions) is not None]
    for numbers in samples(study.problem):
        ahead = [item for item in met if floating(item[0], numbers) > EDGE]
        if ahead and all(floating(one.value, numbers) >= 0 for one in asked):
            first, demands = min(ahead, key=lambda item: floating(item[0], numbers))
            later = [Demand(time - first, ">=") for time, _ in ahead if time is not first]
            return after(study, phase, at_start(study), first, [*asked, *demands, *later])
    raise never(study, phase, UNKNOWN if met else "never reached")


def first_of_forces(
    study: Study, phase: Phase, what: str, gaps: Callable[[Callable[[str], Scalar]], Sequence[Scalar]], *, gives_way: bool = False
) -> ArrivalState:
    """The same for values of unknown forces: by the place along the motion, else by the time."""
    along, name = study.reactions_along_motion, mover(study)
    if not along or name is None:
        return first_moment(study, phase, what or "has this value", *gaps(symbol), gives_way=gives_way)
    return first_place(study, phase, name, what, *gaps(along.__getitem__), gives_way=gives_way)


def run_out(study: Study, phase: Phase, first: Scalar, gain: Scalar, *asked: Demand) -> ArrivalState:
    """When what is there at first and changes at a constant rate has gone, where what is asked is met."""
    if is_zero(gain) or settle(asked, study.assumptions) is None:
        raise never(study, phase)
    time = short(-(first / gain))
    if all(floating(time, numbers) < 0 for numbers in samples(study.problem)):
        raise never(study, phase, UNKNOWN)
    return after(study, phase, at_start(study), time, asked)


def uniform_motion(study: Study, time: Scalar) -> ArrivalState:
    """All coordinates and speeds at a time after the start. Raises NotApplicable where the accelerations are not constant."""
    return after(study, Phase("", "at once", "", (), study.problem), at_start(study), time, ())


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


class EventLaw(Frozen):
    """Where, or when, the motion comes to an event, and what vanishes there (None where no equation says it)."""

    ends: Callable[[Study, Phase], ArrivalState]
    gap: Callable[[Study, Phase], Scalar] | None = None


LAWS: Mapping[str, EventLaw] = KindParts(EVENTS, "law", "LAW")


# --- uniform motion


def are_uniform(study: Study, *besides: str) -> bool:
    """Whether the accelerations are constant, `besides` what they may depend on."""
    found, names = _gains(study), {*study.system.coordinates, *study.system.speeds, CLOCK} - {*besides}
    return found is not None and not any(depends_on(value, name) for value in found.values() for name in names)


def _gains(study: Study) -> dict[str, Scalar] | None:
    """The accelerations beside what stays at rest."""
    found = study.dynamics.accelerations
    return None if found is None else {name: substitute(value, study.resting) for name, value in found.items()}


def uniform(study: Study, phase: Phase, *besides: str) -> Mapping[str, Scalar]:
    """The accelerations, if they are constants."""
    found = _gains(study)
    if found is None or not are_uniform(study, *besides):
        raise not_uniform(phase)
    return found


def gain_of(study: Study, phase: Phase, name: str, *besides: str) -> Scalar:
    """The acceleration of any coordinate. Raises NotApplicable where it is no constant, as of what is tied to the time."""
    rate = of_coordinate(study, name)[1]
    gain = substitute(substitute(time_derivative(rate, study.system.scope), uniform(study, phase, *besides)), study.resting)
    if names_in(gain) & ({*study.system.scope.rates, *study.system.speeds, CLOCK} - {*besides}):
        raise no_closed_form(f"the moment at which “{name}” has its value: its acceleration is not constant")
    return gain


def after(study: Study, phase: Phase, start: ArrivalState, time: Scalar, asked: Iterable[Demand]) -> ArrivalState:
    """The places and speeds that the accelerations, constants or functions of the time, give; what follows from these and the
    time, from its formula. Raises StatementError if what is asked is never met."""
    valid = possible(asked, study.assumptions, never(study, phase))
    image, to = led_to(study, {CLOCK: time}), {CLOCK: time}
    for name in study.system.independent:
        gone = gathered(gain_of(study, phase, name, CLOCK))
        way = None if gone is None else gathered(gone)
        if gone is None or way is None:
            raise no_closed_form(f"the motion of “{name}” as a function of the time")
        speed = start.speeds[name]
        image |= {name: start.places[name] + speed * time + substitute(way, to), f"{name}_dot": speed + substitute(gone, to)}
    pairs = {name: _there(study, name, image) for name in start.places}
    places = {name: short(without_even_roots(place)) for name, (place, _) in pairs.items()}
    return ArrivalState(time, places, {name: short(without_even_roots(speed)) for name, (_, speed) in pairs.items()}, valid)


def _there(study: Study, name: str, image: dict[str, Scalar]) -> tuple[Scalar, ...]:
    """A place and speed; left as they are where they are sines of an angle that is no polynomial."""
    try:
        return tuple(put(value, image) for value in of_coordinate(study, name))
    except Undecided:
        return symbol(name), symbol(f"{name}_dot")


def time_until(study: Study, phase: Phase, way: Scalar, speed: Scalar, gain: Scalar) -> tuple[Scalar, list[Demand]]:
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
        raise never(study, phase, UNKNOWN) if may_be else never(study, phase)
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


def never(study: Study, phase: Phase, how: str = "never reached") -> StatementError:
    """The sentence for an event to which the motion does not come."""
    elements = (*study.problem.constraints, *phase.impulses, *phase.problem.constraints)
    stated: tuple[Coordinate | Element, ...] = (*study.problem.coordinates, *elements)
    return StatementError(
        f"the phase “{phase.name}” is {how}: “{phase.subject}” {EVENTS[phase.event].fails}",
        instead="check the start, the start speeds, the value, and the sense of a slip.",
        place=next((one.place for one in stated if one.name == phase.subject), None),
    )


def cannot_end(phase: Phase, element: Element, what: str, instead: str) -> StatementError:
    """The sentence for an event that an element cannot have."""
    return StatementError(f"the phase “{phase.name}” begins when “{phase.subject}” {what}", instead=instead, place=element.place)


def not_uniform(phase: Phase) -> NotApplicable:
    """The refusal where accelerations that are not constant leave the end of a phase without a closed form."""
    return NotApplicable(
        f"no closed form was found for the end of the phase before “{phase.name}”: the accelerations are not constant",
        instead="state this phase as a problem of its own, or follow it in the simulation.",
    )


def no_closed_form(what: str) -> NotApplicable:
    """The refusal where something has no closed form."""
    return NotApplicable(
        f"no closed form was found for {what}",
        instead="state the phase after it as a problem of its own, or follow it in the simulation.",
    )
