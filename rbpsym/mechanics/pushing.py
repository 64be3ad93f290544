"""Whether a motion can begin as stated: contacts push, strings pull, kinetic friction acts against the slip.

What is surely otherwise gets a sentence; what depends on parameters is the condition under which the motion begins.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.elements.interactions import LETTERS
from rbpsym.errors import LimitError, StatementError
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, names_in, short, substitute, time_derivative
from rbpsym.mechanics.demands import Demand, possible, settle
from rbpsym.mechanics.events import pushes, taken
from rbpsym.mechanics.friction import resistances, slips, spare
from rbpsym.mechanics.numbers import Numbers, bound, floating, sample, samples
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.statement.model import Element
from rbpsym.typeset.machine import to_machine

LARGEST = 4000  # terms: signs of what is longer are not looked for


def check_start(study: Study, *, moves: bool = True) -> None:
    """Raises StatementError where a one-sided force or the friction at the start surely has the wrong sense; of a phase that
    ends at once (it never `moves`), nothing has to begin to slide."""
    found = _asked(study, moves)
    for element, what, value, _ in found:
        if sign(value, study.assumptions, factoring=False).kind == "negative":
            raise _wrong(element, what, value)
    if found:
        possible((demand for *_, demand in found), study.assumptions, _never(study))


def _asked(study: Study, moves: bool) -> list[tuple[Element, str, Scalar, Demand]]:
    rows = (row for row in asked(study) if moves or row[1] not in ("gain", "grip"))
    return [(element, what, value, Demand(value, OPS[what])) for element, what, value in rows]


def _never(study: Study) -> StatementError:
    among = (*study.problem.constraints, *study.problem.interactions)
    element = next((e for e in among if e.values.get("coefficient") is not None or e.kind in LETTERS), among[0])
    return StatementError(
        f"no values of the parameters let “{element.name}” push and slip at the start as it is stated",
        instead="check the start, the side, and the sense of the slip.",
        place=element.place,
    )


def begins(study: Study) -> tuple[Demand, ...]:
    """Under which conditions the motion begins as stated, as far as it is known: nothing where the forces grow too long; where
    nothing begins to slide, of what then stays at rest. Raises StatementError if under none."""
    with suppress(LimitError):
        moving, still = ((demand for *_, demand in _asked(study, moves)) for moves in (True, False))
        left = settle(moving, study.assumptions)
        return possible(still, study.assumptions, _never(study)) if left is None else left
    return ()


def begun_numbers(study: Study, asked: Iterable[Demand] = (), *, far: bool = False) -> dict[str, float]:
    """The first sample numbers at which the motion begins as stated and what else is asked is met; else those of the sample.

    `far`: rather those from which it goes to the farther ends of its ranges.
    """
    begun = (*begins(study), *asked)
    fits = (n for n in samples(study.problem) if all(floating(demand.value, n) >= 0 for demand in begun))
    first = next(fits, None)
    if first is None or not far or _goes_far(study, first):
        return first or sample(study.problem)
    return next((numbers for numbers in fits if _goes_far(study, numbers)), first)


def _goes_far(study: Study, numbers: Numbers) -> bool:
    """Whether what starts within a range, at a place of its own, sets out towards the farther end."""
    start = _gained(study)
    for c in study.problem.coordinates:
        low, high, begun = (bound(node, numbers) for node in (c.lower, c.upper, c.start))
        rates = (floating(start.get(f"{c.name}_{rate}", NOTHING), numbers) for rate in ("dot", "ddot"))
        away = 0.0 if low is None or high is None or begun is None else low + high - 2 * begun
        if next(filter(None, rates), 0.0) * away < 0:
            return False
    return True


OPS = {"way": ">", "force": ">=", "growth": ">=", "grip": ">=", "size": ">=", "slip": ">", "gain": ">"}


def asked(study: Study) -> Iterator[tuple[Element, str, Scalar]]:
    """What has to be positive at the start: lengths and heights that tell ways and sides, one-sided forces, what static
    friction has left of its limit, the slip in its sense, or its gain from rest."""
    start, reactions = _gained(study), study.solved.reactions
    yield from ((element, "way", value) for element, value in ways_taken(study))
    for element in study.problem.constraints:
        for name in pushes(element):
            value, what = _beginning(study, reactions[name], start)
            yield from () if value is None else [(element, what, value)]
        for left in spare(element, reactions.__getitem__):
            value = _at_start(left, start)
            yield from () if value is None else [(element, "grip", value)]
    for name, found in resistances(study.system).items():
        used = names_in(found.size) & reactions.keys()
        value = _at_start(substitute(found.size, {n: reactions[n] for n in used}), start) if used else None
        yield from () if value is None else [(study.system.element(name), "size", value)]
    for name, slip in slips(study.system).items():
        element = study.system.element(name)
        first = _at_start(slip, start)
        if first is not None and is_zero(first):
            first = _at_start(study.begun(time_derivative(slip, study.system.scope)), start)
            if first is not None and study.solved.accelerations and not is_zero(neat(first, study.assumptions)):
                yield element, "gain", first
        elif first is not None:
            yield element, "slip", first


def kept_sense(study: Study, element: Element) -> tuple[Demand, ...]:
    """What friction or a resistance asks of the state, as far as nothing declared says so: that the motion keeps its sense, and
    that a size that rests on unknown forces is not negative."""
    slip, found = slips(study.system).get(element.name), resistances(study.system).get(element.name)
    size = [found.size] if found is not None and names_in(found.size) & {*study.system.unknowns} else []
    never = StatementError(f"“{element.name}” never acts in the sense that is stated", place=element.place)
    return possible((Demand(value, ">=") for value in ([] if slip is None else [slip]) + size), study.assumptions, never)


def ways_taken(study: Study) -> Iterator[tuple[Element, Scalar]]:
    """What is positive at the start where strings run, and things touch, on the side that the formulas are made for."""
    start = _start(study)
    for element, value in taken(study.system):
        there = _at_start(value, start)
        if there is not None and not any(depends_on(there, name) for name in study.system.coordinates):
            yield element, there


def ways_kept(study: Study) -> Iterator[tuple[Element, Scalar]]:
    """What has to stay positive in each position for strings to run, springs to reach and things to touch as the formulas
    have it, where the declared ranges do not say so."""
    for element, value in taken(study.system):
        if names_in(value) & study.system.scope.rates.keys() and not sign(value, study.assumptions).is_nonnegative:
            yield element, value


def _start(study: Study) -> Mapping[str, Scalar]:
    return {**dict.fromkeys(study.system.speeds, NOTHING), **study.system.scope.start}


def _gained(study: Study) -> Mapping[str, Scalar]:
    """The same with the accelerations there, as far as they are known."""
    start = _start(study)
    gained = {name: _at_start(value, start) for name, value in (study.solved.accelerations or {}).items()}
    return {**{name: value for name, value in gained.items() if value is not None}, **start}


def _beginning(study: Study, value: Scalar, start: Mapping[str, Scalar]) -> tuple[Scalar | None, str]:
    """What a force is at the start; where it vanishes, how it begins to grow: by the first of two rates that is not zero."""
    there, what = _at_start(value, start), "force"
    for _ in range(0 if study.at_start else 2):
        if there is not None and is_zero(there) and not is_zero(value):
            value = study.on_motion(time_derivative(value, study.system.scope))
            there, what = _at_start(value, start), "growth"
    return there, what


def _at_start(value: Scalar, start: Mapping[str, Scalar]) -> Scalar | None:
    if len(value.num) * len(value.den) > LARGEST:
        return None
    try:
        return short(substitute(value, start))
    except ZeroDivisionError:
        return None


def _wrong(element: Element, what: str, value: Scalar) -> StatementError:
    """What is said of the wrong sense of something at the start."""
    kind = "resisted" if element.kind in LETTERS else element.kind
    said, instead = WRONG.get(f"{what}.{kind}") or WRONG[what]
    data = {"kind": element.kind, "name": element.name, "slip": element.values.get("slip"), "size": to_machine(present(value))}
    return StatementError(said.format_map(data), instead=instead, place=element.place)


SLIP, BACK = "{kind} “{name}” has slip = “{slip}”, but ", (
    'take the other sense, slip = "auto" for a start with a speed, or static friction, type = "sticking" or "rolling", for what '
    "does not slide."
)
RESISTED, OTHER = "the {kind} “{name}” is against a motion that is not the stated one: ", (
    "take the other sense; where nothing begins to move, hold it by a constraint."
)
WRONG = {
    "way": (
        "the {kind} “{name}” does not run, or touch, at the start where the ranges would have it",
        "let the start and the ranges tell the same side.",
    ),
    "grip": (
        "the {kind} “{name}” would slip at the start: the static friction exceeds its limit there",
        'check the start and the limit; what slides is type = "contact" with a coefficient and a slip.',
    ),
    "size": (
        "the size of the {kind} “{name}” would be negative at the start: {size}",
        "a magnitude is not: write the unknown force in it with the other sign.",
    ),
    "force": (
        "the {kind} “{name}” would have to pull at the start: its force is {size}",
        "check the start (the sense in which things move or turn), the side, and whether it touches at all; what holds to both "
        'sides is type = "guide" for a point.',
    ),
    "force.rolling": (
        "the rolling “{name}” would have to pull at the start: its force is {size}",
        "check the start (the sense in which things move or turn), the side, and that weights press it down, also where motion "
        'alone is asked for: [interactions.W] type = "gravity".',
    ),
    "growth": (
        "the {kind} “{name}” would have to pull as soon as it moves: its force vanishes at the start, and falls from there",
        "check the side; what lets go at once is left out.",
    ),
    "force.string": (
        "the string “{name}” would have to push at the start: its tension is {size}",
        "check its path and what else holds the bodies; a light rod that may push is a body of its own.",
    ),
    "slip": (SLIP + "at the start it slips the other way (in this sense the speed of the slip is {size})", BACK),
    "gain": (
        SLIP + "from rest it does not begin to slide that way: friction would drive it (in this sense the acceleration of the "
        "slip is {size})",
        BACK,
    ),
    "slip.resisted": (
        RESISTED + "at the start it moves the other way (in the sense that it resists, the speed is {size})", OTHER
    ),
    "gain.resisted": (
        RESISTED + "from rest it does not begin to move that way (in the sense that it resists, the acceleration is {size})",
        OTHER,
    ),
}
