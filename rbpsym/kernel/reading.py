"""A reader of the Rocq terms that we write, of its own: what it reads is compared with the tree that was to be written."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, Walker, field, replace
from rbpsym.kernel.claim import TIME, Proposition
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import START
from rbpsym.kernel.rocq import identifier

TOKEN = re.compile(r"\s*(:=|=>|<>|->|[A-Za-z_][\w']*|\d+|[-+*/^()<>=:,])")
Read = tuple[Any, ...]


class Reader(Walker):
    """Reads one proposition or term by descent, by Rocq's precedences, into nested tuples."""

    words: list[str]
    place: int = 0
    bound: dict[str, str] = field(default_factory=dict)
    depth: int = 0

    def next(self) -> str:
        """The next word, or an empty one."""
        return self.words[self.place] if self.place < len(self.words) else ""

    def take(self, word: str = "") -> str:
        """The next word, which has to be this one if one is named."""
        found = self.next()
        if not found or (word and found != word):
            raise RbpsymError(f"what was written can't be read back at “{' '.join(self.words[self.place : self.place + 6])}”")
        self.place += 1
        return found

    def sum(self) -> Read:
        """Terms between + and -."""
        found = self.product()
        while self.next() in ("+", "-"):
            found = (self.take(), found, self.product())
        return found

    def product(self) -> Read:
        """Factors between * and /, each perhaps with a sign."""
        found = self.signed()
        while self.next() in ("*", "/"):
            found = (self.take(), found, self.signed())
        return found

    def signed(self) -> Read:
        """- x, / x, or a power."""
        if self.next() in ("-", "/"):
            return (f"{self.take()}1", self.signed())
        base = self.applied()
        return (self.take("^"), base, self.applied()) if self.next() == "^" else base

    def applied(self) -> Read:
        """A function with what it is applied to."""
        head, parts = self.atom(), []
        while self.next() == "(" or re.match(r"[\w]", self.next()):
            parts.append(self.atom())
        return ("of", head, *parts) if parts else head

    def atom(self) -> Read:
        """A number, a letter, a function of a bound letter, or what stands in brackets."""
        if self.next() != "(":
            word = self.take()
            return ("number", int(word)) if word.isdigit() else ("letter", self.bound.get(word, word))
        self.take("(")
        found = self.function() if self.next() == "fun" else self.sum()
        self.take(")")
        return found

    def function(self) -> Read:
        """fun x : R => body, in which x is called by its depth."""
        self.take("fun")
        name, kept = self.take(), dict(self.bound)
        self.take(":")
        self.take("particle" if self.next() == "particle" else "R")
        self.take("=>")
        self.bound[name], self.depth = f"#{self.depth}", self.depth + 1
        body = self.function() if self.next() == "fun" else self.sum()
        self.bound, self.depth = kept, self.depth - 1
        return ("fun", body)


def read(text: str) -> Read:
    """What a written term says."""
    words = TOKEN.findall(text)
    if "".join(words) != re.sub(r"\s", "", text):
        raise RbpsymError("there is a sign in what was written that no term has")
    reader = Reader(words)
    found = reader.sum()
    if reader.next():
        raise RbpsymError(f"what was written goes on after its end: “{reader.next()}”")
    return found


def proposition(text: str) -> tuple[Read, ...]:
    """What a written proposition says: the conditions in order, then the conclusion."""
    parts = [part.strip() for part in text.split(" -> ")]
    head = ("always",) if parts[0] == "forall t : R, ta < t < tb" else None
    return (*([head] if head else []), *map(_relation, parts[1 if head else 0 :]))


def _relation(text: str) -> Read:
    op = next((op for op in (" <> ", " <= ", " < ", " = ") if op in text), "")
    return (op.strip(), *map(read, text.split(op))) if op else read(text)


# --- what is to be read


