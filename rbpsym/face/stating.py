"""A problem whose values are sympy's: each becomes the text of a file, each symbol a parameter with its sign.

The slot in which a symbol stands gives its dimension. `problem` takes what a file may have, besides: functions of the
time as coordinates (`coordinates=[theta]`, or as keys), and `assumptions`, relations that bound a symbol or a coordinate.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import contextmanager, suppress
from fractions import Fraction
from typing import Any

from rbpsym.decide.dimensions import Unsettled, require_dimension
from rbpsym.errors import DimensionError, Place, RbpsymError, ReadError, StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node, names
from rbpsym.face.late import sympy
from rbpsym.face.reading import CLOCK, SIGNS, is_sympy, name_of, tree_of
from rbpsym.frozen import Frozen, field
from rbpsym.quantities import DIMENSIONS, NUMBER, TIME, Dimension, dimension_named
from rbpsym.statement import build
from rbpsym.statement.model import Problem
from rbpsym.statement.slots import QUANTITIES, Slot, slot_of
from rbpsym.typeset.machine import to_machine

# --- the dimensions of symbols that nobody declared, from the slots in which they stand: what is a rod's length is a length


def inferred(slots: Iterable[tuple[Node, Slot]], known: Mapping[str, Dimension]) -> dict[str, Dimension]:
    """The dimensions that follow from formulas and their slots, by name.

    >>> from rbpsym.expr.tree import Mul, Num, Sym
    >>> str(inferred([(Mul((Num(2), Sym("ell"))), Slot())], {})["ell"])
    'length'
    """
    slots, agreeing = list(slots), list[Dimension]()
    used = {name.removesuffix("_dot") for node, slot in slots for name in (*names(node), slot.of)}
    unknown = used - known.keys() - {""}
    open_ = {name: Dimension(*(sympy.Symbol(f"{part}.{name}") for part in "MLT")) for name in unknown}
    rates = {f"{name}_dot": dimension / TIME for name, dimension in {**known, **open_}.items()}
    for node, slot in slots:
        scope = Unsettled({**rates, **known, **open_, **slot.variables}, agreeing)
        with suppress(DimensionError):
            require_dimension(node, scope, slot.dimension * scope.get(slot.of, NUMBER), "")
    solved: dict[Any, Any] = {}
    for exponent in (part for each in agreeing for part in _parts(each)):
        left = sympy.expand((sympy.Integer(0) + exponent).xreplace(solved))
        for first in sorted(left.free_symbols, key=str)[:1]:
            image = {first: sympy.expand(first - left / left.coeff(first))}
            solved = {name: sympy.expand(value.xreplace(image)) for name, value in solved.items()} | image
    found = {name: [part.xreplace(solved) for part in _parts(each)] for name, each in open_.items()}
    settled = {name: parts for name, parts in found.items() if all(part.is_Rational for part in parts)}
    return {name: Dimension(*(Fraction(part.p, part.q) for part in parts)) for name, parts in settled.items()}


def _parts(dimension: Dimension) -> tuple[Any, ...]:
    return dimension.mass, dimension.length, dimension.time


# ---


Path = tuple[str, ...]
START, PLACE = ("start", "speed"), Slot()


def quantity(symbol: sympy.Symbol, dimension: str, meaning: str = "", **keys: object) -> dict[sympy.Symbol, Any]:
    """A symbol with its dimension, for `parameters=quantity(k, "stiffness") | quantity(g, "acceleration")`.

    `keys` are range and glyph. Raises ReadError for a symbol without a sign, DimensionError for an unknown dimension.

    >>> import sympy
    >>> quantity(sympy.Symbol("k", positive=True), "stiffness")
    {k: {'dimension': 'stiffness', 'meaning': '', 'sign': 'positive', 'glyph': ''}}
    """
    name_of(symbol)
    return {symbol: {**build.parameter(str(dimension_named(dimension)), meaning, sign_of(symbol)), **keys}}


def sign_of(symbol: sympy.Symbol) -> str:
    """The sign that a symbol's assumptions say. Raises ReadError if they say none, or something else."""
    for sign, said in SIGNS.items():
        if symbol == sympy.Symbol(symbol.name, **said):
            return sign
    what = "the sign of “{}” is not said" if _is_bare(symbol) else "the symbol “{}” assumes what has no place here"
    instead = f'write sympy.Symbol("{symbol.name}", positive=True), or nonnegative=True, or real=True.'
    raise ReadError(what.format(symbol.name), instead=instead)


