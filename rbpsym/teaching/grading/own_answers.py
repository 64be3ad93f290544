"""Errors carried forward: what follows from the student's own earlier answers.

Guarded against trivial answers: an own answer counts only if it is wrong and valid, is not zero, no mere number where a
formula is asked for, and has the dimension of what was asked for. What follows from it is guarded in `formula` and
`number`: it must not vanish, and must have the dimension of the key.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from rbpsym.decide.dimensions import dimension_of
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import number
from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading.ground import GradingGround
from rbpsym.teaching.grading.judgement import Status
from rbpsym.teaching.grading.quantity import read_quantity
from rbpsym.teaching.grading.reading import read_all, read_formula
from rbpsym.teaching.model import BlanksKey, FollowOn, Item, NumberKey

if TYPE_CHECKING:
    from rbpsym.teaching.grading.desk import Case

ROUNDED = 0.01  # how far numbers that are put in may be rounded
NOT_VALID = frozenset({Status.EMPTY, Status.INVALID})


def own_formula(follow: FollowOn, case: Case) -> t.Node | None:
    """What follows from the student's own earlier formulas; None if none is wrong, or one is trivial."""
    sources = _sources(follow)
    if not _is_any_wrong(sources, case):
        return None
    found = {name: _own_tree(item, blank, name, case) for item, name, blank in sources}
    own = {name: tree for name, tree in found.items() if tree is not None and not found.keys() & t.names(tree)}
    return replaced(follow.formula, own) if len(own) == len(found) else None


def own_number(follow: FollowOn, key: NumberKey, case: Case) -> float | None:
    """What follows in SI units from the student's own earlier numbers or formulas."""
    given = {name: float(m.value) * read_unit(m.unit).factor for name, m in key.given.items()}
    sources = _sources(follow)
    try:
        if not _is_any_wrong(sources, case):
            return None
        found = {name: _own_value(item, blank, name, given, case) for item, name, blank in sources}
        own = {name: value for name, value in found.items() if value}
        if len(own) < len(found):
            return None
        problem = case.problem(_item(follow.item, case))
        return number(scalar(follow.formula, case.desk.ground(problem).scope), {**given, **own})
    except (RbpsymError, ZeroDivisionError):
        return None


def with_numbers_put_in(text: str, key: t.Node, item: Item, case: Case) -> bool:
    """Does an answer without some of the symbols agree with the key at the numbers of the paper, as far as numbers tell?"""
    ground, given = case.ground(item, key), case.worksheet.part_of(item.id).given
    numbers = {name: float(m.value) * read_unit(m.unit).factor for name, m in given.items()}
    for tree in _read(text, ground):
        try:
            own, right = scalar(tree, ground.scope), scalar(key, ground.scope)
            free = sorted((t.names(tree) | t.names(key)) - numbers.keys())
            states = [{**numbers, **{name: 0.3 + 0.17 * (k + n) for n, name in enumerate(free)}} for k in range(3)]
            pairs = [(number(own, state), number(right, state)) for state in states]
        except (RbpsymError, ZeroDivisionError):
            continue
        if t.names(tree) - {"pi"} < t.names(key) and all(abs(a - b) <= ROUNDED * abs(b) for a, b in pairs):
            return True
    return False


Source = tuple[str, str, int]  # (id of the item, name in the formula, blank)


def _sources(follow: FollowOn) -> tuple[Source, ...]:
    return ((follow.item, follow.name, follow.blank), *((item, name, 0) for item, name in follow.beside))


def _is_any_wrong(sources: tuple[Source, ...], case: Case) -> bool:
    """Is each of the earlier answers valid, and one of them wrong?"""
    found = {case.judged[item].status if item in case.judged else Status.EMPTY for item, _, _ in sources}
    return not found & NOT_VALID and found != {Status.RIGHT}


def _item(id: str, case: Case) -> Item:
    return next(item for item in case.worksheet.items if item.id == id)


def _own_text(item: Item, blank: int, case: Case) -> str:
    from rbpsym.teaching.grading.desk import blank_texts

    text = case.answers.get(item.id, "")
    return blank_texts(text, item.key, item.id, case.answers).get(blank or 1, "") if isinstance(item.key, BlanksKey) else text


def _own_tree(id: str, blank: int, name: str, case: Case) -> t.Node | None:
    """The student's own earlier formula for the symbol `name`, if it is none that makes all that follows trivial."""
    item = _item(id, case)
    if isinstance(item.key, NumberKey):
        return None
    left = getattr(item.key, "left", None)
    ground = case.ground(item, left, getattr(item.key, "value", None))
    found = [tree for tree in _read(_own_text(item, blank, case), ground) if _counts(tree, item, ground)]
    if not found:
        return None
    tree = found[0]
    is_square = isinstance(left, t.Pow) and left.base == t.Sym(name) and left.exponent == t.TWO
    return t.Sqrt(tree) if is_square else tree


def replaced(node: t.Node, by: Mapping[str, t.Node]) -> t.Node:
    """The tree with symbols replaced, all at once; of the root of a square (θ̇ from θ̇²) an even power has no root."""
    if isinstance(node, t.Sym):
        return t.Group(by[node.name]) if node.name in by else node
    root = by.get(node.base.name) if isinstance(node, t.Pow) and isinstance(node.base, t.Sym) else None
    if isinstance(node, t.Pow) and isinstance(root, t.Sqrt):
        power = number_of(node.exponent)
        if power is not None and power % 2 == 0:
            return t.Pow(t.Group(root.arg), t.Num(int(power) // 2))
    return t.mapped(node, lambda part: replaced(part, by))


def _read(text: str, ground: GradingGround) -> list[t.Node]:
    """The last sides of an answer, in each of the ways in which it can be read."""
    try:
        read = [read_formula(text, ground.book)]
    except RbpsymError:
        try:
            read = list(read_all(text, ground.book).trees)
        except RbpsymError:
            return []
    return [tree.items[-1] if isinstance(tree, t.Chain) else tree for tree in read]


def _counts(tree: t.Node, item: Item, ground: GradingGround) -> bool:
    """Is it no zero and no mere number, and of the dimension that is asked for?"""
    try:
        value = scalar(tree, ground.scope)
        fits = dimension_of(tree, ground.dimensions) == item.asked.dimension
    except (RbpsymError, ZeroDivisionError):
        return False
    return fits and bool(value) and value.number() is None


def _own_value(id: str, blank: int, name: str, given: Mapping[str, float], case: Case) -> float | None:
    """The student's own earlier number in SI units, or what the own earlier formula gives; None if it does not fit."""
    item = _item(id, case)
    if not isinstance(item.key, NumberKey):
        tree = _own_tree(id, blank, name, case)
        return None if tree is None else number(scalar(tree, case.ground(item).scope), given)
    typed = read_quantity(_own_text(item, blank, case), case.desk.language)
    unit = read_unit(item.key.measure.unit)
    if typed.unit is None:
        return typed.value * unit.factor
    return typed.si if typed.unit.dimension == unit.dimension else None
