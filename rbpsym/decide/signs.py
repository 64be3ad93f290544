"""Signs of formulas, with a certificate: from signs, ranges, squares, discriminants and bounds.

What is known of a sign is the set of values it may have (a bit mask of -, 0, +). Every rule
is exact; "don't know" is the full set. A polynomial on a box is shown to have one sign by its
Bernstein coefficients in one generator, which are polynomials in the others.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from rbpsym.decide import bounds as b
from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.decide.factoring import ANY, DECIDED, MINUS, NAMES, NONZERO, PLUS, PLUS_ZERO, flip, power, times
from rbpsym.decide.samples import MANY, Samples, samples_of
from rbpsym.decide.sign_rules import QUICK, RULES, Rule
from rbpsym.errors import LimitError, Undecided
from rbpsym.field import ONE, Monomial, Poly, Scalar, apart, at_most, atoms, remembered
from rbpsym.frozen import Frozen, Walker, field

MOST_STUDIES, FEW_STUDIES = 600, 150
DEEPEST = 40
MOST_PRODUCTS = 20_000  # of terms, for one question
LONG = 2000  # a polynomial of √LONG terms costs as much as two short ones


class SignResult(Frozen):
    """mask: the signs that the value may have (see `masks`)."""

    mask: int
    certificate: str = ""

    @property
    def kind(self) -> str | None:
        """"positive", "negative", "zero", "nonnegative", "nonpositive", "nonzero" or None."""
        return NAMES[self.mask]

    @property
    def is_nonzero(self) -> bool:
        """Whether the value is surely not zero."""
        return self.kind in ("positive", "negative", "nonzero")

    @property
    def is_nonnegative(self) -> bool:
        """Whether the value is surely not negative."""
        return self.kind in ("positive", "zero", "nonnegative")

    @property
    def sense(self) -> int:
        """1 of what is surely not negative, -1 of what is surely not positive, else 0."""
        return {"positive": 1, "nonnegative": 1, "negative": -1, "nonpositive": -1}.get(self.kind or "", 0)


def sign(value: Scalar, assumptions: Assumptions = NONE, *, factoring: bool = True) -> SignResult:
    """The sign of a value for all quantities that satisfy the assumptions.

    `factoring` lets what is not decided by its form be factored. The question has an effort of its own, so that
    the answer depends on nothing else.
    """
    return _sign(value, assumptions, factoring)


@remembered
def _sign(value: Scalar, assumptions: Assumptions, factoring: bool) -> SignResult:
    study = SignStudy(assumptions, factoring)
    try:
        with apart(), at_most(MOST_PRODUCTS):
            if value.den is ONE and study.samples.has_both_signs(value.num, MANY):
                study.left = 0
            mask = study.scalar(value)
    except (LimitError, Undecided, ZeroDivisionError) as error:
        return SignResult(ANY, str(error))
    return SignResult(mask, study.reasons.get(value.num, "") if NAMES[mask] else "")


class SignStudy(Walker):
    """One question about a sign: what has been found so far, and how much may still be tried."""

    assumptions: Assumptions
    factoring: bool = True
    own: bool = False  # what is known of generators is found here too, and not looked up
    found: dict[Poly, int] = field(default_factory=dict)
    reasons: dict[Poly, str] = field(default_factory=dict)
    limits: dict[int, b.Bounds] = field(default_factory=dict)
    depth: int = 0  # how many questions wait for this one: bounds may name each other
    left: int = field(init=False)
    samples: Samples = field(init=False)

    def __post_init__(self) -> None:
        self.left = MOST_STUDIES if self.factoring else FEW_STUDIES
        self.samples = samples_of(self.assumptions)
        for value, may_vanish in self.assumptions.known:
            mask = (PLUS_ZERO if may_vanish else PLUS) & self.found.get(value.num, ANY)
            self.found |= {value.num: mask, -value.num: flip(mask)}

    def scalar(self, value: Scalar) -> int:
        """What sign a value may have."""
        above = self.poly(value.num)
        return above if value.den is ONE else times(above, power(self.poly(value.den), -1))

    def poly(self, poly: Poly) -> int:
        """What sign a polynomial may have."""
        if poly in self.found:
            return self.found[poly]
        self.found[poly], self.left, self.depth = ANY, self.left - 1 - len(poly) ** 2 // LONG, self.depth + 1
        mask = self._narrowed(poly, ANY, QUICK)
        if mask not in DECIDED and self.left > 0 and self.depth < DEEPEST and not self.samples.has_both_signs(poly):
            mask = self._narrowed(poly, mask, RULES)
        self.depth -= 1
        self.found[poly] = mask
        return mask

    def _narrowed(self, poly: Poly, mask: int, rules: tuple[Rule, ...]) -> int:
        for rule, reason in rules:
            try:
                found = rule(self, poly)
            except LimitError:  # what is known already stays so
                if mask == ANY:
                    raise
                break
            if found & mask != mask:
                mask &= found
                self.reasons[poly] = reason
            if mask in DECIDED:
                break
        return mask

    def monomial(self, m: Monomial) -> int:
        """What sign a product of generators may have."""
        mask = PLUS
        for index, exponent in m:
            mask = times(mask, power(self.atom(index), exponent))
        return mask

    def atom(self, index: int) -> int:
        """What sign a generator may have."""
        if not self.own:
            return _known(index, self.assumptions)[0]
        found = atoms.atom(index)
        mask = ATOMS[found.kind](self, found.arg) if found.kind in ATOMS else ANY
        limits = self.bounds(index)
        if limits.lower is not None:
            mask &= _above(self.scalar(limits.lower), limits.lower_in)
        if limits.upper is not None:
            mask &= flip(_above(flip(self.scalar(limits.upper)), limits.upper_in))
        return mask

    def bounds(self, index: int) -> b.Bounds:
        """Between what a generator lies."""
        if not self.own:
            return _known(index, self.assumptions)[1]
        if index not in self.limits:
            self.limits[index] = b.NO_BOUNDS
            found = atoms.atom(index)
            factoring, self.factoring = self.factoring, False
            if found.kind in BOUNDS:
                self.limits[index] = BOUNDS[found.kind](self, found.arg)
            self.factoring = factoring
        return self.limits[index]

    def is_nonnegative(self, value: Scalar) -> bool:
        """Whether a value is surely ≥ 0."""
        return not self.scalar(value) & MINUS


@lru_cache(maxsize=8192)
def _known(index: int, assumptions: Assumptions) -> tuple[int, b.Bounds]:
    """Sign and bounds of a generator, in a study of its own: all questions share what is found."""
    study = SignStudy(assumptions, own=True)
    return study.atom(index), study.bounds(index)


def _above(end: int, reached: bool) -> int:
    """Signs of what is greater than (or equal to) something of the given sign."""
    if end & MINUS:
        return ANY
    return end | PLUS if reached else PLUS


SYMBOL_SIGNS = {"positive": PLUS, "nonnegative": PLUS_ZERO, "nonzero": NONZERO, "real": ANY}

ATOMS: dict[str, Callable[[SignStudy, Any], int]] = {
    "symbol": lambda study, name: PLUS if name == "pi" else SYMBOL_SIGNS[study.assumptions.sign_of(name)],
    "root": lambda study, arg: PLUS if study.scalar(arg) == PLUS else PLUS_ZERO,
    "exp": lambda study, arg: PLUS,
    "ln": lambda study, arg: study.scalar(arg - 1),
    "atan": lambda study, arg: study.scalar(arg),
    "asin": lambda study, arg: study.scalar(arg),
    "acos": lambda study, arg: PLUS_ZERO,
    "elliptic_k": lambda study, arg: PLUS,
    "elliptic_e": lambda study, arg: PLUS,
}


BOUNDS: dict[str, Callable[[SignStudy, Any], b.Bounds]] = {
    "symbol": lambda study, name: b.of_symbol(name, study.assumptions),
    "cos": lambda study, angle: b.of_wave("cos", angle, study.assumptions, study.is_nonnegative),
    "sin": lambda study, angle: b.of_wave("sin", angle, study.assumptions, study.is_nonnegative),
    "half": lambda study, angle: b.of_half_tangent(angle, study.assumptions, study.is_nonnegative),
    "exp": lambda study, arg: b.of_exponential(study.scalar(arg)),
    "atan": lambda study, arg: b.of_inverse("atan", study.scalar(arg)),
    "asin": lambda study, arg: b.of_inverse("asin", study.scalar(arg)),
    "acos": lambda study, arg: b.of_inverse("acos", study.scalar(arg)),
}
