"""All that tasks about one problem share, worked out once: derivation, targets, wrong studies, numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence, Set
from typing import Any, TypeVar

from rbpsym.document.model import Inlines
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import Scalar, is_zero
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import Derivation, Step
from rbpsym.quantities import LENGTH, MASS, NUMBER, TIME, Dimension
from rbpsym.statement.model import Problem
from rbpsym.statement.units import unit_of
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.distractors import Pool, once, shown, without_noise
from rbpsym.teaching.model import AskedQuantity, Item, Measure
from rbpsym.teaching.ranges import NumberRange, default_ranges, measure_text, middles
from rbpsym.teaching.situations import Scenery, Situation, names_in
from rbpsym.teaching.spoilers import Content, claims, given, wanted
from rbpsym.teaching.target import Target

ASKED_DIGITS = 3
PHASE = "phase"  # phase2.acceleration.x is a quantity of the second one
GRAVITY = 9.81  # m/s²: sets the pace of what moves under its weight
T = TypeVar("T")


class ProblemBench(Frozen):
    """One problem of a worksheet, or a later phase of it (from 2). `targets` by id; `wishes` are ranges of numbers by name;
    `later` are those of the later phases."""

    derivation: Derivation
    targets: Mapping[str, Target]
    pool: Pool
    wishes: Mapping[str, NumberRange] = field(default_factory=dict)
    phase: int = 1
    later: tuple[ProblemBench, ...] = ()
    memo: dict[Hashable, Any] = field(default_factory=dict, compare=False, repr=False)

    def once(self, key: Hashable, make: Callable[[], T]) -> T:
        """What does not depend on the student, made when it is first asked for."""
        return once(self.memo, key, make)

    @property
    def study(self) -> Study:
        """The right mechanics."""
        return self.derivation.study

    @property
    def name(self) -> str:
        """The name of the problem, of a later phase as the labels of its steps begin."""
        return f"{self.study.problem.name}{'' if self.phase == 1 else f'.{PHASE}{self.phase}'}"

    @property
    def ids(self) -> list[str]:
        """The quantities that can be asked for, as wishes name them."""
        return [*self.targets, *(f"{PHASE}{bench.phase}.{id}" for bench in self.later for id in bench.targets)]

    @property
    def given(self) -> Content:
        """What the statement prints."""
        return self.once("given", lambda: given(self.study))

    def asked(self, target: Target) -> AskedQuantity:
        """What an item about a target asks for."""
        return AskedQuantity(self.name, target.id, target.left, target.dimension, target.step)

    def way_to(self, step: str, most: int) -> tuple[Step, ...]:
        """The steps that lead to a step, itself the last: by the graph, the nearest first, at most so many."""
        by_id = {s.id: s for s in self.derivation.steps}
        kept, front = [step], [step]
        while front and len(kept) < most:
            near = [p for id in front for p in needed(by_id[id]) if p not in kept]
            front = list(dict.fromkeys(near))[: most - len(kept)]
            kept += front
        order = [s.id for s in self.derivation.steps]
        return tuple(by_id[id] for id in sorted(kept, key=order.index))


def needed(step: Step) -> tuple[str, ...]:
    """The steps without which one does not follow: what is solved or put in is all there, of others what they tell of too."""
    own = tuple(id for id in step.reasons if id in step.premises)
    return own if own and step.rule in ("solution", "substitution") else step.reasons


class ItemSetting(Frozen):
    """One student's item in the making: words, numbers, draws, and the values of the prepared task."""

    said: Words
    situation: Situation
    scenery: Scenery
    draws: Draws
    id: str
    values: Sequence[float]
    before: tuple[Item, ...] = ()

Make = Callable[[ItemSetting], Item | None]


class Prepared(Frozen):
    """A task of which only numbers and the order of things are open.

    `values` are evaluated at each student's numbers; `make` gives the item, or None if these numbers do not do
    (two answers would look the same in print).
    """

    kind: str
    target: Target | None
    values: tuple[Scalar, ...]
    make: Make
    content: Content = field(default_factory=Content)
    step: str = ""  # what is asked about, if that is no target
    phase: str = ""  # before what is asked about, if it is of a later phase

    @property
    def kind_asked(self) -> str:
        """The kind of its quantity; "" for what is about none."""
        return self.target.kind if self.target else ""

    @property
    def about(self) -> tuple[str, ...]:
        """How a wish names it; () for what there is only one of."""
        return (f"{self.phase}{self.target.id if self.target else self.step}",) if self.target or self.step else ()


