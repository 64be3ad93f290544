"""Steps as paragraphs and displays: each in its own words, or several under one sentence and one number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rbpsym.derivation.assertions import Said
from rbpsym.derivation.step import Derivation, Step, StepRef
from rbpsym.document.breaking import lines
from rbpsym.document.model import Block, Display, Inlines, Paragraph, Text
from rbpsym.document.tables import relations
from rbpsym.document.words import Words
from rbpsym.notation import tree as t

MOST_ROWS = 6  # formulas under one number
MOST_LINES = 12
COLUMN = 36.0  # em: about the width of a page


class Teller:
    """Says steps one after the other: what was said before is said shorter, what was shown is referred to."""

    def __init__(self, said: Words) -> None:
        self.said = said
        self.before: set[str] = set()

    def steps(self, steps: Iterable[Step]) -> Iterator[Block]:
        """Sentence and formula in turn."""
        for step in steps:
            yield from self.step(step)

    def step(self, step: Step) -> Iterator[Block]:
        """The sentence of a step and its formula; only a sentence if the formula was shown already."""
        known = self.said.same.get(step.id)
        text = self.sentence(step, f"{step.phrase}_known" if known else step.phrase, **step.slots)
        if text:
            yield Paragraph(text)
        if known is None:
            yield display(step, self.said)
        yield from self.conditions([step])

    def conditions(self, steps: Sequence[Step]) -> Iterator[Block]:
        """As long as what is not implied by the declared signs and ranges the formulas hold."""
        owed = dict.fromkeys(node for step in steps for node in self.said.owed.get(step.id, ()))
        if owed:
            yield Paragraph(self.said.say("obligation.holds", conditions=list(owed), count=len(steps)))

    def sentence(self, step: Step, key: str, **slots: object) -> Inlines:
        """What is said before a step, in the variant for a second time if there is one."""
        found = known_key(key, self.said)
        if found is None:
            return ()
        if self.said.has(f"{found}_unseen") and any(self.said.are_unseen(value) for value in slots.values()):
            found = f"{found}_unseen"
        again = f"{found}_again"
        chosen = again if found in self.before and self.said.has(again) else found
        self.before.add(found)
        known = self.said.same.get(step.id)
        text = self.said.say(chosen, **slots, **({"first": StepRef(known)} if known else {}))
        return text if any(not isinstance(i, Text) or i.text.strip() for i in text) else ()

    def together(self, steps: Sequence[Step], key: str, **slots: object) -> Iterator[Block]:
        """Steps of one kind under one sentence and one number; a single one in its own words."""
        if len(steps) < 2:
            yield from self.steps(steps)
            return
        yield Paragraph(self.said.say(key, ground=Said(steps=steps), count=len(steps), **slots))
        if is_tall(steps, self.said):
            yield from (display(step, self.said) for step in steps)
        else:
            yield joined(steps, self.said)
        yield from self.conditions(steps)


def known_key(key: str, said: Words) -> str | None:
    """The key, or that of “other” of its kind; None where nothing is said."""
    if said.has(key):
        return key
    other = key.rsplit(".", 1)[0] + ".other"
    return other if said.has(other) else None


def display(step: Step, said: Words) -> Display:
    """The formula of a step, numbered, boxed if it is a result."""
    return Display(step.statement, said.prefix + step.id, True, step.is_result)


def is_tall(steps: Sequence[Step], said: Words) -> bool:
    """Do the formulas of some steps take too much room to stand under one number?"""
    rows = sum(len(lines(step.statement, said.notation, COLUMN)) for step in steps)
    return len(steps) > MOST_ROWS or rows > MOST_LINES


def joined(steps: Sequence[Step], said: Words) -> Display:
    """The formulas of several steps below each other, with one number."""
    rows = tuple(row for step in steps for row in relations(step))
    first, *others = (said.prefix + step.id for step in steps)
    return Display(t.System(rows), first, True, all(step.is_result for step in steps), also=tuple(others))


def by_kind(steps: Iterable[Step], kinds: Sequence[str]) -> list[list[Step]]:
    """The steps in groups whose phrases begin with these, in this order; all others before."""
    groups: list[list[Step]] = [[] for _ in range(len(kinds) + 1)]
    for step in steps:
        found = (k for k, kind in enumerate(kinds, 1) if f"{step.phrase}.".startswith(f"{kind}."))
        place = next(found, 0)
        groups[place].append(step)
    return groups


def is_constant(step: Step, derivation: Derivation) -> bool:
    """Is a force the same all along the motion?"""
    used = t.names(step.statement)
    return not derivation.study.system.has_clock and used.isdisjoint(
        c.name for c in derivation.study.problem.coordinates
    )
