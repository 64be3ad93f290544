"""A question in the words that all else reads: what is only another way to write it in a problem, with its names."""

from __future__ import annotations

import re

from rbpsym.ask.asked import Asked
from rbpsym.errors import StatementError
from rbpsym.mechanics.arrivals import mover
from rbpsym.mechanics.friction import stops
from rbpsym.present.forms import present
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.paths import tensions
from rbpsym.typeset.machine import to_machine

_VALUE = r"\w+ ?= ?[^\s,=]+"
TURNED_ROUND = re.compile(
    r"\b(after|until|for) (?:it has made |the first )?(\d+(?:[./]\d+)?) (?:full )?(?:turn|revolution|rotation)s?(?=$|,? with )"
)
TO_THE_END = re.compile(r"(?:the )?total (?:way|angle|change) of (?:the )?(\w+)(?=$|,? with )")  # until friction has stopped it
WITHIN = re.compile(rf"(.+?),? (with {_VALUE}(?:(?:,| and) {_VALUE})*),? ((?:is|are) (?:the )?\w+|(?:for|in the limit) .+)")


VANISHES = r"(\b(?:where|when|until|once) (?:the )?(?:[\w ]+ )?of [\w. ]+?) (?:vanishes|is zero)(?=$|,? with )"
AT_PLACE = r" as (?:a )?functions? of (?:the )?(\w+),? (?:with|where|at) \1 ?= ?"  # a function, and where: its value there
BACK = re.compile(
    r"\b(until|when|where|once) (?:the )?\w+ (?:comes back|returns|is back)"
    r"(?: to (?:where it started|(?:the|its) (?:start|starting (?:point|place))))?(?=$|,? with )"
)


def _begun(asked: Asked) -> str:
    """“x = VALUE” of the start of the one coordinate that moves. Raises StatementError where none is known."""
    study = asked.study(asked.lasting)
    if (name := mover(study)) is None or (begun := study.system.scope.start.get(name)) is None:
        raise StatementError("what comes back is not known", instead="say which place: “time until x = 0”.")
    return f"{name} = {to_machine(present(begun))}"


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
    blows = "|".join(re.escape(element.name) for phase in asked.problem.phases for element in phase.impulses)
    plain = re.sub(rf"(^|\bfor which )({blows or '(?!)'})(?=$| )", r"\1impulse of \2", plain)
    named = "|".join(re.escape(name) for name in asked.names if name not in ("rest", "equilibrium"))
    plain = re.sub(rf"\b(?:in|while) (?:the )?({named})(?: phase)?(?=$| )", r"in phase \1", plain)
    for pattern, written in ((VANISHES, r"\1 = 0"), (AT_PLACE, r" where \1 = ")):
        plain = re.sub(pattern, written, plain)
    moved = "|".join(("t", *(coordinate.name for coordinate in asked.problem.coordinates)))
    plain = re.sub(rf"(?<=\w),? with (?=(?:{moved}) ?= ?)", " where ", plain)
    plain = BACK.sub(lambda said: f"{said[1]} {_begun(asked)}", plain)
    plain = _in_strings(asked, plain)
    plain = TURNED_ROUND.sub(lambda said: f"{'where' if said[1] == 'after' else 'until'} number of turns = {said[2]}", plain)
    if TO_THE_END.match(plain) and stops(asked.study(asked.lasting).system):
        plain = TO_THE_END.sub(r"displacement of \1 until \1 comes to rest", plain)
    constants = "|".join(quantity.name for quantity in asked.problem.parameters)
    plain = re.sub(rf"(?<=\w),? (?:where|when|if|for|at) (?=(?:{constants or '(?!)'}) ?= ?)", " with ", plain)
    return " ".join((said[1], said[3], said[2])) if (said := WITHIN.fullmatch(plain)) else plain
