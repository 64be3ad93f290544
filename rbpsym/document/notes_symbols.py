"""The table of symbols: parameters, coordinates, their rates and their values at the start."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Derivation
from rbpsym.document.model import Inlines, Math, Table, words
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.quantities import NUMBER, Quantity
from rbpsym.statement.model import Problem

Row = tuple[Inlines, Inlines, Inlines]


def symbols_table(derivation: Derivation, said: Words) -> Table:
    """Symbol, meaning and dimension of all that the statement names."""
    problem = derivation.study.problem
    header = tuple(said.say(f"header.{key}") for key in ("symbol", "meaning", "dimension"))
    rows = [*_parameters(problem, said), *_coordinates(problem, said), *_starts(problem, said)]
    return Table(header, tuple(rows), said.say("caption.parameters"), "cll", said.prefix + "table.symbols")


def _parameters(problem: Problem, said: Words) -> Iterator[Row]:
    for quantity in problem.parameters:
        if quantity.name not in problem.implicit:
            yield _row(t.Sym(quantity.name), quantity, dimension_words(quantity, said), said)


def _row(letter: t.Node, quantity: Quantity, dimension: Inlines, said: Words) -> Row:
    return (Math(letter),), words(said.meaning(quantity.name, quantity.meaning)), dimension


def _coordinates(problem: Problem, said: Words) -> Iterator[Row]:
    """Each coordinate, and its rates where the notation has letters of their own for them."""
    for coordinate in problem.coordinates:
        quantity, letter = coordinate.quantity, t.Sym(coordinate.name)
        angle = quantity.dimension == NUMBER
        yield _row(letter, quantity, said.say("dimension.angle") if angle else dimension_words(quantity, said), said)
        rates = [f"{coordinate.name}_{dots}" for dots in ("dot", "ddot")]
        own = [t.Sym(rate) for rate in rates if rate in problem.notation]
        if own and rates[0] in problem.notation:
            yield said.say("plain", text=own), said.say("symbols.rates", coordinate=letter, count=len(own)), ()


def _starts(problem: Problem, said: Words) -> Iterator[Row]:
    """The constants at which the coordinates and speeds start."""
    for coordinate in problem.coordinates:
        pairs = ((coordinate.start, coordinate.name), (coordinate.speed, f"{coordinate.name}_dot"))
        found = [(start, t.Sym(of)) for start, of in pairs if _is_constant(start, problem)]
        if found:
            letters = said.say("plain", text=[start for start, _ in found])
            yield letters, said.say("symbols.start", of=[of for _, of in found], count=len(found)), ()


def _is_constant(start: t.Node | None, problem: Problem) -> bool:
    return isinstance(start, t.Sym) and start.name in problem.implicit


def dimension_words(quantity: Quantity, said: Words) -> Inlines:
    """The dimension by name, in the language of the notes."""
    key = f"dimension.{str(quantity.dimension).replace(' ', '_')}"
    return said.say(key) if said.has(key) else words(str(quantity.dimension))
