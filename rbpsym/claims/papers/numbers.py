"""The numbers of equations: the counters of a text, moved on by its commands."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

LEVELS = ("chapter", "section", "subsection")
BOOKS = re.compile(r"\\documentclass(?:\[[^\]]{0,999}+\])?\{(?:book|report|scrbook|scrreprt|memoir)\}")
COMMANDS = re.compile(
    r"\\(?P<level>chapter|section|subsection)(?P<star>\*?)(?=\s*[\[{])"
    r"|\\(?P<set>set|addto)counter\s*\{(?P<counter>\w+)\}\s*\{(?P<value>-?\d{1,6})\}"
    r"|\\(?P<step>(?:ref)?stepcounter)\s*\{(?P<stepped>\w+)\}"
    r"|\\(?:numberwithin(?:\[[^\]]{0,99}+\])?|counterwithin\*?)\s*\{equation\}\s*\{(?P<within>\w+)\}"
    r"|\\renewcommand\*?\s*\{?\s*\\theequation\s*\}?\s*\{(?P<the>(?:[^{}]|\{[^{}]{0,99}+\}){0,999}+)\}"
    r"|(?P<appendix>\\appendix(?![A-Za-z]))"
)
_PART = re.compile(r"\\the(\w+?)(?![A-Za-z])|\\(arabic|alph|Alph|roman|Roman)\s*\{(\w+)\}")
_ROMAN = ((1000, "m"), (900, "cm"), (500, "d"), (400, "cd"), (100, "c"), (90, "xc"), (50, "l"), (40, "xl"), (10, "x"),
          (9, "ix"), (5, "v"), (4, "iv"), (1, "i"))  # fmt: skip


def roman(value: int) -> str:
    """A small Roman number (Arabic beyond 4999)."""
    if not 0 < value < 5000:
        return str(value)
    found = ""
    for unit, letters in _ROMAN:
        found, value = found + letters * (value // unit), value % unit
    return found


def letter(value: int) -> str:
    """a, b, ... (the number itself beyond z)."""
    return chr(96 + value) if 0 < value < 27 else str(value)


STYLES: Mapping[str, Callable[[int], str]] = {
    "arabic": str, "alph": letter, "Alph": lambda value: letter(value).upper(), "roman": roman,
    "Roman": lambda value: roman(value).upper(),
}  # fmt: skip


class Counters:
    """The counters of one text, moved on by its commands; `within` is the level that equations restart at."""

    def __init__(self, within: str = "") -> None:
        self.values: dict[str, int] = {}
        self.within, self.pattern, self.lettered, self.part = within, "", "", 0

    @classmethod
    def of(cls, text: str) -> Counters:
        """The counters at the beginning of a text: a book counts equations within chapters."""
        return cls("chapter" if BOOKS.search(text) else "")

    def obey(self, found: re.Match[str]) -> None:
        """What a command of COMMANDS does to the counters."""
        told = found.groupdict()
        if told["level"] and not told["star"]:
            self._step(told["level"])
        elif told["counter"]:
            base = self.values.get(told["counter"], 0) if told["set"] == "addto" else 0
            self.values[told["counter"]] = base + int(told["value"])
        elif told["stepped"]:
            self._step(told["stepped"])
        elif told["within"] in LEVELS:
            self.within = told["within"]
        elif told["the"] is not None:
            self.pattern = told["the"]
        elif told["appendix"]:
            self.lettered = "chapter" if "chapter" in self.values else "section"
            self.values[self.lettered] = 0

    def _step(self, counter: str) -> None:
        self.values[counter] = self.values.get(counter, 0) + 1
        if counter in LEVELS:
            self.values.update(dict.fromkeys(LEVELS[LEVELS.index(counter) + 1 :], 0))
            if self.within in LEVELS[LEVELS.index(counter) :]:
                self.values["equation"] = 0

    def group(self, begins: bool) -> None:
        """Beginning or end of subequations."""
        if begins:
            self._step("equation")
        self.part = int(begins)

    def next(self) -> str:
        """The number of the next equation."""
        if self.part:
            self.part += 1
            return f"{self.number()}{letter(self.part - 1)}"
        self._step("equation")
        return self.number()

    def number(self) -> str:
        """How the equation counter is printed now."""
        if self.pattern:
            return re.sub(r"[{}\s]|\\(?:mathrm|rm|text|ensuremath|,)(?![A-Za-z])", "", _PART.sub(self._part, self.pattern))
        return ".".join([*([self._the(self.within)] if self.within else []), str(self.values.get("equation", 0))])

    def _part(self, found: re.Match[str]) -> str:
        style, counter = found[2], found[3]
        return STYLES[style](self.values.get(counter, 0)) if style else self._the(found[1])

    def _the(self, counter: str) -> str:
        if counter == "parentequation":
            counter = "equation"
        levels = LEVELS[: LEVELS.index(counter) + 1] if counter in LEVELS else (counter,)
        shown = [level for level in levels if self.values.get(level) or level == counter]
        return ".".join(self._plain(level) for level in shown)

    def _plain(self, level: str) -> str:
        value = self.values.get(level, 0)
        return STYLES["Alph"](value) if level == self.lettered else str(value)
