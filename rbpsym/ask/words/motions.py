"""What the rows of the grammar mean that are about motions and moments: functions of what was read (see `means`)."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.ask.named import begun_without, joined, may_be
from rbpsym.ask.words.chart import Caps
from rbpsym.ask.words.lexicon import RESTING, TOUCHING, Lexicon
from rbpsym.ask.words.means import MEANINGS, Of, coordinate, gone, lone, of_it, of_thing
from rbpsym.expr import tree as t
from rbpsym.quantities import FORCE, LENGTH, NUMBER, TIME
from rbpsym.statement.paths import tensions
from rbpsym.typeset.machine import to_machine

RANKS = {"lower": "lowest", "higher": "highest", "first": "lowest"}
EXTREMES = {"longest": "largest", "shortest": "smallest"}


def _cut(lexicon: Lexicon, caps: Caps) -> str | None:
    found = begun_without(lexicon.problem, f"{caps['who']} is cut")
    return found.removesuffix(" begins") if found.endswith(" begins") else None


def _taut(lexicon: Lexicon, caps: Caps) -> str | None:
    """The phase in which what was slack begins to pull, if that is no blow."""
    phases = lexicon.problem.phases
    acting = [{e.name for e in (*one.constraints, *one.interactions)} for one in (lexicon.problem, *(p.problem for p in phases))]
    new = [phase for phase, before, now in zip(phases, acting, acting[1:], strict=True) if caps["Element"] in now - before]
    return new[0].name if len(new) == 1 and new[0].name != lexicon.struck else None


def _blow(lexicon: Lexicon, caps: Caps) -> str | None:
    side = caps["side"].replace("immediately", "just").replace("right before", "just before")
    if lexicon.struck and not lexicon.blows:  # what is met is a new constraint
        return f"{side.replace('just after', 'right after')} impact" if side.startswith("just ") else None
    return f"{side or 'when'} {caps['Subj']} hits {caps['HitWhat']}" if lexicon.blows else None


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
    return of_it(lexicon, caps["Noun"] or caps["n"])


def _leaves(lexicon: Lexicon, caps: Caps) -> str:
    """That the contact with what is named vanishes, where a body has several."""
    is_body = caps["Subj"] in lexicon.problem.body_names
    sides = [e for e in lexicon.elements if e.kind in TOUCHING and (caps["Subj"] in joined(e) or not is_body)]
    found = [e.name for e in sides if caps["g"] in (*lexicon.grounds(e), *joined(e))]
    return f"{found[0]} vanishes" if len(found) == 1 < len(sides) else f"{caps['Subj']} leaves {caps['g']}"


def _lone_contact(lexicon: Lexicon, place: str) -> str | None:
    sides = [e.name for e in lexicon.elements if e.kind in TOUCHING]
    return f"{sides[0]} where {place} vanishes" if len(sides) == 1 else None


def _on_way(lexicon: Lexicon, caps: Caps) -> str | None:
    """The way back is the only phase that begins, when it stops."""
    phases, who = lexicon.problem.phases, caps["Thing"] or lexicon.it
    if len(phases) != 1 or phases[0].impulses or not who:
        return None
    return f"{caps['n']} of {who} <1>in phase {phases[0].name}"


def _from_rest(lexicon: Lexicon, caps: Caps) -> str | None:
    """What is said of the start adds nothing where the problem says it."""
    return "" if all(c.speed is None or to_machine(c.speed) == "0" for c in lexicon.problem.coordinates) else None


def _resonance(asked: str) -> Of:
    """Where the amplitude of the only coordinate is largest, over the only letter that is so many radians a second."""

    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        drives = [q.name for q in lexicon.problem.parameters if q.dimension == NUMBER / TIME]
        return asked.format(drives[0], lone(lexicon)) if len(drives) == 1 and lone(lexicon) else None

    return find


def _critical(lexicon: Lexicon, caps: Caps) -> str | None:
    """The letter of the only damper for which the only coordinate is critically damped."""
    found = [v.name for e in lexicon.elements if "damper" in e.kind and isinstance(v := e.values.get("coefficient"), t.Sym)]
    return f"{found[0]} for which {lone(lexicon)} is critically damped" if len(found) == 1 and lone(lexicon) else None


def _halved(lexicon: Lexicon, caps: Caps) -> str | None:
    """Half of the speed with which the only coordinate starts: of itself, or of a body's turning that goes with it."""
    coordinates = lexicon.problem.coordinates
    own = caps["Coord"] or not caps["Holder"] or "angular" in caps["n"]
    if len(coordinates) != 1 or coordinates[0].speed is None or not own:
        return None
    return f"speed of {coordinates[0].name} = ({to_machine(coordinates[0].speed)})/2"


