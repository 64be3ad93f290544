"""The search for certificates: multiples of equations, rates of what vanishes, antiderivatives, squares."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, atoms, names_in, rate_along, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.kernel import combining
from rbpsym.kernel.certificates import Have, KnownEquation, Multiples, Proof, circles, formulas, parted, reduced, vanishes
from rbpsym.kernel.claim import TIME, Proposition, brief, is_along_time, letter, sides, tree_of
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import START, started
from rbpsym.kernel.integrals import by_course, by_rates, courses, integrated
from rbpsym.kernel.positive import PositiveSum, is_plain
from rbpsym.kernel.radicals import more, rootless
from rbpsym.kernel.ranges import note_gaps, note_number, note_signs, signed, within
from rbpsym.typeset.machine import to_machine

SIGNS = ("sign", "gap", "positive")
BEGUN = t.Sym(TIME + START)
SLOPES: Mapping[str, Callable[[t.Node], t.Node]] = {
    "sin": lambda arg: t.Fn("cos", arg), "cos": lambda arg: t.Neg(t.Fn("sin", arg)),
    "exp": lambda arg: t.Fn("exp", arg), "ln": lambda arg: t.Div(t.ONE, arg),
}  # fmt: skip


class Search:
    """Looks for the proof of one claim from named claims.

    `declared`: those that are in force without being premises. `positive`: parameters above 0; `certain`: these, and what
    ranges keep above 0; `nonzero`: further letters that are not 0.
    """

    def __init__(self, source: ClaimSource, given: Mapping[str, Proposition], declared: Collection[str] = ()) -> None:
        self.source, self.given, self.declared = source, given, frozenset(declared)
        self.integrals = source.integrals
        self.met: list[t.Integral] = []
        self.roots: dict[str, Scalar] = {}  # what stands below the roots that are letters
        self.notes: dict[str, Have] = {}  # what is known whichever way is tried: of roots, of what stands below
        self.haves: list[Have] = []
        signs = source.study.assumptions.signs
        above = [name for name, sign in signs.items() if sign == "positive"]
        self.positive = {atoms.intern("symbol", name) for name in (*above, "pi")}
        self.always = frozenset(self.positive)
        self.fixed: set[str] = {*signs, *source.rates, TIME, "pi"} - {n for n in source.rates if n.endswith("_dot")}
        self.certain = set(self.positive)  # what may stand below
        self.nonzero = {atoms.intern("symbol", name) for name, sign in signs.items() if sign == "nonzero"}
        self.least = frozenset(atoms.intern("symbol", name) for name, sign in signs.items() if sign == "nonnegative")
        self.gaps: set[int] = set()
        self.met_by: tuple[Proposition, ...] = ()  # what the claim is given
        self.later: set[int] = set()  # positive only where that holds
        self.shifts: dict[str, list[Scalar]] = {}  # what a letter is, by the gap to an end of its range
        self.sums: dict[tuple[Poly, frozenset[int], bool], PositiveSum | None] = {}
        self.deep, self.wide = False, False  # whether squares are being shown; whether what takes longer is tried, too
        self.told: set[str] = set()  # sines and cosines that are put in terms of those of a sum
        self.is_sure = True  # whether nothing is divided by of which it is not known that it does not vanish
        self.ranks: dict[str, int] = {name: place for place, name in enumerate(source.ranked, 3)}
        self.rates = {TIME: UNITY}
        self.starts: dict[str, t.Node] = {TIME + START: t.ZERO}
        self.rates |= {name: self.value(tree_of(rate)) for name, rate in source.rates.items()}
        self.doubled: dict[str, Proposition] = {}  # rates of formulas, and of letters that have one already
        for claim in (claim for claim in given.values() if claim.kind == "start"):
            self.starts[letter(claim.left) + START] = claim.right
        for name, claim in given.items():
            if claim.kind == "rate" and isinstance(claim.left, t.Sym) and self._unrated(claim.left.name):
                self.rates[claim.left.name] = self.value(claim.right)
            elif claim.kind == "rate":
                self.doubled[name] = claim

    # --- values

    def value(self, node: t.Node) -> Scalar:
        """The value in letters; an integral is a letter of its own."""
        return scalar(self._lettered(node))

    def tree(self, value: Scalar) -> t.Node:
        """A value as a tree, sines and cosines as functions again."""
        return t.renamed(tree_of(value), self.source.circular)

    def _lettered(self, node: t.Node) -> t.Node:
        if isinstance(node, t.Fn):
            return self._turned(tree_of(scalar(node)))
        if isinstance(node, t.Sqrt):
            return self._rooted(node)
        if node == BEGUN:
            return t.ZERO
        if not isinstance(node, t.Integral):
            return t.mapped(node, self._lettered)
        name = next((n for n, known in self.integrals.items() if known == node), f"J_{len(self.integrals) + 1}")
        self.integrals[name] = node
        self.met.append(node)
        if (node.var in self.source.rates or node.var == TIME) and name not in self.rates:
            self.rates[name] = self.value(node.integrand) * self.rates[node.var]
            begun = self.starts.get(node.var + START)
            if is_along_time(node, self.moving) or begun == node.lower:
                self.starts[name + START] = t.ZERO
        return t.Sym(name)

    def _turned(self, node: t.Node) -> t.Node:
        """Sines and cosines of plain angles as letters; other functions, and roots that come of their sines, too."""
        if isinstance(node, t.Sqrt):
            return self._rooted(node)
        if not isinstance(node, t.Fn):
            return t.mapped(node, self._turned)
        angle = to_machine(node.arg)
        for kind in ("sin", "cos") if node.name in ("sin", "cos") else (node.name,):
            self.source.circular[f"{kind} {angle}"] = t.Fn(kind, node.arg)
        return t.Sym(f"{node.name} {angle}")

    def _rooted(self, node: t.Sqrt) -> t.Node:
        """A root as a letter."""
        value = self.value(node.arg)
        alike = (name for name, known in self.roots.items() if known == value or not combining.based(self, known - value))
        name = next(alike, f"root {to_machine(node.arg)}")
        self.source.circular.setdefault(name, node)
        if name not in self.roots:
            self.roots[name] = value
            note_number(self, node, value)
        return t.Sym(name)

    def moving(self, name: str) -> bool:
        """Whether a letter is a function of time."""
        if name in self.source.circular:
            return any(map(self.moving, t.names(self.source.circular[name])))
        return self.source.moving(name) or (name in self.integrals and self.integrals[name].var in (*self.source.rates, TIME))

    def difference(self, claim: Proposition, when: str = "t") -> Scalar:
        """left - right, now or at the start."""
        found = self.value(t.Add((claim.left, t.Neg(claim.right))))
        return found if when == "t" else self.at_start(found)

    def at_start(self, value: Scalar) -> Scalar:
        """The value at the start, as far as it is known."""
        return self.value(self._begun(self.tree(value)))

    def _begun(self, node: t.Node) -> t.Node:
        integrals = {n: t.ZERO for n in t.names(node) & self.integrals.keys() if self.starts.get(n + START) == t.ZERO}
        return t.renamed(started(t.renamed(node, integrals), self.moving), self.starts)

    # --- elimination

    def order(self, only: Callable[[str], bool] | None = None, *, begun: bool = True) -> Callable[[int], int]:
        """How soon an atom is replaced: letters late in the text first, speeds last."""

        def rank(index: int) -> int:
            name = atoms.symbol_name(index)
            base = "" if name is None else name.removesuffix(START) if begun else name
            if name in self.told:
                return len(self.ranks) + 3
            kept = name is None or name in self.fixed or name in self.source.circular or index in self.nonzero
            return 0 if kept or (only is not None and not only(base)) else self.ranks.get(base, 2)

        return rank

    def is_nonzero(self, value: Scalar) -> bool:
        """Whether it surely does not vanish."""
        return self.is_plain(value) or (len(value.num) > 1 and signed(self, Scalar(value.num), ranged=False) is not None)

    def is_plain(self, value: Scalar) -> bool:
        """Whether that is plain: one term of what does not vanish, or a sum of positive ones."""
        common, inner = parted(value)
        signs = {c > 0 for c in inner.num.terms.values()}
        return common.atoms() <= self.nonzero | self.positive and inner.num.atoms() <= self.positive and len(signs) == 1

    def vanishes(self, value: Scalar) -> bool:
        """Whether it is 0 by sin² + cos² = 1 and the sines and cosines of sums."""
        left = rootless(self, circles(combining.based(self, value), lifted=True)[1])[0]
        return not circles(left, lifted=True)[1]

    def is_positive(self, value: Scalar, *, ranged: bool = False) -> bool:
        """Whether it is a sum of positive terms over a positive one; `ranged`: by what ranges keep above 0, too."""
        known = self.positive | self.certain | self.gaps if ranged else self.positive
        return bool(value) and all(is_plain(poly, known) for poly in (value.num, value.den))

    def _unrated(self, name: str) -> bool:
        return self.moving(name) and name not in self.rates and name not in self.source.circular

    def _defined(self, name: str) -> bool:
        """A letter that is no coordinate, speed or integral: what is said of it is put in its place."""
        return not any(name in known for known in (self.source.rates, self.integrals, self.source.circular))

    def follow(self, goal: Scalar, known: Sequence[KnownEquation], *, only: bool = False) -> tuple[Scalar, Multiples]:
        """What is left of a value when multiples of known equations are taken off, and these."""
        values = [self.difference(item.claim, item.when) for item in known]
        order = self.order(self._defined if only else None)
        rest, sums, rows = reduced(goal, values, order, self.is_nonzero)
        for row in rows:
            factor = None if self.vanishes(rest) else combining.product_of(self, rest, row.value, order if only else None)
            if factor is not None:
                whole = {place: sums.get(place, NOTHING) - factor * part for place, part in row.multiples.items()}
                rest, sums = rest - factor * row.value if only else NOTHING, {**sums, **whole}
        plain = [reduced(goal, values, lambda index: 0, self.is_nonzero)] if self.wide else []  # as they were
        for end, taken, left in ((rest, sums, rows), *plain):
            if not only and not self.vanishes(rest) and (factors := combining.combined(self, end, [row.value for row in left])):
                for factor, row in zip(factors, left, strict=True):
                    for place, part in row.multiples.items() if factor else ():
                        taken = {**taken, place: taken.get(place, NOTHING) - factor * part}
                rest, sums = NOTHING, taken
        rest = NOTHING if self.vanishes(rest) else rest
        return rest, self.summed(goal - rest, {place: -factor for place, factor in sums.items()}, known, values)

    def summed(
        self, goal: Scalar, sums: Mapping[int, Scalar], known: Sequence[KnownEquation], values: Sequence[Scalar]
    ) -> Multiples:
        """The goal as a sum of multiples of what is known, and of sin² + cos² - 1."""
        used = {place: factor for place, factor in sums.items() if not vanishes(factor)}
        for place, factor in used.items():
            goal = goal - factor * values[place]
        turned, left = circles(combining.based(self, goal), lifted=True)
        left, roots = rootless(self, left)
        again, left = circles(left, lifted=True)
        if left:
            raise Undecided("the multiples do not add up: ")
        turned = {index: turned.get(index, NOTHING) + again.get(index, NOTHING) for index in {**turned, **again}}
        angles = tuple((self.tree(q), self.source.circular[atoms.symbol_name(i) or ""].arg) for i, q in turned.items())
        multiples = [*((factor, known[place]) for place, factor in used.items()), *roots]
        return Multiples(tuple((self.tree(factor), item) for factor, item in multiples), angles)

    # --- claims

    def prove(self, claim: Proposition) -> Proof:
        """The proof of a claim. Raises Undecided, with what is left, if none is found."""
        found = self._sought(claim)
        divided = [t.Div(t.ONE, found.factor)] if found.factor is not None else []
        derived = {name for node in (*(found.like or ())[:1], *(have.of for have in found.steps)) for name in t.names(node)}
        rates = (self.tree(self.rates[name]) for name in sorted(derived & self.source.rates.keys()))
        inner = (self.integrals[name].integrand for name in sorted(derived & self.integrals.keys()))
        stood = replace(claim, left=t.renamed(claim.left, {claim.var: claim.place})) if claim.kind == "slope" else claim
        written = [*sides(stood), *formulas(found), *divided, *rates, *inner]
        known = [item for item in self._known(claim) if item.name in self.given and item.when == "t" and item.is_free]
        below = [*combining.nonzero(self, written, known), *within(self, written)]
        below.sort(key=lambda have: bool(have.claim.given))  # what holds where a force presses may rest on the others
        shown = [node for have in (*below, *found.steps, *self.notes.values()) for node in have.parts]
        parts = {part for node in (*written, *shown) for part in t.walk(node)}
        every = {have.name: have for have in (*found.steps, *self.notes.values()) if have.how in SIGNS}.values()
        signs = sorted((have for have in every if have.claim.left in parts), key=lambda have: have.how == "positive")
        others = [have for have in found.steps if have.how not in SIGNS]
        return replace(found, steps=(*signs, *below, *others))

    def _sought(self, claim: Proposition) -> Proof:
        self.met_by = claim.given
        for item in (*claim.given, *(item for name, item in self.given.items() if "'while" in name)):
            if item.kind == "differ":
                self.nonzero |= self.value(item.left).atoms()
            elif item.kind == "more" and item.right == t.ZERO and isinstance(item.left, t.Sym):
                self.positive |= self.value(item.left).atoms()
                self.later |= self.value(item.left).atoms()
        note_gaps(self)
        note_signs(self, signed=claim.kind in ("more", "least") or bool(claim.given))
        self.difference(claim)
        known = [*self._known(claim), *self._unique(), *integrated(self)]
        known += courses(self, known) if claim.given and self.source.event is not None else []
        self._count = len(self.haves)
        try:
            return self._found(claim, known)
        except Undecided:
            self.wide = True
            with suppress(Undecided):
                return self._found(claim, known)
            sums = list(combining.gathered(self))
            if not sums:
                raise
            self._count = len(self.haves)
            return self._found(claim, [*known, *sums])

    def _found(self, claim: Proposition, known: Sequence[KnownEquation]) -> Proof:
        goal = self.difference(claim)
        goal = goal if any(map(self.moving, names_in(goal))) else self.at_start(goal)
        del self.haves[self._count :]
        if claim.kind == "slope":
            self.rates = {claim.var: UNITY}
            slope = t.renamed(self.tree(self.rate_of(self.value(claim.left))), {claim.var: claim.place})
            return self.proof(self.shown(self.value(slope) - self.value(claim.right), ()))
        if claim.kind == "rate":
            like, by = self.follow(self.value(claim.left), known, only=True)
            found = self.shown(self.rate_of(like) - self.value(claim.right), known)
            return self.proof(found, like=(self.tree(like), by))
        if claim.kind in ("more", "least"):
            found, parts = more(self, goal, known, strict=claim.kind == "more")
            return self.proof(found, parts=parts)
        ways = (*(combining.WHERE_GIVEN if claim.given else (by_rates, by_course)), *combining.ALWAYS)
        reasons = []
        for way in (Search.shown, *ways):
            del self.haves[self._count :]
            try:
                made = way(self, goal, known)
                return self.proof(made) if isinstance(made, Multiples) else made
            except Undecided as error:
                reasons.append(str(error))
        raise Undecided("; ".join(reasons))

    def proof(self, multiples: Multiples, like: tuple[t.Node, Multiples] | None = None, **more: Any) -> Proof:
        """The proof, without what was noted on the way and is not used."""
        used, kept = {known.name for part in (multiples, *(like or ())[1:]) for _, known in part.known}, []
        for have in reversed([*self.notes.values(), *self.haves]):
            if have.name in used or have.how in SIGNS:
                used |= {known.name for by in have.accounts for _, known in by.known}
                kept.append(have)
        return Proof(tuple(reversed(kept)), multiples, like, **more)

    def _known(self, claim: Proposition) -> Iterator[KnownEquation]:
        """The equations among the premises, now, and at the start if that is spoken of."""
        equal = {name: item for name, item in self.given.items() if item.kind == "equal"}
        equal |= {f"g{place}": item for place, item in enumerate(claim.given, 1) if item.kind == "equal"}
        held = {part: name for name, part in self.given.items()} | {part: f"g{n}" for n, part in enumerate(claim.given, 1)}
        for name, item in equal.items():
            if set(item.given) <= held.keys():
                yield KnownEquation(name, item, by=tuple(held[part] for part in item.given))
        spoken = {n for item in (claim, *equal.values()) for side in (item.left, item.right) for n in t.names(side)}
        if any(name.endswith(START) for name in spoken):
            plain = {name: item for name, item in self.given.items() if item.kind == "equal" and not item.given}
            yield from (KnownEquation(name, item, "0") for name, item in plain.items())

    def _unique(self) -> Iterator[KnownEquation]:
        """What is said to be the rate of a formula is the rate that the formula has."""
        equal = [KnownEquation(name, item) for name, item in self.given.items() if item.kind == "equal" and not item.given]
        for name, claim in self.doubled.items():
            with suppress(Undecided):
                like, by = self.follow(self.value(claim.left), equal, only=True)
                rate = self.tree(self.rate_of(like))
                if rate != claim.right:
                    more = {"multiples": by, "parts": (self.tree(like),)} if by.known else {}
                    yield self.note("unique", Proposition(claim.right, rate), of=claim.left, source=name, **more)

    def note(self, how: str, claim: Proposition, **more: Any) -> KnownEquation:
        """What is shown on the way, as something known."""
        self.haves.append(Have(f"q{len(self.haves) + 1}", how, claim, **more))
        return KnownEquation(self.haves[-1].name, claim)

    def rate_of(self, value: Scalar) -> Scalar:
        """How a value changes with the time, by what the premises say of its letters. Raises Undecided."""
        unknown = sorted(filter(self._unrated, names_in(value)))
        if unknown:
            raise Undecided(f"nothing among the premises says how {unknown[0]} changes")
        return rate_along(value, {name: self._letter_rate(name) for name in names_in(value) if self.moving(name)})

    def _letter_rate(self, name: str) -> Scalar:
        if name not in self.source.circular:
            return self.rates[name]
        node = self.source.circular[name]
        if isinstance(node, t.Sqrt):
            return self.rate_of(self.value(node.arg)) / (symbol(name) * 2)
        if isinstance(node, t.Group):
            return self.rate_of(self.value(node.arg))
        if node.name not in SLOPES:
            raise Undecided(f"the rate of {node.name} is not written")
        return self.value(SLOPES[node.name](node.arg)) * self.rate_of(self.value(node.arg))

    def shown(self, goal: Scalar, known: Sequence[KnownEquation]) -> Multiples:
        """By multiples; if that is not enough, with the rates of what vanishes as well."""
        rest, found = self.follow(goal, known)
        if self.vanishes(rest):
            return found
        once = [*self.stills(known)]
        more = [*known, *once]
        if any(name.endswith(START) for name in names_in(goal)):  # accelerations then, of what is said of places
            more += (KnownEquation(item.name, item.claim, "0") for item in (*once, *self.stills(once)))
        rest, found = self.follow(goal, more)
        if not self.vanishes(rest) and (squares := list(self._squares(known))):
            rest, found = self.follow(goal, [*more, *squares])
        if not self.vanishes(rest):
            raise Undecided("it does not follow: of left - right stays " + brief(self.tree(rest)))
        return found

    def stills(self, known: Sequence[KnownEquation]) -> Iterator[KnownEquation]:
        """The rates of the equations, after letters without a rate are replaced."""
        now = [item for item in known if item.when == "t" and item.is_free]
        values, found = [self.difference(item.claim) for item in now], []
        each = [lambda name, one=one: self._defined(name) or name == one for one in self.integrals if self.moving(one)]
        for replaced in (self._unrated, self._defined, *each):
            for row in reduced(NOTHING, values, self.order(replaced, begun=False), self.is_nonzero)[2]:
                names = names_in(row.value)
                if row.value not in found and any(map(self.moving, names)) and not any(map(self._unrated, names)):
                    made = self.summed(row.value, row.multiples, now, values)
                    claim = Proposition(self.tree(self.rate_of(row.value)), t.ZERO)
                    found.append(row.value)
                    yield self.note("still", claim, of=self.tree(row.value), multiples=made)

    def _squares(self, known: Sequence[KnownEquation]) -> Iterator[KnownEquation]:
        """The squares of the speeds that the first integral gives, if it follows."""
        if self.deep or not any(self.starts):
            return
        self.deep = True
        for name, value in self.source.study.squares.items():
            claim = Proposition(t.power(t.Sym(f"{name}_dot"), 2), tree_of(value))
            with suppress(Undecided):
                found = by_rates(self, Scalar(self.difference(claim).num), known)  # what stands below may move
                flat = self.haves[-1]
                if len(found.known) == 1 and flat.how == "flat":
                    yield KnownEquation(flat.name, flat.claim)
        self.deep = False
