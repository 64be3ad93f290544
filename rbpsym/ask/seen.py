"""Quantities of a problem as functions of its parameters and of the place on its motion."""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import suppress

from rbpsym.ask.answer import found_of
from rbpsym.ask.asked import Asked
from rbpsym.ask.extremes import Extreme, extremes
from rbpsym.ask.found import Found
from rbpsym.ask.lasting import asks, compared, lasted
from rbpsym.ask.question import Question, is_jump, read_question
from rbpsym.ask.zeros import where_met, zeros
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.dimensions import a, dimension_of
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import Ambiguous, DimensionError, StatementError, Undecided, all_there
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import field, replace
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.events import Way, pushes, ways
from rbpsym.mechanics.friction import slips, slips_on, spare
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.pushing import begins, begun_numbers
from rbpsym.mechanics.roots import period
from rbpsym.present.forms import present
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.source import did_you_mean
from rbpsym.typeset.text import to_text


class NeverThere(Ambiguous):
    """A coordinate does not come to a place in this phase."""


def never_told(text: str) -> StatementError:
    """What is said where the conditions of something exclude each other."""
    return StatementError(f"“{text}” never comes about: what it asks for is never met", instead="change the statement.")


class AskedPhase(ProblemWorld):
    """One phase of the motion of a problem that is asked (its `number` among all), and what was found for the quantities that a
    question names.

    demands: under what conditions they have the values that were found; lasting: those of contacts, friction and declared
    ranges on the way to the moments at which they are taken; doubts: what of that is not decided; standing: what the same
    ask of the parameters where a quantity is taken at no moment; senses: what the ways ask along which something has to hold.
    """

    asked: Asked = field(kw_only=True)
    number: int = 0
    is_named: bool = False
    used: list[tuple[Question, Found]] = field(default_factory=list)
    lasting: list[Demand] = field(default_factory=list)
    doubts: list[str] = field(default_factory=list)
    standing: list[Demand] = field(default_factory=list)
    senses: list[Demand] = field(default_factory=list)

    def afresh(self) -> AskedPhase:
        """The same phase of which nothing is asked yet."""
        return scene(self.asked, self.number, is_named=self.is_named)

    @property
    def demands(self) -> tuple[Demand, ...]:
        """What the moments ask for at which quantities are taken, and the senses in which speeds are."""
        moments = [found.moment.state.valid for _, found in self.used if found.moment]
        asked = (found.asked for _, found in self.used)
        return tuple(dict.fromkeys(d for part in (*moments, *asked, self.lasting) for d in part))


def scene(asked: Asked, place: int | None = None, *, is_named: bool = True) -> AskedPhase:
    """The phase of that place, with what those before it ask for; the first one that does not end at once."""
    meant, is_named = asked.meant(place), is_named and place is not None
    lasting, doubts = lasted(asked, meant)
    return AskedPhase(asked.study(meant), asked=asked, number=meant, is_named=is_named, lasting=[*lasting], doubts=[*doubts])


def seen(world: AskedPhase, phrase: str) -> Scalar:
    """A quantity at a moment, or on the motion with its speeds as functions of the place as far as they are known.

    Raises StatementError or ReadError for what means nothing, and for a vector.
    """
    values = parts_seen(world, phrase)
    if len(values) != 1:
        raise StatementError(f"“{phrase}” is a vector", instead="name its magnitude or a component.")
    return values[0]


def parts_seen(world: AskedPhase, phrase: str) -> tuple[Scalar, ...]:
    """The same of a vector too, its components."""
    question = read_question(phrase)
    if (world.number or world.is_named) and question.when is None and not question.phase and not is_jump(question.quantity):
        question = replace(question, phase=world.asked.names[world.number])
    found = found_of(world.asked, question)
    world.used.append((question, found))
    lasts, doubts = asks(world.asked, found)
    lasts = lasts or compared(found, [one for _, one in world.used])
    (world.standing if found.moment is None else world.lasting).extend(lasts)
    world.doubts.extend(doubts)
    return tuple(neat(value, world.motion.assumptions) for value in found.values)


# a quantity, and where or when it is asked
PLACE = re.compile(r"(.+?)((?: (?:where|when|at|(?:just|right) (?:after|before|when|where)|in|once) ).+)")


def told(value: Scalar) -> str:
    """A value as text."""
    return to_text(present(value))


def moving(world: AskedPhase, values: Iterable[Scalar]) -> list[str]:
    """The coordinates, speeds and the time on which values depend."""
    names = (*world.motion.scope.rates, *world.motion.speeds, *world.motion.unsettled, "t")
    return [name for name in dict.fromkeys(names) if any(depends_on(value, name) for value in values)]


