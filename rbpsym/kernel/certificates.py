"""Certificates: how a claim follows from others, neutral of any prover; and by which multiples of known equations.

Elimination keeps account of the multiples. Nothing here has to be believed: the kernel multiplies out. Sines and cosines
are letters ("sin theta"), so that nothing is replaced by sin² + cos² = 1 without an account of it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, atoms
from rbpsym.frozen import Frozen, field
from rbpsym.kernel.claim import Proposition, sides


class KnownEquation(Frozen):
    """An equation that may be used: by its name, at the time `when` ("t" or "0"); `by`: what shows that `claim.given` holds."""

    name: str
    claim: Proposition
    when: str = "t"
    by: tuple[str, ...] = ()

    @property
    def is_free(self) -> bool:
        """Whether it holds at all times."""
        return not any(name[0] == "g" and name[1:].isdigit() for name in (self.name, *self.by))


class Multiples(Frozen):
    """left - right = Σ factor × (left - right of a known equation) + Σ factor × (sin² + cos² - 1 of an angle)."""

    known: tuple[tuple[t.Node, KnownEquation], ...] = ()
    circles: tuple[tuple[t.Node, t.Node], ...] = ()


class Have(Frozen):
    """A claim on the way. how: "still" (the rate of what vanishes), "flat" (no rate, and 0 at the start), "course" (it and its
    rate, what `inner` is of, are rates of each other by constant `parts`, and 0 at the start), "integral",
    "sum" (sine and cosine of a sum of angles), "sign" and "gap" (a sine, a difference that ranges keep positive), "nonzero"
    and "positive" (± left is a positive formula and one that is not negative).

    multiples: for "still" those that show what vanishes (`of`), for "flat" and "course" those that show what its rate is, and
    `begin` that it is 0 at the start; source: the premises that it rests on; parts: the two formulas of "nonzero", the
    integrand without roots of "integral".
    """

    name: str
    how: str
    claim: Proposition
    of: t.Node = t.ZERO
    multiples: Multiples = field(default_factory=Multiples)
    begin: Multiples = field(default_factory=Multiples)
    source: str = ""
    inner: Have | None = None
    parts: tuple[t.Node, ...] = ()

    @property
    def accounts(self) -> tuple[Multiples, ...]:
        """All multiples of known equations by which it is shown."""
        return (self.multiples, self.begin, *(self.inner.accounts if self.inner else ()))


class Proof(Frozen):
    """What is shown on the way, then the claim.

    like: for a rate, the formula that is derived, and why it is the same; factor: what is divided by; parts: what is
    positive and what is not negative, of which left - right is the sum.
    """

    steps: tuple[Have, ...] = ()
    multiples: Multiples = field(default_factory=Multiples)
    like: tuple[t.Node, Multiples] | None = None
    factor: t.Node | None = None
    parts: tuple[t.Node, ...] = ()


class Lemma(Frozen):
    """A claim, the premises that its proof names, and the proof."""

    name: str
    claim: Proposition
    premises: Mapping[str, Proposition]
    proof: Proof


Sums = dict[int, Scalar]  # how often each of the known equations is in one


class CertifiedRow(Frozen):
    """A value, and what it is: the goal (or nothing) and Σ multiples × known values."""

    value: Scalar
    multiples: Sums

    def less(self, factor: Scalar, other: CertifiedRow) -> CertifiedRow:
        """The row less a multiple of another; sin² is replaced by 1 - cos² on the way."""
        sums = dict(self.multiples)
        for key, part in other.multiples.items():
            sums[key] = sums.get(key, NOTHING) - factor * part
        return CertifiedRow(wound(self.value - factor * other.value), sums)


class AtomPivot(Frozen):
    """An atom to a power, which a row gives, and its coefficient there."""

    atom: int
    power: int
    slope: Scalar
    row: CertifiedRow

    def cleared(self, row: CertifiedRow) -> CertifiedRow:
        """The row without the pivot."""
        while (top := max(_powers(row.value, self.atom), default=0)) >= self.power:
            head = Scalar(row.value.num.by_power(self.atom)[top], row.value.den)
            row = row.less(head * Scalar(Poly({((self.atom, 1),): 1})) ** (top - self.power) / self.slope, self.row)
        return row


def _powers(value: Scalar, index: int) -> list[int]:
    return [] if index in value.den.atoms() else [power for power in value.num.by_power(index) if power]


def reduced(
    goal: Scalar, known: Sequence[Scalar], order: Callable[[int], int], is_nonzero: Callable[[Scalar], bool]
) -> tuple[Scalar, Sums, list[CertifiedRow]]:
    """What is left of the goal, the multiples that were put to it, and the equations, as they were
    when each was used or left.

    order: the higher, the sooner an atom is replaced; 0 for one that is not.
    """
    rows = [CertifiedRow(wound(value), {place: UNITY}) for place, value in enumerate(known)]
    end, used = CertifiedRow(wound(goal), {}), []
    while pivots := sorted(_pivots(rows, order, is_nonzero), key=lambda p: (-order(p.atom), len(p.slope.num), p.power)):
        pivot = pivots[0]
        rows, end = [pivot.cleared(row) for row in rows if row is not pivot.row], pivot.cleared(end)
        used.append(pivot)
    return end.value, end.multiples, [row for row in (*rows, *(pivot.row for pivot in used)) if row.value]


def _pivots(rows: list[CertifiedRow], order: Callable[[int], int], is_nonzero: Callable[[Scalar], bool]) -> Iterator[AtomPivot]:
    for row in rows:
        for index in row.value.num.atoms():
            powers = _powers(row.value, index)
            if order(index) and len(powers) == 1 and powers[0] > 0:
                slope = Scalar(row.value.num.by_power(index)[powers[0]], row.value.den)
                if is_nonzero(slope):
                    yield AtomPivot(index, powers[0], slope, row)


def parted(value: Scalar) -> tuple[Scalar, Scalar]:
    """The product of atoms that stands in each term of a value, and what it is a multiple of."""
    common = value.num.content()[1]
    return Scalar(Poly({common: 1})), value / Scalar(Poly({common: 1}))


def partner(index: int, kind: str = "sin") -> int | None:
    """The cosine's letter of a sine's (or the other way round); None for what is no sine."""
    name, other = atoms.symbol_name(index) or "", {"sin": "cos", "cos": "sin"}[kind]
    return atoms.intern("symbol", other + name[3:]) if name.startswith(f"{kind} ") else None


def circles(
    rest: Scalar, kind: str = "sin", only: Collection[int] | None = None, *, lifted: bool = False
) -> tuple[dict[int, Scalar], Scalar]:
    """By how much of sin² + cos² - 1 of each angle (by the index of its sine) a value differs from 0, and what stays.

    `only`: the sines (or cosines) whose squares are taken out; all by default. `lifted`: negative powers of sines and
    cosines are multiplied away first, for a value that is to vanish.
    """
    found: dict[int, Scalar] = {}
    num, den = _lifted(rest) if lifted else (rest.num, Scalar(rest.den))
    for index in sorted(num.atoms()):
        if (other := partner(index, kind)) is None or (only is not None and index not in only):
            continue
        square, total = Poly({((other, 2),): 1}), NOTHING
        while (top := max(num.by_power(index), default=0)) > 1:
            head = num.by_power(index)[top] * Poly({((index, top - 2),) if top > 2 else (): 1})
            total = total + Scalar(head)
            num = num - head * (Poly({((index, 2),): 1}) + square - Poly({(): 1}))
        if total:
            found[index] = total / den
    return found, Scalar(num) / den


def _lifted(value: Scalar) -> tuple[Poly, Scalar]:
    """A numerator without negative powers of sines and cosines, and the denominator."""
    low = {i: e for i, e in value.num.content()[1] if e < 0 and (partner(i) is not None or partner(i, "cos") is not None)}
    shift = tuple(sorted((i, -e) for i, e in low.items()))
    return (value.num.scaled(1, shift), Scalar(value.den) * Scalar(Poly({shift: 1}))) if low else (value.num, Scalar(value.den))


def wound(value: Scalar, kind: str = "sin", only: Collection[int] | None = None) -> Scalar:
    """The value with sin² replaced by 1 - cos²."""
    return circles(value, kind, only)[1]


def vanishes(value: Scalar) -> bool:
    """Whether it is 0 by sin² + cos² = 1."""
    return not wound(value)


# --- formulas that are written out


def _multiplied(multiples: Multiples) -> Iterator[t.Node]:
    for factor, known in multiples.known:
        yield from (factor, *sides(known.claim))
    yield from (factor for factor, _ in multiples.circles)


def formulas(proof: Proof) -> Iterator[t.Node]:
    """All that is written out in a proof."""
    yield from _multiplied(proof.multiples)
    if proof.like:
        yield proof.like[0]
        yield from _multiplied(proof.like[1])
    yield from (node for node in (proof.factor, *proof.parts) if node is not None)
    for have in proof.steps:
        if have.how not in ("sign", "gap"):
            yield from (have.of, *sides(have.claim), *(node for by in have.accounts for node in _multiplied(by)))
