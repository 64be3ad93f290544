"""Slots of steps as words and formulas of a language."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.ask.special import COEFFICIENT
from rbpsym.document.model import Inline, Inlines, Math, Ref, Text
from rbpsym.document.phrases import merged, phrase, plain, problem_notation, usual_notation
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation, spaced
from rbpsym.expr.infix import RELATION_SIGNS, read_infix, read_relation
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, field, replace
from rbpsym.languages import in_language, phrases, title_in, worded
from rbpsym.proof.assertions import on_page
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import FULL, STANDARD, BodyRef, PhraseRef, QuestionRef, StepRef
from rbpsym.statement.model import Problem
from rbpsym.statement.own_text import letters_of


class Words(Frozen):
    """How a document speaks of a problem: its language, what labels are there, the bodies' names.

    `prefix` keeps labels of several problems in one document apart; `shown` are the ids of the
    steps that are displayed, so that only these are referred to by number; `same` maps a step
    that repeats an earlier one to it; `elsewhere` has the references of steps that an earlier
    phase showed; `owed`: conditions under which the formula of a step holds;
    `level` of detail, from 1 to 3; `is_brief` where nothing is introduced;
    `is_later` of a later phase of a motion, where introductions
    have been given already; `is_posed` where the statement stands before, with its
    figure; `locate` says a point of a body as it is seen in the figure.
    """

    language: str
    problem: Problem | None = None
    prefix: str = ""
    shown: frozenset[str] = frozenset()
    same: Mapping[str, str] = field(default_factory=dict)
    is_later: bool = False
    is_brief: bool = False
    is_posed: bool = False
    level: int = STANDARD
    elsewhere: Mapping[str, Ref] = field(default_factory=dict)
    owed: Mapping[str, tuple[Node, ...]] = field(default_factory=dict)
    locate: Callable[[str, str, Words], Inlines] | None = field(default=None, compare=False)

    @property
    def is_full(self) -> bool:
        """Is everything shown?"""
        return self.level == FULL

    @property
    def notation(self) -> Notation:
        """How formulas are printed: in the notation of the problem and of the language."""
        return problem_notation(self.problem, self.language) if self.problem else usual_notation(self.language)

    def say(self, key: str, *, ground: Said | None = None, **slots: Any) -> Inlines:
        """A phrase with all its slots turned into words.

        What asserts something of more than one step is said of a `ground` on which it is true; else what is true there.
        """
        found = on_page(key, ground)
        return phrase(found, self.language, **self.slots(slots)) if found else ()

    def slots(self, slots: Mapping[str, Any]) -> dict[str, Any]:
        """The slots as the phrases take them; a body or a list of points is also there with a capital letter."""
        found: dict[str, Any] = {}
        for name, value in slots.items():
            found[name] = self.word([t.upright(node) for node in value] if name == "conditions" else value)
            if isinstance(value, (BodyRef, PhraseRef)):
                found[name[0].upper() + name[1:]] = self._first(value, found[name])
            elif isinstance(value, list) and value:
                found[name[0].upper() + name[1:]] = [self._first(value[0], found[name][0]), *found[name][1:]]
        return found

    def _first(self, value: Any, word: Any) -> Any:
        """As a sentence begins with it; a body that is called by a letter keeps this: s is not S."""
        return word if isinstance(value, BodyRef) and len(self.body(value.name)) == 1 else capital(word)

    def word(self, value: Any) -> Any:
        """One slot."""
        if isinstance(value, BodyRef):
            return self.the(value.name)
        if isinstance(value, StepRef):
            return self.step(value.id)
        if isinstance(value, QuestionRef):
            return question(value.text, self)
        if isinstance(value, PhraseRef):
            return self.say(value.key, **value.slots) or (Text(""),)
        if isinstance(value, Mapping):
            return self.title(value)
        return self.several(value) if isinstance(value, list) else value

    def several(self, values: list[Any]) -> list[Any]:
        """A list of slots; steps that are not shown are left out of a list of steps."""
        if values and all(isinstance(value, StepRef) for value in values):
            marks = [self.step(value.id) for value in values if self.is_seen(value.id)]
            return list(dict.fromkeys(marks)) or [phrase("ref.above", self.language)]
        return [self.label(value) if isinstance(value, str) else self.word(value) for value in values]

    def are_unseen(self, values: Any) -> bool:
        """Is it a list of steps of which none is displayed?"""
        if not isinstance(values, list) or not values or not all(isinstance(value, StepRef) for value in values):
            return False
        return not any(self.is_seen(value.id) for value in values)

    def is_seen(self, id: str) -> bool:
        """Is the formula of a step displayed somewhere?"""
        return id in self.elsewhere or self.same.get(id, id) in self.shown

    def label(self, text: str) -> Inlines:
        """A point as the file names it: "rod.end" is the end of the rod."""
        body, _, point = text.partition(".")
        if point and self.problem and body in self.problem.body_names:
            if self.locate is not None:
                return self.locate(body, point, self)
            return phrase("point.of", self.language, point=self.named(point), body=self.the(body))
        return (Text(text),)

    def step(self, id: str) -> Inlines:
        """The number of a step, or a word for one that is not shown."""
        if id in self.elsewhere:
            return (self.elsewhere[id],)
        first = self.same.get(id, id)
        return (Ref(self.prefix + first),) if first in self.shown else phrase("ref.above", self.language)

    def title(self, titles: Mapping[str, str]) -> str:
        """A text given by language, English or any if there is none in this one."""
        return title_in(titles, self.language)

    def told(self, texts: Mapping[str, tuple[Any, ...]]) -> tuple[Any, ...]:
        """The author's paragraphs in this language, in English or in any if there are none in this one."""
        return in_language(texts, self.language, ())

    def body(self, name: str) -> str:
        """What a body is called: its meaning in this language, else its name."""
        if self.problem is None:
            return name.replace("_", " ")
        translated = self.problem.meanings.get(self.language, {}).get(name)
        own = self.problem.body(name).meaning if name in self.problem.body_names else ""
        return translated or worded(own or spaced(name), self.language)

    def the(self, name: str) -> Inlines:
        """The body with its article; one with a number or letter of its own has none."""
        return self._called(name, "body.the", "body.named")

    def stressed(self, name: str) -> Inlines:
        """The body with its article, emphasised."""
        return self._called(name, "body.stressed", "body.stressed_named")

    def _called(self, name: str, common: str, proper: str) -> Inlines:
        word = self.body(name)
        is_proper = word[-1:].isdigit() or len(word.split()[-1]) == 1
        return phrase(proper if is_proper else common, self.language, body=word)

    def named(self, name: str) -> str:
        """What a point or phase is called: its name in this language, else the one in the file as words."""
        called = self.problem.names.get(self.language, {}) if self.problem else {}
        return called.get(name) or worded(spaced(name), self.language)

    def meaning(self, name: str, own: str) -> str:
        """What a quantity means, in this language if the author gave it."""
        return (self.problem.meanings.get(self.language, {}).get(name) if self.problem else None) or worded(own, self.language)

    def has(self, key: str) -> bool:
        """Whether there are words under a key (an empty phrase means: nothing is said)."""
        table = phrases(self.language)
        return bool(table.get(key)) or any(name.startswith(f"{key}.") for name in table)


