"""What momenta are kept: through a blow, and until a slip has gone; of which sets of bodies.

The road of conservation through a blow: momenta that no unknown impulse changes.

Of a set of bodies, the angular momentum about a place grows by the torque of the impulses, the momentum along a direction
by their component. Where no unknown impulse stands in that, it is one equation for the speeds, and mostly nothing is left
of the impulses at all: then the momentum is kept. Kleppner & Kolenkow 4.4 and 7.5; Goldstein, Classical Mechanics, 1.1.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from rbpsym.field import EX, EY, NOTHING, ORIGIN, Scalar, Vector, cartesian, depends_on, is_zero, short, substitute
from rbpsym.frozen import Frozen
from rbpsym.mechanics.arrivals import ArrivalState, at_start
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.energy import orbital_momentum, spin_momentum
from rbpsym.mechanics.geometry import components
from rbpsym.mechanics.impulse import BeforeAndAfter, body_rows, impulsive, parting, restitutions
from rbpsym.mechanics.placing import origins
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force, System, by_letters
from rbpsym.statement.model import Element


class Jump(Frozen):
    """after - before = given, of a set of bodies: angular momenta about `where` if `is_turning`, else momenta along it.

    `label` names the place or the axis, "" where nothing does; `silent` are the unknown impulses from outside, none of which
    has a torque about the place or a component along the direction.
    """

    bodies: tuple[str, ...]
    label: str
    where: Vector
    is_turning: bool
    after: Scalar
    before: Scalar
    given: Scalar
    silent: tuple[Force, ...]


def road(moment: BeforeAndAfter, impulses: tuple[Element, ...]) -> tuple[Jump, ...]:
    """The jumps that determine all speeds just after, with what collisions say; () where there are not enough of them,
    or where the equations of the single bodies are as few.

    What is kept comes before what a given impulse changes, what has fewer speeds before what has more.
    """
    after = moment.after
    if after.implicit or after.speed_ties:
        return ()
    rows = [parting(moment, e, name, factor) for e in impulses for name, factor in restitutions(e).items()]
    known, chosen = solve_linear(rows, after.speeds, keep_free=True), list[Jump]()
    for jump in sorted(_jumps(moment, impulses), key=lambda jump: _price(moment, jump)):
        row = moment.new(jump.after - jump.given) - moment.old(jump.before)
        if any(depends_on(substitute(row, known.values), name) for name in known.free):
            rows, chosen = [*rows, row], [*chosen, jump]
            known = solve_linear(rows, after.speeds, keep_free=True)
    is_short = not known.free and len(chosen) < _lines(moment, impulses)
    return tuple(chosen) if is_short else ()


def _price(moment: BeforeAndAfter, jump: Jump) -> tuple[bool, int, int]:
    speeds = sum(depends_on(jump.after, name) for name in moment.after.speeds)
    return bool(jump.given), speeds, len(moment.old(jump.before).num)


def _lines(moment: BeforeAndAfter, impulses: tuple[Element, ...]) -> int:
    """How many equations the single bodies have in which something happens."""
    return sum(not is_zero(row) for name in moment.after.bodies for row in body_rows(moment, name, impulses))


def _jumps(moment: BeforeAndAfter, impulses: tuple[Element, ...]) -> Iterator[Jump]:
    """Those without unknown impulses in which a speed stands."""
    forces = impulsive(moment.after, impulses)
    unknown = {name for force in forces for name in force.unknowns} | {n for e in impulses for n in restitutions(e)}
    links = {(a.on, b.on) for a in forces for b in forces if a.name == b.name}
    for bodies in connected_sets(tuple(moment.after.bodies), links):
        acting = [force for force in forces if force.on in bodies]
        outer = [force for force in acting if not any(_is_undone(moment, force, other) for other in acting)]
        for label, where, is_turning in (*_places(moment, outer), *_directions(outer)):
            given = sum((force.torque(where) if is_turning else where.dot(force.vector) for force in acting), NOTHING)
            if any(depends_on(moment.new(given), name) for name in unknown):
                continue
            given = NOTHING if is_zero(moment.new(given)) else given
            after, before = (_momentum(s, bodies, where, is_turning=is_turning) for s in (moment.after, moment.before))
            if any(depends_on(moment.new(after), speed) for speed in moment.after.speeds):
                silent = tuple(force for force in outer if _holds(force, unknown))
                yield Jump(bodies, label, where, is_turning, after, before, given, silent)


def _holds(force: Force, names: set[str]) -> bool:
    parts = (force.vector.x, force.vector.y, force.couple)
    return any(depends_on(part, name) for part in parts for name in names)


def _is_undone(moment: BeforeAndAfter, force: Force, other: Force) -> bool:
    """Whether the two are action and reaction, along one line."""
    if force.name != other.name or force.on == other.on:
        return False
    total, turn = moment.there(force.vector + other.vector), force.torque(ORIGIN) + other.torque(ORIGIN)
    return all(is_zero(moment.new(value)) for value in (total.x, total.y, turn))


def _momentum(system: System, bodies: tuple[str, ...], where: Vector, *, is_turning: bool) -> Scalar:
    total = NOTHING
    for state in (system.bodies[name] for name in bodies):
        if is_turning:
            total = total + state.mass * (state.center - where).cross(state.velocity) + state.moment * state.omega
        else:
            total = total + state.mass * where.dot(state.velocity)
    return total


def _places(moment: BeforeAndAfter, outer: list[Force]) -> Iterator[tuple[str, Vector, bool]]:
    """Fixed points that have names, and where an impulse acts."""
    named = origins(moment.after)
    yield from ((label, moment.there(place), True) for label, place in named.items())
    for force in outer:
        if force.vector:
            yield "", moment.there(force.point), True


def _directions(outer: list[Force]) -> Iterator[tuple[str, Vector, bool]]:
    """The axes, and along and across the line of an impulse that is parallel to none of them."""
    yield "x", EX, False
    yield "y", EY, False
    for force in outer:
        for name in force.unknowns:
            line = force.vector.derivative(name)
            if line.x and line.y:
                yield "", line, False
                yield "", line.turned(), False


MOST_BODIES = 4  # of more only the single ones and the whole are taken


def connected_sets(names: Sequence[str], links: Collection[tuple[str, str]]) -> Iterator[tuple[str, ...]]:
    """The connected sets of bodies, small ones first; `links` are pairs of bodies that act on each other."""
    if len(names) > MOST_BODIES:
        yield from ((name,) for name in names)
        yield tuple(names)
        return
    for size in range(1, len(names) + 1):
        yield from (subset for subset in combinations(names, size) if _is_connected(subset, links))


def _is_connected(subset: tuple[str, ...], links: Collection[tuple[str, str]]) -> bool:
    reached, border = set(), {subset[0]}
    while border:
        reached |= border
        border = {b for a, b in links if a in reached and b in subset} - reached
    return len(reached) == len(subset)


class KeptMomentum(Frozen):
    """L of a set of bodies about a fixed point, `label` "" where that has no name: of the outer forces `silent` ones have no
    torque about it, those that `cancel` have torques whose sum vanishes on the motion."""

    bodies: tuple[str, ...]
    label: str
    where: Vector
    value: Scalar
    silent: tuple[Force, ...]
    cancel: tuple[Force, ...]


def angular_momenta(study: Study) -> Iterator[KeptMomentum]:
    """Those that are kept, change with some speed and hold no coordinate; of small sets first."""
    system = study.system
    for bodies in connected_sets(tuple(system.bodies), {(force.on, force.by) for force in system.forces}):
        outer = [force for force in system.forces if force.on in bodies and force.by not in bodies]
        for label, where in _fixed_places(study):
            states = [system.bodies[name] for name in bodies]
            value = short(sum((orbital_momentum(s, where) + spin_momentum(s) for s in states), NOTHING))
            is_uniform = not any(depends_on(value, name) for name in (*system.coordinates, "t"))
            if not is_uniform or not any(depends_on(value, speed) for speed in system.speeds):
                continue
            turns = [(force, short(force.torque(where))) for force in outer]
            if is_zero(study.on_motion(sum((turn for _, turn in turns), NOTHING))):
                silent, cancel = (tuple(f for f, turn in turns if bool(turn) is told) for told in (False, True))
                yield KeptMomentum(bodies, label, where, value, silent, cancel)


def _fixed_places(study: Study) -> Iterator[tuple[str, Vector]]:
    """Fixed points with names, and of each fixed line that is touched the point next to O."""
    yield from study.origins.items()
    for element in study.problem.constraints:
        for _, line in JOINTS[element.kind].fixed_lines(element):
            a, b, c = components(line)
            yield "", cartesian(a * c, b * c)


def until_no_slip(study: Study, slip: Scalar, end: ArrivalState) -> tuple[KeptMomentum, ...]:
    """The angular momenta that, with a slip that has gone, give all speeds at the end of a phase; () if they do not."""
    wanted, start = study.system.speeds, at_start(study)
    begun = by_letters(start.speeds)
    rows, chosen = [substitute(slip, end.places)], list[KeptMomentum]()
    known = solve_linear(rows, wanted, keep_free=True)
    for kept in angular_momenta(study):
        row = kept.value - substitute(kept.value, begun)
        if any(depends_on(substitute(row, known.values), name) for name in known.free):
            rows, chosen = [*rows, row], [*chosen, kept]
            known = solve_linear(rows, wanted, keep_free=True)
    return () if known.free else tuple(chosen)
