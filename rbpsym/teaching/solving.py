"""How an answer is worked out at the student's numbers, and how it follows from the student's earlier ones.

The formula, the numbers put in, the result; for errors carried forward the quantities that were asked before are
left as symbols in the mechanics, and the same engine makes the later quantity of them: nothing is said by hand.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import combinations

from rbpsym.document.model import Block, Display, Inlines, Paragraph, Ref
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, atoms, substitute, symbol
from rbpsym.field.exponentials import with_squares
from rbpsym.mechanics.dynamics import reactions_by_acceleration
from rbpsym.mechanics.study import Study
from rbpsym.proof.draft import length
from rbpsym.quantities import DIMENSIONS, LENGTH, MASS, NUMBER
from rbpsym.statement.units import unit_of, unit_text
from rbpsym.teaching import bench as b
from rbpsym.teaching.bench import ProblemBench, formula_of
from rbpsym.teaching.distractors import shown
from rbpsym.teaching.lines import WEIGHTS, gist
from rbpsym.teaching.misconceptions.model import with_inertia
from rbpsym.teaching.model import FollowOn, Item, Measure
from rbpsym.teaching.ranges import measured
from rbpsym.teaching.situations import names_in
from rbpsym.teaching.target import REFUSALS, Target
from rbpsym.teaching.targets import axes
from rbpsym.teaching.wording import spoken

MOST_RELATIONS = 2
CASES = (MASS, NUMBER, DIMENSIONS["speed"], LENGTH)  # dimensions of constants that a check lets vanish
LONGEST = 120  # parts of a formula that is shown with numbers in the places of the names


def where_text(setting: b.ItemSetting) -> Inlines:
    """“ where θ = 40.0°”, if it is asked at a place."""
    place = setting.situation.place
    return () if place is None else spoken(setting.said, "ask.place", place=b.given_as(*place, setting.said.notation))


def hint(bench: b.ProblemBench, setting: b.ItemSetting, target: Target, level: int) -> Inlines:
    """With much help (level 0): the relations from which it follows."""
    if level or not target.step:
        return ()
    premises = [bench.derivation.step(id) for id in bench.derivation.step(target.step).reasons]
    kept = [s for s in premises if s.rule in WEIGHTS][-MOST_RELATIONS:]
    relations = [row for step in kept for row in gist(step.statement)]
    return spoken(setting.said, "hint.relations", relations=relations) if relations else ()


def worked(bench: b.ProblemBench, setting: b.ItemSetting, target: Target, value: float | None) -> Iterator[Block]:
    """Where the answer comes from, the formula and, if it is a number, the numbers put in."""
    if target.step:
        yield Paragraph(spoken(setting.said, "solution.from", step=Ref(f"{bench.name}.{target.step}")))
    formula = b.formula_of(bench, target)
    if value is None:
        yield Display(t.equation(target.left, formula), numbered=False)
    else:
        yield Display(numeric_line(bench, setting, target, value), numbered=False)
    yield Paragraph(_check(bench, setting, target))


def _check(bench: b.ProblemBench, setting: b.ItemSetting, target: Target) -> Inlines:
    """What it becomes where a constant vanishes; where no constant may, its unit."""
    case = bench.once(("case", target.id), lambda: _special_case(bench, target))
    if case is not None:
        name, formula = case
        slots = {"case": t.equation(t.Sym(name), t.ZERO), "formula": t.equation(target.left, formula)}
        return spoken(setting.said, "solution.case", **slots)
    unit = unit_text(unit_of(target.dimension, target.unit_name)) or "1"
    return spoken(setting.said, "solution.unit", unit=unit)


def _special_case(bench: b.ProblemBench, target: Target) -> tuple[str, t.Node] | None:
    """A constant and the shorter formula that is left without it: masses come before lengths, what is left before zero.

    That a product vanishes with one of its factors is no check, but for a coefficient.
    """
    value, problem = target.known(bench.study), bench.study.problem
    whole, found = length(formula_of(bench, target)), []
    for quantity in (q for q in problem.parameters if q.dimension in CASES and q.name in names_in(value)):
        try:
            left = shown(substitute(value, {quantity.name: NOTHING}), bench.study)
        except (*REFUSALS, RbpsymError):
            continue
        if length(left) < whole and (left != t.ZERO or quantity.dimension == NUMBER):
            found.append((left == t.ZERO, CASES.index(quantity.dimension), length(left), quantity.name, left))
    return min(found, key=lambda row: row[:-1])[-2:] if found else None


def numeric_line(bench: b.ProblemBench, setting: b.ItemSetting, target: Target, value: float) -> t.Node:
    """left = formula = formula with numbers = number with unit; a very long formula without the third of these."""
    formula = number_formula(bench, target)
    left = target.reading.left if target.reading else target.left
    result = b.word(measure_of(bench, target, value), setting.said.notation)
    given = b.numbers_at(setting.situation, number_names(bench, target))
    if not given or length(formula) > LONGEST:
        return t.equation(left, formula, result)
    numbers = {name: t.Group(b.word(measure, setting.said.notation)) for name, measure in given.items()}
    return t.equation(left, formula, t.renamed(formula, numbers), result)


def number_names(bench: b.ProblemBench, target: Target) -> frozenset[str]:
    """The names in the formula from which a target's number comes."""
    return bench.once(("names", target.id), lambda: frozenset(t.names(number_formula(bench, target))))


def number_formula(bench: b.ProblemBench, target: Target) -> t.Node:
    """The formula from which a target's number comes, as a function of the position alone."""
    return bench.once(("number", target.id), lambda: _number_formula(bench, target))


