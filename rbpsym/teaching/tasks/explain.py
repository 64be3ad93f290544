"""Explain: an open question about a step, with a rubric of what the derivation uses there."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from rbpsym.derivation.step import Step
from rbpsym.document.model import Display, Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, sentence
from rbpsym.teaching.lines import WEIGHTS, gist, shares
from rbpsym.teaching.model import Asked, Criterion, ExplanationKey, Item
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, claims
from rbpsym.teaching.tasks.wish import Wish
from rbpsym.teaching.wording import spoken

# rule -> how interesting a “why” it is; others are not asked
QUESTIONS = {"workless": 3, "work_energy": 2, "combination": 3, "conservation": 2, "torque": 1, "parallel_axis": 1}
MOST_PREMISES = 3
CONCLUSION = 3  # the least weight of putting the premises together, on the scale of `lines.WEIGHTS`


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a step that has a reason and premises; `about` names ids of steps."""
    steps = [s for s in bench.derivation.steps if _interest(s) and _premises(bench, s)]
    named = [s for s in steps if not wish.about or any(s.id == a or s.id.startswith(f"{a}.") for a in wish.about)]
    if not named and wish.at is not None:
        ids = ", ".join(s.id for s in steps)
        raise wish.error(
            f"“{bench.name}” has no step “{', '.join(wish.about)}” to be explained",
            f"steps that can be asked: {ids}." if ids else "choose another kind of task.",
        )
    for step in sorted(named, key=lambda s: -_interest(s)):
        make = partial(_item, bench, wish, step)
        yield Prepared("explain", None, (), make, Content(claims((step.statement,))))


def _interest(step: Step) -> int:
    """How interesting it is; of the works only a result (equal halves) is asked for."""
    return 3 if step.rule == "work" and step.is_result else QUESTIONS.get(step.rule, 0)


def _premises(bench: Bench, step: Step) -> list[Step]:
    """What it stands on, the last first named; at most so many."""
    return [bench.derivation.step(id) for id in step.reasons][:MOST_PREMISES]


def _item(bench: Bench, wish: Wish, step: Step, setting: Setting) -> Item:
    premises = _premises(bench, step)
    usual, sample = 1 + len(premises), tuple(_sample(bench, setting, step, premises))
    prompt = (Paragraph(spoken(setting.said, "ask.explain")), Display(step.statement, numbered=False))
    asked = Asked(bench.name, step.id, t.Sym("W"), step=step.id)
    rubric = _rubric(setting, step, premises, wish.worth(usual))
    return wish.item(setting, asked, prompt, ExplanationKey(sample), usual, rubric=rubric, solution=sample, space=5)


def _sample(bench: Bench, setting: Setting, step: Step, premises: list[Step]) -> Iterator[Paragraph | Display]:
    for premise in premises:
        yield Display(premise.statement, numbered=False)
    why = sentence(bench, step, setting.said)
    if why:
        yield Paragraph(why)
    yield Display(step.statement, numbered=False)


def _rubric(setting: Setting, step: Step, premises: list[Step], points: Fraction) -> Iterator[Criterion]:
    """A line for each thing that it stands on and one for putting them together, by how much each step matters."""
    earned = shares(points, [*map(_weight, premises), max(CONCLUSION, _weight(step))])
    for share, premise in zip(earned, premises, strict=False):
        uses = spoken(setting.said, "rubric.uses", statements=gist(premise.statement))
        yield Criterion(share, uses, premise.statement)
    yield Criterion(earned[-1], spoken(setting.said, "rubric.concludes"))


def _weight(step: Step) -> int:
    return max(1, WEIGHTS.get(step.rule, 0))