def _along(lexicon: Lexicon, caps: Caps) -> str | None:
    """The size of what has one direction; that it is down a slope is known where weights and contacts alone act."""
    drives = [e for e in lexicon.elements if e.kind not in (*TOUCHING, *RESTING, "gravity", "link", "resisting-couple")]
    who = caps["Thing"] or lexicon.it
    return f"magnitude of {caps['n']} of {who}" if who and (caps["x"] == "along" or not drives) else None


def _begins_at_zero(lexicon: Lexicon) -> bool:
    """Whether heights are counted from where the motion begins."""
    return all(c.start is None or to_machine(c.start) == "0" for c in lexicon.problem.coordinates)


def _holds_out(lexicon: Lexicon, caps: Caps) -> str | None:
    """That a force stays below the only one that the problem calls a strength, or the greatest that is borne."""
    strong = [q.name for q in lexicon.problem.parameters if q.dimension == FORCE and STRENGTH.search(f"{q.name} {q.meaning}")]
    name = caps["Force"] or caps["Element"]
    of = next((forces[0] for e in lexicon.elements if e.name == name and e.kind == "string" and (forces := tensions(e))), name)
    return f"{of} stays below {strong[0]}" if len(strong) == 1 and of not in strong else None


STRENGTH = re.compile(r"(?i)max|break|strength|greatest|largest|(?:can|may) (?:bear|stand|hold)")


def _upright(lexicon: Lexicon, caps: Caps) -> str | None:
    """Where the only coordinate is 0, if that is told to be so."""
    told = "".join(c.quantity.meaning for c in lexicon.problem.coordinates)
    known = "upward vertical" in told or "upright" in told or (caps["u"] == "vertical" and "vertical" in told)
    return f"{lone(lexicon)} = 0 is {caps['x']}" if lone(lexicon) and known else None


def _rough_at(lexicon: Lexicon, caps: Caps) -> str | None:
    """The coefficient at a contact, where no other one is rough."""
    rough = [e.name for e in lexicon.elements if e.values.get("friction")]
    return "smallest mu for which it does not slip" if rough == [caps["Contact"]] else None


def _terminal(lexicon: Lexicon, caps: Caps) -> str | None:
    """A speed in the last phase, or else that to which the only coordinate of the kind tends."""
    if lexicon.problem.phases:
        who = caps["Thing"] or lexicon.it
        return f"{caps['n']} of {who} <1>in phase {lexicon.problem.phases[-1].name}" if who else None
    wanted = NUMBER if "angular" in caps["n"] else LENGTH
    names = [c.name for c in lexicon.problem.coordinates if c.quantity.dimension == wanted]
    return f"terminal speed of {names[0]}" if len(names) == 1 else None


def _fraction(lexicon: Lexicon, caps: Caps) -> str | None:
    """What a blow, or else the slipping until it rolls, takes of the kinetic energy."""
    if (caps["b"] and not lexicon.struck) or (caps["f"] and lexicon.struck):
        return None
    lost, first = ("", "just before impact") if lexicon.struck else ("until it rolls ", "at start")
    return f"ratio of energy lost {lost}to kinetic energy {first}"


def _heat(lexicon: Lexicon, caps: Caps) -> str | None:
    """What slipping takes until it rolls, where something round can roll."""
    round_ = (body for body in lexicon.problem.bodies if body.shape.kind != "particle")
    rolls = any(may_be(body, word) for body in round_ for word in ("wheel", "ball"))
    return "heat produced until it rolls" if rolls and not lexicon.struck else None


def _begun(lexicon: Lexicon, caps: Caps) -> str:
    side = caps["side"].split()
    where = "just before {}" if "before" in side else "right after {}" if "after" in side else "when {} begins"
    return where.format(caps["Begun"])


