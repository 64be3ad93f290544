"""A question in the problem's words as a sentence: its names and formulas are set as such, bodies called by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rbpsym.ask.special import COEFFICIENT
from rbpsym.document.model import Inline, Inlines, Math, Text
from rbpsym.document.phrases import merged, plain
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import RELATION_SIGNS, read_infix, read_relation
from rbpsym.frozen import replace
from rbpsym.languages import worded
from rbpsym.statement.own_text import letters_of

if TYPE_CHECKING:
    from rbpsym.document.words import Words

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
