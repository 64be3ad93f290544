"""What exports say: feedback of slips, captions, and the sentences about what a format can't carry."""

from __future__ import annotations

from collections.abc import Iterable

from rbpsym.derivation.step import BodyRef
from rbpsym.document.model import Inlines, Math, Text
from rbpsym.document.writers.plain_text import plain_text
from rbpsym.errors import RbpsymError
from rbpsym.notation.tree import Node
from rbpsym.statement.model import Problem
from rbpsym.teaching.model import Item, Slip, Worksheet
from rbpsym.teaching.wording import say, teaching_phrases


def word(key: str, language: str) -> str:
    """A word in the language of a worksheet."""
    return teaching_phrases(language)[f"exports.{key}"]


def say_slip(slip: Slip, language: str, problems: Iterable[Problem] = ()) -> Inlines:
    """The feedback of a misconception; its name where there is no phrase for it.

    `problems` are those of the worksheet: the one with the bodies of the slip tells what they are called.
    """
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
    return f"{plain_text(worksheet.title, worksheet.notation, worksheet.language)} {worksheet.code} {item.id}"[:240]


def left_out(format_name: str, items: Iterable[tuple[Item, str]]) -> tuple[str, ...]:
    """A sentence for each thing that a format can't carry, with the items that it concerns."""
    found: dict[str, list[str]] = {}
    for item, what in items:
        places = found.setdefault(what, [])
        if item.id not in places:
            places.append(item.id)
    return tuple(f"{format_name}: {what} (item {', '.join(places)})." for what, places in found.items())
