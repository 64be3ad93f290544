"""A question in the words that all else reads: what is only another way to write it in a problem, with its names."""

from __future__ import annotations

import re
from contextlib import suppress

from rbpsym.ask.asked import Asked, NoClosedForm, NotMet
from rbpsym.ask.forms import sense_stated
from rbpsym.ask.moments import moment_of
from rbpsym.ask.question import Question, When
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, names_in, short
from rbpsym.mechanics.arrivals import mover
from rbpsym.mechanics.friction import slips_on, stops
from rbpsym.present.forms import present
from rbpsym.quantities import LENGTH, NUMBER, TIME
from rbpsym.quantity.path import first_push, sense
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.paths import tensions
from rbpsym.typeset.machine import to_machine

_VALUE = r"\w+ ?= ?[^\s,=]+"
TURNED_ROUND = re.compile(
    r"\b(after|until|for) (?:it has made |the first )?(\d+(?:[./]\d+)?) (?:full )?(?:turn|revolution|rotation)s?(?=$|,? with )"
)
TO_THE_END = re.compile(r"(?:the )?total (way|angle|change) of (?:the )?(\w+)(?=$|,? with )")  # until friction has stopped it
WITHIN = re.compile(rf"(.+?),? (with {_VALUE}(?:(?:,| and) {_VALUE})*),? ((?:is|are) (?:the )?\w+|(?:for|in the limit) .+)")


VANISHES = r"(\b(?:where|when|until|once) (?:the )?(?:[\w ]+ )?of [\w. ]+?) (?:vanishes|is zero)(?=$|,? with )"
AT_PLACE = r" as (?:a )?functions? of (?:the )?(\w+),? (?:with|where|at) \1 ?= ?"  # a function, and where: its value there
HEIGHT = re.compile(r" (?:at|in) (?:the|its) (lowest|highest) (?:point|place)(?: of (?:the|its) (?:path|swing))?(?=$|,? with )")
DISTANCE = (  # up to the first rest, to which it goes one way
    r"^(?:the )?(?:(?:stopping|braking|sliding) distance(?: of (\w+))?|distance (?:travelled|covered|moved)(?: by (\w+))?)"
    r"(?: until (\w+ (?:stops|comes to rest)))?(?=$|,? with )"
)
STAYS = r"\bfor which (?:it|\w+) (?:(?:stays|remains) at rest|is (?:in equilibrium|balanced))(?=$|,? with )"
BLOWS = ("blow", "bounce", "collision", "impact")  # of which the name of a problem is none
DRIVES = ("couple", "force", "pull", "prescribed", "prescribed-angle")
OF_GRAMMAR = ("system", "rest", "start", "equilibrium", "time", "turning")
TURNED = r"^(?:the )?angle (?:through|by) which (?:the )?(\w+) (?:turns|rotates|has turned|has rotated)\b"
STOPS = re.compile(r"\b((?:it|(?:the )?\w+) (?:stops|comes to rest)) (after|in|within) (.+?)(?=$|,? with )")
HEAT = re.compile(
    r"(?:the )?(?:heat (?:produced|generated)|(?:mechanical )?energy dissipated)\b.* (?:until|up to|during|over|from) "
)
TURNS = re.compile(r"(\d+(?:[./]\d+)?) (?:full )?(?:turn|revolution|rotation)s?")
BACK = re.compile(
    r"\b(until|when|where|once) (?:the )?\w+ (?:comes back|returns|is back)"
    r"(?: to (?:where it started|(?:the|its) (?:start|starting (?:point|place))))?(?=$|,? with )"
)


def _begun(asked: Asked) -> str:
    """“x = VALUE” of the start of the one coordinate that moves. Raises StatementError where none is known."""
    study = asked.study(asked.lasting)
    if (name := mover(study)) is None or (begun := study.system.scope.start.get(name)) is None:
        raise StatementError("what comes back is not known", instead="say which place: “time until x = 0”.")
    place = to_machine(present(begun))
    with suppress(NoClosedForm, NotMet):
        if moment_of(asked, When("reaches", (name, place)), Question("", "time")).how == "start":
            raise StatementError(f"that “{name}” comes back to where it starts is not known", instead="ask for it in one phase.")
    return f"{name} = {place}"


def _stopped(asked: Asked, said: re.Match[str]) -> str:
    """“number of turns until it stops = 20” for “it stops after 20 turns” (<= for “within”); of a length a way, of a time the
    time."""
    turns, name, found = TURNS.fullmatch(said[3]), mover(asked.study(asked.lasting)), NUMBER
    with suppress(RbpsymError):
        found = dimension_of(read_infix(said[3], [*asked.problem.dimensions]), asked.problem.dimensions)
    counted = "number of turns" if turns else {TIME: "time", LENGTH: name and _way(asked, name)}.get(found)
    how = "<=" if said[2] == "within" else "="
    return f"{counted} until {said[1]} {how} {turns[1] if turns else said[3]}" if counted else said[0]


def _require_heat(asked: Asked) -> None:
    """Raise StatementError where what the motion loses is not all heat: something drives it, and does work too."""
    problems = (asked.problem, *(phase.problem for phase in asked.problem.phases))
    elements = (element for each in problems for element in (*each.interactions, *each.constraints))
    drives = next((element.name for element in elements if element.kind in DRIVES), None)
    if drives is not None:
        what = f"“{drives}” does work too: what becomes heat is not what the motion loses"
        raise StatementError(what, instead="ask for the work of what rubs or brakes: “minus work of FORCE until …”.")


def _way(asked: Asked, name: str, of: str = "way") -> str:
    """How far a coordinate goes; a way in the sense in which it sets out: that has no sign."""
    motion = asked.world(asked.lasting).motion
    way = sense(motion, name) or sense_stated(asked.study(asked.lasting), first_push(motion, name)) if of == "way" else 1
    return f"{SENSES[way]}displacement of {name}"