def _flat(lexicon: Lexicon, caps: Caps) -> str | None:
    """A rod of which an end moves on a floor hits that where it is horizontal."""
    rods = [body.name for body in lexicon.problem.bodies if body.shape.kind == "rod" and body.name == caps["Body"]]
    floors = [
        e for e in lexicon.elements if caps["Body"] in joined(e) and "floor" in lexicon.grounds(e) and not e.values.get("of")
    ]
    return f"where {caps['Body']} is horizontal" if rods and floors and not lexicon.struck else None


def _end(which: str) -> Of:
    def find(lexicon: Lexicon, caps: Caps) -> str | None:
        rods = [body.name for body in lexicon.problem.bodies if body.shape.kind == "rod" and caps["Body"] in ("", body.name)]
        return f"{which} end of {rods[0]}" if len(rods) == 1 else None

    return find


def _after(where: str) -> Of:
    return lambda lexicon, caps: where.format(lexicon.struck) if lexicon.struck else None


def _beside(side: str) -> Of:
    """Just before or right after the one thing that happens: the blow, or else where the only later phase begins."""

    def told(lexicon: Lexicon, caps: Caps) -> str | None:
        phases = lexicon.problem.phases
        return f"{side} impact" if lexicon.struck else f"{side} {phases[0].name}" if len(phases) == 1 else None

    return told


def _swings(lexicon: Lexicon, caps: Caps) -> str | None:
    """A frequency is a circular one, as all are here."""
    words = "period" if caps["Swinging"].startswith("period") else "frequency"
    who = caps["Thing"] or lone(lexicon)
    return f"{words} of {who}" if who else words


def _starts(lexicon: Lexicon, caps: Caps) -> str | None:
    """What starts a motion just balances what holds it."""
    return f"{caps['Par']} for which acceleration of {lone(lexicon)} at start vanishes" if lone(lexicon) else None


def _full(lexicon: Lexicon, caps: Caps) -> str | None:
    """A full turn is one of the only coordinate that is an angle, from its start."""
    found = [c for c in lexicon.problem.coordinates if c.quantity.dimension == NUMBER]
    if len(found) != 1 or len(lexicon.problem.coordinates) != 1 or found[0].start is None:
        return None
    return f"{found[0].name} reaches {to_machine(found[0].start)} + 2*pi"


