"""Where a contact is lost: the first zero of its normal force along the motion, in the sense of the motion.

A zero counts if it exists, lies ahead and within the range, if the motion comes there (the square of the speed is
positive up to it), if the force goes through zero there, and if no one-sided force or limit of friction gives way
before. What of this depends on parameters is the condition under which the contact is lost there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.field import NOTHING, PI, Scalar, atoms, depends_on, derivative, is_zero, short, substitute
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.demands import Demand, assuming, existence, settle, turned
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.friction import geometry_of, spare
from rbpsym.mechanics.interactions import LAWS
from rbpsym.mechanics.roots import factor_zeros, factors_in, period
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element
from rbpsym.statement.paths import tensions

TURNS = 4  # so many to each side


class Loss(Frozen):
    """`force` vanishes where `factor` does, under the conditions `valid`; `at` are the places in closed form."""

    force: str
    factor: Scalar
    at: Mapping[str, Scalar]
    coordinate: str
    valid: tuple[Demand, ...] = ()


class Losses(Frozen):
    """The losses that come first; whether there is no other, and why that is not decided (complete: None); `open_` are
    those of which it is not decided whether they happen."""

    found: tuple[Loss, ...] = ()
    complete: bool | None = True
    reason: str = ""
    open_: tuple[Loss, ...] = ()


class Way(Frozen):
    """How one coordinate moves from its start: in a sense, with the square of its speed; `asked`: where it does so."""

    name: str
    start: Scalar
    sense: int
    square: Scalar
    asked: tuple[Demand, ...] = ()

    def ahead(self, place: Scalar) -> Scalar:
        """How far ahead of the start a place is."""
        return (place - self.start) * self.sense

    def until(self, place: Scalar, given: Assumptions) -> Assumptions:
        """The coordinate lies between the start and a place."""
        ends = (self.start, place) if self.sense > 0 else (place, self.start)
        return given.with_range(self.name, *ends)


def pushes(element: Element) -> tuple[str, ...]:
    """The unknown forces of an element that can push (or pull) only: normal forces, tensions."""
    if not JOINTS[element.kind].is_one_sided or element.values.get("rigid") or element.values.get("held"):
        return ()
    return tensions(element) if element.kind == "string" else (element.name,)


def losses(
    system: System,
    dynamics: Dynamics,
    along: Mapping[str, Scalar] | None,
    squares: Mapping[str, Scalar],
    given: Assumptions,
) -> Losses:
    """The contacts that end during the motion from the start."""
    known = dynamics.reactions if along is None else along
    forces = {name: known[name] for e in system.problem.constraints for name in pushes(e) if name in known}
    forces = {name: value for name, value in forces.items() if sign(value, given).kind != "positive"}
    if not forces:
        return Losses()
    if along is None or system.implicit:
        return Losses((), None, "the forces are not known as functions of the position alone")
    names = {n for value in forces.values() for n in (*system.coordinates, "t") if depends_on(value, n)}
    if len(names) != 1 or not names <= squares.keys() & system.scope.start.keys():
        return Losses((), None, _why_open(names))
    [name] = names
    first = atoms.symbol_name(next(iter(system.scope.start[name].atoms()), 0))
    if first in system.problem.implicit and given.range_of(first) == (None, None) and period(squares[name], name):
        given = given.with_range(first, -PI, PI)  # what repeats itself with each turn may start in the first
    held = [*forces.values(), *_grips(system, along)]
    return _joined([_to_and_fro(way, forces, held, given) for way in ways(system, dynamics, name, squares[name], given)])


def _why_open(names: set[str]) -> str:
    """Why places at which forces vanish are not looked for; `names` is what the forces depend on."""
    if not names:
        return "a force is constant, and its sign depends on the parameters"
    if names == {"t"}:
        return "the forces are functions of the time alone"
    return "several coordinates move" if len(names) > 1 else "the speed is not known as a function of the position"


def _grips(system: System, along: Mapping[str, Scalar]) -> Iterator[Scalar]:
    """What stays positive as long as friction stays below its limits."""
    for element in system.problem.constraints:
        yield from spare(element, along.__getitem__)


def ways(system: System, dynamics: Dynamics, name: str, square: Scalar, given: Assumptions) -> list[Way]:
    """The senses in which a coordinate may start: that of its speed, or from rest that of its acceleration."""
    start, gains = system.scope.start, dynamics.accelerations or {}
    speed = start.get(f"{name}_dot", NOTHING)
    drive = speed if not is_zero(speed) else substitute(gains.get(f"{name}_ddot", NOTHING), start)
    ends = zip((1, -1), reversed(given.range_of(name)), strict=True)
    room = [side for side, end in ends if end is None or not is_zero(end - start[name])]
    if is_zero(drive):  # it leaves a place of rest: to either side where there is room
        return [Way(name, start[name], side, square) for side in room]
    asked = {side: settle([Demand(drive * side)], given) for side in room}
    return [Way(name, start[name], side, square, found) for side, found in asked.items() if found is not None]


def ways_of(system: System, dynamics: Dynamics, value: Scalar, squares: Mapping[str, Scalar], given: Assumptions) -> list[Way]:
    """The ways that are surely taken by the only coordinate of which a value is a function; none if there are several."""
    names = {n for n in (*system.coordinates, "t") if depends_on(value, n)}
    if len(names) != 1 or system.implicit or not names <= squares.keys() & system.scope.start.keys():
        return []
    [name] = names
    found = ways(system, dynamics, name, squares[name], given)
    return found if len(found) == 1 and not found[0].asked else []


def vanishes_before(way: Way, along: Mapping[str, Scalar], normal: str, other: str, given: Assumptions) -> bool:
    """Whether the motion surely comes to where a normal force vanishes while another force does not."""
    places = [place for factor in factors_in(along[normal], way.name) for place in places_ahead(factor, way, given)]
    ends = given.range_of(way.name)
    return any(
        not any(end is not None and is_zero(place - end) for end in ends)
        and all(settle([demand], given) == () for demand in (*existence(place), Demand(way.ahead(place))))
        and sign(way.square, way.until(place, given)).kind == "positive"
        and sign(short(substitute(along[other], {way.name: place})), given).is_nonzero
        for place in places
    )


def _joined(parts: list[Losses]) -> Losses:
    first = next((part for part in parts if part.complete is not True), Losses())
    found, open_ = [loss for part in parts for loss in part.found], [loss for part in parts for loss in part.open_]
    return Losses(tuple(found), first.complete, first.reason, tuple(x for k, x in enumerate(open_) if x not in open_[:k]))


def _to_and_fro(way: Way, forces: Mapping[str, Scalar], held: list[Scalar], given: Assumptions) -> Losses:
    """What is lost on the way; where the motion may turn round, the list is whole only if nothing can be lost behind the
    start, to where it then comes."""
    found, end = _on_way(way, forces, held, given), given.range_of(way.name)[way.sense > 0]
    if _is_driven_from_rest(way):
        return found
    if found.complete is not True or sign(way.square, given if end is None else way.until(end, given)).kind == "positive":
        return found
    back = _on_way(replace(way, sense=-way.sense), forces, held, given)
    each = [[settle(first.valid, assuming(given, loss.valid)) == () for first in found.found] for loss in back.found]
    if back.complete is True and all(map(any, each)):  # what would be lost there is lost before it turns
        return found
    why = "the motion may turn round, and whether a contact is lost behind its start is not decided"
    return replace(found, complete=None, reason=why)


def _is_driven_from_rest(way: Way) -> bool:
    """Whether the speed is zero at the start and grows from there: behind it the square of the speed would be negative."""
    there = {way.name: way.start}
    slope = derivative(way.square, way.name)
    return is_zero(substitute(way.square, there)) and not is_zero(substitute(slope, there))


def _on_way(way: Way, forces: Mapping[str, Scalar], held: list[Scalar], given: Assumptions) -> Losses:
    found, open_, reasons, given = list[Loss](), list[Loss](), list[str](), assuming(given, way.asked)
    for force, value in forces.items():
        for factor in factors_in(value, way.name):
            if not factor_zeros(factor, way.name, given) and not _is_clear(factor, way, given):
                surely = _changes_sign(way, value, factor, held, given)
                (found if surely else open_).append(Loss(force, factor, {}, way.name))
                reasons += [] if surely else [f"no closed form was found for where {force} vanishes"]
            for place in places_ahead(factor, way, given):
                try:
                    valid = _asked(way, place, value, held, given)
                except ZeroDivisionError:
                    open_.append(Loss(force, factor, {way.name: place}, way.name, way.asked))
                    reasons.append(f"where {force} vanishes something else has no value")
                    continue
                if valid is None or any(_is_behind(place, loss, way, assuming(given, valid)) for loss in found):
                    continue
                first = _comes_first(way, place, held, assuming(given, valid))
                (found if first else open_).append(Loss(force, factor, {way.name: place}, way.name, (*way.asked, *valid)))
                reasons += [] if first else [f"it is not decided whether the motion comes to a zero of {force} first"]
    return Losses(tuple(found), None if reasons else True, "; ".join(dict.fromkeys(reasons)), tuple(open_))


def _is_behind(place: Scalar, loss: Loss, way: Way, given: Assumptions) -> bool:
    """Whether a loss that comes first is certain wherever the motion would come to a later place."""
    early = loss.at.get(way.name)
    asked = [] if early is None else [Demand(way.ahead(place) - way.ahead(early)), *loss.valid]
    return bool(asked) and settle(asked, given) == ()


def _changes_sign(way: Way, force: Scalar, factor: Scalar, held: list[Scalar], given: Assumptions) -> bool:
    """Whether the motion goes on to the end of the range, where the force has the other sign, and all others keep theirs."""
    end = given.range_of(way.name)[way.sense > 0]
    if end is None or way.asked:
        return False
    between, others = way.until(end, given), [value for value in held if value is not force]
    sides = [sign(substitute(factor, {way.name: place}), given).kind for place in (way.start, end)]
    kept = [sign(value, between).kind == "positive" for value in (way.square, *others)]
    rest = sign(short(force / factor), between).kind
    return all(kept) and sides in (["positive", "negative"], ["negative", "positive"]) and rest == sides[0]


def _is_clear(factor: Scalar, way: Way, given: Assumptions) -> bool:
    lower, upper = given.range_of(way.name)
    end = upper if way.sense > 0 else lower
    return sign(factor, given if end is None else way.until(end, given)).is_nonzero


def places_ahead(factor: Scalar, way: Way, given: Assumptions) -> list[Scalar]:
    """The zeros of a factor that may lie ahead; the ends belong to the range."""
    found: list[Scalar] = []
    turn = period(factor, way.name)
    lower, upper = given.range_of(way.name)
    for root in factor_zeros(factor, way.name, given):
        for place in [root] if turn is None else sorted(turned(root, turn, (lower, upper), given, TURNS), key=_turns):
            asked = [Demand(way.ahead(place))]
            asked += [] if lower is None else [Demand(place - lower, ">=")]
            asked += [] if upper is None else [Demand(upper - place, ">=")]
            asked += [] if turn is None else [Demand(turn * turn - way.ahead(place) ** 2)]
            if settle(asked, given) is not None and not any(is_zero(place - old) for old in found):
                found.append(place)
    return found


def _turns(place: Scalar) -> Fraction:
    """By how many turns a place lies from the first."""
    return abs(Fraction(place.num.terms.get(((atoms.PI, 1),), 0)))


def _asked(way: Way, place: Scalar, force: Scalar, held: list[Scalar], given: Assumptions) -> tuple[Demand, ...] | None:
    """Under which conditions a force goes through zero at a place to which the motion comes; None if it does not.

    Raises ZeroDivisionError where something has no value there.
    """
    there = {way.name: place}
    lower, upper = given.range_of(way.name)
    asked = [*existence(place), Demand(way.ahead(place))]
    asked += [] if lower is None else [Demand(place - lower)]
    asked += [] if upper is None else [Demand(upper - place)]
    if settle(asked, given) is None:
        return None
    asked.append(Demand(short(substitute(way.square, there))))
    asked.append(Demand(short(substitute(derivative(force, way.name), there)) * -way.sense))
    asked += [Demand(short(substitute(value, there)), ">=") for value in held if value is not force]
    return settle(asked, given)


def _comes_first(way: Way, place: Scalar, held: list[Scalar], given: Assumptions) -> bool:
    """Whether up to the place the motion goes on, and every force keeps its sign."""
    between = way.until(place, given)
    return all(sign(value, between).kind == "positive" for value in (way.square, *held))


def taken(system: System) -> Iterator[tuple[Element, Scalar]]:
    """What is positive where things are as they were taken to be, in the free coordinates."""
    geometry = geometry_of(system)
    setting = setting_of(system, geometry.where)
    problem = system.problem
    found = [(element, JOINTS[element.kind].taken(element, geometry)) for element in problem.constraints]
    found += [(element, LAWS[element.kind].taken(element, setting)) for element in problem.interactions]
    yield from ((element, substitute(value, system.dependent)) for element, values in found for value in values)
