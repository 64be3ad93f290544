"""The last sections: the results at a glance, and what was proved by which roads."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from math import floor, log10
from typing import Any

from rbpsym.chapters.methods.balances import Road
from rbpsym.chapters.methods.registry import METHODS
from rbpsym.document.model import Block, Callout, Display, Inlines, ItemList, Math, Paragraph, Ref, Section, Table, Text, words
from rbpsym.document.needless import is_still
from rbpsym.document.words import Words, capital, sentences
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Num, Pow
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import BodyRef, Derivation, DerivedCourse, PhraseRef, Skipped, Step
from rbpsym.remarks.choosing import remarks

Told = tuple[Words, tuple[Step, ...]]


def results_section(
    derivation: Derivation, said: Words, level: int, later: Iterable[Told] = (), detail: str = "brief"
) -> Iterator[Section]:
    """The boxed results once more, each with the number under which it was found and, as the detail asks for it, with what
    is to be said of it; `later` of further phases. None where nothing is boxed."""
    parts = [derivation, *(phase.derivation for phase in derivation.phases)]
    about = {id(part.steps): found for part, found in zip(parts, remarks(derivation, detail), strict=True)}
    told = [(said, derivation.steps), *later]
    found = [
        (speech, step, about.get(id(steps), {}).get(step.id, ()))
        for speech, steps in told
        for step in steps
        if step.is_result and step.id in speech.shown
    ]
    blocks: tuple[Block, ...] = tuple(block for row in _distinct(found) for block in _once_more(*row))
    if blocks:
        box = Callout("result", said.say("results.intro"), blocks)
        yield Section(said.say("section.results"), (box,), said.prefix + "section.results", level)


def _once_more(step: Step, speech: Words, about: Iterable[Step]) -> Iterator[Block]:
    """The formula with the number under which it stands on the page already, and what is to be said of it."""
    (first, *_) = where = speech.step(step.id)
    if isinstance(first, Ref):
        yield Display(step.statement, numbered=False, repeats=first)
    else:
        yield Display(step.statement, numbered=False, reason=where)
    yield from _remarked(about, speech)


def _remarked(about: Iterable[Step], speech: Words) -> Iterator[Block]:
    if told := [capital(speech.say(remark.phrase, **remark.slots)) for remark in about]:
        yield Paragraph(sentences(told))


def with_remarks(
    sections: Iterable[Section], derivation: Derivation, phases: Iterable[Words], detail: str
) -> Iterator[Section]:
    """The sections of notes that have no list of results: what is to be said of a result stands behind its box."""
    told = zip(phases, remarks(derivation, detail), strict=True)
    about = {said.prefix + id: (found, said) for said, results in told for id, found in results.items()}
    for section in sections:
        blocks = [(block, *_behind(block, about)) for block in section.blocks]
        yield replace(section, blocks=tuple(chain.from_iterable(blocks)))


def _behind(block: Block, about: Mapping[str, tuple[list[Step], Words]]) -> Iterator[Block]:
    if isinstance(block, Display) and block.boxed:
        for found, said in (about[label] for label in (block.label, *block.also) if label in about):
            yield from _remarked(found, said)


def _distinct(found: Sequence[tuple[Words, Step, Iterable[Step]]]) -> Iterator[tuple[Step, Words, Iterable[Step]]]:
    seen = []
    for speech, step, about in found:
        if step.statement not in seen:
            seen.append(step.statement)
            yield step, speech, about


def checks_section(derivation: Derivation, said: Words, level: int, table: str | None = "") -> Section:
    """How many steps are proved, which methods agree, what the oracles say.

    `table` is the label of a table elsewhere that tells how; it is put here if that is "", and
    nothing is said of it if None.
    """
    summary = derivation.summary()
    whole = summary["proved"] == summary["steps"]
    counts = {name: summary[name] for name in ("steps", "proved", "refuted", "undecided")}
    own, ground = checks_table(derivation.all_steps, said), Said(steps=derivation.all_steps, summary=summary)
    key = "checks.some" if not whole else "checks.short" if table is None else "checks.all"
    is_told = whole and bool(table)  # at the end of the document, for all problems at once
    intro = () if is_told else said.say(key, ground=ground, table=Ref(table or own.label), **counts)
    items = [
        *_methods(summary, said, ground),
        *(() if is_still(derivation) else _oracles(summary, said, ground)),
    ]
    lead = said.say("checks.roads", ground=ground)
    is_long = said.is_full and not is_still(derivation)
    skipped = [left_out(found, said) for found in derivation.skipped if is_long or found.method == "phases"]
    if not said.is_full or is_told:
        told = (Paragraph(sentences([part for part in (intro, *items, *skipped) if part])), *(() if whole else (own,)))
        return Section(said.say("section.checks"), told, said.prefix + "section.checks", level)
    blocks: tuple[Block, ...] = (
        Paragraph(intro),
        *((own,) if table == "" or (not whole and not table) else ()),
        *((Paragraph(lead),) if items and lead else ()),
        *((ItemList(tuple(items)),) if items else ()),
        *((Paragraph(sentences(skipped)),) if skipped else ()),
    )
    return Section(said.say("section.checks"), blocks, said.prefix + "section.checks", level)


def left_out(skipped: Skipped, said: Words) -> Inlines:
    """Why a method was not used; of a motion in phases, in the first one, to which all methods are put."""
    told = said.say(skipped.phrase, **{**skipped.slots, "method": said.say(f"method.{skipped.method}")})
    is_of_phase = said.problem is not None and said.problem.phases and skipped.method in METHODS
    return said.say("skipped.first", reason=told) if is_of_phase else told


def course_checks_section(derived: DerivedCourse, said: Words, label: str, detail: str) -> Section:
    """What was proved in the whole course, and how; if all of it is, a table tells that in full notes alone."""
    steps = [step for part in derived.derivations.values() for step in part.steps]
    steps += [step for lesson in derived.lessons.values() for step in lesson.steps]
    kinds = Counter(str(step.certificate.verdict.kind).lower() for step in steps if step.certificate)
    counts = {name: kinds[name] for name in ("proved", "refuted", "undecided")}
    is_short = kinds["proved"] == len(steps) and detail != "full"
    key = "checks.course_short" if is_short else "checks.course" if kinds["proved"] == len(steps) else "checks.some"
    intro = said.say(key, ground=Said(steps=steps), steps=len(steps), table=Ref(label), **counts)
    tables = () if is_short else (replace(checks_table(steps, said), label=label),)
    return Section(said.say("section.checks"), (Paragraph(intro), *tables), "section.checks", 1)


def checks_table(steps: Iterable[Step], said: Words) -> Table:
    """How steps were checked, and how many in each way."""
    steps = tuple(steps)
    counts = Counter(name for step in steps if step.certificate for name in step.certificate.checks)
    rows = tuple(
        (said.say(f"checked.{name}"), words(str(count)))
        for name, count in counts.items()
        if said.has(f"checked.{name}")
    )
    header = (said.say("header.check"), said.say("header.steps"))
    caption = said.say("caption.checks", ground=Said(steps=steps))
    return Table(header, rows, caption, "lr", said.prefix + "table.checks")


def _methods(summary: Mapping[str, Any], said: Words, ground: Any) -> Iterator[Inlines]:
    relative = any(step.phrase == "energy.relative" for step in ground.steps)
    keys = ["energy_relative" if relative and name == "energy" else name for name in summary["methods"]]
    names = [said.say(f"method.{key}") for key in keys]
    if len(names) > 1:
        yield said.say("checks.methods", ground=ground, methods=names)


def _oracles(summary: Mapping[str, Any], said: Words, ground: Said) -> Iterator[Inlines]:
    if summary["lagrange"]:
        yield said.say(f"checks.lagrange.{summary['lagrange']}", ground=ground)
    if summary["simulation"]:
        error = max(summary["simulation"]["max_relative_error"], 1e-16)  # zero is that of the arithmetic itself
        yield said.say("checks.simulation", ground=ground, error=Pow(Num(10), Num(floor(log10(error)) + 1)))


# --- the table of roads: which lines each takes, and which unknown forces drop out of them


def roads_table(roads: Sequence[Road], said: Words) -> Table:
    """Road, lines, unknown forces that drop out, unknown forces that stay; the road of the notes is marked."""
    header = tuple(said.say(f"roads.{key}") for key in ("road", "lines", "drop", "stay"))
    rows = tuple((_road(road, said), (Text(str(road.lines)),), _names(road.drop), _names(road.stay)) for road in roads)
    return Table(header, rows, said.say("roads.caption"), "pcll", said.prefix + "table.roads")


def _names(names: Sequence[str]) -> Inlines:
    parts = [part for name in names for part in (Text(", "), Math(t.Sym(name)))]
    return tuple(parts[1:]) or (Text("–"),)


def _road(road: Road, said: Words) -> Inlines:
    mark = (Text("→ "),) if road.is_taken else ()
    if road.first is None:
        return said.say(f"roads.{road.kind}")
    bodies = [BodyRef(name) for name in road.first.bodies]
    told = PhraseRef("bodies", {"bodies": bodies, "count": len(bodies)})
    return (*mark, *said.say(f"roads.{road.kind}", label=_label(road, said), bodies=told))


def _label(road: Road, said: Words) -> Inlines:
    """A fixed point or an axis by its letter, what meets at a crossing by the forces, other points as the file names them."""
    label = road.first.label if road.first else ""
    if road.kind == "crossing":
        return _names(label.split(", "))
    if road.kind == "fixed" or label in ("x", "y"):
        return (Math(t.Sym(label)),)
    return said.label(label)
