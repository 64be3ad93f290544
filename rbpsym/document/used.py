"""What of a derivation a page needs: what it concludes, and what leads there. All else is shown at full detail only."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Set

from rbpsym.ask.asking import Refused, own_answers
from rbpsym.ask.found import Answer
from rbpsym.chapters.methods.newton_euler import EACH_BODY
from rbpsym.document.needless import is_struck
from rbpsym.expr import tree as t
from rbpsym.proof.step import STANDARD, Derivation, DerivedPhase, Step

# by chapter, the rules of steps that are conclusions though they stand in no box: what ties the coordinates, the motion,
# whether contacts last
CONCLUSIONS: Mapping[str, Collection[str]] = {
    "kinematics": ("constraint", "no_slip", "taut", "tied"),
    "motion": ("solution", "conservation"),
    "contact": ("substitution", "stays", "inequality", "vanishing", "value_there", "asked", "identity"),
    "oscillations": ("normal_modes", "mode_shape", "hurwitz", "motion_of_mode", "open_balance"),
}
# of the works, where a force works on the translation of a body and on its rotation: else the two halves show nothing that
# the energy of the whole does not
IN_HALVES = ("work_energy", "work_together", "work_integral", "conservation", "power")
REPEATED = ("work.alone",)  # works body by body lead to the energy of the whole, which has a chapter of its own


def used(derivation: Derivation, whole: Derivation) -> frozenset[str]:
    """Ids of the steps that are conclusions, or from which the next phase begins, and of all that they rest on or refer to.
    What is asked is asked of the `whole` motion."""
    both = _in_both_parts(derivation)
    asked = _asked(whole)
    ends = [step.id for step in _ends(derivation, both, asked)]
    if asked is not None and derivation is not whole and not any(s.statement in asked for s in derivation.chapter("energy")):
        ends = [id for id in ends if derivation.step(id).chapter != "energy"]  # of a later phase what is asked alone
    ends += [id for phase in derivation.phases[:1] for step in phase.begins for id in step.reasons]
    steady = () if is_struck(derivation.study) else filter(solved_zero, derivation.chapter("motion"))
    ends += [id for step in steady for id in step.reasons]
    return led_to(derivation.steps, ends)


def used_to_begin(phase: DerivedPhase, whole: Derivation) -> frozenset[str]:
    """Of the steps by which a phase begins those that are needed: by the last one only what leads to an answer, and the energy
    that is lost; all where nothing of it is asked, or what comes after."""
    stated = {each.value for each in whole.study.problem.phases}  # a place that is said to be reached
    places = [step for step in phase.begins if step.phrase in ("phases.state.place", "phases.place.value")]
    told = [step.id for step in places if {row.items[-1] for row in t.rows(step.statement)} <= stated]
    ids = frozenset(step.id for step in phase.begins).difference(told)
    asked = None if phase is not whole.phases[-1] or reaches_beyond(whole) else _asked(whole)
    ends = [step.id for step in phase.begins if step.statement in (asked or ())]
    lost = [step.id for step in phase.begins if step.rule == "energy_jump"]
    return ids.intersection([*led_to(phase.begins, ends), *lost]) if ends else ids


def reaches_beyond(whole: Derivation) -> bool:
    """May a question reach beyond the beginnings of the later phases?"""
    answers = [found for found in own_answers(whole.study) if not isinstance(found, Refused)]
    return not answers or any(_meet(found, phase.derivation) for found in answers for phase in whole.phases)


def _meet(answer: Answer, phase: Derivation) -> bool:
    """Is a step of the answer one of this very phase?"""
    own = {step.id for step in phase.steps}
    return answer.study.system == phase.study.system and any(step.id in own for step in answer.steps)


def _asked(whole: Derivation) -> frozenset[t.Node] | None:
    """What those steps say from which the answers to a problem's own questions follow; None where none is asked or answered."""
    answers = tuple(own_answers(whole.study))
    answered = [found for found in answers if not isinstance(found, Refused)]
    if not answered or len(answered) < len(answers):
        return None
    return frozenset(step.statement for found in answered for step in found.steps)


def _ends(derivation: Derivation, both: Collection[str], asked: Collection[t.Node] | None) -> list[Step]:
    """The conclusions: where a blow at the start ends the motion there are none, where the whole motion is given its energy,
    from which no speed follows, is none, nor are small oscillations if all else is asked; of the unknown forces those that are
    asked for, that vanish altogether, or by which a contact pushes."""
    if is_struck(derivation.study):
        return [*derivation.chapter("inertia"), *(step for step in derivation.steps if step.statement in (asked or ()))]
    system = derivation.study.system
    is_given = not system.independent
    without = {"energy"} if system.has_clock and is_given else set()
    if asked is not None and (is_given or all(solved_zero(step) for step in derivation.chapter("motion") if step.is_result)):
        without |= {"work", "energy"}  # of a motion that is given, or goes on as it is, nothing but what is asked
    if asked is not None and not any(step.statement in asked for step in derivation.chapter("oscillations")):
        without.add("oscillations")
    again = retold(derivation)
    found = (step for step in derivation.steps if step.chapter not in without and step.id not in again)
    told = ("forces", "work" if both else "") if len(system.bodies) == 1 else ()  # of one body every force, and what it does
    named = {name for e in derivation.study.problem.constraints for name in (e.name, e.values.get("friction"))}  # no components
    return [s for s in found if _is_end(s, both, asked, named) or (s.chapter in told and s.rule in LEDGER)]