def _is_bare(symbol: Any) -> bool:
    """Whether nothing is assumed of a symbol."""
    return bool(symbol == sympy.Symbol(symbol.name))


def problem(name: str, **sections: Any) -> Problem:
    """The problem called `name`; `sections` are those of a file, their values text, numbers or expressions of sympy.

    Raises RbpsymErrors: StatementError for what contradicts itself, ReadError for what sympy knows and a statement does
    not, DimensionError where the slots do not give the dimension of a symbol.

    >>> import sympy
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from rbpsym import gravity, pivot, rod
    >>> m, ell, g = sympy.symbols("m ell g", positive=True)
    >>> theta = dynamicsymbols("theta")
    >>> pendulum = problem(
    ...     "pendulum", coordinates=[theta], interactions={"W": gravity(g)}, constraints={"F": pivot("rod.start")},
    ...     bodies={"rod": rod(2*ell, mass=m, start=(0, 0), angle=theta - sympy.pi/2)},
    ... )
    >>> [(q.name, str(q.dimension)) for q in pendulum.parameters]
    [('g', 'acceleration'), ('ell', 'length'), ('m', 'mass')]
    """
    found = _Found(str(name))
    tables = {key: found.read(part, (key,)) for key, part in _bounded(sections, found).items()}
    made = build.problem(name, **(_declared(tables, found) if found.symbols else tables))
    for each in made.parameters:
        symbol, path = found.symbols.get(each.name, (None, ()))
        with found.at(path):
            if symbol is not None and not _is_bare(symbol) and sign_of(symbol) != each.sign:
                what = f"the symbol “{each.name}” is {sign_of(symbol)}, but declared to be {each.sign}"
                raise StatementError(what, instead="say the same in both places.")
    return made


class _Found(Frozen):
    """What stands in a statement: expressions with their slots; symbols and functions of the time by name, each with
    its first place."""

    name: str
    leaves: list[tuple[t.Node, Slot, Path]] = field(default_factory=list)
    symbols: dict[str, tuple[Any, Path]] = field(default_factory=dict)

    def read(self, value: Any, path: Path, slot: Slot = PLACE) -> Any:
        """The value with text where sympy's expressions are, and names for keys that are symbols."""
        if isinstance(value, Mapping):
            named = {self.text(key, path) if is_sympy(key) else key: part for key, part in value.items()}
            return {key: self.read(part, (*path, str(key)), slot_of(named, path, key)) for key, part in named.items()}
        if isinstance(value, (list, tuple)) or hasattr(value, "shape"):  # matrices of sympy and numpy
            return [self.read(part, path, slot) for part in value]
        return self.text(value, path, slot) if is_sympy(value) else value

    def text(self, expression: Any, path: Path, slot: Slot | None = None) -> str:
        """The text of an expression; of a key, if there is no slot."""
        with self.at(path):
            node = tree_of(expression)
            for each in sorted(expression.atoms(sympy.Symbol, sympy.core.function.AppliedUndef), key=str):
                self.meet(each, path, {CLOCK} | (slot.variables.keys() if slot else set()))
            if slot is None and path == QUANTITIES[:1] and expression.is_Symbol:
                what, instead = f"the coordinate “{expression}” changes with time", f'write dynamicsymbols("{expression}").'
                raise ReadError(what, instead=instead)
            if slot is not None:
                self.leaves.append((node, slot, path))
            return to_machine(node) if slot else name_of(expression)

    def meet(self, symbol: Any, path: Path, others: Set[str]) -> None:
        """Notes a symbol. Raises ReadError if another one has its name."""
        name = name_of(symbol)
        if name not in others and self.symbols.setdefault(name, (symbol, path))[0] != symbol:
            what = f"“{name}” stands for two things, or for one with different assumptions"
            raise ReadError(what, instead="use one and the same symbol in all places.")

    @contextmanager
    def at(self, path: Path) -> Iterator[None]:
        """Errors are told with the place of the value."""
        try:
            yield
        except RbpsymError as error:
            raise error.at(Place(f"{self.name}: {'.'.join(path)}")) from None


