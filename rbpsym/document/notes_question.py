"""What the problem asks and what comes out: the question in its words, the box, and the steps that the notes lack for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from rbpsym.ask.answer import Answer
from rbpsym.ask.asking import Refused
from rbpsym.derivation.assertions import Said
from rbpsym.derivation.forms import Forms
from rbpsym.derivation.step import Step, StepRef
from rbpsym.document.chapters import ends
from rbpsym.document.model import Block, Display, Emph, Inline, Inlines, ItemList, Paragraph, Ref, Section
from rbpsym.document.questions import question, spoken
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words, sentences
from rbpsym.notation import tree as t
from rbpsym.notation.infix import RELATION_SIGNS

Found = Answer | Refused
Told = tuple[Words, tuple[Step, ...]]


def in_known_forms(answers: Iterable[Found], steps: Iterable[Step]) -> Iterator[Found]:
    """The answers, what these steps have printed already in that form."""
    forms = Forms(steps)
    for found in answers:
        if isinstance(found, Answer):
            kept = tuple(replace(step, statement=forms.kept(step.statement)) for step in found.steps)
            nodes = tuple(forms.kept(t.equation(t.Sym(found.symbol), node)).items[-1] for node in found.nodes)
            found = replace(found, steps=kept, nodes=nodes)
        yield found


def question_section(answers: Iterable[Found], said: Words, level: int) -> Section:
    """What is asked; in brief notes with the answers."""
    asked = [(found, question(text_of(found), said)) for found in answers]
    blocks: list[Block] = [Paragraph(said.say("question.intro", count=len(asked)))]
    if said.is_brief:
        for found, words in asked:
            blocks += [ItemList((words,)), *_outcome(found, said, _box(found))]
    else:
        blocks.append(ItemList(tuple(words for _, words in asked)))
    return Section(said.say("section.question"), tuple(blocks), said.prefix + "section.question", level)


def answer_section(answers: tuple[Found, ...], told: Iterable[Told], said: Words, level: int) -> Section | None:
    """Each answer with the steps that are not among those `told` before: what is shown is referred to, and what this level
    of detail leaves out there is left out here. None if brief notes, which begin with the answers, need no further step."""
    shown = {ends(step.statement): words.step(step.id)[0] for words, steps in told for step in steps}
    together = len(answers) > 1 and all(isinstance(found, Answer) and found.verdict.is_proved for found in answers)
    blocks: list[Block] = []
    for number, found in enumerate(answers, 1):
        own = replace(said, prefix=f"{said.prefix}ask{number}.", same={}, owed={}, shown=frozenset())
        road = [] if isinstance(found, Refused) else list(_road(found, shown, own))
        road += () if said.is_brief else _outcome(found, said, () if _states(found) else _box(found), alone=not together)
        head = [Paragraph((Emph(question(text_of(found), said)),))] if road and len(answers) > 1 else []
        blocks += [*head, *road]
    if together and blocks and not said.is_brief:
        steps = [step for found in answers for step in found.steps]
        blocks.append(Paragraph(said.say("question.proved.many", ground=Said(steps=steps))))
    return None if not blocks else Section(said.say("section.answer"), tuple(blocks), said.prefix + "section.answer", level)


def text_of(found: Found) -> str:
    """The question as it was asked."""
    return found.text if isinstance(found, Refused) else found.question.text


def _road(found: Answer, shown: dict[t.Node, Inline], said: Words) -> Iterator[Block]:
    """The steps beyond what is told; adds to what is shown."""
    last = found.steps[-1:] if _states(found) else ()
    before = [replace(step, is_result=False) for step in found.steps[: len(found.steps) - len(last)]]
    known = {step.id: shown[ends(step.statement)] for step in before if ends(step.statement) in shown}
    new = [*(step for step in before if step.id not in known), *(() if said.is_brief else last)]
    if last and len(new) > 1 and new[-2:-1] == before[-1:] and _comes_to(new[-2]) == _comes_to(new[-1]):
        new[-2:] = [replace(new[-2], is_result=True)]  # what is asked has its name already
    seen = {id: mark for id, mark in known.items() if isinstance(mark, Ref)}
    said = replace(said, shown=frozenset(step.id for step in new), elsewhere=seen)
    inner = {id for step in before if step.id in seen for id in step.reasons}
    needed = {id for step in new for id in step.reasons} & seen.keys() or seen.keys() - inner
    if seen and new:
        yield Paragraph(said.say("question.given", steps=[StepRef(id) for id in seen if id in needed]))
    yield from Teller(said).steps(new)
    shown |= {ends(step.statement): Ref(said.prefix + step.id) for step in new if step not in last}


def _comes_to(step: Step) -> t.Node | None:
    """What an equation says that its letter is."""
    return step.statement.items[-1] if isinstance(step.statement, t.Chain) and set(step.statement.ops) == {"="} else None


def _states(found: Found) -> bool:
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
        yield Paragraph(said.say("question.refused", reason=found.reason))
        return
    told = [*_beside(found, said)]
    if found.valid:
        told.append(said.say("obligation.holds", conditions=list(found.valid), count=1))
    if found.verdict.is_proved and alone:
        told.append(said.say("question.proved.one", ground=Said(steps=found.steps)))
    elif not found.verdict.is_proved:
        told.append(said.say("question.open", reason=found.verdict.reason))
    if told := [part for part in told if part]:
        yield Paragraph(sentences(told))


def _beside(found: Answer, said: Words) -> Iterator[Inlines]:
    """Yes or no, a sentence, the equation that is solved, where an extremum lies, each value's own condition."""
    if found.holds_so is not None:
        yield said.say("question.yes" if found.holds_so else "question.no")
    elif found.says and said.language == "en":  # the language of the grammar in which the question is asked
        yield spoken(f"{found.says[0].upper()}{found.says[1:].rstrip('.')}.", said)
    if found.equation is not None:
        yield said.say("question.solves", name=t.Sym(found.symbol), equation=t.equation(found.equation, t.ZERO))
    if found.at is not None and found.at[0] != found.symbol:
        yield said.say("question.there", place=t.equation(t.Sym(found.at[0]), found.at[1]))
    for node, conditions in zip(found.nodes, found.each, strict=False):
        if conditions:
            yield said.say("question.each", value=node, conditions=list(conditions))