def parameter(world: AskedPhase, name: str) -> str:
    """The name of a parameter. Raises StatementError for a name that is none."""
    problem = world.study.problem
    known = [quantity.name for quantity in problem.parameters]
    if name not in known:
        what = "a coordinate" if name in world.coordinates else "no parameter of the problem"
        raise StatementError(f"“{name}” is {what}", instead=did_you_mean(name, known, "parameters"))
    return name


def number_in(world: AskedPhase, text: str) -> Scalar:
    """The value of an expression in parameters. Raises ReadError."""
    return scalar(read_infix(text, world.names))


def place_in(world: AskedPhase, name: str, text: str) -> Scalar:
    """The value of a coordinate or parameter, within its range. Raises DimensionError or StatementError."""
    value, limits = number_in(world, text), of_symbol(name, world.motion.assumptions)
    require_same(world, symbol(name), value, (name, text))
    for end, side in ((limits.lower, 1), (limits.upper, -1)):
        if end is not None and settle([Demand((value - end) * side, ">=")], world.motion.assumptions) is None:
            what = f"{name} = {text} is outside of what is declared: {name} {'>' if side > 0 else '<'} {told(end)}"
            raise StatementError(what, instead="choose another value.")
    return value


def require_same(world: AskedPhase, first: Scalar, second: Scalar, texts: tuple[str, str]) -> None:
    """Raise DimensionError where two values have different dimensions."""
    known = world.dimensions
    if first and second:
        dimensions = [dimension_of(present(value), known) for value in (first, second)]
        if dimensions[0] != dimensions[1]:
            raise DimensionError(f"“{texts[0]}” is {a(dimensions[0])}, but “{texts[1]}” is {a(dimensions[1])}")


def way_to(world: ProblemWorld, name: str, end: Scalar | None, given: Assumptions) -> tuple[Way, Assumptions]:
    """How a coordinate moves from its start, and its range on the way to a place (None: to where it first comes to rest, or
    to the end of its range).

    In which sense it sets out is told by the sample numbers where it depends on the parameters. Raises StatementError where
    the motion is not known or never comes there.
    """
    found = ways_to(world, name, end, given)
    numbers = begun_numbers(world.study) if len(found) > 1 else {}
    fits = (pair for pair in found if all(floating(one.value, numbers) >= 0 for one in pair[0].asked))
    return found[0] if len(found) == 1 else next(fits, found[0])


def whole_ways(world: AskedPhase, name: str, given: Assumptions) -> list[tuple[Way, Assumptions]]:
    """How far a coordinate goes as is told, in each sense in which it may set out: to where it first comes to rest, where a
    contact is lost, or to the end of its range. Raises StatementError where that depends on parameters."""
    whole = []
    for way, range_ in ways_to(world, name, None, given, may_turn=True):
        end, asked = _lost(world, way, range_)
        way = replace(way, asked=(*way.asked, *asked))
        whole.append((way, _both(way, range_, _back(world, way, range_, given)) if end is None else way.until(end, given)))
    return [_until_next(world, way, range_) for way, range_ in whole]


def _lost(world: AskedPhase, way: Way, given: Assumptions) -> tuple[Scalar | None, tuple[Demand, ...]]:
    """Where on its way a contact is lost, or None, with the condition for the one or the other, as it is at the sample
    numbers. Raises StatementError where that is not known."""
    ended = world.study.ended
    asked = [settle(loss.valid, given) for loss in ended.found]
    happen = [(loss, left) for loss, left in zip(ended.found, asked, strict=True) if left is not None]
    case = _case(world, happen[0][1]) if len(happen) == 1 else None
    if ended.complete is not True or (happen and (case is None or way.name not in happen[0][0].at)):
        return None, _kept_on(world, way, given)
    happens, left = case or (False, ())
    return (happen[0][0].at[way.name] if happens else None), left


def fits(world: ProblemWorld, asked: Iterable[Demand]) -> bool:
    """Whether all that is asked is met by the example, or the sample numbers."""
    numbers = sample(world.study.problem, world.study.problem.example)
    return all(floating(demand.value, numbers) >= 0 for demand in asked)


def _case(world: ProblemWorld, asked: tuple[Demand, ...]) -> tuple[bool, tuple[Demand, ...]] | None:
    """Whether all that is asked is met as `fits` says, and that, or its opposite, as a condition; None where the opposite is
    more than one condition."""
    if fits(world, asked):
        return True, asked
    return (False, (Demand(-asked[0].value, ">=" if asked[0].op == ">" else ">"),)) if len(asked) == 1 else None


