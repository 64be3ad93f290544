r"""The formulas of a LaTeX text in order, with number, label, tag and line.

Displayed: equation, align, eqnarray, gather, multline, alignat, flalign, displaymath and their
starred forms, \[ \], $$ $$. An environment with several numbers gives one formula a number.
Inline: $ $ and \( \).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import takewhile
from pathlib import Path

from rbpsym.claims.papers.formats import ROWED, SINGLE
from rbpsym.claims.papers.macros import LONGEST, Macro, definitions
from rbpsym.claims.papers.numbers import COMMANDS, Counters
from rbpsym.claims.papers.source import PaperText, read_source
from rbpsym.frozen import Frozen, replace

UNNUMBERED = ("displaymath", "math")
_NAMES = "|".join((*SINGLE, *ROWED))
_OPEN = re.compile(
    rf"\\begin\s*\{{({_NAMES})(\*?)\}}|(\\\[)|(\\\()|(?<!\\)\$\$(?=[ \t]*&)|(?<!\\)(\$\$?)"
    r"|\\(begin|end)\s*\{subequations\}|\\\\|\\\$"
    rf"|(?:{COMMANDS.pattern})"
)
ARGUED = ("alignat", "IEEEeqnarray", "empheq")
_ARGUMENTS = re.compile(r"(?:\[[^\]\n]{0,999}+\])?(?:\{[^{}]{0,999}+\})?")
_LEVEL = r"\\(?:chapter|(?:sub)*section)(?![A-Za-z])|\\end\s*+\{document\}"
_NEVER = {  # where what opens so can't go on: it was not closed
    r"\[": rf"\\\[|{_LEVEL}", r"\(": r"\\\(|\n[ \t]*+\n", "$": r"\n[ \t]*+\n", "$$": rf"\n[ \t]*+\n|{_LEVEL}",
}  # fmt: skip
_CLOSE = {r"\[": r"\]", r"\(": r"\)", "$": "$", "$$": "$$"}
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_TAG = re.compile(r"\\tag\*?\s*\{([^{}]*)\}")
_SILENT = re.compile(r"\\(?:nonumber|notag)(?![A-Za-z])")
_GOES_ON = re.compile(r"(?:\s|&|\{\})*(?:=|<|>|\\(?:leq?|geq?|approx|simeq)(?![A-Za-z]))")
_SPACE = r"(?:\s|\{\}|\\q?quad(?![A-Za-z]))*"
_SIGN = r"(?:\+|\\(?:cdot|times|left\.)(?![A-Za-z]))"
_GROWS = re.compile(rf"{_SPACE}(?:{_SIGN}|&(?:{_SPACE}|&)*(?:-|{_SIGN})|-(?![^\\]*=))")  # a sum or product that goes on
_RELATION = re.compile(r"=|<|>|\\(?:leq?|geq?|neq?|approx|simeq|equiv|to|rightarrow)(?![A-Za-z])")


class Formula(Frozen):
    """A formula of a text: its LaTeX as it stands, number ("" for none), labels, file and line.

    block: where the display begins that it is in. fault: why it is no formula, "" if it is one.
    """

    latex: str
    number: str
    labels: tuple[str, ...]
    file: str
    line: int
    offset: int
    displayed: bool = True
    block: int = 0
    fault: str = ""

    @property
    def is_relation(self) -> bool:
        """Does it assert something?"""
        return bool(_RELATION.search(self.latex))


class Paper(Frozen):
    """A text with its formulas, macros, and remarks on its labels."""

    text: PaperText
    formulas: tuple[Formula, ...]
    macros: dict[str, Macro]
    remarks: tuple[tuple[str, int, str], ...] = ()
    decimal: str = ""  # the decimal mark that it says to have, or that all its numbers show; "" where they don't

    @property
    def displayed(self) -> tuple[Formula, ...]:
        """The displayed formulas."""
        return tuple(formula for formula in self.formulas if formula.displayed)


def read_paper(path: Path) -> Paper:
    """The formulas of a LaTeX file. Raises ReadError or LimitError with its place."""
    return walked(read_source(path))


def walked(text: PaperText) -> Paper:
    """The formulas of a text."""
    macros, plain, faults = definitions(text.text)
    own = {r"\div": Macro(r"\divergence")} if _PHYSICS.search(text.text + text.packages) else {}  # else it divides
    macros = {**own, **definitions(text.packages)[0], **macros}
    text = replace(text, text=plain)
    formulas = tuple(_Walker(text).walk())
    remarks = [(*text.origin(offset), said) for offset, said in faults]
    remarks += [(formula.file, formula.line, formula.fault) for formula in formulas if formula.fault]
    mark = "," if _COMMA_SAID.search(text.text + text.packages) else _decimal_mark(formulas)
    return Paper(text, formulas, macros, (*remarks, *_remarks(text, formulas)), mark)


_PHYSICS = re.compile(r"\\(?:usepackage|RequirePackage)\s*(?:\[[^\]]*\]\s*)?\{[^{}]*\bphysics\b[^{}]*\}")
_COMMA_SAID = re.compile(r"decimal-marker\s*=\s*\{?,|\{icomma\}|locale\s*=\s*(?:DE|FR)|\\decimalcomma")
_DECIMAL = {
    mark: re.compile(rf"(?<![\d.,}}])(?:0{sign}\d|\d+{sign}(?:\d{{1,2}}|\d{{4,}})(?![\d{{]))")
    for mark, sign in (("{,}", r"\{,\}"), (".", r"\."))
}


def _decimal_mark(formulas: tuple[Formula, ...]) -> str:
    """The mark of numbers such as 0.125 and 1{,}5, which group no thousands; "" where both stand, or none."""
    shown = [mark for mark, pattern in _DECIMAL.items() if any(pattern.search(one.latex) for one in formulas)]
    return shown[0] if len(shown) == 1 else ""


class _Walker:
    """One pass over the text; counts equations."""

    def __init__(self, text: PaperText) -> None:
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
                arguments = _ARGUMENTS.match(self.text, position) if name in ARGUED else None
                position = arguments.end() if arguments else position
                end, behind, fault = self._end(found, *_ends_of(name + star))
                if fault:
                    yield self._formula(position, end, "", True, fault=fault)
                else:
                    yield from self._environment(name, bool(star), position, end)
                position = behind
            elif opening := next(filter(None, openings), None):
                closing = r"(?<!\\)" * (opening[0] == "$") + re.escape(_CLOSE[opening])
                end, behind, fault = self._end(found, closing, _NEVER[opening])
                yield self._formula(position, end, "", opening in (r"\[", "$$"), fault=fault)
                position = behind

    def _end(self, found: re.Match[str], closing: str, never: str) -> tuple[int, int, str]:
        """Where what opens ends, where it goes on behind, and that it is never closed, if so: it is passed over."""
        start = found.end()
        for one in re.compile(rf"(?P<end>{closing})|(?P<never>{never})|\\\\").finditer(self.text, start, start + LONGEST):
            if one["end"]:
                return one.start(), one.end(), ""
            if one["never"]:
                start = one.start()
                break
        return start, start, f"“{found[0]}” is never closed"

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
        self, start: int, end: int, number: str, displayed: bool, whole: int | None = None, reach: int = 0, fault: str = ""
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
        return Formula(latex.strip("\n"), number, labels, file, line, first, displayed, self.block, fault)


def _ends_of(name: str) -> tuple[str, str]:
    """What ends an environment, and where it can't go on."""
    drawn = re.escape(name)
    return rf"\\end\s*+\{{{drawn}\}}", rf"\\begin\s*+\{{{drawn}\}}|{_LEVEL}"


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


BACK = 200  # characters that are looked at in front of a label


def _remarks(text: PaperText, formulas: tuple[Formula, ...]) -> Iterator[tuple[str, int, str]]:
    """(file, line, remark) of labels that are given twice or stand behind their equation."""
    inside = {label for formula in formulas for label in formula.labels}
    seen: dict[str, int] = {}
    for found in _LABEL.finditer(text.text):
        label, (file, line) = found[1].strip(), text.origin(found.start())
        if label in seen:
            yield file, line, f"the label “{label}” is defined a second time (first in line {seen[label]})"
        seen.setdefault(label, line)
        behind = text.text[max(found.start() - BACK, 0) : found.start()].rstrip()
        if re.search(rf"\\end\s*\{{(?:{_NAMES})\*?\}}$", behind):
            known = " (and names another equation)" if label in inside else ""
            yield file, line, f"the label “{label}” stands behind its equation{known}"
