"""A question in the problem's own words: a quantity, and when, where or as a function of what.

“normal force N where theta = pi/2”, “speed of rod.end as a function of theta”, “work of f until rolling”. A
new way to say when or where is a new row of CLAUSES.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.errors import ReadError
from rbpsym.frozen import Frozen, replace
from rbpsym.quantity.bound import without_articles
from rbpsym.quantity.moments import JUMPS

LONGEST = 400  # characters of a question
LEAST = {"smallest": -1, "least": -1, "lowest": -1, "minimum": -1, "minimal": -1, "shortest": -1, "slowest": -1}
GREATEST = {"largest": 1, "greatest": 1, "highest": 1, "maximum": 1, "maximal": 1, "longest": 1, "fastest": 1}
SUPERLATIVES = LEAST | GREATEST


class When(Frozen):
    """A moment or place of the motion: its kind, a key of `moments.MOMENTS`, and the words that say which."""

    kind: str
    words: tuple[str, ...] = ()
    text: str = ""


class Question(Frozen):
    """What is asked: the words of a quantity, when (None: all along), since when a change or work is counted, in which
    phase, as a function of what (“state”: of places and speeds), in which `manner` it moves (values of MANNERS); whether
    the direction of the vector is asked for."""

    text: str
    quantity: str
    when: When | None = None
    since: When | None = None
    phase: str = ""
    of: str = ""
    is_direction: bool = False
    manner: str = ""


_N, _W = r"(\w+)", r"([\w-]+(?: [\w-]+)??)"
_AT = r"(?:where|when|at|once|until|up to where|as soon as)"

# what a clause says -> how it may be written, with an example for the page of the grammar
CLAUSES: tuple[tuple[str, str, str], ...] = (
    ("of", r"(?:as (?:a )?functions? of|in terms of) (state|positions? and speeds?)", "F_x as a function of the state"),
    ("of", rf"(?:as (?:a )?functions? of|in terms of) {_N}", "speed of rod.end as a function of theta"),
    ("start", r"(?:at (?:start|beginning|moment of release)|initially|at t = 0)", "F_y at the start"),
    ("start", r"(?:just|right|immediately) after (?:release|[\w-]+ is (?:released|let go))", "F_y right after release"),
    ("begins", rf"(?:where|when|once|as soon as) {_W} (?:begins|starts)", "velocity of ball.cm when rolling begins"),
    ("begins", rf"(?:just|right|immediately) after {_W}(?: begins)?", "angular velocity of rod right after struck"),
    ("before", rf"(?:just|right|immediately) before {_W}(?: begins)?", "kinetic energy just before rolling"),
    ("end", rf"at end of (?:phase )?{_W}", "speed of x at the end of phase bowling"),
    ("over", rf"(?:over|during) (?:phase )?{_W}", "work of f during phase sliding"),
    ("vanishes", rf"{_AT} {_N} (?:vanishes|is lost|goes slack|leaves)", "theta where N_w vanishes"),
    ("rests", rf"{_AT} it (?:comes to rest|stops)", "time until it comes to rest"),
    ("rests", rf"{_AT} {_N} (?:comes to rest|stops)", "theta where theta comes to rest"),
    ("rests", r"at (?:its )?turning point", "F_y at the turning point"),
    ("rests", rf"at (?:its )?turning point of {_N}", "F_y at the turning point of theta"),
    ("grips", rf"{_AT} (?:it|{_N}) (?:stops slipping|rolls(?: without slipping)?|begins to roll)",
     "velocity of ball.cm when N stops slipping"),
    ("slips", rf"{_AT} (?:it|{_N}) (?:slips|begins to slip)", "theta when N slips"),
    ("rest", r"(?:at|in) (?:stable )?(?:rest|equilibrium)", "F_y in equilibrium"),
    ("unstable", r"(?:at|in) unstable equilibrium", "F_y in the unstable equilibrium"),
    ("reaches", rf"{_AT} {_N} (?:=|reaches|is) (.+?)", "omega where theta = pi/2"),
    ("until", rf"until {_W}(?: begins)?", "time until rolling"),
)  # fmt: skip


# what is only another way to write something
OTHERWISE: tuple[tuple[str, str | Callable[[re.Match[str]], str]], ...] = (
    (r"^(.*energy lost) (in phase [\w-]+) ((?:until|up to) .+)", r"\1 \3 \2"),
    (r"^(?:kinetic )?energy lost (?:in|during|by|at) (?:blow|collision|impact|bounce)$", "energy lost"),
    (r"^(?:heat (?:produced|generated)|(?:mechanical )?energy dissipated|loss of (?:kinetic )?energy)\b", "energy lost"),
    (r"^time of (?:flight|fall|motion)\b", "time"),
    (r"\bhalf (?:of )?(?=[A-Za-z]\w*\b)", "1/2*"),
    (r"\b(functions? of) time\b", r"\1 t"),
    (r"^turning point of (\w+)", r"\1 where \1 comes to rest"),
    (r"\|(.+)\|", r"magnitude of \1"),
    (r"\b(?:undamped )?natural (?:circular |angular )?(?=frequency of \w+)", "undamped "),
    (r"\b(period|frequency|frequencies) of small (?:oscillations?|swings)\b", r"\1"),
    (r"^((?:\w+ )?(?:period|frequency|frequencies)\b.*?),? (?:for|in) small (?:oscillations?|swings)\b", r"\1"),
    (r"\b(?:just|right|shortly|immediately) before (?:it )?(?=\w+ (?:=|reaches) )", "where "),
    (r"\b(until|when|where) (\w+) (?:meets|catches(?: up with)?|overtakes) (\w+)$", r"\1 \2 = \3"),
    (rf"\b({_AT}) (?:angular )?(?:speed|velocity) of (\w+) (=|reaches|is) ", r"\1 \2_dot \3 "),
    (r"(_dot (?:=|reaches|is)) (?:angular )?(?:speed|velocity) of (\w+)$", r"\1 \2_dot"),
    (rf"\b({_AT}) (\w+) - (\w+) (?:=|reaches|is) (.+)", r"\1 \2 = \3 + (\4)"),
    (r"^energy (?=lost (?:until|up to|by|in|during|over|from|between) )", "energy of motion, weights and springs "),
    (r"\b(translational|rotational) (kinetic energy(?: of (?:system|[\w-]+))?)", r"\2, \1"),
    (r"\bafter (?:a )?time (?=\w+$)", "where t = "),
    (r"^change (?:of|in) (.+) (?:until|up to) (.+)", r"\1 from start to \2"),
    (r"^change (?:of|in) (.+) (?:in|during|over) (?:phase )?([\w-]+)$", r"\1 in phase \2 from start to end of phase \2"),
    (r"^change (?:of|in) (.+ (?:from|between) .+)", r"\1"),
    (r"^(.*energy.*) lost (?:in|during|over) (?:phase )?([\w-]+)$", r"minus \1 in phase \2 from start to end of phase \2"),
    (r"^(.*energy.*) lost ((?:from|between) .+)", r"minus \1 \2"),
    (r"^(.*energy.*) lost (?:until|up to|by) ([\w-]+)$", r"minus \1 from start to when \2 begins"),  # in a blow too
    (r"^(.*energy.*) lost (?:until|up to|by) (.+)", r"minus \1 from start to \2"),
    (r"^torque of ([\w-]+)(?= (?:where|when|at|until)\b|$)", r"couple \1"),
    (r"\bangular impulse of (?!.* begins$)", "time integral of torque of "),
    (r"\bimpulse of (?=.* (?:until|up to|during|over|from|between) )", "time integral of "),
    (r"\bhorizontal (?:component|part) of\b", "x component of"),
    (r"\bvertical (?:component|part) of\b", "y component of"),
    (r"\bhorizontal (?=velocity|acceleration|force|net force|linear momentum)", "x component of "),
    (r"\bvertical (?=velocity|acceleration|force|net force|linear momentum)", "y component of "),
    (r"\bof ([\w-]+) about (?:its|the) (?:own )?cent(?:re|er)(?: of mass)?$", r"of \1 about \1.cm"),
    (
        r"\b(from|(?<!relative )to|and|about) (?:its )?(?:common )?cent(?:re|er) of mass(?: of (\w+))?(?=$| )",
        lambda said: f"{said[1]} {said[2] or 'system'}.cm",
    ),
    (r"\bangular speed of\b", "magnitude of angular velocity of"),
    (r"\b(tension|normal force|friction|reaction|force) (?:of|in) (?!phase|equilibrium)(?=\w+\b)", r"\1 "),
    (r"\b(?:magnitude of )?(reaction|normal force|friction) at (?=[A-Z]\w*\b)", r"\1 "),
)
MANNERS = {
    r"(?:for|in) small (?:oscillations|displacements|angles|amplitudes|swings|vibrations)": "small",
    r"(?:for|with|under|if|when) (?:weak damping|underdamped)|(?<!is )(?:if )?underdamped": "weak",
    r"(?:for|with|under) critical damping|(?<!is )(?:(?:if|when) )?critically damped": "critical",
    r"(?:for|with|under) strong damping|(?<!is )(?:if )?overdamped": "strong",
    r"in steady state|at last": "steady",
}
_LONG = r"(\w[\w-]*(?: (?!(?:where|when|at|until|up|from|as|with|for|over|between|during|right|just|is|in|to|and)\b)\w[\w-]*)?)"
PHASE = re.compile(rf"(.+?),? in phase (?:“|\")?{_LONG}(?:”|\")?( .+)?")
SINCE = re.compile(r"(.+?) (?:from|between) (.+?) (?:to|and|until) (.+)")
ASKED = re.compile(r"(?:what|how (?:large|big|great|fast|long)) (?:is|are) |(?:find|determine|give|compute) ", re.I)


def read_question(text: str) -> Question:
    """The question of a text. Raises ReadError for a text that is none."""
    plain = re.sub(r"\s*=\s*", " = ", without_articles(" ".join(text.split()).rstrip(" ?.")))
    if not plain:
        raise ReadError("this is no question: it is empty", instead='write what is asked, such as "N at the start".')
    if len(plain) > LONGEST:
        raise ReadError(f"a question has at most {LONGEST} characters", instead="ask several questions.")
    rest = ASKED.sub("", plain, count=1) if ASKED.match(plain) else plain
    for pattern, written in OTHERWISE:
        rest = re.sub(pattern, written, rest)
    found = Question(plain, rest)
    if is_jump(found.quantity):
        return found
    if match := re.fullmatch(r"(?:direction|angle) of (.+)", found.quantity):
        found = replace(found, quantity=match[1], is_direction=True)
    if phase := PHASE.fullmatch(found.quantity):
        found = replace(found, quantity=phase[1] + (phase[3] or ""), phase=phase[2])
    if since := SINCE.fullmatch(found.quantity):
        begin, end = _end(since[2], BEGINS), _end(since[3], ENDS)
        if begin is not None and end is not None:
            return replace(found, quantity=since[1], since=begin, when=end)
    for pattern, manner in (*MANNERS.items(), *MANNERS.items()):  # one may stand behind another
        if way := re.search(rf",? ({pattern})(?=$|,| (?:as|where|when) )", found.quantity):
            found = replace(found, quantity=found.quantity[: way.start()] + found.quantity[way.end() :])
            found = replace(found, manner=f"{found.manner} {manner}".strip())
    while clause := _clause(found.quantity):
        quantity, kind, words, said = clause
        if kind == "of" and not found.of:
            found = replace(found, quantity=quantity, of=words[0] if "speed" not in words[0] else "state")
        elif kind != "of" and found.when is None:
            found = replace(found, quantity=quantity, when=When(kind, words, said))
        else:
            raise ReadError(f"“{plain}” says twice when, where or of what", instead="ask two questions.")
    return found


def is_jump(quantity: str) -> bool:
    """Is it what happens at the beginning of a phase: an impulse, a loss of energy?"""
    return any(re.fullmatch(pattern, quantity) for pattern, *_ in JUMPS)


BEGINS, ENDS = "right after ", "until "


def _end(text: str, phase: str) -> When | None:
    """One of two moments: “the start” or “theta = 0”; the name of a phase is its beginning, after its blows or before them."""
    for lead in ("", "at ", "where ", phase):
        if (found := _clause(f"x {lead}{text}")) and found[0] == "x":
            return When(*found[1:])
    return None


def _clause(text: str) -> tuple[str, str, tuple[str, ...], str] | None:
    """(what is before it, its kind, its words, as it is written) of the clause at the end of a text."""
    for kind, pattern, _ in CLAUSES:
        if found := re.fullmatch(rf"(?P<before>.+),? (?P<said>{pattern})", text):
            words = tuple(word for word in found.groups()[2:] if word)
            return found["before"].rstrip(","), kind, words, found["said"]
    return None