def capital(inlines: Inlines) -> Inlines:
    """The inlines with a capital first letter, if they begin with text."""
    if isinstance(inlines, tuple) and inlines and isinstance(inlines[0], Text) and inlines[0].text:
        first = inlines[0].text
        return (Text(first[0].upper() + first[1:]), *inlines[1:])
    return inlines


def small(inlines: Inlines) -> Inlines:
    """The same within a sentence."""
    first = inlines[0]
    return (Text(first.text[0].lower() + first.text[1:]), *inlines[1:]) if isinstance(first, Text) and first.text else inlines


def sentences(parts: list[Inlines]) -> Inlines:
    """Sentences with a space between them."""
    found: list[Any] = []
    for part in parts:
        found += [Text(" ")] if found else []
        found += part
    return tuple(found)


# --- a question in the problem's words as a sentence: its names and formulas are set as such, bodies called by their names


MOST_WORDS = 9  # of a formula in a question
MARK = "`"  # stands around the formulas of a question in another language


def question(text: str, said: Words) -> Inlines:
    """The question in the language of the page if the file tells it so, else as it is asked."""
    told = said.problem.questions.get(text, {}).get(said.language) if said.problem else None
    told = told or worded(f"asked.{text}", said.language)
    if told != f"asked.{text}":
        return merged(_marked(told, said))
    return spoken(_with_articles(text, said), replace(said, language="en"))  # as it is asked, the bodies in its language


