"""The author's own words in a course, as blocks; what is bound to no claim must assert nothing of a system.

The rule: a sentence without a claim holds no formula, no digit, and none of the words by which one compares, counts or
gives a sign, `own_text.words` of the phrases of its language.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache

from rbpsym.document.model import Block, Display, Inlines, Paragraph
from rbpsym.document.phrases import filled, merged
from rbpsym.expr import tree as t
from rbpsym.languages import languages, phrases
from rbpsym.statement.course import Course
from rbpsym.statement.own_text import OwnFormula, OwnParagraph, Sentence

Formulas = Mapping[tuple[str, str], t.Node]
BIND = "bind it to a claim, “... {claim:ID}” (docs/courses.md shows how), or say it otherwise."


def check_unbound(course: Course) -> None:
    """Refuse a sentence that asserts something and is bound to no claim. Raises StatementError."""
    for part in course.parts:
        for language, sentence in part.sentences:
            found = "" if sentence.claims else asserting(sentence, language)
            if found:
                raise sentence.error(f"“{sentence.told}” is bound to no claim, but holds {found}", BIND)


def asserting(sentence: Sentence, language: str) -> str:
    """What in a sentence tells a quantity, a sign or a comparison; "" if nothing does."""
    if any(isinstance(piece, OwnFormula) for piece in sentence.pieces):
        return "a formula"
    found = re.search(r"\d+", sentence.words) or comparing(language).search(sentence.words)
    return f"“{found[0]}”" if found else ""


@cache
def comparing(language: str) -> re.Pattern[str]:
    """The words that compare, count or give a sign; those of English in a language that has no phrases."""
    words = phrases(language if language in languages() else "en")["own_text.words"].split(", ")
    return re.compile(rf"\b(?:{'|'.join(map(re.escape, words))})\b", re.IGNORECASE)


def own_blocks(paragraphs: tuple[OwnParagraph, ...], formulas: Formulas) -> Iterator[Block]:
    """The author's paragraphs, with the formulas that were decided."""
    for sentences in paragraphs:
        if sentences[0].display:
            yield Display(formulas[sentences[0].claims[0], ""], numbered=False)
        else:
            parts = (inline for one in sentences for inline in _inlines(one, formulas))
            yield Paragraph(merged(parts))


def _inlines(sentence: Sentence, formulas: Formulas) -> Inlines:
    """Words, of which those between * are emphasised, and formulas."""
    slots = {f"f{k}": formulas[sentence.claims[0], p.latex] for k, p in enumerate(sentence.pieces) if isinstance(p, OwnFormula)}
    text = "".join(f"{{f{k}}}" if isinstance(p, OwnFormula) else p for k, p in enumerate(sentence.pieces))
    return tuple(filled(text, "own text", "en", slots))
