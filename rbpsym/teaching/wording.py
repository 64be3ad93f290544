"""The sentences of worksheets, in the reader's language: phrases of `phrases/<language>.toml`.

They are filled as those of the notes are (`document.phrases`): places take formulas, words, bodies.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rbpsym.document import phrases
from rbpsym.document.model import Inlines
from rbpsym.document.words import Words
from rbpsym.errors import RbpsymError
from rbpsym.statement.model import Problem

# What asserts something of a system, and who decides that it is so; all other phrases ask, name or narrate.
ASSERTIONS: Mapping[str, str] = {
    **{f"ask.{task}.frequency": "targets.ASSERTED" for task in ("choose", "number", "formula", "compare")},
    **{f"ask.{task}.loss": "targets.ASSERTED" for task in ("choose", "number", "formula")},
    "compare.why": "tasks.compare._answer",
    "misconception": "misconceptions.model.Site",
}

FOLDER = Path(__file__).with_name("phrases")


def languages() -> tuple[str, ...]:
    """The languages in which worksheets can be written."""
    return phrases.languages(FOLDER)


def teaching_phrases(language: str) -> Mapping[str, str]:
    """All templates of a language by dotted key. Raises RbpsymError for a language that is not there."""
    if language not in languages():
        raise RbpsymError(f"there are no worksheets in “{language}”", instead=f"languages: {', '.join(languages())}.")
    return phrases.phrases(language, FOLDER)


def say(key: str, language: str = "en", problem: Problem | None = None, **slots: Any) -> Inlines:
    """A phrase with its places filled; `problem` tells what its bodies are called.

    Raises DocumentError for a missing phrase or place.
    """
    return spoken(Words(language, problem), key, **slots)


def spoken(said: Words, key: str, **slots: Any) -> Inlines:
    """A phrase in the words of a problem."""
    return phrases.phrase_of(FOLDER, key, said.language, said.slots(slots))


def plain_text(key: str, language: str = "en", **slots: Any) -> str:
    """A phrase that holds nothing but text, as a string."""
    return phrases.text_of(say(key, language, **slots), key)


def has(key: str, language: str = "en") -> bool:
    """Whether there is a phrase (or one with variants) under a key."""
    return phrases.has_phrase(key, language, FOLDER)
