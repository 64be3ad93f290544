"""What the problem asks and what comes out: the question in its words, the box, and the steps that the notes lack for it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Set
from contextlib import suppress
from dataclasses import replace
from itertools import groupby
from typing import TypeGuard

from rbpsym.ask.asking import Refused
from rbpsym.ask.found import Answer
from rbpsym.document.chapters import ends, in_page_order
from rbpsym.document.model import Block, Display, Emph, Inlines, ItemList, Paragraph, Ref, Section, Text
from rbpsym.document.telling import Teller
from rbpsym.document.translated import translated
from rbpsym.document.used import leading, led_to
from rbpsym.document.words import Words, capital, question, sentences, spoken
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import RELATION_SIGNS
from rbpsym.field import is_zero, names_in, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.proof.forms import Forms
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import Step

Found = Answer | Refused
Chapter = tuple[Words, tuple[Step, ...]]
MOST_ASKED = 3  # in one sentence


def in_known_forms(answers: Iterable[Found], steps: Iterable[Step]) -> Iterator[Found]:
    """The answers, what these steps have printed already in that form, and under the letter that it has there."""
    forms = Forms(steps)
    for found in answers:
        if isinstance(found, Answer):
            kept = tuple(replace(step, statement=forms.kept(step.statement)) for step in _lettered(found))
            nodes = tuple(forms.kept(t.equation(t.Sym(found.symbol), node)).items[-1] for node in found.nodes)
            found = replace(found, steps=kept, nodes=nodes)
        yield found


def _lettered(found: Answer) -> tuple[Step, ...]:
    """The steps: of a letter whose square the line before tells, the last one tells it by that letter."""
    if not _states(found) or len(found.nodes) != 1:
        return found.steps
    *before, last = found.steps
    told = last.statement
    if last.rule != "value_told" or not isinstance(told, t.Chain):
        return found.steps
    for row in (row for step in before if step.id in last.reasons for row in t.rows(step.statement) if isinstance(row, t.Chain)):
        left, square = row.items[0], row.items[-1]
        if not isinstance(left, t.Pow) or not isinstance(left.base, t.Sym) or left.exponent != t.TWO:
            continue
        if t.names(square) == t.names(found.nodes[0]) and is_zero(scalar(found.nodes[0]) ** 2 - scalar(square)):
            named = {key: [left.base] if slot == [told.items[0]] else slot for key, slot in last.slots.items()}
            slots = {key: left.base if slot == told.items[0] else slot for key, slot in named.items()}
            return (*before, replace(last, statement=t.equation(left.base, told.items[-1]), slots=slots))
    return found.steps


def asked(answers: tuple[Found, ...], stated: Mapping[int, Ref], said: Words) -> Iterator[Block]:
    """What is asked, each with the number under which its answer stands in the text."""
    items = [
        (*question(text_of(found), said), *((Text("\N{NO-BREAK SPACE}"), stated[k]) if k in stated else ()))
        for k, found in enumerate(answers)
    ]
    if len(items) > MOST_ASKED:
        yield from (Paragraph(said.say("question.intro")), ItemList(tuple(items)))
    elif items:
        yield Paragraph(said.say("question.asked", questions=items), is_question=True)


class OnPage(Frozen):
    """Where a page tells what a step says: under its own number, or under those of the steps by which it is led to."""

    marks: tuple[Ref, ...]
    is_own: bool


def _page(told: Iterable[Chapter]) -> dict[t.Node, OnPage]:
    """Where the statements of all these steps stand."""
    found: dict[t.Node, OnPage] = {}
    for words, steps in told:
        by_id = {step.id: step for step in steps}
        for step in in_page_order(steps):
            one = _told(step, by_id, words)
            if one.is_own or ends(step.statement) not in found:
                found[ends(step.statement)] = one
    return found


def _told(step: Step, by_id: Mapping[str, Step], words: Words) -> OnPage:
    mark = words.step(step.id)[0]
    if isinstance(mark, Ref):
        return OnPage((mark,), True)
    marks = (mark for id in leading(step) if id in by_id for mark in _told(by_id[id], by_id, words).marks)
    return OnPage(tuple(dict.fromkeys(marks)), False)


def _stated(found: Found, shown: Mapping[t.Node, OnPage]) -> Ref | None:
    """Where a step on the page states an answer as it is."""
    own = found.steps[-1] if _states(found) and len(found.nodes) == 1 and not _has_more(found) else None
    rows = [*(ends(step.statement) for step in _equal(found)), *(_by_name(own) if own else ())]
    if own and isinstance(found, Answer):
        rows += [row for row in shown if _is_marked(row, ends(own.statement), found.study.problem.body_names)]
    return next((shown[row].marks[0] for row in rows if row in shown and shown[row].is_own), None)


def _is_marked(row: t.Node, own: t.Node, bodies: Collection[str]) -> bool:
    """Is a row what an answer says, of its letter with a mark: the least μ as μ_min, the critical c as c_crit? One with a body's
    name is that of the body."""
    if not isinstance(row, t.Chain) or not isinstance(own, t.Chain) or row.ops != ("=",) or own.ops != ("=",):
        return False
    marked, letter = row.items[0], own.items[0]
    if not isinstance(marked, t.Sym) or not isinstance(letter, t.Sym):
        return False
    stem, _, mark = marked.name.rpartition("_")
    return stem == letter.name and mark not in bodies and row.items[1:] == own.items[1:]


def _by_name(step: Step) -> Iterator[t.Node]:
    """What a step says of a letter, said of the quantity with a name for which the letter stands."""
    found = step.data.get("of")
    for value in found.values() if isinstance(found, Mapping) else ():
        if len(names := names_in(value)) == 1 and value == symbol(*names) and isinstance(step.statement, t.Chain):
            yield t.relation(t.Sym(*names), step.statement.ops[-1], step.statement.items[-1])


def _equal(found: Found) -> list[Step]:
    """Of the steps from which an answer follows those that state its value, where no more is to be said; a letter or a number is
    the value of much else."""
    if not _states(found) or len(found.nodes) != 1 or found.relation != "=" or _has_more(found):
        return []
    if isinstance(found.nodes[0], (t.Sym, t.Num)):
        return []
    before = (step for step in found.steps if step.id in found.steps[-1].reasons)
    return [step for step in before if found.nodes[0] in {_comes_to(row) for row in t.rows(step.statement)}]


def _has_more(found: Answer) -> bool:
    """Is more to be said than a proved value and its conditions?"""
    told = (found.says, found.holds_so is not None, found.equation, found.at, any(found.each))
    return any(told) or not found.verdict.is_proved


def boxes_of_answers(sections: Iterable[Section], marks: Iterable[Ref]) -> Iterator[Section]:
    """The sections with boxes around the answers alone."""
    labels = {mark.label for mark in marks}
    for section in sections:
        yield replace(section, blocks=tuple(part for block in section.blocks for part in _parted(block, labels)))


def _parted(block: Block, labels: Set[str]) -> Iterator[Block]:
    """A block with a box if it is an answer; of several formulas under one number those that are asked for by themselves."""
    rows = t.rows(block.node) if isinstance(block, Display) else ()
    if not isinstance(block, Display) or len(rows) != 1 + len(block.also):
        yield _boxed(block, labels, others=False)
        return
    for _, group in groupby(zip(rows, (block.label, *block.also), strict=True), key=lambda pair: pair[1] in labels):
        kept, (first, *others) = zip(*group, strict=True)
        part = replace(block, node=kept[0] if len(kept) == 1 else t.Relations(kept), label=first, also=tuple(others))
        yield _boxed(part, labels, others=False)


def _boxed(block: Block, labels: Set[str], *, others: bool) -> Block:
    if not isinstance(block, Display):
        return block
    is_asked = not labels.isdisjoint((block.label, *block.also))
    return replace(block, boxed=is_asked or (others and block.boxed), is_result=block.boxed)


def answer_section(
    answers: tuple[Found, ...], told: Iterable[Chapter], said: Words, level: int
) -> tuple[Section | None, dict[int, Ref]]:
    """Each answer with the steps that are not among those `told` before, what is shown being referred to and what this level
    of detail leaves out being left out; and where the others are stated. No section if all are."""
    shown = _page(told)
    together = len(answers) > 1 and all(isinstance(found, Answer) and found.verdict.is_proved for found in answers)
    blocks: list[Block] = []
    stated: dict[int, Ref] = {}
    held: dict[tuple[t.Node, ...], list[Ref]] = {}  # how long the answers hold that stand on the page
    for number, found in enumerate(answers):
        if mark := _stated(found, shown):
            stated[number] = mark
            held.setdefault(() if isinstance(found, Refused) else found.valid, []).append(mark)
            continue
        own = replace(said, prefix=f"{said.prefix}ask{number + 1}.", same={}, owed={}, shown=frozenset())
        road = [] if isinstance(found, Refused) else list(_road(found, shown, own))
        mark = _stated(found, shown) or next((Ref(part.label) for part in reversed(road) if isinstance(part, Display)), None)
        stated |= {number: mark} if mark else {}
        road += _outcome(found, said, () if _states(found) else _box(found), alone=not together)
        blocks += _headed(capital(question(text_of(found), said)), road)
    if together and blocks:
        steps = [step for found in answers if isinstance(found, Answer) for step in found.steps]
        blocks.append(Paragraph(said.say("question.proved.many", ground=Said(steps=steps))))
    lasting = [(list(valid), marks) for valid, marks in held.items() if valid]
    said_of = (said.say("question.stated", steps=marks, conditions=valid, count=len(marks)) for valid, marks in lasting)
    labels = {mark.label for mark in stated.values()}
    blocks = [_boxed(block, labels, others=True) for block in (*map(Paragraph, said_of), *blocks)]
    return Section(said.say("section.answer"), tuple(blocks), said.prefix + "section.answer", level) if blocks else None, stated


def _headed(asked: Inlines, road: list[Block]) -> Iterator[Block]:
    """A road under its question, which its first sentence follows on the same line."""
    first, rest = (road[0].inlines, road[1:]) if road and isinstance(road[0], Paragraph) else ((), road)
    if road:
        yield Paragraph(sentences([(Emph((*asked, Text("."))),), *([first] if first else [])]), is_question=True)
    yield from rest


def text_of(found: Found) -> str:
    """The question as it was asked."""
    return found.text if isinstance(found, Refused) else found.question.text


def _road(found: Answer, shown: dict[t.Node, OnPage], said: Words) -> Iterator[Block]:
    """The steps beyond what is told; adds to what is shown."""
    last = found.steps[-1:] if _states(found) else ()
    equal = {step.id for step in _equal(found)}
    led = led_to(found.steps, equal or [step.id for step in last]) | {step.id for step in last or found.steps}
    before = [replace(step, is_result=False) for step in found.steps if step.id in led and step not in last]
    before = [step for step in before if not _is_asked_so(step, found)]
    rows = ((step.id, row) for step in before for row in (ends(step.statement), *_by_name(step)))
    known = {id: shown[row] for id, row in rows if row in shown}
    new = [*(step for step in before if step.id not in known), *last]
    if any(step.id in equal for step in new):
        new = [_asked_alone(step, found) if step.id in equal else step for step in new[:-1]]  # it has its name already
    seen = {id: one.marks[0] for id, one in known.items() if one.is_own}
    said = replace(said, shown=frozenset(step.id for step in new), elsewhere=seen)
    inner = {id for step in before if step.id in known for id in step.reasons}
    needed = {id for step in new for id in step.reasons} & known.keys() or known.keys() - inner
    marks = {mark for id in needed for mark in known[id].marks} or {mark for step in last for mark in _says(step, shown)}
    if marks and (new or not last):
        in_order = dict.fromkeys(mark for one in shown.values() for mark in one.marks if mark in marks)
        is_all = bool(last) and new == [*last]
        yield Paragraph(said.say("question.follows" if is_all else "question.given", steps=list(in_order)))
        new = [replace(step, phrase="") for step in new] if is_all else new
    yield from Teller(said).steps(new)
    shown |= {ends(step.statement): OnPage((Ref(said.prefix + step.id),), True) for step in new if step not in last}


def _says(step: Step, shown: Mapping[t.Node, OnPage]) -> Iterator[Ref]:
    """Where the page says what the quantity is that has a value at some moment."""
    values = [(value, names_in(value)) for value in step.data.get("of", {}).values() if names_in(value)]
    for row, on in shown.items():
        if isinstance(row, t.Chain) and row.ops[-1] == "=" and on.is_own:
            alike = [value for value, names in values if names == t.names(row.items[-1])]
            with suppress(RbpsymError):
                if any(is_zero(scalar(row.items[-1]) - value) for value in alike):
                    yield from on.marks


def _is_asked_so(step: Step, found: Answer) -> bool:
    """Does a step say no more than the place that the question itself states?"""
    when = found.question.when
    is_there = when is not None and when.kind == "reaches" and f"{when.words[0]} " in text_of(found)
    return is_there and step.phrase == "phases.place.value"


def _asked_alone(step: Step, found: Answer) -> Step:
    """Of what a step says the row that is asked for."""
    rows = [row for row in t.rows(step.statement) if _comes_to(row) in found.nodes]
    return replace(step, statement=rows[0]) if len(rows) == 1 else step


def _comes_to(statement: t.Node) -> t.Node | None:
    """What an equation says that its letter is."""
    return statement.items[-1] if isinstance(statement, t.Chain) and set(statement.ops) == {"="} else None


def _states(found: Found) -> TypeGuard[Answer]:
    """Is the last step what was asked?"""
    return isinstance(found, Answer) and bool(found.steps) and found.steps[-1].is_result


def _box(found: Found) -> tuple[Display, ...]:
    """The answer in its box, for where its step is not shown."""
    if isinstance(found, Refused) or not found.nodes:
        return ()
    if _states(found):
        return (Display(found.steps[-1].statement, numbered=False, boxed=True),)
    op = found.relation if found.relation in RELATION_SIGNS else "="
    nodes = [t.relation(t.Sym(found.symbol), op, node) for node in found.nodes] if found.symbol else found.nodes
    return tuple(Display(node, numbered=False, boxed=True) for node in nodes)


def _outcome(found: Found, said: Words, box: Iterable[Block], *, alone: bool = True) -> Iterator[Block]:
    """The box, what is said beside it, the conditions, and whether it is proved, but for one of several that all are."""
    yield from box
    if isinstance(found, Refused):
        yield Paragraph(said.say("question.refused", reason=translated(found.reason, said.language)))
        return
    told = [*_beside(found, said)]
    if found.valid:
        told.append(said.say("obligation.holds", conditions=list(found.valid), count=1))
    if found.verdict.is_proved and alone:
        told.append(said.say("question.proved.one", ground=Said(steps=found.steps)))
    elif not found.verdict.is_proved:
        told.append(said.say("question.open", reason=translated(found.verdict.reason, said.language)))
    if told := [part for part in told if part]:
        yield Paragraph(sentences(told))


def _beside(found: Answer, said: Words) -> Iterator[Inlines]:
    """Yes or no, a sentence, the equation that is solved, where an extremum lies, each value's own condition."""
    if found.holds_so is not None:
        yield said.say("question.yes" if found.holds_so else "question.no")
    elif found.says:
        says = translated(found.says, said.language)
        yield spoken(f"{says[0].upper()}{says[1:].rstrip('.')}.", said)
    if found.equation is not None:
        yield said.say("question.solves", name=t.Sym(found.symbol), equation=t.equation(found.equation, t.ZERO))
    if found.at is not None and found.at[0] != found.symbol and found.at[1] not in found.nodes:
        yield said.say("question.there", place=t.equation(t.Sym(found.at[0]), found.at[1]))
    for node, conditions in zip(found.nodes, found.each, strict=False):
        if conditions:
            yield said.say("question.each", value=node, conditions=list(conditions))
