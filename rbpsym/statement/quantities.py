"""The sections [parameters] and [coordinates]: what the problem's symbols are."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from difflib import get_close_matches

from rbpsym.errors import DimensionError
from rbpsym.expr.tree import ZERO, Div, Neg, Node, Num, Sym, names, neg
from rbpsym.quantities import NUMBER, TIME, Dimension, Quantity, dimension_named
from rbpsym.statement.completing import fitting
from rbpsym.statement.model import Coordinate
from rbpsym.statement.premises import Declared, declared, surely_above
from rbpsym.statement.references import AXES, RESERVED, check_name, fault_of_name
from rbpsym.statement.scope import Scope, read_expression, read_text
from rbpsym.statement.source import SIGNS, SourceItem, SourceTable, did_you_mean, for_a_dimension, kind_of

_PARAMETER_KEYS = ("dimension", "meaning", "sign", "range", "glyph")
_COORDINATE_KEYS = ("meaning", "dimension", "start", "speed", "acceleration", "range", "glyph")
_EXAMPLE = ('write it as "length: radius of the disk", "mass, nonnegative: mass of the rod" or "length > a: outer radius"')
_RIGHT_ANGLE = Div(Sym("pi"), Num(2))


def read_parameters(table: SourceTable) -> tuple[Quantity, ...]:
    """The quantities of the section [parameters]. A bound may hold any of them."""
    section = table.table("parameters", "parameters")
    found: dict[str, Quantity] = {}
    for name in section.names():
        check_name(name, section, RESERVED | AXES, key=name)
        found[name] = _parameter(name, section)
    given = declared(found.values())
    scope = Scope({name: quantity.dimension for name, quantity in found.items()}, given=given)
    bounded = {name: _bounded(quantity, section, scope) for name, quantity in found.items()}
    _check_bounds(bounded, section, given)
    return tuple(bounded.values())


def _check_bounds(found: Mapping[str, Quantity], section: SourceTable, given: Declared) -> None:
    """No quantity is its own bound, nor smaller than what is smaller than it."""
    above: dict[str, set[str]] = {name: set() for name in found}  # of each, what is surely greater
    for name, quantity in found.items():
        if name in {n for bound in (quantity.lower, quantity.upper) if bound is not None for n in names(bound)}:
            raise section.error(f"“{name}” is in its own bound", "name another quantity.", name)
        if isinstance(quantity.upper, Sym):
            above[name].add(quantity.upper.name)
        if isinstance(quantity.lower, Sym) and quantity.lower.name in above:
            above[quantity.lower.name].add(name)
        _check_bounds_of(quantity, section, given)
    for name in found:
        if name in _reached(name, above):
            raise section.error(f"the bounds of “{name}” contradict each other", "turn one of them round.", name)


def _check_bounds_of(quantity: Quantity, section: SourceTable, given: Declared) -> None:
    """There is a number between the bounds, and of the sign that is declared."""
    floor = ZERO if quantity.sign in ("positive", "nonnegative") else None
    if any(surely_above(low, quantity.upper, given, or_equal=True) for low in (quantity.lower, floor)):
        what = f"no number between the bounds of “{quantity.name}” is {quantity.sign}"
        raise section.value_error(quantity.name, what, "change a bound, or the sign: it is positive unless said otherwise.")


def _reached(name: str, above: Mapping[str, set[str]]) -> set[str]:
    found: set[str] = set()
    new = set(above[name])
    while new:
        found |= new
        new = {other for one in new for other in above.get(one, ())} - found
    return found


def _parameter(name: str, section: SourceTable) -> Quantity:
    if isinstance(section.data[name], Mapping):
        return _parameter_of_table(name, section.table(name, f"parameters.{name}"))
    item = section.item(name)
    if not isinstance(item.value, str) or not item.value.strip():
        raise item.error(f"the parameter “{name}” must be a text, not {kind_of(item.value)}", _EXAMPLE)
    head, _, meaning = item.value.partition(":")
    dimension, _, sign = _BOUND.sub("", re.sub(r"^\s*acute\b", "angle, acute", head), count=1).partition(",")  # “acute” alone
    checked = _sign(item, sign, len(dimension) + 1) if sign else "positive"
    return _quantity(item, name, _dimension(item, dimension), meaning.strip(), checked)


_BOUND = re.compile(r"\s*([<>]=?|[≤≥])([^,]*)")  # an end that may be reached bounds the same open interval


def _parameter_of_table(name: str, table: SourceTable) -> Quantity:
    table.check_keys(_PARAMETER_KEYS, f"the parameter “{name}”")
    table.require("dimension", f"the parameter “{name}”", 'add dimension = "length"')
    dimension = _dimension(table.item("dimension"), table.string("dimension"))
    sign = _sign(table.item("sign"), table.string("sign")) if "sign" in table else "positive"
    found = _quantity(table.item("dimension"), name, dimension, table.string("meaning"), sign)
    return replace(found, glyph=table.string("glyph") or None)


def _quantity(item: SourceItem, name: str, dimension: Dimension, meaning: str, sign: str) -> Quantity:
    if sign != "acute":
        return Quantity(name, dimension, meaning, sign)
    if dimension != NUMBER:
        raise item.error(f"the {dimension} “{name}” can't be acute", "only an angle is acute: leave the word out.")
    return Quantity(name, dimension, meaning, "positive", lower=ZERO, upper=_RIGHT_ANGLE)


def _bounded(quantity: Quantity, section: SourceTable, scope: Scope) -> Quantity:
    """With the bounds of `range = ["a", ""]` or of the short form "length > a: ..."."""
    what = f"bound of “{quantity.name}”"
    if isinstance(section.data[quantity.name], Mapping):
        table = section.table(quantity.name, f"parameters.{quantity.name}")
        if "range" not in table:
            return quantity
        lower, upper = read_range(table.item("range"), scope, f"the parameter “{quantity.name}”", quantity.dimension)
        return replace(quantity, lower=lower, upper=upper)
    item, head = section.item(quantity.name), section.data[quantity.name].partition(":")[0]
    found = _BOUND.search(head)
    if found is None:
        return quantity
    bound = read_text(item, found[2], scope, what, quantity.dimension, shift=found.start(2))
    return replace(quantity, lower=bound) if found[1] in (">", ">=", "≥") else replace(quantity, upper=bound)


def _dimension(item: SourceItem, text: str) -> Dimension:
    word = text.strip()
    try:
        return dimension_named(word)
    except DimensionError as error:
        column = 1 + len(text) - len(text.lstrip())
        place = item.source.inside(item.path, str(item.value), column, len(word))
        instead = for_a_dimension(word, error.instead)
        raise DimensionError(error.what, instead=instead, place=place) from None


def _sign(item: SourceItem, text: str, shift: int = 0) -> str:
    word = text.strip()
    if word not in SIGNS:
        column = shift + 1 + len(text) - len(text.lstrip())
        raise item.error_inside(f"unknown sign “{word}”", did_you_mean(word, SIGNS, "signs"), column, len(word))
    return word


class CoordinateReader:
    """Reads [coordinates]; collects the constants that only a start names (`implicit`)."""

    def __init__(self, table: SourceTable, scope: Scope) -> None:
        self.section = table.table("coordinates", "coordinates")
        self.scope = scope
        said = {name: self._dimension(name) for name in self.section.names()}
        told = {name: found for name, found in said.items() if found is not None}
        self.dimensions = told | fitting(table.data, {**scope.parameters, **told}, [name for name in said if name not in told])
        self.implicit: dict[str, Quantity] = {}

    def read(self) -> Iterator[Coordinate]:
        """The coordinates, in order."""
        for name in self.section.names():
            yield self._coordinate(name, self.section.table(name, f"coordinates.{name}"))

    def _dimension(self, name: str) -> Dimension | None:
        table = self.section.table(name, f"coordinates.{name}")
        check_name(name, table)
        return _dimension(table.item("dimension"), table.string("dimension")) if "dimension" in table else None

    def _coordinate(self, name: str, table: SourceTable) -> Coordinate:
        where = f"the coordinate “{name}”"
        table.check_keys(_COORDINATE_KEYS, where)
        dimension = self.dimensions[name]
        quantity = Quantity(name, dimension, table.string("meaning"), "real", table.string("glyph") or None)
        start = self._value(table, "start", f"start of {where}", dimension, f"start value of {name}")
        lower, upper = self._range(table, where, dimension)
        if isinstance(start, Neg) and lower is not None and (own := self.implicit.get(getattr(start.arg, "name", ""))):
            self.implicit[own.name] = replace(own, upper=neg(lower))
        speed = self._speed(table, where, dimension / TIME, name)
        gain = self._value(table, "acceleration", f"acceleration of {where}", dimension / TIME**2, f"acceleration of {name}")
        if gain is not None:
            table.require("start", f"{where}, whose acceleration is given,", "say where it begins: a value, or a name.")
        return Coordinate(quantity, start, speed, lower, upper, table.source.key(table.path), gain)

    def _speed(self, table: SourceTable, where: str, dimension: Dimension, name: str) -> Node | None:
        if "speed" not in table and "start" not in table:
            return None
        return self._value(table, "speed", f"speed of {where}", dimension, f"start speed of {name}", default="0")

    def _value(
        self, table: SourceTable, key: str, what: str, dimension: Dimension, meaning: str, default: str | None = None
    ) -> Node | None:
        """The expression under `key`; a name that nobody declared becomes a constant, with a minus a positive one."""
        item = table.item(key, default)
        if item.value is None:
            return None
        name = item.value.removeprefix("-").strip() if isinstance(item.value, str) else item.value
        if self._is_new_name(name):
            is_plain = name == item.value.strip()
            said = meaning if is_plain else f"size of the {meaning}"
            self.implicit[name] = Quantity(name, dimension, said, "real" if is_plain else "positive")
            return Sym(name) if is_plain else neg(Sym(name))
        return read_expression(item, self._scope(), what, dimension)

    def _is_new_name(self, text: object) -> bool:
        """Whether a text names a new constant, and not a declared one with a slip."""
        if not isinstance(text, str) or fault_of_name(text)[0] or text in self._scope().all:
            return False
        return text[-1].isdigit() or not get_close_matches(text, self.scope.parameters, n=1, cutoff=0.8)

    def _scope(self) -> Scope:
        implicit = {name: quantity.dimension for name, quantity in self.implicit.items()}
        return Scope({**self.scope.parameters, **implicit}, self.dimensions, self.scope.given)

    def _range(self, table: SourceTable, where: str, dimension: Dimension) -> tuple[Node | None, Node | None]:
        if "range" not in table:
            return None, None
        return read_range(table.item("range"), self._scope(), where, dimension)


def read_range(item: SourceItem, scope: Scope, where: str, dimension: Dimension) -> tuple[Node | None, Node | None]:
    """The two bounds of an open interval; None for a side that is left open."""
    if not isinstance(item.value, (list, tuple)) or len(item.value) != 2:
        raise item.error(f"range of {where} must be a list of two expressions", 'write range = ["0", "pi/2"]')
    lower, upper = (_bound(part, scope, f"range of {where}", dimension) for part in item.items())
    return lower, upper


def _bound(item: SourceItem, scope: Scope, what: str, dimension: Dimension) -> Node | None:
    return None if item.value == "" else read_expression(item, scope, what, dimension)
