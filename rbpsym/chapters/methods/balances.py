"""The balances that one can take: torque about a point of a set of bodies, force along a direction.

A balance is an equation, linear in the accelerations and the unknown forces: rate of change of
(angular) momentum = torque (force). Kleppner & Kolenkow 7.2; for a moving point P the rate
of change is Σ (R - P) × M A + I_cm α.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from math import inf

from rbpsym.errors import LimitError
from rbpsym.expr import tree as t
from rbpsym.field import EX, EY, NOTHING, UNITY, Scalar, Vector, derivative, is_zero, polar, short
from rbpsym.frozen import Frozen
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.geometry import normal
from rbpsym.mechanics.jumps import connected_sets
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState, Force, System
from rbpsym.proof.step import PhraseRef


class Balance(Frozen):
    """left = right; `kind` "fixed", "center", "moving", "crossing" (torques) or "force".

    `label` names the point or the direction; `unknowns` are the accelerations and force
    components that occur; `cost` is how much it asks of a reader.
    """

    kind: str
    bodies: tuple[str, ...]
    label: str
    where: Vector
    left: Scalar
    right: Scalar
    unknowns: frozenset[str]
    cost: float

    @property
    def row(self) -> Scalar:
        """left - right, which vanishes."""
        return self.left - self.right


COST = {"fixed": 1.0, "center": 1.05, "force": 1.2, "moving": 1.9, "crossing": 1.95}
TURNING = ("with ", "path ")  # directions in which a coordinate takes a body, which turn with it: of length 1, and as they are
ROLLING = 1.6  # about the point that a round body touches
ABOUT_NO_AXIS = 0.7  # torque about a fixed point about which the bodies do not turn
SLANTED = 0.1  # a direction that is neither along the velocity nor across it
A_TERM = 0.1  # of the two sides
ONLY_SHIFTED = -0.2  # mass times acceleration of bodies that do not turn


def all_balances(study: Study) -> list[Balance]:
    """Every balance of the kinds above, cheapest first."""
    found: list[Balance] = []
    for bodies in connected_sets(tuple(study.system.bodies), {(force.on, force.by) for force in study.system.forces}):
        found += _torques(study, bodies)
        found += _pushes(study, bodies)
    return sorted(found, key=lambda b: b.cost)


def silent_forces(forces: list[Force]) -> PhraseRef:
    """The unknown forces that have no torque about the point."""
    names = [t.Vec(name) for name in dict.fromkeys(f.name for f in forces)]
    return PhraseRef("torque.silent", {"forces": names, "count": len(names)}) if names else PhraseRef("torque.none", {})


def outer_forces(system: System, bodies: tuple[str, ...]) -> list[Force]:
    """The forces on the set that come from outside of it."""
    return [f for f in system.forces if f.on in bodies and f.by not in bodies]


def _torques(study: Study, bodies: tuple[str, ...]) -> Iterator[Balance]:
    for label, origin in study.origins.items():
        yield _torque(study, "fixed", bodies, label, origin)
    if len(bodies) == 1:
        center = study.system.bodies[bodies[0]].center
        yield _torque(study, "center", bodies, f"{bodies[0]}.cm", center)
    for label, place in _joint_points(study, bodies):
        yield _torque(study, "moving", bodies, label, place)
    for label, place in _crossings(study, bodies):
        yield _torque(study, "crossing", bodies, label, place)


def _torque(study: Study, kind: str, bodies: tuple[str, ...], label: str, point: Vector) -> Balance:
    left, right = NOTHING, NOTHING
    for name in bodies:
        state = study.system.bodies[name]
        left = left + state.mass * (state.center - point).cross(state.acceleration) + state.moment * state.alpha
    for force in outer_forces(study.system, bodies):
        right = right + force.torque(point)
    return _balance(study, kind, bodies, label, point, left, right)


def _balance(study: Study, kind: str, bodies: tuple[str, ...], label: str, where: Vector, left: Scalar, right: Scalar) -> Balance:
    left, right = short(left), short(right)
    names = (*study.system.accelerations, *study.system.unknowns)
    unknowns = frozenset(n for n in names if not is_zero(derivative(left - right, n)))
    forces = len(unknowns & set(study.system.unknowns))
    cost = (
        (ROLLING if kind == "moving" and label in study.system.bodies else COST[kind])
        + _habit(study, kind, bodies, where)
        + 0.25 * (len(bodies) - 1)
        + 0.2 * forces
        + A_TERM * (len(left.num) + len(right.num))
    )
    return Balance(kind, bodies, label, where, left, right, unknowns, cost)


def _habit(study: Study, kind: str, bodies: tuple[str, ...], where: Vector) -> float:
    """What a teacher would rather take: the axis of what turns about it, forces for what is only shifted."""
    states = [study.system.bodies[name] for name in bodies]
    if kind == "force":
        slanted = any(not is_zero(where.cross(s.velocity)) and not is_zero(where.dot(s.velocity)) for s in states)
        return SLANTED * slanted + (ONLY_SHIFTED if not any(state.omega for state in states) else 0.0)
    if kind != "fixed" or all(_keeps_distance(state, where) for state in states):
        return 0.0
    return ABOUT_NO_AXIS


def _keeps_distance(state: BodyState, point: Vector) -> bool:
    """Does the centre of mass stay at one distance from a fixed point?"""
    arm = state.center - point
    return is_zero(arm.dot(state.velocity))


def _joint_points(study: Study, bodies: tuple[str, ...]) -> Iterator[tuple[str, Vector]]:
    """Points that move, where an unknown force acts on the set from outside."""
    for force in outer_forces(study.system, bodies):
        if force.unknowns and force.vector and not any((force.point - place).vanishes() for place in study.origins.values()):
            yield force.where, force.point


def _crossings(study: Study, bodies: tuple[str, ...]) -> Iterator[tuple[str, Vector]]:
    """Where the lines of action of two contact forces meet: neither has a torque about it."""
    forces = [f for f in outer_forces(study.system, bodies) if len(f.unknowns) == 1 and not f.couple]
    for a, b in combinations(forces, 2):
        point = _crossing(a, b)
        if point is not None:
            yield f"{a.name}, {b.name}", point


def _crossing(a: Force, b: Force) -> Vector | None:
    """a.point + s a.vector with (a.point + s a.vector - b.point) × b.vector = 0."""
    slope = a.vector.cross(b.vector)
    if is_zero(slope):
        return None
    step = (b.point - a.point).cross(b.vector) / slope
    return (a.point + a.vector * step).settled()


def _pushes(study: Study, bodies: tuple[str, ...]) -> Iterator[Balance]:
    for label, direction in _directions(study, bodies):
        left, right = NOTHING, NOTHING
        for name in bodies:
            state = study.system.bodies[name]
            left = left + state.mass * direction.dot(state.acceleration)
        for force in outer_forces(study.system, bodies):
            right = right + direction.dot(force.vector)
        if left or right:
            yield _balance(study, "force", bodies, label, direction, left, right)


def _directions(study: Study, bodies: tuple[str, ...]) -> Iterator[tuple[str, Vector]]:
    """The axes, along and across lines that are touched and are not parallel to them, and where a coordinate takes a body."""
    yield "x", EX
    yield "y", EY
    for element in study.problem.constraints:
        for touch in JOINTS[element.kind].fixed_lines(element):
            if touch[0] not in bodies:
                continue
            across = normal(touch[1])
            if across.x and across.y:
                yield f"across {element.name}", across
                yield f"along {element.name}", -across.turned()
    for name in study.system.independent if len(bodies) == 1 else ():
        tangent = study.system.bodies[bodies[0]].center.derivative(name)
        is_polar = len(tangent.parts) == 1
        way = polar(UNITY, *tangent.parts) if is_polar else tangent
        if way.x and way.y:
            yield f"{'with' if is_polar else 'path'} {name}", way


MOST_CANDIDATES, MOST_EXTRA, LONGEST = 40, 3, 6


class Plan(Frozen):
    """The balances, and the unknowns that they determine together."""

    balances: tuple[Balance, ...]
    unknowns: tuple[str, ...]


def plan(study: Study) -> Plan | None:
    """The cheapest set, of few lines or of more and simpler ones, that determines all accelerations; None if the search is too
    wide, or if the accelerations that the balances give grow beyond the limits."""
    try:
        return _search(study)
    except LimitError:
        return None


def _search(study: Study) -> Plan | None:
    wanted = study.system.accelerations
    candidates = all_balances(study)
    trivial = [b for b in candidates if b.unknowns]
    best, least = None, inf
    for size in range(len(wanted), min(len(wanted) + MOST_EXTRA, LONGEST) + 1):
        found = _cheapest(trivial[:MOST_CANDIDATES], size, wanted, least)
        if found is not None:
            best, least = found, _price(found.balances)
    return best


def _price(chosen: Iterable[Balance]) -> float:
    return sum(balance.cost for balance in chosen)


def _cheapest(candidates: list[Balance], size: int, wanted: tuple[str, ...], bound: float) -> Plan | None:
    if _price(candidates[:size]) >= bound:
        return None
    sets = [c for c in combinations(candidates, size) if may_close(c, size, wanted) and _price(c) < bound]
    for chosen in sorted(sets, key=_price):
        unknowns = tuple(sorted(frozenset().union(*(b.unknowns for b in chosen))))
        solution = solve_linear([b.row for b in chosen], unknowns)
        if not solution.free:
            return Plan(tuple(sorted(chosen, key=lambda b: (len(b.unknowns), len(b.bodies), b.cost))), unknowns)
    return None


def may_close(chosen: tuple[Balance, ...], size: int, wanted: tuple[str, ...]) -> bool:
    """Whether so many balances hold as many unknowns, all that are wanted among them."""
    unknowns = frozenset().union(*(b.unknowns for b in chosen))
    return len(unknowns) == size and set(wanted) <= unknowns


# --- roads to the motion, each with the lines that it takes: what a teacher weighs before writing the first of them
# A road begins with one balance (about a point, along a direction, of some of the bodies) and takes as few further ones as
# determine all accelerations. An unknown force that stands in none of its lines has dropped out.


class Road(Frozen):
    """`first` is the balance with which it begins; None for `kind` "bodies" (Newton's and Euler's equations of each) and
    "energy" (that of the whole). `lines` are its equations, `stay` and `drop` the unknown forces that are in them and not."""

    kind: str
    first: Balance | None
    lines: int
    stay: tuple[str, ...]
    drop: tuple[str, ...]
    is_taken: bool = False


def roads(study: Study) -> list[Road]:
    """All of them, those with the fewest lines and the fewest unknown forces first; `is_taken` where the notes go."""
    wanted, unknown = study.system.accelerations, study.system.unknowns
    if not wanted:
        return []
    chosen = plan(study)
    candidates = [b for b in all_balances(study) if b.unknowns][:MOST_CANDIDATES]
    found = [_bodies(study)]
    if len(wanted) == 1 and study.first_integral is not None:
        found.append(Road("energy", None, 1, (), unknown))
    for first in candidates:
        lines = _shortest(first, candidates, wanted)
        if lines:
            stay = tuple(name for name in unknown if any(name in line.unknowns for line in lines))
            is_taken = chosen is not None and first.row in [balance.row for balance in chosen.balances]
            found.append(Road(first.kind, first, len(lines), stay, tuple(n for n in unknown if n not in stay), is_taken))
    return sorted(found, key=lambda road: (road.lines, len(road.stay), not road.is_taken))


def _bodies(study: Study) -> Road:
    rows = [row for row in study.newton_euler_rows if not is_zero(row)]
    return Road("bodies", None, len(rows), study.system.unknowns, ())


def _shortest(first: Balance, candidates: Sequence[Balance], wanted: tuple[str, ...]) -> tuple[Balance, ...]:
    """The fewest lines, this one first, that determine the accelerations and not without it; () if there are too many."""
    others = [balance for balance in candidates if balance is not first]
    for size in range(len(wanted), min(len(wanted) + MOST_EXTRA, LONGEST) + 1):
        for more in combinations(others, size - 1):
            if _closes((first, *more), wanted) and not _closes(more, wanted):
                return (first, *more)
    return ()


def _closes(lines: tuple[Balance, ...], wanted: tuple[str, ...]) -> bool:
    if not may_close(lines, len(lines), wanted):
        return False
    names = tuple(sorted(frozenset().union(*(line.unknowns for line in lines))))
    return not solve_linear([line.row for line in lines], names).free
