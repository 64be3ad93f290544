"""Texts of a file: one for all languages, or one a language."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.statement.source import Table


def worded(table: Table, key: str, default: str = "") -> Mapping[str, str]:
    """A text by language; one that is not told apart is taken for English."""
    if not isinstance(table.data.get(key), Mapping):
        return {"en": table.string(key, default)}
    texts = strings(table, key)
    check_languages(table.table(key, key), f'write {key} = {{ en = "...", es = "..." }}')
    return texts


def check_languages(section: Table, cure: str) -> None:
    """The keys of a table by language are codes of languages."""
    for language in section.names():
        if not re.fullmatch(r"[a-z]{2,3}", language):
            raise section.error(f"“{language}” is no language", cure, language)


def strings(table: Table, key: str) -> dict[str, str]:
    """A table of texts."""
    section = table.table(key, f"“{key}”")
    return {name: section.string(name) for name in section.names()}