MOTIONS: Mapping[str, Of] = {
    "full": _full,
    "stable": lambda lexicon, caps: f"{found} is {caps['x']}" if (found := of_thing(lexicon, caps, "equilibrium")) else None,
    "equilibrium": lambda lexicon, caps: of_thing(lexicon, caps, "equilibrium"),
    "slowing": lambda lexicon, caps: of_thing(lexicon, caps, caps["x"].replace("retardation", "deceleration")),
    "difference": lambda lexicon, caps: f"{caps['State']} {caps['a']} - {caps['State']} {caps['b']}",
    "strikes": lambda lexicon, caps: f"speed of {caps['Subj']} <2>just before {caps['Subj']} hits {caps['HitWhat']}"
                                     if lexicon.blows else None,
    "with_which": lambda lexicon, caps: f"{of_it(lexicon, caps['n'] or 'speed')} <2>where {caps['Event']}",
    "acquired": lambda lexicon, caps: f"{caps['n']} of {caps['Thing']}{' <2>right after impact' if lexicon.struck else ''}",
    "height_at": lambda lexicon, caps: f"height of {lexicon.it}.cm <2>where {caps['Event']}"
                                       if lexicon.it in lexicon.problem.body_names else None,
    "on_way": _on_way,
    "extreme": lambda lexicon, caps: f"{caps['Subj']} is at its {'lowest' if 'lowest' in caps['x'] else 'highest'} point",
    "turned": lambda lexicon, caps: f"where {caps['Body'] or 'it'} has turned 2*pi*({caps['Value'] or 1})",
    "best_of": lambda lexicon, caps: f"{caps['Par']} for which {caps['State']} is {EXTREMES.get(caps['Best'], caps['Best'])}",
    "where": lambda lexicon, caps: f"{who} where {caps['Event']}"
                                   if (who := lone(lexicon) or coordinate(lexicon, {**caps, "x": "angle"})) else None,
    "cut": _cut,
    "taut": _taut,
    "slid_until": lambda lexicon, caps: f"{MEANINGS['slid'](lexicon, caps)} until {caps['e'] or 'it stops slipping'}",
    "critically": lambda lexicon, caps: f"{lone(lexicon)} is critically damped" if lone(lexicon) else None,
    "halved": _halved,
    "along": _along,
    "max_height": lambda lexicon, caps: "how high does it rise" if _begins_at_zero(lexicon) else None,
    "holds_out": _holds_out,
    "upright": _upright,
    "rough_at": _rough_at,
    "forced": lambda lexicon, caps: f"{'phase' if caps['x'] else 'amplitude'} of {who}"
                                    if (who := caps["Thing"] or lone(lexicon)) else None,
    "resonance": _resonance("{} for which amplitude of {} is largest"),
    "at_resonance": _resonance("largest amplitude of {1} over {0}"),
    "critical": _critical,
    "of_mode": lambda lexicon, caps: f"{RANKS.get(caps['o'], caps['o'])} {caps['x'].split()[-1]}",
    "stops_in": lambda lexicon, caps: f"{caps['Subj']} stops {'after' if caps['w'] == 'in' else caps['w']} {caps['Value']} turns",
    "stopping": lambda lexicon, caps: f"{caps['Par']} for which {caps['b'] or 'it'} stops "
                                      f"{'within' if caps['w'] == 'within' else 'after'} {caps['Value']} turns",
    "tip": _end("free"),
    "now": lambda lexicon, caps: None if lexicon.problem.phases else "at start",
    "from_rest": _from_rest,
    "final": lambda lexicon, caps: f"{caps['State']} in phase {phases[-1].name}" if (phases := lexicon.problem.phases) else None,
    "in_impact": lambda lexicon, caps: "in impact" if lexicon.struck else None,
    "leaves_at": lambda lexicon, caps: f"{_leaves(lexicon, caps).replace(' vanishes', '')} where {caps['Place']} vanishes"
                                       if "leaves" not in _leaves(lexicon, caps) else _lone_contact(lexicon, caps["Place"]),
    "doubled": lambda lexicon, caps: f"{caps['State']} = 2*({caps['State']} at start)",
    "ratio_each": _ratio_each(1),
    "ratio_other": _ratio_each(-1),
    "cut_at_start": lambda lexicon, caps: None if lexicon.problem.phases else "at start",  # the problem is that of what is left,
    "blow": _blow,
    "speed": lambda lexicon, caps: f"speed of {caps['Subj']} = {caps['SpeedValue']}",
    "rests": lambda lexicon, caps: f"{caps['Subj']} comes to rest",
    "leaves": _leaves,
    "lone_noun": _lone_noun,
    "terminal": _terminal,
    "fraction": _fraction,
    "begun": _begun,
    "swings": _swings,
    "starts": _starts,
    "damped": lambda lexicon, caps: f"{who} is {caps['x']}" if (who := caps["Thing"] or lone(lexicon)) else None,
    "distance_until": lambda lexicon, caps: f"{gone(lexicon, 'it')} until {caps['Event']}" if lexicon.it else None,
    "heat": _heat,
    "flat": _flat,
    "lower_end": _end("lower"),
    "upper_end": _end("upper"),
    "just_before": _beside("just before"),
    "just_after": _beside("right after"),
    "after_blow": _after("right after impact"),
    "before_blow": _after("just before impact"),
    "in_blow": _after("<2>in impact"),
    "until_blow": _after("<2>until {}"),
    "each": lambda lexicon, caps: f"{singular(caps['n'])} of {caps['Each']}",
    "is_stable": lambda lexicon, caps: f"is equilibrium of {who} stable" if (who := caps["Thing"] or lone(lexicon)) else None,
    "highest": lambda lexicon, caps: f"height of {who}.cm is largest"
                                     if (who := lexicon.it) in lexicon.problem.body_names else None,
    "one_turn": lambda lexicon, caps: f"<2>until {caps['b'] or lexicon.it or 'it'} has turned 2*pi",
    "largest_angle": lambda lexicon, caps: f"largest {found}" if (not caps["Thing"] or lone(lexicon)) and (
                         found := coordinate(lexicon, {**caps, "x": "angle"})) else None,
    "vanishes": lambda lexicon, caps: f"{caps['Held']} vanishes",
    "stretched": lambda lexicon, caps: f"{'compression' if caps['c'] == 'compressed' else 'elongation'} of {caps['Spring']} = "
                                       f"{caps['Length']}",
}  # fmt: skip
