"""Which sentences assert something of a system, and what has to be proved before they are said.

A key stands for all that is below it, and for its variants `_again`, `_known` and `_unseen`. Each key of the phrase
files is told in exactly one of `ASSERTIONS` and `NARRATION` (a test says so). Where the condition is refuted or not
decided, the other sentence of the entry is said, if its own condition holds; "" means that nothing is said.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.errors import RbpsymError
from rbpsym.field import at_most
from rbpsym.frozen import replace
from rbpsym.proof import grounds as g
from rbpsym.proof import grounds_works as w
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import PhraseRef, Step

Condition = Callable[[Said], bool]
Entry = tuple[Condition, str]
MOST_PRODUCTS = 100_000

IDENTITY = "pivot pin weld contact guide slider sticking distance string prescribed prescribed-angle other"
CHAPTERS = """
ask course kinematics inertia instant momentum torque newton_euler work energy oscillations contact phases comparison remark
statics theory
"""
RESTING = """
oscillations.stable oscillations.asymptotic oscillations.unstable oscillations.unclear oscillations.undecided
"""
SETTLED = "stable asymptotic frequency frequency_undamped"
MANY = ("position", "velocity", "speed", "turning", "dependent", "tied_speed", "acceleration", "spin_up", "centre")

STEPS: Mapping[str, Entry] = {
    **dict.fromkeys(CHAPTERS.split(), (g.is_proved, "")),  # what says no more than its formula
    **{f"kinematics.condition.{kind}.identity": (g.is_identity, "") for kind in IDENTITY.split()},
    "kinematics.condition.sticking_speed.moving": (g.touching_body_moves, "kinematics.condition.sticking_speed.fixed"),
    "kinematics.dependent": (g.ties_to_others, "kinematics.determined"),
    "kinematics.dependent.balance": (g.places_no_mass, "kinematics.determined"),
    "kinematics.orbit": (g.is_steady, ""),
    "kinematics.turning.opposite": (g.is_turned_back, "kinematics.turning.plain"),
    "kinematics.turning.none": (g.does_not_turn, "kinematics.turning.plain"),
    "inertia.steiner": (g.turns_about_point, ""),
    "inertia.together": (g.turns_about_point, ""),
    "momentum.orbital": (g.is_orbital, "momentum.both"),
    "momentum.spin": (g.is_spin, "momentum.both"),
    "torque.projected": (g.is_without_unknowns, ""),
    "torque.silent": (g.silent_forces_drop_out, "torque.none"),
    "torque.solved_zero": (g.ends_in_zero, ""),
    "torque.added": (g.acts_at_same_points, "torque.added_along"),
    "torque.added_along": (g.is_without_unknowns, ""),
    "torque.free": (g.no_force_acts_along, "torque.even"),
    "torque.net.contact": (g.point_moves, "torque.net.resting"),
    "torque.net.moving": (g.point_moves, "torque.net.resting"),
    "torque.net.crossing": (g.all_lines_meet, "torque.net.two"),
    "torque.balance.center.some": (g.starts_to_turn, "torque.balance.level"),
    "torque.balance.moving": (g.point_moves, "torque.balance.resting"),
    "torque.balance.crossing": (g.point_moves, "torque.balance.resting"),
    "newton_euler.reaction": (g.is_of_position_and_speed, "newton_euler.known"),
    "work.cancels": (w.works_cancel, "work.cancelled"),
    "work.cancels.grip": (w.works_cancel_as_points_move_together, "work.cancelled"),
    "work.cancels.grip.one": (w.takes_from_centre, "work.cancels.grip.back"),
    "work.cancels.grip.back": (w.gives_to_centre, "work.cancels.grip.open"),
    "work.cancels.grip.open": (w.works_cancel_as_points_move_together, "work.cancelled"),
    "work.cancels.joint": (w.works_cancel_as_points_move_together, "work.cancelled"),
    "work.dissipated.damper": (g.is_never_positive, "work.drawn"),
    "work.dissipated.friction": (w.works_do_not_cancel, "work.drawn"),
    "work.dissipated.resistance": (w.works_do_not_cancel, "work.drawn"),
    "work.theorem.whole.cancelled": (w.some_works_cancel, "work.theorem.whole.all"),
    "work.added": (w.conserved_energy_is_handed_on, "work.summed"),
    "work.summed": (w.work_is_handed_on, "work.dropped"),
    "work.together.rotational": (w.rotational_work_is_opposite, "work.together.others_too"),
    "work.together.others_too": (w.common_work_is_not_zero, "work.together.opposite"),
    "work.together.energy": (w.common_work_is_not_zero, "work.together.constant"),
    "work.together.turned": (w.does_not_turn_at_start, "work.together.grown"),
    "energy.conserved": (w.energy_is_conserved, ""),
    "energy.conserved.free": (w.no_force_acts, ""),
    "energy.effective": (w.work_is_of_position, ""),
    "energy.changes": (g.ends_otherwise, "energy.rated"),
    "energy.square": (w.does_not_stay, "energy.square_resting"),
    "energy.square_alone": (w.acceleration_is_of_position_and_does_not_stay, "energy.square_alone_resting"),
    "energy.square_alone_resting": (w.acceleration_is_of_position, "energy.square_own"),
    "energy.square_own": (w.acceleration_is_alone_and_does_not_stay, "energy.square_own_resting"),
    "energy.square_own_resting": (w.acceleration_is_alone, ""),
    "energy.rate": (w.energy_has_no_drive, "energy.rate_relative"),
    "energy.kinetic": (w.turns_and_moves, "energy.kinetic_plain"),
    "energy.potential.force": (w.is_constant_action, "energy.potential.other"),
    "energy.potential.couple": (w.is_constant_action, "energy.potential.other"),
    **dict.fromkeys(RESTING.split(), (g.is_proved, "oscillations.doubtful")),
    **{f"oscillations.{said}.alone": (g.is_one_place, f"oscillations.{said}.among") for said in SETTLED.split()},
    "contact.along": (g.is_of_position, "contact.known"),
    "contact.lost.place": (g.nothing_slips, "contact.lost_without_slip.place"),
    "contact.lost.first": (g.nothing_slips, "contact.lost_without_slip.first"),
    "contact.endless": (g.no_friction_is_enough, "contact.ratio"),
    "phases.quiet": (g.forces_have_no_torque, "torque.none"),
    "phases.cancel": (g.torques_cancel, "torque.none"),
    "phases.free": (g.is_free_of_coefficient, "torque.none"),
    "phases.silent.inner": (g.impulses_cancel, "torque.none"),
    "phases.silent": (g.impulses_drop_out, "torque.none"),
    "phases.slip": (g.touching_body_moves, "phases.slip_between"),
    "phases.slip_rate": (g.is_steady, "phases.slip_rated"),
    "phases.taken": (w.only_friction_works, "phases.fallen"),
    "phases.lost.some": (w.energy_is_lost, "phases.lost.change"),
    "comparison.spin.free": (g.ends_in_zero, ""),
    "skipped.no_freedom": (lambda said: not said.system.independent, ""),
    "skipped.no_forces": (lambda said: not said.system.forces, ""),
    "skipped.not_conserved": (lambda said: said.study.first_integral is None, ""),
    "skipped.driven": (lambda said: said.system.has_clock, ""),
    "skipped.one_equation": (lambda said: len(said.system.independent) > 1, ""),
}


def _all(key: str) -> Condition:
    """Each of the steps is told by a sentence under the key, so that its condition holds."""
    return lambda said: bool(said.steps) and all(f"{step.phrase}.".startswith(f"{key}.") for step in said.steps)


PAGES: Mapping[str, Entry] = {
    "statement.vertical": (w.all_move_in_vertical_plane, "statement.upright"),
    "statement.upright": (w.moves_in_vertical_plane, "statement.plane"),
    "statement.plane": (w.all_move, "statement.flat"),
    "statement.flat": (w.can_move, "statement.held"),
    "statement.held": (w.rests_in_vertical_plane, "statement.held_flat"),
    "statement.rolling": (w.can_move, "statement.rolling_still"),
    "statement.still": (w.is_still, ""),
    "statement.driven": (w.is_driven, ""),
    "statement.rest": (w.leaves_rest, "statement.rest_there"),
    "statement.rest_there": (w.stays_at_rest, "statement.begins"),
    **{f"kinematics.{kind}_many": (_all(f"kinematics.{kind}"), "") for kind in MANY},
    "instant.intro": (lambda said: said.study.at_start, ""),
    "released": (lambda said: not any(said.system.scope.start.get(speed) for speed in said.system.speeds), ""),
    "oscillations.intro": (w.is_not_carried, "oscillations.carried"),
    "oscillations.brief": (w.is_not_carried, "oscillations.carried"),
    "newton_euler.rest.intro": (w.is_still, ""),
    "newton_euler.driven.intro": (w.is_driven, ""),
    "newton_euler.reactions": (_all("newton_euler.reaction"), ""),
    "torque.solved_all": (_all("torque.solved"), ""),
    "torque.solved_zero_all": (_all("torque.solved_zero"), ""),
    "work.idle": (_all("work.none"), ""),
    "work.cancel_all": (_all("work.cancels"), "work.cancelled_all"),
    "work.done_intro": (w.all_works_are_done, "work.done_some"),
    "work.done_below": (w.all_works_are_done, "work.done_some_below"),
    "work.theorem.half": (g.nothing_turns, "work.theorem.halves"),
    "contact.along_all": (_all("contact.along"), ""),
    "contact.along_plain": (_all("contact.along"), ""),
    "contact.constant": (_all("contact.along"), ""),
    "contact.lasts.contact_many": (_all("contact.asks"), ""),
    "contact.lasts.string_many": (_all("contact.asks"), ""),
    "contact.other_forces": (_all("contact.other_force"), ""),
    "oscillations.unstable_many": (_all("oscillations.unstable"), ""),
    "caption.checks": (w.most_are_checked_twice, "caption.checked"),
    "question.proved": (lambda said: not said.steps or w.all_steps_are_proved(said), ""),
    "checks.short": (w.all_steps_are_proved, ""),
    "checks.all": (w.all_steps_are_proved, ""),
    "checks.course": (w.all_steps_are_proved, ""),
    "checks.course_short": (w.all_steps_are_proved, ""),
    "checks.roads": (w.is_confirmed, ""),
    "checks.methods": (w.methods_agree, "checks.differ"),
    "checks.differ": (w.methods_differ, "checks.open"),
    "checks.lagrange.PROVED": (w.lagrange_agrees, ""),
    "checks.simulation": (w.simulation_agrees, "checks.simulation_differs"),
}

ASSERTIONS: Mapping[str, Entry] = {**STEPS, **PAGES}

NARRATIVE = """
block bodies body callout caption checked checks.lagrange checks.open checks.simulation_differs checks.some
dimension explorer figure forces functions grammar growth header index it latex library line list method notation
notebook number obligation own_text party question part plain plots point ref results roads section shape skipped spoken statement
symbols twin verdict word
kinematics.intro kinematics.nothing kinematics.circle kinematics.on kinematics.speed_of_centre inertia.intro
momentum.intro torque.intro torque.none torque.settled newton_euler.alone newton_euler.brief newton_euler.intro
newton_euler.short work.short work.short_below
newton_euler.reactions_rest newton_euler.solved_many work.intro work.intro_below work.integrals work.none
work.done_some work.done_some_below work.theorem.body work.theorem.halves work.theorem.halves_each work.cancelled_all
phases.blow phases.impulses_then
phases.clock phases.event phases.impulses phases.same_motion phases.title oscillations.carried oscillations.doubtful
oscillations.place comparison.figure comparison.intro comparison.title comparison.because theory.figure theory.intro
theory.heading
"""  # names things, says what is done next, repeats the statement
NARRATION = frozenset(NARRATIVE.split())

ELSEWHERE: Mapping[str, str] = {
    "tutor": "studio.tutor.TELLS",  # what is said of a student's line, by who judged it
    "sentence": "document.translated.translated",  # what the engine says, by who said it
}

LATER = ("_unseen", "_again", "_known")


def base(key: str) -> str:
    """The key without what says that it is said again, or of what is seen elsewhere."""
    head, dot, tail = key.partition(".")
    while any(head.endswith(mark) for mark in LATER):
        head = head.rpartition("_")[0]
    return head + dot + (base(tail) if tail else "")


def entry(key: str) -> Entry | None:
    """What is told of the longest part of a key that stands in one of the tables; None for narration."""
    parts = base(key).split(".")
    stems = [".".join(parts[:k]) for k in range(len(parts), 0, -1)]
    found = next((stem for stem in stems if stem in ASSERTIONS or stem in NARRATION), "")
    return ASSERTIONS.get(found)


def settled(key: str, said: Said, variant: object = "") -> str:
    """The sentence itself if it is true, else the one that is true without the condition; "" if there is none."""
    while key and (found := entry(f"{key}.{variant}" if variant else key)):
        if _holds(found[0], said):
            return key
        key = found[1]
    return key


def _holds(condition: Condition, said: Said) -> bool:
    """What cannot be decided does not hold."""
    try:
        with at_most(MOST_PRODUCTS):
            return bool(condition(said))
    except (RbpsymError, ZeroDivisionError):
        return False


NOTHING_ELSE = Said()


def told(step: Step, said: Said = NOTHING_ELSE) -> Step:
    """The step with a sentence that is true of it."""
    said = replace(said, step=step)
    slots = {name: _silenced(value, said) for name, value in step.slots.items()}
    return replace(step, phrase=settled(step.phrase, said, step.slots.get("variant", "")), slots=slots)


def _silenced(value: object, said: Said) -> object:
    """A sentence in a slot, or none in its place."""
    return replace(value, key=settled(value.key, said) or "torque.none") if isinstance(value, PhraseRef) else value


def on_page(key: str, ground: Said | None) -> str:
    """The sentence of a page that is true on its ground; KeyError for one that asserts something and has none."""
    if base(key) not in PAGES:
        return key
    if ground is None:
        raise KeyError(f"“{key}” asserts something of a system, and is said of none")
    return settled(key, ground)
