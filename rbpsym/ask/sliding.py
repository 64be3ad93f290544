"""Of what it is said that it slips, tips, holds: a contact by the name of its body; what sets out to slip from rest, and what
does not set out at all (an orbit that stays a circle), or comes to rest."""

from __future__ import annotations

import re

from rbpsym.ask.moments import coordinate_of
from rbpsym.ask.seen import AskedPhase, moving, seen
from rbpsym.ask.wanted import Wanted
from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, depends_on, derivative, is_zero, symbol
from rbpsym.mechanics.arrivals import mover
from rbpsym.mechanics.friction import slips

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
