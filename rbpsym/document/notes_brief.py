"""Notes as short as in a book: few headings, what leads to the results, and no step between."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.derivation.step import Derivation, Step
from rbpsym.document.chapters import chapter_blocks, chapter_title
from rbpsym.document.model import Block, Paragraph, Ref, Section
from rbpsym.document.notes_figures import free_bodies_figure, free_bodies_label, has_single_body
from rbpsym.document.words import Words

# what the next step starts from, or a student must see; results are shown besides
RULES: Mapping[str, frozenset[str]] = {
    "kinematics": frozenset({"constraint", "no_slip", "taut"}),
    "inertia": frozenset({"mass_integral", "parallel_axis", "statement"}),
    "motion": frozenset({"torque", "balance", "combination", "solution"}),
    "reactions": frozenset({"balance"}),
    "work": frozenset({"work", "workless", "power"}),
    "energy": frozenset({"kinetic_energy", "potential", "conservation", "first_integral"}),
    "contact": frozenset({"substitution"}),
    "oscillations": frozenset({"linearization"}),
}
STANDARD = 2

# chapters under one heading: that of the first of them in the second row that is there
GROUPS = (
    (("kinematics", "inertia", "momentum", "motion"), ("motion", "kinematics", "inertia")),
    (("work", "energy"), ("work", "energy")),
    (("reactions", "contact"), ("contact", "reactions")),
    (("oscillations",), ("oscillations",)),
)


def brief_steps(derivation: Derivation) -> frozenset[str]:
    """Ids of the steps that a book would print, and of the angular momenta that they start from."""
    kept = [step for step in derivation.steps if step.is_result or _is_brief(step)]
    cited = {id for step in kept if step.chapter == "motion" for id in step.reasons}
    momenta = {step.id for step in derivation.chapter("momentum") if step.id in cited}
    return frozenset(step.id for step in kept) | momenta


def _is_brief(step: Step) -> bool:
    return step.level <= STANDARD and step.rule in RULES.get(step.chapter, ())


def brief_sections(derivation: Derivation, said: Words, level: int) -> Iterator[Section]:
    """The chapters in a few sections, the drawing of the forces in the first."""
    figure = list(_forces(derivation, said))
    for chapters, titles in GROUPS:
        blocks = {name: list(chapter_blocks(name, derivation, said)) for name in chapters}
        lead = next((name for name in titles if blocks[name]), None)
        if lead is not None:
            found = (*figure, *(block for name in chapters for block in blocks[name]))
            yield Section(chapter_title(lead, derivation, said), found, f"{said.prefix}section.{lead}", level)
            figure = []


def _forces(derivation: Derivation, said: Words) -> Iterator[Block]:
    """The free-body diagrams with the sentence that leads to them, where they do not stand beside the system."""
    if derivation.chapter("forces") and not has_single_body(derivation):
        count = len(derivation.study.system.bodies)
        yield Paragraph(said.say("forces.brief", figure=Ref(free_bodies_label(said)), count=count))
        yield free_bodies_figure(derivation, said)
