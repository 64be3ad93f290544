"""What joins the bodies and acts on them, a sentence for each element of the statement."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.document.model import Inlines
from rbpsym.document.places import line_in_words, point_in_words
from rbpsym.document.words import Words, capital
from rbpsym.elements.interactions import LETTERS
from rbpsym.expr import tree as t
from rbpsym.mechanics.impulse import is_holding
from rbpsym.pictures.pose import DrawnPose
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Element, PointRef, Turn
from rbpsym.statement.paths import tensions
from rbpsym.statement.slots import ALL

Slots = dict[str, Any]


def element_sentence(element: Element, pose: DrawnPose, said: Words) -> Inlines:
    """The sentence of one constraint, interaction or impulse."""
    key = f"statement.{element.kind}{ALL[element.kind].told(element, pose.study.problem)}"
    slots = in_words(element, pose, said) | {"force": t.Vec(element.name), "letter": t.Sym(element.name)}
    if pose.study.problem.unstated:
        slots = {name: value for name, value in slots.items() if name not in FORCES}
    key = key if said.has(key) else "statement.other"
    return capital(said.say(key, ground=Said(pose.study), kind=element.kind.replace("-", " "), **slots))


FORCES = ("force", "letter", "letters", "friction", "couple")  # slots for what no one asks for where masses are not stated


def in_words(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """What the keys of an element say, as slots of a phrase: formulas by their key, points and bodies by their part in it."""
    found: Slots = {}
    for field in ALL[element.kind].fields:
        if (value := element.values.get(field.name)) is not None:
            found |= SLOTS.get(field.kind, _as_it_is)(field.name, value, pose, said)
    if element.kind in LETTERS:
        found["speed"] = t.Sym(LETTERS[element.kind])
    if "path" in found:
        found["letters"] = [t.Sym(name) for name in tensions(element)]
    if found.keys() & {"line", "circle", "curve"}:
        found["line"] = _curve(element, pose, said)
    for other in pose.study.problem.constraints:
        if other.values.get("beside") == element.name:
            found["friction"] = t.Vec(other["friction"])
    return found


def _as_it_is(name: str, value: Any, pose: DrawnPose, said: Words) -> Slots:
    return {name: value}


def _name(name: str, value: str, pose: DrawnPose, said: Words) -> Slots:
    return {name: t.Vec(value) if name == "friction" else t.Sym(value)}


def _point(name: str, value: PointRef, pose: DrawnPose, said: Words) -> Slots:
    return {name if name == "circle" else "point": point_in_words(value, pose, said)}


def _points(name: str, value: tuple[PointRef, PointRef], pose: DrawnPose, said: Words) -> Slots:
    """The place on the ground first."""
    first, second = value if value[1].body or name == "between" else value[::-1]
    bodies = zip(("one", "body", "other"), (first, second, second), strict=True)
    words = {"first": point_in_words(first, pose, said), "second": point_in_words(second, pose, said)}
    return words | {slot: BodyRef(ref.body) for slot, ref in bodies if ref.body}


def _body(name: str, value: str, pose: DrawnPose, said: Words) -> Slots:
    slots = ("other",) if name in ("of", "reaction_on") else ("body", "point")
    return dict.fromkeys(slots, BodyRef(value))


def _bodies(name: str, value: tuple[str, ...], pose: DrawnPose, said: Words) -> Slots:
    """Two bodies, or a body and the ground, that are turned against each other."""
    names = [name for name in value if name in pose.study.system.bodies]
    return {"bodies": [BodyRef(name) for name in names], "count": len(names)}


def _pair(name: str, value: tuple[t.Node, t.Node], pose: DrawnPose, said: Words) -> Slots:
    return {"x": value[0], "y": value[1]}


def _path(name: str, value: tuple[Turn, ...], pose: DrawnPose, said: Words) -> Slots:
    """What is wound on it comes last."""
    turns = value if value[-1].sense or not value[0].sense else value[::-1]
    told = [said.the(turn.body) if turn.sense and turn.body else point_in_words(turn.center, pose, said) for turn in turns]
    return {"path": told[1:-1] or told, "first": told[0], "last": told[-1], "whole": told}


SLOTS: Mapping[str, Callable[[str, Any, DrawnPose, Words], Slots]] = {
    "name": _name, "point": _point, "points": _points, "body": _body, "two bodies": _bodies, "pair": _pair, "path": _path,
}  # fmt: skip


def _curve(element: Element, pose: DrawnPose, said: Words) -> Inlines:
    """What is touched: a line or a circle, fixed or of a body."""
    if element.values.get("curve") is not None:
        curve = element["curve"]
        rows = [t.equation(t.Sym(axis), node) for axis, node in (("x", curve.x), ("y", curve.y)) if t.Sym(axis) != node]
        return said.say("line.curve", lines=rows)
    if element.values.get("circle") is None:
        body = element.values.get("of")
        return said.the(str(body)) if body else line_in_words(element["line"], pose, said)
    center, side = element["circle"], element.values.get("side")
    slots = {"radius": element["radius"], "center": point_in_words(center, pose, said)}
    if element["radius"] == t.ZERO:
        return said.say("line.corner", center=slots["center"])
    if center.body and element["radius"] in pose.study.problem.body(center.body).shape.sizes.values():  # its own rim
        return said.say("line.inside_body", body=BodyRef(center.body)) if side == "inside" else said.the(center.body)
    return said.say("line.inside" if side == "inside" else "line.circle", **slots)


def touched(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """What touches (`point`) and what is touched (`line`), or what a string joins (`path`)."""
    found = in_words(element, pose, said)
    return {"path": found["whole"]} if "whole" in found else {slot: found[slot] for slot in ("point", "line") if slot in found}


def element_sentences(pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """All of them: what holds the bodies, then what acts on them."""
    problem, told = pose.study.problem, set()
    for element in (*problem.constraints, *problem.interactions):
        yield from sentences_of(element, pose, said)
        along = element.values.get("of") if element.values.get("line") is not None else None
        if along and along not in told:  # a line has no ends, and no condition asks for those of the body
            told.add(along)
            yield said.say("statement.long_enough", body=BodyRef(along))


def sentences_of(element: Element, pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """The sentence of an element, and what more is stated of it: a limit of static friction, how it bounces, ..."""
    yield element_sentence(element, pose, said)
    own = pose.study.problem.body(element["body"]).shape.sizes.values() if element.values.get("rim") is not None else ()
    for key in ("limit", "length", "rest_angle", "rim"):
        if element.values.get(key) not in (None, t.ZERO, *own):
            yield said.say(f"statement.{key}", value=element[key])
    if "bodies" in element.values and {*element["bodies"]} != {*pose.study.problem.body_names}:
        yield said.say("statement.bodies", bodies=[BodyRef(name) for name in element["bodies"]], count=len(element["bodies"]))
    if element.kind == "bounce" and "path" not in element.values:
        yield from _friction_of(element, said)


def _friction_of(bounce: Element, said: Words) -> Iterator[Inlines]:
    """Whether what bounces slips as it parts, and how rough it is."""
    if is_holding(bounce):
        manner = {t.ZERO: "held", t.ONE: "whole"}.get(bounce["tangential"], "turned")
        yield said.say(f"statement.bounce_{manner}", tangential=bounce["tangential"])
    if bounce["coefficient"] is not None:
        yield said.say("statement.bounce_rough", coefficient=bounce["coefficient"])
    elif not is_holding(bounce):
        yield said.say("statement.bounce_smooth")
