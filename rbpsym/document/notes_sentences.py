"""What joins the bodies and acts on them, a sentence for each element of the statement."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from rbpsym.document.model import Inlines
from rbpsym.document.places import line_in_words, point_in_words
from rbpsym.document.words import Words, capital
from rbpsym.expr import tree as t
from rbpsym.field import depends_on
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.impulse import is_holding
from rbpsym.mechanics.resistance import LETTERS
from rbpsym.pictures.pose import DrawnPose
from rbpsym.present.forms import present
from rbpsym.proof.assertions import Said
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Element, PointRef
from rbpsym.statement.paths import tensions
from rbpsym.statement.scope import CLOCK

Slots = dict[str, object]
DOWN = (t.ZERO, t.Neg(t.ONE))
DRIVEN = {(t.ONE, t.ZERO): "driven_right", (t.ZERO, t.ONE): "driven_up"}


def element_sentence(element: Element, pose: DrawnPose, said: Words) -> Inlines:
    """The sentence of one constraint or interaction."""
    write = SENTENCES.get(element.kind, _other)
    slots = write(element, pose, said)
    key = slots.pop("key", f"statement.{element.kind}")
    if not said.has(key):
        key, slots = "statement.other", _other(element, pose, said)
    ground = Said(pose.study)
    return capital(said.say(key, ground=ground, force=t.Vec(element.name), letter=t.Sym(element.name), **slots))


def _pivot(element: Element, pose: DrawnPose, said: Words) -> Slots:
    ends = {"ground", element["point"].body}
    rough = any(ends == {*each["between"]} for each in pose.study.problem.of_kind("resisting-couple"))
    slots: Slots = {"point": point_in_words(element["point"], pose, said)}
    where = pose.where(element["point"])
    is_moved = any(depends_on(part, CLOCK) for part in (where.x, where.y))
    slots["key"] = f"statement.pivot{'_rough' if rough else ''}{'_moved' if is_moved else ''}"
    if is_moved:
        slots |= {"x": present(where.x, pose.study.style), "y": present(where.y, pose.study.style)}
    return slots


def _pair(element: Element, pose: DrawnPose, said: Words) -> Slots:
    first, second = element["points"]
    if second.body is None:
        first, second = second, first
    slots: Slots = {"first": point_in_words(first, pose, said), "second": point_in_words(second, pose, said)}
    if element.kind == "weld":
        slots["couple"] = t.Sym(element["couple"])
    if first.body is None:
        return slots | {"key": f"statement.{element.kind}_ground", "body": BodyRef(second.body)}
    return slots | {"one": BodyRef(first.body), "other": BodyRef(second.body)}


def _touching(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """A point or a round body on a line; other curves are named by what they are."""
    what = element.values.get("point") or element.values.get("body")
    if what is None:
        return _other(element, pose, said) | {"key": "statement.other"}
    toucher = point_in_words(what, pose, said) if isinstance(what, PointRef) else said.the(str(what))
    slots: Slots = {"point": toucher, "line": _curve(element, pose, said)}
    if element.values.get("friction"):
        slots["friction"] = t.Vec(str(element["friction"]))
    for other in pose.study.problem.constraints:
        if other.values.get("beside") == element.name:
            slots |= {"friction": t.Vec(str(other["friction"])), "key": "statement.contact_beside"}
    if element.values.get("coefficient") is not None:
        slots |= {"coefficient": element["coefficient"], "key": f"statement.{element.kind}_rough"}
    if isinstance(what, PointRef) and what.body is None and element.values.get("of"):
        slots["key"] = f"{slots.get('key', f'statement.{element.kind}')}_on_point"
    if element.values.get("couple"):
        slots["couple"] = t.Sym(str(element["couple"]))
    return slots


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
    if center.body and _is_round_itself(element, pose):
        return said.say("line.inside_body", body=BodyRef(center.body)) if side == "inside" else said.the(center.body)
    return said.say("line.inside" if side == "inside" else "line.circle", **slots)


def _is_round_itself(element: Element, pose: DrawnPose) -> bool:
    """Is the circle the rim of the body, and not one drawn on it?"""
    return element["radius"] in pose.study.problem.body(element["circle"].body).shape.sizes.values()


def _spring(element: Element, pose: DrawnPose, said: Words) -> Slots:
    natural = element["natural_length"]
    more: Slots = {"natural": natural} if natural not in (None, t.ZERO) else {"key": "statement.spring_short"}
    return {"stiffness": element["stiffness"], **_ends(element, pose, said), **more}


def _ends(element: Element, pose: DrawnPose, said: Words) -> Slots:
    first, second = element["between"]
    return {"first": point_in_words(first, pose, said), "second": point_in_words(second, pose, said)}


def _twisting(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """Two bodies, or a body and the ground, that are turned against each other."""
    names = [name for name in element["between"] if name in pose.study.system.bodies]
    size = element["stiffness"] if "stiffness" in element.values else element["coefficient"]
    return {"size": size, "bodies": [BodyRef(name) for name in names], "count": len(names)}


def _applied(element: Element, pose: DrawnPose, said: Words) -> Slots:
    x, y = element["force"]
    turns = {"key": "statement.force_turning"} if element["frame"] == "body" else {}
    return {"point": point_in_words(element["on"], pose, said), "x": x, "y": y, **turns}


def _falling(element: Element, pose: DrawnPose, said: Words) -> Slots:
    x, y = element["direction"]
    return {"g": element["g"], "x": x, "y": y, **({} if (x, y) == DOWN else {"key": "statement.gravity_along"})}


def _resisting(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """A force or couple against a motion, its size with or without the speed in it."""
    speed = t.Sym(LETTERS[element.kind])
    slots: Slots = {"size": element["size"], "speed": speed}
    moves = "on" in element.values and any(map(scalar, element["medium"]))
    if "on" in element.values:
        slots["point"] = point_in_words(element["on"], pose, said)
    else:
        names = [name for name in element["between"] if name in pose.study.system.bodies]
        slots |= {"bodies": [BodyRef(name) for name in names], "count": len(names)}
    if moves:
        return slots | {"x": element["medium"][0], "y": element["medium"][1], "key": "statement.resistance_in"}
    return slots if speed.name in t.names(element["size"]) else slots | {"key": f"statement.{element.kind}_dry"}


def _couple(element: Element, pose: DrawnPose, said: Words) -> Slots:
    return {"couple": element["couple"], "body": BodyRef(element["on"])}


def _driven(element: Element, pose: DrawnPose, said: Words) -> Slots:
    x, y = element["along"]
    slots: Slots = {"point": point_in_words(element["point"], pose, said), "distance": element["distance"], "x": x, "y": y}
    if element["of"]:
        return {**slots, "other": BodyRef(element["of"]), "key": "statement.driven_along"}
    return {**slots, "key": f"statement.{DRIVEN.get((x, y), 'prescribed')}"}


def _turned(element: Element, pose: DrawnPose, said: Words) -> Slots:
    slots = {"body": BodyRef(element["body"]), "angle": element["angle"]}
    return {**slots, "other": BodyRef(element["of"]), "key": "statement.turned_against"} if element["of"] else slots


def touched(element: Element, pose: DrawnPose, said: Words) -> Slots:
    """What touches (`point`) and what is touched (`line`), or what a string joins (`path`)."""
    if "path" not in element.values:
        found = _touching(element, pose, said)
        return {slot: found[slot] for slot in ("point", "line") if slot in found}
    found = _string(element, pose, said)
    return {"path": [found["first"], *found["path"], found["last"]] if "first" in found else found["path"]}


def _bouncing(element: Element, pose: DrawnPose, said: Words) -> Slots:
    kind = "bounce_taut" if "path" in element.values else "bounce"
    return {**touched(element, pose, said), "restitution": element["restitution"], "key": f"statement.{kind}"}


def _colliding(element: Element, pose: DrawnPose, said: Words) -> Slots:
    x, y = element["along"]
    first, second = (point_in_words(point, pose, said) for point in element["points"])
    return {"first": first, "second": second, "x": x, "y": y, "restitution": element["restitution"]}


def _struck(element: Element, pose: DrawnPose, said: Words) -> Slots:
    x, y = element["impulse"]
    return {"point": point_in_words(element["on"], pose, said), "x": x, "y": y}


def _string(element: Element, pose: DrawnPose, said: Words) -> Slots:
    turns = element["path"]
    turns = turns if turns[-1].sense or not turns[0].sense else turns[::-1]
    told = [
        said.the(turn.body) if turn.sense and turn.body else point_in_words(turn.center, pose, said) for turn in turns
    ]
    if element.values.get("rigid"):
        return {"path": told, "key": "statement.link"}
    if len(turns) == 2 and not turns[-1].sense:
        return {"path": told, "key": "statement.string_straight"}
    over = "over_" if len(turns) > 2 else ""
    key = f"statement.string_{over}wound" if turns[-1].sense else "statement.string"
    pulls = tensions(element)
    turned = {"key": "statement.string_turning", "letters": [t.Sym(name) for name in pulls]} if len(pulls) > 1 else {}
    return {"first": told[0], "path": told[1:-1], "last": told[-1], "key": key, **turned}


def _other(element: Element, pose: DrawnPose, said: Words) -> Slots:
    return {"kind": element.kind.replace("-", " ")}


Writer = Callable[[Element, DrawnPose, Words], Slots]

SENTENCES: Mapping[str, Writer] = {
    "blow": _struck,
    "bounce": _bouncing,
    "collision": _colliding,
    "pivot": _pivot,
    "pin": _pair,
    "weld": _pair,
    "contact": _touching,
    "guide": _touching,
    "slider": _touching,
    "touch": _touching,
    "rolling": _touching,
    "gear": _touching,
    "sticking": _touching,
    "string": _string,
    "link": _string,
    "prescribed": _driven,
    "prescribed-angle": _turned,
    "gravity": _falling,
    "spring": _spring,
    "pull": lambda e, p, w: {"size": e["size"], **_ends(e, p, w)},
    "damper": lambda e, p, w: {"coefficient": e["coefficient"], **_ends(e, p, w)},
    "torsion-spring": _twisting,
    "rotary-damper": _twisting,
    "force": _applied,
    "couple": _couple,
    "resistance": _resisting,
    "resisting-couple": _resisting,
}


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
    if element.kind == "gravity" and {*element["bodies"]} != {*pose.study.problem.body_names}:
        yield said.say("statement.bodies", bodies=[BodyRef(name) for name in element["bodies"]], count=len(element["bodies"]))
    if element.kind == "bounce" and "path" not in element.values:
        yield from _friction_of(element, said)


def _friction_of(bounce: Element, said: Words) -> Iterator[Inlines]:
    """Whether what bounces slips as it parts, and how rough it is."""
    if is_holding(bounce):
        turned = bounce["tangential"] != t.ZERO
        yield said.say("statement.bounce_turned" if turned else "statement.bounce_held", tangential=bounce["tangential"])
    if bounce["coefficient"] is not None:
        yield said.say("statement.bounce_rough", coefficient=bounce["coefficient"])
    elif not is_holding(bounce):
        yield said.say("statement.bounce_smooth")