class Meant(Frozen):
    """What a claim is to be read as, from its trees. `time`: the moment; `bound`: what integrals and slopes bind, by the
    `depth` at which they do."""

    source: ClaimSource
    time: Read = ("letter", "t")
    bound: Mapping[str, Read] = field(default_factory=dict)
    depth: int = 0

    def claim(self, claim: Proposition) -> tuple[Read, ...]:
        """The claim with what it is made of."""
        if claim.kind == "start":
            return (replace(self, time=ZERO).relation(claim),)
        if claim.kind == "slope":
            return (self.slope(claim),)
        return (("always",), *map(self.relation, claim.given), self.relation(claim))

    def slope(self, claim: Proposition) -> Read:
        """A derivative at a place."""
        inner = replace(self, bound={claim.var: ("letter", "#0")}, depth=1)
        return ("of", DERIVED, ("fun", inner.of(claim.left)), self.of(claim.place), self.of(claim.right))

    def relation(self, claim: Proposition) -> Read:
        """A relation between two sides."""
        left, right = self.of(claim.left), self.of(claim.right)
        if claim.kind == "rate":
            inner = replace(self, time=("letter", "#0"), depth=1).of(claim.left)
            return ("of", DERIVED, ("fun", inner), self.time, right)
        if claim.kind in ("more", "least"):
            return ("<" if claim.kind == "more" else "<=", right, left)
        return ("<>" if claim.kind == "differ" else "=", left, right)

    def of(self, node: t.Node) -> Read:
        """A tree."""
        if isinstance(node, t.Add | t.Mul):
            op, parts = ("+", node.terms) if isinstance(node, t.Add) else ("*", node.factors)
            return reduce(lambda found, part: (op, found, self.of(part)), parts[1:], self.of(parts[0]))
        if isinstance(node, t.Num):
            top, below = abs(Fraction(node.value).numerator), Fraction(node.value).denominator
            whole: Read = ("-1", ("number", top)) if node.value < 0 else ("number", top)
            return whole if below == 1 else ("/", whole, ("number", below))
        if isinstance(node, t.Integral):
            return self.integral(node)
        if isinstance(node, t.Fn) and node.name in ("tan", "cot", "sec", "csc"):
            over, under = {"tan": ("sin", "cos"), "cot": ("cos", "sin"), "sec": ("", "cos"), "csc": ("", "sin")}[node.name]
            divisor = ("of", ("letter", under), self.of(node.arg))
            return ("/", ("of", ("letter", over), self.of(node.arg)), divisor) if over else ("/1", divisor)
        return SHAPES[type(node)](self, node)

    def letter(self, node: t.Sym) -> Read:
        """A constant, a function at the moment or at the start, what is bound."""
        name = node.name
        if name in self.bound:
            return self.bound[name]
        if name.endswith(START):
            return replace(self, time=ZERO).letter(t.Sym(name.removesuffix(START)))
        if name == TIME:
            return self.time
        if name in self.source.integrals:
            return self.integral(self.source.integrals[name])
        word = ("letter", "PI" if name == "pi" else identifier(name))
        return ("of", word, self.time) if self.source.moving(name) else word

    def power(self, node: t.Pow) -> Read:
        """A whole power; below if it is negative."""
        exponent = int(node.exponent.value) if isinstance(node.exponent, t.Num) else 0
        found = ("^", self.of(node.base), ("number", abs(exponent)))
        return found if exponent >= 0 else ("/1", found)

    def integral(self, node: t.Integral) -> Read:
        """Over the time, or over what is bound; along the time where other functions of time stand in it."""
        own = ("letter", f"#{self.depth}")
        if any(map(self.source.moving, t.names(node.integrand) - {node.var})) or node.var == TIME:
            speed = None if node.var == TIME else t.Sym(f"{node.var}_dot")
            body = node.integrand if speed is None else t.Mul((node.integrand, speed))
            inner = replace(self, time=own, depth=self.depth + 1).of(body)
            ends = (self.of(node.lower), self.of(node.upper)) if speed is None else (ZERO, self.time)
            return ("of", ("letter", "RInt"), ("fun", inner), *ends)
        inner = replace(self, bound={**self.bound, node.var: own}, depth=self.depth + 1).of(node.integrand)
        return ("of", ("letter", "RInt"), ("fun", inner), self.of(node.lower), self.of(node.upper))


ZERO: Read = ("number", 0)
DERIVED: Read = ("letter", "is_derive")
SHAPES: dict[type, Callable[[Meant, Any], Read]] = {
    t.Sym: Meant.letter, t.Pow: Meant.power, t.Group: lambda meant, node: meant.of(node.arg),
    t.Neg: lambda meant, node: ("-1", meant.of(node.arg)),
    t.Div: lambda meant, node: ("/", meant.of(node.num), meant.of(node.den)),
    t.Sqrt: lambda meant, node: ("of", ("letter", "sqrt"), meant.of(node.arg)),
    t.Fn: lambda meant, node: ("of", ("letter", node.name), meant.of(node.arg)),
}  # fmt: skip


def read_back(text: str, claim: Proposition, source: ClaimSource) -> str:
    """The proposition, if it reads as the claim. Raises RbpsymError if it does not."""
    if proposition(text) != Meant(source).claim(claim):
        raise RbpsymError("what was written does not read as what was meant")
    return text
