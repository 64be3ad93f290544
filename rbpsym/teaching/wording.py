"""The sentences of worksheets, in the reader's language: phrases of `phrases/<language>.toml`.

They are filled as those of the notes are (`document.phrases`): places take formulas, words, bodies.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any

from rbpsym.document.model import DocumentError, Inlines, Text
from rbpsym.document.phrases import contracted, filled, flatten, grammar, merged
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
    return tuple(sorted(path.stem for path in FOLDER.glob("*.toml")))


@cache
def teaching_phrases(language: str) -> Mapping[str, str]:
    """All templates of a language by dotted key. Raises RbpsymError for a language that is not there."""
    path = FOLDER / f"{language}.toml"
    if language not in languages():
        raise RbpsymError(f"there are no worksheets in “{language}”", instead=f"languages: {', '.join(languages())}.")
    return dict(flatten("", tomllib.loads(path.read_text(encoding="utf-8"))))


def say(key: str, language: str = "en", problem: Problem | None = None, **slots: Any) -> Inlines:
    """A phrase with its places filled; `problem` tells what its bodies are called.

    Raises DocumentError for a missing phrase or place.
    """
    return spoken(Words(language, problem), key, **slots)


def spoken(said: Words, key: str, **slots: Any) -> Inlines:
    """A phrase in the words of a problem."""
    filled_slots = said.slots(slots)
    text = _template(key, said.language, filled_slots)
    return contracted(merged(filled(text, key, said.language, filled_slots)), said.language)


def plain_text(key: str, language: str = "en", **slots: Any) -> str:
    """A phrase that holds nothing but text, as a string."""
    found = say(key, language, **slots)
    if not all(isinstance(inline, Text) for inline in found):
        raise DocumentError(f"phrase “{key}” is more than text")
    return "".join(inline.text for inline in found)


def has(key: str, language: str = "en") -> bool:
    """Whether there is a phrase (or one with variants) under a key."""
    table = teaching_phrases(language)
    return key in table or any(name.startswith(f"{key}.") for name in table)


def _template(key: str, language: str, slots: Mapping[str, Any]) -> str:
    table = teaching_phrases(language)
    for wanted in (f"{key}.{_variant(language, slots)}", key):
        if wanted in table:
            return table[wanted]
    near = get_close_matches(key, table, n=1)
    raise DocumentError(
        f"no phrase “{key}” for worksheets in “{language}”", instead=f"did you mean “{near[0]}”?" if near else ""
    )


def _variant(language: str, slots: Mapping[str, Any]) -> str:
    if "variant" in slots:
        return str(slots["variant"])
    return grammar(language).number(slots["count"]) if "count" in slots else ""
