"""What is wanted of a motion in questions about parameters, as values that have to be positive, or zero.

“theta reaches pi/2”, “it does not slip”, “N stays positive until theta = pi”, “theta = 0 is stable”, “N_f vanishes”,
“speed of x >= v_1”. A new condition is a new row of WANTED.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress

from rbpsym.ask.asked import NoClosedForm, bearable, left_open
from rbpsym.ask.finding import needed
from rbpsym.ask.made import value_of
from rbpsym.ask.question import is_jump
from rbpsym.ask.seen import PLACE, AskedPhase, going_on, moving, place_in, require_same, seen, way_to, ways_to
from rbpsym.ask.wanted import Wanted, free_place, on_way
from rbpsym.ask.zeros import where_met
from rbpsym.chapters import oscillations
from rbpsym.decide.rooted import rooted, sign_along
from rbpsym.decide.signs import sign
from rbpsym.errors import DimensionError, NotApplicable, RbpsymError, StatementError, Undecided, there
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar, derivative, is_zero, lift, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.events import Way, pushes
from rbpsym.mechanics.friction import spare
from rbpsym.mechanics.impulse import is_holding
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Step
from rbpsym.statement.source import did_you_mean


def wanted(world: AskedPhase, text: str, name: str = "") -> Wanted:
    """What a condition asks for; `name`: of which symbol. Raises StatementError for one that means nothing here."""
    for pattern, find in WANTED:
        if found := re.fullmatch(pattern, text):
            return find(world, *found.groups(), *((name,) if find in OF_FRICTION else ()))
    return _compared(world, text)


def _reaches(world: AskedPhase, name: str, text: str) -> Wanted:
    """Up to the place the speed does not vanish, and nothing lets go or slips."""
    name, end = free_place(world, name, text)
    way, given = way_to(world, name, end, world.motion.assumptions)
    _check_phase(world, way, end)
    others = len(ways_to(world, name, end, world.motion.assumptions)) > 1
    return Wanted(going_on(world, way, given), given, name, end=end, asked=way.asked, others=others)


def _check_phase(world: AskedPhase, way: Way, end: Scalar) -> None:
    """Raise StatementError where it is not sure that the phase still goes on there, and none is named."""
    if world.is_named or world.number + 1 == len(world.asked.names):
        return
    after = world.asked.names[world.number + 1]
    with suppress(NotApplicable):
        last = world.asked.began(world.number + 1).before.places[way.name]
        if settle([Demand((end - last) * way.sense)], world.motion.assumptions) is None:
            return
    what = f"whether this is before the phase “{after}” begins depends on the parameters, or is not known"
    raise StatementError(what, instead=f"ask it in one phase: “… in phase first”, “… in phase {after}”.")


def _stays(world: AskedPhase, phrase: str, sign: str, until: str | None, text: str | None) -> Wanted:
    """A quantity has one sign on the way."""
    value = seen(world, phrase) * (-1 if sign == "negative" else 1)
    return on_way(world, (value,), phrase, until, text, world.motion.assumptions)


def _beyond(world: AskedPhase, phrase: str, side: str, value: str, until: str | None, text: str | None) -> Wanted:
    """A quantity stays on one side of a value on the way; of a coordinate, see `critical.NEVER`."""
    gap = _equal(world, phrase, value).values[0] * (1 if side == "above" else -1)
    return on_way(world, (gap,), phrase, until, text, world.motion.assumptions)


def _holds_fast(world: AskedPhase, contact: str, until: str | None, text: str | None, name: str = "", then: str = "") -> Wanted:
    """Static friction stays below its limit, at one contact or at all (“it”), on the way or at one moment (`then`)."""
    needs = {need.constraint: need for need in world.study.friction_needs}
    found = None if then else _held_then(world, contact, None)
    if found and contact not in needs and (contact != "it" or not needs):
        return found
    if not needs:
        what = "no contact is held by static friction here"
        raise StatementError(what, instead='what sticks or rolls is type = "sticking" or "rolling", with a limit = "mu".')
    if contact not in ("it", "nothing", *needs):
        raise StatementError(f"static friction does not hold “{contact}”", instead=did_you_mean(contact, needs, "such contacts"))
    held, given = [need for place, need in needs.items() if contact in ("it", "nothing", place)], world.motion.assumptions
    without, held = held[0].constraint, [need for need in held if need.limit is not None]  # the others hold as much as is needed
    if not held:
        what = f"the contact “{without}” has no coefficient of static friction"
        raise StatementError(what, instead=f'ask for “mu for which …”, or write limit = "mu" in [constraints.{without}].')
    if left_open(world.study) and not then:
        values, given, asked = bearable(world.study, held, given, name)
        return Wanted(values, given, asked=asked)

    def here(force: str) -> Scalar:
        return seen(world, force + then)

    forces = [(sum(map(here, need.normals), NOTHING) * there(need.limit), here(need.friction)) for need in held]
    values = tuple(most + friction * side for most, friction in forces for side in (-1, 1))
    found = on_way(world, values, "the friction that is needed", until, text, given)
    normal = {need.constraint for need in held if len(need.normals) == 1}
    others = [here(name) for e in world.study.problem.constraints for name in pushes(e) if name not in normal]
    beside = tuple(value for value in others if sign(value, found.given).kind != "positive")
    return replace(found, beside=beside, there="there a contact is lost")


def _holds_there(world: AskedPhase, contact: str, there: str, name: str = "") -> Wanted:
    return _holds_fast(world, contact, None, None, name, there)


def _held_then(world: AskedPhase, contact: str, phase: str | None) -> Wanted | None:
    """The impulse of friction stays below its limit in a blow (when a phase begins); None where friction holds in none."""
    values = list[Scalar]()
    for number in range(1, len(world.asked.names)):
        began = world.asked.began(number)
        for element in (*began.phase.impulses, *began.phase.problem.constraints):
            limit = element.values.get("coefficient" if is_holding(element) else "limit")
            is_meant = contact in ("it", "nothing", element.name) and phase in (None, began.phase.name)
            if is_meant and element.values.get("friction") in began.impulses and limit is not None:
                names = (element.name, element["friction"])
                most, grip = (seen(world, f"impulse of {n} when {began.phase.name} begins") for n in names)
                values += [most * scalar(limit) + grip * side for side in (-1, 1)]
    return Wanted(tuple(values), world.motion.assumptions) if values else None


def _holds_then(world: AskedPhase, contact: str, phase: str) -> Wanted:
    found = _held_then(world, contact, phase)
    if found is None:
        raise StatementError(
            f"friction holds nothing when “{phase}” begins", instead='what does not slip there is a bounce with slip = "none".'
        )
    return found


def _touches(world: AskedPhase, until: str | None = None, text: str | None = None) -> Wanted:
    """All one-sided forces stay positive; beside that, what sticks or rolls does not slip before."""
    constraints = world.study.problem.constraints
    names = [name for element in constraints for name in pushes(element)]
    if not names:
        raise StatementError("no contact or string of the problem can let go")
    values, given = tuple(seen(world, name) for name in names), world.motion.assumptions
    found = on_way(world, values, " and ".join(names), until, text, given)
    grips = [left for element in constraints for left in spare(element, lambda name: seen(world, name))]
    beside = tuple(value for value in grips if sign(value, found.given).kind != "positive")
    return replace(found, beside=beside, there="there it slips")


def _stays_put(world: AskedPhase, name: str = "") -> Wanted:
    """Neither static friction gives way nor a contact."""
    lets_go = any(pushes(element) for element in world.study.problem.constraints)
    if not world.study.friction_needs and lets_go:
        return _touches(world)
    held = _holds_fast(world, "it", None, None, name)
    if left_open(world.study):
        return held
    return replace(held, values=(*held.values, *(_touches(world).values if lets_go else ())), beside=())


def _at_rest(world: AskedPhase, name: str = "") -> Wanted:
    """The same of what nothing but friction and contacts lets move."""
    if world.study.system.independent:
        raise StatementError(
            "whether what can move stays at rest is not decided by its contacts",
            instead="ask “… for which x stays constant”, or state it without coordinates, held by what sticks.",
        )
    return _stays_put(world, name)


OF_FRICTION = (_holds_fast, _holds_there, _stays_put, _at_rest)


def rest_at(world: AskedPhase, name: str, text: str | None) -> tuple[int, Equilibrium]:
    """The place of rest there, or the only one, and its number, from 1. Raises StatementError if there is none."""
    found = [(number, item) for number, item in enumerate(world.study.equilibria, 1) if name in item.at]
    if text is not None:
        found = [pair for pair in found if is_zero(pair[1].at[name] - place_in(world, name, text))]
    if not found or (text is None and len(found) > 1):
        what = f"{name} = {text} is no place of rest" if text else f"“{name}” has {len(found) or 'no known'} places of rest"
        raise StatementError(what, instead=f"ask for the “equilibrium of {name}”.")
    return found[0]


def _stable(world: AskedPhase, name: str, text: str | None, opposite: str | None) -> Wanted:
    """What is positive where a place of rest is stable."""
    place, item = rest_at(world, name, text)
    where = item.where if item.stable is None else lift(1 if item.stable else -1)
    if where is None:
        raise StatementError(f"whether {name} = {text or 'the equilibrium'} is stable is not decided by one condition")
    given = where_met(world.motion.assumptions, item.valid)
    steps = of_chapter(world, oscillations.write, f"equilibrium.{place}") if item.stable is not None else ()
    return Wanted((-where if opposite else where,), given, closed=False, asked=item.valid, steps=steps)


def of_chapter(world: AskedPhase, write: Callable[[Draft], None], id: str) -> tuple[Step, ...]:
    """The step of a chapter that says so, behind those from which it follows."""
    draft = Draft(world.study)
    write(draft)
    return needed(draft.steps, id)


def _damped(world: AskedPhase, name: str, kind: str) -> Wanted:
    """Whether what is left to itself swings: γ² against ϑ², of small oscillations or of a linear motion that is driven."""
    try:
        decay, square = seen(world, f"decay rate of {name}"), seen(world, f"undamped frequency of {name}") ** 2
    except StatementError:
        gained = seen(world, f"acceleration of {name} as a function of the state")
        decay, square = -derivative(gained, f"{name}_dot") / 2, -derivative(gained, name)
    if moving(world, (decay, square)):
        raise StatementError(f"the motion of “{name}” is not that of one mode")
    way = -1 if kind == "underdamped" else 1
    is_equal = kind == "critically damped"
    gap = rooted(decay * decay - square, world.motion.assumptions)
    return Wanted((gap * way,), world.motion.assumptions, equal=is_equal, closed=False)


def _rests_at(world: AskedPhase, name: str, place: str) -> Wanted:
    """It comes to rest at a place: where that is known, else its speed vanishes there, and not before if it is real there."""
    with suppress(NoClosedForm):
        return _equal(world, f"{name} where {name} comes to rest", place)
    end, given = place_in(world, name, place), world.motion.assumptions
    if name not in world.study.squares:
        return _equal(world, f"speed of {name} where {name} = {place}", "0")
    way, within = way_to(world, name, end, given)
    _check_phase(world, way, end)
    *others, square = going_on(world, way, within)
    last = rooted(substitute(square, {name: end}), given)
    if others or sign_along(square, name, within, lambda value: is_zero(value - last)) <= 0:
        raise Undecided(f"whether “{name}” comes so far without a halt is not decided")
    return Wanted((last,), given, equal=True, asked=way.asked)


def _equilibrium(world: AskedPhase, name: str, text: str) -> Wanted:
    """At rest at a place, it stays there."""
    value, study = place_in(world, name, text), world.study
    gained = seen(world, f"acceleration of {name} as a function of the state")
    still = dict.fromkeys(study.system.speeds, NOTHING)
    return Wanted((substitute(gained, {**still, name: value}),), world.motion.assumptions, equal=True)


def _lets_go(world: AskedPhase, contact: str) -> Wanted:
    """The force of a contact vanishes."""
    if contact not in world.study.system.unknowns:
        raise StatementError(f"“{contact}” is no contact", instead="write “N vanishes” with the name of one.")
    return _equal(world, contact, "0")


def _equal(world: AskedPhase, left: str, right: str) -> Wanted:
    first, second = (value_of(world, side, of_vectors=True) for side in (left, right))
    require_same(world, first, second, (left, right))
    return Wanted((first - second,), world.motion.assumptions, equal=True)


SIGNS = {">=": (1, True), ">": (1, False), "<=": (-1, True), "<": (-1, False)}
RELATION = re.compile(
    r" (=|[><]=?|equals|exceeds|is (?:at (?:least|most)|(?:less|greater|more) than)|"
    r"is(?= -?[(\d]| \w+[*/]| [A-Za-z]\w?\w?(?:_\w+)?$)) "
)
WORDS = {"equals": "=", "is": "=", "is at least": ">=", "is at most": "<=", "is less than": "<"}
WORDS |= dict.fromkeys(("exceeds", "is greater than", "is more than"), ">")


def _sides(world: AskedPhase, left: str, right: str) -> Iterator[tuple[str, str]]:
    """The ways to read the two sides, the likeliest first: a place that follows a formula is that of the first side; one that
    follows a quantity is that of both, unless the first has its own or it is a moment of the second alone (“at the start”)."""
    place = PLACE.fullmatch(right)
    if place and _is_formula(world, place[1]):
        yield left + place[2], place[1]
    elif place and place[2].startswith((" where", " when", " once")) and not PLACE.fullmatch(left) and not is_jump(left):
        yield left + place[2], right
    yield left, right


def _is_formula(world: AskedPhase, text: str) -> bool:
    with suppress(RbpsymError):
        return t.names(read_infix(text, world.names)) <= {*world.study.problem.dimensions, "pi"}
    return False


def _compared(world: AskedPhase, text: str) -> Wanted:
    """Two quantities with a relation between; a place may follow the second: “N = m*g where theta = 0”."""
    refused: list[RbpsymError] = []
    for cut in RELATION.finditer(text):
        left, op, right = text[: cut.start()], WORDS.get(cut[1], cut[1]), text[cut.end() :]
        for first, second in _sides(world, left, right):
            try:
                both = _equal(world, first, second)
            except RbpsymError as error:
                refused.append(error)
                continue
            if op == "=":
                return both
            side, closed = SIGNS[op]
            return Wanted(tuple(value * side for value in both.values), both.given, closed=closed)
    if refused:
        raise next((error for error in refused if isinstance(error, DimensionError)), refused[0])
    raise StatementError(
        f"“{text}” is no condition",
        instead="write “N vanishes”, “theta reaches pi/2”, “it does not slip”, “theta = 0 is stable”, “QUANTITY >= VALUE”.",
    )


_N, _UNTIL = r"([\w.]+)", r"(?:,? (?:until|before|up to) (\w+) (?:=|reaches|is) (.+))?"
WANTED: tuple[tuple[str, Callable[..., Wanted]], ...] = (
    (rf"{_N} (?:comes|is brought) to rest (?:at|where|when|after) (?:\w+ = )?(.+)", _rests_at),
    (rf"{_N} where \1 comes to rest = (.+)", _rests_at),
    (rf"{_N} (?:just )?reach(?:es)? (.+)", _reaches),
    (rf"{_N} (?:gets|comes) to (.+)", _reaches),
    (rf"{_N} (?:does not|never) (?:begin to |start to )?slips?{_UNTIL}", _holds_fast),
    (rf"{_N} (?:does not|never) (?:begin to |start to )?slips? when ([\w-]+) begins", _holds_then),
    (rf"{_N} (?:does not|never) (?:begin to |start to )?slips?"
     r"( (?:at|where|when|right|just) .+| in (?:un)?(?:stable )?equilibrium)", _holds_there),
    (rf"{_N} (?:holds|sticks|rolls without slipping){_UNTIL}", _holds_fast),
    (rf"\w+ (?:does not|never) (?:leave|lift|let go|lose contact|tip)s?(?: off| over| [\w-]+)??{_UNTIL}", _touches),
    (rf"\w+ (?:stays|keeps|remains)(?: in)? (?:contact|on \w+){_UNTIL}", _touches),
    (r"\w+ (?:neither slips nor tips|neither tips nor slips)", _stays_put),
    (r"\w+ (?:(?:stays|remains|is) (?:at rest|in equilibrium)|does not move)", _at_rest),
    (rf"(.+?) (?:stays|remains|is always) (positive|negative){_UNTIL}", _stays),
    (rf"(.+?) is (positive|negative){_UNTIL}", lambda world, *words: replace(_stays(world, *words), closed=False)),
    (rf"(.+?) (?:stays|remains|is(?: always)?) (below|above) (.+?){_UNTIL}", _beyond),
    (rf"(.+?) (?:does not|never) vanish(?:es)?{_UNTIL}", lambda w, phrase, *to: _stays(w, phrase, "positive", *to)),
    (rf"{_N} = (.+) is (un)?stable", _stable),
    (rf"equilibrium of {_N} is (un)?stable", lambda world, name, opposite: _stable(world, name, None, opposite)),
    (rf"{_N} = (.+) is (?:an equilibrium|in equilibrium|a place of rest)", _equilibrium),
    (rf"{_N} is (critically damped|overdamped|underdamped)", _damped),
    (r"(\w+) (?:leaves|lifts|loses contact)(?: off)?(?: (?:with )?\w+)?", _lets_go),
    (r"(.+?) (?:just )?(?:vanish(?:es)?|is zero|goes to zero)((?: (?:where|when|at|just) .+)?)",
     lambda w, phrase, at: _equal(w, phrase + (at or ""), "0")),
)
