"""Conditions on parameters, such as 2 k L - m g > 0: what is left of them, and which contradict each other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import takewhile

from rbpsym.decide.assumptions import Assumptions, behind
from rbpsym.decide.domain import IMPLIED
from rbpsym.decide.rooted import neat, root_of
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.field import ONE, ZERO, Poly, atoms, cosine, generator, names_in, short, sine, with_exponentials_joined
from rbpsym.field.normal import in_one_angle, is_zero, normal
from rbpsym.field.roots import without_even_roots
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, symbol
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.stability import essential, open_factors
from rbpsym.present.forms import present
from rbpsym.typeset.machine import to_machine

FAILS = {">": ("negative", "zero", "nonpositive"), ">=": ("negative",), "!=": ("zero",)}
WAYS: Mapping[str | None, int] = {"positive": 1, "negative": -1}


class Demand(Frozen):
    """`value` op 0, op being ">", ">=" or "!="."""

    value: Scalar
    op: str = ">"


def settle(demands: Iterable[Demand], given: Assumptions) -> tuple[Demand, ...] | None:
    """What is left of the demands; None if one of them is never met, or if they contradict each other."""
    kept: list[Demand] = []
    queue = list(demands)
    while queue:
        demand = queue.pop(0)
        value = short(without_even_roots(in_one_angle(with_exponentials_joined(demand.value))))
        item = _without_inverse(Demand(Scalar(value.num * value.den) if len(value.den) > 1 else value, demand.op), given)
        found = sign(item.value, given)
        if found.kind in FAILS[item.op]:
            return None
        if not IMPLIED[item.op](found):
            item = Demand(essential(item.value, given), item.op)
            parts = _squared(item, given) or _without_roots(item) or _parted(item, given)
            kept += [] if parts else [item]
            queue += parts
    return _consistent(list(dict.fromkeys(kept)), given)


def possible(demands: Iterable[Demand], given: Assumptions, never: RbpsymError) -> tuple[Demand, ...]:
    """What is left of what has to be met. Raises the error where it never is, which is no empty condition."""
    left = settle(demands, given)
    if left is None:
        raise never
    return left


def turned(root: Scalar, turn: Scalar, ends: tuple[Scalar | None, Scalar | None], given: Assumptions, most: int) -> list[Scalar]:
    """The places that lie whole turns from one, in order, up to the first that is beyond an end."""
    lower, upper = ends
    down, up = ([root + turn * k for k in turns] for turns in (range(-1, -most - 1, -1), range(most + 1)))
    kept = takewhile(lambda place: lower is None or sign(place - lower, given).kind != "negative", down)
    return [*reversed([*kept]), *takewhile(lambda place: upper is None or sign(upper - place, given).kind != "negative", up)]


def _parted(item: Demand, given: Assumptions) -> list[Demand]:
    """a b > 0 as a > 0 and b > 0, or as a < 0 and b < 0, where only one of these may be."""
    factors = open_factors(item.value, given)
    whole = sign(short(item.value / (factors[0] * factors[1])), given).kind if len(factors) == 2 else None
    if whole not in WAYS or item.op == "!=":
        return []
    pairs = ((Demand(factors[0] * way, item.op), Demand(factors[1] * way * WAYS[whole], item.op)) for way in (1, -1))
    met = [pair for pair in pairs if settle(pair, given) is not None]
    return sorted(met[0], key=lambda one: to_machine(present(one.value))) if len(met) == 1 else []


def _consistent(demands: list[Demand], given: Assumptions) -> tuple[Demand, ...] | None:
    """Without what follows from the rest."""
    strict = [item for item in demands if item.op == ">"]
    parts = {one for one in demands if one.op != ">" and any(_divided(item, [Demand(one.value)]) != item for item in strict)}
    demands = [item for item in demands if item.op != "!=" or item not in parts]  # a factor of what is positive is not zero
    demands = [Demand(item.value) if item in parts else item for item in demands]
    known = [Demand(value, ">=" if is_loose else ">") for value, is_loose in given.known]
    demands = list(dict.fromkeys(_divided(item, [*demands, *known]) for item in demands))
    other_than_zero = {item.value * way for item in demands if item.op == "!=" for way in (1, -1)}
    demands = [Demand(item.value) if item.op == ">=" and item.value in other_than_zero else item for item in demands]
    firm = {one.value * way for one in demands if one.op == ">" for way in (1, -1)}
    apart = [item for k, item in enumerate(demands) if item.value in firm or Demand(-item.value, "!=") in demands[:k]]
    demands = [item for item in demands if item.op != "!=" or item not in apart]
    demands = [item for item in demands if item.op == ">" or Demand(item.value) not in demands]
    for item in list(demands):
        others = [other for other in demands if other is not item]
        found = sign(item.value, assuming(given, others, tighter=True))
        products = [sign(short(item.value * o.value), given) for o in others if ">" in (item.op, o.op) and o.op != "!="]
        if found.kind in FAILS[item.op] or any(p.kind in FAILS[item.op] for p in products):
            return None
        if IMPLIED[item.op](found) or any(p.kind == "positive" for p in products) or any(_leaves(o, item) for o in others):
            demands = others
    return tuple(demands)


def _leaves(firm: Demand, item: Demand) -> bool:
    """Whether sin x ≠ 0 is asked, which leaves 1 - cos x and 1 + cos x positive: their product is its square."""
    return firm.op != ">=" and is_zero(item.value * (2 - item.value) - firm.value**2)


def _divided(item: Demand, demands: list[Demand]) -> Demand:
    """Without a factor that another demand says to be positive."""
    for other in demands:
        is_firm = other.op == ">" or other.op == item.op == ">="
        if is_firm and item.op != "!=" and other.value != item.value and 1 < len(other.value.num) <= len(item.value.num):
            for above, below in ((item.value.num, other.value.num), (normal(item.value.num), normal(other.value.num))):
                rest = short(Scalar(above) / Scalar(below))
                is_factor = rest.den is ONE and all(power > 0 for term in rest.num.terms for _, power in term)
                is_less = is_factor and len(rest.num) < len(above) and rest.number() is None
                item = Demand(rest, item.op) if is_less else item
    return item


def assuming(given: Assumptions, demands: Iterable[Demand], *, tighter: bool = False, whole: bool = False) -> Assumptions:
    """The assumptions with what the demands say of one quantity each (`tighter`: in place of wider bounds too; `whole`: what
    they say of several as it stands, for checks: it is not to be asked whether they are met)."""
    for demand in demands:
        if demand.op != "!=":
            other = _knowing(given, demand) if whole else given
            given = next(_turned(given, demand), None) or next(_narrowed(given, demand, tighter), other)
    return given


def _knowing(given: Assumptions, demand: Demand) -> Assumptions:
    """What no bound of one quantity says, as it stands; a quotient only where what it is divided by is positive."""
    if len(demand.value.num) < 2 or sign(Scalar(demand.value.den), given).kind != "positive":
        return given
    return replace(given, known=given.known | {(Scalar(demand.value.num), demand.op == ">=")})


def _turned(given: Assumptions, demand: Demand) -> Iterator[Assumptions]:
    """± sin x > 0 or cos x > 0 as a range of x, where x lies in (-π, π)."""
    value = demand.value
    [(index, exponent), *more] = next(iter(value.num.terms), ()) or ((0, 0),)
    atom = atoms.atom(index)
    name = atoms.symbol_name(next(iter(atom.arg.atoms()), 0)) if atom.kind in WAVES else None
    if value.den is ONE and len(value.num) == exponent == 1 and not more and name and name in given.ranges:
        side = 1 if next(iter(value.num.terms.values())) > 0 else -1
        ends = WAVES[atom.kind].get(side)
        low, high = (None if end is None else (end / PI).number() for end in given.range_of(name))
        if ends and low is not None and high is not None and low >= -1 and high <= 1 and atom.arg == symbol(name).num:
            new = {side for side, is_new in enumerate((ends[0] > low, ends[1] < high)) if is_new}
            reached = (given.sides_of(name) - new) | (set() if demand.op == ">" else new)
            yield given.with_range(name, max(ends[0], low) * PI, min(ends[1], high) * PI, reached)


HALF = Fraction(1, 2)
WAVES: Mapping[str, Mapping[int, tuple[Fraction | int, Fraction | int]]] = {  # in units of π
    "sin": {1: (0, 1), -1: (-1, 0)},
    "cos": {1: (-HALF, HALF)},
}


def _narrowed(given: Assumptions, demand: Demand, tighter: bool) -> Iterator[Assumptions]:
    """a x + b > 0 or a x² + b > 0 as a bound of x, for each x that has none yet on that side; a x > 0 as its sign."""
    value = demand.value
    powers = {name: max(value.num.by_power(atoms.intern("symbol", name))) for name in names_in(value) - {"pi"}}
    for name in sorted(powers, key=lambda n: (powers[n], n)):
        parts = value.num.by_power(atoms.intern("symbol", name))
        if value.den is not ONE or set(parts) not in ({0, 1}, {0, 2}, {1}):
            continue
        power, slope = max(parts), Scalar(parts[max(parts)])
        way, bound = WAYS.get(sign(slope, given).kind), short(-(Scalar(parts.get(0, ZERO)) / slope))
        if way is None or name in behind(given, bound) or (power == 2 and given.sign_of(name) != "positive"):
            continue
        lower, upper = given.range_of(name)
        if power == 2:
            if sign(bound, given).kind != "positive":
                continue
            bound = root_of(bound, given)
        old = lower if way > 0 else upper
        if old == bound and demand.op != ">":
            continue
        if old in (None, NOTHING) or (tighter and sign((bound - old) * way, given).is_nonnegative):
            side = 0 if way > 0 else 1
            sides = (given.sides_of(name) - {side}) | (set() if demand.op == ">" else {side})
            yield given.with_range(name, bound if way > 0 else lower, upper if way > 0 else bound, sides)


# --- where a formula has a value


def existence(value: Scalar) -> list[Demand]:
    """Arguments of inverse functions lie within their bounds, radicands are positive, denominators are not zero."""
    found = [] if value.den is ONE else [Demand(Scalar(value.den), "!=")]
    found += [Demand(Scalar(generator(i)), "!=") for m in value.num.terms for i, power in m if power < 0]
    for index in value.atoms():
        atom = atoms.atom(index)
        if atom.kind != "symbol":
            arg = atom.arg if isinstance(atom.arg, Scalar) else Scalar(atom.arg)
            bound = WITHIN.get(atom.kind)
            found += existence(arg) + ([] if bound is None else [Demand(bound(arg))])
    return found


WITHIN: Mapping[str, Callable[[Scalar], Scalar]] = {  # what is positive of an argument within the bounds of its function
    **dict.fromkeys(("root", "ln"), lambda arg: arg),
    **dict.fromkeys(("asin", "acos"), lambda arg: UNITY - arg * arg),
    **dict.fromkeys(("elliptic_k", "elliptic_e"), lambda arg: UNITY - arg),
}


# --- inverse functions


def _tangent(angle: Scalar) -> Scalar:
    """tan A, of numbers as sin 2A/(1 + cos 2A), which is known for more of them."""
    return sine(angle) / cosine(angle) if names_in(angle) - {"pi"} else sine(angle * 2) / (1 + cosine(angle * 2))


FORWARD = {"asin": sine, "acos": cosine, "atan": _tangent}
ENDS = {"asin": (-PI / 2, PI / 2), "atan": (-PI / 2, PI / 2), "acos": (NOTHING, PI)}


def _without_inverse(demand: Demand, given: Assumptions) -> Demand:
    """c asin x + r > 0 as x > sin(-r/c), where that is within the values of asin; 1 or -1 > 0 where it is beyond. With two of
    them, one is r."""
    inverse = sorted(i for i in demand.value.num.atoms() if atoms.atom(i).kind in FORWARD)
    parts = demand.value.num.by_power(inverse[0]) if len(inverse) in (1, 2) and demand.op != "!=" else {}
    if set(parts) - {0} != {1} or demand.value.den is not ONE:
        return demand
    kind, inner = atoms.atom(inverse[0]).kind, atoms.atom(inverse[0]).arg
    way = WAYS.get(sign(Scalar(parts[1]), given).kind)
    if way is None:
        return demand
    bound = short(-(Scalar(parts[0]) / Scalar(parts[1]))) if 0 in parts else NOTHING
    low, high = ENDS[kind]
    if sign(bound - high, given).is_nonnegative:
        return Demand(UNITY * -way)
    if sign(low - bound, given).is_nonnegative:
        return Demand(UNITY * way)
    if not (sign(bound - low, given).is_nonnegative and sign(high - bound, given).is_nonnegative):
        return demand
    gap = (inner if isinstance(inner, Scalar) else Scalar(inner)) - FORWARD[kind](bound)
    return Demand(short(neat(gap, given) * (-way if kind == "acos" else way)), demand.op)


# --- roots


def _without_roots(demand: Demand) -> list[Demand]:
    """A √x > 0 as A > 0 and x > 0, A x² > 0 as A > 0 and x ≠ 0, A √x ≠ 0 as A ≠ 0 and x > 0; else nothing."""
    powers = [(i, e) for i, e in demand.value.num.content()[1] if atoms.atom(i).kind == "root" or not e % 2]
    if not powers or demand.op == ">=" or demand.value.den is not ONE:
        return []
    rest = demand.value / Scalar(Poly({tuple(powers): 1}))
    roots = [Demand(atoms.atom(i).arg) for i, _ in powers if atoms.atom(i).kind == "root"]
    return [Demand(rest, demand.op), *roots, *(Demand(Scalar(generator(i)), "!=") for i, e in powers if not e % 2)]


def _squared(demand: Demand, given: Assumptions) -> list[Demand]:
    """A > B √x for B > 0 as A > 0 and A² > B² x; A + B √x > 0 for A ≤ 0 < B as B² x > A²; else nothing, as of √2."""
    for index in demand.value.num.atoms() if demand.op != "!=" else ():
        parts = {k: Scalar(part) for k, part in demand.value.num.by_power(index).items()}
        is_root = atoms.atom(index).kind == "root" and atoms.atom(index).arg.number() is None
        if is_root and set(parts) - {0} == {1} and demand.value.den is ONE:
            rest, root = parts.get(0, NOTHING), sign(parts[1], given)
            gap = rest**2 - parts[1] ** 2 * atoms.atom(index).arg
            if root.kind == "negative":
                return [Demand(rest, demand.op), Demand(gap, demand.op)]
            if root.kind == "positive" and sign(rest, given).kind in ("negative", "zero"):
                return [Demand(-gap, demand.op)]
    return []
