"""What worksheets say: their phrases, filled; the feedback of slips, and the sentences about what a format can't carry."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.document.phrases import phrase_of, text_of
from rbpsym.document.words import Words
from rbpsym.document.writers.page import plain_text as bare
from rbpsym.errors import RbpsymError
from rbpsym.expr.tree import Node
from rbpsym.languages import phrases
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Problem
from rbpsym.teaching.model import Item, Slip, Worksheet


def say(key: str, language: str = "en", problem: Problem | None = None, **slots: Any) -> Inlines:
    """A phrase with its places filled; `problem` tells what its bodies are called.

    Raises DocumentError for a missing phrase or place.
    """
    return spoken(Words(language, problem), key, **slots)


def spoken(said: Words, key: str, **slots: Any) -> Inlines:
    """A phrase in the words of a problem."""
    return phrase_of("worksheets", key, said.language, said.slots(slots))


def plain_text(key: str, language: str = "en", **slots: Any) -> str:
    """A phrase that holds nothing but text, as a string."""
    return text_of(say(key, language, **slots), key)


# --- what exports say: feedback of slips, captions, and the sentences about what a format can't carry


def word(key: str, language: str) -> str:
    """A word in the language of a worksheet."""
    return phrases(language, "worksheets")[f"exports.{key}"]


def say_slip(slip: Slip, language: str, problems: Iterable[Problem] = ()) -> Inlines:
    """The feedback of a misconception, and of the others that give the same; its name where there is no phrase for it.

    `problems` are those of the worksheet: the one with the bodies of the slip tells what they are called.
    """
    known = tuple(problems)
    others = (say("paper.also", language, comment=_said(other, language, known)) for other in slip.also)
    return (*_said(slip, language, known), *(part for told in others for part in told))


def _said(slip: Slip, language: str, problems: tuple[Problem, ...]) -> Inlines:
    bodies = {value.name for value in slip.slots.values() if isinstance(value, BodyRef)}
    problem = next((found for found in problems if bodies <= set(found.body_names)), None)
    try:
        return say(slip.phrase, language, problem, **slip.slots)
    except RbpsymError:
        return (Text(slip.name.replace("-", " ").capitalize() + "."),)


def feedback(slip: Slip | None, worksheet: Worksheet) -> Inlines:
    """The feedback of a wrong answer, with the first wrong step as it should be."""
    if slip is None:
        return (Text(word("wrong", worksheet.language)),)
    first: Inlines = (Text(" "), Math(slip.shown)) if isinstance(slip.shown, Node) else ()
    return (*say_slip(slip, worksheet.language, worksheet.problems.values()), *first)


def name_of(item: Item, worksheet: Worksheet) -> str:
    """The name of a question in a question bank: title, form code, number."""
    return f"{bare(worksheet.title, worksheet.notation, worksheet.language)} {worksheet.code} {item.id}"[:240]


def left_out(format_name: str, items: Iterable[tuple[Item, str]]) -> tuple[str, ...]:
    """A sentence for each thing that a format can't carry, with the items that it concerns."""
    found: dict[str, list[str]] = {}
    for item, what in items:
        places = found.setdefault(what, [])
        if item.id not in places:
            places.append(item.id)
    return tuple(f"{format_name}: {what} (item {', '.join(places)})." for what, places in found.items())
