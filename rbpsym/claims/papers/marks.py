"""Texts rewritten where marks open in them, in one pass; what comments say to us stands between two marks of our own."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable

NOTE, NOTE_END = "\ue000", "\ue001"
LONGEST = 20_000  # characters between an opening mark and its closing
SPAN, _TICKS = 2000, re.compile(r"`+")
_BREAK = re.compile(r"\n[ \t]*+\n")
_OPTION = re.compile(r"^[ \t]*:(\w+):[ \t]*(.*)$", re.M)
_SAYS = re.compile(r"\s*rbpsym:(.*)", re.S)


def blank(text: str) -> str:
    """The ends of its lines alone."""
    return "\n" * text.count("\n")


def noted(said: str) -> str:
    """What is said to us, a note for each line."""
    return "\n".join(f"{NOTE}{line}{NOTE_END}" if line.strip() else "" for line in said.split("\n"))


def comment(text: str) -> str:
    """A comment: what it says to us, or its lines."""
    found = _SAYS.match(text)
    return blank(text[: found.start(1)]) + noted(found[1]) if found else blank(text)


def display(body: str, label: str = "", *, rows: bool = False) -> str:
    """A displayed formula; the options of a directive in front of it name it. `rows`: each is one of its own."""
    options = dict(_OPTION.findall(body))
    label = label or options.get("label", "")
    body = _OPTION.sub("", body).rstrip(" \t")
    if "nowrap" in options:
        return body
    end = body.rstrip()
    name = ("align" if rows else "equation") + ("" if label else "*")
    named = rf"\label{{{label.strip()}}}" if label else ""
    return rf"\begin{{{name}}}{end}{named}\end{{{name}}}{body[len(end) :]}"


def displays(body: str) -> str:
    """The formulas of a directive, which blank lines part; the options in front belong to the first."""
    first, *others = re.split(r"(?<=\S)[ \t]*+\n(?=[ \t]*+\n)", body)
    if "nowrap" in dict(_OPTION.findall(first)):
        return display(body)
    if others and not _OPTION.sub("", first).strip():
        first, *others = f"{first}\n{others[0]}", *others[1:]
    return "\n".join(display(part) if part.strip() else part for part in (first, *others))


class Rewriting:
    """A text rewritten where marks open in it; a closing mark is looked for but once from where it was found last.

    So the time is that of reading the text a few times, whatever stands in it.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.closings: dict[str, tuple[int, int] | None] = {}
        self.ticks: dict[int, list[int]] | None = None

    def rewritten(self, opening: re.Pattern[str], piece: Callable[[Rewriting, re.Match[str]], tuple[str, int]]) -> str:
        """The text with what each opening begins replaced: by what `piece` says, up to where it says."""
        position, pieces = 0, []
        while (found := opening.search(self.text, position)) is not None:
            made, end = piece(self, found)
            pieces += [self.text[position : found.start()], made]
            position = max(end, found.end())
        return "".join([*pieces, self.text[position:]])

    def closing(self, mark: str, start: int, most: int = LONGEST) -> tuple[int, int] | None:
        """Where a mark (a pattern) begins and ends next, if it does so soon."""
        known = self.closings.get(mark, (-1, -1))
        if known is not None and known[0] < start:
            found = re.compile(mark, re.M | re.I).search(self.text, start)
            known = self.closings[mark] = found.span() if found else None
        return known if known and known[0] - start <= most else None

    def paragraph(self, start: int, end: int) -> bool:
        """Do the places stand in one paragraph?"""
        gap = self.closing(_BREAK.pattern, start, len(self.text))
        return gap is None or gap[0] >= end

    def span(self, start: int, size: int) -> int:
        """Where so many backticks stand alone next, in this paragraph; -1 if nowhere."""
        if self.ticks is None:
            self.ticks = {}
            for found in _TICKS.finditer(self.text):
                self.ticks.setdefault(len(found[0]), []).append(found.start())
        places = self.ticks.get(size, [])
        place = bisect_left(places, start)
        end = places[place] if place < len(places) else -1
        return end if 0 < end - start <= SPAN and self.paragraph(start, end) else -1
