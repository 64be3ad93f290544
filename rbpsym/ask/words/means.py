"""What the rows of the grammar mean that hang on the problem: functions of what was read, None where they mean nothing."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from rbpsym.ask.named import begun_without, joined, may_be
from rbpsym.ask.words.chart import Caps
from rbpsym.ask.words.lexicon import RESTING, ROLES, TOUCHING, Lexicon
from rbpsym.expr import tree as t
from rbpsym.quantities import LENGTH, NUMBER, TIME
from rbpsym.statement.model import Element
from rbpsym.typeset.machine import to_machine

Of = Callable[[Lexicon, Caps], str | None]


def _element(lexicon: Lexicon, name: str) -> Element | None:
    return next((e for e in lexicon.elements if e.name == name), None)


def _role(role: str, e: Element | None, holder: str = "") -> str | None:
    """What holds or pushes by its name, if the noun may mean it, on a body if that is said: “reaction” is none of a rough
    contact, which has two parts."""
    kind = next((kind for kind, (words, _) in ROLES.items() if role in words.split("|")), "")
    if e is None or e.kind not in ROLES[kind][1]:
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


def _coordinate(lexicon: Lexicon, caps: Caps) -> str | None:
    """The only angle, or length, that tells a place; of several the only one that tells where a body is, not only how it lies."""
    wanted = NUMBER if caps["x"] == "angle" else LENGTH
    found = [c.name for c in lexicon.problem.coordinates if c.quantity.dimension == wanted]
    if len(found) > 1:
        places = {name for body in lexicon.problem.bodies for way in (body.placed or ("", ()))[1] for name in t.names(way)}
        found = [name for name in found if name in places]
    return found[0] if len(found) == 1 and caps["x"] != "place" else None


def _lone(lexicon: Lexicon) -> str:
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


def _of_it(lexicon: Lexicon, noun: str) -> str:
    return f"{noun} of {lexicon.it}" if lexicon.it else noun


def _cut(lexicon: Lexicon, caps: Caps) -> str | None:
    found = begun_without(lexicon.problem, f"{caps['who']} is cut")
    return found.removesuffix(" begins") if found.endswith(" begins") else None


def _blow(lexicon: Lexicon, caps: Caps) -> str | None:
    side = caps["side"].replace("immediately", "just").replace("right before", "just before")
    if lexicon.struck and not lexicon.blows:  # what is met is a new constraint
        return f"{side.replace('just after', 'right after')} impact" if side.startswith("just ") else None
    return f"{side or 'when'} {caps['Subj']} hits {caps['HitWhat']}" if lexicon.blows else None


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


def _of_thing(lexicon: Lexicon, caps: Caps, what: str) -> str | None:
    who = caps["Thing"] or _lone(lexicon)
    return f"{what} of {who}" if who and "." not in who else None


def singular(noun: str) -> str:
    """“velocity” for “velocities”."""
    return {"momenta": "momentum"}.get(noun, re.sub("ies$", "y", noun) if noun.endswith("ies") else noun.removesuffix("s"))


def _ratio_each(way: int) -> Of:
    """Of two bodies, the ratio of the first to the other one, or the other way round: which is meant is not said."""
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        names, noun = lexicon.problem.body_names[::way], singular(caps["n"])
        return f"ratio of {noun} of {names[0]} to {noun} of {names[1]} {caps['Tails']}" if len(names) == 2 else None

    return find


def _lone_noun(lexicon: Lexicon, caps: Caps) -> str:
    return _of_it(lexicon, caps["Noun"] or caps["n"])


def _leaves(lexicon: Lexicon, caps: Caps) -> str:
    """That the contact with what is named vanishes, where a body has several."""
    sides = [e for e in lexicon.elements if e.kind in TOUCHING and caps["Subj"] in (*joined(e), "it")]
    found = [e.name for e in sides if caps["g"] in (*lexicon.grounds(e), *joined(e))]
    return f"{found[0]} vanishes" if len(found) == 1 < len(sides) else f"{caps['Subj']} leaves {caps['g']}"


def _lone_contact(lexicon: Lexicon, place: str) -> str | None:
    sides = [e.name for e in lexicon.elements if e.kind in TOUCHING]
    return f"{sides[0]} where {place} vanishes" if len(sides) == 1 else None


def _on_way(lexicon: Lexicon, caps: Caps) -> str | None:
    """The way up is the motion before, and the way down that after the only phase that begins when it stops."""
    phases, who = lexicon.problem.phases, caps["Thing"] or lexicon.it
    if len(phases) != 1 or phases[0].impulses or not who:
        return None
    return f"{caps['n']} of {who} <1>in phase {'first' if caps['x'] == 'up' else phases[0].name}"


def _resisting(lexicon: Lexicon, caps: Caps) -> str | None:
    found = [e.name for e in lexicon.elements if e.kind in ("resisting-couple", "rotary-damper")]
    return f"couple {found[0]}" if len(found) == 1 else None


def _from_rest(lexicon: Lexicon, caps: Caps) -> str | None:
    """What is said of the start adds nothing where the problem says it."""
    return "" if all(c.speed is None or to_machine(c.speed) == "0" for c in lexicon.problem.coordinates) else None


def _resonance(asked: str) -> Of:
    """Where the amplitude of the only coordinate is largest, over the only letter that is so many radians a second."""
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        drives = [q.name for q in lexicon.problem.parameters if q.dimension == NUMBER / TIME]
        return asked.format(drives[0], _lone(lexicon)) if len(drives) == 1 and _lone(lexicon) else None

    return find


def _component_of(axis: str) -> Of:
    return lambda lexicon, caps: _component(lexicon, {"x": axis, "Held": caps["Held"]})


def _critical(lexicon: Lexicon, caps: Caps) -> str | None:
    """The letter of the only damper for which the only coordinate is critically damped."""
    found = [v.name for e in lexicon.elements if "damper" in e.kind and isinstance(v := e.values.get("coefficient"), t.Sym)]
    return f"{found[0]} for which {_lone(lexicon)} is critically damped" if len(found) == 1 and _lone(lexicon) else None


def _terminal(lexicon: Lexicon, caps: Caps) -> str | None:
    """A speed in the last phase, or else that to which the only coordinate of the kind tends."""
    if lexicon.problem.phases:
        who = caps["Thing"] or lexicon.it
        return f"{caps['n']} of {who} <1>in phase {lexicon.problem.phases[-1].name}" if who else None
    wanted = NUMBER if "angular" in caps["n"] else LENGTH
    names = [c.name for c in lexicon.problem.coordinates if c.quantity.dimension == wanted]
    return f"terminal speed of {names[0]}" if len(names) == 1 else None


def _fraction(lexicon: Lexicon, caps: Caps) -> str:
    """What a blow, or else the slipping until it rolls, takes of the kinetic energy."""
    lost, first = ("", "just before impact") if lexicon.struck else ("until it rolls ", "at start")
    return f"ratio of energy lost {lost}to kinetic energy {first}"


def _heat(lexicon: Lexicon, caps: Caps) -> str | None:
    """What slipping takes until it rolls, where something round can roll."""
    rolls = any(may_be(body, "wheel") or may_be(body, "ball") for body in lexicon.problem.bodies)
    return "heat produced until it rolls" if rolls and not lexicon.struck else None


def _begun(lexicon: Lexicon, caps: Caps) -> str:
    side = caps["side"].split()
    where = "just before {}" if "before" in side else "right after {}" if "after" in side else "when {} begins"
    return where.format(caps["Begun"])


def _flat(lexicon: Lexicon, caps: Caps) -> str | None:
    """A rod of which an end moves on a floor hits that where it is horizontal."""
    rods = [body.name for body in lexicon.problem.bodies if body.shape.kind == "rod" and body.name == caps["Body"]]
    floors = [e for e in lexicon.elements if caps["Body"] in joined(e) and "floor" in lexicon.grounds(e) and not e.values.get("of")]
    return f"where {caps['Body']} is horizontal" if rods and floors and not lexicon.struck else None


def _end(which: str) -> Of:
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        rods = [body.name for body in lexicon.problem.bodies if body.shape.kind == "rod" and caps["Body"] in ("", body.name)]
        return f"{which} end of {rods[0]}" if len(rods) == 1 else None

    return find


def _after(where: str) -> Of:
    return lambda lexicon, caps: where.format(lexicon.struck) if lexicon.struck else None


def _swings(lexicon: Lexicon, caps: Caps) -> str | None:
    """A frequency is a circular one, as all are here."""
    words = "period" if caps["Swinging"].startswith("period") else "frequency"
    who = caps["Thing"] or _lone(lexicon)
    return f"{words} of {who}" if who else words


def _starts(lexicon: Lexicon, caps: Caps) -> str | None:
    """What starts a motion just balances what holds it."""
    return f"{caps['Par']} for which acceleration of {_lone(lexicon)} at start vanishes" if _lone(lexicon) else None


def _driving(lexicon: Lexicon, caps: Caps) -> str | None:
    """What leads a body as prescribed, by its name."""
    kinds = ("prescribed-angle",) if caps["Thing"] and "force" not in caps.values() else ("prescribed",)
    found = [e.name for e in lexicon.elements if e.kind in kinds]
    return f"couple {found[0]}" if len(found) == 1 and kinds == ("prescribed-angle",) else found[0] if len(found) == 1 else None


def _full(lexicon: Lexicon, caps: Caps) -> str | None:
    """A full turn is one of the only coordinate that is an angle, from its start."""
    found = [c for c in lexicon.problem.coordinates if c.quantity.dimension == NUMBER]
    if len(found) != 1 or len(lexicon.problem.coordinates) != 1 or found[0].start is None:
        return None
    return f"{found[0].name} reaches {to_machine(found[0].start)} + 2*pi"


def _weight(lexicon: Lexicon, caps: Caps) -> str | None:
    names = lexicon.problem.body_names
    return f"weight of {names[0]}" if len(names) == 1 else None


def _of_kinds(what: str, *kinds: str) -> Of:
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        e = _element(lexicon, caps["Element"])
        return f"{what} {e.name}".strip() if e and e.kind in kinds else None

    return find


RANKS = {"lower": "lowest", "higher": "highest", "first": "lowest"}
EXTREMES = {"longest": "largest", "shortest": "smallest"}
MEANINGS: Mapping[str, Of] = {
    "ratio_held": _ratio_held,
    "angle_of": _angle_of,
    "full": _full,
    "weight": _weight,
    "stable": lambda lexicon, caps: f"{found} is {caps['x']}" if (found := _of_thing(lexicon, caps, "equilibrium")) else None,
    "equilibrium": lambda lexicon, caps: _of_thing(lexicon, caps, "equilibrium"),
    "slowing": lambda lexicon, caps: _of_thing(lexicon, caps, caps["x"].replace("retardation", "deceleration")),
    "distance_from": lambda lexicon, caps: f"distance from {caps['Point']} to {_point(lexicon, caps['Thing'])}",
    "difference": lambda lexicon, caps: f"{caps['State']} {caps['a']} - {caps['State']} {caps['b']}",
    "couple": _of_kinds("couple", "couple", "prescribed-angle", "torsion-spring", "rotary-damper", "resisting-couple"),
    "dissipated": _of_kinds("minus work of", "resisting-couple"),
    "impulse": lambda lexicon, caps: f"impulse of {caps['Struck']}" if caps["Struck"] else "impulse" if lexicon.struck else None,
    "ratio": _ratio,
    "strikes": lambda lexicon, caps: f"speed of {caps['Subj']} <2>just before {caps['Subj']} hits {caps['HitWhat']}"
                                     if lexicon.blows else None,
    "with_which": lambda lexicon, caps: f"{_of_it(lexicon, caps['n'])} <2>where {caps['Event']}",
    "acquired": lambda lexicon, caps: f"{caps['n']} of {caps['Thing']}{' <2>right after impact' if lexicon.struck else ''}",
    "height_at": lambda lexicon, caps: f"height of {lexicon.it}.cm <2>where {caps['Event']}"
                                       if lexicon.it in lexicon.problem.body_names else None,
    "on_way": _on_way,
    "resisting": _resisting,
    "lone_role": lambda lexicon, caps: _lone_role(lexicon, caps["Role"], set()) or caps["Role"],
    "system_cm": lambda lexicon, caps: "system.cm" if len(lexicon.problem.bodies) > 1 else None,
    "extreme": lambda lexicon, caps: f"{caps['Subj']} is at its {'lowest' if 'lowest' in caps['x'] else 'highest'} point",
    "turned": lambda lexicon, caps: f"where {caps['Body'] or 'it'} has turned 2*pi*({caps['Value'] or 1})",
    "best_of": lambda lexicon, caps: f"{caps['Par']} for which {caps['State']} is {EXTREMES.get(caps['Best'], caps['Best'])}",
    "where": lambda lexicon, caps: f"{_lone(lexicon)} where {caps['Event']}" if _lone(lexicon) else None,
    "cut": _cut,
    "lone_centre": lambda lexicon, caps: f"instantaneous centre of {lexicon.it}" if lexicon.it else None,
    "slid_until": lambda lexicon, caps: MEANINGS["slid"](lexicon, caps) + f" until {caps['e'] or 'it stops slipping'}",
    "forced": lambda lexicon, caps: f"{'phase' if caps['x'] else 'amplitude'} of {who}" if (who := caps["Thing"] or _lone(lexicon)) else None,
    "resonance": _resonance("{} for which amplitude of {} is largest"),
    "at_resonance": _resonance("largest amplitude of {1} over {0}"),
    "held_x": _component_of("horizontal"),
    "held_y": _component_of("vertical"),
    "critical": _critical,
    "of_mode": lambda lexicon, caps: f"{RANKS.get(caps['o'], caps['o'])} {caps['x'].split()[-1]}",
    "impulsive": lambda lexicon, caps: f"impulse of {e} in impact" if (e := caps["Element"]) and lexicon.struck else None,
    "stops_in": lambda lexicon, caps: f"{caps['Subj']} stops {caps['w'].replace('in', 'after') if caps['w'] == 'in' else caps['w']} "
                                      f"{caps['Value']} turns",
    "stopping": lambda lexicon, caps: f"{caps['Par']} for which {caps['b'] or 'it'} stops "
                                      f"{'within' if caps['w'] == 'within' else 'after'} {caps['Value']} turns",
    "tip": _end("free"),
    "now": lambda lexicon, caps: None if lexicon.problem.phases else "at start",
    "from_rest": _from_rest,
    "inertia": lambda lexicon, caps: f"moment of inertia of {caps['x'] or 'system'} {caps['About']}",
    "final": lambda lexicon, caps: f"{caps['State']} in phase {phases[-1].name}" if (phases := lexicon.problem.phases) else None,
    "in_impact": lambda lexicon, caps: "in impact" if lexicon.struck else None,
    "leaves_at": lambda lexicon, caps: f"{_leaves(lexicon, caps).replace(' vanishes', '')} where {caps['Place']} vanishes"
                                       if "leaves" not in _leaves(lexicon, caps) else _lone_contact(lexicon, caps["Place"]),
    "slid": lambda lexicon, caps: f"magnitude of displacement of {_point(lexicon, caps['a'])} relative to {_point(lexicon, caps['b'])}",
    "doubled": lambda lexicon, caps: f"{caps['State']} = 2*({caps['State']} at start)",
    "ratio_each": _ratio_each(1),
    "ratio_other": _ratio_each(-1),
    "cut_at_start": lambda lexicon, caps: None if lexicon.problem.phases else "at start",  # the problem is that of what is left
    "blow": _blow,
    "coordinate": _coordinate,
    "speed": lambda lexicon, caps: f"speed of {caps['Subj']} = {caps['SpeedValue']}",
    "rests": lambda lexicon, caps: f"{caps['Subj']} comes to rest",
    "leaves": _leaves,
    "lone_noun": _lone_noun,
    "terminal": _terminal,
    "fraction": _fraction,
    "begun": _begun,
    "swings": _swings,
    "starts": _starts,
    "driving": _driving,
    "damped": lambda lexicon, caps: f"{who} is {caps['x']}" if (who := caps["Thing"] or _lone(lexicon)) else None,
    "lone_component": lambda lexicon, caps: f"{caps['x']} component of {caps['Noun']} of {lexicon.it}" if lexicon.it else None,
    "distance_until": lambda lexicon, caps: f"distance travelled by {lexicon.it} until {caps['Event']}" if lexicon.it else None,
    "heat": _heat,
    "flat": _flat,
    "lower_end": _end("lower"),
    "upper_end": _end("upper"),
    "after_blow": _after("right after impact"),
    "before_blow": _after("just before impact"),
    "in_blow": _after("<2>in impact"),
    "until_blow": _after("<2>until {}"),
    "each": lambda lexicon, caps: f"{singular(caps['n'])} of {caps['Each']}",
    "is_stable": lambda lexicon, caps: f"is equilibrium of {who} stable" if (who := caps["Thing"] or _lone(lexicon)) else None,
    "highest": lambda lexicon, caps: f"height of {who}.cm is largest" if (who := lexicon.it) in lexicon.problem.body_names else None,
    "one_turn": lambda lexicon, caps: f"<2>until {caps['b'] or lexicon.it or 'it'} has turned 2*pi",
    "largest_angle": lambda lexicon, caps: f"largest {found}" if (found := _coordinate(lexicon, {**caps, "x": "angle"})) else None,
    "vanishes": lambda lexicon, caps: f"{caps['Held']} vanishes",
    "stretched": lambda lexicon, caps: f"{'compression' if caps['c'] == 'compressed' else 'elongation'} of {caps['Spring']} = "
                                       f"{caps['Length']}",
    "spring": _of_kinds("", "spring", "torsion-spring"),
    "string": _of_kinds("", "string"),
    "its": lambda lexicon, caps: _of_it(lexicon, caps["Noun"]),
    "relative": _relative,
    "component": _component,
    "multiple": lambda lexicon, caps: f"{'2' if caps['x'] in ('twice', 'double') else '1/2'}*{caps['State']}",
    "held": _held,
    "held_on": _held_on,
    "between": _between,
    "by_on": _by_on,
    "named": _named,
    "distance": lambda lexicon, caps: f"distance travelled by {caps['Thing'] or (lexicon.it if caps['Subj'] == 'it' else caps['Subj'])}",
    "angle": lambda lexicon, caps: f"angle turned by {caps['Holder']}" if caps["Holder"] else "angle turned",
    "turns": lambda lexicon, caps: f"number of turns of {caps['Holder']}" if caps["Holder"] else "number of turns",
    "work": lambda lexicon, caps: f"work of {caps['Force']}{' on ' if caps['Holder'] else ''}{caps['Holder']}",
    "work_between": lambda lexicon, caps: next((f"work of {e.name} on {caps['Holder']}" for e in lexicon.elements
                                                if {caps["Holder"], caps["Body"]} <= joined(e)), None),
    "change": lambda lexicon, caps: f"change of {caps['State']}",
}  # fmt: skip
