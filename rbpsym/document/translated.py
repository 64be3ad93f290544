"""Sentences of the engine, which speaks English, in the language of a page.

As in gettext, the English sentence with its places is the key of its translation, in the table [sentence] of a phrases file;
what fills a place is found again by matching.
"""

from __future__ import annotations

import re
from functools import cache

from rbpsym.languages import phrases

TABLE = "sentence."
Entry = tuple[re.Pattern[str], str]


def translated(sentence: str, language: str, part: str = "notes") -> str:
    """The sentence by the phrases of one part of a language; as it is if that is English or it is not known.

    >>> translated("it is not proved; “P” is negative: its magnitude is meant", "es")
    'no está demostrado; «P» es negativo: se pide su valor absoluto'
    """
    for pattern, told in _catalogue(language, part):
        found = pattern.fullmatch(sentence)
        if found:
            return filled(told, {name: translated(text, language, part) for name, text in found.groupdict().items()})
    return sentence


def filled(text: str, parts: dict[str, str]) -> str:
    """The template with its places filled; other braces are those of LaTeX."""
    return re.sub(r"\{([a-d])\}", lambda found: parts.get(found[1], found[0]), text)


@cache
def _catalogue(language: str, part: str) -> tuple[Entry, ...]:
    """Patterns of English sentences with their translations, those with the most words of their own first."""
    table = phrases(language, part)
    keys = sorted((key for key in table if key.startswith(TABLE)), key=lambda key: -len(_PLACE.sub("", key)))
    return tuple((_pattern(key.removeprefix(TABLE)), table[key]) for key in keys)


_PLACE = re.compile(r"\{([a-d])\}")


def _pattern(key: str) -> re.Pattern[str]:
    pieces = _PLACE.split(key)
    parts = (f"(?P<{piece}>.+?)" if place % 2 else re.escape(piece) for place, piece in enumerate(pieces))
    return re.compile("".join(parts), re.DOTALL)
