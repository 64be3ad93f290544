"""Display trees as Rocq terms over the reals."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from rbpsym.errors import RbpsymError
from rbpsym.kernel.components import START
from rbpsym.notation import tree as t

RESERVED = frozenset((
    "R", "t", "u", "x", "y", "E", "sin", "cos", "sqrt", "PI", "RInt", "is_derive", "continuous", "trig", "less", "ta", "tb",
    "as", "at", "cofix", "else", "end", "exists", "fix", "for", "forall", "fun", "if", "in", "let", "match", "mod", "return",
    "then", "using", "where", "with", "Begin", "Prop", "Set", "Type",
))  # fmt: skip


def identifier(name: str) -> str:
    """A name that Rocq reads as one word and that means nothing else there; different names stay different."""
    word = "".join(c if c.isalnum() or c == "_" else "'" for c in name)
    return f"{word}_" if word.rstrip("_") in RESERVED else word


def is_along_time(node: t.Integral, moving: Callable[[str], bool]) -> bool:
    """Whether other functions of time than the variable stand in an integral."""
    return any(moving(name) for name in t.names(node.integrand) - {node.var})


@dataclass(frozen=True)
class Terms:
    """How letters are written: `moving` are functions of time; `time` is the moment; `bound` what stands for others.

    `integrals`: the integral that a letter of ours stands for. `speeds`: the speed of each coordinate.
    """

    moving: Callable[[str], bool]
    speeds: Mapping[str, str]
    integrals: Mapping[str, t.Integral]
    time: str = "t"
    bound: Mapping[str, str] | None = None

    def at(self, time: str) -> Terms:
        """The same at another moment."""
        return replace(self, time=time)

    def term(self, node: t.Node) -> str:
        """The Rocq term of a scalar tree. Raises RbpsymError for a node that no term was found for."""
        if type(node) not in TERMS:
            raise RbpsymError(f"{type(node).__name__.lower()} has no term in Rocq")
        return TERMS[type(node)](self, node)

    def symbol(self, node: t.Sym) -> str:
        """A letter: a constant, a function at the moment or at the start, a bound variable."""
        name = node.name
        if self.bound and name in self.bound:
            return self.bound[name]
        if name.endswith(START):
            return self.at("0").symbol(t.Sym(name.removesuffix(START)))
        if name in self.integrals:
            return self.integral(self.integrals[name])
        return "PI" if name == "pi" else f"({identifier(name)} {self.time})" if self.moving(name) else identifier(name)

    def integral(self, node: t.Integral) -> str:
        """∫ over a coordinate: along time if other functions of time stand in it."""
        if is_along_time(node, self.moving) and node.var in self.speeds:
            integrand = replace(self, time="u").term(t.Mul((node.integrand, t.Sym(self.speeds[node.var]))))
            return f"(RInt (fun u : R => {integrand}) 0 {self.time})"
        inside = replace(self, bound={**(self.bound or {}), node.var: f"x{len(self.bound or {}) or ''}"})
        ends = f"{self.term(node.lower)} {self.term(node.upper)}"
        return f"(RInt (fun {inside.bound[node.var]} : R => {inside.term(node.integrand)}) {ends})"

    def power(self, node: t.Pow) -> str:
        """Powers with whole exponents."""
        exponent = getattr(node.exponent, "value", None)
        if exponent is None or Fraction(exponent).denominator != 1:
            raise RbpsymError("a power with such an exponent has no term in Rocq")
        inner = f"({self.term(node.base)} ^ {abs(exponent)})"
        return inner if exponent >= 0 else f"(/ {inner})"

    def function(self, node: t.Fn) -> str:
        """Sine and cosine."""
        if node.name not in ("sin", "cos"):
            raise RbpsymError(f"the function {node.name} has no term in Rocq")
        return f"({node.name} {self.term(node.arg)})"


def _number(terms: Terms, node: t.Num) -> str:
    value = Fraction(node.value)
    whole = str(value.numerator) if value >= 0 else f"(- {-value.numerator})"
    return whole if value.denominator == 1 else f"({whole} / {value.denominator})"


TERMS: dict[type, Callable[[Terms, Any], str]] = {
    t.Num: _number,
    t.Sym: Terms.symbol,
    t.Add: lambda terms, node: "(" + " + ".join(map(terms.term, node.terms)) + ")",
    t.Neg: lambda terms, node: f"(- {terms.term(node.arg)})",
    t.Mul: lambda terms, node: "(" + " * ".join(map(terms.term, node.factors)) + ")",
    t.Div: lambda terms, node: f"({terms.term(node.num)} / {terms.term(node.den)})",
    t.Pow: Terms.power,
    t.Fn: Terms.function,
    t.Group: lambda terms, node: terms.term(node.arg),
    t.Integral: Terms.integral,
}
