"""Values with units in a question, “until speed of phi = 600 rpm”: each gets a letter, which the answer is told in."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from fractions import Fraction

from rbpsym.ask.asked import Asked
from rbpsym.decide.dimensions import dimension_of
from rbpsym.errors import RbpsymError, ReadError
from rbpsym.expr.infix import read_infix
from rbpsym.frozen import replace
from rbpsym.quantities import LENGTH, MASS, NUMBER, TIME, Dimension, Quantity
from rbpsym.statement.checks import dimensions_with_unknowns
from rbpsym.statement.model import Problem
from rbpsym.statement.units import UnitOf, read_unit

VALUE = re.compile(
    r"(?:\b(?P<of>\w+) )?(?P<is>=|[<>]=?|reaches|is|(?:stops|rest) (?:after|in|within)|(?:moves|travels) (?:at|with)|"
    r"(?:fallen|risen|moved|travelled|rolled|slid|gone|climbed|descended|distance|height)(?: through| up| down| of)?) "
    r"(?P<sign>[-+−]?)(?P<number>\d+(?:\.\d+)?) ?(?P<unit>[^\W\d][\w^*/ ]*?)"
    r"(?=$|,| (?:in|with|for|as|at|and|to|until|from|before|after)\b)"
)
GONE = re.compile(r"(?<!stops )(?<!rest )\bafter (?:a time of )?(?=\d+(?:\.\d+)? ?(?:m?s|min|h)\b)")
LETTER, FINEST = "q", 100_000
# a letter that a question brings with it: “after falling h”, “a distance d”, “when the speed is v”, “after n turns”
GREEK = "alpha|beta|gamma|delta|epsilon|eta|theta|kappa|lambda|mu|nu|xi|rho|sigma|tau|phi|chi|psi|omega"
NOUN = (
    "(?:angular )?(?:speed|velocity|acceleration)|distance|height|depth|length|way|time|period|angle|power|fallen|falling|falls?|"
    "risen|rising|rises?|moved|moving|moves?|travelled|rolled|rolling|slid|sliding|gone|climbed|climbing|descended|descending|turned|turning|"
    "rotated|turns?"
)
BROUGHT = re.compile(
    rf"\b(?P<noun>{NOUN})(?: (?:through|up|down|by|is|=|reaches|equals|has fallen to)| (?<=[dghys] )of(?= [a-z]))? "
    rf"(?P<letter>(?:a(?=$|,)|[B-Zb-z]|{GREEK})(?:_\w+)?)(?=$|,| (?!=|of\b)\D)"
    r"|\b(?:after|within|in|made) (?P<count>[a-zN](?:_\w+)?) (?:full |complete )?(?:turns|revolutions|rotations)\b"
)


def in_letters(asked: Asked, text: str) -> tuple[Asked, str, Mapping[str, str]]:
    """The question with a letter for each value that has a unit, asked of the problem that has these letters too, and the
    values by letter. An angle becomes a multiple of π. Raises ReadError for a value of no dimension that is no angle."""
    known, given = {**dimensions_with_unknowns(asked.problem), "t": TIME}, dict[str, str]()
    added: list[Quantity] = []

    def put(said: re.Match[str]) -> str:
        unit = _unit(said["unit"], known.get(said["of"] or "") or _of_noun(said.string[: said.start("is")]), known)
        is_counted = said["is"].startswith(("stops", "rest"))  # “stops after 20 turns” tells no angle
        if unit is None or unit.of_mechanics is None or (is_counted and unit.of_mechanics == NUMBER):
            return said[0]
        lead = f"{said['of']} {said['is']}" if said["of"] else said["is"]
        sign = "-" if said["sign"] in ("-", "−") else ""
        if unit.of_mechanics == NUMBER:
            return f"{lead} {sign}{said['number']}{_of_angle(unit)}"
        name = next(n for k in range(1, 100) if (n := f"{LETTER}_{k}") not in known and n not in given)
        given[name] = f"{said['number']} {said['unit']}"
        added.append(Quantity(name, unit.of_mechanics, f"{said['number']} {said['unit']}"))
        return f"{lead} {sign}{name}"

    plain = VALUE.sub(put, GONE.sub("where t = ", whole := " ".join(text.split()).rstrip(" ?.")))
    words = {*asked.problem.body_names, *(e.name for e in (*asked.problem.constraints, *asked.problem.interactions))}
    words |= {*asked.problem.points, *(point for body in asked.problem.bodies for point in body.points)}
    for said in BROUGHT.finditer(plain):
        name = said["letter"] or said["count"]
        if name not in {*known, *words, "t", "g"} and all(name != q.name for q in added):
            added.append(Quantity(name, NUMBER if said["count"] else _of_gone(said["noun"]), ""))
    if not added:
        return asked, text if plain == whole else plain, given
    problem = asked.problem
    return Asked(replace(with_letters(problem, *added), example={**problem.example, **given})), plain, given


def with_letters(problem: Problem, *added: Quantity) -> Problem:
    """The problem with these parameters too, in all of its phases."""
    phases = tuple(replace(phase, problem=with_letters(phase.problem, *added)) for phase in problem.phases)
    return replace(problem, parameters=(*problem.parameters, *added), phases=phases)


def _of_noun(text: str) -> Dimension | None:
    """The dimension of what is named last in a text."""
    found = [word for word in re.findall(r"[a-z]+", text) if word in NOUNS]
    is_angular = bool(found) and re.search(rf"angular {found[-1]}\b", text) is not None
    return None if not found or is_angular else NOUNS[found[-1]]


def _of_gone(noun: str) -> Dimension:
    """The dimension of what stands behind a noun or a participle: what has turned turns by an angle, what goes goes a length."""
    if noun.startswith("angular "):
        return NOUNS[noun.removeprefix("angular ")] / LENGTH
    return NOUNS.get(noun, NUMBER if re.match("angle|turn|rotat", noun) else TIME if noun == "period" else LENGTH)


SPEED, FORCE = LENGTH / TIME, MASS * LENGTH / TIME**2
NOUNS = dict.fromkeys(("speed", "velocity"), SPEED) | {"acceleration": SPEED / TIME, "time": TIME, "power": FORCE * SPEED}
NOUNS |= dict.fromkeys(("height", "distance", "displacement", "elongation", "compression", "amplitude"), LENGTH)
NOUNS |= dict.fromkeys(("tension", "force", "friction"), FORCE) | dict.fromkeys(("energy", "work"), FORCE * LENGTH)


def _unit(text: str, of: Dimension | None, known: Mapping[str, Dimension]) -> UnitOf | None:
    """The unit that is meant; None for names of the problem (3 m where m is a mass), unless these do not fit."""
    try:
        unit = read_unit(text)
    except ReadError:
        return None
    try:
        named = dimension_of(read_infix(text.replace("^", "**"), known), known)
    except RbpsymError:
        return unit
    return unit if of not in (None, named) else None


def _of_angle(unit: UnitOf) -> str:
    """What a number of degrees, turns or radians is multiplied by. Raises ReadError for another unit."""
    size = unit.factor * (2 * math.pi if unit.counts_cycles else 1)
    if size == 1:
        return ""
    part = Fraction(size / math.pi).limit_denominator(FINEST)
    if part and math.isclose(part * math.pi, size):
        return f"*{part}*pi"
    raise ReadError("an angle is told in deg, rad or turns here")
