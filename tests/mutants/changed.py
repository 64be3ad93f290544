"""Relations that are really different from a true one: another sign, number, exponent, function, limit, symbol.

Which of them are different is found with floating-point numbers on the motion, on a road of its
own; the exact decision must then refute each of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from rbpsym.claims.diagnosis import is_in_exponent, put, sites, terms
from rbpsym.claims.diagnosis_numbers import Numbers, Sample, samples
from rbpsym.claims.ground import EqualityQuestion, Ground
from rbpsym.claims.integrals import prepared, valued
from rbpsym.errors import NoNumber, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field.vector import Space
from rbpsym.mechanics.numbers import number

DIFFERENT = 1e-5
COEFFICIENTS = tuple(
    Fraction(n, d)
    for n, d in (
        (2, 1),
        (1, 2),
        (3, 1),
        (-1, 1),
        (3, 2),
        (2, 3),
        (4, 1),
        (1, 3),
        (5, 1),
        (-2, 1),
        (1, 4),
        (6, 1),
        (7, 1),
        (1, 7),
        (5, 2),
        (8, 1),
        (9, 1),
        (10, 1),
        (11, 1),
        (1, 6),
        (12, 1),
        (-3, 1),
        (13, 1),
    )
)


def mutants(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    """Different relations without repetition, the likeliest slips first."""
    seen = {relation}
    for rule in RULES:
        for other in rule(relation):
            if other not in seen:
                seen.add(other)
                yield other
    yield from _replaced_zero(relation)
    yield from _spoiled(relation, ground)


def _signs(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in terms(relation):
        yield put(relation, path, t.neg(node))


def _functions(relation: t.Chain) -> Iterator[t.Chain]:
    swap = {"sin": "cos", "cos": "sin"}
    for path, node in sites(relation):
        if isinstance(node, t.Fn) and node.name in swap:
            yield put(relation, path, replace(node, name=swap[node.name]))


def _exponents(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in sites(relation):
        if isinstance(node, t.Pow) and isinstance(node.exponent, t.Num) and not _is_vectorial(node.base):
            for step in (1, -1):
                yield put(relation, path, t.power(node.base, node.exponent.value + step))
        elif isinstance(node, t.Sym) and not is_in_exponent(path) and path[-1][0] in ("factors", "num", "den"):
            yield put(relation, path, t.Pow(node, t.TWO))


def _is_vectorial(node: t.Node) -> bool:
    return any(isinstance(part, (t.Vec, t.Unit)) for _, part in sites(node))


def _dropped(relation: t.Chain) -> Iterator[t.Chain]:
    """A term or a factor left out (a dropped I_cm is one of them)."""
    for path, node in sites(relation):
        if path and path[-1][0] == "terms":
            yield put(relation, path, t.ZERO)
        elif path and path[-1][0] == "factors" and not _is_vectorial(node):
            yield put(relation, path, t.ONE)


def _numbers(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in sites(relation):
        if isinstance(node, t.Num) and node.value and not is_in_exponent(path):
            for step in (1, 2):
                yield put(relation, path, t.Num(node.value + step))


def _limits(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in sites(relation):
        if isinstance(node, t.Integral):
            yield put(relation, path, replace(node, lower=node.upper, upper=node.lower))
            yield put(relation, path, replace(node, lower=t.ZERO))


def _crossed(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in sites(relation):
        if isinstance(node, t.Cross):
            yield put(relation, path, replace(node, left=node.right, right=node.left))


def _symbols(relation: t.Chain) -> Iterator[t.Chain]:
    names = sorted({node.name for _, node in sites(relation) if isinstance(node, t.Sym)})
    for path, node in sites(relation):
        if isinstance(node, t.Sym) and path[-1][0] != "path":
            yield from (put(relation, path, t.Sym(other)) for other in names if other != node.name)


def _multiplied(relation: t.Chain) -> Iterator[t.Chain]:
    for path, node in terms(relation):
        for factor in COEFFICIENTS:
            yield put(relation, path, t.mul(t.Num(factor), node))


def _reversed(relation: t.Chain) -> Iterator[t.Chain]:
    """a < b turned round, or made an equation."""
    turned = {"<": (">", ">=", "="), ">": ("<", "<=", "="), "<=": (">",), ">=": ("<",)}
    for op in turned.get(relation.ops[0], ()):
        yield t.Chain(relation.items, (op,))


RULES: tuple[Callable[[t.Chain], Iterator[t.Chain]], ...] = (
    _signs,
    _functions,
    _exponents,
    _dropped,
    _crossed,
    _limits,
    _reversed,
    _symbols,
    _numbers,
    _multiplied,
)


def _spoiled(relation: t.Chain, ground: Ground) -> Iterator[t.Chain]:
    """A side times a power of something that moves."""
    for place, node in enumerate(relation.items):
        if isinstance(node, t.Word) or node == t.ZERO:
            continue
        for name in ground.motion.scope.start:
            for exponent in range(1, 11):
                yield put(relation, (("items", place),), t.mul(t.power(t.Sym(name), exponent), node))


def _replaced_zero(relation: t.Chain) -> Iterator[t.Chain]:
    """Something else in place of a 0, in multiples of what the setting knows."""
    if t.ZERO not in relation.items:
        return
    place = relation.items.index(t.ZERO)
    vector = _is_vectorial(relation.items[1 - place])
    for factor in range(1, 30):
        new = t.mul(t.Num(factor), t.Unit("z")) if vector else t.Num(factor)
        yield put(relation, (("items", place),), new)


def is_different(relation: t.Chain, ground: Ground, depth: str = "") -> bool:
    """Do numbers show a state of the motion in which the relation does not hold?"""
    question = EqualityQuestion(ground, depth)
    looks = samples(question, 3)
    try:
        if (varying := _side_of_constant(relation, ground)) is not None:
            return _varies(varying, ground, question)
        if question.motion.is_free and any(isinstance(node, t.Delta) for _, node in sites(relation)):
            return _drifts(relation, ground, question, looks)
        ready = t.Chain(tuple(prepared(item, ground) for item in relation.items), relation.ops)
        return any(_fails(ready, look) for look in looks) or (
            bool(looks) and looks[0].gap(ready) is None and _drifts(relation, ground, question, looks)
        )
    except (RbpsymError, ArithmeticError):
        return False


def _side_of_constant(relation: t.Chain, ground: Ground) -> t.Node | None:
    """The side that is said to be constant."""
    for one, other in (relation.items, relation.items[::-1]):
        if isinstance(one, t.Word) or (isinstance(one, t.Sym) and ground.kind(one.name) == "constant"):
            return other
    return None


def _varies(node: t.Node, ground: Ground, question: EqualityQuestion) -> bool:
    found, numbers = valued(node, ground), Numbers(7)
    parts = found.components() if isinstance(found, Space) else (found,)
    rates = [question.seen(question.rate(part), "motion") for part in parts]
    return any(abs(number(rate, numbers)) > DIFFERENT for rate in rates if rate)


def _fails(relation: t.Chain, look: Sample) -> bool:
    """Is the relation false in one state?"""
    gap = look.gap(relation)
    if gap is None or relation.ops[0] == "=":
        return gap is not None and gap > DIFFERENT
    if not _is_in_range(look):
        return False
    left, right = (look.gap(t.Chain((item, t.ZERO), ("=",))) for item in relation.items)
    return None not in (left, right) and _is_false(relation, look)


def _is_in_range(look: Sample) -> bool:
    """Do the numbers keep the declared ranges? Inequalities hold only there."""
    try:
        ranges = look.question.motion.assumptions.ranges.items()
        return all(
            (low is None or number(low, look.numbers) < look.numbers[name])
            and (high is None or look.numbers[name] < number(high, look.numbers))
            for name, (low, high) in ranges
        )
    except NoNumber:
        return False


def _is_false(relation: t.Chain, look: Sample) -> bool:
    from rbpsym.claims.diagnosis_numbers import value

    left, right = (value(item, look) for item in relation.items)
    apart = right - left if relation.ops[0] in ("<", "<=") else left - right
    return apart < -DIFFERENT


def _drifts(relation: t.Chain, ground: Ground, question: EqualityQuestion, looks: list[Sample]) -> bool:
    """Where a value has no closed form: do the sides differ at the start, or in their rates in a state of the motion?"""
    if relation.ops != ("=",):
        return False
    a, b = (valued(item, ground) for item in relation.items)
    pairs = zip(*(x.components() if isinstance(x, Space) else (x,) for x in (a, b)), strict=True)
    numbers = looks[0].numbers if looks else Numbers(7)
    for x, y in pairs:
        begin = question.begin(x) - question.begin(y)
        rate = question.seen(question.rate(x - y), "start")
        if any(abs(number(part, numbers)) > DIFFERENT for part in (begin, rate) if part):
            return True
    return False
