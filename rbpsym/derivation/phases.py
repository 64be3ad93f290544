"""The later phases of a motion: for each the steps by which it begins."""

from __future__ import annotations

from rbpsym.derivation.chapters import endings, impulses
from rbpsym.derivation.chapters.blow import Blow
from rbpsym.derivation.chapters.ending import Ending
from rbpsym.derivation.draft import Draft
from rbpsym.mechanics.phases import Stage, stages
from rbpsym.statement.model import Phase, Problem


def hand_overs(problem: Problem) -> list[tuple[Phase, Stage, Draft]]:
    """Each later phase, its mechanics, and the draft of the steps from the end of the one before to its start.

    Raises NotApplicable where the end of a phase has no closed form.
    """
    all_stages = stages(problem)
    rows = zip(problem.phases, all_stages, all_stages[1:], strict=False)
    return [(phase, stage, hand_over(k, phase, before, stage)) for k, (phase, before, stage) in enumerate(rows, 1)]


def hand_over(number: int, phase: Phase, before: Stage, stage: Stage) -> Draft:
    """The draft of the steps from the end of the phase of that number (from 1) to the start of the next one."""
    draft = Draft(before.study)
    draft.chapter = "phase"
    endings.write(draft, Ending(phase, number, stage.began.before))
    if stage.began.is_blow:
        impulses.write(draft, Blow(before.study.system, stage.study.system, stage.began.phase, stage.began, number))
    return draft
