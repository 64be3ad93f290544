"""When and where of a question: the state of the motion at a moment, and the ending that leads there.

A place that the motion comes to is found as the end of a phase is (`mechanics.endings`), with the conditions under which
it comes there; a new kind of moment is a new entry of MOMENTS.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.ask import in_time
from rbpsym.ask.asked import Asked, Moment, NoClosedForm, NotMet
from rbpsym.ask.lasting import clear, coming, in_phase
from rbpsym.ask.question import Question, When
from rbpsym.decide.dimensions import require_dimension
from rbpsym.decide.rooted import neat
from rbpsym.elements.events import EVENTS
from rbpsym.errors import NotApplicable, RbpsymError, StatementError, there
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import ZERO, Node
from rbpsym.field import NOTHING, depends_on, is_zero, names_in
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics.arrivals import ArrivalState, at_start, mover
from rbpsym.mechanics.demands import assuming
from rbpsym.mechanics.endings import LAWS, UNKNOWN, is_before
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.orbit import orbits
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.statement.model import Phase
from rbpsym.statement.source import did_you_mean
from rbpsym.typeset.machine import to_machine


def moment_of(asked: Asked, when: When, question: Question) -> Moment:
    """The moment that the words mean. Raises StatementError where the motion never comes there."""
    place = asked.named(question.phase) if question.phase else None
    if when.kind == "rests" and when.words:
        when = replace(when, words=(coordinate_of(asked, when.words[0]),))
    if question.manner and when.kind in ("reaches", "rests"):
        if found := in_time.by_time(asked, when, place, question.manner):
            return found
        raise NoClosedForm(f"no closed form was found for the moment “{when.text}” in this case", instead=BY_NUMBERS)
    try:
        found, refused = MOMENTS[when.kind](asked, when, place), None
    except StatementError as error:
        found, refused = None, error
    if (end := found and found.phase) and when.kind == "until" and found.state.time is None:
        when = _as_place(asked, found, end, when)
    is_part = found is None or (found.state.time is None if "time" in question.quantity else _is_open(asked, found))
    if when.kind in ("reaches", "rests", "vanishes") and is_part:
        ahead = range(asked.lasting, len(asked.names))
        places = [place] if place is not None else [found.place] if found else ahead
        found = next((moment for each in places if (moment := in_time.by_time(asked, when, each))), found)
    if found is None:
        raise there(refused)
    return in_phase(asked, found)


def _as_place(asked: Asked, found: Moment, end: Phase, when: When) -> When:
    """The moment at which a phase ends by the place of the coordinate that comes there, which the time may tell."""
    if end.event in ("reaches", "rests"):
        return When(end.event, (end.subject, to_machine(end.value or ZERO)), when.text)
    name = mover(asked.study(found.place))
    return When("reaches", (name, to_machine(present(found.state.places[name]))), when.text) if name else when


def _is_open(asked: Asked, found: Moment) -> bool:
    """Whether the place or the speed of a coordinate is not known there."""
    moving = {*asked.study(found.place).system.coordinates, *asked.study(found.place).system.speeds}
    return any(names_in(value) & moving for value in (*found.state.places.values(), *found.state.speeds.values()))


def _begins(asked: Asked, when: When, place: int | None) -> Moment:
    place = asked.named(when.words[0])
    return Moment(place, at_start(asked.study(place)))


def _ends(asked: Asked, when: When, place: int | None) -> Moment:
    """The end of a phase: the beginning of the next, before its blows."""
    return _before(asked, asked.named(when.words[0]) + 1)


def _before(asked: Asked, place: int) -> Moment:
    if not 0 < place < len(asked.names):
        known = ", ".join(asked.names[1:])
        told = f"after it a phase must begin; those that begin are: {known}." if known else "the problem has no [[phases]]."
        raise StatementError("nothing ends this phase", instead=told)
    phase, before = asked.problem.phases[place - 1], asked.began(place).before
    return Moment(place - 1, before) if phase.event == "at once" else Moment(place - 1, before, "event", phase)


def _ahead(asked: Asked, event: str, subject: str, place: int | None, value: Node | None = None) -> Moment:
    """The first phase in which the motion comes to an event before that phase ends."""
    refused: RbpsymError | None = None
    for number in [place] if place is not None else range(asked.lasting, len(asked.names)):
        try:
            study = asked.study(number)
            phase = Phase("", event, subject, (), study.problem, value)
            state = LAWS[event].ends(study, phase)
        except (NotApplicable, StatementError) as error:
            refused = refused or error
            if isinstance(error, NotApplicable) and event == "reaches" and subject == mover(study):
                begun = at_start(study)
                if is_zero(begun.places[subject] - scalar(there(value))) and begun.speeds.get(subject):
                    return Moment(number, begun)
                state, is_sure = coming(study, subject, scalar(there(value)))
                return Moment(number, state, "event", phase if is_sure else None, is_open=not is_sure)
            continue
        except ZeroDivisionError:
            refused = refused or StatementError("a speed has no value there: something is divided by zero")
            continue
        if number + 1 < len(asked.names) and place is None and not _comes_before(asked, number, state):
            continue
        if _is_begun(study, state):
            return Moment(number, at_start(study))
        state = clear(study, state)
        given = assuming(study.assumptions, state.valid)  # the sense in which it came tells that of its start
        state = replace(state, speeds={name: neat(speed, given) for name, speed in state.speeds.items()})
        return Moment(number, state, "event", phase)
    study = asked.study(asked.meant(place))
    is_sure = not isinstance(refused, NotApplicable) or mover(study) == subject  # else it may come there again
    if event == "reaches" and is_sure and is_zero(at_start(study).places[subject] - scalar(there(value))):
        return Moment(asked.meant(place), at_start(study))
    raise _told(refused, event, subject)


def _comes_before(asked: Asked, number: int, state: ArrivalState) -> bool:
    """Whether a state comes before the end of its phase, at the sample numbers."""
    try:
        return is_before(asked.study(number), state, asked.began(number + 1).before)
    except NotApplicable:
        return True


def _is_begun(study: Study, state: ArrivalState) -> bool:
    if state.time is not None:
        return state.time == NOTHING
    begun = at_start(study).places
    return all(is_zero(place - begun[name]) for name, place in state.places.items())


def _told(error: RbpsymError | None, event: str, subject: str) -> RbpsymError:
    """The reason why a moment is not found, without the name of a phase."""
    if isinstance(error, NotApplicable):
        return NoClosedForm(error.what, instead=BY_NUMBERS)
    if error is not None and "the phase “”" in error.what:
        what = EVENTS[event].fails
        if UNKNOWN in error.what:
            return NotMet(f"“{subject}” {what} in this motion at any of the numbers that were tried", instead=error.instead)
        return StatementError(f"“{subject}” {what} in this motion, as far as is known", instead=error.instead)
    return error or StatementError("this moment is not known")


def _vanishes(asked: Asked, when: When, place: int | None) -> Moment:
    name = when.words[0]
    if name in asked.study(asked.meant(place)).system.unknowns and not _lets_go(asked, name):
        return _ahead(asked, "takes", name, place, ZERO)
    return _ahead(asked, "lost", _subject(asked, name, "force"), place)


def _lets_go(asked: Asked, name: str) -> bool:
    """Whether a constraint of that name holds to one side only."""
    problems = (asked.problem, *(phase.problem for phase in asked.problem.phases))
    return any(name in pushes(element) for each in problems for element in each.constraints)


def _rests(asked: Asked, when: When, place: int | None) -> Moment:
    names = asked.study(asked.meant(place)).system.independent
    if not when.words and len(names) != 1:
        said = f"write “at the turning point of {names[0]}”." if names else "nothing can move."
        raise StatementError("which coordinate turns round?", instead=said)
    name = when.words[0] if when.words else names[0]
    return _ahead(asked, "rests", name, place)


def _of_contact(event: str) -> Callable[[Asked, When, int | None], Moment]:
    return lambda asked, when, place: _ahead(asked, event, _subject(asked, _meant(asked, when), "contact"), place)


def _meant(asked: Asked, when: When) -> str:
    """The contact that is named, or the only one that static friction with a limit holds, or which slips (“it”, “the ball”)."""
    key = "coefficient" if when.kind == "grips" else "limit"
    held = [element.name for element in asked.problem.constraints if element.values.get(key) is not None]
    said = when.words[0] if when.words else "it"
    return held[0] if len(held) == 1 and said in ("it", *asked.problem.body_names) else said


def _begun_before(asked: Asked, when: When, place: int | None) -> Moment:
    return _before(asked, asked.named(when.words[0]))


def _subject(asked: Asked, name: str, what: str) -> str:
    if name not in asked.held:
        hint = did_you_mean(name, asked.held, f"{what}s")
        raise StatementError(f"there is no {what} “{name}” that a constraint holds", instead=hint)
    return name


def coordinate_of(asked: Asked, name: str) -> str:
    """A coordinate by its name, or by that of the body that it alone moves. Raises StatementError."""
    known = [c.name for c in asked.problem.coordinates]
    for place in range(asked.lasting, len(asked.names)) if name not in known and name in asked.problem.body_names else ():
        system = asked.study(place).system
        body = system.bodies[name]
        rates = (body.velocity.x, body.velocity.y, body.omega)
        alone = [n for n in system.independent if any(depends_on(rate, f"{n}_dot") for rate in rates)]
        if alone:
            name = alone[0] if len(alone) == 1 else name  # the one coordinate that moves it
            break
    if name not in known:
        raise StatementError(f"“{name}” is no coordinate", instead=did_you_mean(name, known, "coordinates"))
    return name


def _reaches(asked: Asked, when: When, place: int | None) -> Moment:
    name, text = when.words
    if name.endswith("_dot") and text == "0":
        return _ahead(asked, "rests", coordinate_of(asked, name.removesuffix("_dot")), place)
    if text == "0" and name in asked.held:
        return _vanishes(asked, When("vanishes", (name,)), place)
    world = asked.world(asked.meant(place))
    node = read_infix(text, world.names)
    if name == "t":
        return in_time.at_time(asked, asked.meant(place), in_time.instant(world, text))
    if name in asked.study(asked.meant(place)).system.unknowns:
        require_dimension(node, world.dimensions, world.dimensions[name], f"what “{name}” reaches")
        return _ahead(asked, "takes", name, place, node)
    coordinate = coordinate_of(asked, name.removesuffix("_dot"))
    require_dimension(node, world.dimensions, world.dimensions[name], f"what “{name}” reaches")
    if coordinate != name or names_in(scalar(node)) & {*world.motion.scope.rates, *world.study.system.dependent}:
        raise NoClosedForm(f"no closed form was found for the moment at which “{name}” has this value", instead=BY_NUMBERS)
    return _ahead(asked, "reaches", name, place, node)


def _in_rest(stable: bool) -> Callable[[Asked, When, int | None], Moment]:
    def find(asked: Asked, when: When, place: int | None) -> Moment:
        first, last = asked.meant(place), len(asked.names) if place is None else asked.meant(place) + 1
        at = ((k, [e for e in asked.study(k).equilibria if bool(e.stable) is stable or (stable and e.stable is None)])
              for k in range(first, last))  # fmt: skip
        number, found = next((one for one in at if one[1]), (first, []))
        study = asked.study(number)
        if not found and stable:
            return _steady(study, number)
        if not found:
            raise StatementError("no unstable equilibrium is known")
        if len(found) > 1:
            raise StatementError(f"there are {len(found)} such equilibria", instead='write “where theta = …”.')
        still = dict.fromkeys(study.system.independent, NOTHING)
        return Moment(number, ArrivalState(None, dict(found[0].at), still, found[0].valid), "rest")

    return find


def _steady(study: Study, place: int) -> Moment:
    """Where coordinates stay while others go on. Raises StatementError where no such motion, or more than one, is known."""
    names = () if study.at_start or study.system.has_clock else study.system.independent
    known = {name: orbits(study, name) for name in names}
    there = {name: found[0] for name, found in known.items() if len(found) == 1}
    if not there:
        raise StatementError("no stable equilibrium is known")
    valid = tuple(demand for one in there.values() for demand in one.valid)
    state = ArrivalState(None, {name: one.place for name, one in there.items()}, dict.fromkeys(there, NOTHING), valid)
    return Moment(place, state, "rest")


BY_NUMBERS = "ask for it with numbers: --with “M = 1 kg, …”."
MOMENTS: Mapping[str, Callable[[Asked, When, int | None], Moment]] = {
    "start": lambda asked, when, place: Moment(place or 0, at_start(asked.study(place or 0))),
    "begins": _begins,
    "before": _begun_before,
    "end": _ends,
    "over": _ends,
    "until": _begun_before,
    "vanishes": _vanishes,
    "rests": _rests,
    "grips": _of_contact("no slip"),
    "slips": _of_contact("slips"),
    "reaches": _reaches,
    "rest": _in_rest(True),
    "unstable": _in_rest(False),
}