def _bounded(sections: Mapping[str, Any], found: _Found) -> dict[str, Any]:
    """The sections with tables of coordinates and parameters, in which the bounds stand that are assumed."""
    tables: dict[str, Any] = {key: part for key, part in sections.items() if key != "assumptions"}
    for key in QUANTITIES:
        several = [tables[key]] if is_sympy(tables.get(key)) else tables.get(key, {})
        if isinstance(several, (list, tuple)):
            several = {each: {} for each in several}
        if isinstance(several, Mapping):
            several = {found.text(each, (key,)) if is_sympy(each) else each: part for each, part in several.items()}
        tables[key] = several
    assumed = sections.get("assumptions", ())
    with found.at(("assumptions",)):
        for relation in assumed if isinstance(assumed, (list, tuple)) else [assumed]:
            _bound(relation, tables, found)
    return tables


def _bound(relation: Any, tables: Mapping[str, Any], found: _Found) -> None:
    """Notes a relation as a bound of the symbol or coordinate on one of its sides."""
    if isinstance(relation, sympy.And):
        for part in relation.args:
            _bound(part, tables, found)
        return
    if is_sympy(relation) and relation.func(*relation.args) == sympy.true:
        return  # the signs of the symbols say it already
    if not isinstance(relation, sympy.StrictLessThan | sympy.StrictGreaterThan):
        raise ReadError(f"“{relation}” can't be assumed", instead="assume a < b or a > b: ranges are open.")
    for side, bound, end in ((relation.gts, relation.lts, 0), (relation.lts, relation.gts, 1)):
        node = tree_of(side)
        if isinstance(node, t.Sym) and node.name not in ("pi", CLOCK):
            section = next((tables[key] for key in QUANTITIES if node.name in tables[key]), tables["parameters"])
            entry = section.get(node.name, {})
            ends = list(entry.get("range", ("", ""))) if isinstance(entry, Mapping) else []
            if ends[end : end + 1] == [""]:
                found.meet(side, ("assumptions",), set())
                ends[end] = bound
                section[node.name] = {**entry, "range": ends}
                return
    raise ReadError(f"“{relation}” bounds nothing that is not bounded yet", instead="say it where the quantity is declared.")


def _declared(tables: dict[str, Any], found: _Found) -> dict[str, Any]:
    """With the parameters that nobody declared, and the dimensions of parameters and coordinates."""
    coordinates, parameters = (tables[key] for key in QUANTITIES)
    if not isinstance(coordinates, dict) or not isinstance(parameters, dict):
        return tables
    told = {name: _dimension(entry) for section in (parameters, coordinates) for name, entry in section.items()}
    known = {name: dimension for name, dimension in told.items() if dimension is not None} | {"pi": NUMBER, CLOCK: TIME}
    dimensions = inferred(((node, slot) for node, slot, _ in found.leaves), known)
    inside = {name for node, _, path in found.leaves if path[-1] not in START for name in t.names(node)}
    for name, (symbol, path) in found.symbols.items():
        with found.at(path):
            if not symbol.is_Symbol and name not in coordinates:
                raise ReadError(f"“{symbol}” is none of the coordinates", instead=f"write coordinates=[{name}, ...].")
            entry = parameters.get(name, {})
            if name in known or name in coordinates or not isinstance(entry, Mapping):
                continue
            if name in inside or sign_of(symbol) != "real":  # else a coordinate starts there: a constant is made of it
                parameters[name] = {**build.parameter(_word(name, dimensions), sign=sign_of(symbol)), **entry}
    for name, entry in coordinates.items():
        if dimensions.get(name, NUMBER) != NUMBER and isinstance(entry, Mapping):
            coordinates[name] = {**entry, "dimension": _word(name, dimensions)}
    return tables


def _dimension(entry: Any) -> Dimension | None:
    """The dimension that an entry of [parameters] or [coordinates] declares; None if it has none that is known."""
    word = entry.get("dimension", "") if isinstance(entry, Mapping) else re.split("[:,<>]", str(entry))[0]
    try:
        return dimension_named(str(word).strip())
    except DimensionError:
        return None


def _word(name: str, dimensions: Mapping[str, Dimension]) -> str:
    word = str(dimensions.get(name, ""))
    if word not in DIMENSIONS:
        why = f"would be {word}, which has no name" if word else "does not follow from where it stands"
        instead = f'write parameters=quantity({name}, "length"), with others behind |, or mend the formula.'
        raise DimensionError(f"the dimension of “{name}” {why}", instead=instead)
    return word
