"""How an answer is worked out at the student's numbers: the formula, the numbers put in, the result."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import fields

from rbpsym.document.model import Block, Display, Inlines, Paragraph, Ref
from rbpsym.notation import tree as t
from rbpsym.teaching import bench as b
from rbpsym.teaching.distractors import shown, size
from rbpsym.teaching.lines import WEIGHTS, gist
from rbpsym.teaching.model import Measure
from rbpsym.teaching.targets import Target
from rbpsym.teaching.units import measured
from rbpsym.teaching.wording import spoken

# --- formulas into which each student's numbers are put: looked through once, then filled quickly


Fill = Callable[[Mapping[str, t.Node]], t.Node]


def filler(node: t.Node, names: Container[str]) -> Fill | None:
    """Puts a tree for each of these names into a formula; None if none of them is in it.

    >>> from rbpsym.notation.tree import Num, Sym, Mul
    >>> filler(Mul((Sym("m"), Sym("g"))), {"g"})({"g": Num(10)}) == Mul((Sym("m"), Num(10)))
    True
    """
    if isinstance(node, t.Sym):
        return (lambda given, name=node.name: given[name]) if node.name in names else None
    parts = {name: _of_part(getattr(node, name), names) for name in _inner(node)}
    changing = {name: fill for name, fill in parts.items() if fill is not None}
    if not changing:
        return None
    kept = {name: getattr(node, name) for name in _inner(node) if name not in changing}
    kind = type(node)
    return lambda given: kind(**kept, **{name: fill(given) for name, fill in changing.items()})


def _inner(node: t.Node) -> list[str]:
    return [item.name for item in fields(node) if item.name != "span"]


def _of_part(value: object, names: Container[str]) -> Callable | None:
    if isinstance(value, t.Node):
        return filler(value, names)
    if not isinstance(value, tuple) or not value or not isinstance(value[0], t.Node):
        return None
    row = [(part, filler(part, names)) for part in value]
    if all(fill is None for _, fill in row):
        return None
    return lambda given: tuple([part if fill is None else fill(given) for part, fill in row])


# ---


MOST_RELATIONS = 2
LONGEST = 120  # parts of a formula that is shown with numbers in the places of the names


def where_text(setting: b.Setting) -> Inlines:
    """“ where θ = 40.0°”, if it is asked at a place."""
    place = setting.situation.place
    if place is None:
        return ()
    return spoken(setting.said, "ask.place", place=b.given_as(*place, _notation(setting)))


def _notation(setting: b.Setting):
    return setting.said.notation


def hint(bench: b.Bench, setting: b.Setting, target: Target, level: int) -> Inlines:
    """With much help (level 0): the relations from which it follows."""
    if level or not target.step:
        return ()
    premises = [bench.derivation.step(id) for id in bench.derivation.step(target.step).reasons]
    kept = [s for s in premises if s.rule in WEIGHTS][-MOST_RELATIONS:]
    relations = [row for step in kept for row in gist(step.statement)]
    return spoken(setting.said, "hint.relations", relations=relations) if relations else ()


def label_of(bench: b.Bench, step: str) -> str:
    """The label under which the solution shows a step of a problem."""
    return f"{bench.name}.{step}"


def worked(bench: b.Bench, setting: b.Setting, target: Target, value: float | None) -> tuple[Block, ...]:
    """Where the answer comes from, the formula and, if it is a number, the numbers put in."""
    return tuple(_worked(bench, setting, target, value))


def _worked(bench: b.Bench, setting: b.Setting, target: Target, value: float | None) -> Iterator[Block]:
    if target.step:
        yield Paragraph(spoken(setting.said, "solution.from", step=Ref(label_of(bench, target.step))))
    formula = b.formula_of(bench, target)
    if value is None:
        yield Display(t.equation(target.left, formula), numbered=False)
        return
    yield Display(numeric_line(bench, setting, target, value), numbered=False)


def numeric_line(bench: b.Bench, setting: b.Setting, target: Target, value: float) -> t.Node:
    """left = formula = formula with numbers = number with unit; a very long formula without the third of these."""
    formula = number_formula(bench, target)
    left = target.reading.left if target.reading else target.left
    result = b.word(measure_of(bench, target, value), setting.said.notation)
    put_in = bench.once(("fill", target.id), lambda: _filler(bench, target, setting))
    if put_in is None:
        return t.equation(left, formula, result)
    given = b.numbers_at(setting.situation, number_names(bench, target))
    numbers = {name: t.Group(b.word(measure, setting.said.notation)) for name, measure in given.items()}
    return t.equation(left, formula, put_in(numbers), result)


def _filler(bench: b.Bench, target: Target, setting: b.Setting) -> Fill | None:
    formula = number_formula(bench, target)
    known = b.numbers_at(setting.situation, number_names(bench, target))
    return filler(formula, known) if size(formula) <= LONGEST else None


def number_names(bench: b.Bench, target: Target) -> frozenset[str]:
    """The names in the formula from which a target's number comes."""
    return bench.once(("names", target.id), lambda: frozenset(t.names(number_formula(bench, target))))


def number_formula(bench: b.Bench, target: Target) -> t.Node:
    """The formula from which a target's number comes, as a function of the position alone."""
    return bench.once(("number", target.id), lambda: _number_formula(bench, target))


def _number_formula(bench: b.Bench, target: Target) -> t.Node:
    along = target.along(bench.study)
    plain = b.formula_of(bench, target) if along is None else shown(along, bench.study)
    return target.reading.node(plain) if target.reading else plain


def measure_of(bench: b.Bench, target: Target, value: float) -> Measure:
    """The number of a target as it is printed (`value` in SI units, before it is read off)."""
    value = target.reading.number(value) if target.reading else value
    return measured(value, b.asked_unit(bench, target), b.ASKED_DIGITS)
