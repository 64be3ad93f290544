"""Sums of multiples of equations where no single factor is sure: linear algebra over the field; equations by a factor, of
which a multiple is shown to be 0; and why what is divided by does not vanish."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Coefficient, Monomial, Poly, Scalar, atoms, generator, symbol
from rbpsym.field.calculus import names_in, substitute
from rbpsym.field.division import divide
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import bases_of, in_bases, is_zero
from rbpsym.kernel.certificates import Have, KnownEquation, Multiples, Proof, parted, reduced, wound
from rbpsym.kernel.claim import Proposition, tree_of
from rbpsym.kernel.integrals import by_rates
from rbpsym.kernel.positive import PositiveSum, is_wave, positive_sum
from rbpsym.kernel.radicals import rootless
from rbpsym.kernel.ranges import sense_of, shown, signed
from rbpsym.mechanics.elimination import solve_linear

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search

BELOW = {"tan": "cos", "sec": "cos", "cot": "sin", "csc": "sin"}  # what stands below in these
MOST = 6  # rows of which multiples with sines and cosines alone are sought


def combined(search: Search, goal: Scalar, rows: Sequence[Scalar]) -> list[Scalar] | None:
    """Factors with goal = Σ factor × row, whose denominators surely do not vanish; None if none are found.

    They are sought in the field of parameters, places and speeds, in that of parameters and places alone, in that of
    all of which higher powers occur, and in that of places.
    """
    order = search.order()
    letters = {i for value in (goal, *rows) for i in value.num.atoms() if order(i)} - search.nonzero
    linear = {i for i in letters if all(max(value.num.by_power(i), default=0) <= 1 for value in (goal, *rows))}
    speeds = {i for i in letters if (atoms.symbol_name(i) or "") in search.source.rates}
    every = {i for value in (goal, *rows) for i in value.num.atoms()}
    constants = {i for i in every if not search.moving(atoms.symbol_name(i) or "") and not is_wave(i)}
    kinds = (letters - speeds, letters, linear, *([constants] if len(rows) <= MOST else []))
    for unknown in dict.fromkeys(map(frozenset, kinds)):
        if any(value.den.atoms() & unknown for value in (goal, *rows)):
            continue
        ways = [[*range(len(rows))]]
        for kept in ways:  # then without a row whose factor is over what may vanish
            found = _factors_of(search, goal, [rows[place] for place in kept], unknown)
            factors = dict(zip(kept, (_whole(search, value) for value in found or ()), strict=False))
            bad = [place for place, value in factors.items() if not all(stays(search, part) for part in _under(value))]
            if factors and not bad:
                return [factors.get(place, NOTHING) for place in range(len(rows))]
            fewer = ([p for p in kept if p != place] for place in bad if len(ways) < 2 * MOST * search.wide)
            ways += [left for left in fewer if left not in ways]
    return None


def _whole(search: Search, value: Scalar) -> Scalar:
    """The value without sines and cosines below, if there is such a form: (1 - cos²)/sin is sin."""
    forms = (wound(search.value(tree_of(value)), kind) for kind in ("sin", "cos"))
    return next((form for form in forms if not any(e < 0 and is_wave(i) for m in form.num.terms for i, e in m)), value)


def _under(value: Scalar) -> Iterator[Scalar]:
    """What it is divided by."""
    yield Scalar(value.den)
    yield from (Scalar(generator(i)) for i in sorted({i for m in value.num.terms for i, e in m if e < 0}))


def _factors_of(search: Search, goal: Scalar, rows: Sequence[Scalar], letters: Collection[int]) -> list[Scalar] | None:
    names = [f"factor {place}" for place in range(len(rows))]
    equations: dict[Monomial, Scalar] = {}
    for factor, value in zip([*map(symbol, names), UNITY * -1], [based(search, value) for value in (*rows, goal)], strict=True):
        for key, part in by_letters(value.num, letters).items():
            whole = scalar(search.tree(Scalar(part) / Scalar(value.den)))
            equations[key] = equations.get(key, NOTHING) + factor * whole
    found = solve_linear(list(equations.values()), names, keep_free=True)
    if not all(map(is_zero, found.left)):
        return None
    free = dict.fromkeys(names, NOTHING)
    values = [substitute(found.values.get(name, NOTHING), free) for name in names]
    return [search.value(tree_of(value)) for value in values]


def by_letters(poly: Poly, letters: Collection[int]) -> dict[Monomial, Poly]:
    """The coefficients of the products of some letters."""
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for monomial, coefficient in poly.terms.items():
        key = tuple(item for item in monomial if item[0] in letters)
        parts.setdefault(key, {})[tuple(item for item in monomial if item[0] not in letters)] = coefficient
    return {key: Poly(terms) for key, terms in parts.items()}


def product_of(search: Search, rest: Scalar, by: Scalar, order: Callable[[int], int] | None) -> Scalar | None:
    """Of which multiple of an equation the rest is; by an order of letters, of which multiple the products of letters are
    that stand in the equation."""
    if order is None:
        return ratio_of(search, rest, by) or ratio_of(search, wound(rest, "cos"), wound(by, "cos"))
    letters = {index for value in (rest, by) for index in value.num.atoms() if order(index)}
    own, there = by_letters(by.num, letters), by_letters(rest.num, letters)
    products = [key for key in own if key]
    if not products or not there.keys() >= {*products}:
        return None
    first, *others = ((Scalar(there[key], rest.den), Scalar(own[key], by.den)) for key in products)
    factor = ratio_of(search, *first)
    return None if factor is None or any(left - factor * right for left, right in others) else factor


def ratio_of(search: Search, value: Scalar, by: Scalar) -> Scalar | None:
    """value / by, if it is a polynomial but for what does not vanish."""
    found = divide(value.num, by.num) if by else None
    if found is None or not search.is_nonzero(Scalar(value.den)):
        return None
    below = {index for m in found.terms for index, exponent in m if exponent < 0}
    return Scalar(found) * Scalar(by.den) / Scalar(value.den) if below <= search.positive | search.nonzero else None


def stays(search: Search, value: Scalar) -> bool:
    """Whether a value surely does not vanish."""
    return search.is_nonzero(value) or signed(search, Scalar(value.num)) is not None


def based(search: Search, value: Scalar) -> Scalar:
    """Sines and cosines of sums written in those of their terms."""
    images, circular = {}, search.source.circular
    for name in () if search.told else names_in(value) & circular.keys() - search.roots.keys():
        num = scalar(circular[name]).num
        if (image := in_bases(num, bases_of(num))) != num:
            images[name] = search.value(tree_of(image))
    return substitute(value, images) if images else value


def gathered(search: Search) -> Iterator[KnownEquation]:
    """Sines and cosines of the first term of a sum of two angles, by those of the sum and of the second."""
    circular = search.source.circular
    for node in [node for name, node in circular.items() if name.startswith("cos ")]:
        terms = scalar(node.arg).num.terms if scalar(node.arg).den.constant_value() == 1 else {}
        plain = [(atoms.symbol_name(m[0][0]) or "", sign) for m, sign in terms.items() if len(m) == 1 and m[0][1] == 1]
        is_told = len(plain) == len(terms) == 2 and all(f"cos {name}" in {*circular} - search.told for name, _ in plain)
        if not is_told or any(abs(sign) != 1 for _, sign in plain) or {-1} == {sign for _, sign in plain}:
            continue
        (first, turn), (second, way) = plain
        b, c = (node.arg, t.Sym(second)) if turn > 0 else (t.Sym(second), node.arg)
        sb, cb, sc, cc = (t.Fn(kind, of) for of in (b, c) for kind in ("sin", "cos"))
        is_sum = way < 0 < turn
        for kind, left, right in (("sin", (sb, cc), (cb, sc)), ("cos", (cb, cc), (sb, sc))):
            product = t.Mul(right) if is_sum == (kind == "sin") else t.Neg(t.Mul(right))
            search.told.add(f"{kind} {first}")
            yield search.note("sum", Proposition(t.Fn(kind, t.Sym(first)), t.Add((t.Mul(left), product))))


# --- denominators


def nonzero(search: Search, nodes: Sequence[t.Node], known: Sequence[KnownEquation]) -> Iterator[Have]:
    """Why what is divided by in some formulas does not vanish, where it takes more than signs of letters."""
    seen: set[tuple[Poly, str]] = set()
    over = {item.var for item in search.integrals.values()}
    every = [part for node in nodes for part in t.walk(node)]
    for factor, kind in ((each, "more" if isinstance(part, t.Sqrt) else "differ") for part in every for each in _below(part)):
        value = Scalar(search.value(factor).num)
        is_bound = over & names_in(value) - search.source.rates.keys()
        if (value.num, kind) not in seen and not search.is_plain(value) and not is_bound:
            seen |= {(value.num, kind), (value.num.scaled(-1), kind)}
            name, why = f"z{len(seen)}", surely(search, value, known)
            if why is not None and (kind == "differ" or why[1].sign > 0):
                node = search.tree(value)
                yield anywhere(search, name, node, over & t.names(node)) or shown(search, name, (node, why[0]), *why[1:], kind)
            elif kind == "differ" and (divides := divisor(search, name, value, known)):
                yield divides
            elif why is None:
                search.is_sure = False


def anywhere(search: Search, name: str, node: t.Node, over: set[str]) -> Have | None:
    """The claim of each value of the one coordinate in it, over which is integrated, if it takes no range to show it."""
    if len(over) != 1 or {*filter(search.moving, t.names(node))} != over:
        return None
    found = positive_sum(search.value(node).num, search.always, search.least)
    if found is None or found.sign < 0 or not any(isinstance(part, t.Fn) for part in t.walk(node)):
        return None
    made = shown(search, name, (node, search.value(node)), found, Multiples(), "more")
    return replace(made, claim=replace(made.claim, var=min(over)))


def divisor(search: Search, name: str, value: Scalar, known: Sequence[KnownEquation]) -> Have | None:
    """A value of which a multiple is given not to vanish."""
    for item in (item for item in search.met_by if item.kind in ("more", "differ") and item.right == t.ZERO):
        rest, by = search.follow(search.value(item.left), known)
        if (found := divide(rest.num, value.num)) is not None:
            claim = Proposition(search.tree(value), t.ZERO, "differ", search.met_by)
            return Have(name, "factor", claim, multiples=by, parts=(item.left, search.tree(Scalar(found) / Scalar(rest.den))))
    return None


def surely(search: Search, value: Scalar, known: Sequence[KnownEquation]) -> tuple[Scalar, PositiveSum, Multiples] | None:
    """Why a value does not vanish: what it is by what is known, that as a sum of one sign, and by which multiples."""
    rest, by = search.follow(value, known) if any(map(search.order(), value.atoms())) else (value, Multiples())
    if (found := signed(search, rest)) is not None:
        return rest, found, by
    for whole in (search.value(item.left) for item in search.met_by if item.kind == "more" and item.right == t.ZERO):
        rest, _ = search.follow(whole, known)
        ratio = ratio_of(search, wound(value), wound(rest))  # a multiple of what is more than 0 where the claim has to hold
        if ratio is not None and (sense := sense_of(search, ratio)):
            left, by = search.follow(value - ratio * whole, known)
            if not left:
                return ratio * whole, PositiveSum(sense, ratio * whole * sense, (), ()), by
    return None


def _below(part: t.Node) -> Iterator[t.Node]:
    if isinstance(part, t.Div):
        yield from _factors(part.den)
    elif isinstance(part, t.Pow) and isinstance(part.exponent, t.Num | t.Neg) and t.is_negative(part.exponent):
        yield from _factors(part.base)
    elif isinstance(part, t.Sqrt):
        yield from _factors(part.arg)
    elif isinstance(part, t.Fn) and part.name in BELOW:
        yield t.Fn(BELOW[part.name], part.arg)


def _factors(node: t.Node) -> Iterator[t.Node]:
    if isinstance(node, t.Mul):
        for factor in node.factors:
            yield from _factors(factor)
    elif isinstance(node, t.Group | t.Neg):
        yield from _factors(node.arg)
    elif isinstance(node, t.Pow):
        yield from _factors(node.base)
    else:
        yield node


# --- by a factor


def cancelled(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Proof:
    """A multiple of left - right vanishes, by a factor that does not."""
    values = [search.difference(item.claim, item.when) for item in known]
    rest, sums, rows = reduced(goal, values, search.order(), search.is_nonzero)
    for row in rows:
        factor = ratio_of(search, row.value, rest)
        if factor is not None and search.is_nonzero(factor):
            whole = {place: -factor * part for place, part in sums.items()}
            whole |= {place: whole.get(place, NOTHING) + part for place, part in row.multiples.items()}
            above = t.mul(*map(search.tree, parted(factor)))
            return search.proof(search.summed(factor * goal, whole, known, values), factor=above)
    raise Undecided("what stands beside it may vanish")


def cancelled_rates(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Proof:
    """The same with the rates of what vanishes."""
    return cancelled(search, goal, [*known, *search.stills(known)])


def multiplied(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Proof:
    """left - right times what holds letters below it, or changes there, vanishes, and that does not."""
    order = search.order()
    moves = {i for i in goal.num.atoms() | goal.den.atoms() if order(i) or search.moving(atoms.symbol_name(i) or "")}
    below = {generator(i): -e for i, e in goal.num.content()[1] if e < 0 and i in moves}
    below |= {goal.den: 1} if goal.den.atoms() & moves else {}
    factor = UNITY
    for part, exponent in below.items():
        factor = factor * Scalar(part) ** exponent
        if not (stays(search, Scalar(part)) or surely(search, Scalar(part), known)):
            raise Undecided("what stands below may vanish")
    if not below:
        raise Undecided("nothing stands below")
    try:
        found = search.shown(goal * factor, known)
    except Undecided:
        found = by_rates(search, goal * factor, known)
    return search.proof(found, factor=search.tree(factor))


def met(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Proof:
    """left - right times what is given not to vanish vanishes."""
    for item in (item for item in search.met_by if item.kind == "differ" and item.right == t.ZERO):
        factor = search.value(item.left)
        return search.proof(search.shown(goal * factor, known), factor=search.tree(factor))
    raise Undecided("nothing is given that does not vanish")


def conjugated(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Proof:
    """left - right is linear in a root: times the same with the other root it vanishes, and that does not."""
    rest = search.follow(goal, known)[0]
    for name in sorted(names_in(rest) & search.roots.keys()):
        other = parted(substitute(rest, {name: -symbol(name)}))[1]
        found = signed(search, Scalar(other.num))
        if found is not None and name not in names_in(rootless(search, rest * other)[0]):
            other = other * found.sign
            whole, taken = rootless(search, goal * other)
            by = search.shown(whole, known)
            more = tuple((search.tree(factor), item) for factor, item in taken)
            return search.proof(replace(by, known=(*by.known, *more)), factor=search.tree(other))
    raise Undecided("no other root")


WHERE_GIVEN, ALWAYS = (cancelled, cancelled_rates, met), (multiplied, conjugated)
