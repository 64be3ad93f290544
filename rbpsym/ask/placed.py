"""Places that are told by how far a body has gone since the start, or by how a rod stands then."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial

from rbpsym.ask.answer import found_of
from rbpsym.ask.asked import Asked, NoClosedForm
from rbpsym.ask.found import sense_at_sample, sense_stated
from rbpsym.ask.moments import moment_of
from rbpsym.ask.named import GROUNDS, SURFACES, joined
from rbpsym.ask.question import SUPERLATIVES, Question, When
from rbpsym.ask.seen import AskedPhase, place_in, scene
from rbpsym.decide.signs import sign
from rbpsym.errors import Ambiguous, RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, PI, Scalar, depends_on, derivative, is_zero, names_in, root, short, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.arrivals import mover
from rbpsym.present.forms import present
from rbpsym.quantity.path import first_push, sense
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.model import Line
from rbpsym.typeset.machine import to_machine

MEETS = re.compile(r"\b(until|when|where) (\w+) (?:meets|hits|catches(?: up with)?|overtakes|passes) (\w+)$")


LENGTH = re.compile(
    r"\b(until|when|where) (?:(elongation|compression) of (\w+) (?:=|is|reaches) (.+)"
    r"|(\w+) (?:(?:has|reaches|is at) its natural length|(?:is|gets|becomes) (?:relaxed|unstretched|unstressed)))$"
)


MOVES = re.compile(
    r"\b(until|when|where|once) ((angular )?(?:speed|velocity) of (\w+)) "
    r"(?:=|reaches|is|equals|is equal to) (.+)$"
)
TOGETHER = re.compile(
    r"\b(until|when|where|once) (\w+) and (\w+) (?:have|(?:turn|rotate) (?:with|at)) (?:same|equal) "
    r"angular (?:velocity|speed|velocities|speeds)$"
)


def met(asked: Asked, text: str) -> str:
    """The question with “where x = VALUE” for “where BODY meets BODY”, “where elongation of S = VALUE” or “where angular velocity
    of BODY = VALUE”; as it is if it says no such thing."""
    if text.rsplit(" ", 1)[-1] in SUPERLATIVES:  # “where speed of block is greatest” names no value
        return text
    phase, found = _of_phase(asked, lambda number: _met(asked, text, number), text)
    return PLACED_LAST.sub(rf" {phase}\1", found) if phase and found != text else found


PLACED_LAST = re.compile(r" ((?:where|when|once|until|at|as|after) (?!.* (?:where|when|until) ))")


def _met(asked: Asked, text: str, phase: int) -> str:
    world = asked.world(phase)
    text = TOGETHER.sub(r"\1 angular velocity of \2 = angular velocity of \3", text)
    if (said := MOVES.search(text)) and said[4] in {body.name for body in asked.problem.bodies} - {*world.coordinates}:
        before = f"{text[: said.start()]}{said[1]} "
        if said[3] is None:  # of a body that is the magnitude of its velocity, of a coordinate its rate
            return f"{before}magnitude of velocity of {said[4]} = {said[5]}"
        sides = [world.bound(side).number for side in (said[2], said[5])]
        return f"{before}{equation(world, (sides[0] - sides[1],), f'“{said[2]}” has this value')}"
    if (said := MEETS.search(text)) and {said[2], said[3]} <= {body.name for body in asked.problem.bodies}:
        apart, what = world.centre(said[2]) - world.centre(said[3]), f"“{said[2]}” and “{said[3]}” are at one place"
        return f"{text[: said.start()]}{said[1]} {equation(world, (apart.x, apart.y), what)}"
    spring = (said := LENGTH.search(text)) and (said[3] or said[5])
    if said and spring in {element.name for element in asked.problem.of_kind("spring")}:
        gap = world.bound(f"{said[2] or 'elongation'} of {spring}").number
        gap = gap - scalar(read_infix(said[4] or "0", world.names))
        return f"{text[: said.start()]}{said[1]} {equation(world, (gap,), f'“{spring}” is as long')}"
    return text


def equation(world: ProblemWorld, values: Iterable[Scalar], what: str) -> str:
    """“x = VALUE” for the one coordinate in which a value, that vanishes with the others, is linear. Raises StatementError."""
    tied = world.study.system.dependent
    gaps = [gap for part in values if not is_zero(gap := short(substitute(part, tied)))]
    names = (*world.study.system.independent, *world.study.system.speeds, *([] if world.study.system.independent else ["t"]))
    free = [name for name in names if gaps and depends_on(gaps[0], name)]
    ways = [name for name in free if not names_in(derivative(gaps[0], name)) & {*world.motion.scope.rates, "t"}]
    if not ways or any(names_in(short(gap / gaps[0])) & {*world.motion.scope.rates, "t"} for gap in gaps[1:]):
        raise StatementError(
            f"where {what} is no equation for one coordinate",
            instead="ask where a coordinate has the value that makes it so.",
        )
    value = short(symbol(ways[0]) - gaps[0] / derivative(gaps[0], ways[0]))
    return f"{ways[0]} = {to_machine(present(value))}"


DOWN = "fall(?:en|ing)|dropp(?:ed|ing)|descend(?:ed|ing)|s[ui]nk(?:ing)?|lowered"
UP = "r(?:isen|ising)|climb(?:ed|ing)|ascend(?:ed|ing)|raised"
ON = "mov(?:ed|ing)|travell?(?:ed|ing)|roll(?:ed|ing)|sli(?:d|dden|ding)|gone|advanc(?:ed|ing)|cover(?:ed|ing)"
ROUND = "(?:turn|rotat)(?:ed|ing)"
GONE = re.compile(
    rf"\b(?P<when>after|when|where|once|until|in) (?:(?:it|(?P<body>[\w-]+)) (?:has|have) )?(?:been )?"
    rf"(?:(?P<down>{DOWN})|(?P<up>{UP})|(?P<on>{ON})|(?P<round>{ROUND}))(?: down| up)?"
    r"(?: through)?(?: an? (?:distance|height|angle|way|depth)(?: of)?)? (?P<value>(?!with )[^\s,]+)"
    r"(?: (?:up|down|along) (?:slope|incline|plane|ramp|hill|floor|table))?(?=$|,? with )"
)
STANDS = re.compile(
    r"\b(?P<when>when|where|once|until|as|(?:just |right )?before) (?:it|(?P<body>[\w-]+)) (?:(?:is|becomes|has become|gets) |"
    r"makes (?:an angle (?:of )?)?(?P<value>[^\s,]+?)(?P<degrees>°| ?deg(?:rees)?)? with )"
    r"(?P<line>vertical|horizontal)(?=$|,? with )"
)


STRIKES = (
    r"(?:has |have )?(?:hits?|strikes?|struck|collides? with|collided with|bounced?s?(?: off| on)?|meets?|lands? on|touche[sd]|"
    r"pass(?:es|ed)? through|is (?:hit|struck)(?: by)?|catche?s|caught|reaches)(?: ([\w-]+))?"
)
STRUCK = re.compile(
    r"\b(?P<when>(?:(?:just|right|immediately|shortly) )?(?:before|after)|when|where|as|until) (?P<who>it|[\w-]+) "
    rf"{STRIKES}(?=$|,? with )"
)
LETTER = re.compile(r"[A-Za-z]\w?(?:_\w+)?")
SIDES = {"before": "just before", "after": "right after", "until": "until"}


def _struck(asked: Asked, text: str) -> str:
    """“just before PHASE” for “when BODY strikes the floor”, of the only blow, which touches it."""
    said = STRUCK.search(text)
    struck = [phase for phase in asked.problem.phases if phase.impulses]
    if said is None or len(struck) != 1:
        return text
    bodies = {*asked.problem.body_names}
    met = {name for element in struck[0].impulses for name in joined(element)} & bodies
    lines = [line for e in struck[0].impulses if isinstance(line := e.values.get("line"), Line)]
    other = {word for words, fits in SURFACES.items() if lines and not any(map(fits, lines)) for word in words.split("|")}
    fixed = {*GROUNDS.split("|")} - other if len(met) < 2 else ()  # what is struck is a body, or what stays where it is
    if said["who"] not in (*met, "it") or said[3] not in (None, "it", *met, *fixed):
        return text
    head, name = text[: said.start()], struck[0].name
    side = "until" if text.startswith("time") else SIDES.get(said["when"].split()[-1], "just before")
    strikes = (said["who"] == "it" and " is " not in said[0]) or head.endswith(f" of {said['who']} ")
    if said["when"] in ("when", "where", "as") and side != "until" and not strikes:
        both = f"“just before {name}” or “right after {name}”"
        raise Ambiguous(f"“{said[0]}” may be before the blow or after it", instead=f"write {both}.")
    return f"{head}{side} {name}{text[said.end() :]}"


END = re.compile(r"\b(upper|top|highest|lower|bottom|lowest|left|right)(?:most)? end(?: of ([\w-]+))?(?![\w-])")


def _ends(asked: Asked, said: re.Match[str]) -> str:
    """The end of a rod that is the upper, lower, left or right one where it starts."""
    rods = [body.name for body in asked.problem.bodies if body.shape.kind == "rod" and said[2] in (None, body.name)]
    if len(rods) != 1:
        return said[0]
    world = scene(asked)
    way = world.place(f"{rods[0]}.end") - world.place(f"{rods[0]}.start")
    gap = short(substitute(way.x if said[1] in ("left", "right") else way.y, world.motion.scope.start))
    upward = sign(gap, world.motion.assumptions).sense * (1 if said[1] in ("upper", "top", "highest", "right") else -1)
    return f"{rods[0]}.{'end' if upward > 0 else 'start'}" if upward else said[0]


def placed(asked: Asked, text: str) -> str:
    """The question with “where x = VALUE” for “after BODY has fallen VALUE” and “when BODY is vertical”. Raises StatementError
    where that is no place, or more than one."""
    text = END.sub(lambda said: _ends(asked, said), _struck(asked, text))
    for pattern, find in ((GONE, _gone), (STANDS, _standing)):
        said = pattern.search(text)
        value = said["value"] if said and LETTER.fullmatch(said["value"] or "") else None
        if value and value not in {*asked.problem.dimensions, "pi"}:
            what = f"“{value}” is not declared"
            raise StatementError(what, instead=f'write {value} = "length: …" under [parameters], or a number with its unit.')
        if said and is_formula(asked, said["value"] or "0"):
            when = "until" if said[1] == "until" else "where"
            phase, place = _of_phase(asked, partial(find, asked, said), text)
            text = f"{text[: said.start()]}{phase}{when} {place}{text[said.end() :]}"
    return text


def _of_phase(asked: Asked, find: Callable[[int], str], text: str) -> tuple[str, str]:
    """Where a coordinate says it: in the phase that is named; else in the first one, which is named where it is not so in all."""
    named = [k for k, name in enumerate(asked.names) if re.search(rf"\bin phase {re.escape(name)}(?![\w-])", text)]
    if named:
        return "", find(named[-1])
    place = find(asked.lasting)
    try:
        told = {find(other) for other in range(asked.lasting + 1, len(asked.names))} if place != text else set()
    except RbpsymError:
        told = {""}
    return f"in phase {asked.names[asked.lasting]} " if told - {place} else "", place


def is_formula(asked: Asked, text: str) -> bool:
    """Whether a text is a formula in the parameters."""
    known = [*asked.problem.dimensions]
    with suppress(RbpsymError):
        return names_in(scalar(read_infix(text, known))) <= {*known, "pi"}
    return False


def _body(asked: Asked, named: str | None, text: str, names: list[str]) -> str:
    """The body that is named, or the one of which the question is, or the only one. Raises StatementError."""
    about = [name for name in names if re.search(rf"\bof {re.escape(name)}\b", text)]
    found = [named] if named and named != "it" else about or names
    if len(found) != 1 or found[0] not in names:
        told = " or ".join(f"“{name}”" for name in names)
        raise StatementError(f"“{named or 'it'}” is no body that goes so", instead=f"name {told}." if told else "name a place.")
    return found[0]


def _gone(asked: Asked, said: re.Match[str], phase: int) -> str:
    world, names = scene(asked, phase), list(asked.problem.body_names)
    name = _body(asked, said["body"], said.string[: said.start()], names)
    if said["down"] or said["up"]:
        way = 1 if said["up"] else -1
        gap = world.bound(f"y component of displacement of {name}.cm").number - _value(world, said) * way
        try:
            return equation(world, (gap,), f"“{name}” has gone so far")
        except StatementError:
            if timed := _in_time(asked, phase, f"y component of displacement of {name}.cm", _value(world, said) * way):
                return timed
            raise
    what = f"angle of {name}" if said["round"] else f"way of {name}"
    free = mover(world.study) or next(iter(world.study.system.independent), "t")
    rates = _rates(world, name, free, turns=bool(said["round"]))
    size = short(sum((rate * rate for rate in rates[1:]), rates[0] * rates[0]))
    onwards = 1 if free == "t" else sense(world.motion, free) if free in world.motion.scope.start else 0
    if not onwards and free in world.motion.scope.start:
        push = first_push(world.motion, free)
        onwards = sense_stated(world.study, push) or sense_at_sample(world.study, push)
    if not onwards or is_zero(size) or not _is_led(world, name, free, turns=bool(said["round"])):
        counted = f"angle turned by {name}" if said["round"] else f"displacement of {name}.cm"
        if timed := _in_time(asked, phase, counted, _value(world, said), is_size=True):
            return timed
        raise StatementError(
            f"the {what} is not told by one coordinate that goes on in one sense",
            instead=f"say where: “where {free} = VALUE”.",
        )
    begun = world.motion.scope.start.get(free, NOTHING)
    return f"{free} = {to_machine(present(short(begun + _value(world, said) / root(size) * onwards)))}"


def _in_time(asked: Asked, phase: int, counted: str, value: Scalar, *, is_size: bool = False) -> str | None:
    """When what is counted from the start, or its size, has a value, if it grows with the time or its square: straight on."""
    with suppress(RbpsymError):
        found = found_of(asked, Question("", counted, of="t")).values if not phase else ()
        for power in (1, 2):
            rates = [short(part / symbol("t") ** power) for part in found]
            if any(rates) and not any(depends_on(rate, "t") for rate in rates):
                size = root(short(sum((rate * rate for rate in rates), NOTHING))) if is_size else rates[0]
                time = short(value / size) if power == 1 else root(short(value / size))
                return f"t = {to_machine(present(time))}"
    return None


def along_a_line(asked: Asked, name: str, free: str) -> bool:
    """Whether a body moves along a straight line as a coordinate grows, in the first phase in which it moves."""
    for place in range(asked.lasting, len(asked.names)):
        world = scene(asked, place)
        if any(_rates(world, name, free, turns=False)):
            return _is_led(world, name, free, turns=False)
    return False


def _is_led(world: AskedPhase, name: str, free: str, *, turns: bool) -> bool:
    """Whether a body goes straight on, or turns, as that coordinate grows, and as no other one does, nor the time."""
    names = (*world.motion.scope.rates, "t")
    return not any(
        (rate and other != free) or any(depends_on(rate, each) for each in names)
        for other in names
        for rate in _rates(world, name, other, turns=turns)
    )


def _value(world: AskedPhase, said: re.Match[str]) -> Scalar:
    return scalar(read_infix(said["value"], world.names))


def _rates(world: AskedPhase, name: str, free: str, *, turns: bool) -> list[Scalar]:
    """What a body's place, or its angle, gains with a coordinate."""
    if turns:
        return [derivative(world.body(name).pose.angle, free)]
    moved = world.bound(f"displacement of {name}.cm").arrow.plane
    return [derivative(moved.x, free), derivative(moved.y, free)]


