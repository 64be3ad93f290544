"""Where each key and each value of a TOML text stands, to put carets under characters.

`tomllib` reads the values and refuses what is wrong, but tells no positions. This index
walks a text that `tomllib` has accepted, so it need not check anything. A path is a tuple of
keys and list positions: `("bodies", "rod", "center", 0)`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from rbpsym.errors import Place

Path = tuple[str | int, ...]

_BARE_END = ",]}#\n"
_ESCAPE_LENGTH = {"u": 6, "U": 10, "x": 4}


def place_at(file: str, text: str, offset: int, width: int = 1) -> Place:
    """The place of the character at `offset` of `text`."""
    line = text.count("\n", 0, offset) + 1
    start = text.rfind("\n", 0, offset) + 1
    content = "".join(char if char.isprintable() else " " for char in text[start:].split("\n", 1)[0])
    return Place(file, line, offset - start + 1, content, max(1, min(width, len(content) - offset + start)))


@dataclass
class PositionIndex:
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
    """One pass over the text; `at` is the offset of the next character."""

    def __init__(self, text: str) -> None:
        self.text, self.at = text, 0
        self.index = PositionIndex(text)
        self.counts: dict[Path, int] = {}
        self.table: Path = ()

    def walk(self) -> None:
        self._skip_blank()
        while self.at < len(self.text):
            self._header() if self._peek() == "[" else self._pair(self.table)
            self._skip_blank()

    def _peek(self, width: int = 1) -> str:
        return self.text[self.at : self.at + width]

    def _skip_spaces(self) -> None:
        while self._peek() in (" ", "\t"):
            self.at += 1

    def _skip_blank(self) -> None:
        """Past white space, line ends and comments."""
        while self._peek() and self._peek() in " \t\r\n#":
            self.at = self._line_end() if self._peek() == "#" else self.at + 1

    def _line_end(self) -> int:
        end = self.text.find("\n", self.at)
        return len(self.text) if end < 0 else end

    def _header(self) -> None:
        """A line `[a.b]` or `[[a.b]]`."""
        is_list = self._peek(2) == "[["
        self.at += 2 if is_list else 1
        parts = self._key_path()
        path: Path = ()
        for name, start, width in parts:
            path = self._last_of_list((*path, name))
            self.index.keys.setdefault(path, (start, width))
        if is_list:
            path = self._next_of_list(path, parts[-1])
        self.table = path
        self.at = self._line_end()

    def _last_of_list(self, path: Path) -> Path:
        return (*path, self.counts[path] - 1) if path in self.counts else path

    def _next_of_list(self, path: Path, part: tuple[str, int, int]) -> Path:
        base = path[:-1] if isinstance(path[-1], int) else path
        count = self.counts.get(base, 0)
        self.counts[base] = count + 1
        self.index.keys[(*base, count)] = part[1:]
        return (*base, count)

    def _key_path(self) -> list[tuple[str, int, int]]:
        """The parts of a dotted key with the offset and width of each."""
        parts = [self._key_part()]
        while self._peek() == ".":
            self.at += 1
            parts.append(self._key_part())
        return parts

    def _key_part(self) -> tuple[str, int, int]:
        self._skip_spaces()
        start = self.at
        name = self._quoted_key() if self._peek() in "\"'" else self._bare_key()
        width = self.at - start
        self._skip_spaces()
        return name, start, width

    def _bare_key(self) -> str:
        start = self.at
        while self._peek().isalnum() or self._peek() in ("_", "-"):
            self.at += 1
        return self.text[start : self.at]

    def _quoted_key(self) -> str:
        import tomllib

        start = self.at
        self._string(())
        return next(iter(tomllib.loads(f"{self.text[start : self.at]} = 0")))

    def _pair(self, table: Path) -> None:
        """`key = value`."""
        path = table
        for name, start, width in self._key_path():
            path = (*path, name)
            self.index.keys.setdefault(path, (start, width))
        self.at += 1
        self._value(path)

    def _value(self, path: Path) -> None:
        self._skip_spaces()
        start = self.at
        reader = {'"': self._string, "'": self._string, "[": self._list, "{": self._inline}
        reader.get(self._peek(), self._bare)(path)
        self.index.values[path] = (start, self.at)

    def _bare(self, path: Path) -> None:
        """A number, a date, true or false."""
        start = self.at
        while self._peek() and self._peek() not in _BARE_END:
            self.at += 1
        self.at = start + len(self.text[start : self.at].rstrip())

    def _list(self, path: Path) -> None:
        self.at += 1
        self._skip_blank()
        count = 0
        while self._peek() != "]":
            self._value((*path, count))
            count += 1
            self._skip_separator()
        self.at += 1

    def _inline(self, path: Path) -> None:
        self.at += 1
        self._skip_blank()
        while self._peek() != "}":
            self._pair(path)
            self._skip_separator()
        self.at += 1

    def _skip_separator(self) -> None:
        self._skip_blank()
        if self._peek() == ",":
            self.at += 1
        self._skip_blank()

    def _string(self, path: Path) -> None:
        """A string of any of the four kinds; keeps the offset of each of its characters."""
        quote = self._peek()
        long = self._peek(3) == quote * 3
        delimiter = quote * 3 if long else quote
        self.at += len(delimiter)
        if long and self._peek() == "\n":
            self.at += 1
        offsets: list[int] = []
        while self._peek(len(delimiter)) != delimiter:
            self._character(offsets, escapes=quote == '"')
        while long and self._peek(4) == quote * 4:  # quotes that belong to the text
            self._character(offsets, escapes=False)
        self.index.strings[path] = [*offsets, self.at]
        self.at += len(delimiter)

    def _character(self, offsets: list[int], escapes: bool) -> None:
        if not (escapes and self._peek() == "\\"):
            offsets.append(self.at)
            self.at += 1
        elif self._peek(2)[1].isspace():  # the end of the line is not part of the text
            self.at += 1
            while self._peek().isspace():
                self.at += 1
        else:
            offsets.append(self.at)
            self.at += _ESCAPE_LENGTH.get(self._peek(2)[1], 2)
