"""Relations that are equal to a given one by the way they are made; the decision must prove each."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rbpsym.claims.diagnosis import is_in_exponent, put, sites
from rbpsym.claims.ground import Ground
from rbpsym.expr import tree as t
from rbpsym.field.scalar import symbol

HALF_TURN = t.Div(t.Sym("pi"), t.TWO)
MULTIPLIERS = tuple(t.Num(n) for n in (2, 3, 5, 7, 4, 6, 9, 10, 12, 15, 16, 18, 20, 21, 24, 30))


def rewrites(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    """Equal relations without repetition: by their parts, then as a whole."""
    seen = {relation}
    for other in (*_by_parts(relation, ground), *_as_a_whole(relation, ground)):
        if other not in seen:
            seen.add(other)
            yield other


def _by_parts(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    speeds = _names_of_speeds(ground)
    for path, node in sites(relation):
        if not path or is_in_exponent(path) or _is_kept(path, node):
            continue
        if isinstance(node, t.Fn) and isinstance(node.arg, t.Sym) and ground.generator(node.arg.name) is None:
            continue
        for rule in PARTS.get(type(node), ()):
            for other in rule(node):
                yield put(relation, path, other)
        if isinstance(node, t.Sym) and node.name in speeds and path[-1][0] != "items":
            yield put(relation, path, t.Deriv(t.Sym(speeds[node.name])))


def _is_kept(path: tuple, node: t.Node) -> bool:
    """Paths of integrals, and symbols that are a whole side, stay as they are."""
    return path[-1][0] == "path" or (path[-1][0] == "items" and isinstance(node, (t.Sym, t.Vec, t.Word)))


def _names_of_speeds(ground: Ground) -> dict[str, str]:
    """ω for dθ/dt: names of speeds with the names of their coordinates."""
    scalars = ground.scope.scalars
    places = {found: name for name, found in scalars.items() if " " not in name}
    rates = ground.motion.scope.rates
    moving = {rates[q]: places[symbol(q)] for q in rates if symbol(q) in places}
    return {name: moving[found] for name, found in scalars.items() if found in moving}


def _as_a_whole(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    left, right = relation.items
    if relation.ops != ("=",) or _is_special(left, ground) or _is_special(right, ground):
        yield from _inside(relation, ground)
        return
    yield t.Chain((right, left), ("=",))
    for k in MULTIPLIERS:
        yield t.Chain((t.mul(k, left), t.mul(k, right)), ("=",))
    for k in MULTIPLIERS:
        yield t.Chain((t.Add((t.mul(k, left), t.neg(t.mul(k, right)))), t.ZERO), ("=",))


def _is_special(node: t.Node, ground: Ground) -> bool:
    return isinstance(node, t.Word) or (isinstance(node, (t.Sym, t.Vec)) and ground.kind(node.name) != "value")


def _inside(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    """k x/k for the sides that are no constant."""
    for place, node in enumerate(relation.items):
        if not _is_special(node, ground):
            for k in MULTIPLIERS:
                yield put(relation, (("items", place),), t.Div(t.Mul((k, t.Group(node))), k))
                yield put(
                    relation, (("items", place),), t.Add((t.mul(k, node), t.neg(t.mul(t.Num(k.value - 1), node))))
                )


def _turned_product(node: t.Mul) -> Iterator[t.Node]:
    yield t.Mul(node.factors[::-1])


def _expanded(node: t.Mul) -> Iterator[t.Node]:
    """a (b + c) = a b + a c"""
    for place, factor in enumerate(node.factors):
        inner = factor.arg if isinstance(factor, t.Group) else factor
        if isinstance(inner, t.Add):
            before, after = node.factors[:place], node.factors[place + 1 :]
            yield t.Add(tuple(t.Mul((*before, term, *after)) for term in inner.terms))


def _turned_sum(node: t.Add) -> Iterator[t.Node]:
    yield t.Add(node.terms[::-1])
    yield t.Neg(t.Add(tuple(t.neg(term) for term in node.terms)))


def _divided(node: t.Div) -> Iterator[t.Node]:
    yield t.Mul((t.Pow(t.Group(node.den), t.Num(-1)), node.num))
    yield t.Div(t.mul(t.Num(6), node.num), t.mul(t.Num(6), node.den))
    top = node.num.arg if isinstance(node.num, t.Group) else node.num
    if isinstance(top, t.Add):
        yield t.Add(tuple(t.Div(term, node.den) for term in top.terms))


def _multiplied_out(node: t.Pow) -> Iterator[t.Node]:
    if node.exponent == t.TWO and not isinstance(node.base, t.Vec):
        yield t.Mul((node.base, node.base))
        yield t.Div(t.Pow(node.base, t.Num(3)), node.base)


def _other_waves(node: t.Fn) -> Iterator[t.Node]:
    """cos x = sin(π/2 - x) = 1 - 2 sin²(x/2) = cos²(x/2) - sin²(x/2), sin x = 2 sin(x/2) cos(x/2)"""
    if node.name not in ("sin", "cos"):
        return
    other, half = ("cos" if node.name == "sin" else "sin"), t.Div(node.arg, t.TWO)
    sine, cosine = t.Fn("sin", half), t.Fn("cos", half)
    yield t.Fn(other, t.Group(t.Add((HALF_TURN, t.Neg(node.arg)))))
    if node.name == "sin":
        yield t.Group(t.Mul((t.TWO, sine, cosine)))
        yield t.Neg(t.Fn("sin", t.Group(t.Neg(node.arg))))
    else:
        yield t.Group(t.Add((t.ONE, t.Neg(t.Mul((t.TWO, t.Pow(sine, t.TWO)))))))
        yield t.Group(t.Add((t.Pow(cosine, t.TWO), t.Neg(t.Pow(sine, t.TWO)))))
        yield t.Fn("cos", t.Group(t.Neg(node.arg)))


def _split_number(node: t.Num) -> Iterator[t.Node]:
    if node.value:
        yield t.Div(t.Num(node.value * 4), t.Num(4))


def _turned_cross(node: t.Cross) -> Iterator[t.Node]:
    yield t.Neg(t.Cross(node.right, node.left))


def _turned_dot(node: t.Dot) -> Iterator[t.Node]:
    yield t.Dot(node.right, node.left)


def _turned_integral(node: t.Integral) -> Iterator[t.Node]:
    yield t.Neg(t.Integral(node.integrand, node.var, node.upper, node.lower))
    yield t.Mul((t.TWO, t.Integral(t.Div(node.integrand, t.TWO), node.var, node.lower, node.upper)))


def _doubled(node: t.Sym) -> Iterator[t.Node]:
    yield t.Div(t.Mul((t.TWO, node)), t.TWO)


PARTS: dict[type, tuple[Callable[..., Iterator[t.Node]], ...]] = {
    t.Mul: (_turned_product, _expanded),
    t.Add: (_turned_sum,),
    t.Div: (_divided,),
    t.Pow: (_multiplied_out,),
    t.Fn: (_other_waves,),
    t.Num: (_split_number,),
    t.Cross: (_turned_cross,),
    t.Dot: (_turned_dot,),
    t.Integral: (_turned_integral,),
    t.Sym: (_doubled,),
}
