"""A reader of grammars: every way to read a text from its beginning to its end, with what each costs.

A grammar has rows “pattern -> meaning” under names. In a pattern a word stands for itself, `a|b` for one of two, `[…]` for
what may be missing, `(…)` for a group (`(…):x` for its words under the name x), and a name with a capital letter for what is
read under that name; a meaning takes these up by their names in braces, or is a function of them (`@name`), None where they
mean nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

TOKEN = re.compile(r"[A-Za-z_][\w.]*(?:-[A-Za-z]\w*)*(?:\([\w., ]+\))?|\d+(?:\.\d+)?|->|[<>]=?|!=|\S")
MARK = re.compile(r":\w+|[A-Z]\w*(?::\w+)?|[^\s\[\]()|:]+|[\[\]()|]")
Node = tuple[str, Any]
UNREAD = 4  # what a word costs that is taken as it is written


class Heard(NamedTuple):
    """A word, and where it begins and ends in the text."""

    word: str
    begin: int
    end: int


class Parsed(NamedTuple):
    """What is read up to a token, what it means, and what that costs."""

    to: int
    text: str
    cost: int


Caps = Mapping[str, str]
Meaning = str | Callable[[Caps], str | None]
Rule = tuple[Node, Meaning, int]


class _Missing(dict[str, str]):
    """What is read by name; nothing for what was left out, “it” for who does something."""

    def __missing__(self, name: str) -> str:
        return "it" if name == "Subj" else ""


def tokens(text: str) -> list[Heard]:
    """The words of a text."""
    return [Heard(found[0], *found.span()) for found in TOKEN.finditer(text)]


def compiled(pattern: str) -> Node:
    """A pattern as a tree."""
    marks = MARK.findall(pattern)[::-1]
    found = _either(marks)
    assert not marks, pattern
    return found


def _either(marks: list[str]) -> Node:
    branches = [_sequence(marks)]
    while marks and marks[-1] == "|":
        marks.pop()
        branches.append(_sequence(marks))
    return branches[0] if len(branches) == 1 else ("either", branches)


def _sequence(marks: list[str]) -> Node:
    parts: list[Node] = []
    while marks and marks[-1] not in "|)]":
        mark = marks.pop()
        if mark in "([":
            inner = _either(marks)
            closing = marks.pop()
            assert closing == {"(": ")", "[": "]"}[mark]
            if marks and marks[-1][0] == ":":
                inner = ("caught", (inner, marks.pop()[1:]))
            parts.append(inner if mark == "(" else ("either", [inner, ("all", [])]))
        elif mark[0].isupper():
            name, _, label = mark.partition(":")
            parts.append(("named", (name, label or name)))
        else:
            parts.append(("word", mark))
    return ("all", parts)


class Chart:
    """All readings of one text by the rules of a grammar, and by what finds the names and values of a problem in it."""

    def __init__(
        self, text: str, rules: Mapping[str, list[Rule]], finders: Mapping[str, Callable[[list[Heard], int], Iterator[Parsed]]]
    ) -> None:
        self.text, self.words, self.rules, self.finders = text, tokens(text), rules, finders
        self.known: dict[tuple[str, int], list[Parsed]] = {}

    def read(self, name: str) -> dict[str, int]:
        """What the whole text may mean under a name, with what each reading costs."""
        whole = [one for one in self._named(name, 0) if one.to == len(self.words)]
        return {one.text: one.cost for one in sorted(whole, key=lambda one: -one.cost)}

    def begun(self, name: str, at: int) -> list[int]:
        """To which tokens something reads under a name that begins at one, of which all words are read."""
        return [one.to for one in self._named(name, at) if one.cost < UNREAD]

    def _named(self, name: str, at: int) -> list[Parsed]:
        if (name, at) not in self.known:
            self.known[name, at] = []  # what begins with itself is not read again
            best: dict[tuple[int, str], int] = {}
            for one in self.finders[name](self.words, at) if name in self.finders else self._by_rules(name, at):
                best[one.to, one.text] = min(one.cost, best.get((one.to, one.text), one.cost))
            self.known[name, at] = [Parsed(to, text, cost) for (to, text), cost in best.items()]
        return self.known[name, at]

    def _by_rules(self, name: str, at: int) -> Iterator[Parsed]:
        for node, meaning, own in self.rules[name]:
            for to, caps, cost in self._match(node, at):
                text = meaning.format_map(_Missing(caps)) if isinstance(meaning, str) else meaning(_Missing(caps))
                if text is not None:
                    yield Parsed(to, " ".join(text.split()), cost + own)

    def _match(self, node: Node, at: int) -> Iterator[tuple[int, dict[str, str], int]]:
        kind, what = node
        if kind == "word":
            if at < len(self.words) and self.words[at].word == what:
                yield at + 1, {}, 0
        elif kind == "named":
            yield from ((one.to, {what[1]: one.text}, one.cost) for one in self._named(what[0], at))
        elif kind == "caught":
            inner, label = what
            for to, caps, cost in self._match(inner, at):
                yield to, {**caps, label: caps.get(label) or " ".join(one.word for one in self.words[at:to])}, cost
        elif kind == "either":
            for branch in what:
                yield from self._match(branch, at)
        else:
            yield from self._all(what, at)

    def _all(self, parts: list[Node], at: int) -> Iterator[tuple[int, dict[str, str], int]]:
        if not parts:
            yield at, {}, 0
            return
        for to, caps, cost in self._match(parts[0], at):
            for end, more, other in self._all(parts[1:], to):
                yield end, {**caps, **more}, cost + other