def _standing(asked: Asked, said: re.Match[str], phase: int) -> str:
    """Where a rod, or a string, is vertical or horizontal: the only such place to which the motion comes."""
    world = scene(asked, phase)
    leads = {body.name: world.body(body.name).pose.angle for body in asked.problem.bodies if body.shape.kind == "rod"}
    strings = {element.name: element["path"] for element in asked.problem.of_kind("string") if len(element["path"]) == 2}
    if path := strings.get(said["body"]):
        first, last = (world.place(turn.center.label) for turn in path)
        leads |= dict.fromkeys([said["body"]], next(iter((last - first).parts)))
    name = _body(asked, said["body"], said.string[: said.start()], [*leads])
    angle = leads[name]
    free = next((n for n in (mover(world.study), *world.study.system.independent, "t") if n and derivative(angle, n)), None)
    slope = derivative(angle, free) if free else None
    moved = (*world.motion.scope.rates, "t")
    if free is None or slope is None or any(depends_on(slope, other) for other in moved):
        raise StatementError(f"the angle of “{name}” is not told by one coordinate", instead="say where that has which value.")
    rest = short(angle - slope * symbol(free))
    leaning = scalar(read_infix(said["value"] or "0", world.names)) * (PI / 180 if said["degrees"] else 1)
    turns = (PI * turn / 2 for turn in range(-4, 5) if bool(turn % 2) is (said["line"] == "vertical"))
    angles = dict.fromkeys(short((turn + leaning * side - rest) / slope) for turn in turns for side in (1, -1))
    places = (to_machine(present(angle)) for angle in angles)
    found = [f"{free} = {place}" for place in places if _comes(asked, phase, free, place)]
    if len(found) != 1:
        told = " or ".join(f"“where {place}”" for place in found)
        what = f"“{name}” stands so at {len(found) or 'no'} places to which the motion is known to come"
        raise StatementError(what, instead=f"write {told}." if found else f"say where: “where {free} = VALUE”.")
    return found[0]


def _comes(asked: Asked, phase: int, name: str, place: str) -> bool:
    """Whether the motion comes to a place, other than its start; where that is not known, whether it is in the range."""
    world = scene(asked, phase)
    try:
        if is_zero(place_in(world, name, place) - world.motion.scope.start.get(name, symbol(name))):
            return False
        moment_of(asked, When("reaches", (name, place), f"where {name} = {place}"), Question("", name))
    except NoClosedForm:
        return True
    except RbpsymError:
        return False
    return True
