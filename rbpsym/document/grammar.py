"""The grammar of a language, as its phrases file tells it under [grammar]: number, gender, contractions."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Grammar:
    """How words change beside others.

    `singular` are the numbers that take the form `one`; nouns with one of the `feminine` endings are feminine,
    but for the words in `genders`; `contractions` are what words that meet become (“de el”: “del”); the last
    “and” of a list is `other_last` before the `sound` (a regular expression), else `last`.
    """

    last: str = ", "
    other_last: str = ""
    sound: str = ""
    singular: frozenset[int] = frozenset({1})
    feminine: tuple[str, ...] = ()
    genders: Mapping[str, str] = field(default_factory=dict)
    contractions: Mapping[str, str] = field(default_factory=dict)

    def number(self, count: int) -> str:
        """ "one" or "many"."""
        return "one" if count in self.singular else "many"

    def gender(self, noun: str) -> str:
        """ "feminine" or "masculine", by the first word of a noun phrase.

        >>> Grammar(feminine=("a",), genders={"mapa": "masculine"}).gender("la cuña")
        'feminine'
        """
        words = noun.lower().split()
        word = words[0] if words else ""
        return self.genders.get(word, "feminine" if word.endswith(self.feminine) else "masculine")

    def contracted(self, text: str) -> str:
        """The text with its contractions.

        >>> Grammar(contractions={"de el": "del"}).contracted("De el centro de el disco")
        'Del centro del disco'
        """
        for meeting, short in self.contractions.items():
            first, rest = re.escape(meeting[1:]), short[1:]
            text = re.sub(rf"\b({meeting[0]}|{meeting[0].upper()}){first}\b", rf"\g<1>{rest}", text)
        return text

    def last_and(self, word: str) -> str:
        """What stands before the last item of a list."""
        return self.other_last if self.sound and re.match(self.sound, word, re.IGNORECASE) else self.last


def grammar_of(table: Mapping[str, str]) -> Grammar:
    """The grammar in a phrases file (dotted keys)."""

    def several(key: str) -> tuple[str, ...]:
        return tuple(table.get(f"grammar.{key}", "").split())

    genders = {word: gender for gender in ("masculine", "feminine") for word in several(f"{gender}_words")}
    prefix = "grammar.contractions."
    return Grammar(
        last=table["list.last"],
        other_last=table.get("grammar.other_last", ""),
        sound=table.get("grammar.sound", ""),
        singular=frozenset(map(int, several("singular"))) or frozenset({1}),
        feminine=several("feminine_endings"),
        genders=genders,
        contractions={key.removeprefix(prefix): short for key, short in table.items() if key.startswith(prefix)},
    )
