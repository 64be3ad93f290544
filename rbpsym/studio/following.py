"""Where an equation along a motion fails: the motion from its start as power series in the time, at points of the parameters.

The equations of motion give one coefficient after the other, each enclosed by fractions (`decide.series`). An equation that
holds along the motion has the same series on both sides, so that a coefficient that surely differs refutes it. Of a place (a
rest, the end of a contact) only the state itself is known.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from itertools import islice
from math import factorial

from rbpsym.decide import enclosure as e
from rbpsym.decide import series
from rbpsym.decide.enclosure import Number, Outside
from rbpsym.decide.points import Point, angle_name, angle_parts, points
from rbpsym.decide.series import Series
from rbpsym.decide.verdict import Verdict, Witness, refuted, undecided
from rbpsym.errors import RbpsymError
from rbpsym.field import NOTHING, ONE, UNITY, Poly, Scalar, atoms, cosine, is_zero, names_in, root, substitute, symbol
from rbpsym.field.poly import Monomial
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study
from rbpsym.quantity.path import Path, path_of, sense
from rbpsym.quantity.problem import ProblemWorld

LENGTH, POINTS, MOST = 5, 2, 24
Gap = tuple[Scalar, Scalar]
Known = Mapping[str, Scalar]


class Following(Frozen):
    """A motion, or a place of it: from where it starts (`begins`), how it goes on (`rates`), and what is known of other names."""

    begins: Known
    rates: Known
    known: Known
    length: int = LENGTH

    def values(self) -> list[Scalar]:
        """What must have a value at a point of the parameters."""
        inner = [*self.begins.values(), *self.known.values()]
        return [substitute(value, self.begins) for value in inner]


class FollowedPoint(Frozen):
    """A course at one point of the parameters; `state`: the series of what moves, as far as they are known."""

    course: Following
    point: Point
    state: Mapping[str, Series]
    length: int
    found: dict[str | int, Series] = field(default_factory=dict)

    def value(self, value: Scalar) -> Series:
        """The series of a value. Raises Outside where it has none."""
        above = self._poly(value.num)
        return above if value.den is ONE else series.product(above, series.reciprocal(self._poly(value.den)))

    def _poly(self, poly: Poly) -> Series:
        total = series.constant(Fraction(0), self.length)
        for monomial, coefficient in poly.terms.items():
            term = series.constant(Fraction(coefficient), self.length)
            for index, exponent in monomial:
                term = series.product(term, series.power(self._atom(index), exponent))
            total = series.added(total, term)
        return total

    def _atom(self, index: int) -> Series:
        if index not in self.found:
            kind, arg = atoms.atom(index).kind, atoms.atom(index).arg
            if kind == "symbol":
                self.found[index] = self._named(arg)
            elif kind in ("cos", "sin"):
                self.found[index] = self._turn(arg)[kind == "sin"]
            elif kind in series.FUNCTIONS:
                self.found[index] = series.FUNCTIONS[kind](self.value(arg))
            else:
                raise Outside("a function of which no series is known")
        return self.found[index]

    def _named(self, name: str) -> Series:
        """What moves; what is known of a name by others; else a parameter, which has its number at the point."""
        if name in self.state:
            return self.state[name]
        if name in self.course.known:
            if name not in self.found:
                self.found[name] = ()  # being asked for
                self.found[name] = self.value(self.course.known[name])
            if self.found[name]:
                return self.found[name]
        if name != "pi" and name not in self.point.numbers and name not in self.point.angles:
            raise Outside(f"it is not known what {name} is on the motion")
        return series.constant(e.pi() if name == "pi" else self.point.symbol(name), self.length)

    def _turn(self, angle: Poly) -> tuple[Series, Series]:
        """(cos, sin) of an angle, exact at the start where that is a multiple of angles of the point."""
        start = substitute(Scalar(angle), {**self.course.known, **self.course.begins})
        is_whole = start.den is ONE and all(self._is_multiple(m, c) for m, c in start.num.terms.items())
        grown = self._poly(angle)
        return series.turn(self.point.turn(start.num) if is_whole else e.turn_of(grown[0]), grown)

    def _is_multiple(self, monomial: Monomial, coefficient: Fraction | int) -> bool:
        name = angle_name(monomial)
        return name is None or name not in self.point.angles or (coefficient * self.point.parts[name]).denominator == 1


def followed(course: Following, point: Point) -> FollowedPoint:
    """The course at a point. Raises Outside, or a LookupError for a name or an order that is not known."""
    now = FollowedPoint(course, point, {}, 1)
    now = FollowedPoint(course, point, {name: now.value(value) for name, value in course.begins.items()}, 1)
    for length in range(2, course.length + 1):
        grown = {n: now.value(course.rates.get(n, NOTHING))[length - 2] * Fraction(1, length - 1) for n in now.state}
        now = FollowedPoint(course, point, {name: (*known, grown[name]) for name, known in now.state.items()}, length)
    return now


def motion(study: Study, letters: Known) -> Following | None:
    """The motion from its start; None where it is not known that the start fulfils the conditions that tie coordinates."""
    system, start = study.system, study.system.scope.start
    if not study.at_start and any(not is_zero(substitute(tie.value, start)) for tie in study.ties):
        return None
    begins = {name: start.get(name, symbol(name)) for name in system.scope.rates} | {"t": NOTHING}
    known = {**letters, **solved(study)}
    return Following(begins, {**system.scope.rates, "t": UNITY}, known, 1 if study.at_start else LENGTH)


def solved(study: Study) -> Known:
    """Accelerations, unknown forces and what is tied, by their names."""
    found = study.solved
    return {**study.system.tied(), **(found.accelerations or {}), **found.reactions}


def way(study: Study, letters: Known) -> Following | None:
    """A state on the way of one coordinate that leaves a rest, of which the motion from there tells nothing; None of others."""
    system, start = study.system, study.system.scope.start
    names, still = ([name for name, square in study.squares.items() if bool(square) is moves] for moves in (True, False))
    resting = {name: start[name] for one in still for name in (one, f"{one}_dot") if name in start} | dict(study.resting)
    if len(names) != 1 or study.has_clock or not {f"{n}_dot" for n in system.independent} <= {*resting, f"{names[0]}_dot"}:
        return None
    speed = root(study.squares[names[0]]) * sense(ProblemWorld(study).motion, names[0])
    begins = {**resting, names[0]: symbol(names[0]), f"{names[0]}_dot": speed}
    return Following(begins, system.scope.rates, {**letters, **solved(study)}) if speed else None


def is_at_rest(seen: FollowedPoint) -> bool:
    """Does nothing move in it?"""
    return not any(any(known[1:]) for name, known in seen.state.items() if name != "t")


def places(study: Study, told: Iterable[Known], letters: Known) -> Iterator[Following]:
    """The states at places of which the derivation tells: with either sense of the speeds that the motion has there."""
    start = {name: value for name, value in study.system.scope.start.items() if not name.endswith("_dot")}
    for at in told:
        there = {name: at.get(name, start.get(name, symbol(name))) for name in study.system.coordinates}
        for side in (1, -1):
            speeds = {f"{name}_dot": substitute(root(square) * side, there) for name, square in study.squares.items()}
            yield Following({**there, **speeds}, {}, {**letters, **solved(study)}, 1)


def rests(study: Study, equilibria: Iterable[Equilibrium], letters: Known) -> Iterator[Following]:
    """The positions of rest."""
    speeds = {name: NOTHING for name in study.system.scope.rates if name.endswith("_dot")}
    for one in equilibria:
        there = {name: one.at.get(name, symbol(name)) for name in study.system.coordinates}
        yield Following({**there, **speeds}, {}, {**letters, **solved(study)}, 1)


def looks(course: Following, study: Study, path: Path | None = None) -> Iterator[FollowedPoint]:
    """The course at a few points that the declared signs and ranges admit, so that it stays in the ranges as it sets out."""
    told = [*course.values(), *(symbol(q.name) for q in study.problem.parameters)]
    told = [value for value in told if names_in(value)]
    halves = [cosine(Scalar(symbol(name).num) * Fraction(1, 2 * parts)) for name, parts in angle_parts(told).items()]
    for point in points([*told, *halves], study.assumptions, MOST):
        with suppress(Outside, LookupError, ZeroDivisionError):
            seen = followed(course, point)
            met = path is None or path.holds(point)
            if met and all(_stays(name, seen, study) for name in course.begins):
                yield seen


def _stays(name: str, seen: FollowedPoint, study: Study) -> bool:
    """Does it not leave its declared range at once?"""
    lower, upper = study.assumptions.range_of(name)
    ends = [symbol(name) - lower] if lower is not None else []
    ends += [upper - symbol(name)] if upper is not None else []
    return all(next(filter(None, map(e.sign_of, seen.value(gap))), 1) == 1 for gap in ends)


def failing(pairs: Iterable[Gap], seen: list[FollowedPoint]) -> Verdict:
    """REFUTED at the first point at which the sides of one of the pairs have different series; else the key of a reason."""
    reason = "nowhere" if seen else "no_state"
    for a, b in pairs:
        for look in seen:
            try:
                left, right = look.value(a), look.value(b)
            except (Outside, RbpsymError, ZeroDivisionError) as error:
                reason = "no_state" if isinstance(error, ZeroDivisionError) else str(error)
                continue
            order = next((k for k, (x, y) in enumerate(zip(left, right, strict=False)) if e.are_disjoint(x, y)), None)
            if order is not None:
                return refuted("the sides differ on the motion", _witness(look.point, left[order], right[order], order))
    return undecided(reason)


def _witness(point: Point, left: Number, right: Number, order: int) -> Witness:
    parts = {name: "" if part == 1 else f"/{part}" for name, part in point.parts.items()}
    circle = tuple((f"{name}{parts[name]}", *pair) for name, pair in point.angles.items())
    whose = f"rates of change at the start, of order {order}" if order else ""
    return Witness(tuple(point.numbers.items()), circle, left * factorial(order), right * factorial(order), whose)


def first_looks(course: Following | None, study: Study) -> list[FollowedPoint]:
    """The first few; none of a course that is not known."""
    return list(islice(looks(course, study), POINTS)) if course is not None else []


def motion_looks(study: Study, letters: Known) -> list[FollowedPoint]:
    """The first few of the motion from its start; on its way, where it starts from a rest."""
    found = first_looks(motion(study, letters), study)
    course = way(study, letters) if found and all(map(is_at_rest, found)) else None
    if course is None:
        return found
    path = path_of([symbol(name) for name in study.squares], ProblemWorld(study).motion)
    return [*found, *islice(looks(course, study, path), POINTS)]
