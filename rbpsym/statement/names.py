"""The names that a quantity, a body, an interaction or a constraint may have."""

from __future__ import annotations

import re

from rbpsym.errors import StatementError
from rbpsym.statement.source import Item, Table, kind_of

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_FUNCTIONS = ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "arcsin", "arccos", "arctan",
              "exp", "ln", "log", "sqrt", "abs", "sen", "tg", "ctg", "cotg", "cosec", "arcsen", "arctg")  # fmt: skip

RESERVED = {
    "t": "the time",
    "pi": "the number π",
    "O": "the origin",
    "cm": "the centre of mass of each body",
    "ground": "what does not move",
    "all": "all bodies",
    **dict.fromkeys(_FUNCTIONS, "a function"),
}
AXES = {"x": "an axis of space", "y": "an axis of space"}


def fault_of_name(name: str, reserved: dict[str, str] = RESERVED) -> tuple[str, str]:
    """What is wrong with a name and what to do, two empty texts if nothing is."""
    if not _NAME.fullmatch(name):
        return f"“{name}” can't be a name", "a name is made of a-z, A-Z, 0-9 and “_”, a letter first: theta_0, N_w."
    if name in reserved:
        return f"“{name}” is reserved: it means {reserved[name]}", "choose another name."
    if re.search(r"_d+ot$", name):
        return f"“{name}” can't be declared: names ending in _dot are time derivatives", "choose another name."
    return "", ""


def check_name(name: str, table: Table, reserved: dict[str, str] = RESERVED, key: str | None = None) -> None:
    """Refuse a name that can't be; `table` is what bears the name, or holds it as `key`."""
    what, instead = fault_of_name(name, reserved)
    if what:
        raise table.error(what, instead, key)


def check_name_item(item: Item, what: str) -> str:
    """The name that a value holds."""
    if not isinstance(item.value, str):
        raise item.error(f"{what} must be a name in quotes, not {kind_of(item.value)}")
    fault, instead = fault_of_name(item.value)
    if fault:
        raise item.error(fault, instead)
    return item.value


def twice(name: str, first: str, second: str, table: Table, key: str | None = None) -> StatementError:
    """The error of a name that two things bear."""
    return table.error(f"“{name}” is the name of {first} and of {second}", "give one of them another name.", key)
