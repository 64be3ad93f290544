"""How a phase of the motion ends: when or where, and the state at that moment.

Where the accelerations are constant, the moment is found first; else the place, and the speed there
from the first integral.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress

from rbpsym.elements.events import EVENTS
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, is_zero, short, substitute, symbol, time_derivative
from rbpsym.frozen import Frozen
from rbpsym.mechanics.arrivals import ArrivalState, at_start
from rbpsym.mechanics.endings import LAWS
from rbpsym.mechanics.jumps import KeptMomentum, until_no_slip
from rbpsym.mechanics.system import Force, by_letters, in_state
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef, PhraseRef, Step, StepRef, bodies_named
from rbpsym.statement.curves import curve_body, toucher
from rbpsym.statement.model import Element, Phase


def write(draft: Draft, ending: Ending) -> None:
    """Steps that lead to the state at the end; none where the next phase begins at once."""
    if ending.phase.event == "at once":
        return
    state, slip = ending.state, _slip(draft, ending)
    sources = [] if slip is None else kept_until(draft, ending, slip)
    if sources:
        _state(draft, ending, "speed", state.speeds, sources)
    if state.time is not None:
        _condition(draft, ending, slip)
        _moment(draft, ending, state.time)
    else:
        _place(draft, ending)
    _state(draft, ending, "place", state.places)
    if not sources:
        _state(draft, ending, "speed", state.speeds)
    _energy(draft, ending)


# --- when


def _slip(draft: Draft, ending: Ending) -> Scalar | None:
    """How fast it slips; None where no slip ends."""
    gap = LAWS[ending.phase.event].gap if EVENTS[ending.phase.event].by_friction else None
    return None if gap is None else short(gap(draft.study, ending.phase))


def _condition(draft: Draft, ending: Ending, value: Scalar | None) -> None:
    """For a slip that goes: its speed, and the rate at which that changes."""
    if value is None:
        return
    study, element = draft.study, ending.element(draft)
    letter = draft.define(draft.free("u"), value)
    on, by = toucher(element), curve_body(element)
    draft.add("slip.speed", "slip", t.equation(letter, draft.show(value)), "phases.slip", letter=letter,
              body=BodyRef(on or by or ""), data={"element": element, "value": value})  # fmt: skip
    rate = short(study.on_motion(time_derivative(value, study.system.scope)))
    draft.add("slip.rate", "balance", t.equation(t.Deriv(letter), draft.show(rate, factor=True)), "phases.slip_rate",
              premises=["slip.speed"], letter=letter)  # fmt: skip


def _moment(draft: Draft, ending: Ending, time: Scalar) -> None:
    """t_1."""
    letter, event = draft.define(draft.free(f"t_{ending.number}"), time), begun(ending.phase)
    draft.add("moment", "event_time", t.equation(letter, draft.show(time, factor=True, met=ending.state.valid or None)),
              f"phases.moment.{EVENTS[event].moment if event in EVENTS else event}",
              premises=draft.those("slip.speed", "slip.rate") or [f"motion.{name}" for name in draft.study.system.independent],
              letter=letter, coordinate=t.Sym(ending.phase.subject), is_result=True, obligations=draft.asked(ending.state.valid),
              data={"ending": ending})  # fmt: skip


# --- where


def _place(draft: Draft, ending: Ending) -> None:
    """The place at which the force vanishes, friction reaches its limit, or a coordinate its value."""
    [name] = _mover(draft, ending)
    value = ending.state.places[name]
    letter = draft.define(place_name(draft, name, ending.number), value)
    led = [f"along.{ending.phase.subject}", *([f"square.{name}"] if ending.phase.event == "rests" else [])]
    kind = EVENTS[ending.phase.event].place  # a value that the statement names is no result
    draft.add("place", "event_place", t.equation(letter, draft.show(value)), f"phases.place.{kind}",
              premises=draft.those(*led),
              letter=letter, force=t.Sym(ending.phase.subject), coordinate=t.Sym(name), is_result=kind != "value",
              obligations=draft.asked(ending.state.valid), data={"ending": ending, "name": name, "value": value})  # fmt: skip


def begun(phase: Phase) -> str:
    """The event as it is told: a string that begins is taut."""
    return "taut" if phase.gap is not None and "path" in phase.gap.values else phase.event


def _mover(draft: Draft, ending: Ending) -> list[str]:
    """The independent coordinate that moved."""
    start, names = at_start(draft.study), draft.study.system.independent
    known = [n for n in names if n in draft.study.squares and ending.state.places[n] != symbol(n)]
    moved = [n for n in known if not is_zero(ending.state.places[n] - start.places[n])]
    return moved[:1] or list(names[:1])


# --- the state then


def _state(draft: Draft, ending: Ending, what: str, values: Mapping[str, Scalar], given: Sequence[Step] = ()) -> None:
    """All places (or speeds) that were not named yet, or only by what is kept, from which they follow then."""
    rows, letters, begun = [], {}, dict[str, Scalar]()
    with suppress(StatementError):  # what drives lead may begin at a place without a closed form
        start = at_start(draft.study)
        begun |= start.places if what == "place" else start.speeds
    name_of: Callable[[Draft, str, int], str] = place_name if what == "place" else speed_name
    for name, value in values.items():
        letter = name_of(draft, name, ending.number)
        known = letter in draft.context.scalars and not given
        draft.context.scalars[letter] = value
        stays = value in (symbol(name), symbol(f"{name}_dot")) or (name in begun and is_zero(value - begun[name]))
        if not known and not stays:
            rows.append(t.equation(t.Sym(letter), draft.show(value, factor=True, met=ending.state.valid or None)))
            letters[letter] = name
    squared = letters.values() if what == "speed" and ending.state.time is None else ()
    if rows:
        draft.add(f"state.{what}", "end_state", t.system(rows), f"phases.state.{'kept' if given else what}",
                  premises=[step.id for step in given] or draft.those("moment", "place", *(f"square.{name}" for name in squared)),
                  sources=[StepRef(step.id) for step in given],
                  free=PhraseRef("phases.free", {"coefficient": _coefficient(draft, ending), "count": len(rows)}),
                  count=len(rows), is_result=True, data={"ending": ending, "what": what, "letters": letters})  # fmt: skip


def _coefficient(draft: Draft, ending: Ending) -> t.Node:
    """That of the friction of what slips; 0 where nothing does."""
    slips: t.Node = ending.element(draft)["coefficient"] if EVENTS[ending.phase.event].by_friction else t.ZERO
    return slips


def _energy(draft: Draft, ending: Ending) -> None:
    """What kinetic friction has taken by then."""
    if not EVENTS[ending.phase.event].by_friction:
        return
    study, start = draft.study, at_start(draft.study)
    before, after = (kinetic(draft, s.places, s.speeds) for s in (start, ending.state))
    lost = short(before - after)
    letters = [draft.define(draft.free(f"K_{k}"), v) for k, v in ((ending.number - 1, before), (ending.number, after))]
    states = ((study.system, start.places, start.speeds), (study.system, ending.state.places, ending.state.speeds))
    draft.add("energy.taken", "energy_jump", t.equation(t.add(letters[0], t.neg(letters[1])), draft.show(lost, factor=True)),
              "phases.taken", premises=draft.those("state.speed"), is_result=True, data={"states": states})  # fmt: skip


def kinetic(draft: Draft, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Scalar:
    """The kinetic energy of the draft's system in a state."""
    return short(in_state(sum(draft.study.kinetic, NOTHING), places, speeds))


