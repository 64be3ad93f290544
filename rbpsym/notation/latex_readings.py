"""A formula that can be read in several ways: the one in which the dimensions fit, or an error.

Among the readings with the fewest faults of dimension, the usual one is taken; if two remain that differ, the
formula is refused at the place where they part.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.latex_table import Question, Reader
from rbpsym.notation.latex_tokens import Token
from rbpsym.notation.source import Source
from rbpsym.notation.symbol_table import SymbolTable, equally

MOST_READINGS, MOST_TOKENS = 128, 12_000  # readings, and tokens read in all of them
Read = Callable[[Reader], t.Node]


@dataclass(frozen=True, slots=True)
class Reading:
    """A formula as it was read with some choices: the tree or the error, the questions met, how unusual it is."""

    script: tuple[bool, ...]
    met: tuple[Question, ...]
    cost: int
    node: t.Node | None
    error: RbpsymError | None


def best_reading(source: Source, tokens: tuple[Token, ...], table: SymbolTable, read: Read) -> t.Node:
    """The tree that is meant. Raises ReadError if none or more than one can be meant."""
    first = _reading(source, tokens, table, read, ())
    if not first.met:
        return _tree(first)
    readings = _all(source, tokens, table, read, first)
    sound = [reading for reading in readings if reading.node is not None]
    if not sound:
        raise first.error
    faults = {reading.script: table.faults(reading.node) for reading in sound}
    ranked = sorted(sound, key=lambda reading: (faults[reading.script], reading.cost))
    best = ranked[0]
    rank = (faults[best.script], best.cost)
    rivals = [r for r in ranked if (faults[r.script], r.cost) == rank and r.node != best.node]
    if rivals:
        raise _asked(source, _parting(best, rivals[0]))
    return best.node


def every_reading(source: Source, tokens: tuple[Token, ...], table: SymbolTable, read: Read) -> tuple[Reading, ...]:
    """All readings that make a formula, the first without any unusual choice. Raises ReadError if there is none."""
    free = replace(table, faults=equally)
    first = _reading(source, tokens, free, read, ())
    readings = _all(source, tokens, free, read, first)
    sound = tuple(reading for reading in readings if reading.node is not None)
    if not sound:
        raise first.error
    return sound


def _tree(reading: Reading) -> t.Node:
    if reading.node is None:
        raise reading.error
    return reading.node


def _reading(
    source: Source, tokens: tuple[Token, ...], table: SymbolTable, read: Read, script: tuple[bool, ...]
) -> Reading:
    reader = Reader(source, tokens, table=table, script=script)
    try:
        node, error = read(reader), None
    except RbpsymError as found:
        node, error = None, found
    chosen = (*script, *(False,) * (len(reader.met) - len(script)))
    return Reading(chosen, tuple(reader.met), reader.cost, node, error)


def _all(source: Source, tokens: tuple[Token, ...], table: SymbolTable, read: Read, first: Reading) -> list[Reading]:
    """Every reading: of each, those that choose otherwise at one of the questions behind its script."""
    found, waiting = [first], [(first, 0)]
    most = min(MOST_READINGS, max(MOST_TOKENS // len(tokens), 2))
    while waiting:
        reading, fixed = waiting.pop()
        for place in range(fixed, len(reading.met)):
            if len(found) >= most:
                raise _asked(source, reading.met[place])
            other = _reading(source, tokens, table, read, (*reading.script[:place], True))
            found.append(other)
            waiting.append((other, place + 1))
    return found


def _asked(source: Source, question: Question) -> RbpsymError:
    what, instead, token = question
    return source.error(what, token.start, token.end, instead)


def _parting(one: Reading, other: Reading) -> Question:
    """The question that the two readings answer differently."""
    pairs = zip(one.script, other.script, strict=False)
    place = next((k for k, (a, b) in enumerate(pairs) if a != b), 0)
    return one.met[place]
