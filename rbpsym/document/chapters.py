"""The chapters of a derivation as sections: a sentence that says why, then the formula."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from rbpsym.derivation.step import Derivation, Step, StepRef
from rbpsym.document.breaking import lines, table_width
from rbpsym.document.model import Block, Display, Inlines, Paragraph, Ref, Section, Text
from rbpsym.document.notes_figures import free_bodies_figure, free_bodies_label, problem_notation
from rbpsym.document.tables import done_table, forces_table, works_table
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT

ORDER = ("kinematics", "inertia", "momentum", "forces", "motion", "reactions", "work", "energy", "contact", "oscillations")
MOST_ROWS = 6  # formulas under one number
MOST_LINES = 12
COLUMN = 36.0  # em: about the width of a page
WIDEST = 44.0  # em: a table that is wider would have to be set in small letters


def chapter_sections(derivation: Derivation, said: Words, level: int) -> Iterator[Section]:
    """One section a chapter, in the order of a lecture; chapters without shown steps are left out."""
    for name in ORDER:
        steps = [step for step in derivation.chapter(name) if step.id in said.shown or step.id in said.same]
        if steps:
            blocks = BLOCKS.get(name, _plain)(steps, derivation, said)
            title = said.say(f"section.{_title(name, derivation)}")
            yield Section(title, tuple(blocks), f"{said.prefix}section.{name}", level)


def repeated(derivation: Derivation, shown: Iterable[str], said: Words) -> dict[str, str]:
    """Shown steps whose statement stands already on the page, with the step that showed it first.

    Only those that have words for "the same again" are left to a reference.
    """
    shown, first, found = set(shown), {}, {}
    for step in (step for name in ORDER for step in derivation.chapter(name) if step.id in shown):
        if step.statement not in first:
            first[step.statement] = step.id
        elif said.has(f"{step.phrase}_known"):
            found[step.id] = first[step.statement]
    return found


def _title(name: str, derivation: Derivation) -> str:
    """The chapter on contacts is about forces along the motion where none is lost."""
    return "along" if name == "contact" and not derivation.study.losses else name


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

    def sentence(self, step: Step, key: str, **slots: object) -> Inlines:
        """What is said before a step, in the variant for a second time if there is one."""
        found = known_key(key, self.said)
        if found is None:
            return ()
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
        yield Paragraph(self.said.say(key, count=len(steps), **slots))
        if is_tall(steps, self.said):
            yield from (display(step, self.said) for step in steps)
        else:
            yield joined(steps, self.said)


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
    notation = problem_notation(said.problem) if said.problem else DEFAULT
    rows = sum(len(lines(step.statement, notation, COLUMN)) for step in steps)
    return len(steps) > MOST_ROWS or rows > MOST_LINES


def joined(steps: Sequence[Step], said: Words) -> Display:
    """The formulas of several steps below each other, with one number."""
    rows = tuple(row for step in steps for row in
                 (step.statement.rows if isinstance(step.statement, t.System) else (step.statement,)))
    first, *others = (said.prefix + step.id for step in steps)
    return Display(t.System(rows), first, True, all(step.is_result for step in steps), also=tuple(others))


def by_kind(steps: Iterable[Step], kinds: Sequence[str]) -> list[list[Step]]:
    """The steps in groups whose phrases begin with these, in this order; all others before."""
    groups: list[list[Step]] = [[] for _ in range(len(kinds) + 1)]
    for step in steps:
        place = next((k for k, kind in enumerate(kinds, 1) if step.phrase == kind or step.phrase.startswith(f"{kind}.")), 0)
        groups[place].append(step)
    return groups


def _intro(key: str, derivation: Derivation, said: Words, **slots: object) -> Iterator[Block]:
    if said.has(f"{key}.intro"):
        points = [t.Sym(label) for label in derivation.study.origins]
        count = len(derivation.study.system.bodies)
        yield Paragraph(said.say(f"{key}.intro", points=points, count=count, **slots))


def _plain(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    key = {"motion": "torque"}.get(steps[0].chapter, steps[0].chapter)
    yield from _intro(key, derivation, said)
    yield from Teller(said).steps(steps)


def _kinematics(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Positions, velocities and speeds of all bodies together, then how they turn."""
    teller = Teller(said)
    yield from _intro("kinematics", derivation, said)
    kinds = ("position", "velocity", "speed", "turning")
    others, *groups = by_kind(steps, [f"kinematics.{kind}" for kind in kinds])
    yield from teller.steps(others)
    for kind, group in zip(kinds, groups, strict=True):
        yield from teller.together(group, f"kinematics.{kind}_many")


