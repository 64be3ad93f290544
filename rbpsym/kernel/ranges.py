"""Signs: sines and cosines that the known ranges of their angles keep positive, and what is more than something else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from math import isqrt, prod
from typing import TYPE_CHECKING

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, PI, Poly, Scalar, atoms, factors, names_in, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.kernel.certificates import Have, KnownEquation, Multiples, circles, parted, wound
from rbpsym.kernel.claim import Proposition, brief, tree_of
from rbpsym.kernel.positive import PositiveSum, positive_sum
from rbpsym.typeset.machine import to_machine

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search

MOST = 3  # letters for which ends of ranges are tried at once
QUARTERS = (("sin", NOTHING, PI), ("cos", PI * Fraction(-1, 2), PI * Fraction(1, 2)))


def _is_least(value: Scalar) -> bool:
    """Whether a multiple of π is not negative."""
    found = (value / PI).number()
    return found is not None and found >= 0


def _is_turn(search: Search, end: Scalar, kind: str) -> bool:
    """Whether an end, for a sine, is the arcsine of something positive."""
    node = search.tree(search.value(tree_of(end)))
    return kind == "sin" and isinstance(node, t.Fn) and node.name == "asin" and search.is_positive(scalar(node.arg))


def _is_in_force(search: Search, claim: Proposition) -> bool:
    """Whether something is said to be more where the claim that is sought has to hold."""
    return claim.kind == "more" and set(claim.given) <= set(search.met_by)


def note_signs(search: Search, *, signed: bool) -> None:
    """Sines and cosines that ranges keep positive; only if signs are spoken of, and their ranges are premises, is
    divided by them on the way."""
    ranges = {name: claim for name, claim in search.given.items() if _is_in_force(search, claim)}
    for name in sorted({n for claim in ranges.values() for n in t.names(claim.left) | t.names(claim.right)} - {"pi"}):
        own = t.Sym(name)
        low = {scalar(claim.right): id for id, claim in ranges.items() if claim.left == own}
        high = {scalar(claim.left): id for id, claim in ranges.items() if claim.right == own}
        for kind, lowest, highest in QUARTERS:
            below = next((id for end, id in low.items() if _is_least(end - lowest) or _is_turn(search, end, kind)), None)
            above = next((id for end, id in high.items() if _is_least(highest - end)), None)
            if below and above:
                wave = t.Fn(kind, own)
                given = ranges[below].given
                search.note("sign", Proposition(wave, t.ZERO, "more", given), source=f"{below} {above}")
                search.certain |= search.value(wave).atoms()
                search.later |= search.value(wave).atoms() if given else set()
                if signed and (not search.moving(name) or not {below, above} & search.declared):
                    search.positive |= search.value(wave).atoms()


def note_gaps(search: Search) -> None:
    """What a range leaves between a letter and its end, as a positive letter; and π - 3."""
    ends = [(name, item) for name, item in search.given.items() if _is_in_force(search, item)]
    for source, item in (*ends, ("", Proposition(t.Sym("pi"), t.Num(3), "more"))):
        search.haves.append(_gap(search, item, f"q{len(search.haves) + 1}", source))


def note_number(search: Search, node: t.Sqrt, value: Scalar) -> None:
    """Between which hundredths the root of a number is."""
    if (number := value.number()) is not None and number > 0:
        low = Fraction(isqrt(int(number * 10**4)), 100)
        for high, less in ((node, t.Num(low)), (t.Num(low + Fraction(1, 100)), node)):
            own = f"b{len(search.notes)}"
            search.notes[own] = _gap(search, Proposition(high, less, "more"), own)


def _gap(search: Search, item: Proposition, own: str, source: str = "") -> Have:
    """The gap between two sides, as a positive letter by which either is replaced if it is a letter."""
    node, (high, low) = t.Group(t.Add((item.left, t.Neg(item.right)))), map(search.value, (item.left, item.right))
    letter = f"gap {source or to_machine(node)}"
    search.source.circular[letter], gap = node, symbol(letter)
    for side, image in ((high, low + gap), (low, high - gap)):
        for name in (name for name in names_in(side) if side == symbol(name)):
            search.shifts.setdefault(name, []).append(image)
    search.gaps |= gap.atoms()
    search.later |= gap.atoms() if item.given else set()
    return Have(own, "gap", Proposition(node, t.ZERO, "more", item.given), source=source)


def signed(search: Search, value: Scalar, *, ranged: bool = True, strict: bool = True) -> PositiveSum | None:
    """The value as a sum of one sign: by gaps, by what sines and cosines are at most, and if it is `ranged` by what ranges
    keep positive. Not `strict`: it may vanish."""
    known = frozenset(search.positive | search.certain) if ranged else search.always
    common = search.positive | known if strict else search.positive | known | search.least
    below = Poly({tuple(sorted((i, -e) for i, e in value.num.content()[1] if i in common)): 1})
    poly = value.num * below
    if (key := (poly, known, strict)) not in search.sums:
        search.sums[key] = next(_sums(search, poly, known, strict), None)
    num = search.sums[key]
    sense = 0 if num is None else sense_of(search, Scalar(value.den))
    if num is None or not sense:
        return None
    return num.over(Scalar(value.den) * Scalar(below) * sense, num.sign * sense)


def _sums(search: Search, poly: Poly, known: frozenset[int], strict: bool) -> Iterator[PositiveSum]:
    names = [name for name in search.shifts if atoms.intern("symbol", name) in poly.atoms()][:MOST]
    ways = [dict(zip(names, images, strict=True)) for images in product(*([None, *search.shifts[name]] for name in names))]
    for images in ways:
        value = substitute(Scalar(poly), {name: image for name, image in images.items() if image is not None})
        for above in dict.fromkeys((known, search.always)) if value.den.constant_value() == 1 else ():
            deep = 0 if any(images.values()) else 3
            found = positive_sum(value.num, above | search.gaps, search.least, strict=strict, deep=deep)
            if found is not None:
                yield found


def sense_of(search: Search, value: Scalar) -> int:
    """The sign of a value by those of its factors; 0 if it is not known."""
    common, inner = parted(value)
    if not search.is_positive(common):
        return 0
    split = [factors(poly) for poly in (inner.num, inner.den)]
    senses = [_sense(search, Scalar(part)) ** exponent for _, parts in split for part, exponent in parts]
    return int(prod(senses, start=1 if prod(number for number, _ in split) > 0 else -1))


def _sense(search: Search, part: Scalar) -> int:
    found = signed(search, part)
    return found.sign if found else 0


def shown(search: Search, name: str, of: tuple[t.Node, Scalar], found: PositiveSum, by: Multiples, kind: str = "differ") -> Have:
    """± the formula, or what it is known to be, is positive and not negative parts, by sin² + cos² = 1."""
    node, value = of
    rest = [t.mul(_above(search, factor), t.Pow(search.tree(root), t.TWO)) for factor, root in found.squares]
    for factor, wave, turn in found.waves:
        swing = search.tree(wave)
        rest.append(t.mul(_above(search, factor), t.Add((t.ONE, swing if turn > 0 else t.Neg(swing)))))
    above, others = _above(search, found.above), t.add(*rest)
    whole = search.value(t.Add((above, others)))
    turned, left = circles(value * found.sign - whole)
    assert not left, "a sum that was found is the formula"
    angles = [(search.tree(q), search.source.circular[atoms.symbol_name(i) or ""].arg) for i, q in turned.items()]
    known = tuple((t.mul(t.Num(found.sign), factor), item) for factor, item in by.known)
    angles += [(t.mul(t.Num(found.sign), factor), angle) for factor, angle in by.circles]
    side = node if found.sign > 0 else t.Neg(node)
    how = "nonzero" if kind == "differ" else "positive"
    pairs = (*found.squares, *((factor, wave) for factor, wave, _ in found.waves))
    parts = (found.above, *(part for pair in pairs for part in pair))
    given = search.met_by if any(part.atoms() & search.later for part in parts) else ()
    return Have(name, how, Proposition(node, t.ZERO, kind, given), side, Multiples(known, tuple(angles)), parts=(above, others))


def _above(search: Search, value: Scalar) -> t.Node:
    """A positive value; by its positive factors if it is no sum of positive terms, which are shown to be so."""
    common, inner = parted(value)
    sides = [factors(poly) for poly in (inner.num, inner.den)]
    if search.is_positive(inner, ranged=True) or not all(_sense(search, Scalar(part)) for _, parts in sides for part, _ in parts):
        return search.tree(value)
    top, below = (t.mul(*(t.power(_factor(search, Scalar(part)), exponent) for part, exponent in parts)) for _, parts in sides)
    return t.div(t.mul(search.tree(common * abs(Fraction(sides[0][0]) / Fraction(sides[1][0]))), top), below)


def _factor(search: Search, part: Scalar) -> t.Node:
    """A factor with the sign that makes it positive."""
    found = signed(search, part)
    assert found is not None
    node = search.tree(part * found.sign)
    if not search.is_positive(part * found.sign, ranged=True) and all(note.claim.left != node for note in search.notes.values()):
        have = shown(search, "", (node, part * found.sign), replace(found, sign=1), Multiples(), "more")
        name = f"u{len(search.notes)}"
        search.notes[name] = replace(have, name=name)
    return node


def within(search: Search, nodes: Sequence[t.Node]) -> Iterator[Have]:
    """Why that of which an arcsine or arccosine is taken in some formulas is between -1 and 1."""
    inverse = {part.arg for node in nodes for part in t.walk(node) if isinstance(part, t.Fn) and part.name in ("asin", "acos")}
    for place, arg in enumerate(sorted((arg for arg in inverse if t.names(arg)), key=to_machine), 1):
        inner = t.Add((t.ONE, t.Neg(t.Pow(arg, t.TWO))))
        try:
            by, parts = above(search, search.value(inner), ())
            yield Have(f"w{place}", "positive", Proposition(inner, t.ZERO, "more"), inner, by, parts=parts)
        except Undecided:
            search.is_sure = False


def above(
    search: Search, goal: Scalar, known: Sequence[KnownEquation], *, strict: bool = True
) -> tuple[Multiples, tuple[t.Node, ...]]:
    """left - right is a sum of something positive (or, if not `strict`, nothing) and of what is not negative: the multiples,
    and these two."""
    rest, by = search.follow(goal, known)
    found = signed(search, rest, strict=strict)
    if found is not None and found.sign > 0:
        have = shown(search, "", (t.ZERO, rest), found, Multiples())
        return Multiples(by.known, (*by.circles, *have.multiples.circles)), have.parts
    rest = wound(rest, "cos")
    bounds = [item.left for item in search.met_by if item.kind == "least" and item.right == t.ZERO]
    bounds += [item.claim.left for item in known if isinstance(item.claim.left, t.Pow) and item.claim.left.exponent == t.TWO]
    for node in bounds:
        bound, _ = search.follow(search.value(node), known)
        for index in sorted(bound.num.atoms()):
            heads, own = bound.num.by_power(index), rest.num.by_power(index)
            top = max(heads)
            more = Scalar(own.get(top, Poly({})), rest.den) / Scalar(heads[top], bound.den)
            left = wound(rest - more * bound)
            if top > 0 and sense_of(search, more) > 0 and sense_of(search, left) > 0:
                _, multiples = search.follow(goal - more * search.value(node) - left, known)
                return multiples, (_above(search, left), t.mul(_above(search, more), node))
    raise Undecided("nothing shows that it is positive: " + brief(search.tree(rest)))
