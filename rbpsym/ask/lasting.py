"""How far the motion that is stated lasts: no contact is lost on the way to a place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial

from rbpsym.ask.asked import Asked, Moment
from rbpsym.ask.extremes import by_speed, driven, least_of, least_until, until
from rbpsym.ask.found import Found
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, StatementError, Undecided, there
from rbpsym.field import NOTHING, Scalar, is_zero, names_in, short, substitute, symbol
from rbpsym.mechanics.arrivals import ArrivalState, at_start, mover, state_at, value_in
from rbpsym.mechanics.demands import Demand, assuming, possible
from rbpsym.mechanics.endings import LAWS
from rbpsym.mechanics.events import pushes, taken, ways_of
from rbpsym.mechanics.friction import slips, slips_on, spare, stops
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.orbit import swinging
from rbpsym.mechanics.pushing import begins, begun_numbers, ways_kept
from rbpsym.mechanics.sides import grips
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.quantity.path import sense
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.model import Phase


def contacts_last(study: Study, places: Mapping[str, Scalar]) -> Iterator[tuple[str, Demand]]:
    """(force, what it asks) for each contact that is lost on the way: a place lies not beyond that; where the contact is
    lost under conditions only, its force still pushes there."""
    motion = ProblemWorld(study).motion
    for loss in study.losses:
        if loss.valid or not loss.at:
            yield loss.force, Demand(short(substitute(there(study.reactions_along_motion)[loss.force], places)), ">=")
        elif loss.coordinate in places:
            name, end = loss.coordinate, loss.at[loss.coordinate]
            way = sense(motion, name) or end - study.system.scope.start[name]
            yield loss.force, Demand((end - places[name]) * way, ">=")


def clear(study: Study, state: ArrivalState) -> ArrivalState:
    """The state, if no contact is lost on the way to it; what that asks of the parameters is a condition."""
    asked = list(contacts_last(study, state.places))
    for force, demand in asked:
        possible([demand], study.assumptions, _ends_before(force))
    # what the place itself asks for stays beside it: a check of a strict sign takes strict conditions only
    left = possible((demand for _, demand in asked), study.assumptions, _ends_before(asked[0][0])) if asked else ()
    return replace(state, valid=(*state.valid, *left))


def _ends_before(force: str) -> StatementError:
    return StatementError(f"“{force}” vanishes before, and with it the motion that is stated ends")


def coming(study: Study, name: str, place: Scalar) -> tuple[ArrivalState, bool]:
    """A place to which the motion may come, with what its speed asks for where that is least on the way, and whether that is
    known; else with what it asks for there alone."""
    from rbpsym.ask.seen import way_to
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    state, square, lows = state_at(study, name, place), study.squares[name], None
    with suppress(Undecided, StatementError):
        way, within = way_to(ProblemWorld(study), name, place, study.assumptions)
        lows = [*way.asked, *least_values(Wanted((square,), within, name, end=place, asked=way.asked))]
    never = StatementError(f"“{name}” does not come to this value in this motion: its speed vanishes before")
    asked = [Demand(substitute(square, {name: place}), ">=")] if lows is None else lows
    state = replace(state, valid=possible(asked, study.assumptions, never))
    return (state, False) if lows is None else (clear(study, state), True)


def in_phase(asked: Asked, moment: Moment) -> Moment:
    """A moment that comes before its phase ends: with what that asks of the two times, as far as they are known. Raises
    StatementError where it never does."""
    state, begins = moment.state, moment.place + 1
    if moment.how not in ("time", "event") or not state.time or begins == len(asked.names):
        return moment
    with suppress(NotApplicable):
        end = asked.began(begins).before.time
        never = StatementError(f"before that the phase “{asked.names[begins]}” begins")
        given = asked.study(moment.place).assumptions
        left = () if end is None else possible([Demand(end - state.time, ">=")], given, never)
        return replace(moment, state=replace(state, valid=(*state.valid, *left)))
    return moment


def held(study: Study) -> list[Demand]:
    """What contacts and friction ask for on the motion where they are not sure to hold, as functions of the state."""
    along = study.reactions_along_motion or {}
    kept = [demand for side in study.sides if side.state in ("asked", "open") for demand in side.valid]
    for need in study.friction_needs:
        if need.constraint in along and need.needed is None and need.limit is not None:
            most, friction = sum((along[n] for n in need.normals), NOTHING) * need.limit, along[need.friction]
            kept += [Demand(short(most + friction * side), ">=") for side in (-1, 1)]
        else:
            kept += grips((need,))
    return [Demand(short(substitute(one.value, study.resting)), one.op) for one in kept] if study.resting else kept


def running(study: Study) -> Iterator[Demand]:
    """Where strings run and springs reach as the formulas have it, as far as that is known of one coordinate."""
    for _, value in ways_kept(study):
        way = substitute(substitute(value, study.system.dependent), study.resting)
        moving = names_in(way) & study.system.scope.rates.keys()
        if moving and ((len(moving) == 1 and moving <= study.squares.keys()) or not moving & study.system.scope.start.keys()):
            yield Demand(way)


def regime(study: Study) -> list[Demand]:
    """What of that depends on the parameters alone."""
    moving = {*study.system.scope.rates, *study.system.speeds, "t"}
    return [demand for demand in held(study) if not names_in(demand.value) & moving]


def slipping(study: Study, state: ArrivalState) -> Iterator[Demand]:
    """What slips has not changed its sense up to a state."""
    for slip in slips(study.system).values():
        left = neat(short(substitute(slip, state.image)), study.assumptions)
        if left and not names_in(left) & study.system.scope.rates.keys():
            yield Demand(left, ">=")


def asks(asked: Asked, found: Found) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """What is asked of the parameters, and of the state where it is told along the motion, for what was found to be that of
    the motion as it is stated, through the phases before; what of that is not decided. Raises StatementError where that surely
    does not last so far."""
    kind, _, place = found.told.partition(" ")
    number = int(place) if kind == "phase" else found.moment.place if found.moment else asked.place(found.study)
    before, own = lasted(asked, number), ((), ()) if kind == "phase" else _in_phase(found)
    return (*before[0], *own[0]), (*before[1], *own[1])


def lasted(asked: Asked, number: int) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """The same for the phases before that of this number to last up to their ends."""
    lasting = [k for k in range(number) if asked.problem.phases[k].event != "at once"]
    asked.lasted.update((k, _to_end(asked, k)) for k in lasting if k not in asked.lasted)
    return tuple(d for k in lasting for d in asked.lasted[k][0]), tuple(d for k in lasting for d in asked.lasted[k][1])


def _to_end(asked: Asked, number: int) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    study, phase = asked.study(number), asked.problem.phases[number]
    state = clear(study, asked.began(number + 1).before)
    lasts, doubts = lasts_to(study, Moment(number, state, "event", phase))
    return (*begins(study), *state.valid, *lasts), doubts


def _in_phase(found: Found) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """The same of its own phase alone."""
    study, (kind, _, _) = found.study, found.told.partition(" ")
    if kind in ("course", "swing"):
        return _decided(lambda: (*begins(study), *_on_way(study, None)))
    if kind == "oscillations":
        return (*_sides(study),), ()
    if kind or found.about or is_constant(found):
        return (), ()
    if found.moment is not None:
        lasts, doubts = lasts_to(study, found.moment)
        return (*(_sides(study) if found.moment.how == "rest" else begins(study)), *lasts), doubts
    lost = contacts_last(study, {n: symbol(n) for n in study.system.coordinates}) if found.of == "position" else ()
    on_the_way = (*held(study), *running(study)) if found.of == "position" else ()
    along = [one for one in on_the_way if not kept_from_start(study, one)] if found.of == "position" else regime(study)
    return (*begins(study), *(demand for _, demand in lost), *along), ()


def kept_from_start(study: Study, demand: Demand) -> bool:
    """Whether it is positive ahead of the start of a motion that begins as it is stated, where this never comes to lie behind
    that: it starts from rest, friction stops it, or it does not turn round; or it is the speed with which it goes on."""
    given = assuming(study.assumptions, begins(study))
    speeds = {symbol(f"{name}_dot") * way: (name, way) for name in study.squares for way in (1, -1)}
    name, forwards = speeds.get(demand.value, ("", 0))
    value = symbol(name) if name else demand.value
    for way in ways_of(study.system, study.dynamics, value, study.squares, given):
        ends = given.range_of(way.name)
        ahead = given.with_range(way.name, *((way.start, ends[1]) if way.sense > 0 else (ends[0], way.start)))
        is_pushed = not is_zero(study.system.scope.start.get(f"{way.name}_dot", NOTHING))
        halts = stops(study.system) and not slips_on(study.system, way.name)
        turns = is_pushed and not halts and sign(way.square, ahead).kind != "positive"
        if name:
            return forwards == way.sense and sign(way.square, ahead).kind == "positive"
        return not turns and sign(value, ahead).kind == "positive"
    return False


def _sides(study: Study) -> Iterator[Demand]:
    """That the motion begins on the side of springs, strings and surfaces on which a place of rest is told, where that lies
    there under a condition: on the other side there may be another one."""
    for _, value in taken(study.system):
        rests = [neat(substitute(value, item.at), study.assumptions) for item in study.equilibria]
        begun = substitute(value, study.system.scope.start)
        if not names_in(begun) & study.system.scope.rates.keys():
            yield from [Demand(begun)] if any(sign(one, study.assumptions).kind != "positive" for one in rests) else []


def is_constant(found: Found) -> bool:
    """Whether it is made of parameters alone, as a mass is."""
    constants = {"pi", *(quantity.name for quantity in found.study.problem.parameters)}
    return found.moment is None and not found.told and all(names_in(value) <= constants for value in found.named)


def is_of_motion(found: Found) -> bool:
    """Whether it is what it is in the motion from the start alone: no place of rest, no mass."""
    is_at_rest = found.moment is not None and found.moment.how == "rest"
    return not (found.about or is_at_rest or is_constant(found) or found.told.partition(" ")[0] in ("oscillations", "orbit"))


def compared(found: Found, others: Iterable[Found]) -> tuple[Demand, ...]:
    """What is asked for a number with which what others are in the motion is compared: that this begins as it is stated."""
    is_asked = is_constant(found) and any(map(is_of_motion, others))
    return (*begins(found.study), *regime(found.study)) if is_asked else ()


def lasts_to_place(study: Study, name: str, place: Scalar) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """The same as `lasts_to` for a place on the motion of a coordinate, with the contacts that are lost on it."""
    begin = study.system.scope.start.get(name)
    if name not in study.squares or begin is None:
        return (), ()
    if is_zero(place - begin):
        return lasts_to(study, Moment(0, at_start(study)))
    if mover(study) == name:
        pushed = study.system.scope.start.get(f"{name}_dot", NOTHING)  # by the side on which it surely is, else as it sets out
        way = next((w for gap in (place - begin, pushed) if (w := sign(gap, study.assumptions).sense)), 0)
        reached = state_at(study, name, place, way or (-1 if floating(place - begin, begun_numbers(study)) < 0 else 1))
    else:
        reached = LAWS["reaches"].ends(study, Phase("", "reaches", name, (), study.problem, present(place)))
    lasts, doubts = lasts_to(study, Moment(0, reached, "event"))
    return (*(demand for _, demand in contacts_last(study, {name: place})), *lasts), doubts


def lasts_to(study: Study, moment: Moment) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    """What the same ask of the parameters at a moment and on the whole way to it, and what of that is not decided. Raises
    StatementError where they surely do not last so far."""
    if moment.is_small and (item := swinging(study)) is not None:  # close to it they are what they are there
        still, kept = {**item.at, **dict.fromkeys(study.system.speeds, NOTHING)}, held(study)
        found = tuple(Demand(neat(substitute(one.value, still), study.assumptions), one.op) for one in kept)
        if all(one.value for one in found):
            return found, ()
    if moment.how == "rest":
        return tuple(_at_rest(study, moment.state)), ()
    if moment.how == "start":
        return tuple(Demand(value_in(study, demand.value, moment.state), demand.op) for demand in held(study)), ()
    is_place = moment.how != "time" or (moment.watched is not None and _goes_on(study, *moment.watched[:2]))
    if is_place:
        return _decided(lambda: (*slipping(study, moment.state), *_on_way(study, moment.state.places, moment)))
    state = moment.state
    lost = partial(never_lost, study, state, moment.courses)
    return _decided(lambda: (*slipping(study, state), *lost(), *_on_way(study, None, moment)))


def _at_rest(study: Study, state: ArrivalState) -> Iterator[Demand]:
    """What contacts and friction ask for where it rests: of their forces there, not of those with which a motion goes through."""

    def there_(name: str) -> Scalar:
        return neat(value_in(study, symbol(name), state), study.assumptions)

    for element in study.problem.constraints:
        values = [*map(there_, pushes(element)), *spare(element, there_)]
        yield from (Demand(value, ">=") for value in values if not sign(value, study.assumptions).is_nonnegative)


def _pushing(study: Study, places: Mapping[str, Scalar] | None) -> Iterator[Demand]:
    """The forces that vanish under conditions only: that they push at a place does not say that they did on the way to it."""
    for loss in study.losses:
        if places and loss.coordinate in places and (loss.valid or not loss.at):
            yield Demand(there(study.reactions_along_motion)[loss.force], ">=")


def _goes_on(study: Study, name: str, value: Scalar) -> bool:
    """Whether what is watched is a coordinate, or a speed that changes uniformly without turning round before it has a value."""
    coordinate = name.removesuffix("_dot")
    gain = (study.dynamics.accelerations or {}).get(f"{coordinate}_ddot")
    if name == coordinate or gain is None:
        return name in study.system.coordinates
    is_uniform = not names_in(gain) & {*study.system.scope.rates, *study.system.speeds, "t"}
    first = study.system.scope.start.get(name, NOTHING)
    return is_uniform and sign(first * value, study.assumptions).is_nonnegative


def never_lost(study: Study, state: ArrivalState, courses: Mapping[str, InTime]) -> Iterator[Demand]:
    """No contact is lost on the whole motion where that depends on one condition; else not up to the time of a state, as far as
    `courses` tell that: before it comes to the place, or as long as its force pushes."""
    from rbpsym.ask.in_time import first_time

    for loss, (_, here) in zip(study.losses, contacts_last(study, state.places), strict=True):
        name = loss.coordinate
        if len(loss.valid) == 1:
            yield Demand(-loss.valid[0].value, OPPOSITE[loss.valid[0].op])
        elif name not in courses:
            yield here
        elif loss.valid or not loss.at:
            force = there(study.reactions_along_motion)[loss.force]
            yield from least_until(study, Demand(force, ">="), state.time, courses)
        else:
            try:
                time, _ = first_time(study, name, loss.at[name], courses)
            except NotApplicable as error:
                raise Undecided(error.what) from None
            left = Demand(substitute(time, courses[name].letters) - there(state.time), ">=")
            possible([left], study.assumptions, _ends_before(loss.force))
            yield left


OPPOSITE = {">": ">=", ">=": ">"}


def _decided(found: Callable[[], tuple[Demand, ...]]) -> tuple[tuple[Demand, ...], tuple[str, ...]]:
    try:
        return found(), ()
    except Undecided as error:
        return (), (f"whether the contacts and the friction last so far is not decided: {error.what}",)


def _on_way(study: Study, places: Mapping[str, Scalar] | None, moment: Moment | None = None) -> Iterator[Demand]:
    """Least values on the way from the start to some places (None: on the whole motion; what surely ends, and what the courses
    of a moment tell, up to its time). Raises Undecided, StatementError."""
    time = moment.state.time if moment else None
    for demand in running(study):
        is_timed = not (places and moment and study.system.independent) or moment.courses
        if is_timed and (then := until(study, demand.value, time)) is not None:
            yield then
            continue
        with suppress(*([] if places else [Undecided])):  # how far it swings on the whole is told by what holds it
            [name] = names_in(demand.value) & study.system.scope.rates.keys()
            found = least_of(study, demand, name, places=places)
            what = "a string runs out, or a spring turns over, before: the motion that is stated ends there"
            possible(found, study.assumptions, StatementError(what))
            yield from found
    for demand in (*held(study), *_pushing(study, places)):
        names = names_in(demand.value) & {*study.system.coordinates, *study.system.speeds, "t"}
        if (low := by_speed(study, demand)) is not None:
            found = low
        elif len(names) > 1 or any(name not in study.squares and driven(study, name, places) is None for name in names):
            if time is None and places is not None:
                raise Undecided("their forces are not known on the way")
            found = least_until(study, demand, time, moment.courses if moment else {}, moment.state.valid if moment else ())
        else:
            found = least_of(study, demand, *names, places=places) if names else [demand]
        what = "a contact is lost, or friction reaches its limit, before: the motion that is stated ends there"
        possible(found, study.assumptions, StatementError(what))
        yield from found
