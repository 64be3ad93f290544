"""A statement as it was written: plain tables and strings, and where each of them stands.

A TOML file and the Python functions of `build` give the same `Table`; only the places that
errors tell differ: `file:line:column`, or the path of the key ("pendulum: bodies.rod.angle").
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from datetime import date, datetime, time
from decimal import Decimal
from difflib import get_close_matches
from fractions import Fraction
from typing import Any
from unicodedata import category

from rbpsym.errors import Place, RbpsymError, StatementError
from rbpsym.frozen import Frozen, replace
from rbpsym.statement.hints import other_word
from rbpsym.statement.positions import Path, PositionIndex, place_at


class Source(Frozen):
    """Where a statement comes from: the name of its file, and its positions if it has a text."""

    file: str = ""
    index: PositionIndex | None = None

    @property
    def text(self) -> str:
        """The text of the file; "" of what Python functions made."""
        return self.index.text if self.index else ""

    def key(self, path: Path) -> Place:
        """The place of a key."""
        return place_at(self.file, self.index.text, *self.index.key(path)) if self.index else self._named(path)

    def value(self, path: Path) -> Place:
        """The place of a value."""
        return place_at(self.file, self.index.text, *self.index.value(path)) if self.index else self._named(path)

    def inside(self, path: Path, text: str, column: int, width: int = 1) -> Place:
        """The place of a character of the string at `path`."""
        if self.index:
            return place_at(self.file, self.index.text, *self.index.inside(path, column, width))
        return replace(self._named(path), column=column, text=text, width=width)

    def _named(self, path: Path) -> Place:
        dotted = ".".join(str(part) for part in path)
        return Place(": ".join(part for part in (self.file, dotted) if part))


class SourceItem(Frozen):
    """A value of a statement with its path."""

    source: Source
    path: Path
    value: Any  # what TOML or Python gives

    def error(self, what: str, instead: str = "") -> StatementError:
        """An error about the value."""
        return StatementError(what, instead=instead, place=self.source.value(self.path))

    def error_inside(self, what: str, instead: str, column: int, width: int) -> StatementError:
        """An error about some characters of a string."""
        place = self.source.inside(self.path, str(self.value), column, width)
        return StatementError(what, instead=instead, place=place)

    def items(self) -> list[SourceItem]:
        """The parts of a list."""
        return [SourceItem(self.source, (*self.path, i), part) for i, part in enumerate(self.value)]


class Table(Frozen):
    """A table of a statement with its path."""

    source: Source
    path: Path
    data: Mapping[str, Any]

    def __contains__(self, key: str) -> bool:
        return key in self.data

    def names(self) -> list[str]:
        """Its keys, in order."""
        return list(self.data)

    def error(self, what: str, instead: str = "", key: str | None = None) -> StatementError:
        """An error about the table, or about one of its keys."""
        path = self.path if key is None else (*self.path, key)
        return StatementError(what, instead=instead, place=self.source.key(path))

    def value_error(self, key: str, what: str, instead: str = "") -> StatementError:
        """An error about the value of a key."""
        place = self.source.value((*self.path, key)) if key in self.data else self.source.key(self.path)
        return StatementError(what, instead=instead, place=place)

    def item(self, key: str, default: object = None) -> SourceItem:
        """The value under `key`, or a default that stands for it."""
        if key in self.data:
            return SourceItem(self.source, (*self.path, key), self.data[key])
        return SourceItem(self.source, self.path, default)

    def check_keys(self, known: Iterable[str], where: str) -> None:
        """Refuse the first key that is not known."""
        known = list(known)
        for key in self.data:
            if key not in known:
                raise self.error(f"unknown key “{key}” in {where}", did_you_mean(key, known, "keys here"), key)

    def require(self, key: str, where: str, instead: str = "") -> None:
        """Refuse a table without `key`."""
        if key not in self.data:
            raise self.error(f"{where} has no “{key}”", instead or f'add {key} = "..."')

    def table(self, key: str, where: str) -> Table:
        """The table under `key`, empty if there is none."""
        value = self.data.get(key, {})
        if not isinstance(value, Mapping):
            raise self.value_error(key, f"{where} must be a table, not {kind_of(value)}", f"write [{key}]")
        return Table(self.source, (*self.path, key), value)

    def tables(self, key: str, where: str) -> Iterator[tuple[str, Table]]:
        """The named tables under `key`."""
        section = self.table(key, where)
        for name in section.names():
            yield name, section.table(name, f"{key}.{name}")

    def rows(self, key: str, where: str) -> list[Table]:
        """The tables in the list under `key`, empty if there is none."""
        value = self.data.get(key, [])
        if not isinstance(value, (list, tuple)) or not all(isinstance(row, Mapping) for row in value):
            raise self.value_error(key, f"{where} must be a list of tables", f"write {key} = [{{ ... }}, {{ ... }}]")
        return [Table(self.source, (*self.path, key, i), row) for i, row in enumerate(value)]

    def string(self, key: str, default: str = "") -> str:
        """The string under `key`."""
        value = self.data.get(key, default)
        if not isinstance(value, str):
            raise self.value_error(
                key, f"“{key}” must be a text in quotes, not {kind_of(value)}", f'write {key} = "..."'
            )
        return value

    def flag(self, key: str, default: bool = False) -> bool:
        """True or false under the key. Raises StatementError for anything else."""
        value = self.data.get(key, default)
        if not isinstance(value, bool):
            raise self.value_error(key, f"“{key}” must be true or false, not {kind_of(value)}", f"write {key} = true")
        return value

    def whole(self, key: str, default: int, low: int, high: int) -> int:
        """The whole number under the key. Raises StatementError for anything else."""
        value = self.data.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
            what = f"“{key}” must be a whole number from {low} to {high}"
            raise self.value_error(key, what, f"write {key} = {default}")
        return value

    def choice(self, key: str, known: Iterable[str], default: str = "") -> str:
        """One of the words that are known, or the default. Raises StatementError for another."""
        value = self.string(key, default)
        if value != default and value not in known:
            raise self.value_error(key, f"“{value}” is not a value of “{key}”", did_you_mean(value, known))
        return value


def did_you_mean(word: str, known: Iterable[str], what: str = "known") -> str:
    """A hint: our word for a usual one, the nearest known word, else all of them."""
    known = list(known)
    if ours := other_word(word, known):
        return ours
    near = get_close_matches(word, known, n=1, cutoff=0.6)
    if near:
        return f"did you mean “{near[0]}”?"
    return f"{what}: {', '.join(known)}." if known else ""


_KINDS = {
    bool: "true or false", int: "a number", float: "a number", str: "a text", list: "a list", tuple: "a list",
    type(None): "nothing", **dict.fromkeys((date, time, datetime), "a date or time"),
}  # fmt: skip


def kind_of(value: object) -> str:
    """What a value of a statement is, in words."""
    return (
        "a table" if isinstance(value, Mapping) else _KINDS.get(type(value), f"a value of type {type(value).__name__}")
    )


def written(value: object) -> str | None:
    """A number as the text that it writes of itself; None for others."""
    is_number = isinstance(value, (int, float, Fraction, Decimal)) and not isinstance(value, bool)
    return str(value) if is_number else None


HARMLESS = "\n\t"
HIDDEN = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")  # Unicode's control, format and unassigned characters


def check_characters(table: Table) -> None:
    """Refuse a text or name that holds a character which is not seen, or turns the writing round."""
    for item in _texts(SourceItem(table.source, table.path, table.data)):
        for column, char in enumerate(item.value, 1):
            if category(char) in HIDDEN and char not in HARMLESS:
                raise item.error_inside(
                    f"the character U+{ord(char):04X} can't stand in a text: it is not seen", "remove it.", column, 1
                )


def _texts(item: SourceItem) -> Iterator[SourceItem]:
    if isinstance(item.value, str):
        yield item
    elif isinstance(item.value, Mapping):
        for key, part in item.value.items():
            yield from _texts(SourceItem(item.source, (*item.path, key), str(key)))
            yield from _texts(SourceItem(item.source, (*item.path, key), part))
    elif isinstance(item.value, (list, tuple)):
        for part in item.items():
            yield from _texts(part)


def relocate(error: RbpsymError, source: Source, path: Path, text: str, shift: int = 0) -> RbpsymError:
    """The error of a reader of `text`, told where the text stands (`shift` characters in)."""
    inner = error.place or Place(column=1, width=max(len(text) - shift, 1))
    place = source.inside(path, text, max(inner.column, 1) + shift, inner.width)
    return type(error)(error.what, instead=error.instead, place=place)