def _number_formula(bench: b.ProblemBench, target: Target) -> t.Node:
    along = target.along(bench.study)
    plain = b.formula_of(bench, target) if along is None else shown(along, bench.study)
    return target.reading.node(plain) if target.reading else plain


def measure_of(bench: b.ProblemBench, target: Target, value: float) -> Measure:
    """The number of a target as it is printed (`value` in SI units, before it is read off)."""
    value = target.reading.number(value) if target.reading else value
    return measured(value, b.asked_unit(target), b.ASKED_DIGITS)


# --- how a later answer follows from earlier ones, for errors carried forward
# The quantities that were asked before are left as symbols in the mechanics (a moment of inertia, an acceleration, a
# speed), and the same engine makes the later quantity of them: nothing is said by hand. Where several earlier
# answers matter, there is a way for each alone and for each of their combinations.


SOURCES = ("moment", "axis-moment", "acceleration", "speed")
TAILS = {"acceleration": "_ddot", "speed": "_dot"}
MOST_SOURCES = 3
Source = tuple[str, str]  # (id of the item, id of the quantity that it asks for)


def follow_ons(bench: ProblemBench, target: Target, before: Sequence[Item], kind: str) -> Iterator[FollowOn]:
    """The ways from earlier items of the same problem to a target; `kind` is “formula” or “number”."""
    sources = _sources(bench, target, before, kind)
    for chosen in (some for count in range(1, len(sources) + 1) for some in combinations(sources, count)):
        quantities = tuple(quantity for _, quantity in chosen)
        node = bench.once(("follow", target.id, kind, quantities), partial(_node, bench, target, quantities, kind))
        if node is not None:
            (first, quantity), *others = chosen
            beside = tuple((item, name_of(other)) for item, other in others)
            yield FollowOn(first, name_of(quantity), node, beside=beside)


def _sources(bench: ProblemBench, target: Target, before: Sequence[Item], kind: str) -> list[Source]:
    """The last item for each quantity that may matter."""
    kinds = ("formula",) if kind == "formula" else ("formula", "number")
    found: dict[str, str] = {}
    for item in before:
        quantity = item.asked.quantity
        fits = item.kind in kinds and item.asked.problem == bench.name and quantity.partition(".")[0] in SOURCES
        if fits and quantity != target.id:
            found[quantity] = item.id
    return [(item, quantity) for quantity, item in list(found.items())[-MOST_SOURCES:]]


def name_of(quantity: str) -> str:
    """The symbol that stands for an earlier answer: theta_ddot for acceleration.theta, a name of its own for a moment."""
    kind, _, name = quantity.partition(".")
    return f"{name}{TAILS[kind]}" if kind in TAILS else f"own.{quantity}"


def _node(bench: ProblemBench, target: Target, quantities: tuple[str, ...], kind: str) -> t.Node | None:
    """The target as a formula in the symbols of earlier answers; None if one of them does not matter."""
    supplied = {name_of(quantity) for quantity in quantities}
    asked = t.names(formula_of(bench, target)) if kind == "formula" else number_names(bench, target)
    try:
        study = _with_moments(bench.study, quantities)
        value = _value(study, target, supplied)
        if value is None:
            return None
        hidden = {n: square for n, square in study.squares.items() if f"{n}_dot" not in supplied | set(asked)}
        value = with_squares(value, hidden)
    except (*REFUSALS, RbpsymError):
        return None
    speeds = [name for name in supplied if name.endswith("_dot")]
    extra = {name for name in names_in(value) - supplied - set(asked) if name.endswith(("_dot", "_ddot"))}
    if extra or not supplied <= names_in(value) or not all(is_even(value, name) for name in speeds):
        return None
    node = shown(value, bench.study)
    return target.reading.node(node) if kind == "number" and target.reading else node


def _with_moments(study: Study, quantities: tuple[str, ...]) -> Study:
    """The mechanics in which the moments of inertia that were asked for are symbols."""
    for quantity in quantities:
        kind, _, body = quantity.partition(".")
        if kind in TAILS:
            continue
        own, state = symbol(name_of(quantity)), study.system.bodies[body]
        away = state.mass * axes(study)[body][1] if kind == "axis-moment" else None
        study = with_inertia(study, body, moment=own if away is None else own - away)
    return study


def _value(study: Study, target: Target, supplied: set[str]) -> Scalar | None:
    """The target in the state; an unknown force, or the square of a speed, by the accelerations that are supplied."""
    if target.kind == "speed":
        return _square(study, target.id.removeprefix("speed."), supplied)
    if target.kind != "reaction":
        return target.value(study)
    name, given = target.id.removeprefix("reaction."), study.dynamics.accelerations or {}
    if not any(acceleration in supplied for acceleration in given):
        return study.dynamics.reactions.get(name)
    value = reactions_by_acceleration(study.system).get(name)
    others = {key: found for key, found in given.items() if key not in supplied}
    return None if value is None else substitute(value, others)


def _square(study: Study, name: str, supplied: set[str]) -> Scalar | None:
    """q̇², gained in the measure in which the own acceleration is greater or smaller than the right one."""
    square, key = study.squares.get(name), f"{name}_ddot"
    actual = (study.dynamics.accelerations or {}).get(key)
    if square is None or key not in supplied or not actual:
        return square
    first = study.system.scope.start.get(f"{name}_dot", NOTHING)
    return first * first + (square - first * first) * (symbol(key) / actual)


def is_even(value: Scalar, name: str) -> bool:
    """Whether a value holds even powers of a name only (then the sense of a speed does not matter)."""
    index = atoms.intern("symbol", name)
    return all(not power % 2 for poly in (value.num, value.den) for power in poly.by_power(index))
