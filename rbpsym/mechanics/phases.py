"""Motion in phases: the state that ends one is handed over to the next, through impulses if there are any.

At an event the bodies keep their places. Impulses Ĵ change the velocities: m ΔV = Σ Ĵ, I_cm Δω =
Σ r × Ĵ + couples for every body, with the unknown impulses of the constraints that hold afterwards and
of collisions and bounces (n·(v₂' - v₁') = -e n·(v₂ - v₁)); forces that stay finite don't count.
Kleppner & Kolenkow 4.4, 7.6; Meriam & Kraige, Dynamics, 3/12, 6/8.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

from rbpsym.decide.rooted import neat
from rbpsym.elements.interactions import LETTERS
from rbpsym.errors import NotApplicable, StatementError
from rbpsym.expr.tree import Node, Sym, add
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, names_in, short, symbol, without_even_roots
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics import energy
from rbpsym.mechanics.arrivals import ArrivalState, at_start
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.demands import Demand, possible
from rbpsym.mechanics.endings import LAWS
from rbpsym.mechanics.friction import resistances
from rbpsym.mechanics.impulse import STRIKES, Struck, is_holding, restitutions, strike
from rbpsym.mechanics.phase_checks import check_in_place, check_still_slipping, with_senses
from rbpsym.mechanics.pushing import begins
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System, in_state
from rbpsym.present.forms import present
from rbpsym.present.style import Style
from rbpsym.statement.model import Element, Phase, Problem
from rbpsym.statement.scope import CLOCK
from rbpsym.statement.solids import put_into


def shifted(phase: Phase, begins: Scalar | None) -> Problem:
    """The problem of a phase with t counted from its beginning. Raises NotApplicable where that moment has no
    closed form (None) and something is given as a function of the time."""
    problem = phase.problem
    if begins == NOTHING or not any(depends_on(scalar(node), CLOCK) for node in _given(problem)):
        return problem
    if begins is None:
        raise NotApplicable(
            f"no closed form was found for the moment at which the phase “{phase.name}” begins, and in it something is given as "
            f"a function of the time",
            instead="state this phase as a problem of its own.",
        )
    later = {CLOCK: add(present(begins), Sym(CLOCK))}
    parts = ("bodies", "interactions", "constraints")
    return replace(problem, **{part: put_into(getattr(problem, part), later) for part in parts})


def _given(problem: Problem) -> list[Node]:
    found = [node for element in problem.elements for node in element.nodes]
    parts = [part for body in problem.bodies for part in (body.angle, *(body.placed[1] if body.placed else ()))]
    return [*found, *(part for part in parts if part is not None)]


class HandOver(Frozen):
    """How a phase begins, told with the sides and senses of what strikes: the state that ended the one before, the speeds
    after, the impulses, the energy lost in the blow (if there `is_blow`), and that which was taken on the way before (None
    where a force has no potential); what is `asked` of coefficients of restitution, so that no energy is gained, and for
    contacts to be `held`, by their names."""

    phase: Phase
    before: ArrivalState
    speeds: Mapping[str, Scalar]
    impulses: Mapping[str, Scalar]
    energy_lost: Scalar
    energy_taken: Scalar | None = None
    is_blow: bool = True
    asked: tuple[Demand, ...] = ()
    held: Mapping[str, tuple[Demand, ...]] = field(default_factory=dict)


class Stage(Frozen):
    """A phase with its mechanics; `began` is None for the first. `clock` is the time from the start of the first
    phase to its beginning, None where that has no closed form."""

    name: str
    study: Study
    began: HandOver | None = None
    clock: Scalar | None = NOTHING

    @property
    def starts(self) -> tuple[Demand, ...]:
        """What is asked of the parameters for the phase to begin as it is stated."""
        began = self.began
        return (*(() if began is None else (*began.asked, *chain(*began.held.values()))), *begins(self.study))


def followable(parts: Iterable[Stage]) -> tuple[Demand, ...]:
    """What is asked of the parameters for the motion to come to all phases, and for each to begin as it is stated."""
    return tuple(demand for part in parts for demand in (*(part.began.before.valid if part.began else ()), *part.starts))


def stages(problem: Problem) -> tuple[Stage, ...]:
    """All phases. Raises NotApplicable where the end of a phase has no closed form."""
    found, reason = known_stages(problem)
    if reason is not None:
        raise reason
    return found


def known_stages(problem: Problem) -> tuple[tuple[Stage, ...], NotApplicable | None]:
    """The phases up to the first whose end has no closed form, and why it has none."""
    found = [Stage(problem.name, study_of(replace(problem, phases=())))]
    for phase in problem.phases:
        try:
            found.append(_next(found[-1], phase))
        except NotApplicable as reason:
            return tuple(found), reason
    return tuple(found), None


def _next(stage: Stage, phase: Phase) -> Stage:
    study = stage.study
    if study.at_start and phase.event != "at once":
        what = f"no closed form was found for the end of the phase before “{phase.name}”: its motion is known at its start alone"
        raise NotApplicable(what, instead="let the phase begin at once, or state it as a problem of its own.")
    before = LAWS[phase.event].ends(study, phase)
    lost_track = [name for name, value in before.places.items() if value == symbol(name)]
    if lost_track:
        what = f"no closed form was found for {lost_track[0]} at the end of the phase before “{phase.name}”"
        raise NotApplicable(what, instead="state this phase as a problem of its own, or follow it in the simulation.")
    clock = None if stage.clock is None or before.time is None else stage.clock + before.time
    phase = with_senses(study, phase, before)
    problem = shifted(phase, clock)
    firm = tuple(element for element in problem.interactions if element.kind not in LETTERS)  # the others ask how it moves
    placed = type(study)(_started(replace(problem, interactions=firm), study.style, before.places, {}))
    _check(study, phase, placed, before)
    struck: Struck = strike(study.system, placed.system, phase.impulses, before.places, before.speeds)
    speeds, impulses = (
        {name: neat(value, study.assumptions) for name, value in each.items()} for each in (struck.speeds, struck.impulses)
    )
    after = _started(problem, study.style, before.places, speeds)
    lost = _kinetic(study.system, before.places, before.speeds) - _kinetic(placed.system, before.places, speeds)
    lost = neat(lost, study.assumptions)
    is_blow = bool(phase.impulses) or any(not is_zero(value) for value in (lost, *impulses.values()))
    taken = _taken(study, before)
    lost = short(without_even_roots(lost)) if is_blow else NOTHING
    factors = [factor for item in phase.impulses for factor in restitutions(item).values()]
    never = StatementError(f"with what “{phase.name}” begins, a coefficient of restitution is not between 0 and 1")
    asked = possible((Demand(x, ">=") for e in factors for x in (e, 1 - e)), study.assumptions, never)
    held = dict(_held(study, phase, struck, asked, lost)) if is_blow else {}
    began = HandOver(phase, before, speeds, impulses, lost, taken, is_blow, asked, held)
    later = type(study)(after)
    _refuse_struck_resistance(phase, later.system, struck)
    return Stage(phase.name, later if later.at_start and later.ties else study_of(after), began, clock)


def _refuse_struck_resistance(phase: Phase, system: System, struck: Struck) -> None:
    """What a resistance that rests on an unknown force takes in a blow to that force is not said."""
    hit = {name for name, impulse in struck.impulses.items() if not is_zero(impulse)}
    for name, found in resistances(system).items():
        if hit & names_in(found.push):
            element = system.element(name)
            raise StatementError(
                f"in the blow with which “{phase.name}” begins, “{name}” would have an impulse of its own, for its size rests on "
                f"{min(hit & names_in(found.push))}",
                instead="let it act from a phase after the blow on.",
                place=element.place,
            )


def _held(
    study: Study, phase: Phase, struck: Struck, asked: tuple[Demand, ...], lost: Scalar
) -> Iterator[tuple[str, tuple[Demand, ...]]]:
    """What is left of what contacts ask for in a blow, by their names. Raises StatementError for what is never met."""
    for element in (*phase.impulses, *phase.problem.constraints):
        gain = [Demand(lost, ">=")] if is_holding(element) else []
        left = possible([*asked, *struck.asked[element.name], *gain], study.assumptions, _not_so(element))
        yield element.name, tuple(demand for demand in left if demand not in asked)


def _not_so(element: Element) -> StatementError:
    what = "would have to pull, to hold by more friction than there is, or to slip the other way"
    return StatementError(
        f"in the blow the {element.kind} “{element.name}” {what}",
        instead="check the side, the sense of the slip (slip = “none” where it does not slip as they part), and the speeds.",
        place=element.place,
    )


def _taken(study: Study, end: ArrivalState) -> Scalar | None:
    """The energy at the start of a phase less that at its end."""
    if study.potential is None or study.system.has_clock:
        return None
    total, start = sum(study.kinetic, study.potential), at_start(study)
    first, last = (in_state(total, state.places, state.speeds) for state in (start, end))
    return short(without_even_roots(first - last))


def _check(study: Study, phase: Phase, placed: Study, before: ArrivalState) -> None:
    """Raises StatementError if the phase can't begin so."""
    check_still_slipping(study, phase, before)
    check_in_place(study, phase, placed, before)
    for element in phase.impulses:
        STRIKES[element.kind].check(study, element, before, placed.system)


def _started(problem: Problem, style: Style, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Problem:
    """The problem with these starts."""
    starts = {name: present(value, style, factor=True) for name, value in places.items()}
    rates = {name: present(value, style, factor=True) for name, value in speeds.items()}
    coordinates = tuple(replace(c, start=starts[c.name], speed=rates.get(c.name)) for c in problem.coordinates)
    return replace(problem, coordinates=coordinates)


def _kinetic(system: System, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Scalar:
    return in_state(sum(energy.kinetic_energy(system), NOTHING), places, speeds)
