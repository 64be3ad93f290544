r"""The formulas of a LaTeX text in order, with number, label, tag and line.

Displayed: equation, align, eqnarray, gather, multline, alignat, flalign, displaymath and their
starred forms, \[ \], $$ $$. An environment with several numbers gives one formula a number.
Inline: $ $ and \( \).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import takewhile
from pathlib import Path

from rbpsym.errors import ReadError
from rbpsym.verify.paper_macros import Macro, definitions
from rbpsym.verify.paper_numbers import COMMANDS, Counters
from rbpsym.verify.paper_source import Text, read_source

SINGLE = ("equation", "multline", "displaymath", "math")
ROWED = ("align", "eqnarray", "gather", "alignat", "flalign")
UNNUMBERED = ("displaymath", "math")
_NAMES = "|".join((*SINGLE, *ROWED))
_OPEN = re.compile(
    rf"\\begin\s*\{{({_NAMES})(\*?)\}}(?:\{{\d+\}})?|(\\\[)|(\\\()|(?<!\\)(\$\$?)"
    r"|\\(begin|end)\s*\{subequations\}|\\\\|\\\$"
    rf"|(?:{COMMANDS.pattern})"
)
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
    """A formula of a text: its LaTeX as it stands, number ("" for none), labels, file and line."""

    latex: str
    number: str
    labels: tuple[str, ...]
    file: str
    line: int
    offset: int
    displayed: bool = True

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
    except ReadError as error:
        raise ReadError(f"in a macro's definition: {error.what}", place=text.place(0)) from None
    text = replace(text, text=plain)
    formulas = tuple(_Walker(text).walk())
    return Paper(text, formulas, macros, tuple(_remarks(text, formulas)))


class _Walker:
    """One pass over the text; counts equations."""

    def __init__(self, text: Text) -> None:
        self.source, self.text = text, text.text
        self.counters = Counters.of(self.text)

    def walk(self) -> Iterator[Formula]:
        """All formulas in order."""
        position = 0
        while (found := _OPEN.search(self.text, position)) is not None:
            name, star, *openings, sub = found.groups()[:6]
            position = found.end()
            if found.lastgroup:
                self.counters.obey(found)
            elif sub:
                self.counters.group(sub == "begin")
            elif name:
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
        return Formula(latex.strip("\n"), number, labels, file, line, first, displayed)


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