def _kept_on(world: AskedPhase, way: Way, given: Assumptions) -> tuple[Demand, ...]:
    """Under what condition nothing lets go on the whole way, where it `fits`. Raises StatementError where that
    is not decided, or something does."""
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    alone = world.afresh()
    with suppress(Undecided):
        going = Wanted(going_on(alone, way, given)[:-1], given, way.name, asked=way.asked)
        asked = tuple(least_values(going, alone.demands))
        if fits(world, asked):
            return asked
    ended = world.study.ended.found
    what = f"whether, and where, {ended[0].force if ended else 'a contact'} lets go depends on the parameters or is not decided"
    raise StatementError(what, instead=f"say where from and where to: “… over {way.name} between VALUE and VALUE”.")


def _until_next(world: AskedPhase, way: Way, given: Assumptions) -> tuple[Way, Assumptions]:
    """The way and the range up to where the next phase begins, if the coordinate comes there without turning round. Raises
    StatementError where that is not decided."""
    if world.number + 1 == len(world.asked.names):
        return _halted(world, way, given)
    phase, before = world.asked.names[world.number + 1], world.asked.began(world.number + 1).before
    end, onwards = before.places[way.name], sign(before.speeds[way.name] * way.sense, world.motion.assumptions)
    if onwards.is_nonnegative and end != symbol(way.name):
        comes = tuple(dict.fromkeys((*way.asked, *before.valid)))
        return replace(way, asked=comes), way.until(end, where_met(given, before.valid))
    if onwards.kind in ("negative", "nonpositive"):
        return _halted(world, way, given)
    what = f"whether “{way.name}” turns round before “{phase}” begins depends on the parameters, or is not known"
    raise StatementError(what, instead=f"ask for its value when {phase} begins, or where it comes to rest.")


def ways_to(
    world: ProblemWorld, name: str, end: Scalar | None, given: Assumptions, *, may_turn: bool = False
) -> list[tuple[Way, Assumptions]]:
    """The same as `way_to` for each sense in which it may set out; `may_turn`: whether it turns round may depend on the
    parameters, and is as at the sample numbers."""
    study = world.study
    square, begin = world.motion.squares.get(name), study.system.scope.start.get(name)
    if square is None or begin is None:
        what = f"the speed of “{name}” as a function of its place is not known"
        raise StatementError(what, instead=f'does [coordinates.{name}] have a start = "..." and a speed = "..."?')
    if end is not None and is_zero(end - begin):
        raise StatementError(f"“{name}” starts there")
    if end is not None and name in study.resting:
        raise NeverThere(f"“{name}” stays where it starts")
    found = ways(study.system, study.dynamics, name, square, given)
    if not found:
        raise StatementError(f"in which sense “{name}” sets out is not known", instead="ask for its acceleration at the start.")
    begun = where_met(given, begins(study)) if len(found) > 1 else given  # the slips that are stated tell the sense, too
    found = [way for way in found if settle(way.asked, begun) is not None] or found
    asked = [() if end is None else settle([Demand(way.ahead(end))], where_met(given, way.asked)) for way in found]
    pairs = zip(found, asked, strict=True)
    coming = [replace(way, asked=(*way.asked, *ahead)) for way, ahead in pairs if ahead is not None]
    if not coming:
        sense = "grows" if found[0].sense > 0 else "falls"
        raise NeverThere(f"“{name}” never comes there before it turns round: it {sense} from {told(begin)}")
    if end is None and may_turn:
        coming = [replace(way, asked=(*way.asked, *_turns(world, way, where_met(given, way.asked)))) for way in coming]
    return [(way, _on_way(way, end, where_met(given, way.asked))) for way in coming]


def _turns(world: ProblemWorld, way: Way, given: Assumptions) -> tuple[Demand, ...]:
    """Under what one condition it turns round, at one of the places that are known, or does not, as it is at the sample
    numbers."""
    found = zeros(way.square, way.name, given.with_range(way.name, *_ends(way, given.range_of(way.name))))
    if len({place.asked for place in found.found}) != 1 or found.open_ or found.crossings:
        return ()
    case = _case(world, found.found[0].asked)
    return case[1] if case else ()


def to_and_fro(world: ProblemWorld, name: str, given: Assumptions) -> list[tuple[Way, Assumptions]]:
    """The whole motion of a coordinate as `way_to` says it; with the other side of the start, to which it comes back from
    a place where it turns round."""
    way, within = way_to(world, name, None, given)
    return [(way, within), *_back(world, way, within, given)]


def _back(world: ProblemWorld, way: Way, within: Assumptions, given: Assumptions) -> list[tuple[Way, Assumptions]]:
    """The other side of the start, if it comes back there from a place where it turns round."""
    if not _turns_round(world, way, within) or not world.study.system.scope.start.get(f"{way.name}_dot", NOTHING):
        return []
    back = replace(way, sense=-way.sense)
    return [(back, _on_way(back, None, where_met(given, way.asked)))]


