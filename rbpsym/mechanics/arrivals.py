"""Where the one coordinate that moves first comes to a place at which a value vanishes.

Numbers choose the sense and the root; told with them are the conditions under which the motion takes this sense, comes
there without a halt, and meets no other root before.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat, root_of, sign_along
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, StatementError
from rbpsym.field import derivative, has_roots, is_zero, names_in, short, substitute, time_derivative
from rbpsym.field.integration import definite
from rbpsym.field.roots import without_even_roots
from rbpsym.field.scalar import NOTHING, PI, Scalar, symbol
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.demands import Demand, assuming, existence, settle
from rbpsym.mechanics.events import Way, places_ahead
from rbpsym.mechanics.numbers import Numbers, floating, sample, samples
from rbpsym.mechanics.pushing import begins
from rbpsym.mechanics.roots import factor_zeros, factors_in, period
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import by_letters
from rbpsym.present.forms import present
from rbpsym.statement.model import Phase, Problem


class ArrivalState(Frozen):
    """Time since the start of the phase (None: no closed form), coordinates and speeds of all that the problem has; the
    conditions under which the motion comes there."""

    time: Scalar | None
    places: Mapping[str, Scalar]
    speeds: Mapping[str, Scalar]
    valid: tuple[Demand, ...] = ()

    @property
    def image(self) -> dict[str, Scalar]:
        """What stands for coordinates, speeds and time."""
        return {**self.places, **by_letters(self.speeds), **({} if self.time is None else {"t": self.time})}


def value_in(study: Study, value: Scalar, state: ArrivalState) -> Scalar:
    """What a value is in a state, accelerations and unknown forces too."""
    return short(substitute(study.begun(value), state.image))


def at_start(study: Study, phase: Phase | None = None) -> ArrivalState:
    """Coordinates and speeds of the declared start, dependent ones too."""
    if study.instant is not None:
        return ArrivalState(NOTHING, study.instant.places, study.instant.speeds)
    start, places, speeds = study.system.scope.start, {}, {}
    for coordinate in study.problem.coordinates:
        name = coordinate.name
        value, rate = of_coordinate(study, name)
        places[name], speeds[name] = (short(substitute(part, start)) for part in (value, rate))
        _require_start(study, name, places[name], speeds[name])
    return ArrivalState(NOTHING, places, speeds)


def with_starts(study: Study) -> Problem:
    """The problem of a study with all starts that its conditions tell; as it is where one of them is open."""
    try:
        begun = at_start(study)
        told = {n: (present(begun.places[n]), present(begun.speeds[n])) for n in begun.places}
    except (StatementError, ZeroDivisionError):
        return study.problem
    coordinates = (replace(c, start=told[c.name][0], speed=told[c.name][1]) for c in study.problem.coordinates)
    return replace(study.problem, coordinates=tuple(coordinates))


def of_coordinate(study: Study, name: str) -> tuple[Scalar, Scalar]:
    """A coordinate and its speed in the independent ones."""
    value, rate = study.system.dependent.get(name, symbol(name)), study.system.scope.rates.get(name)
    return value, time_derivative(value, study.system.scope) if rate is None else rate


def _require_start(study: Study, name: str, *values: Scalar) -> None:
    names = {n for c in study.problem.coordinates for n in (c.name, f"{c.name}_dot")}
    if any(derivative(value, other) for value in values for other in names):
        raise StatementError(
            f"the phases need to know where “{name}” starts and how fast",
            instead=f'give [coordinates.{name}] a start = "..." and a speed = "...".',
            place=next(c.place for c in study.problem.coordinates if c.name == name),
        )


EDGE = 1e-9


def mover(study: Study, subject: str = "") -> str | None:
    """The one independent coordinate that changes, if the square of its speed is known; the others stay at rest, or their
    speeds follow from conserved momenta. Of several that change the subject, if its speed follows from its own place."""
    if study.kept_speeds:
        return next(iter(study.squares))
    moving = _moving(study)
    one = moving[0] if len(moving) == 1 else subject
    return one if one in moving and one in study.squares else None


def _moving(study: Study) -> list[str]:
    """The independent coordinates that change."""
    start, gains = study.system.scope.start, study.dynamics.accelerations or {}
    return [
        name
        for name in study.system.independent
        if name not in study.resting
        if start.get(f"{name}_dot", NOTHING) or not is_zero(gains.get(f"{name}_ddot", symbol(name)))
    ]


def state_at(study: Study, name: str, place: Scalar, sense: int = 0) -> ArrivalState:
    """All coordinates and speeds where the one that changes has a value, its speed from the first integral, in the `sense`
    in which it comes there (0: that at the sample numbers); a coordinate that is not known there is its own letter, and so is
    the speed of one that moves for itself."""
    there = sense or floating(place - study.system.scope.start[name], sample(study.problem))
    speed = positive_root(study, substitute(study.squares[name], {name: place})) * (-1 if there < 0 else 1)
    here = {**study.system.scope.start, name: place, f"{name}_dot": speed}
    apart = [key for other in _moving(study) if other != name and not study.kept_speeds for key in (other, f"{other}_dot")]
    here |= {key: symbol(key) for key in apart}
    here |= {other: symbol(other) for other in study.system.coordinates if study.ties and other != name}  # its tie may tell it
    for other, rate in study.kept_speeds.items():
        here[other.removesuffix("_dot")] = substitute(_followed(study, name, other), {name: place})
        here[other] = substitute(rate, {name: place, f"{name}_dot": speed})
    values = {c.name: of_coordinate(study, c.name) for c in study.problem.coordinates}
    places, speeds = ({n: short(substitute(pair[k], here)) for n, pair in values.items()} for k in (0, 1))
    return ArrivalState(None, places, speeds)


def followed(study: Study, name: str, other: str) -> Scalar | None:
    """A coordinate as a function of another one: by the speed that a kept momentum gives, or where both have accelerations and
    first speeds in one constant ratio; None where it is none."""
    start, gains = study.system.scope.start, study.dynamics.accelerations or {}
    if f"{other}_dot" in study.kept_speeds and mover(study) == name:
        found = _followed(study, name, f"{other}_dot")
        return None if names_in(found) & {other} else found
    first, second = (gains.get(f"{n}_ddot", NOTHING) for n in (name, other))
    if not {name, other} <= start.keys() or not first or study.ties:
        return None
    ratio = short(second / first)
    begun = start.get(f"{other}_dot", NOTHING) - ratio * start.get(f"{name}_dot", NOTHING)
    is_fixed = not names_in(ratio) & {*study.system.scope.rates, *study.system.speeds, "t"} and is_zero(begun)
    return short(start[other] + ratio * (symbol(name) - start[name])) if is_fixed else None


def _followed(study: Study, name: str, speed: str) -> Scalar:
    """A coordinate whose speed is that of the one that changes times a function of its place; else its own letter."""
    other, way = speed.removesuffix("_dot"), f"{name}_dot"
    rate = short(study.kept_speeds[speed] / symbol(way))
    gained = None
    if not names_in(rate) & {way, *study.system.scope.rates.keys()} - {name}:
        gained = definite(rate, name, study.system.scope.start[name], symbol(name))
    return symbol(other) if gained is None else study.system.scope.start[other] + gained


def first_met(study: Study, name: str, *gaps: Scalar, first: Iterable[Demand] = ()) -> tuple[Scalar, list[Demand], int] | None:
    """The first place on the way from the start at which one of the values vanishes, at the first sample numbers at which
    the motion begins as stated (`first`: what else is asked of its start) and comes to one, where it is the first, and the
    sense in which it comes; None if there is none in closed form.
    Raises NotApplicable where one without may come before."""
    first, square = tuple(first), study.squares[name]
    even = [without_even_roots(value) for value in (square, *gaps)]  # squares of roots may hide a zero
    found = _first_met(study, name, (square, *gaps), first)
    return _first_met(study, name, even, first) if found is None and even != [square, *gaps] else found


def _first_met(
    study: Study, name: str, values: Sequence[Scalar], first: Iterable[Demand]
) -> tuple[Scalar, list[Demand], int] | None:
    """The same; of the values, the first one is the square of the speed."""
    square, *gaps = values
    start, is_open = study.system.scope.start[name], False
    is_pushed = is_zero(study.system.scope.start.get(f"{name}_dot", NOTHING))  # from rest it goes as the forces want
    begun, drive = begins(study) if is_pushed else (), _drive(study, name)
    inwards = inward(start, study.assumptions.range_of(name)) if is_zero(drive) else 0
    for numbers in samples(study.problem):
        if any(floating(demand.value, numbers) < 0 for demand in begun):
            continue
        way = Way(name, start, inwards or (-1 if floating(drive, numbers) < 0 else 1), square)
        factors = [factor for gap in gaps for factor in factors_in(gap, name)]
        known = (place for factor in factors for place in places_ahead(factor, way, study.assumptions))
        ahead = [item for place in known if (item := (floating(way.ahead(place), numbers), place))[0] > EDGE]
        place = min(ahead, key=lambda item: item[0])[1] if ahead else None
        found = None if place is None else _conditions(study, way, place, tuple(gaps), numbers)
        asked = None if found is None else [*first, *found]
        if place is not None and asked is not None and all(one.op == "!=" or floating(one.value, numbers) >= 0 for one in asked):
            told = settle(asked, study.assumptions)
            if told is not None:
                return neat(place, assuming(study.assumptions, told)), asked, way.sense
        is_open = is_open or (place is not None and asked is None)
    if is_open:
        what = "is not decided: the speed may vanish before, at a place that was not found"
        raise NotApplicable(f"whether “{name}” comes so far {what}")
    return None


def _conditions(study: Study, way: Way, place: Scalar, gaps: tuple[Scalar, ...], numbers: Numbers) -> list[Demand] | None:
    """Under which the place is the first; None where what has no root in closed form may vanish before."""
    there = neat(substitute(way.square, {way.name: place}), study.assumptions)
    comes = (way.ahead(place), _drive(study, way.name) * way.sense, there)
    asked = [*existence(place), *_first_turn(study, way), *(Demand(value) for value in comes if not is_zero(value))]
    if (told := settle(asked, study.assumptions)) is None:
        return asked
    given = assuming(study.assumptions, told)
    between, known = way.until(place, given), {demand.value for demand in asked if demand.op != "!="}.__contains__
    for value in (way.square, *gaps):
        for factor in () if sign(value, between).is_nonzero else factors_in(value, way.name):
            if sign(factor, between).is_nonzero or sign_along(factor, way.name, between, known):
                continue
            if not factor_zeros(factor, way.name, given):
                return None
            others = (other for other in places_ahead(factor, way, given) if not is_zero(other - place))
            asked += [demand for other in others for demand in _not_before(way, place, other, given, numbers)]
    return asked


def _first_turn(study: Study, way: Way) -> list[Demand]:
    """What repeats itself with each turn starts in the first one, if nothing is declared of its start."""
    first = next(iter(names_in(way.start)), "")
    is_open = first in study.problem.implicit and study.assumptions.range_of(first) == (None, None)
    turns = is_open and way.start == symbol(first) and period(way.square, way.name)
    return [Demand(PI + way.start), Demand(PI - way.start)] if turns else []


def _not_before(way: Way, place: Scalar, other: Scalar, given: Assumptions, numbers: Numbers) -> Iterator[Demand]:
    """Under which condition another root is not met before the place: as it is at these numbers, where that is not sure."""
    later = way.ahead(other) - way.ahead(place)
    if settle([*existence(other), Demand(way.ahead(other)), Demand(-later)], given) is None:
        return
    found = floating(way.ahead(other), numbers)
    if found == found:
        yield Demand(later if found > EDGE else -way.ahead(other), ">=")
    for demand in existence(other) if found != found else ():
        if demand.op == ">" and not floating(demand.value, numbers) > 0:
            yield Demand(-demand.value)


def inward(begin: Scalar | None, ends: tuple[Scalar | None, Scalar | None]) -> int:
    """The sense that leads into the range of a coordinate that starts at an end of it; 0 if it does not."""
    if begin is None:
        return 0
    return next((s for s, end in zip((1, -1), ends, strict=True) if end is not None and is_zero(end - begin)), 0)


def _drive(study: Study, name: str) -> Scalar:
    """The speed at the start, or the acceleration from rest."""
    start = study.system.scope.start
    speed = start.get(f"{name}_dot", NOTHING)
    return speed if not is_zero(speed) else substitute((study.dynamics.accelerations or {}).get(f"{name}_ddot", NOTHING), start)


def positive_root(study: Study, value: Scalar) -> Scalar:
    """The square root, with what is declared positive taken out."""
    value = short(value)
    return root_of(neat(value, study.assumptions) if has_roots(value) else value, study.assumptions)
