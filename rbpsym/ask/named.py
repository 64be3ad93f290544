"""What a textbook calls the bodies, strings and hinges of a problem, by the names that the statement gives them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.errors import Ambiguous
from rbpsym.expr import tree as t
from rbpsym.field import is_zero
from rbpsym.field.evaluate import scalar
from rbpsym.quantities import FORCE, LENGTH, NUMBER
from rbpsym.quantity.bound import without_articles
from rbpsym.statement.model import Body, Element, Line, Phase, Problem

STRINGS = "string|rope|cord|cable|thread|chain|wire|coupling"
# a word for an element -> the kinds that it may mean: the only one of these, or of those that touch what is named beside it
ELEMENTS: Mapping[str, tuple[str, ...]] = {
    f"{STRINGS}|link|strut": ("string",),
    "spring": ("spring", "torsion-spring"),
    "damper|dashpot": ("damper", "rotary-damper"),
    "pivot|fulcrum|nail": ("pivot",),
    "pivot|hinge|axle|axis|bearing|pin": ("pivot", "pin"),
    "motor": ("couple",),
    "teeth": ("gear",),
}
# what a contact with a fixed line is called by the slope of that line
SURFACES: Mapping[str, Callable[[Line], bool]] = {
    "wall": lambda line: is_zero(scalar(line.b)),
    "floor|ground|road": lambda line: is_zero(scalar(line.a)),
    "incline|slope|ramp|plane": lambda line: not is_zero(scalar(line.a)) and not is_zero(scalar(line.b)),
}
# what a parameter is called that stands under one of these keys
PARAMETERS = {
    "coefficient of friction": ("coefficient", "limit"),
    "coefficient of static friction": ("limit",),
    "coefficient of (?:kinetic|sliding) friction": ("coefficient",),
    "coefficient of restitution": ("restitution",),
    "spring constant": ("stiffness",),
}
# words for bodies, by the shapes that they may have; the only body of these shapes may be called so
KINDS: Mapping[str, tuple[str, ...]] = {
    "arm|bar|beam|boom|door|gate|ladder|lever|plank|pole|rod|shaft|stick|trapdoor": ("rod", "rectangle"),
    "cylinder|disc|disk|drum|flywheel|hoop|pipe|reel|ring|roller|spool|wheel": ("disk", "ring", "annulus"),
    "ball|bead|bob|marble|puck|sphere": ("ball", "shell", "particle"),
    "block|board|box|car|carriage|cart|collar|crate|cube|load|particle|plate|slab|slider|sled|sledge|trolley|truck|wagon":
        ("particle", "rectangle"),
}
SHAPES = "|".join((*KINDS, "beam|bike|body|crank|gear|link|mass|pulley|wedge"))
MOVES = "speed|velocity|acceleration|displacement|position|height|kinetic energy|momentum|cent(?:re|er)"
FORCES = "force|tension|friction|work"
ROLES = "normal force|reaction|force|friction force|friction"
GROUNDS = (
    "ground|floor|table|road|track|surface|plane|incline|slope|hill|dome|bowl|loop|ramp|rail|circle|wall|sphere|cylinder|wedge|edge|"
    "corner|step|peg"
)
_NEXT = " (?:with|in|for|if|and|at|where|when)\\b"
SIDE = "".join(f"(?<!{side} )" for side in ("other", "free", "upper", "lower", "left", "right", "top", "bottom"))
LEAVES = "leaves|loses contact(?: with)?|lifts off|comes off|flies off"
GONE = r"is (?:cut|removed|switched off|turned off|released|let go)|breaks|snaps|lets go"


def _any(names: list[str]) -> str:
    return "|".join(map(re.escape, sorted(names, key=len, reverse=True))) or "(?!)"


def _elements(problem: Problem, text: str) -> str:
    """“the cable”, “spring S”, “the upper spring”, “the pin at A” by the name of the only one that is meant; “the tension in the
    cable” is that of the only string, whichever part."""
    known = _names(problem) | {body.name for body in problem.bodies}
    text = re.sub(rf"\btension (?:in|of) the (?:{'|'.join({*STRINGS.split('|')} - known)})\b(?! (?:at|on|of) )", "tension", text)
    for words, kinds in ELEMENTS.items():
        found = [e for e in (*problem.constraints, *problem.interactions) if e.kind in kinds]
        words = "|".join(word for word in words.split("|") if word not in known) or "(?!)"
        text = re.sub(rf"\b(?:the )?(?:{words}) (?=(?:{_any([e.name for e in found])})(?![\w.-]))", "", text)
        touched = [word for e in found for word in joined(e)]
        many = _any([word for word in {*touched} if 1 < touched.count(word) < len(found) + (word in problem.body_names)])
        if open_ := re.search(rf"\bthe (?:{many}) (?:{words})\b", text):
            meant = " or ".join(f"“{e.name}”" for e in found if {*open_[0].split()} & joined(e))
            raise Ambiguous(f"“{open_[0]}” may be {meant}", instead="write its name.")
        for element in found:
            own = _any([word for word in joined(element) if touched.count(word) == 1 and len(found) > 1])
            said = rf"(?:{own}) (?:{words})|(?:{words})(?: (?:at|on|to|of))?(?: the)? (?:{own})"
            text = re.sub(rf"\b(?:the )?(?:{said})\b(?! (?:force|constant)|[.=])", element.name, text)
        if len(found) == 1:
            lone = rf"\b(?:the |(?<= of )|(?<= in )|(?<= on )|(?<= at )|(?<= between ))(?:{words})\b(?! (?:force|constant))"
            text = re.sub(lone, found[0].name, text)
    return _by_size(problem, text)


def _parts(element: Element) -> Iterator[Any]:
    for value in element.values.values():
        yield from value if isinstance(value, tuple) else (value,)


def joined(element: Element) -> set[str]:
    """The bodies and the named points that an element joins."""
    points = [part if isinstance(part, str) else getattr(part, "center", part) for part in _parts(element)]
    found = [getattr(point, "body", None) or getattr(point, "label", point) for point in points]
    return {name for name in found if isinstance(name, str)}


def _by_size(problem: Problem, text: str) -> str:
    """“work done by F” by the name of the only force of which that parameter is the size."""
    known = _names(problem) | {body.name for body in problem.bodies}
    sizes = [(part.name, e.name) for e in problem.interactions for part in _parts(e) if isinstance(part, t.Sym)]
    for size, name in sizes:
        is_one = [one for one, _ in sizes].count(size) == 1 and problem.dimensions.get(size) in (FORCE, FORCE * LENGTH)
        if is_one and size not in known:
            text = re.sub(rf"\b(work (?:done )?(?:of|by)|power of|impulse of) {re.escape(size)}(?![\w.])", rf"\1 {name}", text)
    return text


def _surfaces(problem: Problem, text: str) -> str:
    """“normal force of the wall” by the only contact with a line of that slope."""
    for words, fits in SURFACES.items():
        fixed = [e for e in problem.constraints if isinstance(e.values.get("line"), Line) and not e.values.get("of")]
        lines = [e.name for e in fixed if fits(e["line"])]
        if len(lines) == 1:
            text = re.sub(rf"\b({ROLES}) (?:at|of|on|with|from|exerted by) (?:the )?(?:{words})\b", rf"\1 {lines[0]}", text)
    return text


def _parameters(problem: Problem, text: str) -> str:
    """“coefficient of friction” by the only parameter that is one; “friction torque for which …” by that which is called so."""
    stated = (*problem.constraints, *problem.interactions, *(e for phase in problem.phases for e in phase.impulses))
    for words, keys in PARAMETERS.items():
        values = {e.values[key] for e in stated for key in keys if isinstance(e.values.get(key), t.Sym)}
        if words.startswith("coefficient"):  # a damper has one, too, that is no number
            values = {value for value in values if problem.dimensions.get(value.name) == NUMBER}
        held = [e for e in problem.constraints if e.kind in ("rolling", "sticking") and "limit" in keys and not values]
        own = values.pop().name if len(values) == 1 else "mu" if held else None
        if own:  # what is asked for may be none of the statement
            told = "(?! (?:needed|required))" if own in problem.dimensions else r"(?= (?:for|at) which\b)"
            text = re.sub(rf"\b{words}\b{told}", own, text)
    return text


def _meant(problem: Problem, text: str) -> str:
    """“largest recoil” by the coordinate that means the recoil, “the left block” by the body of which a mass is said to be."""
    for q in problem.parameters:
        of = re.sub("^mass of ", "", without_articles(q.meaning))
        own = [body.name for body in problem.bodies if body.mass == t.Sym(q.name)]
        if len(own) == 1 and " " in of and not of.startswith("of "):
            text = re.sub(rf"\b{re.escape(of)}\b", own[0], text)
    alone = r"(?![.\w-]| (?:of|by|from|to|with|against|relative|above|below)\b)"
    for coordinate in problem.coordinates:
        told = without_articles(coordinate.quantity.meaning)
        if told and told not in PLAIN:
            text = re.sub(rf"\b{re.escape(told)}\b{alone}", coordinate.name, text)
    return text


PLAIN = {"speed", "displacement", "distance", "position", "height", "angle", "place", "way", "time", "mass", "angle turned"}


def may_be(body: Body, word: str) -> bool:
    """Whether a body can be called by a word for a shape: of a shape that is not told, where its name tells nothing of it."""
    kinds = [shapes for words, shapes in KINDS.items() if word in words.split("|")]
    tells_nothing = len(body.name) <= 2 or body.name in SIDES
    return not kinds or any(body.shape.kind in shapes for shapes in kinds) or (body.shape.kind == "given" and tells_nothing)


SIDES = ("front", "rear", "left", "right", "upper", "lower", "top", "bottom", "back", "first", "second", "inner", "outer")


def _bodies(problem: Problem, text: str) -> str:
    """“the rear wheel”, “wheel A” by the name of the body alone, “speed of m_1” by that of the only body with this mass."""
    names = [body.name for body in problem.bodies]
    for body in problem.bodies:  # of “the car wheel” the car is not what is meant
        shapes = _any([word for word in SHAPES.split("|") if word not in names and may_be(body, word)])
        text = re.sub(rf"\b({re.escape(body.name)}) (?:{shapes})\b(?!\.)", r"\1", text)
        text = re.sub(rf"\b(?:{shapes}) (?={re.escape(body.name)}(?![\w-]))", "", text)
    for words, kinds in KINDS.items():
        lone = [body.name for body in problem.bodies if body.shape.kind in kinds]
        if len(lone) == 1:
            words = "|".join(word for word in words.split("|") if word not in names)
            before = "of|on|when|where|until|which|after|before|does|that"
            text = re.sub(rf"\b({before}) (?:{words})(?=$|[ ,])(?! of\b)", rf"\1 {lone[0]}", text)
    masses = [body.mass.name for body in problem.bodies if isinstance(body.mass, t.Sym)]
    for body in problem.bodies:
        if isinstance(body.mass, t.Sym) and masses.count(own := body.mass.name) == 1 and own not in names:
            role = rf"(?:{MOVES}) of|(?:{FORCES})(?: [\w-]+)?(?: of [\w-]+)? on"
            after = r"(?:after|before|when|where|until)(?= [\w-]+ (?:has|hits|strikes|meets|reaches|comes|stops|lands|leaves))"
            text = re.sub(rf"\b({role}|{after}) (?:mass )?{re.escape(own)}(?![\w.])", rf"\1 {body.name}", text)
    return text


def _points(problem: Problem, text: str) -> str:
    """“normal force at the front wheels” by the name of what holds the point “front”, “the free end” of the only rod that is
    held at its other one."""
    touched = [(e.name, point.point) for e in problem.constraints for point in _parts(e) if getattr(point, "point", None)]
    known = _names(problem) | {*problem.body_names}
    for name, point in touched:
        if [one for _, one in touched].count(point) == 1 and point not in known:
            there = rf"(?:at|on|of) {re.escape(point)}(?: (?:{SHAPES}|edge|end|corner|foot)s?)?(?![\w.])"
            text = re.sub(rf"\b({ROLES}) {there}", rf"\1 {name}", text)
    for body in problem.bodies:
        points = _any([point for point in body.points if point not in known])
        text = re.sub(rf"{SIDE}\b(?:point )?({points}) of {re.escape(body.name)}(?![\w.-])", rf"{body.name}.\1", text)
        middle = f"{body.name}.{'center' if 'center' in body.points else 'cm'}"
        lone = "?" if len(problem.bodies) == 1 and not {"center", "centre"} & known else ""
        of = rf"(?: of {re.escape(body.name)}(?![\w.-])){lone}"
        text = re.sub(rf"(?<=\bof )(?:cent(?:re|er)|middle|midpoint){of}(?! of\b|\.)", middle, text)
    ends = {body.name: {"start", "end"} for body in problem.bodies if body.shape.kind == "rod"}
    holds = (*problem.constraints, *(e for phase in problem.phases for e in phase.impulses))
    for point in (point for e in holds for point in _parts(e)):
        if getattr(point, "point", None) and point.body in ends:
            ends[point.body] -= {point.point}
    free = {name: left.pop() for name, left in ends.items() if len(left) == 1}
    for name, end in free.items():
        text = re.sub(rf"\b(?:free end|other end|tip) of {re.escape(name)}(?![\w-])", f"{name}.{end}", text)
        if len(free) == 1:
            text = re.sub(r"\bof (?:free end|tip)(?! of)\b", f"of {name}.{end}", text)
    return text


def _between(problem: Problem, text: str) -> str:
    """“force between A and B” and “force of A on B” by the only constraint that joins the two bodies."""
    for e in problem.constraints:
        both = joined(e) & {*problem.body_names}
        if len(both) == 2 and sum(both <= joined(other) for other in problem.constraints) == 1:
            one = _any([*both])
            text = re.sub(rf"\b(?:contact )?({ROLES}|tension) between (?:{one}) and (?:{one})(?![\w.-])", rf"\1 {e.name}", text)
            text = re.sub(rf"\bforce (?:of|by|from|exerted by) (?:{one}) on ({one})(?![\w.-])", rf"force {e.name} on \1", text)
    return text


def _leaving(problem: Problem, text: str) -> str:
    """“where the block leaves the table” by the only contact that holds the block to one side."""
    sides = ("contact", "touch", "rolling", "sticking")
    for body in problem.bodies:
        own = [e for e in problem.constraints if e.kind in sides and _is_of(e, body.name)]
        if len(own) == 1:
            of = own[0].values.get("of") or getattr(own[0].values.get("circle"), "body", None)
            who = "|".join((re.escape(body.name), *(["it"] if len(problem.bodies) == 1 else [])))
            leaves = rf"\b(?:{who}) (?:{LEAVES})(?: (?:{GROUNDS}|{_any([of] if of else [])}))?(?=$|,|{_NEXT})"
            ends = [phase for phase, gone in _gone(problem) if own[0].name in gone]
            if len(ends) == 1 and ends[0].subject != own[0].name:  # it is left where that phase begins without it
                text = re.sub(rf"(?<=where |.when |until ){leaves}", f"{ends[0].name} begins", text)
            text = re.sub(leaves, f"{own[0].name} vanishes", text)
    lone = [e.name for e in problem.constraints if e.kind in sides]
    text = re.sub(r"\bcontact (?:is lost|ceases)", f"{lone[0]} vanishes", text) if len(lone) == 1 else text
    for name in lone:
        text = re.sub(rf"\b{re.escape(name)} (?:{LEAVES}) (?:{GROUNDS})\b", f"{name} vanishes", text)
    return text


def _impulses(problem: Problem, text: str) -> str:
    """“impulse on the block” by the only blow that strikes it."""
    blows = [e for phase in problem.phases for e in phase.impulses]
    for body in problem.bodies:
        own = [e.name for e in blows if body.name in joined(e)]
        if len(own) == 1:
            struck = rf"\bimpulse (?:(?:of|by|from) [\w-]+ )?(?:on|given to|received by) {re.escape(body.name)}(?![\w.-])"
            text = re.sub(struck, f"impulse of {own[0]}", text)
    return text


def _components(problem: Problem, text: str) -> str:
    """“horizontal impulse at the hinge” by the name of that component, “impulse at the hinge” by that of the whole."""
    for name in (e.name for e in problem.constraints if e.kind in ("pivot", "pin", "weld") and e.name not in problem.body_names):
        for side, axis in (("horizontal", "x"), ("vertical", "y")):
            what = rf"\b{side}(?: component of)? "
            where = rf"(?: (?:at|of|on))? {re.escape(name)}(?![\w.])(?! on )"
            text = re.sub(f"{what}(?:reaction|force){where}", f"{name}_{axis}", text)
            other = "yx"["yx".index(axis) - 1]
            text = re.sub(rf"\b(?:reaction|force){where} is {side}\b", f"{name}_{other} vanishes", text)
            text = re.sub(f"{what}impulse{where}", f"impulse of {name}_{axis}", text)
        text = re.sub(rf"\bimpulse (?:at|on) {re.escape(name)}(?![\w.])", f"impulse of {name}", text)
    return text


def _is_of(element: Element, body: str) -> bool:
    return any(getattr(value, "body", value) == body for key, value in element.values.items() if key in ("point", "body"))


def begun_without(problem: Problem, text: str) -> str:
    """“right after the cord is cut” by the only phase that begins without it."""
    ends = _gone(problem)
    for phase, names in ends:
        lone = [name for name in names if sum(name in gone for _, gone in ends) == 1]
        who = _any(lone) + ("|it" if len(lone) == 1 == sum(len(gone) for _, gone in ends) else "")
        ahead = rf"\b(?:(?:just|right|immediately) )?before (?:{who}) (?:{GONE})\b"
        text = re.sub(ahead, f"just before {phase.name}", text)
        text = re.sub(rf"\b(?:{who}) (?:{GONE})\b", f"{phase.name} begins", text)
    return text


def _gone(problem: Problem) -> list[tuple[Phase, set[str]]]:
    """The phases, each with the names of what acts no more in it."""
    before = [problem, *(phase.problem for phase in problem.phases)]
    return [(phase, _names(old) - _names(phase.problem)) for old, phase in zip(before, problem.phases, strict=False)]


def _names(problem: Problem) -> set[str]:
    return {element.name for element in (*problem.constraints, *problem.interactions)}


def in_names(problem: Problem, text: str) -> str:
    """The question in the names of the problem, without articles."""
    text = _parameters(problem, _surfaces(problem, _elements(problem, text)))
    text = _bodies(problem, _meant(problem, without_articles(text)))
    held = _any([*_names(problem) - {*problem.body_names}])
    text = re.sub(rf"\b({ROLES})s? (?:at|of|on|in|between|exerted by) (?=(?:{held})(?![\w.-]))", r"\1 ", text)
    for find in (_components, _points, _between, _leaving, _impulses, begun_without):
        text = find(problem, text)
    return text
