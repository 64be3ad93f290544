"""The answer to a question about a quantity: its exact value, and the steps from which it follows."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress

from rbpsym.ask.asked import Asked, Moment, NoClosedForm, left_open
from rbpsym.ask.certified import LETTER, certified
from rbpsym.ask.found import Answer, Found, sense_at_sample, sense_stated, shortest
from rbpsym.ask.in_time import at_time, time_of_swing
from rbpsym.ask.moments import BY_NUMBERS, moment_of
from rbpsym.ask.question import Question, When, is_jump
from rbpsym.ask.senses import moving_in, of_one, resisted_in
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.signs import sign
from rbpsym.errors import Ambiguous, NotApplicable, RbpsymError, ReadError, StatementError, Undecided
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, names_in, root, short, substitute, symbol, time_derivative
from rbpsym.field.exponentials import with_squares
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import replace
from rbpsym.mechanics.arrivals import inward
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.energy import rotational_energy, translational_energy
from rbpsym.mechanics.led import put
from rbpsym.mechanics.solutions import SMALL
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.unsolvable import untold
from rbpsym.quantity.bound import Bound, parts, plane
from rbpsym.quantity.path import even, first_push, gathered, sense, work_by_energy, work_done
from rbpsym.quantity.problem import ProblemWorld


def answer(asked: Asked, question: Question, letter: str = LETTER) -> Answer:
    """The answer about a quantity, called by the letter.

    Raises StatementError for what means nothing, never happens or has no closed form.
    """
    if question.quantity in {quantity.name for quantity in asked.problem.parameters}:
        what = f"“{question.quantity}” is a parameter: it has the value that it is given"
        raise StatementError(what, instead=f"ask for which value something is so: “{question.quantity} for which …”.")
    made = certified(asked, question, found_of(asked, question), letter)
    if made.verdict.is_refuted:
        raise Undecided(f"what was found for “{question.text}” is refuted by its own check, and is not told")
    return made


def found_of(asked: Asked, question: Question) -> Found:
    """What is found for a quantity, not certified yet. Raises StatementError as `answer` does."""
    if question.quantity == "time":
        since = question.since
        if since is None and question.when and question.phase and asked.named(question.phase):  # as a work, from its beginning
            since = When("begins", (question.phase,), f"when {question.phase} begins")
        ends = (question.when, since) if since else (question.when,)
        return _since(*(_time(asked, replace(question, when=end)) for end in ends))
    found = _along(asked, question) if question.when is None else _then(asked, question, question.when)
    if any(names_in(value) & left_open(found.study) for value in found.values):
        study_of(asked.problem).dynamics  # noqa: B018  (which says what is not told apart)
    return found


def _bound(asked: Asked, question: Question, place: int | None) -> tuple[int, Bound]:
    """The phase in which the quantity is known, and what it is there."""
    if question.manner == SMALL and not question.of and question.when is None:
        return _bound(asked, replace(question, quantity=f"{question.quantity} {SMALL}", manner=""), place)
    if is_jump(question.quantity):
        return 0, asked.whole.bound(question.quantity)
    if place is None and question.phase:
        place = asked.named(question.phase)
    if place is not None:
        return place, _meant(asked.world(place), question)
    refused = dict[int, RbpsymError]()
    for each in (*range(asked.lasting, len(asked.names)), *range(asked.lasting)):
        try:
            world = asked.world(each)
        except RbpsymError as error:  # what a phase that cannot be worked out would say, no other one says for it
            raise (error if each < asked.lasting else next(iter(refused.values()), error)) from None
        try:
            return each, _meant(world, question)
        except RbpsymError as error:
            if type(error) is Ambiguous:  # it is so in whatever phase
                raise
            refused[each] = error
    raise refused[0]


OF_BODY = re.compile(r"(?:magnitude of )?(speed|velocity|acceleration) of (\w+)")


def _meant(world: ProblemWorld, question: Question) -> Bound:
    """What the words mean; the direction of a force is that of its vector, where its name alone is its magnitude."""
    found = world.bound(question.quantity)
    said = OF_BODY.fullmatch(question.quantity)
    if said and not any(parts(found)) and said[2] in world.study.system.bodies and world.body(said[2]).omega:
        what = f"the centre of “{said[2]}” stays where it is, so that “{question.quantity}” may mean its turning"
        raise Ambiguous(what, instead=f"ask for the angular {said[1]} of {said[2]}, or for the {said[1]} of {said[2]}.cm.")
    with suppress(ReadError):  # a formula in the names of the problem
        dimension_of(read_infix(question.quantity, world.names), world.dimensions)
    return plane(world.vector(question.quantity)) if question.is_direction and len(parts(found)) == 1 else found


def _unsolved(study: Study, name: str) -> StatementError:
    """Why nothing is known of an acceleration or an unknown force."""
    if study.problem.unstated:
        return untold(study.system, name)
    return NoClosedForm(f"no closed form was found for {name}", instead=BY_NUMBERS)


Works = Mapping[str, tuple[Scalar, Scalar]]


def _works(world: ProblemWorld, values: tuple[Scalar, ...]) -> Works:
    """(rate, value) of each work in the values. Raises StatementError for a work that has no closed form."""
    found = {}
    for name, power in world.motion.ledger.items():
        if any(depends_on(value, name) for value in values):
            ways = (find(power, world.motion) for find in (work_done, work_by_energy, gathered))
            done = next((one for one in ways if one is not None), None) or _of_body(world, power)
            if done is None:
                raise NoClosedForm("no closed form was found for a work in this", instead="ask for its power, or with numbers.")
            found[name] = (power, done)
    return found


def _of_body(world: ProblemWorld, power: Scalar) -> Scalar | None:
    """∫ power dt as what it gives to the kinetic energy of a body, or of all, and to what acts beside it; None where it is none
    of this."""
    energies = [translational_energy(state) + rotational_energy(state) for state in world.bodies("system")]
    for energy in (*energies, sum(energies, NOTHING)):
        rest = short(world.motion.moved(power - time_derivative(energy, world.motion.scope)))
        beside = NOTHING if is_zero(rest) else work_done(rest, world.motion)
        if energy and beside is not None:
            return energy - substitute(energy, world.motion.scope.start) + beside
    return None


def _then(asked: Asked, question: Question, when: When) -> Found:
    """The value at a moment; what is counted since another moment, from there."""
    if question.of:
        raise StatementError("what is asked at one moment is no function", instead="leave out “as a function of …”.")
    place, _ = _bound(asked, question, None)  # an unknown word is told before a moment is looked for
    if said := FRICTION.fullmatch(question.quantity):  # of the forces: along the motion it holds its speeds already
        need = next(one for one in asked.study(place).friction_needs if one.constraint == said[2])
        what = "" if said[1] == "ratio" else "magnitude of "
        question = replace(question, quantity=f"{what}{need.friction}/({' + '.join(need.normals)})")
    if not re.search(r"\b(?:work|time integral|displacement|number|turned)\b", question.quantity):
        ends = [moment_of(asked, end, question) for end in (when, question.since) if end]
        return _since(*(_at_moment(asked, question, end) for end in ends))
    return _work(asked, question, when)


FRICTION = re.compile(r"friction (ratio|coefficient needed) at (\w+)")


def _work(asked: Asked, question: Question, when: When) -> Found:
    """A work or a way until a moment, from the very start, that of the phase that is named, or another moment: phase by phase."""
    since, before = question.since, list[Found]()
    found = _at_moment(asked, question, moment_of(asked, replace(when, kind=DONE_BEFORE.get(when.kind, when.kind)), question))
    first = asked.named(question.phase) if question.phase else found.then.place if when.kind == "over" else 0
    if since is not None:
        since = replace(since, kind="begins") if since.kind == "until" else since
        begun = _at_moment(asked, question, moment_of(asked, since, question))
        first, before = begun.then.place, [] if begun.then.how == "start" else [begun]
    if first > found.then.place:
        raise StatementError(BACKWARDS, instead="ask the other way round.")
    if question.quantity.startswith("number"):
        first = max(first, min(asked.lasting, found.then.place))  # what ends at once turns nothing
    between = asked.names[first : found.then.place]
    if between or before:
        if said := SIZE.fullmatch(question.quantity):
            return _size_of(asked, question, when, said)
        if re.search(r"\b(?:magnitude|number) of (?!.*, counter-clockwise)", question.quantity):
            what = "sizes of parts are not added: in between it may go back"
            raise StatementError(what, instead="name one phase, or ask without.")
    ends = [moment_of(asked, When("end", (name,)), question) for name in between]
    words, blows = set(re.findall(r"\w+", question.quantity)), [asked.began(end.place + 1) for end in ends]
    struck = {name for blow in blows if blow.is_blow for name, size in blow.impulses.items() if not is_zero(size)}
    is_struck = any(name == word or name.startswith(f"{word}_") for name in struck for word in words)
    if is_struck or (re.search(r"\b(net|external) work", question.quantity) and any(blow.is_blow for blow in blows)):
        raise StatementError("a blow between does work too", instead="ask phase by phase: “… from PHASE to PHASE”.")
    acting = [{force.name for force in asked.study(place).system.forces} for place in range(found.then.place + 1)]
    named = words & acting[-1]  # what does not act yet in a phase does no work in it
    return _since(found, *before, done=[_at_moment(asked, question, end) for end in ends if named <= acting[end.place]])


SIZE = re.compile(r"magnitude of (.+)|(number of (?:turns|revolutions|rotations) (?:of|made by) [\w-]+)")


def _size_of(asked: Asked, question: Question, when: When, said: re.Match[str]) -> Found:
    """The size of what is summed over phases, or since a moment: that of the sum, which a size of each part would not give;
    turns are counted where all parts are turned in one sense. Raises StatementError where a sign is not decided."""
    inner = said[1] or f"{said[2]}, counter-clockwise"
    total = _work(asked, replace(question, quantity=inner), when)
    along = [axis for axis, value in zip("xy", total.values, strict=False) if not is_zero(value)]
    if len(total.values) == 2 and len(along) == 1:
        total = _work(asked, replace(question, quantity=(inner := f"{along[0]} component of {inner}")), when)
    given = assuming(total.study.assumptions, total.then.state.valid)
    parts = [part.values[0] for part in total.since] if said[2] and len(total.values) == 1 else []
    last = total.values[0] - sum(parts, NOTHING)
    senses = {sign(value, given).sense for value in ([*parts, last] if parts else total.values)}
    if len(total.values) != 1 or len(senses) != 1 or 0 in senses or (said[2] and question.since):
        what = "whether it turns in one sense" if said[2] else f"the magnitude of “{inner}”"
        raise StatementError(f"{what} is not told of several phases", instead=f"ask for “{inner.split(',')[0]}” phase by phase.")
    return total if senses == {1} else _work(asked, replace(question, quantity=f"minus {inner}"), when)


DONE_BEFORE = {"begins": "until"}  # what is done when a phase begins was done before
BACKWARDS = "the first of both moments comes after the second"


def _since(found: Found, *before: Found, done: Sequence[Found] = ()) -> Found:
    """What is counted from the moment `before` (none: the start), with the works `done` in the phases between."""
    if any(one.then.place > found.then.place for one in before):
        raise StatementError(BACKWARDS, instead="ask the other way round.")
    for part, way in (*((part, 1) for part in done), *((part, -1) for part in before)):
        pairs = list(zip(found.named, found.values, part.values, strict=True))
        named, values = (tuple(counted[k] + counted[2] * way for counted in pairs) for k in (0, 1))
        found = replace(found, named=named, values=tuple(map(short, values)), since=(*found.since, part))
    return found


def _at_moment(asked: Asked, question: Question, moment: Moment) -> Found:
    place, bound = _bound(asked, question, moment.place)
    world, study, named = asked.world(place), asked.study(place), parts(bound)
    if moment.how == "start" and place == 0 and asked.begun and _is_long(study, named):
        return _at_moment(asked.begun, question, moment_of(asked.begun, When("start"), question))
    works = _works(world, named)
    try:
        values = _at(world, named, works, moment, question)
    except ZeroDivisionError:  # by what the way of solving for every place divides, too
        if moment.how != "start" or place or not asked.begun:
            raise StatementError(f"“{question.quantity}” has no value there: something is divided by zero") from None
        return _at_moment(asked.begun, question, moment_of(asked.begun, When("start"), question))
    if moment.how == "rest" and not any(values) and any(names_in(value) & {*world.motion.scope.rates} for value in named):
        raise StatementError(
            f"in equilibrium nothing moves, so that “{question.quantity}” is nothing there",
            instead="of the place of equilibrium that is passed say “… where potential energy is smallest”.",
        )
    return Found(study, named, values, moment=moment, works=works, about=bound.about)


def _is_long(study: Study, named: Sequence[Scalar]) -> bool:
    """Whether what the laws give for these values at every place is too long to be read, where only the start is asked."""
    solved = {**study.solved.reactions, **(study.solved.accelerations or {})}
    return any(len(solved[n].num) * len(solved[n].den) > LONG for value in named for n in names_in(value) & solved.keys())


LONG = 60  # terms, those above times those below


def _at(world: ProblemWorld, named: Sequence[Scalar], works: Works, moment: Moment, question: Question) -> tuple[Scalar, ...]:
    closed = {name: done for name, (_, done) in works.items()}
    moved = world.study.begun if world.study.at_start else world.motion.moved
    found = [put(moved(substitute(value, closed)), moment.state.image) for value in named]
    found = [shortest(short(even(value)), world.study) for value in found]
    return tuple(_settled(world, value, moment, question) for value in found)


def _settled(world: ProblemWorld, value: Scalar, moment: Moment, question: Question) -> Scalar:
    """The value, which must hold nothing that moves. Raises StatementError."""
    study = world.study
    moving = names_in(value) & {*world.motion.scope.rates, *world.motion.unsettled, *world.motion.speeds}
    moving -= {"t"} if moment.how == "time" else set()
    if moving:
        name = min(moving)
        if name == "t":
            raise NoClosedForm(f"“{question.quantity}” depends on the time, which is not known there", instead=BY_NUMBERS)
        if study.problem.unstated and name in study.system.unsettled:
            raise _unsolved(study, name)
        if moment.state.places.get(name.removesuffix("_dot")) == symbol(name.removesuffix("_dot")):
            raise NoClosedForm(f"“{question.quantity}” depends on {name}, for which no closed form was found", instead=BY_NUMBERS)
        raise StatementError(
            f"“{question.quantity}” still depends on {name} there",
            instead=f'does [coordinates.{name.removesuffix("_dot")}] have a start = "..."? Where the time alone puts it '
            "there, leave its start out and give it a range: then it is a function of the time.",
        )
    return value


def _time(asked: Asked, question: Question) -> Found:
    """The time from the start of the first phase to a moment."""
    if question.when is None:
        raise StatementError("the time until when?", instead="write “time until x = 0”, or “time until PHASE”.")
    moment = moment_of(asked, question.when, question)
    clock = asked.stage(moment.place).clock if moment.place else NOTHING
    swung = time_of_swing(asked, moment)
    if swung is not None:
        return Found(asked.first, (swung[0],), (swung[0],), told=swung[1])
    time = moment.state.time
    if time is None:
        what = f"no closed form was found for the time {question.when.text}"
        raise NoClosedForm(what, instead=BY_NUMBERS)
    moment = replace(moment, how="time") if moment.how == "start" else moment
    if clock is None:  # each phase by its own motion
        begun = _time(asked, replace(question, when=When("until", (name := asked.names[moment.place],), f"until {name}")))
        return _since(Found(asked.study(moment.place), (symbol("t"),), (time,), moment=moment), done=[begun])
    return Found(asked.study(moment.place), (symbol("t") + clock,), (short(clock + time),), moment=moment)


# --- as a function


def _along(asked: Asked, question: Question) -> Found:
    """The value along the motion: a function of the position where the speeds are such, else of the state."""
    place, bound = _bound(asked, question, None)
    world, study, named = asked.world(place), asked.study(place), parts(bound)
    if bound.told:
        return Found(study, named, tuple(map(short, named)), told=bound.told)
    if study.at_start and any(names_in(value) & world.motion.unsettled for value in named):
        what = f"of the motion, only the start is known, also of “{question.quantity}”"
        raise StatementError(what, instead=f"ask for “{question.quantity} at the start”, or when a phase begins.")
    works = _works(world, named)
    closed = {name: done for name, (_, done) in works.items()}
    values = tuple(short(world.motion.moved(substitute(value, closed))) for value in named)
    unsolved = next((n for value in values for n in world.motion.unsettled if depends_on(value, n)), None)
    if unsolved is not None:
        raise _unsolved(study, unsolved)
    if question.of == "t" and moving_in(world, values) - {"t"}:
        return _in_time(asked, question, place)
    found = Found(study, named, values, "state" if moving_in(world, values) else "", works=works, about=bound.about)
    if not question.of and (constant := _constant(world, question, found)):
        return constant
    if question.of != "state" and question.of not in study.system.speeds:
        by_place = _without_speeds(world, found)
        if len(by_place.ways) > 1 and not question.of:  # each by its own place: only the time ties these
            with suppress(StatementError, NotApplicable):
                return _in_time(asked, question, place)
        else:
            found = by_place
    return of_one(world, found, question) if question.of not in ("", "state") else found


def on_way_back(world: ProblemWorld, found: Found) -> tuple[Scalar, ...]:
    """The values as functions of the position with all speeds in the opposite sense, as when the motion comes back."""
    closed = {name: done for name, (_, done) in found.works.items()}
    values = tuple(short(world.motion.moved(substitute(value, closed))) for value in found.named)
    return _without_speeds(world, replace(found, values=values), -1).values


def _constant(world: ProblemWorld, question: Question, found: Found) -> Found | None:
    """A momentum or speed that is kept from the start, as what it is there; None where it changes, or is none of these."""
    if not found.of or not KEPT.match(question.quantity):
        return None
    scope, study = world.motion.scope, world.study
    rates = (without_even_roots(study.on_motion(time_derivative(value, scope))) for value in found.values)
    begun = tuple(short(substitute(value, scope.start)) for value in found.values)
    is_kept = all(map(is_zero, rates)) and not moving_in(world, begun) and not any(depends_on(value, "t") for value in begun)
    return replace(found, values=begun, of="", constant=True) if is_kept else None


KEPT = re.compile(r"(?:total |[xy] component of )*(?:(?:angular |linear )?momentum\b|(?:angular )?(?:velocity|speed) of )")


def _without_speeds(world: ProblemWorld, found: Found, turned: int = 1) -> Found:
    """The values with the speeds as functions of the position, as far as these and their senses are known (`turned` -1: the
    opposite ones)."""
    motion, ways, asked = world.motion, {}, []
    kept = world.study.kept_speeds if any(depends_on(v, speed) for v in found.values for speed in motion.speeds) else {}
    kept = {speed: value for speed, value in kept.items() if any(depends_on(v, speed) for v in found.values)}
    values = tuple(substitute(value, kept) for value in found.values)
    values = tuple(with_squares(value, motion.squares) for value in values)
    for name, square in motion.squares.items():
        speed = f"{name}_dot"
        if any(depends_on(value, speed) for value in values):
            way = 1 if is_zero(square) else sense(motion, name)
            if not way:
                push = first_push(motion, name)
                way = inward(motion.scope.start.get(name), motion.assumptions.range_of(name))
                way = way or sense_stated(world.study, push) or sense_at_sample(world.study, push)
                asked.append(Demand(push * way))
            if not way:
                return found
            ways[name] = way
            values = tuple(even(substitute(value, {speed: root(square) * (way * turned)})) for value in values)
    resisted = resisted_in(world, values)
    values = tuple(substitute(value, {f"{name}_dot": speed for name, speed in resisted.items()}) for value in values)
    left = any(depends_on(value, speed) for value in values for speed in motion.speeds)
    if left:
        return found
    moves = any(depends_on(value, name) for value in values for name in motion.scope.rates)
    of = "position" if moves or values != found.values else found.of
    values = tuple(shortest(short(value), world.study) for value in values)
    return replace(found, values=values, of=of, ways=ways, asked=tuple(asked), speeds=resisted, kept=kept)


def _in_time(asked: Asked, question: Question, place: int) -> Found:
    """The value as a function of the time since the start of the phase."""
    try:
        return _at_moment(asked, question, at_time(asked, place, symbol("t"), question.manner))
    except NotApplicable:
        what = f"no closed form was found for “{question.quantity}” as a function of the time"
        raise StatementError(what, instead="ask for it “as a function of” a coordinate.") from None