def is_plain(value: Scalar) -> bool:
    """Zero, a number or a single name: there is no need for a name of its own."""
    return value.number() is not None or isinstance(present(value), t.Sym)


def speed_symbol(draft: Draft, coordinate: str, number: int, value: Scalar) -> Scalar:
    """The speed at the end of a phase as it is written in an equation: its value if that is plain, else its letter."""
    name = speed_name(draft, coordinate, number)
    return value if is_plain(value) or name not in draft.context.scalars else symbol(name)


class Ending(Frozen):
    """The end of the phase number `number` (counted from 1) that begins `phase`."""

    phase: Phase
    number: int
    state: ArrivalState

    def element(self, draft: Draft) -> Element:
        """The constraint that it is about."""
        return draft.study.system.element(self.phase.subject)


def place_name(draft: Draft, coordinate: str, number: int) -> str:
    """x_1: the coordinate at the end of phase 1."""
    return draft.free(f"{coordinate}_{number}")


def speed_name(draft: Draft, coordinate: str, number: int) -> str:
    """x_1_dot, or v_1 where the speed is called v."""
    alias = draft.study.problem.notation.get(f"{coordinate}_dot")
    return draft.free(f"{alias}_{number}" if alias else f"{coordinate}_{number}_dot")


def kept_until(draft: Draft, ending: Ending, slip: Scalar) -> list[Step]:
    """The steps; none where what is kept does not give the speeds at the end."""
    found = until_no_slip(draft.study, slip, ending.state)
    for name in draft.study.system.independent if found else ():
        draft.context.scalars[speed_name(draft, name, ending.number)] = ending.state.speeds[name]
    return [_kept_step(draft, ending, kept, slip) for kept in found]


def _kept_step(draft: Draft, ending: Ending, kept: KeptMomentum, slip: Scalar) -> Step:
    letters = draft.study.letters
    point = t.Sym(kept.label or letters.free("C", taken=letters.things))
    rows = [_unchanged(draft, ending, kept.value), t.equation(draft.show(_then(draft, ending, slip)), t.ZERO)]
    return draft.add(f"kept.{kept.label or 'there'}.{'.'.join(kept.bodies)}", "kept_until", t.system(rows),
                     f"phases.until.{'named' if kept.label else 'there'}", bodies=bodies_named(kept.bodies), point=point,
                     place=draft.show_vector(kept.where), silent=_those("phases.quiet", kept.silent, point),
                     cancel=_those("phases.cancel", kept.cancel, point), data={"kept": kept, "ending": ending})  # fmt: skip


def _those(key: str, forces: tuple[Force, ...], point: t.Node) -> PhraseRef:
    names = [t.Vec(name) for name in dict.fromkeys(force.name for force in forces)]
    return PhraseRef(key if names else "torque.none", {"forces": names, "count": len(names), "point": point})


def _unchanged(draft: Draft, ending: Ending, value: Scalar) -> t.Node:
    """L at the end = L at the start, positive where both are negative."""
    value = -value if isinstance(draft.show(value), t.Neg) else value
    begun = by_letters(at_start(draft.study).speeds)
    return t.equation(draft.show(_then(draft, ending, value)), draft.show(substitute(value, begun)))


def _then(draft: Draft, ending: Ending, value: Scalar) -> Scalar:
    """A value at the end, its speeds as letters."""
    names = draft.study.system.independent
    images = {f"{name}_dot": symbol(speed_name(draft, name, ending.number)) for name in names}
    return substitute(substitute(value, images), ending.state.places)
