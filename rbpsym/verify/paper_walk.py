r"""The formulas of a LaTeX text in order, with number, label, tag and line.

Displayed: equation, align, eqnarray, gather, multline, alignat, flalign, displaymath and their
starred forms, \[ \], $$ $$. An environment with several numbers gives one formula a number.
Inline: $ $ and \( \).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import takewhile
from pathlib import Path

from rbpsym.errors import ReadError
from rbpsym.verify.paper_macros import Macro, definitions
from rbpsym.verify.paper_source import Text, read_source

LEVELS = ("chapter", "section", "subsection")
BOOKS = re.compile(r"\\documentclass(?:\[[^\]]*\])?\{(?:book|report|scrbook|scrreprt|memoir)\}")
COMMANDS = re.compile(
    r"\\(?P<level>chapter|section|subsection)(?P<star>\*?)(?=\s*[\[{])"
    r"|\\(?P<set>set|addto)counter\s*\{(?P<counter>\w+)\}\s*\{(?P<value>-?\d{1,6})\}"
    r"|\\(?P<step>(?:ref)?stepcounter)\s*\{(?P<stepped>\w+)\}"
    r"|\\(?:numberwithin(?:\[[^\]]*\])?|counterwithin\*?)\s*\{equation\}\s*\{(?P<within>\w+)\}"
    r"|\\renewcommand\*?\s*\{?\s*\\theequation\s*\}?\s*\{(?P<the>(?:[^{}]|\{[^{}]*\})*)\}"
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
    "arabic": str,
    "alph": letter,
    "Alph": lambda value: letter(value).upper(),
    "roman": roman,
    "Roman": lambda value: roman(value).upper(),
}


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
            return re.sub(
                r"[{}\s]|\\(?:mathrm|rm|text|ensuremath|,)(?![A-Za-z])", "", _PART.sub(self._part, self.pattern)
            )
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


SINGLE = ("equation", "multline", "displaymath", "math", "dmath", "empheq")
ROWED = ("align", "eqnarray", "gather", "alignat", "flalign", "IEEEeqnarray", "dgroup")
UNNUMBERED = ("displaymath", "math")
_NAMES = "|".join((*SINGLE, *ROWED))
_OPEN = re.compile(
    rf"\\begin\s*\{{({_NAMES})(\*?)\}}|(\\\[)|(\\\()|(?<!\\)(\$\$?)"
    r"|\\(begin|end)\s*\{subequations\}|\\\\|\\\$"
    rf"|(?:{COMMANDS.pattern})"
)
ARGUED = ("alignat", "IEEEeqnarray", "empheq")
_ARGUMENTS = re.compile(r"(?:\[[^\]]*\])?(?:\{[^{}]*\})?")
_CLOSE = {r"\[": r"\]", r"\(": r"\)", "$": "$", "$$": "$$"}
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_TAG = re.compile(r"\\tag\*?\s*\{([^{}]*)\}")
_SILENT = re.compile(r"\\(?:nonumber|notag)(?![A-Za-z])")
_GOES_ON = re.compile(r"(?:\s|&|\{\})*(?:=|<|>|\\(?:leq?|geq?|approx|simeq)(?![A-Za-z]))")
_SPACE = r"(?:\s|\{\}|\\q?quad(?![A-Za-z]))*"
_SIGN = r"(?:\+|\\(?:cdot|times|left\.)(?![A-Za-z]))"
_GROWS = re.compile(rf"{_SPACE}(?:{_SIGN}|&(?:{_SPACE}|&)*(?:-|{_SIGN})|-(?![^\\]*=))")  # a sum or product that goes on
_RELATION = re.compile(r"=|<|>|\\(?:leq?|geq?|neq?|approx|simeq|equiv|to|rightarrow)(?![A-Za-z])")


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula of a text: its LaTeX as it stands, number ("" for none), labels, file and line.

    block: where the display begins that it is in.
    """

    latex: str
    number: str
    labels: tuple[str, ...]
    file: str
    line: int
    offset: int
    displayed: bool = True
    block: int = 0

    @property
    def is_relation(self) -> bool:
        """Does it assert something?"""
        return bool(_RELATION.search(self.latex))


@dataclass(frozen=True, slots=True)
class Paper:
    """A text with its formulas, macros, and remarks on its labels."""

    text: Text
    formulas: tuple[Formula, ...]
    macros: dict[str, Macro]
    remarks: tuple[tuple[str, int, str], ...] = ()

    @property
    def displayed(self) -> tuple[Formula, ...]:
        """The displayed formulas."""
        return tuple(formula for formula in self.formulas if formula.displayed)


def read_paper(path: Path) -> Paper:
    """The formulas of a LaTeX file. Raises ReadError or LimitError with its place."""
    return walked(read_source(path))


def walked(text: Text) -> Paper:
    """The formulas of a text."""
    try:
        macros, plain = definitions(text.text)
        macros = {**definitions(text.packages)[0], **macros}
    except ReadError as error:
        raise ReadError(f"in a macro's definition: {error.what}", place=text.place(0)) from None
    text = replace(text, text=plain)
    formulas = tuple(_Walker(text).walk())
    return Paper(text, formulas, macros, tuple(_remarks(text, formulas)))


