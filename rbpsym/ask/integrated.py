"""Values for which there is no closed form, by numbers: the motion is integrated to the moment that is asked for.

Nothing is proved by it, and that is said: the verdict on the form is UNDECIDED.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rbpsym.ask.asked import Asked
from rbpsym.ask.numbers import require_numbers
from rbpsym.ask.question import Question, When
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar, depends_on, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.compiled import compiled_rates, compiled_values
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.numbers import Numbers, number
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.quantity.bound import parts
from rbpsym.quantity.problem import ProblemWorld

if TYPE_CHECKING:
    import numpy as np

MOST_STEPS, LAST, LOOKS, NEAR = 20_000, 1e6, 200, 1e-7
HOW = "no closed form was found; the value is that of the motion, integrated from the start"


def integrated(asked: Asked, question: Question, numbers: Numbers) -> tuple[tuple[float, ...], t.Node]:
    """The value of a quantity at a moment, and the formula that tells its dimension. Raises StatementError where the motion
    does not come there, or a contact is lost before."""
    if question.when is None or question.of or question.since:
        what = "without a closed form, a value is found at one moment only"
        raise StatementError(what, instead="say when: “… where theta = 0”.")
    refused = list[StatementError]()
    for place in [asked.named(question.phase)] if question.phase else range(asked.lasting, len(asked.names)):
        try:
            return _in_phase(asked, question, question.when, numbers, place)
        except StatementError as error:
            refused.append(error)
    raise refused[0]


def _in_phase(asked: Asked, question: Question, when: When, numbers: Numbers, place: int) -> tuple[tuple[float, ...], t.Node]:
    """The same in one phase. Raises StatementError, where it ends before too."""
    world, study = asked.world(place), asked.study(place)
    is_time = question.quantity == "time"
    named = (symbol("t"),) if is_time else parts(world.bound(question.quantity))
    ledger = world.motion.ledger
    if place > asked.lasting and not question.phase and any(depends_on(value, work) for value in named for work in ledger):
        raise StatementError("without a closed form, a work is counted in one phase", instead="name it: “… in phase PHASE”.")
    values = [*named, _watched(world, when), *ledger.values(), *_lasting(study)]
    values = [substitute(study.on_motion(value), study.system.dependent) for value in values]
    moving, known = (*study.system.coordinates, *study.system.speeds), study.system.scope.start
    if missing := [name for name in moving if known.get(name) is None]:
        raise StatementError(f"it is not said where “{missing[0]}” starts", instead='give its coordinate a start = "...".')
    begin = {name: known[name] for name in moving}
    require_numbers(study, [*values, *begin.values()], {*numbers, *begin, *ledger, "t"})
    compiled, size = compiled_values(study, values, numbers, tuple(ledger)), len(moving)

    def evaluate(time: float, state: np.ndarray) -> np.ndarray:
        found: np.ndarray = compiled(time, state[:size], *state[size:])
        return found

    start = [*(number(value, numbers) for value in begin.values()), *(0.0 for _ in ledger)]
    time, state = _followed(study, evaluate, start, numbers, len(named), len(ledger), when)
    if place + 1 < len(asked.names):
        after = asked.began(place + 1).before.time
        if after is None:
            raise StatementError("when this phase ends is not known in closed form", instead="state it as a problem of its own.")
        if number(after, numbers) < time:
            raise StatementError(f"with these numbers the phase ends before {when.text}", instead="name another phase.")
    clock = asked.stage(place).clock if is_time and place else NOTHING
    if clock is None:
        what = "no closed form was found for the time until the phase begins"
        raise StatementError(what, instead="ask for it in that phase alone.")
    told = substitute(named[0], {name: power * symbol("t") for name, power in ledger.items()})
    return tuple(float(value) + number(clock, numbers) for value in evaluate(time, state)[: len(named)]), present(told)


def _watched(world: ProblemWorld, when: When) -> Scalar:
    """What vanishes at the moment. Raises StatementError for a moment that is not found by numbers."""
    if when.kind == "reaches" and when.words[0] != "t":
        name, text = when.words
        return world.dependent.get(name, symbol(name)) - scalar(read_infix(text, world.names))
    if when.kind == "reaches":
        return symbol("t") - scalar(read_infix(when.words[1], world.names))
    if when.kind in ("vanishes", "rests") and when.words:
        name = when.words[0]
        return symbol(name if when.kind == "vanishes" else f"{name}_dot")
    raise StatementError(f"no closed form was found for the moment “{when.text}”", instead="ask at a place: “where theta = 0”.")


def _lasting(study: Study) -> list[Scalar]:
    """What must not become negative: one-sided forces, what friction has left, slips in their sense, room in the ranges."""
    elements = study.problem.constraints
    found = [symbol(name) for element in elements for name in pushes(element) if name in study.dynamics.reactions]
    for need in study.friction_needs:
        if need.limit is not None:
            most = sum(map(symbol, need.normals), NOTHING) * need.limit
            found += [most + symbol(need.friction) * side for side in (-1, 1)]
    for name in study.system.coordinates:
        ends = zip(study.assumptions.range_of(name), (1, -1), strict=True)
        found += [(symbol(name) - end) * side for end, side in ends if end is not None]
    return [*found, *slips(study.system).values()]


Evaluate = Callable[[float, "np.ndarray"], "np.ndarray"]


def _followed(
    study: Study, evaluate: Evaluate, start: list[float], numbers: Numbers, first: int, works: int, when: When
) -> tuple[float, np.ndarray]:
    """(time, state) at the moment, contacts watched on the way."""
    import numpy as np

    from rbpsym.numeric.integration import Event, followed

    rates, size = compiled_rates(study, numbers), len(start) - works

    def rate(time: float, state: np.ndarray) -> np.ndarray:
        return np.concatenate((rates(time, state[:size]), evaluate(time, state)[first + 1 : first + 1 + works]))

    if not rate(0.0, np.array(start)).any():
        what = "it starts at rest where nothing drives it, and by numbers it stays there"
        raise StatementError(what, instead="give it a small speed at the start.")
    event = Event(lambda time, state: float(evaluate(time, state)[first]))
    path = followed(rate, start, LAST, events=[event], most=MOST_STEPS)
    if not path.seen[0]:
        raise StatementError(f"with these numbers the motion does not come {when.text}", instead="change a number.")
    time = path.seen[0][0]
    looks = np.array([evaluate(at, path.at(at))[first + 1 + works :] for at in np.linspace(0, time, LOOKS)[:-1]])
    if looks.size and (looks < -NEAR * np.abs(looks).max(axis=0)).any():
        what = "with these numbers a contact is lost, something slips or a range is left before"
        raise StatementError(what, instead="ask for what comes before that.")
    return time, path.at(time)