SENSES = {1: "", -1: "minus ", 0: "magnitude of "}


def _displaced(asked: Asked, said: re.Match[str]) -> str:
    """The way of the one coordinate that moves, if it is a length; of a body, if there is no other."""
    study, of = asked.study(asked.lasting), said[1] or said[2] or "it"
    way = None if study.at_start else mover(study)
    [body, *more] = asked.problem.body_names
    if way is None or asked.problem.dimensions[way] != LENGTH or of not in ("it", way, *([] if more else [body])):
        return said[0]
    return f"{_way(asked, way)} until {said[3] or 'it stops'}"


def _extreme(asked: Asked, said: re.Match[str]) -> str:
    """Where the body that is named, or the only one, is highest or lowest; of several where all are so together."""
    bodies = asked.study(asked.lasting).system.bodies
    named = [name for name in bodies if re.search(rf"\b{re.escape(name)}\b", said.string)] or [*bodies]
    first, *others = [bodies[name].velocity.y for name in named]
    if others and not (first and all(sign(short(rate / first), asked.first.assumptions).kind == "positive" for rate in others)):
        return said[0]
    return f" where height of {named[0]}.cm is {'smallest' if said[1] == 'lowest' else 'largest'}"


def _kept_at_rest(asked: Asked, said: re.Match[str]) -> str:
    """Of one coordinate that starts from rest: that it has no acceleration, where that hangs on what is asked for."""
    study, wanted = asked.study(asked.lasting), said.string[: said.start()].split()[-1:]
    free = study.system.independent if not study.at_start else ()
    if len(free) != 1 or study.system.scope.start.get(f"{free[0]}_dot"):
        return said[0]
    gain = (study.dynamics.accelerations or {}).get(f"{free[0]}_ddot", NOTHING)
    hangs = {*wanted} <= names_in(gain)
    return f"for which acceleration of {free[0]} at the start vanishes" if hangs else said[0]


def _in_strings(asked: Asked, text: str) -> str:
    """The tensions T, T_1, T_2 of the only string, which has another name, by that name."""
    strings = [tensions(element) for element in asked.problem.of_kind("string")]
    names = strings[0] if len(strings) == 1 else ()
    own = dict(zip(("T",) if len(names) == 1 else (f"T_{k}" for k in range(1, len(names) + 1)), names, strict=True))
    known = {*asked.problem.dimensions, *(name for element in asked.problem.constraints for name in unknowns_of(element))}
    return TENSION.sub(lambda said: said[0] if said[0] in known else own.get(said[0], said[0]), text)


TENSION = re.compile(r"(?<![.\w])T(?:_\d)?(?![.\w])")


def plain_words(asked: Asked, text: str) -> str:
    """The words of a question as all else reads them: values of parameters (“with F = 0”) at the end, “in phase rolling” for
    “in rolling”, “impulse of J” for what is called J in a blow, “with F = 0” for “where F = 0”."""
    plain = " ".join(text.split()).rstrip(" ?.")
    _require_heat(asked) if HEAT.match(plain) else None
    bodies = "|".join(re.escape(body.name) for body in asked.problem.bodies if body.name not in OF_GRAMMAR)
    plain = re.sub(rf"\bthe (?=(?:{bodies or '(?!)'})(?![\w-]))", "", plain)
    blows = "|".join(re.escape(element.name) for phase in asked.problem.phases for element in phase.impulses)
    plain = re.sub(rf"(^|\bfor which )({blows or '(?!)'})(?=$| )", r"\1impulse of \2", plain)
    phases = [name for k, name in enumerate(asked.names) if name not in ("rest", "equilibrium", *(() if k else BLOWS))]
    named = "|".join(map(re.escape, phases))
    plain = re.sub(rf"\b(?:in|while) (?:the )?({named})(?: phase)?(?=$| )", r"in phase \1", plain)
    for pattern, written in ((VANISHES, r"\1 = 0"), (AT_PLACE, r" where \1 = ")):
        plain = re.sub(pattern, written, plain)
    plain = re.sub(DISTANCE, lambda said: _displaced(asked, said), plain)
    plain = re.sub(STAYS, lambda said: _kept_at_rest(asked, said), plain)
    plain = HEIGHT.sub(lambda said: _extreme(asked, said), plain)
    plain = re.sub(TURNED, r"angle turned by \1", plain)
    plain = STOPS.sub(lambda said: _stopped(asked, said), plain)
    moved = "|".join(("t", *(coordinate.name for coordinate in asked.problem.coordinates)))
    plain = re.sub(rf"(?<=\w),? with (?=(?:{moved}) ?= ?)", " where ", plain)
    plain = BACK.sub(lambda said: f"{said[1]} {_begun(asked)}", plain)
    plain = _in_strings(asked, plain)
    plain = TURNED_ROUND.sub(lambda said: f"{'where' if said[1] == 'after' else 'until'} number of turns = {said[2]}", plain)
    system = asked.study(asked.lasting).system
    if (said := TO_THE_END.match(plain)) and stops(system) and not slips_on(system, said[2]):
        plain = TO_THE_END.sub(lambda said: f"{_way(asked, said[2], said[1])} until {said[2]} comes to rest", plain)
    constants = "|".join(quantity.name for quantity in asked.problem.parameters)
    plain = re.sub(rf"(?<=\w),? (?:where|when|if|for|at) (?=(?:{constants or '(?!)'}) ?= ?)", " with ", plain)
    return " ".join((said[1], said[3], said[2])) if (said := WITHIN.fullmatch(plain)) else plain
