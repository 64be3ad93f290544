"""What the problem asks and what comes out: the question in its words, the box, and the steps that the notes lack for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from rbpsym.ask.answer import Answer
from rbpsym.ask.asking import Refused
from rbpsym.derivation.assertions import Said
from rbpsym.derivation.step import Step, StepRef
from rbpsym.document.chapters import ends
from rbpsym.document.model import Block, Display, Emph, Inline, Inlines, ItemList, Math, Paragraph, Ref, Section, Text
from rbpsym.document.phrases import merged
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words, sentences
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.infix import RELATION_SIGNS, read_infix, read_relation
from rbpsym.statement.letters import letters_of

Found = Answer | Refused
Told = tuple[Words, tuple[Step, ...]]
MOST_WORDS = 9  # of a formula in a question
MARK = "`"  # stands around the formulas of a question in another language


# --- a question with its formulas


def question(text: str, said: Words) -> Inlines:
    """The question in the language of the notes if the file tells it so, with names and formulas set as such."""
    told = said.problem.questions.get(text, {}).get(said.language, "")
    return merged(_marked(told, said) if told else _spoken(text, said))


def _marked(text: str, said: Words) -> Iterator[Inline]:
    for place, part in enumerate(text.split(MARK)):
        yield (_formula(part, said) or Text(part)) if place % 2 else Text(part)


def _spoken(text: str, said: Words) -> Iterator[Inline]:
    """The words of the grammar; the longest runs that are formulas as formulas, bodies and their points by their names."""
    words, start = text.split(), 0
    while start < len(words):
        ways = range(min(len(words), start + MOST_WORDS), start, -1)
        found = next(((end, node) for end in ways if (node := _formula(" ".join(words[start:end]), said))), None)
        yield Text(" " if start else "")
        yield from (found[1],) if found else _thing(words[start], said)
        start = found[0] if found else start + 1


def _formula(text: str, said: Words) -> Math | None:
    read = read_relation if any(sign in text for sign in RELATION_SIGNS) else read_infix
    try:
        return Math(read(text, letters_of(said.problem).names))
    except RbpsymError:
        return None


def _thing(word: str, said: Words) -> Inlines:
    """A body, or a point of one, as the notes call it."""
    body, dot, _ = word.partition(".")
    if body not in said.problem.body_names:
        return (Text(word),)
    return said.label(word) if dot else said.the(body)


# --- the sections


def question_section(answers: Iterable[Found], said: Words, level: int) -> Section:
    """What is asked; in brief notes with the answers."""
    asked = [(found, question(text_of(found), said)) for found in answers]
    blocks: list[Block] = [Paragraph(said.say("question.intro", count=len(asked)))]
    for found, words in asked:
        blocks += [ItemList((words,)), *(_outcome(found, said, _box(found)) if said.is_brief else ())]
    if not said.is_brief:
        blocks[1:] = [ItemList(tuple(words for _, words in asked))]
    return Section(said.say("section.question"), tuple(blocks), said.prefix + "section.question", level)


def answer_section(answers: tuple[Found, ...], told: Iterable[Told], said: Words, level: int) -> Section:
    """Each answer with the steps that are not among those `told` before: what is shown is referred to, and what this level
    of detail leaves out there is left out here."""
    shown = {ends(step.statement): words.step(step.id)[0] for words, steps in told for step in steps}
    blocks: list[Block] = []
    for number, found in enumerate(answers, 1):
        if len(answers) > 1:
            blocks.append(Paragraph((Emph(question(text_of(found), said)),)))
        own = replace(said, prefix=f"{said.prefix}ask{number}.", same={}, owed={}, shown=frozenset())
        blocks += _outcome(found, said, ()) if isinstance(found, Refused) else _road(found, shown, own)
    return Section(said.say("section.answer"), tuple(blocks), said.prefix + "section.answer", level)


def text_of(found: Found) -> str:
    """The question as it was asked."""
    return found.text if isinstance(found, Refused) else found.question.text


def _road(found: Answer, shown: dict[t.Node, Inline], said: Words) -> Iterator[Block]:
    """The steps beyond what is told, and the outcome; adds to what is shown."""
    last = found.steps[-1:] if _states(found) else ()
    before = [replace(step, is_result=False) for step in found.steps[: len(found.steps) - len(last)]]
    known = {step.id: shown[ends(step.statement)] for step in before if ends(step.statement) in shown}
    new = [*(step for step in before if step.id not in known), *last]
    seen = {id: mark for id, mark in known.items() if isinstance(mark, Ref)}
    said = replace(said, shown=frozenset(step.id for step in new), elsewhere=seen)
    needed = {id for step in new for id in step.reasons} & seen.keys() or seen.keys()
    if seen:
        yield Paragraph(said.say("question.given", steps=[StepRef(id) for id in seen if id in needed]))
    yield from Teller(said).steps(new)
    shown |= {ends(step.statement): Ref(said.prefix + step.id) for step in new if step not in last}
    yield from _outcome(found, said, () if last else _box(found))


def _states(found: Answer) -> bool:
    """Is the last step what was asked?"""
    return bool(found.steps) and found.steps[-1].is_result


def _box(found: Found) -> tuple[Display, ...]:
    """The answer in its box, for where its step is not shown."""
    if isinstance(found, Refused) or not found.nodes:
        return ()
    if _states(found):
        return (Display(found.steps[-1].statement, numbered=False, boxed=True),)
    nodes = found.nodes if found.symbol == "" else [t.equation(t.Sym(found.symbol), node) for node in found.nodes]
    return tuple(Display(node, numbered=False, boxed=True) for node in nodes)


def _outcome(found: Found, said: Words, box: Iterable[Block]) -> Iterator[Block]:
    """The box, what is said beside it, the conditions, and whether it is proved."""
    yield from box
    if isinstance(found, Refused):
        yield Paragraph(said.say("question.refused", reason=found.reason))
        return
    told = [*_beside(found, said)]
    if found.valid:
        told.append(said.say("obligation.holds", conditions=list(found.valid), count=1))
    if found.verdict.is_proved:
        told.append(said.say("question.proved", ground=Said(steps=found.steps)))
    else:
        told.append(said.say("question.open", reason=found.verdict.reason))
    yield Paragraph(sentences([part for part in told if part]))


def _beside(found: Answer, said: Words) -> Iterator[Inlines]:
    """Yes or no, a sentence, the equation that is solved, where an extremum lies, each value's own condition."""
    if found.holds_so is not None:
        yield said.say("question.yes" if found.holds_so else "question.no")
    elif found.says:
        yield (Text(f"{found.says[0].upper()}{found.says[1:]}."),)
    if found.equation is not None:
        yield said.say("question.solves", name=t.Sym(found.symbol), equation=t.equation(found.equation, t.ZERO))
    if found.at is not None and found.at[0] != found.symbol:
        yield said.say("question.there", place=t.equation(t.Sym(found.at[0]), found.at[1]))
    for node, conditions in zip(found.nodes, found.each, strict=False):
        if conditions:
            yield said.say("question.each", value=node, conditions=list(conditions))
