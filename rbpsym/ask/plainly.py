"""A question in the words that all else reads: what is only another way to write it in a problem, with its names."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress

from rbpsym.ask.asked import Asked, NoClosedForm, NotMet
from rbpsym.ask.found import sense_stated
from rbpsym.ask.moments import coordinate_of, moment_of
from rbpsym.ask.named import in_names
from rbpsym.ask.placed import along_a_line, placed
from rbpsym.ask.question import GREATEST, SUPERLATIVES, Question, When
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.signs import sign
from rbpsym.errors import Ambiguous, RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, depends_on, is_zero, names_in, short
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
    r"\b(after|until|for) (?:it has made |first )?(\d+(?:[./]\d+)?) (?:full )?(?:turn|revolution|rotation)s?( of [\w-]+)?"
    r"(?=$|,? with )"
)
TO_THE_END = re.compile(r"total (way|angle|change) of (\w+)(?=$|,? with )")  # until friction has stopped it
WITHIN = re.compile(rf"(.+?),? (with {_VALUE}(?:(?:,| and) {_VALUE})*),? ((?:is|are) \w+|(?:for|in limit) .+)")


_END, _STOPS = r"(?=$|,? with )", r"(?:(?:it )?(?:stops|comes to rest)|stopping|coming to rest)"
_GOES = "goes|moves|rolls|slides|travels|climbs|rises"
BLOWS = ("blow", "bounce", "collision", "impact")  # of which the name of a problem is none
# words that say the same in any problem
WORDS: tuple[tuple[str, str | Callable[[re.Match[str]], str]], ...] = (
    (r"\b(?:he|she)\b", "it"),
    (r"^((?:horizontal |vertical )?(?:speed|velocity|kinetic energy)) (?:with|at) which ([\w-]+) (?!is )", r"\1 of \2 when \2 "),
    (r"^(angle|position|place) at which ", r"\1 where "),
    (r"\bin (vertical|horizontal) position\b", r"when it is \1"),
    (r"^(?:least |smallest |minimum )?(coefficient of (?:static )?friction|mu) (?:needed|required) (?:for [\w-]+ not to slip|"
     r"so that [\w-]+ does not slip|to prevent slip(?:ping)?)" + _END, r"\1 for which it does not slip"),
    (r"^amplitude of small (?:oscillations?|vibrations?)" + _END, "amplitude for small oscillations"),
    (r"\bmost (compressed|stretched|extended)\b", r"\1 most"),
    (rf"\b(\w+) is compressed most{_END}", r"compression of \1 is largest"),
    (rf"\b(\w+) is (?:stretched|extended) most{_END}", r"elongation of \1 is largest"),
    (r"\b(where|when|until|once) ([\w-]+) (?:moves|travels|is moving) (?:at|with) (?:a )?(?:speed )?(?:of )?(?=\S+)",
     r"\1 speed of \2 = "),
    (r"\bratio of (\w+) to (\w+) (kinetic energy|component)\b", r"ratio of \1 \3 to \2 \3"),
    (r"^equilibrium (?:position|angle|length|value) of ", "equilibrium of "),
    (r"\bfor which ([\w-]+) (?:slides|moves|rolls|travels|goes) (?:through )?(?:an? distance )?(?:of )?(?=[^\s]+$)",
     r"for which distance travelled by \1 = "),
    (r"(\b(?:where|when|until|once) (?:[\w ]+ )?of [\w. ]+?) (?:vanishes|is zero)" + _END, r"\1 = 0"),
    (r" as (?:a )?functions? of (\w+),? (?:with|where|at) \1 ?= ?", r" where \1 = "),  # a function, and where: its value there
    (rf" (?:needed |required )?(?:for|to) (?:pure rolling|roll(?:ing)? without slipping|(?:no|prevent) slip(?:ping)?){_END}",
     " for which it does not slip"),
    (r"^how far(?: (?:up|down|along))?(?: [\w ]+?)? (?:does|will|can|is) ([\w-]+) "
     rf"(?:go|move|roll|slide|travel|climb|rise|driven|pushed|moved)(?: (?:before|until) (?:{_STOPS}|it comes back))?{_END}",
     r"distance travelled by \1"),
    (rf"^distance (?:that )?(it|[\w-]+) (?:{_GOES})(?: (?:before|until) {_STOPS})?{_END}", r"distance travelled by \1"),
    (rf"^time (?:it takes |needed |required )?(?:to (?:stop|come to rest)|before {_STOPS}){_END}", "time until it comes to rest"),
    (r"\b(?:before|until) (?:stopping|coming to rest)\b", "until it comes to rest"),
    (r"^((?!does |do |will |is ).*)\bbefore (it|[\w-]+) (stops|comes to rest)\b", r"\1until \2 \3"),
    (r"^time (?:at which|when|after which) ", "time until "),
    (r"^time (?:it takes |needed |taken |required )?to (?:cover|travel|move|slide|roll) (?:through )?(?=an? |[^\s]+" + _END + ")",
     "time until it has moved "),
    (r"^(\w+) (?:needed|required|necessary) to stop ([\w-]+)", r"\1 for which \2 stops"),
    (r"\b((?:it|[\w-]+) (?:stops|comes to rest) (?:after|in|within)) an? (?:distance|time|way)(?: of)? ", r"\1 "),
    (r"\bfor which there is no (?=\w+)(.+?)" + _END, r"for which \1 vanishes"),
    (r"\bfor which (it|[\w-]+) (?:just )?(?:starts?|begins?) to (?:move|slide)" + _END, r"for which \1 slips"),
    (rf"^((?!(?:{'|'.join(SUPERLATIVES)})\b).*)(?<!right )(?<!just )(?<!immediately )\bafter ({'|'.join(BLOWS)}){_END}",
     r"\1right after \2"),
    (rf"\b[\w-]+ (?:rebounds|swings)(?: back| up| out)? to (\w+) = (\S+){_END}", r"\1 comes to rest at \1 = \2"),
    (r"\bno energy is lost\b", "energy lost vanishes"),
    (r"\bratio of amplitudes (?:of )?", "ratio of "),
    (r"\b(?:energy|heat) (?:lost|dissipated|produced|generated|absorbed) (?:to|by|in) (friction|drag|damper|damping)"
     r"(?= (?:until|up to|during|over|from|as|where|when|after|in)\b)", r"minus work of \1"),
    (r"^time (?:for|in which) ([\w-]+) (?:to )?(fall|ris)(?:e|s|es)? ", r"time until \1 has \2en "),
    (r"^time (?:for|in which) ([\w-]+) (?:to )?(?:move|slide|roll|travel|cover)s? ", r"time until \1 has moved "),
    (r"\bangular speed(?! of)\b", "magnitude of angular velocity"),
    (r"\b([\w-]+) (?:stops|comes to rest|is at rest) (?:in|after) (?:impact|collision|blow)" + _END,
     r"velocity of \1 right after impact vanishes"),
    (r"^fraction of (?:kinetic )?energy (?:that is )?lost(?: (?:in|during|by|at) (\w+))?" + _END,
     lambda said: f"ratio of energy lost to kinetic energy just before {said[1] or 'impact'}"),
    (r"\bwork done by ", "work of "),
    (r"(^|\bfor which )initial ((?:angular )?(?:acceleration|deceleration|velocity|speed)(?: of [\w.-]+)?|"
     r"[\w ]*(?:force|tension|friction|reaction|energy)(?: \w+)?(?: (?:on|of) [\w.-]+)?)(?=$| (?:=|is|vanishes)\b|,? with )",
     r"\1\2 at start"),
    (r"^distance (?:of|from) cent(?:re|er) of mass (?:from|to) (\w+)", r"distance from \1 to system.cm"),
    (r"^(moment of inertia|radius of gyration) (?=about )", r"\1 of system "),
    (r"^natural frequency without damping" + _END, "undamped frequency"),
)  # fmt: skip
HEIGHT = re.compile(
    r" (?:(?:at|in)|(?:where|when|once|as) (?:it|[\w.-]+) (?:is (?:at|in)|passes(?: through)?|reaches)) (?:its )?"
    r"(?:(lowest|highest) (?:point|place|position)|(top|bottom))(?: of (?:its )?(?:path|swing|hill|loop|circle|track|arc))?"
    r"(?=$|,? with )"
)
DISTANCE = (  # up to the first rest, to which it goes one way
    r"(?:^|(?<=for which ))(?:(?:stopping|braking|sliding) distance(?: of)?|distance (?:travelled|covered|moved)(?: by)?)"
    r"(?: (?!until|in)(\w+))?(?P<phase> in phase [\w-]+)?(?: until (\w+ (?:stops|comes to rest)))?(?=$|,? with | = )"
)
OF_SWINGS = (
    r"^((?:(?:undamped|damped|natural|circular|angular) )*(?:frequency|period|amplitude)|damping ratio|logarithmic decrement|"
    r"decay rate)"
    r"(?: of (?:free |small |damped )?(?:oscillations?|vibrations?|swings?|motion))?(?=$|,? (?:with|for|if|when|where|in|about) )"
)
DAMPED = r"[\w-]+(?= is (?:critically |over|under)damped)"
ALL_SWINGS = (
    r"^(?:(normal|natural) )?(frequencies|periods|(?:lowest|highest) frequency|(?:longest|shortest) period)(?=$|,? with )"
)
CRITICAL = r"^(\w+) for (?:(critical) damping|damping to be (critical))(?=$|,? with )"
STAYS = r"\bfor which (it|\w+) (?:(?:stays|remains) at rest|is (?:in equilibrium|balanced))(?=$|,? with )"
DRIVES = ("couple", "force", "pull", "prescribed", "prescribed-angle")
HEAT = re.compile(r"(?:heat (?:produced|generated)|(?:mechanical )?energy dissipated)\b.* (?:until|up to|during|over|from) ")
TURNED = r"^angle (?:through|by) which (\w+) (?:turns|rotates|has turned|has rotated)\b"
OF_TURNS = r"^(number of (?:turns|revolutions|rotations))(?! of| made)"
SLOWED = re.compile(r"\b(?:angular )?deceleration(?: of ([\w-]+))?(?=$|[ ,])")
STOPS = re.compile(r"\b((?:it|\w+) (?:stops|comes to rest)) (after|in|within) (.+?)(?=$|,? with )")
TURNS = re.compile(r"(\d+(?:[./]\d+)?|[A-Za-z]\w*) (?:full )?(?:turn|revolution|rotation)s?")
BACK = re.compile(
    r"\b(until|when|where|once) \w+ (?:comes back|returns|is back)"
    r"(?: to (?:where it started|(?:its )?(?:start|starting (?:point|place))))?(?=$|,? with )"
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
    turns, who, found = TURNS.fullmatch(said[3]), said[1].split()[0], NUMBER
    name = (mover(asked.study(asked.lasting)) or who) if who == "it" else who
    way = f"magnitude of displacement of {name}" if name in asked.problem.body_names else _way(asked, name)
    with suppress(RbpsymError):
        found = dimension_of(read_infix(said[3], [*asked.problem.dimensions]), asked.problem.dimensions)
    counted = "number of turns" if turns else {TIME: "time", LENGTH: way}.get(found)
    how = "<=" if said[2] == "within" else "="
    return f"{counted} until {said[1]} {how} {turns[1] if turns else said[3]}" if counted else said[0]


def _require_heat(asked: Asked) -> None:
    """Raise StatementError where what the motion loses is not all heat: something drives it, and does work too."""
    problems = (asked.problem, *(phase.problem for phase in asked.problem.phases))
    elements = (element for each in problems for element in (*each.interactions, *each.constraints))
    drives = next((element.name for element in elements if element.kind in DRIVES), None)
    if drives is not None:
        what = f"“{drives}” does work too: what becomes heat is not what the motion loses"
        raise Ambiguous(what, instead="ask for the work of what rubs or brakes: “minus work of FORCE until …”.")


def _way(asked: Asked, name: str, of: str = "way") -> str:
    """How far a coordinate goes; a way in the sense in which it sets out: that has no sign."""
    motion = asked.world(asked.lasting).motion
    way = sense(motion, name) or sense_stated(asked.study(asked.lasting), first_push(motion, name)) if of == "way" else 1
    return f"{SENSES[way]}displacement of {name}"


SENSES = {1: "", -1: "minus ", 0: "magnitude of "}


def _slowed(asked: Asked, said: re.Match[str]) -> str:
    """By how much the speed of a coordinate falls in a second, or of that which alone moves a body."""
    study = asked.study(asked.lasting)
    name = coordinate_of(asked, said[1]) if said[1] else mover(study)
    begun = sign(study.system.scope.start.get(f"{name}_dot", NOTHING), study.assumptions).sense
    return f"{'minus ' if begun > 0 else ''}acceleration of {name}" if name and begun else said[0]


def _displaced(asked: Asked, said: re.Match[str]) -> str:
    """The way of the coordinate that is named, or alone moves, if it is a length; of a body that moves along a line, the size of
    its own."""
    study, names = asked.study(asked.lasting), asked.problem.body_names
    phase = said["phase"] or ""
    if phase and not said[3]:
        return said[0]
    way, end = None if study.at_start else mover(study), said[3] or "it stops"
    if said[1] in names and len(names) > 1:
        with suppress(RbpsymError):
            if along_a_line(asked, said[1], coordinate_of(asked, said[1])):
                return f"magnitude of displacement of {said[1]}{phase} until {said[3] or f'{said[1]} stops'}"
        return said[0]
    way = way if said[1] in (None, "it", way, *names) else None
    if way is None or asked.problem.dimensions[way] != LENGTH:
        return said[0]
    return f"magnitude of displacement of {way}{phase} until {end}" if phase else f"{_way(asked, way)} until {end}"


def _extreme(asked: Asked, said: re.Match[str]) -> str:
    """Where the body that is named, or the only one, is highest or lowest; of several where all are so together."""
    bodies = asked.study(asked.lasting).system.bodies
    named = [name for name in bodies if re.search(rf"\b{re.escape(name)}\b", said.string)] or [*bodies]
    first, *others = [bodies[name].velocity.y for name in named]
    if others and not (first and all(sign(short(rate / first), asked.first.assumptions).kind == "positive" for rate in others)):
        return said[0]
    return f" where height of {named[0]}.cm is {'smallest' if said[1] == 'lowest' or said[2] == 'bottom' else 'largest'}"


def _kept_at_rest(asked: Asked, said: re.Match[str]) -> str:
    """Of one coordinate that starts from rest: that it has no acceleration, where that hangs on what is asked for."""
    study, wanted = asked.study(asked.lasting), said.string[: said.start()].split()[-1:]
    free = study.system.independent if not study.at_start else ()
    if len(free) > 1 and said[1] in asked.problem.body_names and not any(map(study.system.scope.start.get, study.system.speeds)):
        return f"for which acceleration of {said[1]} at the start vanishes"
    if len(free) != 1 or study.system.scope.start.get(f"{free[0]}_dot"):
        return said[0]
    gain = (study.dynamics.accelerations or {}).get(f"{free[0]}_ddot", NOTHING)
    hangs = {*wanted} <= names_in(gain)
    return f"for which acceleration of {free[0]} at the start vanishes" if hangs else said[0]


def _of_swings(asked: Asked, text: str) -> str:
    """A frequency or a damping ratio of which nothing is said is that of the only coordinate; of all modes, of any; what is
    damped is the coordinate of a body."""
    system = asked.study(asked.lasting).system if re.search(f"{OF_SWINGS}|{ALL_SWINGS}|{CRITICAL}|{DAMPED}", text) else None
    if system is None or not (names := system.independent):
        return text
    text = re.sub(ALL_SWINGS, rf"\2 of {names[0]}", text)
    if len(names) > 1:  # told if it is the same of all
        return re.sub(OF_SWINGS, r"\1", text)
    text = re.sub(CRITICAL, rf"\1 for which {names[0]} is critically damped", re.sub(OF_SWINGS, rf"\1 of {names[0]}", text))
    return re.sub(DAMPED, lambda said: names[0] if said[0] in ("it", *system.bodies) else said[0], text)


def _own_coordinate(asked: Asked, name: str) -> str:
    """The coordinate that moves a body and no other one, or alone moves it."""
    system, names = asked.study(asked.lasting).system, {coordinate.name for coordinate in asked.problem.coordinates}
    if name not in asked.problem.body_names or name in names:
        return name
    rates = {body: (state.velocity.x, state.velocity.y, state.omega) for body, state in system.bodies.items()}
    moves = {body: {n for n in system.independent if any(depends_on(r, f"{n}_dot") for r in rs)} for body, rs in rates.items()}
    own = moves[name].difference(*(moves[other] for other in moves if other != name)) or moves[name]
    return own.pop() if len(own) == 1 else name


def _of_lone(asked: Asked, text: str) -> str:
    """“until its speed is v_1”, “time to reach omega_1” of the only coordinate that is a length, or an angle; “how high does it
    rise” of the only body; “largest x when critically damped” where x comes to rest."""
    named, bodies = {c.name: c.quantity.dimension for c in asked.problem.coordinates}, asked.problem.body_names
    lone = {kind: name for name, kind in named.items() if [*named.values()].count(kind) == 1}
    lone |= {kind / TIME: f"speed of {name}" for kind, name in lone.items()}

    def put(said: re.Match[str]) -> str:
        kind = (NUMBER if "ang" in said[2] else LENGTH) / (TIME if said[1] else NUMBER)
        return f"{said[1]}{lone[kind]}{said[3]}" if kind in lone else said[0]

    def reached(said: re.Match[str]) -> str:
        what = lone.get(asked.problem.dimensions.get(said[2], TIME))
        return f"{said[1]} until {what} = {said[2]}" if what else said[0]

    def risen(said: re.Match[str]) -> str:
        who = bodies[0] if said[1] == "it" and len(bodies) == 1 else said[1]
        rest = " after impact" if REBOUNDS.search(said[0]) and not said[2] else said[2].replace(" right", "")
        return f"largest y component of displacement of {who}.cm{rest}" if who in bodies else said[0]

    text = MOST.sub(lambda said: f"{said[1]} where {said[1]} comes to rest{said[2]}" if said[1] in named else said[0], text)
    text = FARTHEST.sub(lambda said: f"{said[1]} comes to rest" if said[1] in named else said[0], text)
    text = OF_BODY.sub(lambda said: f"{said[1]} of {_own_coordinate(asked, said[2])}", text)
    for pattern in (LONE, ITS_SPEED):
        text = pattern.sub(put, text)
    return RISES.sub(risen, TO_REACH.sub(reached, text))


_CASE = "(?:,? (?:for|with|under|if|when))? (?:critical|weak|strong|small|steady)"
MOST = re.compile(rf"^(?:{'|'.join(GREATEST)}) (\w+)((?:,? (?:for|with|under|if|when))? (?:critical damping|critically damped))$")
FARTHEST = re.compile(rf"(?<=(?:til|hen|ere|nce) )(\w+) is (?:{'|'.join(GREATEST)})(?={_CASE})")
OF_BODY = re.compile(
    r"^((?:stable |unstable |natural )*(?:period|frequency|amplitude|equilibrium)) "
    r"of (?:(?:small )?(?:oscillations?|swings?|vibrations?) of )?([\w-]+)(?=$|[ ,])"
)
LONE = re.compile(r"^()(angle|position|place|angle turned)( (?:where|when|until|after) )")
ITS_SPEED = re.compile(
    r"\b((?:until|when|where|once) )(?:its )?(?:magnitude of )?((?:angular )?(?:speed|velocity))( (?:=|is|reaches) (?!.*est$))"
)
TO_REACH = re.compile(r"^(time|angle turned|distance) (?:needed |required |it takes )?(?:to|until it) reach(?:es)? (\w+)$")
UP = r"(?:rises?|goes?(?: up)?|swings?|bounces?|rebounds?|reach(?:es)?|jumps?|climbs?)"
RISES = re.compile(
    rf"^(?:how high (?:does|will|can) |(?:vertical |greatest |maximum |largest )*height (?:to which |that |reached by ))"
    rf"(it|[\w-]+)(?: {UP})?((?: right)?(?: after [\w-]+)?)$"
)
REBOUNDS = re.compile("bounce|rebound")


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
    plain = in_names(asked.problem, plain)
    _require_heat(asked) if HEAT.match(plain) else None
    blows = "|".join(re.escape(element.name) for phase in asked.problem.phases for element in phase.impulses)
    plain = re.sub(rf"(^|\bfor which )({blows or '(?!)'})(?=$| )", r"\1impulse of \2", plain)
    phases = [name for k, name in enumerate(asked.names) if name not in ("rest", "equilibrium", *(() if k else BLOWS))]
    named = "|".join(map(re.escape, phases))
    plain = re.sub(rf"\b(?:in|while) ({named})(?: phase)?(?=$| )", r"in phase \1", plain)
    for pattern, written in WORDS:
        plain = re.sub(pattern, written, plain)
    plain = _of_swings(asked, placed(asked, plain))
    plain = re.sub(DISTANCE, lambda said: _displaced(asked, said), plain)
    plain = re.sub(STAYS, lambda said: _kept_at_rest(asked, said), plain)
    if phases[1:] and plain.startswith("final "):
        plain = f"{plain.removeprefix('final ')} in phase {phases[-1]}"
    plain = HEIGHT.sub(lambda said: _extreme(asked, said), plain)
    plain = re.sub(TURNED, r"angle turned by \1", plain)
    if re.match(OF_TURNS, plain):
        turning = [name for name, state in asked.study(asked.lasting).system.bodies.items() if not is_zero(state.omega)]
        plain = re.sub(OF_TURNS, rf"\1 of {turning[0]}", plain) if len(turning) == 1 else plain
    plain = _of_lone(asked, plain)
    plain = SLOWED.sub(lambda said: _slowed(asked, said), plain)
    plain = STOPS.sub(lambda said: _stopped(asked, said), plain)
    moved = "|".join(("t", *(coordinate.name for coordinate in asked.problem.coordinates)))
    plain = re.sub(rf"(?<=\w),? with (?=(?:{moved}) ?= ?)", " where ", plain)
    plain = BACK.sub(lambda said: f"{said[1]} {_begun(asked)}", plain)
    plain = _in_strings(asked, plain)
    turned = "{} number of turns{} = {}".format
    plain = TURNED_ROUND.sub(lambda s: turned("where" if s[1] == "after" else "until", s[3] or "", s[2]), plain)
    system = asked.study(asked.lasting).system
    if (said := TO_THE_END.match(plain)) and stops(system) and not slips_on(system, said[2]):
        plain = TO_THE_END.sub(lambda said: f"{_way(asked, said[2], said[1])} until {said[2]} comes to rest", plain)
    constants = "|".join(quantity.name for quantity in asked.problem.parameters)
    plain = re.sub(rf"(?<=\w),? (?:where|when|if|for|at) (?=(?:{constants or '(?!)'}) ?= ?)", " with ", plain)
    return " ".join((said[1], said[3], said[2])) if (said := WITHIN.fullmatch(plain)) else plain
