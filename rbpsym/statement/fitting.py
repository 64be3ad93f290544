"""The dimension of a coordinate that says none: an angle, or a length where the statement fits only so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from itertools import product
from typing import Any

from rbpsym.decide.dimensions import Dimensions, require_dimension
from rbpsym.errors import DimensionError, RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Node
from rbpsym.quantities import LENGTH, NUMBER, TIME, Dimension

MOST = 6  # coordinates that say none
TIMES = {"start": NUMBER, "speed": TIME, "acceleration": TIME**2}  # by which a value of the coordinate is multiplied


def fitting(data: Mapping[str, Any], known: Dimensions, unsaid: list[str]) -> dict[str, Dimension]:
    """The first choice of angles and lengths in which places are lengths, angles are numbers, and starts fit; angles, if none."""
    angles = dict.fromkeys(unsaid, NUMBER)
    known = {"t": TIME, **known}
    stated = [*_stated(data, {**known, **angles})] if 0 < len(unsaid) <= MOST else []
    for choice in product((NUMBER, LENGTH), repeat=len(unsaid)) if stated else ():
        chosen = dict(zip(unsaid, choice, strict=True))
        if all(_fits(node, {**known, **chosen}, wanted, times) for node, wanted, times in stated):
            return chosen
    return angles


def _fits(node: Node, dimensions: Dimensions, wanted: Dimension | str, times: Dimension) -> bool:
    try:
        require_dimension(node, dimensions, dimensions[wanted] / times if isinstance(wanted, str) else wanted, "it")
    except DimensionError:
        return False
    return True


def _stated(data: Mapping[str, Any], known: Dimensions) -> Iterator[tuple[Node, Dimension | str, Dimension]]:
    """Formulas with the dimension that they must have: one of its own, or that of a coordinate over what it is taken times."""
    texts = [(text, LENGTH, NUMBER) for body in _tables(data, "bodies") for place in _places(body) for text in place]
    texts += [(body.get("angle"), NUMBER, NUMBER) for body in _tables(data, "bodies")]
    for name, table in (data.get("coordinates") or {}).items():
        if isinstance(table, Mapping) and name in known:
            texts += [(table.get(key), name, times) for key, times in TIMES.items()]
            texts += [(text, name, NUMBER) for text in _listed(table.get("range"))]
    for text, wanted, times in texts:
        with suppress(RbpsymError):  # what can't be read is told where it is read
            if isinstance(text, str) and text:
                yield read_infix(text, known), wanted, times


def _tables(data: Mapping[str, Any], section: str) -> list[Mapping[str, Any]]:
    found = data.get(section)
    return [table for table in found.values() if isinstance(table, Mapping)] if isinstance(found, Mapping) else []


def _places(body: Mapping[str, Any]) -> Iterator[list[Any]]:
    """All pairs of a body's table: its centre, or its start, or a point of it."""
    for value in body.values():
        if isinstance(value, Mapping):
            yield from _places(value)
        elif len(pair := _listed(value)) == 2:
            yield pair


def _listed(value: Any) -> list[Any]:
    return list(value) if isinstance(value, (list, tuple)) else []