def whole_motion(world: ProblemWorld, name: str, given: Assumptions) -> tuple[Way, Assumptions]:
    """How a coordinate sets out, and all the places to which it comes on either side of its start."""
    (way, within), *back = to_and_fro(world, name, given)
    return way, _both(way, within, back)


def _turns_round(world: ProblemWorld, way: Way, within: Assumptions) -> bool:
    """Whether it comes to rest at the end of its way, and goes back: what slips stays there."""
    return _rests(way, within) and not slips(world.study.system)


def _rests(way: Way, within: Assumptions) -> bool:
    end = within.range_of(way.name)[way.sense > 0]
    return end is not None and is_zero(without_even_roots(substitute(way.square, {way.name: end})))


def _halted(world: ProblemWorld, way: Way, within: Assumptions) -> tuple[Way, Assumptions]:
    """The way; raises StatementError where it comes to rest at its end, while it slips on something else that moves."""
    if slips_on(world.study.system, way.name) and _rests(way, within):
        raise StatementError(f"how far “{way.name}” goes is not known: it turns round as it slips", instead="say until when.")
    return way, within


def comes_back(world: ProblemWorld, name: str, given: Assumptions) -> bool:
    """Whether a coordinate turns round where it first comes to rest, and passes its places again."""
    return any(_turns_round(world, *pair) for pair in ways_to(world, name, None, given, may_turn=True))


def _both(way: Way, within: Assumptions, back: list[tuple[Way, Assumptions]]) -> Assumptions:
    """One range of both sides of the start."""
    name = way.name
    for _, other in back:
        below, above = (other, within) if way.sense > 0 else (within, other)
        sides = (below.sides_of(name) - {1}) | (above.sides_of(name) - {0})
        within = within.with_range(name, below.range_of(name)[0], above.range_of(name)[1], sides)
    return within


def _on_way(way: Way, end: Scalar | None, given: Assumptions) -> Assumptions:
    ahead = given.with_range(way.name, *_ends(way, given.range_of(way.name)))
    end = _turning(way, ahead) if end is None else end
    return ahead if end is None else way.until(end, given)


def _ends(way: Way, known: tuple[Scalar | None, Scalar | None]) -> tuple[Scalar | None, Scalar | None]:
    return (way.start, known[1]) if way.sense > 0 else (known[0], way.start)


def _turning(way: Way, ahead: Assumptions) -> Scalar | None:
    """Where the speed first vanishes ahead; None if it does not in the range. Raises StatementError if that is open."""
    found = zeros(way.square, way.name, ahead)
    if found.open_ or found.crossings or found.asked:
        what = f"how far “{way.name}” goes depends on the parameters, or is not known in closed form"
        raise StatementError(what, instead=f"say until when: “… until {way.name} = VALUE”, or “… between VALUE and VALUE”.")
    return found.found[0 if way.sense > 0 else -1].place if found.found else None


def one_period(value: Scalar, given: Assumptions, name: str = "t", begin: Scalar = NOTHING, sense: int = 1) -> Assumptions:
    """The time, or a coordinate that sets out in a sense and has no end, runs through a period of the value, if there is one."""
    turn = period(value, name)
    if turn is None or given.range_of(name)[sense > 0] is not None:
        return given
    end = begin + (-turn if sign(turn, given).kind == "negative" else turn) * sense
    return given.with_range(name, *((begin, end) if sense > 0 else (end, begin)))


def going_on(world: AskedPhase, way: Way, given: Assumptions) -> tuple[Scalar, ...]:
    """What has to stay positive for the motion to go on as it is told: one-sided forces, what friction has left of its
    limits, and last the square of the speed; without what is surely positive all the way.

    Raises StatementError where a force is no function of the position.
    """
    study = world.study
    names = [name for element in study.problem.constraints for name in pushes(element)]
    values = [seen(world, name) for name in names]
    for element in study.problem.constraints:
        values += spare(element, lambda name: seen(world, name))
    other = next((n for n in moving(world, values) if n != way.name), None)
    if other is not None:
        raise StatementError(f"{names[0]} is no function of {way.name} alone, so that it may let go before")
    square = seen(world, f"{way.name}_dot^2")
    return (*(value for value in values if sign(value, given).kind != "positive"), square)


def is_sure(values: Iterable[Scalar], name: str, given: Assumptions) -> bool:
    """Whether all values are positive on the way, for all parameters."""
    found = all_there(extremes(value, name, given, -1) for value in values)
    return found is not None and all(_is_positive(low, given) for lows in found for low in lows)


def _is_positive(low: Extreme, given: Assumptions) -> bool:
    return low.crossing is None and low.value is not None and (low.beside > 0 or settle([Demand(low.value)], given) == ())
