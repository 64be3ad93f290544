"""Phrases about a moment of the motion: the start, a place, a rest, a phase that begins; and about oscillations.

“speed of s where s = L”, “N_w where theta = 0”, “x when rolling begins”, “time until rolling”. Each is a
constant: accelerations and unknown forces are those of the motion, speeds follow from the start.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, QUARTER, Scalar, Space, Vector, depends_on, is_zero, root, short, substitute, with_squares
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.system import by_letters
from rbpsym.quantity.bound import Bound, Phrase, number, plane
from rbpsym.quantity.oscillations import PHRASES as OSCILLATIONS
from rbpsym.quantity.path import first_push, work_done
from rbpsym.statement.source import did_you_mean

if TYPE_CHECKING:
    from rbpsym.mechanics.phases import HandOver
    from rbpsym.quantity.problem import ProblemWorld

See = Callable[[Scalar], Scalar]


def mapped(found: Bound, see: See, image: Mapping[str, Scalar]) -> Bound:
    """The bound with its lengths seen otherwise and a place put in. Raises StatementError if it has no value."""
    if found.scalar is None and found.vector is None:
        raise StatementError("this has no value of its own", instead="name a quantity.")

    def there(value: Scalar) -> Scalar:
        return substitute(see(value), image)

    vector = found.vector
    if vector is not None:
        lengths = Vector({angle: see(length) for angle, length in vector.plane.parts.items()})
        vector = Space(lengths.substitute(image), there(vector.z))
        if vector.plane.parts:
            return plane(vector)
    return replace(found, scalar=None if found.scalar is None else there(found.scalar), vector=vector)


def _still(world: ProblemWorld, found: Bound, phrase: str) -> Bound:
    """The bound, which must hold nothing that moves. Raises StatementError."""
    parts = [] if found.scalar is None else [found.scalar]
    parts += [] if found.vector is None else list(found.vector.components())
    moving = next((n for n in world.motion.scope.rates for part in parts if depends_on(part, n)), None)
    if moving is None:
        return found
    raise StatementError(
        f"“{phrase}” still depends on {moving} there", instead=f'does [coordinates.{moving}] have a start = "..."?'
    )


def carried(world: ProblemWorld, value: Scalar) -> Scalar:
    """The value on the motion, works in closed form. Raises StatementError for a work that has none."""
    motion, images = world.motion, {}
    for name, power in motion.ledger.items():
        if depends_on(value, name):
            done = work_done(power, motion)
            if done is None:
                raise StatementError("no closed form was found for a work in this phrase")
            images[name] = done
    return motion.moved(substitute(value, images) if images else value)


def start(world: ProblemWorld, phrase: str) -> Bound:
    """The value in the start state."""
    see = world.study.begun if world.study.at_start else partial(carried, world)
    found = mapped(world.bound(phrase), see, world.motion.scope.start)
    return _still(world, found, phrase)


def elsewhere(world: ProblemWorld, phrase: str, problem: str) -> Bound:
    """The same in another problem, whose parameters of the same names are the same quantities."""
    if world.others is None:
        instead = f"in a claim or a comparison that is the problem “{problem}”; of a body say “of {problem}”, “on {problem}”."
        raise StatementError(f"“in {problem}” means nothing here", instead=instead)
    other = world.others(problem)
    found = other.bound(phrase)
    return found if found.kind != "value" else mapped(found, lambda v: carried(other, v), {})


# --- at a place


def _at(world: ProblemWorld, phrase: str, place: Mapping[str, Scalar]) -> Bound:
    """The value where a coordinate has a value, along the motion from the start."""
    motion = world.motion
    squares = {name: short(substitute(square, place)) for name, square in motion.squares.items()}
    speeds = {f"{name}_dot": _speed(world, name, square, place) for name, square in squares.items() if name in place}

    def see(value: Scalar) -> Scalar:
        return substitute(with_squares(carried(world, value), motion.squares), speeds)

    return _still(world, mapped(world.bound(phrase), see, place), phrase)


def _speed(world: ProblemWorld, name: str, square: Scalar, place: Mapping[str, Scalar]) -> Scalar:
    """The speed when the place is first passed: its sign is that of the way from the start."""
    begin = world.motion.scope.start[name]
    if is_zero(place[name] - begin):
        return world.motion.scope.start.get(f"{name}_dot", NOTHING)
    return root(square) * _sense(world, place[name] - begin)


def _sense(world: ProblemWorld, value: Scalar) -> Scalar | int:
    """1 or -1, or x/|x| where the sign depends on the parameters."""
    known = sign(value, world.motion.assumptions)
    return 1 if known.kind == "zero" else known.sense or value / root(value * value)


def where_equal(world: ProblemWorld, phrase: str, name: str, text: str) -> Bound:
    """PHRASE where COORDINATE = VALUE; a coordinate that is tied to another one is solved for that."""
    value = scalar(read_infix(text, world.names))
    if name not in world.dependent:
        if name not in world.study.system.independent:
            raise StatementError(f"“{name}” is no coordinate", instead=did_you_mean(name, world.coordinates))
        return _at(world, phrase, {name: value})
    gap = world.dependent[name] - value
    ways = [(n, zeros(gap, n)) for n in world.study.system.independent if depends_on(gap, n)]
    if len(ways) != 1 or len(ways[0][1]) != 1:
        raise StatementError(f"the place where {name} = {text} has no single closed form")
    return _at(world, phrase, {ways[0][0]: ways[0][1][0]})


def where_vanishes(world: ProblemWorld, phrase: str, force: str) -> Bound:
    """PHRASE where FORCE vanishes: where a contact is lost or a string gets slack."""
    for item in world.study.losses:
        if item.force == force and item.at:
            return _at(world, phrase, item.at)
    raise StatementError(f"“{force}” does not vanish during the motion, as far as is known")


def where_rests(world: ProblemWorld, phrase: str, name: str) -> Bound:
    """PHRASE where COORDINATE comes to rest: the only place ahead at which its speed is zero."""
    motion = world.motion
    square, begin = motion.squares.get(name), motion.scope.start.get(name)
    if square is None or begin is None:
        raise StatementError(f"the speed of “{name}” as a function of its place is not known")
    way = first_push(motion, name)
    places = [place for place in zeros(square, name) if not is_zero(place - begin)]
    if len(places) != 1 or sign(way * (places[0] - begin), motion.assumptions).kind != "positive":
        raise StatementError(f"the place where “{name}” comes to rest has no single closed form")
    return _at(world, phrase, {name: places[0]})


def time_until(world: ProblemWorld, name: str, text: str) -> Bound:
    """The time from the start until COORDINATE = VALUE, if the acceleration is uniform."""
    motion, value = world.motion, scalar(read_infix(text, world.names))
    begin = start(world, name).number
    actual = motion.moved(world.bound(f"acceleration of {name}").number)
    if any(depends_on(actual, moving) for moving in (*motion.scope.rates, "t")):
        raise StatementError(f"the acceleration of “{name}” is not uniform, and no closed form was found for this time")
    speed, gain, way = start(world, f"speed of {name}").number, actual, value - begin
    if not gain:
        return number(way / speed)
    spread = root(short(speed * speed + way * gain * 2))
    return number((spread * _sense(world, way) - speed) / gain)


# --- phases


def _stage(world: ProblemWorld, name: str | None, force: str = "") -> tuple[int, HandOver]:
    """Which phase a name is of, and how it begins; without a name, the only phase that begins with a blow, or with one in which
    that force has an impulse."""
    if name is None and world.study.problem.phases:
        world.named(world.study.problem.phases[-1].name)  # one that is not known might begin with a blow, too
    apart = {one.name: one.began for one in world.stages if name is None and one.began is not None and one.began.is_blow}
    struck = [one for one, began in apart.items() if {force, f"{force}_x"} & began.impulses.keys()]
    blows = struck or [*apart]
    if name is None and len(blows) != 1:
        told = f"write “… when {' begins” or “… when '.join(blows)} begins”." if blows else "the problem has no blow."
        raise StatementError("the blow is not named", instead=told)
    place = world.named(name or blows[0])
    began = world.stages[place].began
    if began is None:
        raise StatementError(f"there is no phase “{name}” that begins")
    return place, began


def when_begins(world: ProblemWorld, phrase: str, name: str) -> Bound:
    """PHRASE when PHASE begins, just after the impulses."""
    place, _ = _stage(world, name)
    return start(world.phase(place), phrase)


def just_before(world: ProblemWorld, phrase: str, name: str) -> Bound:
    """PHRASE just before PHASE: at the end of the phase before it."""
    place, began = _stage(world, name)
    earlier, state = world.phase(place - 1), began.before
    image = {**state.places, **by_letters(state.speeds)}
    return _still(earlier, mapped(earlier.bound(phrase), lambda v: carried(earlier, v), image), phrase)


def until(world: ProblemWorld, name: str) -> Bound:
    """The time from the start of the phase before to the beginning of PHASE."""
    _, began = _stage(world, name)
    if not began.before.time:
        raise StatementError(f"no closed form was found for the time until “{name}”, or the phase begins at once")
    return number(began.before.time)


def impulse(world: ProblemWorld, force: str, name: str | None) -> Bound:
    """The impulse of a constraint or collision when PHASE begins; of a pivot as a vector."""
    place, began = _stage(world, name, force)
    found, told = began.impulses, f"phase {place}"
    both = tuple(found[name] for name in (f"{force}_x", f"{force}_y") if name in found)
    if force not in found and len(both) == 2:
        return replace(plane(Vector(dict(zip((NOTHING, QUARTER), both, strict=True)))), told=told)
    if force not in found:
        raise StatementError(f"no impulse “{force}” is known there", instead=did_you_mean(force, found, "impulses"))
    return number(found[force], told)


def energy_lost(world: ProblemWorld, name: str | None) -> Bound:
    """Kinetic energy lost when PHASE begins."""
    place, began = _stage(world, name)
    return number(began.energy_lost, f"phase {place}" if began.is_blow else "")


def friction_ratio(world: ProblemWorld, contact: str) -> Bound:
    """f/N of a contact that static friction holds."""
    return number(_need(world, contact).ratio, "contact")


def _need(world: ProblemWorld, contact: str) -> FrictionNeed:
    needs = {item.constraint: item for item in world.study.friction_needs}
    if contact not in needs:
        raise StatementError(f"static friction does not hold “{contact}”", instead=did_you_mean(contact, needs, "such contacts"))
    return needs[contact]


def needed_friction(world: ProblemWorld, contact: str) -> Bound:
    """|f|/N of a contact that static friction holds: the coefficient that it needs."""
    need = _need(world, contact)
    if is_zero(need.ratio):  # no step tells what is not needed
        return world.expression(need.friction)
    return number(need.ratio * _sense(world, need.ratio) if need.needed is None else need.needed, "contact")


_W = r"([\w-]+)"
JUMPS: tuple[Phrase, ...] = (
    (rf"impulse of (\w+)(?: when {_W} begins)?", impulse, "impulse of CONTACT when PHASE begins"),
    (rf"(?:kinetic )?energy lost(?: when {_W} begins)?", energy_lost, "energy lost when PHASE begins"),
)
PHRASES: tuple[Phrase, ...] = (
    *JUMPS,
    (rf"(.+) when {_W} begins", when_begins, "speed of COORDINATE when PHASE begins"),
    (rf"(.+) just before {_W}", just_before, "speed of COORDINATE just before PHASE"),
    (r"time until (\w+) = (.+)", time_until, "time until COORDINATE = VALUE"),
    (rf"time until {_W}", until, "time until PHASE"),
    (r"(.+) where (\w+) = (.+)", where_equal, "speed of COORDINATE where COORDINATE = VALUE"),
    (r"(.+) where (\w+) vanishes", where_vanishes, "COORDINATE where FORCE vanishes"),
    (r"(.+) where (\w+) comes to rest", where_rests, "COORDINATE where COORDINATE comes to rest"),
    (r"(.+) in ([\w./-]+)", elsewhere, ""),
    (r"start of (.+)", start, "start of FORCE"),
    *OSCILLATIONS,
    (r"friction ratio at (\w+)", friction_ratio, "friction ratio at CONTACT"),
    (r"friction coefficient needed at (\w+)", needed_friction, "friction coefficient needed at CONTACT"),
)
