"""Inlines as plain text: for titles in metadata, alt texts and terminals."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.document.model import Emph, Inlines, Math, Ref, Strong, Text
from rbpsym.document.writers.page import Page, Print
from rbpsym.expr.glyphs import Notation
from rbpsym.typeset.text import to_text

PLAIN: Mapping[type, Print] = {
    Text: lambda inline, page: inline.text,
    Math: lambda inline, page: to_text(inline.node, page.notation),
    Ref: lambda inline, page: inline.mark,
    Emph: lambda inline, page: page.inlines(inline.inlines),
    Strong: lambda inline, page: page.inlines(inline.inlines),
}


def plain_text(inlines: Inlines, notation: Notation, language: str = "en") -> str:
    """The inlines without any markup."""
    return Page(PLAIN, notation, language).inlines(inlines)
