"""How questions about parameters are written, and what answers each."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress

from rbpsym.ask import ahead, made, optima, special, yesno
from rbpsym.ask.asked import Asked, NotMet
from rbpsym.ask.certified import LETTER
from rbpsym.ask.concluded import beyond, concluded, either, joined
from rbpsym.ask.finding import Finding, together
from rbpsym.ask.found import Answer
from rbpsym.ask.question import ASKED, PHASE, SUPERLATIVES
from rbpsym.ask.regions import equal_for
from rbpsym.ask.seen import AskedPhase, NeverThere, number_in, require_same, scene
from rbpsym.ask.senses import turned
from rbpsym.ask.wanted import Wanted
from rbpsym.decide.rooted import neat
from rbpsym.errors import RbpsymError, StatementError, there
from rbpsym.field import is_zero, short, substitute
from rbpsym.frozen import replace
from rbpsym.mechanics.arrivals import mover

_BEST = rf"({'|'.join(SUPERLATIVES)})"
_N, _FOR = r"(\w+)", r"(?:for|at|with) which"
_NO_MODE = r"(?!(?:lowest|highest) frequency of |(?:longest|shortest) period of \w+$)"  # that of a mode is a quantity
_BETWEEN = r"(?: (?:between|from) (?:\w+ = )?(.+) (?:and|to) (?:\w+ = )?(.+))?"
_APART = r"distance (?:from|between) [\w.]+ (?:to|and) [\w.]+"
_START = r"(?:start|beginning|release)"
_WAY = rf"(?:(?:from {_START} )?(?:until|up to|to)|between {_START} and) (?:where )?(\w+) (?:=|reaches|is) (.+)"
_UNTIL = r"(?: (?:before|until|up to) (\w+) (?:=|reaches|is) (.+))?"


_GOES = r"(?:->|→|tends to|goes to)"
LIMIT = rf"(.+) (?:in limit|(?:for|as|when)(?= \w+ ?{_GOES})) {_N} ?(?:{_GOES}|to) ?(.+)"
Rows = tuple[tuple[str, Callable[..., Finding]], ...]
ROWS: Rows = (
    (rf"does (.+) depend on {_N}", special.depends),
    (rf"is (.+) independent of {_N}", special.independent),
    (r"is (.+) (?:conserved|constant|kept)", special.conserved),
    (rf"(?:does|do|will|when does|where does) (\w+) vanish{_UNTIL}", yesno.vanishes),
    (rf"(?:does|will) (\w+ {ahead.EVENT} before .+)", lambda w, text, *_: ahead.comes_first(w, text)),
    (rf"(?:does|do|will) {_N} slip{_UNTIL}", lambda w, name, *to: yesno.does_not(w, _clause(f"{name} does not slip", *to))),
    (
        rf"(?:does|do|will) (?:it|\w+) (?:leave|lift|let go|lose contact|tip)(?: off| over)?{_UNTIL}",
        lambda w, *to: yesno.does_not(w, _clause("it stays in contact", *to)),
    ),
    (rf"(?:does|do|will) {_N} (?:reach|get to|come to) (.+)", lambda w, name, to: yesno.does(w, f"{name} reaches {to}")),
    (rf"is {_N} = (.+) (an equilibrium|a place of rest)", lambda w, name, at, what: yesno.does(w, f"{name} = {at} is {what}")),
    (rf"is {_N} = (.+) (un)?stable", yesno.rests_stably),
    (r"is (equilibrium of \w+) ((?:un)?stable)", lambda w, place, kind: yesno.does(w, f"{place} is {kind}")),
    (r"is (.+) (positive|negative)", lambda w, phrase, kind: yesno.does(w, f"{phrase} is always {kind}")),
    (r"is (.+ (?:>=|<=|>|<) .+)", yesno.does),
    (LIMIT, special.in_limit),
    (rf"(.+) (?:for|in limit|when) {_N} ?(>>|<<) ?{_N}", special.much),
    (rf"(.+) for (?:very )?(?:small|light|short|weak|thin) {_N}", lambda w, what, name: special.near(w, what, name, "0")),
    (rf"(.+) for (?:very )?(?:large|heavy|long|strong) {_N}", lambda w, what, name: special.near(w, what, name, "oo")),
    (rf"{_N} and {_N} (?:with|of|for) (?:equal|same) (.+)", optima.with_equal),
    (rf"for which {_N} is (.+) {_BEST}", ahead.extreme_for),
    (rf"{_N} where (.+) is {_BEST}", ahead.extreme_for),
    (rf"where is (.+) {_BEST}", lambda w, phrase, best: ahead.extreme_for(w, None, phrase, best)),
    (rf"for which {_N} (?:is|does|do|has) (.+)", lambda w, name, text: ahead.which(w, None, name, _told_after(text))),
    (rf"(?:critical|limiting) (?:value of )?{_N} {_FOR} (.+)", lambda w, name, text: ahead.which(w, None, name, text)),
    (rf"{_N} {_FOR} (.+) is {_BEST}( (?:when|where|at|right|just) .+)?",
     lambda w, name, phrase, best, there: ahead.extreme_for(w, name, phrase + (there or ""), best)),
    (rf"{_BEST} {_N} {_FOR} (.+)", ahead.which),
    (rf"{_BEST} (.+) {_FOR} (.+)", ahead.bounded),
    (rf"{_N} {_FOR} (.+)", lambda world, name, text: ahead.which(world, None, name, text)),
    (rf"{_NO_MODE}{_BEST} (.+?) {_WAY}", ahead.until),
    (rf"{_NO_MODE}{_BEST} (.+?) (?:until|up to) ([\w-]+)(?: begins)?",
     lambda w, best, phrase, phase: ahead.extremum(w, best, phrase, None, None, None, until=phase)),
    (rf"{_BEST} (.+) over {_N} ((?:where|when|at|right) .+)",
     lambda w, best, phrase, name, place: ahead.extremum(w, best, f"{phrase} {place}", name, None, None)),
    (rf"{_NO_MODE}{_BEST} ({_APART}|.+?)(?: over {_N})?{_BETWEEN}", ahead.extremum),
    (r"(.+) (?:with|for|if) (\w+ ?= ?.+)", special.with_values),
)

def _extreme_is(world: AskedPhase, name: str, text: str, best: str, to: str) -> Finding:
    """SYMBOL for which a greatest or least value is a given one, or vanishes. Raises StatementError without one such value."""
    phase = f" in phase {world.asked.names[world.number]}" if world.is_named else ""
    other, found = there(finding(world.asked, text + phase))
    if len(found.values) != 1 or found.relation != "=":
        raise StatementError(f"there is no single “{text}” that is known", instead="ask for that alone.")
    value = number_in(world, to or "0")
    require_same(world, found.values[0], value, (text, to))
    world.used.extend(other.used)
    world.doubts.extend(other.doubts)
    world.lasting.extend(other.lasting)
    world.standing.extend((*found.valid, *(found.asked[0] if found.asked else ())))
    equal = Wanted((short(found.values[0] - value),), world.motion.assumptions, equal=True)
    told = equal_for(world, None, name, equal, f"{text} = {to or 0}")
    return replace(told, **together(told, found))


# what is asked otherwise if the plain reading of it is refused
RESORTS: Rows = (
    (rf"{_N} {_FOR} ({_BEST} .+?) (?:(?:=|is|equals) (?!zero)(.+)|vanishes|is zero)", _extreme_is),
    (rf"{_N} where (.+?) ((?:=|is|equals|vanishes) ?.*)", lambda w, name, *said: ahead.which(w, None, name, " ".join(said))),
    (r"where (?:is|does) (.+?) (?:zero|vanish)", lambda w, phrase: ahead.which(w, None, _mover(w), f"{phrase} = 0")),
    (r"ratio of (\w+) to (\w+) (in \w+ mode)", made.of_mode),
    (r"(.+[-+*/].+)", made.made),
)
AFTER = re.compile(rf"({_BEST} .+) after (\w+)")
OF_A_PART = re.compile(r"ratio of .+ in phase .+ to ")  # the phase in it is that of the first part
WITH = re.compile(r"(.+) (?:with|if) (\w+ ?= ?[^=]+(?:(?:,| and) \w+ ?= ?[^=]+)*)")


def _mover(world: AskedPhase) -> str:
    """The one coordinate that moves. Raises StatementError where there are several, or none is known."""
    name = mover(world.study)
    if name is None:
        raise StatementError("several coordinates move, or none is known to", instead="say of which: “x where …”.")
    return name


def _told_after(text: str) -> str:
    """“it not slip” as “it does not slip”, “theta = 0 stable” as “theta = 0 is stable”."""
    text = re.sub(r"^(\w+|.+(?= not depend on )) not (\w+)", r"\1 does not \2", text)
    return re.sub(r" ((?:un)?stable|zero)$", r" is \1", text)


def _clause(text: str, until: str | None, place: str | None) -> str:
    return f"{text} until {until} = {place}" if until else text


def of_parameters(asked: Asked, text: str, letter: str = LETTER) -> Answer | None:
    """The answer to a question about parameters; None if it is none. Raises StatementError or ReadError."""
    found = finding(asked, text)
    if found is None:
        return None
    found = _at_rest(asked, *found) or found
    with suppress(RbpsymError):
        other = beyond(found[0], found[1].symbol) if found[1].symbol else None
        if other is not None:
            return joined(text, found, there(finding(other[0], text)), other[1], letter)
    is_equation = found[1].rule == "vanishes_for" and found[1].values
    side = turned(asked, found[0].demands, found[1].symbol) if is_equation else None
    if side is not None:
        with suppress(NotMet):  # from there the motion does not come so far: the condition on its sense is told
            return either(text, found, there(finding(side, text)), letter)
    return concluded(found[0], text, found[1], letter)


def _at_rest(asked: Asked, world: AskedPhase, found: Finding) -> tuple[AskedPhase, Finding] | None:
    """For what vanishes with the speeds: the values for which the motion just comes to rest at the place at which it is taken;
    None where there are none."""
    places = {question.when.words for question, _ in world.used if question.when and question.when.kind == "reaches"}
    if not (found.is_none and found.rule == "vanishes_for" and len(places) == 1):
        return None
    [(mover_, to)], value = places, found.grounds[0][1]["value"]
    phase = f" in phase {asked.names[world.number]}" if world.is_named else ""
    with suppress(RbpsymError):
        other = there(finding(asked, f"{found.symbol} for which {mover_} comes to rest at {to}{phase}"))
        images = [{found.symbol: place} for place in other[1].values]
        if images and all(is_zero(neat(substitute(value, at), world.motion.assumptions)) for at in images):
            return other
    return None


def resorted(asked: Asked, text: str, letter: str = LETTER) -> Answer | None:
    """The same for what is asked in another way; None if nothing is found."""
    for row in RESORTS:
        with suppress(RbpsymError):
            found = finding(asked, text, (row,))
            if found and (found[1].values or (found[1].verdict and found[1].verdict.is_proved)):
                return concluded(found[0], text, found[1], letter)
    return None


def finding(asked: Asked, text: str, rows: Rows = ROWS) -> tuple[AskedPhase, Finding] | None:
    """What is found for a question about parameters, not concluded yet. Raises as `of_parameters`."""
    rest = ASKED.sub("", text, count=1) if ASKED.match(text) else text
    if said := AFTER.fullmatch(rest):
        rest = said[1] if re.fullmatch(_START, said[3]) else f"{said[1]} in phase {said[3]}"
    phase, place = None if OF_A_PART.match(rest) else PHASE.fullmatch(rest), None
    if phase is not None:
        rest, place = phase[1] + (phase[3] or ""), asked.named(phase[2])
    if (said := WITH.fullmatch(rest)) and _is_found(said[1]):
        return finding(Asked(special.special_problem(scene(asked, place), said[2])), said[1])
    if (said := re.fullmatch(LIMIT, rest)) and _is_found(said[1]):
        inner = there(finding(asked, f"{said[1]} in phase {phase[2]}" if phase else said[1]))
        return inner[0], special.limit_of(*inner, *said.groups())
    for pattern, find in rows:
        if words := re.fullmatch(pattern, rest):
            return _found(asked, place, find, words.groups())
    if any(re.fullmatch(pattern, rest) for pattern, _ in made.MADE):
        world = scene(asked, place)
        return world, made.made(world, rest)
    return None


def _is_found(text: str) -> bool:
    """Whether it is a question of its own about parameters, or a quantity made of others."""
    return any(re.fullmatch(pattern, text) for pattern, _ in (*ROWS[:-1], *made.MADE))


def _found(
    asked: Asked, place: int | None, find: Callable[..., Finding], words: tuple[str | None, ...]
) -> tuple[AskedPhase, Finding]:
    """What is found in the phase that is named, else in the first in which the motion comes to the place that is asked for."""
    world, refused = scene(asked, place), list[NeverThere]()
    for number in range(world.number, world.number + 1 if world.is_named else len(asked.names)):
        try:
            world = world if number == world.number else scene(asked, number, is_named=False)
            return world, find(world, *words)
        except NeverThere as error:
            refused.append(error)
    raise refused[0]