def evaluator(prepared: Iterable[Prepared]) -> Callable[[Mapping[str, float]], list[list[float]]]:
    """The values of all prepared tasks at some numbers, each task's in a list of its own."""
    tasks = tuple(prepared)
    whole = compiled([value for task in tasks for value in task.values])

    def evaluate(numbers: Mapping[str, float]) -> list[list[float]]:
        found, rows, at = whole(numbers), [], 0
        for task in tasks:
            own = found[at : at + len(task.values)]
            rows.append(own if task.kind == "signs" else without_noise(own))
            at += len(task.values)
        return rows

    return evaluate


def generic_state(bench: ProblemBench) -> dict[str, float]:
    """Numbers for coordinates, speeds, accelerations and forces that the paper leaves open, so that formulas can be told apart.

    They are of the size that the problem's own lengths and masses give them, so that no part of a sum is lost in another.
    """
    return bench.once("generic state", lambda: _generic_state(bench))


def _generic_state(bench: ProblemBench) -> dict[str, float]:
    study, middle = bench.study, middles({**default_ranges(bench.study), **bench.wishes})
    length, mass = (_typical(study.problem, middle, dimension) for dimension in (LENGTH, MASS))
    rate = math.sqrt(GRAVITY / length)
    found = {}
    for place, coordinate in enumerate(study.problem.coordinates):
        name, unit = coordinate.name, 1.0 if coordinate.quantity.dimension == NUMBER else length
        found[name] = unit * (0.43 + 0.29 * place)
        found[f"{name}_dot"] = unit * rate * (1.37 + 0.73 * place)
        found[f"{name}_ddot"] = -unit * rate**2 * (0.83 + 0.31 * place)
    return found | {name: mass * GRAVITY * (0.9 + 0.5 * place) for place, name in enumerate(study.system.unknowns)}


def _typical(problem: Problem, middle: Mapping[str, float], dimension: Dimension) -> float:
    """The geometric mean of the constants of a dimension; 1 if there are none."""
    sizes = [abs(middle[q.name]) for q in problem.parameters if q.dimension == dimension and middle.get(q.name)]
    return math.exp(sum(map(math.log, sizes)) / len(sizes)) if sizes else 1.0


def asks_for(bench: ProblemBench, target: Target) -> Content:
    """What a task asks that wants the value of a target: its formula, the step that shows it, and what is read off it."""
    step = (bench.derivation.step(target.step).statement,) if target.step else ()
    formula = formula_of(bench, target)
    read = (target.reading.node(formula), t.Sqrt(formula)) if target.reading else ()  # the period and the frequency are one
    return Content(asks=claims((t.equation(target.left, formula), *step)) | wanted(bench.study, [formula, *read]))


def formula_of(bench: ProblemBench, target: Target) -> t.Node:
    """The right value of a target as it is printed in answers."""
    return bench.once(("formula", target.id), lambda: shown(target.known(bench.study), bench.study))


def is_number(bench: ProblemBench, target: Target, scenery: Scenery) -> bool:
    """Whether a target is a number at the place that is asked about."""
    value = target.along(bench.study)
    return value is not None and not is_zero(value) and names_in(value) <= known_names(bench, scenery)


def known_names(bench: ProblemBench, scenery: Scenery) -> set[str]:
    """Names that have a number on the paper."""
    return set(scenery.ranges) | ({scenery.coordinate} if scenery.coordinate else set())


def asked_unit(target: Target) -> str:
    """The unit of a target as a number."""
    dimension = target.reading.dimension if target.reading else target.dimension
    name = target.unit_name if not target.reading else target.reading.unit_name
    if not name and dimension == NUMBER and target.kind == "loss":
        name = "angle"
    is_motion = target.kind in ("acceleration", "speed", "start", "given")
    if is_motion and not (dimension.length or dimension.mass) and dimension != TIME:
        return "rad/s^2" if dimension == TIME**-2 else "rad/s"
    return unit_of(dimension, name)


def sentence(bench: ProblemBench, step: Step, said: Words) -> Inlines:
    """Why a step is made, in the words of the notes; () where they say nothing (of forces: a table)."""
    tell = lambda: () if step.chapter == "forces" else Teller(said).sentence(step, step.phrase, **step.slots)  # noqa: E731
    return bench.once(("sentence", step.id, said.language), tell)


def word(measure: Measure, notation: Notation) -> t.Word:
    """A measure as a part of a formula."""
    return t.Word(measure_text(measure, notation.decimal))


def given_as(name: str, measure: Measure, notation: Notation) -> t.Node:
    """name = 2.50 m."""
    return t.equation(t.Sym(name), word(measure, notation))


def numbers_at(situation: Situation, names: Set[str]) -> dict[str, Measure]:
    """The printed numbers of some names, in the order of the paper."""
    return {name: measure for name, measure in situation.printed.items() if name in names}
