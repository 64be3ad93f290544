"""Where each key and each value of a TOML text stands, to put carets under characters.

`tomllib` reads the values and refuses what is wrong, but tells no positions. This index
walks a text that `tomllib` has accepted, so it need not check anything. A path is a tuple of
keys and list positions: `("bodies", "rod", "center", 0)`.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable

from rbpsym.errors import Place
from rbpsym.frozen import Walker, field

Path = tuple[str | int, ...]
Key = list[tuple[str, int, int]]  # the parts of a dotted key, each with its offset and width

_BLANK = re.compile(r"(?:\s|#[^\n]*)*")
_GAP = re.compile(r"(?:[\s,]|#[^\n]*)*")
_LINE = re.compile(r"[^\n]*")
_KEY = re.compile(r"""[ \t]*("(?:\\.|[^"\\])*"|'[^']*'|[\w-]+)[ \t]*""")
_BARE = re.compile(r"[^,\]}#\n]*")  # a number, a date, true or false
# strings of the four kinds; up to two quotes before the closing ones belong to the text
_STRING = re.compile(
    r'"""\n?(?P<long>(?:\\.|[^\\])*?"{0,2})"""(?!")|"(?P<short>(?:\\.|[^"\\])*)"'
    r"|'''\n?(?P<long_literal>.*?'{0,2})'''(?!')|'(?P<short_literal>[^']*)'",
    re.DOTALL,
)
_CHARACTER = re.compile(r"\\(?:(?P<nothing>\s+)|u.{4}|U.{8}|x..|.)|.", re.DOTALL)


def place_at(file: str, text: str, offset: int, width: int = 1) -> Place:
    """The place of the character at `offset` of `text`."""
    line = text.count("\n", 0, offset) + 1
    start = text.rfind("\n", 0, offset) + 1
    content = "".join(char if char.isprintable() else " " for char in text[start:].split("\n", 1)[0])
    return Place(file, line, offset - start + 1, content, max(1, min(width, len(content) - offset + start)))


class PositionIndex(Walker):
    """Offsets of keys (start, width), of values (start, end) and of the characters of strings."""

    text: str
    keys: dict[Path, tuple[int, int]] = field(default_factory=dict)
    values: dict[Path, tuple[int, int]] = field(default_factory=dict)
    strings: dict[Path, list[int]] = field(default_factory=dict)

    def key(self, path: Path) -> tuple[int, int]:
        """Offset and width of the last key of `path`, or of the nearest table around it."""
        while path and path not in self.keys:
            path = path[:-1]
        return self.keys.get(path, (0, 1))

    def value(self, path: Path) -> tuple[int, int]:
        """Offset and width of the value at `path`; of its key if it has no value of its own."""
        if path not in self.values:
            return self.key(path)
        start, end = self.values[path]
        return start, end - start

    def inside(self, path: Path, column: int, width: int) -> tuple[int, int]:
        """Offset and width of `width` characters from the `column`-th (from 1) of a string."""
        offsets = self.strings.get(path)
        if offsets is None:
            start, length = self.value(path)
            return start + min(column - 1, length - 1), width
        first = min(max(column - 1, 0), len(offsets) - 1)
        last = min(first + max(width, 1), len(offsets) - 1)
        return offsets[first], max(1, offsets[last] - offsets[first])


def index_positions(text: str) -> PositionIndex:
    """The positions in a text that is valid TOML."""
    walker = _Walker(text)
    walker.walk()
    return walker.index


class _Walker:
    """One pass over the text; what reads a part gives the offset behind it."""

    def __init__(self, text: str) -> None:
        self.text, self.index = text, PositionIndex(text)
        self.counts: dict[Path, int] = {}

    def walk(self) -> None:
        table: Path = ()
        at = self._past(_BLANK, 0)
        while at < len(self.text):
            if self.text[at] == "[":
                table, at = self._header(at)
            else:
                at = self._pair(table, at)
            at = self._past(_BLANK, at)

    def _past(self, pattern: re.Pattern[str], at: int) -> int:
        return _met(pattern, self.text, at).end()

    def _header(self, at: int) -> tuple[Path, int]:
        """A line `[a.b]` or `[[a.b]]`: the table that begins there."""
        is_list = self.text.startswith("[[", at)
        parts, at = self._key(at + 1 + is_list)
        path: Path = ()
        for name, start, width in parts:
            path = (*path, name)
            path = (*path, self.counts[path] - 1) if path in self.counts else path
            self.index.keys.setdefault(path, (start, width))
        if is_list:
            base = path[:-1] if isinstance(path[-1], int) else path
            count = self.counts.get(base, 0)
            path, self.counts[base] = (*base, count), count + 1
            self.index.keys[path] = parts[-1][1:]
        return path, self._past(_LINE, at)

    def _key(self, at: int) -> tuple[Key, int]:
        found = _met(_KEY, self.text, at)
        is_quoted = found[1][0] in "\"'"
        name = next(iter(tomllib.loads(f"{found[1]} = 0"))) if is_quoted else found[1]
        part = (name, found.start(1), len(found[1]))
        if self.text[found.end()] != ".":
            return [part], found.end()
        others, at = self._key(found.end() + 1)
        return [part, *others], at

    def _pair(self, path: Path, at: int) -> int:
        """`key = value`."""
        parts, at = self._key(at)
        for name, start, width in parts:
            path = (*path, name)
            self.index.keys.setdefault(path, (start, width))
        return self._value(path, at + 1)

    def _value(self, path: Path, at: int) -> int:
        start = self._past(_BLANK, at)
        if self.text[start] in "[{":
            end = self._group(path, start)
        elif found := _STRING.match(self.text, start):
            self.index.strings[path] = [*_characters(found), found.end(found.lastgroup or 0)]
            end = found.end()
        else:
            end = start + len(_met(_BARE, self.text, start)[0].rstrip())
        self.index.values[path] = (start, end)
        return end

    def _group(self, path: Path, at: int) -> int:
        """A list, or a table in braces."""
        is_list, count = self.text[at] == "[", 0
        at = self._past(_GAP, at + 1)
        while self.text[at] not in "]}":
            at = self._value((*path, count), at) if is_list else self._pair(path, at)
            at, count = self._past(_GAP, at), count + 1
        return at + 1


def _met(pattern: re.Pattern[str], text: str, at: int) -> re.Match[str]:
    """What is there: the text is TOML, as it was read before."""
    found = pattern.match(text, at)
    assert found
    return found


def _characters(found: re.Match[str]) -> Iterable[int]:
    """The offset of each character of a string; the end of a line behind a backslash is not part of the text."""
    kind = found.lastgroup or ""
    start, end = found.span(kind)
    if kind.endswith("literal"):
        return range(start, end)
    return (one.start() for one in _CHARACTER.finditer(found.string, start, end) if not one["nothing"])
