"""What a student is told: the sentences of marks, in the language of the worksheet, and a page with answers and points."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from types import MappingProxyType
from typing import Any
from unicodedata import category

from markupsafe import Markup, escape

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.document.phrases import phrase_of
from rbpsym.document.translated import translated as document_translated
from rbpsym.document.writers.page import plain_text, shell
from rbpsym.errors import RbpsymError
from rbpsym.expr.glyphs import renamed
from rbpsym.expr.tree import Node
from rbpsym.languages import part_of
from rbpsym.teaching.grading.desk import Mark
from rbpsym.teaching.grading.judgement import Judgement, Remark, Status, sentence
from rbpsym.teaching.model import Slip, Worksheet
from rbpsym.teaching.papers.layout import own
from rbpsym.teaching.ranges import number_text
from rbpsym.teaching.wording import say_slip
from rbpsym.typeset.mathml import to_mathml

# --- what the readers say of an answer that can't be read, in the language of the worksheet


def translated(sentence: str, language: str) -> str:
    """The sentence in a language; as it is if that is English or the sentence is not known.

    >>> translated("unknown symbol “v”", "es")
    'el símbolo «v» no se conoce'
    """
    return document_translated(sentence, language, "worksheets")


def reason(error: RbpsymError, language: str) -> str:
    """What is wrong and what to write instead, as sentences."""
    what = translated(error.what, language)
    instead = translated(error.instead, language) if error.instead else ""
    return " ".join(filter(None, (sentence(what), sentence(instead) if instead else "")))


# --- the sentences of marks, [remark] of the phrases. {name} is a place; a tree in a place is printed as a formula


_NAME = re.compile(r"[A-Za-z]\w*_\w+")
_NOTHING: Mapping[str, str] = MappingProxyType({})
SaySlip = Callable[[Slip, str], Inlines]


def said(remark: Remark, language: str, say_slip: SaySlip, called: Mapping[str, str] = _NOTHING) -> Inlines:
    """A remark as a sentence; `called` is what bodies are called in the language, in which what the readers say is told too."""
    error = remark.slots.get("error")
    slots = {name: translated(value, language) if isinstance(value, str) else value for name, value in remark.slots.items()}
    if isinstance(error, RbpsymError):
        slots["why"] = _NAME.sub(lambda name: renamed(name[0], called), reason(error, language))
    told = {name: tuple(_inlines(value, language, say_slip)) for name, value in slots.items()}
    return phrase_of("worksheets", f"remark.{remark.key}", language, told)


def _inlines(value: Any, language: str, say_slip: SaySlip) -> Iterator[Any]:
    if isinstance(value, Node):
        yield Math(value)
    elif isinstance(value, Slip):
        yield from say_slip(value, language)
    elif isinstance(value, tuple):
        for place, item in enumerate(value):
            yield from ((Text(", "),) if place else ())
            yield from _inlines(item, language, say_slip)
    else:
        yield Text(str(value))


def comment(judgement: Judgement, language: str, say_slip: SaySlip, called: Mapping[str, str] = _NOTHING) -> Inlines:
    """All remarks of a judgement, one after the other."""
    found: list[Any] = []
    for remark in judgement.remarks:
        found += [Text(" ")] if found else []
        found += said(remark, language, say_slip, called)
    return tuple(found)


# ---


LONGEST_ANSWER = 400


def remarks_of(mark: Mark, worksheet: Worksheet) -> Inlines:
    """The remarks of a mark in the language of the worksheet; a word of praise where all is right."""
    words = part_of("feedback", worksheet.language, "worksheets")
    problem = worksheet.problems.get(worksheet.part_of(mark.item).problem) if mark.item else None
    speaker = partial(say_slip, problems=() if problem is None else (problem,))
    called = problem.names_in(worksheet.language) if problem else {}
    found = comment(mark.judgement, worksheet.language, speaker, called)
    if mark.judgement.status is Status.RIGHT and not found:
        found = (Text(words["right"]),)
    return (*found, Text(f" {words['teacher']}")) if mark.judgement.is_for_teacher else found


def remarks_text(mark: Mark, worksheet: Worksheet) -> str:
    """The remarks as plain text on one line, for a table."""
    lines = plain_text(remarks_of(mark, worksheet), worksheet.notation, worksheet.language).splitlines()
    return visible("; ".join(" ".join(line.split()) for line in lines if line.strip()))


def feedback_page(worksheet: Worksheet, marks: tuple[Mark, ...], student: str) -> str:
    """The page of one student as HTML."""
    words = part_of("feedback", worksheet.language, "worksheets")
    return shell(
        "feedback.html",
        autoescape=True,
        language=worksheet.language,
        title=plain_text(worksheet.title, worksheet.notation, worksheet.language),
        student=student,
        code=worksheet.code,
        words=words,
        total=_points(sum((mark.points for mark in marks), Fraction(0)), worksheet),
        most=_points(worksheet.points, worksheet),
        rows=[_row(mark, worksheet) for mark in marks],
    )


def _points(value: Fraction, worksheet: Worksheet) -> str:
    """Points with the decimal mark of the worksheet."""
    return number_text(value, worksheet.notation.decimal)


def _row(mark: Mark, worksheet: Worksheet) -> dict[str, object]:
    shown = mark.answer if len(mark.answer) <= LONGEST_ANSWER else mark.answer[:LONGEST_ANSWER] + "…"
    return {
        "item": mark.item,
        "answer": visible(shown),
        "points": _points(mark.points, worksheet),
        "most": _points(mark.most, worksheet),
        "kind": "right" if mark.judgement.credit == 1 else "part" if mark.judgement.credit else "none",
        "remarks": _html(remarks_of(mark, worksheet), worksheet),
        "shown": [visible(text, "\n ") for r in mark.judgement.remarks if (text := r.slots.get("shown"))],
    }


def visible(text: str, kept: str = " ") -> str:
    """Text in which no character is invisible: controls and marks of direction are shown by their codes."""
    return "".join(" " if category(c) == "Zs" else c if c.isprintable() or c in kept else f"⟨U+{ord(c):04X}⟩" for c in text)


def _html(inlines: Inlines, worksheet: Worksheet) -> Markup:
    parts = (
        Markup(to_mathml(part.node, worksheet.notation))
        if isinstance(part, Math)
        else escape(visible(plain_text((part,), worksheet.notation, worksheet.language)))
        for part in inlines
    )
    return Markup("").join(parts)


def file_name(student: str) -> str:
    """The name of a student's page: safe in any folder, and another one for each student."""
    return f"{own(student)}.html"
