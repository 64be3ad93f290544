"""What is wanted of a motion in a question about parameters: values that are positive, or zero, along a way."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from contextlib import suppress
from types import MappingProxyType

from rbpsym.ask.moments import coordinate_of
from rbpsym.ask.seen import AskedPhase, going_on, is_sure, moving, never_told, one_period, place_in, seen, way_to, whole_motion
from rbpsym.ask.zeros import where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import rooted
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, short, substitute, symbol
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.arrivals import mover
from rbpsym.mechanics.coupled import courses_of
from rbpsym.mechanics.demands import Demand, possible
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.roots import period, zeros
from rbpsym.mechanics.stability import essential
from rbpsym.proof.step import Step
from rbpsym.statement.source import did_you_mean


class Wanted(Frozen):
    """values: all positive (`equal`: zero) where `given`; `along`: all along the range of a coordinate.

    closed: zero is enough; end: at this place of the way it is enough if the last value vanishes (it arrives at rest).
    comes: whether the motion goes all the way for all parameters. beside: what must not be negative either for it to be the
    motion that is stated, though it is not asked for; there: what is said where one of these vanishes first. others:
    whether it may come by setting out in the other sense, too. steps: that say of what the values are signs.
    """

    values: tuple[Scalar, ...]
    given: Assumptions
    along: str | None = None
    equal: bool = False
    closed: bool = True
    end: Scalar | None = None
    asked: tuple[Demand, ...] = ()
    comes: bool = True
    beside: tuple[Scalar, ...] = ()
    others: bool = False
    there: str = "beyond it the motion is not the one that is stated"
    steps: tuple[Step, ...] = ()


def arrives(condition: Wanted, place: Scalar | None, at: Mapping[str, Scalar] = MappingProxyType({})) -> bool:
    """Whether a motion whose speed vanishes at a place comes there nevertheless: it is where it was to come, and the square
    of the speed goes through zero there (else the place is approached for ever)."""
    if condition.end is None or condition.along is None or place is None or not is_zero(place - condition.end):
        return False
    slope = substitute(derivative(condition.values[-1], condition.along), {**at, condition.along: place})
    return not is_zero(rooted(slope, condition.given))


def lasting_premises(world: AskedPhase) -> list[Demand]:
    """The same, be it said by the condition or not: what does not move of it."""
    return [demand for demand in dict.fromkeys(world.standing) if not moving(world, (demand.value,))]


def premises(world: AskedPhase, condition: Wanted) -> list[Demand]:
    """What contacts, friction and the start ask of the parameters for the motion to be the one that is stated, beside what
    the condition itself says."""
    standing = lasting_premises(world)
    standing = [_without_divisor(demand, standing, condition.given) for demand in standing]
    return unsaid(dict.fromkeys(standing), condition)


def unsaid(demands: Iterable[Demand], condition: Wanted, name: str = "") -> list[Demand]:
    """Those that the condition itself does not say, of a symbol in another form either."""
    said = {essential(value, condition.given) for value in condition.values}
    left = [demand for demand in demands if essential(demand.value, condition.given) not in said]
    return [demand for demand in left if not any(_is_multiple(demand.value, one, name, condition.given) for one in said)]


def _is_multiple(value: Scalar, other: Scalar, name: str, given: Assumptions) -> bool:
    """Whether a value is another one times what is positive and free of a symbol."""
    first, second = (derivative(one, name) for one in (value, other))
    if not first or not second or not is_zero(first * other - second * value):
        return False
    return sign(short(first * second), given).kind == "positive"


def _without_divisor(demand: Demand, standing: list[Demand], given: Assumptions) -> Demand:
    """Multiplied by what it is divided by, where the others ask for that to be positive."""
    others = [replace(other, op=">") for other in standing if other != demand]
    below = sign(Scalar(demand.value.den), where_met(given, others)).kind
    return replace(demand, value=short(demand.value * Scalar(demand.value.den))) if below == "positive" else demand


def case_of(world: AskedPhase) -> tuple[Demand, ...]:
    """What the motion that was told asks of the parameters."""
    asked = (demand for demand in (*world.demands, *world.standing) if not moving(world, (demand.value,)))
    return possible(asked, world.motion.assumptions, never_told("the motion that is stated"))


def on_what(world: AskedPhase, value: Scalar) -> str:
    """The parameters on which a value depends, as advice."""
    known = [q.name for q in world.study.problem.parameters if depends_on(value, q.name)]
    return f"it depends on {', '.join(known)}." if known else ""


def free_place(world: AskedPhase, name: str, text: str) -> tuple[str, Scalar]:
    """The coordinate that is free, and its value where another one that is tied to it has a value."""
    if name not in world.coordinates:
        raise StatementError(f"“{name}” is no coordinate", instead=did_you_mean(name, world.coordinates))
    value = place_in(world, name, text)
    if name in world.study.system.independent:
        return name, value
    if name not in world.dependent:
        left = ", ".join(world.study.system.independent)
        raise StatementError(f"“{name}” is no function of {left} that is known", instead=f"ask for it by {left}.")
    gap = world.dependent[name] - value
    found = [(n, root) for n in world.study.system.independent if depends_on(gap, n) for root in zeros(gap, n)]
    if len(found) != 1:
        raise StatementError(f"the place where “{name}” has this value has no single closed form")
    return found[0]


def _in_time(world: AskedPhase, values: tuple[Scalar, ...]) -> tuple[tuple[Scalar, ...], tuple[Demand, ...]]:
    """The values as functions of the time, with what that asks for; as they are where the motion is not known so."""
    with suppress(RbpsymError):
        found = courses_of(world.study)
        at = {name: one.whole for name, one in found.items()} | {f"{name}_dot": one.speed for name, one in found.items()}
        return tuple(short(substitute(value, at)) for value in values), tuple(d for one in found.values() for d in one.valid)
    return values, ()


def on_way(
    world: AskedPhase, values: tuple[Scalar, ...], phrase: str, until: str | None, text: str | None, given: Assumptions
) -> Wanted:
    """The values are positive along the way of the one coordinate on which they depend."""
    free = moving(world, values)
    if not free:
        return Wanted(values, given)
    asked: tuple[Demand, ...] = ()
    if until is None and len(free) > 1:
        values, asked = _in_time(world, values)
        free = moving(world, values) or free
    if free == ["t"] and until is None:
        turns = {period(value, "t"): value for value in values if depends_on(value, "t")}
        return Wanted(values, one_period(next(iter(turns.values())), given) if len(turns) == 1 else given, "t", asked=asked)
    name, end = (free[0], None) if until is None or text is None else free_place(world, until, text)
    if len(free) > 1 or name != free[0]:
        raise StatementError(f"“{phrase}” depends on {', '.join(free)} along the motion, and not on one coordinate alone")
    way, given = whole_motion(world, name, given) if until is None else way_to(world, name, end, given)
    others = () if until is None else going_on(world, way, given)
    comes = is_sure(others, free[0], given)
    return Wanted(values if comes else (*values, *others), given, free[0], end=end, asked=way.asked, comes=comes)


DOES = r"(?: (?:does not|never|begins to|starts to|just))?"
VERBS = "slip|leave|lift|tip|move|lose|let go|hold|stick|roll|keep|stay|remain"
OF_BODY = re.compile(rf"(\w+)(?: \w+)??(?={DOES} (?:{VERBS})s?\b)")


def of_contact(world: AskedPhase, text: str) -> str:
    """The condition with “it”, or the name of a contact, for a body: “the ladder does not slip” where nothing else holds."""
    said, problem = OF_BODY.match(text), world.study.problem
    touching = [e.name for e in problem.constraints if said and getattr(e.values.get("point"), "point", None) == said[1]]
    if said and len(touching) == 1:  # “the front wheel lifts”, where a contact holds the point “front”
        return touching[0] + text[said.end() :]
    if said is None or STEADY.fullmatch(text) or RISES.fullmatch(text) or said[1] not in (body.name for body in problem.bodies):
        return text
    held = {need.constraint for need in world.study.friction_needs} or {*slips(world.study.system)}
    values = {name: world.study.system.element(name).values.values() for name in held}
    own = {name for name in held if any(getattr(value, "body", value) == said[1] for value in values[name])}
    names = {"it"} if own == held else own
    return names.pop() + text[said.end() :] if len(names) == 1 else text


def begins_to_slip(world: AskedPhase, contact: str) -> Wanted | None:
    """Kinetic friction acts from the beginning of a slip: what is at rest begins to slip in the stated sense where it gains
    speed in it. None where static friction holds a contact, or the slip is no multiple of the one speed."""
    found = {name: slip for name, slip in slips(world.study.system).items() if contact in ("it", name)}
    names = {name for slip in found.values() for name in world.study.system.independent if depends_on(slip, f"{name}_dot")}
    if world.study.friction_needs or len(names) != 1:
        return None
    [name] = names
    speed, given = f"{name}_dot", world.motion.assumptions
    senses = {sign(derivative(slip, speed), given).sense for slip in found.values()}
    is_multiple = all(is_zero(derivative(slip, speed) * symbol(speed) - slip) for slip in found.values())
    is_at_rest = is_zero(world.study.system.scope.start.get(speed, NOTHING))
    if len(senses) != 1 or 0 in senses or not (is_multiple and is_at_rest):
        return None
    return Wanted((seen(world, f"acceleration of {name} at the start") * senses.pop(),), given, closed=False)


STEADY = re.compile(
    r"(\w+) (?:moves|goes|rises|sinks|falls|rolls|slides|turns) (?:steadily|uniformly|(?:at|with) (?:a )?constant \w+)"
)


def goes_steadily(world: AskedPhase, text: str) -> Wanted | None:
    """A coordinate, or the only one with which a body moves, has no acceleration. None for another condition."""
    said, system = STEADY.fullmatch(text), world.study.system
    body = system.bodies.get(said[1]) if said else None
    rates = [] if body is None else [n for n in system.speeds if body.velocity.derivative(n) or derivative(body.omega, n)]
    names = [said[1]] if said and said[1] in world.coordinates else [name.removesuffix("_dot") for name in rates]
    gain = seen(world, f"acceleration of {names[0]} as a function of the state") if len(names) == 1 else None
    return None if gain is None or moving(world, (gain,)) else Wanted((gain,), world.motion.assumptions, equal=True)


STAYS = re.compile(r"(\w+) (?:stays|remains)(?: at)? (.+)")


def stays(world: AskedPhase, text: str) -> Wanted | None:
    """A coordinate stays what it is at the start, where it is at rest and kept momenta tie all other speeds to it: it gains no
    speed there, so that nothing changes. None for another condition."""
    said, study = STAYS.fullmatch(text), world.study
    if said is None or said[1] not in study.system.coordinates:
        return None
    start, gain = study.system.scope.start, seen(world, f"acceleration of {said[1]} as a function of the state")
    is_uniform = not moving(world, (gain,)) and not slips(study.system)
    if not is_uniform and (not study.kept_speeds or mover(study) != said[1]):
        return None
    is_here = said[2] == "constant" or (said[2] in world.names and is_zero(symbol(said[2]) - start[said[1]]))
    if not is_here or not is_zero(start.get(f"{said[1]}_dot", NOTHING)):
        return None
    return Wanted((seen(world, f"acceleration of {said[1]} at the start"),), world.motion.assumptions, equal=True)


RISES = re.compile(r"(\w+) (?:begins to |starts to |just )?(rise|fall|sink|(?:goe?|move|roll|slide)s? (?:up|down))s?")


def rises(world: AskedPhase, text: str) -> Wanted | None:
    """A body that is at rest begins to move upwards, or downwards. None for another condition."""
    said = RISES.fullmatch(text)
    if said is None or said[1] not in (body.name for body in world.study.problem.bodies):
        return None
    if not is_zero(seen(world, f"y component of velocity of {said[1]}.cm at the start")):
        return None
    gain = seen(world, f"y component of acceleration of {said[1]}.cm at the start")
    if is_zero(gain):
        raise StatementError(f"as it is stated, “{said[1]}” is held where it is",
                             instead="ask when what holds it lets go: “P for which N vanishes”.")  # fmt: skip
    way = -1 if re.match("fall|sink|.*down", said[2]) else 1
    return Wanted((gain * way,), world.motion.assumptions, closed=False)


RESTS = re.compile(r"(\w+) (?:comes to rest|is brought to rest|stops)")


def comes_to_rest(world: AskedPhase, text: str) -> Wanted | None:
    """A constant acceleration is against the speed with which a coordinate sets out. None for another condition."""
    said, given = RESTS.fullmatch(text), world.motion.assumptions
    if said is None:
        return None
    free = world.study.system.independent
    name = free[0] if said[1] == "it" and len(free) == 1 else coordinate_of(world.asked, said[1])
    way = sign(seen(world, f"speed of {name} at the start"), given).sense
    gain = seen(world, f"acceleration of {name} as a function of the state")
    if not way or moving(world, (gain,)):
        why = "its acceleration is not constant" if way else "the sense in which it sets out is not known"
        raise StatementError(f"whether “{name}” comes to rest is not decided by one condition: {why}",
                             instead=f"name a place, “… for which {name} reaches VALUE”, or its speed at a moment, “… for which "
                             f"speed of {name} right after PHASE = 0”.")  # fmt: skip
    return Wanted((-(gain * way),), given, closed=False)


GOES = (stays, comes_to_rest, rises, goes_steadily)
