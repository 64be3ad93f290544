"""The chapters of a derivation as sections: a sentence that says why, then the formula."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import chain, groupby

from rbpsym.document import telling
from rbpsym.document.breaking import table_width
from rbpsym.document.model import Block, Display, Paragraph, Ref, Section
from rbpsym.document.needless import is_still
from rbpsym.document.notes_figures import figure_label, free_bodies_figure, free_bodies_label, is_drawn_beside
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import Derivation, Step

ORDER = ("kinematics", "inertia", "momentum", "forces", "instant", "motion", "reactions", "work", "energy", "contact",
         "oscillations", "course")  # fmt: skip
Groups = tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]
SINGLE: Groups = tuple(((name,), (name,)) for name in ORDER)
# chapters under one heading: that of the first of them in the second row that is there
GROUPS: Groups = (
    (("kinematics", "inertia", "momentum"), ("kinematics", "inertia", "momentum")),
    (("forces", "instant", "motion"), ("motion", "instant", "forces")),
    (("work", "energy"), ("work", "energy")),
    (("reactions", "contact", "done"), ("contact", "reactions", "done")),
    (("oscillations",), ("oscillations",)),
    (("course",), ("course",)),
)
BRIEF: Groups = (
    (("kinematics", "inertia", "momentum", "instant", "motion"), ("motion", "instant", "kinematics", "inertia")),
    (("work", "energy", "done"), ("work", "energy", "done")),
    *GROUPS[3:],
)
PAGE = tuple(chain.from_iterable(chapters for chapters, _ in GROUPS))
GENERAL = ("kinematics", "inertia", "momentum", "torque")  # introductions that say the same in every problem: in full notes
WIDEST = 49.0  # em: a table that is wider would have to be set in small letters


def in_page_order(steps: Iterable[Step]) -> list[Step]:
    """The steps as they follow each other on a page that is not full."""
    return sorted(steps, key=lambda step: PAGE.index(step.chapter) if step.chapter in PAGE else len(PAGE))


def chapter_sections(derivation: Derivation, said: Words, level: int, first: Iterable[Block] = ()) -> Iterator[Section]:
    """The chapters in the order of a lecture: one section each in full notes, else few, the `first` blocks in the first."""
    before = tuple(first)
    for chapters, titles in SINGLE if said.is_full else BRIEF if said.is_brief else GROUPS:
        blocks = {name: list(chapter_blocks(name, derivation, said)) for name in chapters}
        lead = next((name for name in titles if blocks[name]), None)
        if lead is not None:
            found = (*before, *chain.from_iterable(blocks.values()))
            yield Section(said.say(f"section.{_title(lead, derivation)}"), found, f"{said.prefix}section.{lead}", level)
            before = ()


def chapter_blocks(name: str, derivation: Derivation, said: Words) -> Iterator[Block]:
    """The shown steps of a chapter; none if there are none."""
    found = derivation.chapter("work" if name == "done" else name)
    apart = not said.is_full and name in ("work", "done")  # works carried out stand where the forces are known
    steps = [step for step in found if step.id in said.shown or step.id in said.same]
    if steps := [s for s in steps if not apart or (s.rule == "work_done") is (name == "done")]:
        yield from BLOCKS.get(name, _plain)(steps, derivation, said)


def repeated(derivation: Derivation, shown: Iterable[str], said: Words) -> dict[str, str]:
    """Shown steps whose statement stands already on the page, with the step that showed it first.

    Only those that have words for "the same again" are left to a reference.
    """
    shown, first, found = set(shown), {}, {}
    for step in (step for name in ORDER for step in derivation.chapter(name) if step.id in shown):
        asserted = ends(step.statement)
        if asserted not in first:
            first[asserted] = step.id
        elif said.has(f"{step.phrase}_known"):
            found[step.id] = first[asserted]
    return found


def ends(statement: t.Node) -> t.Node:
    """What a chain comes to: its first and its last item."""
    if isinstance(statement, t.Chain) and set(statement.ops) == {"="}:
        return t.equation(statement.items[0], statement.items[-1])
    return statement


def _title(name: str, derivation: Derivation) -> str:
    """The chapter on contacts is about forces along the motion where none is lost; energy need not be conserved."""
    if name == "energy" and not any(step.id == "energy" for step in derivation.steps):
        return "energy_changes"
    if name == "energy" and derivation.study.system.has_clock:
        return "energy_relative"
    if name == "contact" and is_still(derivation):
        return "friction"
    lost = any(step.rule == "vanishing" for step in derivation.steps)
    return "along" if name == "contact" and not lost else {"done": "work"}.get(name, name)


def _intro(key: str, derivation: Derivation, said: Words, **slots: object) -> Iterator[Block]:
    if said.is_brief:
        short = f"{key.partition('.')[0]}.brief"
        yield from (Paragraph(said.say(short, ground=Said(derivation.study))),) if said.has(short) else ()
    elif said.has(f"{key}.intro") and not (said.is_later and key != "oscillations") and (said.is_full or key not in GENERAL):
        points = [t.Sym(label) for label in telling.told_origins(derivation, said)]
        count = len(derivation.study.system.bodies)
        ground = Said(derivation.study)
        told = "intro" if said.is_full or not said.has(f"{key}.short") else "short"
        yield Paragraph(said.say(f"{key}.{told}", ground=ground, points=points, count=count, **slots))


def _plain(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    chapter = steps[0].chapter
    yield from _intro("released" if chapter == "instant" and not derivation.study.ties else chapter, derivation, said)
    yield from telling.Teller(said).steps(steps)


def _inertia(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The integrals over the mass; of a moment that is given there is nothing to say before."""
    if any(step.rule == "mass_integral" for step in derivation.chapter("inertia")):
        yield from _intro("inertia", derivation, said)
    teller, before = telling.Teller(said), set()
    for step in steps:
        road = t.rows(step.statement)[0].items[2:] if step.phrase.startswith("inertia.integral") and not said.is_full else ()
        yield from teller.step(replace(step, statement=ends(step.statement), phrase=ALIKE) if road in before else step)
        before |= {road} if road else set()


