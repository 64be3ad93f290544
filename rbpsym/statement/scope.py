"""The names that an expression of a statement may use, and the reading of expressions."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.decide.dimensions import require_dimension
from rbpsym.errors import DimensionError, Place, RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Add, Node, Num, Sym, renamed, walk
from rbpsym.expr.tree import names as tree_names
from rbpsym.frozen import Frozen, field, replace
from rbpsym.quantities import LENGTH, NUMBER, TIME, Dimension
from rbpsym.statement.model import Pair
from rbpsym.statement.premises import LEFT_OPEN, NOTHING_DECLARED, Declared, contradicts, without_value
from rbpsym.statement.source import SourceItem, did_you_mean, kind_of, relocate, unknown_symbol, written
from rbpsym.typeset.machine import written_otherwise

ORIGIN: Pair = (Num(0), Num(0))
CLOCK = "t"


class Scope(Frozen):
    """The quantities of a problem: dimensions of its parameters and coordinates, and what is `given` of their signs.

    `variables` are names that only one expression knows (s in a rod's density, x and y in a
    line); they hide quantities of the same name. `points` are the fixed points, `forces` the unknown ones,
    `starts` the places where what is read must have a value.
    """

    parameters: Mapping[str, Dimension] = field(default_factory=dict)
    coordinates: Mapping[str, Dimension] = field(default_factory=dict)
    given: Declared = NOTHING_DECLARED
    points: Mapping[str, Pair] = field(default_factory=lambda: {"O": ORIGIN})
    variables: Mapping[str, Dimension] = field(default_factory=dict)
    forces: Mapping[str, Dimension] = field(default_factory=dict)
    starts: Mapping[str, Node] = field(default_factory=dict)

    @property
    def speeds(self) -> dict[str, Dimension]:
        """The first time derivatives of the coordinates."""
        return {f"{name}_dot": dimension / TIME for name, dimension in self.coordinates.items()}

    @property
    def all(self) -> dict[str, Dimension]:
        """Every name with its dimension."""
        return {CLOCK: TIME, **self.parameters, **self.coordinates, **self.speeds, **self.forces, **self.variables}

    def role(self, name: str) -> str:
        """What a name is: "parameter", "coordinate", "force", "speed" or "time"."""
        roles = {"parameter": {**self.parameters, **self.variables}, "coordinate": self.coordinates, "time": (CLOCK,)}
        roles["force"] = self.forces
        return next((role for role, names in roles.items() if name in names), "speed")

    def with_variables(self, variables: Mapping[str, Dimension]) -> Scope:
        """The scope inside an expression that has variables of its own."""
        return replace(self, variables=variables)


_FORBIDDEN = {
    "parameters": ("time", "coordinate", "speed", "force"),
    "time": ("coordinate", "speed", "force"),
    "coordinates": ("speed", "force"),
    "speeds": ("force",),
    "forces": (),
}
_MAY_USE = {"time": "parameters and the time t"}


def text_of(item: SourceItem, what: str) -> str:
    """The text of an expression: a string or a plain number."""
    value = item.value
    if isinstance(value, str) and value.strip():
        return value
    if (text := written(value)) is not None:
        return text
    found = "an empty text" if isinstance(value, str) else kind_of(value)
    raise item.error(f"{what} must be an expression in quotes, not {found}", 'write it as "2*ell"')


def read_expression(
    item: SourceItem,
    scope: Scope,
    what: str,
    dimension: Dimension | None = None,
    may_use: str = "parameters",
    sign: str = "",
) -> Node:
    """The tree of an expression, its names, dimension and sign checked."""
    text = text_of(item, what)
    return read_text(item, text, scope, what, dimension, may_use, sign)


def read_text(
    item: SourceItem,
    text: str,
    scope: Scope,
    what: str,
    dimension: Dimension | None = None,
    may_use: str = "parameters",
    sign: str = "",
    shift: int = 0,
) -> Node:
    """As `read_expression`, for a part of the item's text that begins `shift` characters in."""
    names = scope.all
    try:
        node = read_infix(text, names, aliases=written_otherwise(names))
        _check_names(node, scope, what, may_use)
        if dimension is not None:
            _check_dimension(node, scope, dimension, what)
        _check_values(node, scope, what, sign, may_use)
    except RbpsymError as error:
        _explain(error, text, dimension)
        raise relocate(error, item.source, item.path, text_of(item, what), shift) from None
    return node


