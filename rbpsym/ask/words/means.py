"""What the rows of the grammar mean that hang on the problem: functions of what was read, None where they mean nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.ask.named import joined
from rbpsym.ask.words.chart import Caps
from rbpsym.ask.words.lexicon import RESTING, ROLES, TOUCHING, Lexicon
from rbpsym.expr import tree as t
from rbpsym.quantities import LENGTH, NUMBER
from rbpsym.statement.model import Element

Of = Callable[[Lexicon, Caps], str | None]


def _element(lexicon: Lexicon, name: str) -> Element | None:
    return next((e for e in lexicon.elements if e.name == name), None)


OF_TEETH = ("tangential force", "tooth force")


def _role(role: str, e: Element | None, holder: str = "") -> str | None:
    """What holds or pushes by its name, if the noun may mean it, on a body if that is said: “reaction” is none of a rough
    contact, which has two parts."""
    kind = next((kind for kind, (words, _) in ROLES.items() if role in words.split("|")), "")
    if e is None or e.kind not in ROLES[kind][1] or (role in OF_TEETH and e.kind != "gear"):
        return None
    is_rough = bool(e.values.get("friction"))
    if (kind == "force" and e.kind in TOUCHING and is_rough) or (kind == "friction" and not is_rough):
        return None
    if kind == "force" and (holder or e.kind in RESTING):
        return f"force {e.name} on {holder}" if holder else f"reaction {e.name}"
    return f"{kind} {e.name}"


def _held(lexicon: Lexicon, caps: Caps) -> str | None:
    return _role(caps["Role"], _element(lexicon, caps["Where"]), caps["Holder"])


def _lone_role(lexicon: Lexicon, role: str, bodies: set[str], holder: str = "") -> str | None:
    """The only force of that role on a body, or between two."""
    found = [one for e in lexicon.elements if bodies <= joined(e) and (one := _role(role, e, holder))]
    return found[0] if len(found) == 1 else None


def _held_on(lexicon: Lexicon, caps: Caps) -> str | None:
    return _held(lexicon, caps) if caps["Where"] else _lone_role(lexicon, caps["Role"], {caps["Holder"]}, caps["Holder"])


def _between(lexicon: Lexicon, caps: Caps) -> str | None:
    return _lone_role(lexicon, caps["Role"], {caps["a"], caps["b"]}) if caps["a"] != caps["b"] else None


def _by_on(lexicon: Lexicon, caps: Caps) -> str | None:
    return _lone_role(lexicon, caps["Role"], {caps["a"], caps["b"]}, caps["b"]) if caps["a"] != caps["b"] else None


def _component(lexicon: Lexicon, caps: Caps) -> str | None:
    axis, whole = {"horizontal": "x", "vertical": "y"}[caps["x"]], caps["Held"]
    e = None if " on " in whole else _element(lexicon, whole.split()[-1])  # of a pin the sign hangs on the body
    return f"{e.name}_{axis}" if e and e.kind in RESTING else f"{axis} component of {whole}"


def coordinate(lexicon: Lexicon, caps: Caps) -> str | None:
    """The only angle, or length, that tells a place; of several the only one that tells where a body is, not only how it lies."""
    wanted = NUMBER if caps["x"] == "angle" else LENGTH
    found = [c.name for c in lexicon.problem.coordinates if c.quantity.dimension == wanted]
    if len(found) > 1:
        places = {name for body in lexicon.problem.bodies for way in (body.placed or ("", ()))[1] for name in t.names(way)}
        found = [name for name in found if name in places]
    return found[0] if len(found) == 1 and caps["x"] != "place" else None


def lone(lexicon: Lexicon) -> str:
    """The only coordinate; nothing where there are several."""
    names = [c.name for c in lexicon.problem.coordinates]
    return names[0] if len(names) == 1 else ""


def _point(lexicon: Lexicon, name: str) -> str:
    return f"{name}.cm" if name in lexicon.problem.body_names else name


def _relative(lexicon: Lexicon, caps: Caps) -> str | None:
    names = [c.name for c in lexicon.problem.coordinates]
    if caps["a"] in names or caps["b"] in names:
        return None
    size, noun = ("magnitude of ", "velocity") if caps["RelNoun"] == "speed" else ("", caps["RelNoun"])
    return f"{size}{noun} of {_point(lexicon, caps['a'])} relative to {_point(lexicon, caps['b'])}"


def of_it(lexicon: Lexicon, noun: str) -> str:
    """A noun of what “it” means; the noun alone where that is not known."""
    return f"{noun} of {lexicon.it}" if lexicon.it else noun


def _ratio(lexicon: Lexicon, caps: Caps) -> str:
    return f"ratio of {caps['Noun']} of {caps['a']} to {caps['Noun']} of {caps['b']} {caps['Tails']}"


def _named(lexicon: Lexicon, caps: Caps) -> str | None:
    e = _element(lexicon, caps["Force"])
    return _role(caps["Role"], e) if e else f"{caps['Role']} {caps['Force']}" if caps["Role"] in ROLES else None


def _ratio_held(lexicon: Lexicon, caps: Caps) -> str | None:
    both = [_role(caps["Role"], _element(lexicon, caps[side])) for side in "ab"]
    return f"ratio of {both[0]} to {both[1]}" if all(both) else None


def _angle_of(lexicon: Lexicon, caps: Caps) -> str | None:
    angles = [c.name for c in lexicon.problem.coordinates if c.quantity.dimension == NUMBER]
    return angles[0] if len(angles) == 1 == len(lexicon.problem.bodies) else None


def of_thing(lexicon: Lexicon, caps: Caps, what: str) -> str | None:
    """What is asked of the coordinate, or body, that is named, or of the only coordinate; None for a point."""
    who = caps["Thing"] or lone(lexicon)
    return f"{what} of {who}" if who and "." not in who else None


def _resisting(lexicon: Lexicon, caps: Caps) -> str | None:
    found = [e.name for e in lexicon.elements if e.kind in ("resisting-couple", "rotary-damper")]
    return f"couple {found[0]}" if len(found) == 1 else None


def _component_of(axis: str) -> Of:
    return lambda lexicon, caps: _component(lexicon, {"x": axis, "Held": caps["Held"]})


def _driving(lexicon: Lexicon, caps: Caps) -> str | None:
    """What leads a body as prescribed, by its name."""
    kinds = ("prescribed-angle",) if caps["Thing"] and "force" not in caps.values() else ("prescribed",)
    found = [e.name for e in lexicon.elements if e.kind in kinds]
    return f"couple {found[0]}" if len(found) == 1 and kinds == ("prescribed-angle",) else found[0] if len(found) == 1 else None


def _weight(lexicon: Lexicon, caps: Caps) -> str | None:
    names = lexicon.problem.body_names
    return f"weight of {names[0]}" if len(names) == 1 else None


def _of_kinds(what: str, *kinds: str) -> Of:
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        e = _element(lexicon, caps["Element"])
        return f"{what} {e.name}".strip() if e and e.kind in kinds else None

    return find


def _impulse(lexicon: Lexicon, caps: Caps) -> str | None:
    """That of the only blow, if it strikes the body that is named."""
    met = {name for _, e in lexicon.blows for name in joined(e)}
    if caps["Body"] and met and caps["Body"] not in met:
        return None
    return f"impulse of {caps['Struck']}" if caps["Struck"] else "impulse" if lexicon.struck else None


def gone(lexicon: Lexicon, who: str) -> str:
    """How far something goes: of the only body, which more than one coordinate tells, what lies between beginning and end."""
    who, lone_body = lexicon.it if who == "it" else who, lexicon.it in lexicon.problem.body_names
    is_told = len(lexicon.problem.coordinates) > 1 and who == lexicon.it and lone_body and len(lexicon.problem.bodies) == 1
    return f"magnitude of displacement of {who}" if is_told else f"distance travelled by {who or 'it'}"


MEANINGS: Mapping[str, Of] = {
    "ratio_held": _ratio_held,
    "angle_of": _angle_of,
    "weight": _weight,
    "distance_from": lambda lexicon, caps: f"distance from {caps['Point']} to {_point(lexicon, caps['Thing'])}",
    "couple": _of_kinds("couple", "couple", "prescribed-angle", "torsion-spring", "rotary-damper", "resisting-couple"),
    "dissipated": _of_kinds("minus work of", "resisting-couple"),
    "impulse": _impulse,
    "ratio": _ratio,
    "resisting": _resisting,
    "lone_role": lambda lexicon, caps: _lone_role(lexicon, caps["Role"], set()) or caps["Role"],
    "system_cm": lambda lexicon, caps: "system.cm" if len(lexicon.problem.bodies) > 1 else None,
    "lone_centre": lambda lexicon, caps: f"instantaneous centre of {lexicon.it}" if lexicon.it else None,
    "held_x": _component_of("horizontal"),
    "held_y": _component_of("vertical"),
    "impulsive": lambda lexicon, caps: f"impulse of {e}" if (e := caps["Element"]) and lexicon.struck else None,
    "inertia": lambda lexicon, caps: f"moment of inertia of {caps['x'] or 'system'} {caps['About']}",
    "slid": lambda lexicon, caps: f"magnitude of displacement of {_point(lexicon, caps['a'])}"
                                  f" relative to {_point(lexicon, caps['b'])}",
    "coordinate": coordinate,
    "driving": _driving,
    "lone_component": lambda lexicon, caps: f"{caps['x']} component of {caps['Noun']} of {lexicon.it}" if lexicon.it else None,
    "spring": _of_kinds("", "spring", "torsion-spring"),
    "string": _of_kinds("", "string"),
    "its": lambda lexicon, caps: of_it(lexicon, caps["Noun"]),
    "relative": _relative,
    "component": _component,
    "multiple": lambda lexicon, caps: f"{'2' if caps['x'] in ('twice', 'double') else '1/2'}*{caps['State']}",
    "held": _held,
    "held_on": _held_on,
    "between": _between,
    "by_on": _by_on,
    "named": _named,
    "far": lambda lexicon, caps: f"{gone(lexicon, caps['Thing'])} {caps['Spans']}",
    "distance": lambda lexicon, caps: gone(lexicon, caps["Thing"] or caps["Subj"]),
    "angle": lambda lexicon, caps: f"angle turned by {caps['Holder']}" if caps["Holder"] else "angle turned",
    "turns": lambda lexicon, caps: f"number of turns of {caps['Holder']}" if caps["Holder"] else "number of turns",
    "work": lambda lexicon, caps: f"work of {caps['Force']}{' on ' if caps['Holder'] else ''}{caps['Holder']}",
    "work_between": lambda lexicon, caps: next((f"work of {e.name} on {caps['Holder']}" for e in lexicon.elements
                                                if {caps["Holder"], caps["Body"]} <= joined(e)), None),
    "change": lambda lexicon, caps: f"change of {caps['State']}",
}  # fmt: skip
