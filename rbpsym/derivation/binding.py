"""Which premises a step needs: the least that its checks ask for, of what was said before it.

The author of a step names what a reader should look at. Premises are those of these, and of the definitions, laws,
starts and ranges, without which the step is not proved; what is named and not needed stays as `cites`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from rbpsym.derivation.context import Context
from rbpsym.derivation.facts import MOTION
from rbpsym.derivation.letters import fixed, introducers
from rbpsym.derivation.rules import examined
from rbpsym.derivation.step import Step
from rbpsym.equality.decide import proofs_alone
from rbpsym.notation import tree as t

TELLS_MOTION = ("solution", "first_integral", "substitution")  # rules of steps that say what the motion is
SIGNED = ("vanishing", "equilibrium")  # rules that decide signs on ranges: costly where they fail
MOST_LAWS = 6  # of so many single laws it is tried whether they do


def bound(context: Context, step: Step, named: Iterable[str]) -> Step:
    """The step with its premises, what else its author cites, and its certificate."""
    named = tuple(dict.fromkeys(named))
    with proofs_alone():
        found, used, kept = None, set(), _needed(context, step, named, hasty=True)
    if kept is not None:
        found, used = examined(context, step, kept)
    if kept is None or not found.verdict.is_proved or set(kept) - used:  # numbers mislead: the long way
        with proofs_alone():
            kept = _needed(context, step, named, hasty=False)
        found = None if kept is None else examined(context, step, kept)[0]
    if kept is None:
        kept, (found, _) = named, examined(context, step, _widest(context, step, named))
    context.rests[step.id] = frozenset(introducers(context, [step.statement])) | fixed(context)
    return replace(step, premises=kept, cites=tuple(id for id in named if id not in kept), certificate=found)


def _needed(context: Context, step: Step, named: tuple[str, ...], *, hasty: bool) -> tuple[str, ...] | None:
    """The least of the first set of premises with which it is proved; None if it is with none."""
    for level in _levels(context, step, named):
        found, used = examined(context, step, level, hasty=hasty)
        if found.verdict.is_proved:
            return _irredundant(context, step, tuple(id for id in level if id in used), hasty=hasty)
    return None


def _widest(context: Context, step: Step, named: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(id for level in _levels(context, step, named) for id in level))


def _levels(context: Context, step: Step, named: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Sets of premises to try, from what is nearest to the whole of the laws; ranges where more or less is asserted."""
    ranges = tuple(id for id, fact in context.facts.items() if fact.kind == "range")
    laws = [id for id, fact in context.facts.items() if fact.kind == "law" and fact.subject]
    letters = introducers(context, [step.statement])
    said = introducers(context, [context.steps[id].statement for id in named if id in context.steps])
    works = {id for name, (id, _) in context.introduced.items() if name in context.works}
    told = [id for id, other in context.steps.items() if other.rule in TELLS_MOTION]
    near = (*named, *letters, *sorted(fixed(context)))
    quiet = [id for id in said if id not in works]
    few = [*quiet, *laws] if len(laws) <= MOST_LAWS else []
    steps_up = ((), quiet, said, few, (*said, *told), (MOTION,), (*said, *told, MOTION))
    if step.rule in SIGNED or any(op != "=" for _, op, _ in t.relations(step.statement)):
        steps_up = tuple((*more, *ranges) for more in ((), (*said, *told), (*said, *told, MOTION)))
    tried = set()
    for more in (*steps_up, (*said, *told, MOTION, *ranges)):
        level = tuple(dict.fromkeys((*near, *more)))
        if frozenset(level) not in tried:
            tried.add(frozenset(level))
            yield level


def _irredundant(context: Context, step: Step, premises: tuple[str, ...], *, hasty: bool) -> tuple[str, ...]:
    """Without those that the step is proved without."""
    for id in reversed(premises):
        if id in premises:
            found, used = examined(context, step, tuple(other for other in premises if other != id), hasty=hasty)
            if found.verdict.is_proved:
                premises = tuple(other for other in premises if other in used)
    return premises