ALIKE = "inertia.alike"  # the integral of a body is that of one before


def _motion(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The balances, then the accelerations: those that come from the same equations, or that are zero, together."""
    teller = telling.Teller(said)
    if derivation.study.system.unknowns:
        yield from _intro("torque", derivation, said)
    order = [step.id for step in derivation.steps]
    for found in solved_together(steps):
        phrase = found[0].phrase
        slots = {name: [step.slots.get(name[:-1]) for step in found] for name in ("accelerations", "coordinates")}
        named = dict.fromkeys(source for step in found for source in step.slots.get("sources", ()))
        sources = sorted(named, key=lambda source: order.index(source.id))
        together = teller.together(found, f"{phrase}_all", sources=sources, **slots)
        yield from together if phrase in SOLUTIONS else teller.steps(found)


SOLUTIONS = ("torque.solved", "torque.solved_zero")


def solved_together(steps: Iterable[Step]) -> list[list[Step]]:
    """Steps that are told together: accelerations that vanish, and those of which each is solved from an equation of another."""
    groups: list[list[Step]] = []
    for step in steps:
        last = groups[-1] if groups else []
        alike = bool(last) and last[0].phrase == step.phrase
        if alike and (step.phrase != "torque.solved" or any(set(step.reasons) & set(other.reasons) for other in last)):
            last.append(step)
        else:
            groups.append([step])
    return groups


def _kinematics(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Positions, velocities and speeds of all bodies together, then how they turn."""
    teller = telling.Teller(said)
    if not is_still(derivation):
        yield from _intro("kinematics", derivation, said)
    kinds = ("dependent", "tied_speed", "position", "velocity", "acceleration", "speed", "orbit", "turning", "spin_up", "centre",
             "length")  # fmt: skip
    found = [step for step in steps if step.phrase == "kinematics.turning.found"]
    others, *groups = telling.by_kind([step for step in steps if step not in found], [f"kinematics.{kind}" for kind in kinds])
    yield from teller.steps((*others, *found))
    for kind, group in zip(kinds, groups, strict=True):
        for balances in (False, True):
            alike = [step for step in group if (step.slots.get("variant") == "balance") is balances]
            tied = [step.slots["coordinate"] for step in alike if "coordinate" in step.slots]
            ways = {step.slots.get("variant") for step in alike}
            way = next((way for way in ("balance", "rate") if way in ways), "rate" if "zero" in ways else "place")
            manner = {"variant": way} if kind == "dependent" else {}
            yield from teller.together(alike, f"kinematics.{kind}_many", coordinates=tied, **manner)


def _forces(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The free-body diagrams and the ledger; a sentence where the forces are drawn beside the system."""
    if is_drawn_beside(derivation, said):
        forces = telling.forces_told(steps, derivation, said)
        yield Paragraph(said.say("forces.told", forces=forces, figure=Ref(figure_label(said))))
        short = telling.in_one_table(steps, derivation, said)
        yield from (Display(t.rows(step.statement)[0], said.prefix + step.id) for step in steps if step not in short)
        yield from telling.Teller(said).conditions(steps)
        return
    figure = Ref(free_bodies_label(said))
    key = "forces" if telling.told_origins(derivation, said) else "forces.center"
    key = "forces.acting" if telling.tells_statics(derivation, said) else key
    yield from _intro(key, derivation, said, figure=figure, table=Ref(said.prefix + "table.forces"))
    if len(steps) < len(derivation.chapter("forces")):
        yield Paragraph(said.say("forces.needed"))
    yield free_bodies_figure(derivation, said)
    short = telling.in_one_table(steps, derivation, said)
    long = [step for step in steps if step not in short]
    yield telling.forces_table(short, derivation, said)
    if long:
        yield Paragraph(said.say("forces.long", forces=[step.slots["force"] for step in long]))
        yield from telling.long_forces(long, derivation, said)
    yield from telling.Teller(said).conditions(steps)


def _manner_of_motion(derivation: Derivation, said: Words) -> str:
    """At rest, driven all through, with accelerations that were found before, or that are to be found."""
    if derivation.study.system.independent:
        known = any(step.id in said.shown for step in derivation.chapter("motion"))
        return "newton_euler" if known else "newton_euler.alone"
    return "newton_euler.driven" if derivation.study.system.has_clock else "newton_euler.rest"


def _reactions(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The equations of each body, then the unknown forces together."""
    teller = telling.Teller(said)
    yield from _intro(_manner_of_motion(derivation, said), derivation, said)
    others, known, moving, still = telling.by_kind(steps, [f"newton_euler.{kind}" for kind in ("known", "reaction", "settled")])
    reactions = [*moving, *still]
    yield from teller.steps(others)
    yield from teller.together(known, "newton_euler.solved_many")
    yield from teller.together(reactions, "newton_euler.reactions_rest" if is_still(derivation) else "newton_euler.reactions")


def _work(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works as symbols, what cancels, the theorem in its halves, then the works carried out."""
    teller = telling.Teller(said)
    rules = ("work", "workless", "power", "work_energy", "work_sum", "work_done", "solution")
    kinds = {rule: [step for step in steps if step.rule == rule] for rule in rules}
    integrals, handed_on, idle = telling.by_kind(kinds["work"], ("work.handed_on", "work.none"))
    integrals += idle if said.is_full else ()
    if integrals:
        yield from _integrals(integrals, derivation, said)
    if idle and not said.is_full:
        forces = list(dict.fromkeys(telling.whose(step, telling.on_several(derivation), said) for step in idle))
        yield Paragraph(said.say("work.idle", ground=Said(steps=idle), forces=forces, count=len(forces)))
    for manner in dict.fromkeys(step.phrase for step in kinds["workless"]):
        group = [step for step in kinds["workless"] if step.phrase == manner]
        yield from teller.together(group, "work.cancel_all", forces=[step.slots["force"] for step in group])
    yield from teller.steps((*handed_on, *kinds["power"]))
    whole, *split = telling.by_kind(kinds["work_energy"], ("work.theorem.translational", "work.theorem.rotational"))
    halves = [step for step in kinds["work_energy"] if any(step in half for half in split)]
    if halves:
        yield from _halves(halves, teller, said, Said(derivation.study))
    yield from teller.steps(step for step in steps if step.phrase.startswith(("work.spring.", "work.together.")))
    yield from teller.steps((*whole, *kinds["work_sum"], *kinds["solution"]))
    if kinds["work_done"]:
        yield from _done(kinds["work_done"], derivation, said)


def _integrals(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works as integrals: a table, or one below the other if they are long."""
    table = telling.works_table(steps, said, several=telling.on_several(derivation))
    if table_width(table, said.notation) <= WIDEST:
        yield Paragraph(said.say("work.intro" if said.is_full else "work.short", table=Ref(table.label)))
        yield table
    else:
        yield Paragraph(said.say("work.intro_below" if said.is_full else "work.short_below"))
        yield from (telling.joined([step], said) for step in steps)
    yield from telling.Teller(said).conditions(steps)


def _done(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The works carried out: a table, or one below the other if the formulas are long."""
    table, ground = telling.done_table(steps, said), Said(derivation.study, steps=steps)
    if table_width(table, said.notation) <= WIDEST:
        yield Paragraph(said.say("work.done_intro", ground=ground, table=Ref(table.label)))
        yield table
    elif said.is_full:
        yield Paragraph(said.say("work.done_below", ground=ground))
        forces = dict.fromkeys(step.id.split(".", 2)[2] for step in steps)
        yield from (telling.joined([s for s in steps if s.id.split(".", 2)[2] == force], said) for force in forces)
    yield from telling.Teller(said).conditions(steps)


def _halves(steps: list[Step], teller: telling.Teller, said: Words, ground: Said) -> Iterator[Block]:
    """Both halves of the theorem, of all bodies under one number if there are few."""
    if len(steps) <= telling.MOST_ROWS:
        yield Paragraph(said.say("work.theorem.half", ground=ground, count=len(steps)))
        yield telling.joined(steps, said)
        yield from teller.conditions(steps)
        return
    yield Paragraph(said.say("work.theorem.halves_each"))
    for body in dict.fromkeys(step.slots["body"] for step in steps):
        yield from teller.together([s for s in steps if s.slots["body"] == body], "work.theorem.body", body=body)


def _contact(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """The forces along the motion together, then where they vanish."""
    teller = telling.Teller(said)
    others, along = telling.by_kind(steps, ("contact.along",))
    sources = [source for step in along for source in step.slots.get("sources", ())]
    still = [step for step in along if telling.is_constant(step, derivation)]
    if still:
        forces = [step.slots["force"] for step in still]
        yield Paragraph(said.say("contact.constant", ground=Said(steps=still), forces=forces, count=len(still)))
        yield telling.joined(still, said)
        yield from teller.conditions(still)
    for boxed in (True, False):
        group = [step for step in along if step.is_result is boxed and step not in still]
        forces = [step.slots["force"] for step in group]
        key = "contact.along_all" if sources else "contact.along_plain"
        yield from teller.together(group, key, sources=sources, forces=forces)
    for is_beside, run in groupby(others, lambda step: step.phrase == "contact.other_force"):  # each loss with what is told of it
        rest = list(run)
        forces = [step.slots.get("force") for step in rest]
        yield from teller.together(rest, "contact.other_forces", forces=forces) if is_beside else _lasting(rest, teller)


def _lasting(steps: list[Step], teller: telling.Teller) -> Iterator[Block]:
    """How long contacts last: those that ask for a condition each together, others in their own words."""
    for lasts, group in groupby(steps, key=lambda step: step.slots["lasts"].key if step.phrase == "contact.asks" else ""):
        found = list(group)
        forces = [step.slots["lasts"].slots["force"] for step in found] if lasts else []
        yield from teller.together(found, f"{lasts}_many", forces=forces) if lasts else teller.steps(found)


def _oscillations(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Each position of rest; of one that is not shown with the motion close to it, or its formulas, at least the sentence."""
    teller = telling.Teller(said)
    yield from _intro("oscillations", derivation, said)
    close = {id for step in steps if step.rule == "linearization" for id in step.reasons}
    silent = [s for s in derivation.chapter("oscillations") if s.rule == "equilibrium" and s.id not in close]
    unstable = [step for step in silent if step.phrase == "oscillations.unstable" and step not in steps]
    for step in derivation.chapter("oscillations"):
        if step in steps and step.id in close:
            yield telling.display(step, said)
            yield from teller.conditions([step])
        elif step in steps:
            yield from teller.step(step)
        elif step in silent and not (step in unstable and len(unstable) > 1):
            yield Paragraph(teller.sentence(step, step.phrase, **step.slots))
            yield from teller.own_conditions([step])
    if len(unstable) > 1:
        places = [said.say("oscillations.place", place=step.slots["place"]) for step in unstable]
        yield Paragraph(said.say("oscillations.unstable_many", ground=Said(steps=unstable), places=places))
        yield from teller.own_conditions(unstable)


BLOCKS: Mapping[str, Callable[[list[Step], Derivation, Words], Iterator[Block]]] = {
    of.__name__[1:]: of
    for of in (_kinematics, _inertia, _motion, _forces, _reactions, _work, _done, _contact, _oscillations)
}
