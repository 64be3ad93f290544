"""A student's numbers: drawn so that the motion takes place and its results are reasonable.

Conditions are quantities that must be positive: at the start and the frequencies, along the way from the
start to the place that is asked about (it gets there, it keeps contact, friction is enough).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from rbpsym.errors import RbpsymError
from rbpsym.field import NOTHING, Scalar, calculus, is_zero, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.motion import along_motion
from rbpsym.mechanics.study import Study
from rbpsym.quantities import LENGTH, NUMBER
from rbpsym.statement.model import Coordinate
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.compiled import Evaluate, compiled
from rbpsym.teaching.model import Measure
from rbpsym.teaching.ranges import NumberRange, conditions, default_ranges, middles, named_quantities, si, step_near

MOST_DRAWS = 600
WAY = (0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)  # shares of the way that are looked at
SLOWEST, FASTEST = 0.15, 3.0  # Hz: what a class can count or time
SMALLEST = 1e-9
HALVINGS, TRIALS = 6, 40


def _measure_near(start: float, ahead: float, is_angle: bool) -> Measure:
    """A round number near start + ahead: whole degrees (tenths for small ways), three figures of a length."""
    if is_angle:
        step = Fraction(1) if abs(math.degrees(ahead)) > 4 else Fraction(1, 10)
        return Measure(Fraction(round(math.degrees(start + ahead) / float(step))) * step, "deg")
    step = step_near(Fraction(abs(ahead)))
    return Measure(Fraction(round((start + ahead) / float(step))) * step, "m")


class Situation(Frozen):
    """given: the printed numbers of the constants; place: the printed coordinate where it is looked at
    (None if nothing is asked along a way); numbers: all in SI units, for evaluation."""

    given: Mapping[str, Measure]
    place: tuple[str, Measure] | None
    numbers: Mapping[str, float]

    @property
    def printed(self) -> dict[str, Measure]:
        """All numbers that stand on the paper, in its order."""
        return {**self.given, **self.places}

    @property
    def places(self) -> dict[str, Measure]:
        """The place by its name; none where nothing is asked along a way."""
        return dict([self.place]) if self.place else {}


class Scenery(Frozen):
    """What numbers a problem takes: ranges of its constants, the coordinate along which it is followed.

    `ranges` of the coordinate itself may be wished for by its name. `still` and `along` are evaluated values that
    must be positive, with what they mean; `along` holds on the whole way.
    """

    study: Study
    ranges: Mapping[str, NumberRange]
    coordinate: str | None
    wished: NumberRange | None
    still: tuple[tuple[str, Scalar], ...]
    along: tuple[tuple[str, Scalar], ...]
    evaluate_still: Evaluate = field(compare=False, repr=False)
    evaluate_along: Evaluate = field(compare=False, repr=False)
    start: Evaluate = field(compare=False, repr=False)

    def situations(self, draws: Draws) -> Iterator[Situation]:
        """Situations in which all conditions hold, one after another. Raises RbpsymError if there are hardly any."""
        failed: dict[str, int] = {}
        for _ in range(MOST_DRAWS):
            given = {name: self.ranges[name].draw(draws) for name in self.ranges}
            numbers = {name: si(measure) for name, measure in given.items()}
            still = zip(self.still, self.evaluate_still(numbers), strict=True)
            reason = next((what for (what, _), value in still if not value > SMALLEST), "")
            place = None if reason or self.coordinate is None else self.placed(self.coordinate, draws, numbers)
            reason = place if isinstance(place, str) else reason
            if reason or isinstance(place, str):
                failed[reason] = failed.get(reason, 0) + 1
                continue
            if place is not None:
                numbers[place[0]] = si(place[1])
            yield Situation(given, place, numbers)
        worst = max(failed, key=failed.__getitem__, default="print")
        raise RbpsymError(
            f"no fitting numbers were found for “{self.study.problem.name}” in {MOST_DRAWS} draws: {REASONS[worst]}",
            instead="give other ranges under [problem.numbers], or ask for fewer things.",
        )

    def placed(self, coordinate: str, draws: Draws, numbers: dict[str, float]) -> tuple[str, Measure] | str:
        """A place that is reached, nearer and nearer to the start; else what is in the way of it."""
        start, speed, push = self.start(numbers)
        way = math.copysign(1.0, speed if abs(speed) > SMALLEST else push)
        if not math.isfinite(start) or not math.isfinite(way):
            return "way"
        reason = "way"
        for measure in self._places(draws, start, way, numbers):
            reason = self._obstacle(numbers, coordinate, start, si(measure), way)
            if not reason:
                return coordinate, measure
        return reason

    def _obstacle(self, numbers: dict[str, float], coordinate: str, start: float, end: float, way: float) -> str:
        if (end - start) * way <= 0:
            return "way"
        shares = (self.evaluate_along({**numbers, coordinate: start + share * (end - start)}) for share in WAY)
        looks = (pair for values in shares for pair in zip(self.along, values, strict=True))
        return next((what for (what, _), value in looks if not value > SMALLEST), "")

    def _places(self, draws: Draws, start: float, way: float, numbers: Mapping[str, float]) -> Iterator[Measure]:
        """Where it may be looked at: as wished, or a part of the room that there is, halved again and again."""
        if self.wished is not None:
            yield self.wished.draw(draws)
            return
        coordinate = next(c for c in self.study.problem.coordinates if c.name == self.coordinate)
        share = (20 + draws.below(61)) / 100
        is_angle = coordinate.quantity.dimension == NUMBER
        whole = share * min(1.9 if is_angle else 2.0, self._room(coordinate, start, way, numbers))
        for halvings in range(HALVINGS if whole > SMALLEST else 0):
            yield _measure_near(start, way * whole / 2**halvings, is_angle)

    def _room(self, coordinate: Coordinate, start: float, way: float, numbers: Mapping[str, float]) -> float:
        """How far the declared range lets it go."""
        bound = coordinate.upper if way > 0 else coordinate.lower
        if bound is None:
            return math.inf
        [end] = compiled([scalar(bound)])(numbers)
        return abs(end - start) if math.isfinite(end) else math.inf


# condition -> what was wrong, in words
REASONS: Mapping[str, str] = {
    "mass": "a mass or a moment of inertia would not be positive",
    "begin": "the motion would not begin as it is stated, or not come to all phases and to what is asked",
    "order": "sizes would not fit each other",
    "friction": "friction would not be enough",
    "frequency": f"an oscillation would be slower than {SLOWEST} Hz or faster than {FASTEST} Hz",
    "way": "the place that is asked about would not be reached from the start, or contact would be lost before",
    "print": "the right answer would look like a wrong one in print",
}


def scenery(study: Study, wishes: Mapping[str, NumberRange], is_timed: bool, ends: Mapping[str, Scalar]) -> Scenery:
    """The scenery of a problem; `wishes` are ranges by name; `is_timed`: an oscillation is to be measured; `ends`: where the
    next phase begins, by coordinate."""
    names = named_quantities(study.problem)
    ranges = {**default_ranges(study), **{n: r for n, r in wishes.items() if n in names}}
    coordinate = followed(study)
    if coordinate is not None and coordinate not in wishes and not _gets_anywhere(study, ranges, coordinate, ends):
        coordinate = None
    return _scenery(study, ranges, coordinate, ends, wishes.get(coordinate or ""), is_timed)


def _gets_anywhere(study: Study, ranges: Mapping[str, NumberRange], coordinate: str, ends: Mapping[str, Scalar]) -> bool:
    """Whether it leaves its start at all in some of the drawn situations."""
    trial, draws = _scenery(study, ranges, coordinate, ends), Draws(b"trial", study.problem.name)
    drawn = ({name: si(range_.draw(draws)) for name, range_ in ranges.items()} for _ in range(TRIALS))
    return any(not isinstance(trial.placed(coordinate, draws, numbers), str) for numbers in drawn)


def _scenery(
    study: Study,
    ranges: Mapping[str, NumberRange],
    coordinate: str | None,
    ends: Mapping[str, Scalar],
    wished: NumberRange | None = None,
    is_timed: bool = False,
) -> Scenery:
    sizes = (*_sound(study), *_ordered(study, ranges), *_begun(study))
    still = (*_held_in_the_middle(sizes, ranges), *(_measurable(study, ranges) if is_timed else ()))
    along = () if coordinate is None else tuple(_kept(study, coordinate, ends))
    return Scenery(
        study,
        ranges,
        coordinate,
        wished,
        still,
        along,
        compiled([value for _, value in still]),
        compiled([value for _, value in along]),
        _start(study, coordinate),
    )


def followed(study: Study) -> str | None:
    """The coordinate along which the motion is known from its start: the first whose speed is a function of it alone."""
    given, start = {*named_quantities(study.problem)}, study.system.scope.start
    squares = ((name, names_in(square)) for name, square in study.squares.items() if not is_zero(square) and name in start)
    return next((name for name, names in squares if {name} <= names <= {name, *given}), None)


def names_in(value: Scalar) -> frozenset[str]:
    """All symbols of a value, also those inside of functions (π aside)."""
    return calculus.names_in(value) - {"pi"}


def _held_in_the_middle(
    conditions: tuple[tuple[str, Scalar], ...], ranges: Mapping[str, NumberRange]
) -> list[tuple[str, Scalar]]:
    """Those that the middle of the ranges keeps; another (a pulley without mass) is what the author wants."""
    values = compiled([value for _, value in conditions])(middles(ranges))
    return [condition for condition, value in zip(conditions, values, strict=True) if value > SMALLEST]


def _sound(study: Study) -> Iterator[tuple[str, Scalar]]:
    for state in study.system.bodies.values():
        for value in (state.mass, state.moment):
            if value and names_in(value) <= set(named_quantities(study.problem)):
                yield "mass", value


def _begun(study: Study) -> Iterator[tuple[str, Scalar]]:
    """It begins as it is stated, and comes to all phases and to what is asked."""
    known = {*named_quantities(study.problem)}
    yield from (("begin", demand.value) for demand in conditions(study) if names_in(demand.value) <= known)


def _ordered(study: Study, ranges: Mapping[str, NumberRange]) -> Iterator[tuple[str, Scalar]]:
    """Lengths keep the order that they have in the example (a hole stays smaller than its disk)."""
    lengths = [q.name for q in study.problem.parameters if q.dimension == LENGTH and q.sign == "positive"]
    middle = middles(ranges)
    pairs = ((one, other) for one in lengths for other in lengths if middle[one] < middle[other])
    yield from (("order", symbol(other) - symbol(one)) for one, other in pairs)


def _measurable(study: Study, ranges: Mapping[str, NumberRange]) -> Iterator[tuple[str, Scalar]]:
    """4π²·f² within the bounds, if the middle of the ranges lies there (else what the author wants is followed)."""
    known = set(named_quantities(study.problem))
    middle = middles(ranges)
    for place in study.equilibria:
        for square in place.frequencies_squared if place.stable else ():
            low, high = (Fraction(round((2 * math.pi * f) ** 2, 6)) for f in (SLOWEST, FASTEST))
            if names_in(square) <= known and float(low) < compiled([square])(middle)[0] < float(high):
                yield "frequency", square - low
                yield "frequency", high - square


def _kept(study: Study, coordinate: str, ends: Mapping[str, Scalar]) -> Iterator[tuple[str, Scalar]]:
    """The speed along the way, the way that is left in this phase, forces that can only push, and friction that suffices."""
    known, start = {coordinate, *named_quantities(study.problem)}, study.system.scope.start[coordinate]
    yield "way", study.squares[coordinate]
    if coordinate in ends and names_in(ends[coordinate]) <= known:
        yield "way", (ends[coordinate] - symbol(coordinate)) * (ends[coordinate] - start)
    forces = study.reactions_along_motion or {}
    for element in study.problem.constraints:
        for name in pushes(element):
            if name in forces and names_in(forces[name]) <= known and names_in(forces[name]):
                yield "way", forces[name]
    for need in study.friction_needs:
        if need.limit is not None:
            for spare in (need.limit - need.ratio, need.limit + need.ratio):
                if names_in(spare) <= known and not is_zero(spare):  # it may be given that friction just suffices
                    yield "friction", spare


def _start(study: Study, coordinate: str | None) -> Evaluate:
    """(place, speed, acceleration) of the coordinate at the start."""
    if coordinate is None:
        return lambda numbers: [math.nan] * 3
    start = study.system.scope.start
    push = along_motion((study.dynamics.accelerations or {})[f"{coordinate}_ddot"], study.squares)
    assert push is not None, coordinate
    speed = start.get(f"{coordinate}_dot", NOTHING)
    return compiled([start[coordinate], speed, substitute(push, {coordinate: start[coordinate]})])