def _forces(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The free-body diagrams and the ledger."""
    yield from _intro("forces", derivation, said, figure=Ref(free_bodies_label(said)),
                      table=Ref(said.prefix + "table.forces"))
    yield free_bodies_figure(derivation, said)
    yield forces_table(steps, derivation, said)


def _reactions(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The equations of each body, then the unknown forces together."""
    teller = Teller(said)
    yield from _intro("newton_euler", derivation, said)
    others, reactions = by_kind(steps, ("newton_euler.reaction",))
    yield from teller.steps(others)
    yield from teller.together(reactions, "newton_euler.reactions")


def _work(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works as symbols, what cancels, the theorem in its halves, then the works carried out."""
    teller = Teller(said)
    kinds = {kind: [s for s in steps if s.rule == kind] for kind in ("work", "workless", "work_energy", "work_done", "solution")}
    if kinds["work"]:
        yield from _integrals(kinds["work"], derivation, said)
    forces = [step.slots["force"] for step in kinds["workless"]]
    yield from teller.together(kinds["workless"], "work.cancel_all", forces=forces)
    whole, halves = by_kind(kinds["work_energy"], ("work.theorem.translational", "work.theorem.rotational"))[0], []
    halves = [step for step in kinds["work_energy"] if step not in whole]
    if halves:
        yield from _halves(halves, teller, said)
    yield from teller.steps((*whole, *kinds["solution"]))
    if kinds["work_done"]:
        yield from _done(kinds["work_done"], derivation, said)


def _integrals(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works as integrals: a table, or one below the other if they are long."""
    table = works_table(steps, said)
    if table_width(table, problem_notation(derivation.study.problem)) <= WIDEST:
        yield Paragraph(said.say("work.intro", table=Ref(table.label)))
        yield table
        return
    yield Paragraph(said.say("work.intro_below"))
    yield from (joined([step], said) for step in steps)


def _done(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works carried out: a table, or one below the other if the formulas are long."""
    table = done_table(steps, said)
    if table_width(table, problem_notation(derivation.study.problem)) <= WIDEST:
        yield Paragraph(said.say("work.done_intro", table=Ref(table.label)))
        yield table
        return
    yield Paragraph(said.say("work.done_below"))
    for group in _by_force(steps):
        yield joined(group, said)


def _by_force(steps: list[Step]) -> list[list[Step]]:
    """Groups of at most so many formulas, the two works of a force together."""
    groups: list[list[Step]] = [[]]
    forces = dict.fromkeys(step.id.split(".", 2)[2] for step in steps)
    for force in forces:
        own = [step for step in steps if step.id.split(".", 2)[2] == force]
        if groups[-1] and len(groups[-1]) + len(own) > MOST_ROWS:
            groups.append([])
        groups[-1] += own
    return groups


def _halves(steps: list[Step], teller: Teller, said: Words) -> Iterator[Block]:
    """Both halves of the theorem, of all bodies under one number if there are few."""
    if len(steps) <= MOST_ROWS:
        yield Paragraph(said.say("work.theorem.halves"))
        yield joined(steps, said)
        return
    yield Paragraph(said.say("work.theorem.halves_each"))
    for body in dict.fromkeys(step.slots["body"] for step in steps):
        yield from teller.together([s for s in steps if s.slots["body"] == body], "work.theorem.body", body=body)


def _contact(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The forces along the motion together, then where they vanish."""
    teller = Teller(said)
    others, along = by_kind(steps, ("contact.along",))
    sources = [s for step in along for s in step.slots.get("sources", ())]
    results = [step for step in along if step.is_result]
    yield from teller.together(results, "contact.along_all", sources=sources, forces=[s.slots["force"] for s in results])
    rest = [step for step in along if not step.is_result]
    yield from teller.together(rest, "contact.along_all", sources=sources, forces=[s.slots["force"] for s in rest])
    yield from teller.steps(others)


def _oscillations(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Each position of rest; of one that is not shown with its formulas at least the sentence."""
    teller = Teller(said)
    yield from _intro("oscillations", derivation, said)
    for step in derivation.chapter("oscillations"):
        if step in steps:
            yield from teller.step(step)
        elif step.rule == "equilibrium" and not step.slots.get("told"):
            yield Paragraph(teller.sentence(step, step.phrase, **step.slots))


BLOCKS: Mapping[str, Callable[[list[Step], Derivation, Words], Iterator[Block]]] = {
    "kinematics": _kinematics, "forces": _forces, "reactions": _reactions, "work": _work, "contact": _contact,
    "oscillations": _oscillations,
}