class _Walker:
    """One pass over the text; counts equations."""

    def __init__(self, text: Text) -> None:
        self.source, self.text = text, text.text
        self.counters, self.block = Counters.of(self.text), 0

    def walk(self) -> Iterator[Formula]:
        """All formulas in order."""
        position = 0
        while (found := _OPEN.search(self.text, position)) is not None:
            name, star, *openings, sub = found.groups()[:6]
            self.block, position = found.start(), found.end()
            if found.lastgroup:
                self.counters.obey(found)
            elif sub:
                self.counters.group(sub == "begin")
            elif name:
                position = _ARGUMENTS.match(self.text, position).end() if name in ARGUED else position
                end, behind = self._end(found, rf"\\end\s*\{{{name}{re.escape(star)}\}}")
                yield from self._environment(name, bool(star), position, end)
                position = behind
            elif opening := next(filter(None, openings), None):
                end, behind = self._end(found, _closing(opening))
                yield self._formula(position, end, "", opening in (r"\[", "$$"))
                position = behind

    def _end(self, found: re.Match[str], closing: str) -> tuple[int, int]:
        end = re.compile(closing).search(self.text, found.end())
        if end is None:
            raise ReadError(f"“{found[0]}” is never closed", place=self.source.place(found.start()))
        return end.start(), end.end()

    def _environment(self, name: str, star: bool, start: int, end: int) -> Iterator[Formula]:
        rows = list(_rows(self.text, start, end)) if name in ROWED else [(start, end)]
        silent = star or name in UNNUMBERED
        begin = whole = start
        numbered = [row for row in rows if not self._is_silent(row, silent)]
        for first, last in rows:
            if (first, last) in numbered or (last == rows[-1][1] and not numbered):
                is_last = not numbered or (first, last) == numbered[-1]
                stop = end if is_last else last
                number = self._number(begin, stop, (first, last) in numbered)
                goes_on = _GOES_ON.match(self.text, begin, stop) or _GROWS.match(self.text, begin, stop)
                whole = whole if goes_on else begin
                behind = takewhile(lambda row: _GROWS.match(self.text, *row), (row for row in rows if row[0] >= stop))
                reach = max((row[1] for row in behind), default=stop)
                yield self._formula(begin, stop, number, True, whole, reach)
                begin = stop
            if begin == end:
                return

    def _is_silent(self, row: tuple[int, int], silent: bool) -> bool:
        text = self.text[slice(*row)]
        if _TAG.search(text):
            return False
        return silent or bool(_SILENT.search(text)) or not text.strip()

    def _number(self, start: int, end: int, numbered: bool) -> str:
        tag = _TAG.search(self.text, start, end)
        if tag or not numbered:
            return tag[1].strip() if tag else ""
        return self.counters.next()

    def _formula(
        self, start: int, end: int, number: str, displayed: bool, whole: int | None = None, reach: int = 0
    ) -> Formula:
        """The formula from `start`, with the rows from `whole` on if it goes on with what began there, up to `reach`."""
        raw = self.text[start:end]
        labels = tuple(found[1].strip() for found in _LABEL.finditer(raw))
        first = start + len(raw) - len(raw.lstrip())
        file, line = self.source.origin(start if displayed else first)
        if whole is not None:
            raw = self.text[whole : max(end, reach)]
            first = whole + len(raw) - len(raw.lstrip())
        latex = _TAG.sub("", _LABEL.sub("", raw))
        return Formula(latex.strip("\n"), number, labels, file, line, first, displayed, self.block)


def _closing(opening: str) -> str:
    return r"(?<!\\)" + re.escape(_CLOSE[opening]) if opening.startswith("$") else re.escape(_CLOSE[opening])


def _rows(text: str, start: int, end: int) -> Iterator[tuple[int, int]]:
    r"""The rows of an environment: \\ within braces or inner environments does not end one."""
    depth, begin = 0, start
    for found in re.compile(r"\\\\(?:\[[^\]]*\])?|\\begin\b|\\end\b|\\[{}]|[{}]").finditer(text, start, end):
        token = found[0]
        depth += token in ("{", r"\begin")
        depth -= token in ("}", r"\end")
        if token.startswith("\\\\") and depth == 0:
            yield begin, found.end()
            begin = found.end()
    if text[begin:end].strip():
        yield begin, end


def _remarks(text: Text, formulas: tuple[Formula, ...]) -> Iterator[tuple[str, int, str]]:
    """(file, line, remark) of labels that are given twice or stand behind their equation."""
    inside = {label for formula in formulas for label in formula.labels}
    seen: dict[str, int] = {}
    for found in _LABEL.finditer(text.text):
        label, (file, line) = found[1].strip(), text.origin(found.start())
        if label in seen:
            yield file, line, f"the label “{label}” is defined a second time (first in line {seen[label]})"
        seen.setdefault(label, line)
        behind = text.text[: found.start()].rstrip()
        if re.search(rf"\\end\s*\{{(?:{_NAMES})\*?\}}$", behind):
            known = " (and names another equation)" if label in inside else ""
            yield file, line, f"the label “{label}” stands behind its equation{known}"
