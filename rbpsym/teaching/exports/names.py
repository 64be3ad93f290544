"""Formulas in the infix of other programs (Maxima, sympy), with names that these can read."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Mapping

from rbpsym.expr import tree as t
from rbpsym.statement.model import Problem
from rbpsym.typeset.machine import to_machine

# names that mean something in Maxima or sympy
_WORDS = ("beta", "gamma", "zeta", "psi", "lambda", "e", "i", "pi", "I", "E", "S", "N", "O", "Q", "C", "D")
_CALLS = ("diff", "integrate", "ev", "at", "del")
RESERVED = frozenset({*keyword.kwlist, *_WORDS, *_CALLS})


def exported_names(names: Iterable[str], problem: Problem, reserved: Iterable[str] = ()) -> dict[str, str]:
    """Our name -> the name to type there: as the problem prints it (omega for theta_dot), if that is free."""
    taken: dict[str, str] = {}
    for name in sorted(set(names) - {"pi"}):
        shown = problem.notation.get(name, name)
        shown = shown if re.fullmatch(r"[A-Za-z]\w*", shown) and shown not in taken.values() else name
        taken[name] = f"{shown}_" if shown in set(reserved) else shown
    return taken


def maxima(node: t.Node, names: Mapping[str, str]) -> str:
    """A formula for Maxima."""
    return re.sub(r"\bpi\b", "%pi", sympy_text(node, names).replace("**", "^"))


def sympy_text(node: t.Node, names: Mapping[str, str]) -> str:
    """A formula for sympy, as text that is data there."""
    return to_machine(t.renamed(node, {name: t.Sym(typed) for name, typed in names.items()}))