def _explain(error: RbpsymError, text: str, dimension: Dimension | None) -> None:
    """A better hint for a name that the problem does not have."""
    found = re.match(r"unknown symbol “(\w+)”", error.what)
    if found and error.place:
        error.instead = unknown_symbol(text, found[1], error.place.column, error.instead, dimension)


def _check_names(node: Node, scope: Scope, what: str, may_use: str) -> None:
    for part in walk(node):
        if not isinstance(part, Sym) or part.name == "pi":
            continue
        if part.name not in scope.all:
            raise _at(part, f"unknown symbol “{part.name}” in {what}", did_you_mean(part.name, scope.all, "declared"))
        role = scope.role(part.name)
        if role in _FORBIDDEN[may_use]:
            raise _at(
                part,
                f"{what} must not depend on “{part.name}”, a {role}",
                f"it may be made of {_MAY_USE.get(may_use, may_use)}.",
            )


def _check_dimension(node: Node, scope: Scope, dimension: Dimension, what: str) -> None:
    """The most usual slip is a coordinate that is a length, but was not said to be one."""
    try:
        require_dimension(node, scope.all, dimension, what)
    except DimensionError as error:
        terms = node.terms if isinstance(node, Add) else (node,)
        bare = [part.name for part in terms if isinstance(part, Sym) and part.name in scope.coordinates]
        if dimension == LENGTH and bare and scope.coordinates[bare[0]] == NUMBER:
            error.instead = f'if “{bare[0]}” is a length, say so: dimension = "length" in [coordinates.{bare[0]}]'
        elif not error.instead and error.what.endswith("this is an angle or a number"):
            error.instead = NUMBERS_ARE_NAMES
        raise


NUMBERS_ARE_NAMES = "multiply it by a parameter of the dimension that is missing, or write one instead of a number."


def _check_values(node: Node, scope: Scope, what: str, sign: str, may_use: str) -> None:
    """What has no value, or not the sign that is needed, whatever the declared numbers are; of a size with speeds and unknown
    forces, where these are positive."""
    rests_on_forces = may_use == "forces" and not tree_names(node) & {*scope.coordinates, CLOCK}
    given = scope.given.without(scope.variables)
    given = given.positive(*scope.variables, *scope.forces) if rests_on_forces else given
    for where, starts in (("", {}), (" at the start", scope.starts)):
        if nowhere := without_value(renamed(node, starts) if starts else node, given):
            raise _at(nowhere[0], f"{what} {nowhere[1]}{where}", "write what has a value for the numbers that are declared.")
    found = contradicts(node, sign, given)
    varies = not rests_on_forces and (scope.variables or CLOCK in tree_names(node))  # where, or when, is not known
    if found and not (found == LEFT_OPEN and varies):
        raise _at(node, f"{what} must be {sign}, but this is {found}", SIGNS_ARE_PREMISES)


SIGNS_ARE_PREMISES = 'declare bounds for which it is so, as in "mass > m: mass of the block", or write another expression.'


def _at(node: Node, what: str, instead: str = "") -> StatementError:
    place = Place(column=node.span[0] + 1, width=node.span[1] - node.span[0]) if node.span else None
    return StatementError(what, instead=instead, place=place)


def read_pair(
    item: SourceItem, scope: Scope, what: str, dimension: Dimension | None = LENGTH, may_use: str = "parameters"
) -> Pair:
    """Two expressions, or the name of a fixed point."""
    if isinstance(item.value, str) and dimension == LENGTH:
        return fixed_point(item, scope, what)
    if not isinstance(item.value, (list, tuple)) or len(item.value) != 2:
        raise item.error(
            f"{what} must be a pair of expressions, not {_pair_fault(item.value)}",
            'write it as ["ell*cos(theta)", "0"]',
        )
    x, y = (read_expression(part, scope, what, dimension, may_use) for part in item.items())
    return x, y


def _pair_fault(value: object) -> str:
    count = f"a list of {len(value)}" if isinstance(value, (list, tuple)) else ""
    return count or kind_of(value)


def fixed_point(item: SourceItem, scope: Scope, what: str) -> Pair:
    """The place of the fixed point that is named."""
    if item.value not in scope.points:
        others = f", or one of {', '.join(scope.points)}" if scope.points else ""
        joined = ' (two points of bodies are joined by type = "pin")' if "." in item.value else ""
        raise item.error(f"{what}: “{item.value}” is not a fixed point", f'write a pair ["0", "0"]{others}{joined}.')
    return scope.points[item.value]
