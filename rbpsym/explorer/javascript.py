"""Scalars as JavaScript: straight-line code in which each sine, root and intermediate quantity is computed once.

The code is printed from the exact values of the derivation; nothing is rounded before the browser
divides the integers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from rbpsym.errors import StatementError
from rbpsym.field import ONE, Poly, Scalar, atoms
from rbpsym.field.poly import Monomial

FUNCTIONS = {"root": "sqrt", "ln": "log", **{name: name for name in ("cos", "sin", "exp", "atan", "asin", "acos")}}
LARGEST_EXACT = 2**53


class Program:
    """A JavaScript function body in the making: inputs by name, definitions used when they are needed, outputs.

    `inputs` maps a name to the JavaScript expression that holds it ("x[0]"); `defined` maps further
    names to their values; `solved` maps names to (text of a vector, place in it), see `solve_for`.
    """

    def __init__(self, inputs: Mapping[str, str], defined: Mapping[str, Scalar]) -> None:
        self.inputs, self.defined = inputs, dict(defined)
        self.lines: list[str] = []
        self._known: dict[int, str] = {atoms.PI: "Math.PI"}
        self._outputs: dict[Scalar, int] = {}
        self._texts: list[str] = []
        self._solvers: dict[str, Callable[[], None]] = {}

    def solve_for(self, names: tuple[str, ...], matrix: Iterable[Iterable[Scalar]], right: Iterable[Scalar]) -> None:
        """Let the browser solve matrix · names = right, if one of the names is needed."""
        rows, sides = [list(row) for row in matrix], list(right)

        def write() -> None:
            table = ",".join(f"[{','.join(map(self.value, row))}]" for row in rows)
            vector = self._let(f"solve([{table}],[{','.join(map(self.value, sides))}])")
            self._known |= {atoms.intern("symbol", name): f"{vector}[{k}]" for k, name in enumerate(names)}

        self._solvers |= dict.fromkeys(names, write)

    def knows(self, name: str) -> bool:
        """Can it tell the value of a name?"""
        return name in self.inputs or name in self.defined or name in self._solvers

    def output(self, value: Scalar) -> int:
        """The place of a value among the numbers that the function returns."""
        if value not in self._outputs:
            self._outputs[value] = len(self._texts)
            self._texts.append(self.value(value))
        return self._outputs[value]

    def output_again(self, value: Scalar) -> int:
        """The same, each time at a place of its own."""
        self._texts.append(self.value(value))
        return len(self._texts) - 1

    @property
    def text(self) -> str:
        """The body of the function."""
        return "\n".join([*self.lines, f"return [{','.join(self._texts)}];"])

    def value(self, value: Scalar) -> str:
        """An expression for a scalar; what it needs is computed before."""
        top = self._sum(value.num)
        return top if value.den is ONE else f"({top})/({self._sum(value.den)})"

    def _sum(self, poly: Poly) -> str:
        text = ""
        for monomial, coefficient in poly.terms.items():
            term = self._term(monomial, coefficient)
            text += term if term.startswith("-") or not text else f"+{term}"
        return text or "0"

    def _term(self, monomial: Monomial, coefficient: int | Fraction) -> str:
        ratio = Fraction(coefficient)
        above = [self._power(index, e) for index, e in monomial if e > 0]
        below = [self._power(index, -e) for index, e in monomial if e < 0]
        above += [whole(abs(ratio.numerator))] if abs(ratio.numerator) != 1 or not above else []
        below += [whole(ratio.denominator)] if ratio.denominator != 1 else []
        sign = "-" if ratio < 0 else ""
        under = "*".join(below)
        return (
            sign + "*".join(above) + (f"/({under})" if len(below) > 1 or "*" in under else f"/{under}" if below else "")
        )

    def _power(self, index: int, exponent: int) -> str:
        base = self._atom(index)
        return "*".join([base] * exponent) if exponent < 4 else f"Math.pow({base},{exponent})"

    def _atom(self, index: int) -> str:
        if index not in self._known:
            found = atoms.atom(index)
            if found.kind == "symbol":
                self._symbol(index, found.arg)
            else:
                self._known[index] = self._let(self._call(found))
        return self._known[index]

    def _symbol(self, index: int, name: str) -> None:
        if name in self.inputs:
            self._known[index] = self.inputs[name]
        elif name in self.defined:
            self._known[index] = self._let(self.value(self.defined[name]))
        elif name in self._solvers:
            self._solvers[name]()
        else:
            raise StatementError(
                f"the explorer has no number for “{name}”", instead="declare it in the problem, or give it a start."
            )

    def _call(self, found: atoms.Atom) -> str:
        if found.kind not in FUNCTIONS:
            what = "no form of a result of this problem was found that a browser can compute"
            raise StatementError(what, instead="write its notes instead: rbpsym notes.")
        inner = self.value(found.arg) if isinstance(found.arg, Scalar) else self._sum(found.arg)
        return f"Math.{FUNCTIONS[found.kind]}({inner})"

    def _let(self, text: str) -> str:
        name = f"a{len(self.lines)}"
        self.lines.append(f"const {name}={text};")
        return name


def whole(number: int) -> str:
    """An integer as JavaScript writes it; one beyond 2⁵³ as the nearest double."""
    return str(number) if number <= LARGEST_EXACT else repr(float(number))


def function(arguments: str, body: str) -> str:
    """An anonymous function."""
    return f"function({arguments}){{\n{body}\n}}"
