"""A statement as it was written: plain tables and strings, and where each of them stands.

A TOML file and the Python functions of `build` give the same `SourceTable`; only the places that
errors tell differ: `file:line:column`, or the path of the key ("pendulum: bodies.rod.angle").
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from datetime import date, datetime, time
from decimal import Decimal
from difflib import get_close_matches
from fractions import Fraction
from typing import Any
from unicodedata import category

from rbpsym.errors import Place, RbpsymError, StatementError
from rbpsym.frozen import Frozen, replace
from rbpsym.quantities import DIMENSIONS, NUMBER, Dimension
from rbpsym.statement.positions import Path, PositionIndex, place_at
from rbpsym.statement.units import unit_named, unit_of


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


class SourceTable(Frozen):
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

    def table(self, key: str, where: str) -> SourceTable:
        """The table under `key`, empty if there is none."""
        value = self.data.get(key, {})
        if not isinstance(value, Mapping):
            raise self.value_error(key, f"{where} must be a table, not {kind_of(value)}", f"write [{key}]")
        return SourceTable(self.source, (*self.path, key), value)

    def tables(self, key: str, where: str) -> Iterator[tuple[str, SourceTable]]:
        """The named tables under `key`."""
        section = self.table(key, where)
        for name in section.names():
            yield name, section.table(name, f"{key}.{name}")

    def rows(self, key: str, where: str) -> list[SourceTable]:
        """The tables in the list under `key`, empty if there is none."""
        value, named = self.data.get(key, []), ".".join(part for part in (*self.path, key) if isinstance(part, str))
        if not isinstance(value, (list, tuple)) or not all(isinstance(row, Mapping) for row in value):
            raise self.value_error(key, f"{where} must be a list of tables", f"write [[{named}]] above the keys of each one")
        return [SourceTable(self.source, (*self.path, key, i), row) for i, row in enumerate(value)]

    def string(self, key: str, default: str = "") -> str:
        """The string under `key`."""
        value = self.data.get(key, default)
        if not isinstance(value, str):
            raise self.value_error(key, f"“{key}” must be a text in quotes, not {kind_of(value)}", f'write {key} = "..."')
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
    return ("a table" if isinstance(value, Mapping) else _KINDS.get(type(value), f"a value of type {type(value).__name__}"))


def written(value: object) -> str | None:
    """A number as the text that it writes of itself; None for others."""
    is_number = isinstance(value, (int, float, Fraction, Decimal)) and not isinstance(value, bool)
    return str(value) if is_number else None


HARMLESS = "\n\t"
HIDDEN = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")  # Unicode's control, format and unassigned characters


def check_characters(table: SourceTable) -> None:
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


# --- what to write instead, for the words and units that people bring along from elsewhere


SIGNS = ("positive", "nonnegative", "nonzero", "real", "acute")  # acute: an angle between 0 and π/2

# word of ours -> the usual ones for which it may stand
OTHER_WORDS: Mapping[str, str] = {
    "rod": "bar stick beam ladder pendulum",
    "rectangle": "plate square block box",
    "ring": "circle",
    "disk": "wheel pulley circle",
    "particle": "point bead pendulum",
    "pivot": "hinge axle fixed",
    "pin": "hinge joint revolute",
    "weld": "fixed clamp",
    "contact": "roller floor wall friction",
    "touch": "friction",
    "guide": "wire track rail",
    "link": "rod",
    "string": "cable belt",
    "gravity": "weight",
    "couple": "torque moment motor",
    "prescribed-angle": "motor",
    "damper": "dashpot",
    "coefficient": "mu friction_coefficient",
    "limit": "mu friction_coefficient",
    "stiffness": "k",
    "mass": "m",
    "center": "position",
    "speed": "velocity omega",
    "interactions": "forces loads",
    "constraints": "joints supports",
    "coordinates": "variables",
    "parameters": "constants",
}
FUNCTIONS = {"cosine": "cos", "cosinus": "cos", "sine": "sin", "sinus": "sin", "tangent": "tan", "squareroot": "sqrt"}
_AFTER_A_NUMBER = re.compile(r"(?:^|[^\w.])\d+(?:\.\d+)?\s*°?$")
FULL_TURN = 6.3


def other_word(word: str, known: Collection[str]) -> str:
    """The word of ours for a usual one: "write “rod”" for "stick"; "" if there is none."""
    found = [name for name, usual in OTHER_WORDS.items() if name in known and word.lower() in usual.split()]
    return "write " + " or ".join(f"“{name}”" for name in found) + "." if found else ""


def unknown_symbol(text: str, name: str, column: int, hint: str, dimension: Dimension | None) -> str:
    """What to do about a name that the problem does not have; `hint` is what the reader of formulas proposes."""
    if name.lower() in FUNCTIONS:
        return f"Write {FUNCTIONS[name.lower()]}(x)."
    if _AFTER_A_NUMBER.search(text[: column - 1]) and unit_named(name) is not None:
        return _number_with_unit(name)
    if "Did you mean" in hint or "Write" in hint or "write" in hint:
        return hint
    kind = _name_of(dimension) if text.strip() == name else ""
    return f'Declare it under [parameters]: {name} = "{kind or "length"}: what it is". {hint}'


def _number_with_unit(unit: str) -> str:
    if unit in ("deg", "°"):
        return 'Angles are in radians: pi/3. Or write a name, as in start = "theta_0", and its number in [example].'
    return "Formulas hold names: write one, say what it is under [parameters], and give its number in [example]."


def in_radians(value: float, dimension: Dimension | None) -> str:
    """For a large number where an angle is wanted."""
    if dimension == NUMBER and abs(value) > FULL_TURN:
        return f" Angles are in radians: {value:g}° is {value:g}*pi/180."
    return ""


def for_a_dimension(word: str, hint: str) -> str:
    """Where a number with its unit, a sign, or the meaning alone, stands for a dimension."""
    if word in SIGNS:
        return f'“{word}” is a sign and stands after the dimension: "length, {word}: ..."'
    number, _, unit = word.strip().partition(" ")
    if re.match(r"[-+]?\d", number):
        found = unit_named(unit) if unit else None
        return f'numbers stand in [example]; here stands what it is: "{_name_of(found[0] if found else None) or "length"}: ..."'
    found = unit_named(word)
    if found is not None:
        return f"write the dimension, not its unit: “{_name_of(found[0])}”."
    first = next((name for name in sorted(DIMENSIONS, key=len, reverse=True) if word.startswith(name + " ")), None)
    return f'write a colon after the dimension: "{first}: {word}"' if first else hint


def _name_of(dimension: Dimension | None) -> str:
    return next((name for name, found in DIMENSIONS.items() if found == dimension), "")


def unit_example(dimension: Dimension) -> str:
    """How a number of this dimension is written."""
    unit = unit_of(dimension)
    return f'write a number and, after a space, a unit: "{f"2 {unit}" if unit else "0.3"}"'
