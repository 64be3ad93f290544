"""Slots of steps as words and formulas of a language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rbpsym.derivation.step import BodyRef, PhraseRef, StepRef
from rbpsym.document.model import Inlines, Ref, Text
from rbpsym.document.phrases import phrase, phrases
from rbpsym.statement.model import Problem


@dataclass(frozen=True)
class Words:
    """How a document speaks of a problem: its language, what labels are there, the bodies' names.

    `prefix` keeps labels of several problems in one document apart; `shown` are the ids of the
    steps that are displayed, so that only these are referred to by number.
    """

    language: str
    problem: Problem | None = None
    prefix: str = ""
    shown: frozenset[str] = frozenset()

    def say(self, key: str, **slots: Any) -> Inlines:
        """A phrase with all its slots turned into words."""
        return phrase(key, self.language, **self.slots(slots))

    def slots(self, slots: Mapping[str, Any]) -> dict[str, Any]:
        """The slots as the phrases take them; a body is also there with a capital letter."""
        found: dict[str, Any] = {}
        for name, value in slots.items():
            found[name] = self.word(value)
            if isinstance(value, (BodyRef, PhraseRef)):
                found[name[0].upper() + name[1:]] = capital(found[name])
        return found

    def word(self, value: Any) -> Any:
        """One slot."""
        if isinstance(value, BodyRef):
            return phrase("body.the", self.language, body=self.body(value.name))
        if isinstance(value, StepRef):
            return (Ref(self.prefix + value.id),) if value.id in self.shown else phrase("ref.above", self.language)
        if isinstance(value, PhraseRef):
            return self.say(value.key, **value.slots) or (Text(""),)
        if isinstance(value, Mapping):
            return self.title(value)
        return [self.word(item) for item in value] if isinstance(value, list) else value

    def title(self, titles: Mapping[str, str]) -> str:
        """A text given by language, English or any if there is none in this one."""
        return titles.get(self.language) or titles.get("en") or next(iter(titles.values()), "")

    def body(self, name: str) -> str:
        """What a body is called: its meaning in this language, else its name."""
        if self.problem is None:
            return name.replace("_", " ")
        translated = self.problem.meanings.get(self.language, {}).get(name)
        own = self.problem.body(name).meaning if name in self.problem.body_names else ""
        return (translated or own or name).replace("_", " ")

    def meaning(self, name: str, own: str) -> str:
        """What a quantity means, in this language if the author gave it."""
        return (self.problem.meanings.get(self.language, {}).get(name) if self.problem else None) or own

    def has(self, key: str) -> bool:
        """Whether there are words under a key (an empty phrase means: nothing is said)."""
        table = phrases(self.language)
        return bool(table.get(key)) or any(name.startswith(f"{key}.") for name in table)


def capital(inlines: Any) -> Any:
    """The inlines with a capital first letter, if they begin with text."""
    if isinstance(inlines, tuple) and inlines and isinstance(inlines[0], Text) and inlines[0].text:
        first = inlines[0].text
        return (Text(first[0].upper() + first[1:]), *inlines[1:])
    return inlines
