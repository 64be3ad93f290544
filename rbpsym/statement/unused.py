"""What is declared and used nowhere: no error, but worth a word."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass

from rbpsym.expr.tree import Node, Sym, walk
from rbpsym.statement.model import Problem

SAID = ("meanings", "names", "notation", "example", "text", "file")  # what is told of a name does not use it


def unused(problem: Problem) -> list[str]:
    """The parameters that no formula, question or claim of the statement holds, in the order of their declaration.

    >>> from rbpsym.statement.loader import load_problem
    >>> unused(load_problem("sliding-ladder"))
    []
    """
    used = set(_names([getattr(problem, part.name) for part in fields(problem) if part.name not in SAID]))
    return [quantity.name for quantity in problem.parameters if quantity.name not in used]


def _names(part: object) -> Iterator[str]:
    if isinstance(part, Node):
        yield from (node.name for node in walk(part) if isinstance(node, Sym))
    elif isinstance(part, str):
        yield from re.findall(r"\w+", part)
    elif isinstance(part, Mapping):
        yield from (name for pair in part.items() for item in pair for name in _names(item))
    elif isinstance(part, list | tuple):
        yield from (name for item in part for name in _names(item))
    elif is_dataclass(part):
        kept = (one.name for one in fields(part) if one.name not in ("name", "meaning"))
        yield from (name for key in kept for name in _names(getattr(part, key)))
