"""Worksheets and keys in Spanish: no English word is left, and words are contracted and spaced as Spanish asks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from functools import cache

import pytest

from rbpsym.document.model import Text
from rbpsym.document.phrases import INLINES, grammar
from rbpsym.expr.tree import Node
from rbpsym.pictures.figures.scene import Scene
from rbpsym.teaching.papers.layout import key_document, paper_document
from rbpsym.teaching.plan import plan_of
from tests.library.test_spanish import ENGLISH, FEMININE, MASCULINE, PASSED

SHEETS = ("works-that-cancel", "spin-part", "ball-on-incline")


def told(value: object) -> Iterator[str]:
    """The sentences of a document, ⟨⟩ for what is no text."""
    if isinstance(value, tuple) and value and all(isinstance(part, INLINES) for part in value):
        yield "".join(part.text if isinstance(part, Text) else "⟨⟩" for part in value)
    elif isinstance(value, tuple):
        for part in value:
            yield from told(part)
    elif is_dataclass(value) and not isinstance(value, (Node, Scene)):
        for item in fields(value):
            yield from told(getattr(value, item.name))


@cache
def prose(name: str) -> tuple[str, ...]:
    sheet = plan_of(name).worksheet(None, "secret", "es")
    return tuple(text for document in (paper_document(sheet), key_document(sheet)) for text in told(document.sections))


@pytest.mark.parametrize("name", SHEETS)
def test_worksheets_are_spanish(name: str) -> None:
    assert not [line for line in prose(name) if ENGLISH.search(line.replace(name, ""))]


@pytest.mark.parametrize("name", SHEETS)
def test_their_grammar_holds(name: str) -> None:
    for line in prose(name):
        assert not re.search(r"\b(de|a) el\b|“|”| [,;:.](?=\s|$)|,,", line, re.IGNORECASE), line
        assert not re.search(r"\d\.\d", line), line
        for pattern, gender in ((MASCULINE, "masculine"), (FEMININE, "feminine")):
            for noun in pattern.findall(line):
                assert noun.lower() in PASSED or grammar("es").gender(noun) == gender, f"{noun}: {line}"