def _is_end(step: Step, both: Collection[str], asked: Collection[t.Node] | None, named: Set[object]) -> bool:
    if step.phrase in FORCES:
        is_none = all(row.items[-1] == t.ZERO and t.names(row.items[0]) <= named for row in t.rows(step.statement))
        return asked is None or step.statement in asked or is_none or (step.is_result and step.chapter == "contact")
    return step.is_result or (step.level <= STANDARD and _concludes(step, both))


LEDGER = ("torque", "force", "work")
# what an unknown force is
FORCES = ("newton_euler.reaction", "newton_euler.known", "newton_euler.settled", "contact.along", "contact.other_force")


# of the works, what the chapter on the energy says once more of the whole
OF_THE_WHOLE = ("work.together.", "work.alone", "work.theorem.whole", "work.axis")


def retold(derivation: Derivation) -> frozenset[str]:
    """Ids of steps that say what others on the page do: the energy of the whole in terms of works, the rate at which it is
    lost, of several bodies the works of forces that turn none, the balances of a body from which the motion was found, that
    something does not accelerate of which the balance is zero."""
    ends = {row.items[-1] for step in derivation.chapter("energy") if step.is_result for row in t.rows(step.statement)}
    is_kept = any(step.id == "energy" for step in derivation.steps)
    phrases = (*OF_THE_WHOLE, "work.theorem.") if is_kept else OF_THE_WHOLE
    works = derivation.chapter("work") if derivation.chapter("energy") else ()
    same = {s.id for s in works if s.rule == "power" and t.rows(s.statement)[0].items[-1] in ends}
    again = [s.id for s in works if s.phrase.startswith(phrases) or s.id in same]
    if is_kept and len(derivation.study.system.bodies) > 1:
        turning = {step.id.split(".")[1] for step in works if step.rule == "work" and _turns(step)}
        again += [s.id for s in works if s.rule in ("work", "workless") and s.id.split(".")[1] not in turning]
    again += [s.id for s in derivation.chapter("reactions") if _is_balanced(s, derivation)]
    again += [s.id for s in derivation.chapter("motion") if solved_zero(s) and len(s.slots["sources"]) == 1]
    return frozenset(again)


def solved_zero(step: Step) -> bool:
    """Does a coordinate not accelerate, as the balance says from which that follows?"""
    return step.phrase == "torque.solved_zero"


def _turns(step: Step) -> bool:
    """Does a force do work on the rotation of a body?"""
    rows = (row.items for row in t.rows(step.statement) if t.ZERO not in row.items)
    return any(name.startswith("cal_W_theta") for first, *_ in rows for name in t.names(first))


ABOUT_CENTRE = ("torque.balance.center", "torque.balance.center.some", "torque.balance.level")


def _is_balanced(step: Step, derivation: Derivation) -> bool:
    """Are Newton's and Euler's equations of a body those from which the motion was found?"""
    body = step.id.partition(".")[2]
    found = (s for s in derivation.chapter("motion") if s.id.startswith(("push.", "balance.")) and s.id.endswith(f".{body}"))
    own = [s for s in found if s.id.startswith("push.") or s.phrase in ABOUT_CENTRE]
    return step.phrase in EACH_BODY and len(own) == len(t.rows(step.statement))


def led_to(steps: Iterable[Step], ends: Iterable[str]) -> frozenset[str]:
    """Ids of the steps with which one ends, and of all those of the given ones that they rest on or refer to."""
    by_id, found, left = {step.id: step for step in steps}, set(), [*ends]
    while left:
        id = left.pop()
        if id in by_id and id not in found:
            found.add(id)
            left += leading(by_id[id])
    return frozenset(found)


def leading(step: Step) -> tuple[str, ...]:
    """Ids of what leads to a step on a page: to an unknown force what it follows from, to others what they tell of as well."""
    return step.premises if step.phrase in FORCES[:3] else step.reasons


def _concludes(step: Step, both: Collection[str]) -> bool:
    if step.chapter != "work":
        return step.rule in CONCLUSIONS.get(step.chapter, ())
    return bool(both) and step.rule in IN_HALVES and not step.phrase.startswith(REPEATED) and not _is_nothing(step)


def _in_both_parts(derivation: Derivation) -> frozenset[str]:
    """The forces on bodies that work on the translation and on the rotation."""
    works = (step for step in derivation.chapter("work") if step.rule == "work")
    return frozenset(s.id.partition(".")[2] for s in works if len(t.rows(s.statement)) > 1 and not _is_nothing(s, any))


def _is_nothing(step: Step, of: Callable[[Iterable[bool]], bool] = all) -> bool:
    """Something is zero, in each row, or in any."""
    return of(t.ZERO in row.items for row in t.rows(step.statement))
