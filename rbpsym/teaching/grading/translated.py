"""What the readers say of an answer that can't be read, in the language of the worksheet.

Readers speak English. As in gettext, the English sentence with its places is the key of its translation, in the table
[reader] of a phrases file; what fills a place is found again by matching.
"""

from __future__ import annotations

import re
from functools import cache

from rbpsym.errors import RbpsymError
from rbpsym.teaching.grading.judgement import sentence
from rbpsym.teaching.wording import teaching_phrases

TABLE = "reader."
Entry = tuple[re.Pattern[str], str]


def translated(sentence: str, language: str) -> str:
    """The sentence in a language; as it is if that is English or the sentence is not known.

    >>> translated("unknown symbol “v”", "es")
    'el símbolo «v» no se conoce'
    """
    for pattern, text in _catalogue(language):
        found = pattern.fullmatch(sentence)
        if found:
            return filled(text, {name: translated(part, language) for name, part in found.groupdict().items()})
    return sentence


def reason(error: RbpsymError, language: str) -> str:
    """What is wrong and what to write instead, as sentences."""
    what = translated(error.what, language)
    instead = translated(error.instead, language) if error.instead else ""
    return " ".join(filter(None, (sentence(what), sentence(instead) if instead else "")))


def filled(text: str, parts: dict[str, str]) -> str:
    """The template with its places filled; other braces are those of LaTeX."""
    return re.sub(r"\{([a-d])\}", lambda found: parts.get(found[1], found[0]), text)


@cache
def _catalogue(language: str) -> tuple[Entry, ...]:
    """Patterns of English sentences with their translations, those with the most words of their own first."""
    table = teaching_phrases(language)
    keys = sorted((key for key in table if key.startswith(TABLE)), key=lambda key: -len(_PLACE.sub("", key)))
    return tuple((_pattern(key.removeprefix(TABLE)), table[key]) for key in keys)


_PLACE = re.compile(r"\{([a-d])\}")


def _pattern(key: str) -> re.Pattern[str]:
    pieces = _PLACE.split(key)
    parts = (f"(?P<{piece}>.+?)" if place % 2 else re.escape(piece) for place, piece in enumerate(pieces))
    return re.compile("".join(parts), re.DOTALL)