BEFORE = r"(?:^|(?<=^does )|(?<=^is )|(?<=which )|(?<=where )|(?<=when )|(?<=until )|(?<= of ))"


def _with_articles(text: str, said: Words) -> str:
    """“the speed of x when “rolling” begins” of “speed of x when rolling begins”."""
    nouns = plain("question.nouns").replace(", ", "|")
    text = re.sub(rf"{BEFORE}(?={nouns})(?=\S+(?: |$))", "the ", text)
    names = "|".join(re.escape(phase.name) for phase in (said.problem.phases if said.problem else ()))
    text = re.sub(rf"\b({names}) begins", "“\\1” begins", text) if names else text
    text = re.sub(rf"^does (.+?) ({plain('question.verbs').replace(', ', '|')})\b", r"whether \1 \2s", text)
    text = re.sub(r"^is (.+?) (stable|unstable|conserved|kept|constant)$", r"whether \1 is \2", text)
    return re.sub(r"^(\w+) (?=for which )", r"the \1 ", text)


def spoken(text: str, said: Words) -> Inlines:
    """What is said in the words of the grammar, its names and formulas set as such."""
    return merged(_spoken(text, said))


def _marked(text: str, said: Words) -> Iterator[Inline]:
    for place, part in enumerate(text.split(MARK)):
        yield (_formula(part, said) or Text(part)) if place % 2 else Text(part)


def _spoken(text: str, said: Words) -> Iterator[Inline]:
    """The words of the grammar; the longest runs that are formulas as formulas. A body has its article by itself."""
    bodies, words, start = said.problem.body_names if said.problem else (), text.split(), 0
    words = [word for word, then in zip(words, (*words[1:], ""), strict=True) if word != "the" or then not in bodies]
    while start < len(words):
        is_article = words[start : start + 2] == ["a", "function"]  # no letter
        ways = range(start if is_article else min(len(words), start + MOST_WORDS), start, -1)
        found = next(((end, node) for end in ways if (node := _formula(" ".join(words[start:end]), said))), None)
        yield Text(" " if start else "")
        yield from (found[1],) if found else _thing(words[start], said)
        start = found[0] if found else start + 1


def _formula(text: str, said: Words) -> Math | None:
    read = read_relation if any(sign in text for sign in RELATION_SIGNS) else read_infix
    if said.problem is None:
        return None
    blows = (element for phase in said.problem.phases for element in phase.impulses)
    struck = {name for element in blows for name in (element.name, element.values.get("friction")) if name}
    try:
        return Math(read(text, letters_of(said.problem).names | {"t", COEFFICIENT, *struck}))
    except RbpsymError:
        return None


def _thing(word: str, said: Words) -> Inlines:
    """A body, or a point of one, as the page calls it."""
    body, dot, _ = word.partition(".")
    if said.problem is None or body not in said.problem.body_names:
        return (Text(word),)
    return said.label(word) if dot else said.the(body)
