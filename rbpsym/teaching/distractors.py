"""Wrong answers that may stand beside a right one.

A value that a misconception gives is accepted only if it is REFUTED (with a witness) against the right
value and against every other that was accepted, and has the dimension of the right one. That it also
differs at a student's printed numbers is seen to when these are drawn (`distinct`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from typing import Any, TypeVar

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.equal import FIRST_POINTS, find_witness, scalars_equal
from rbpsym.decide.rooted import neat
from rbpsym.errors import LimitError, RbpsymError, Undecided
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, at_most, atoms, has_roots, same, spend
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.draft import length
from rbpsym.proof.step import Derivation
from rbpsym.quantities import Dimension
from rbpsym.statement.model import Problem
from rbpsym.teaching.misconceptions.model import Misconception, Site
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.misconceptions.told import is_asked_of, is_true
from rbpsym.teaching.model import Measure, Slip
from rbpsym.teaching.retold import Retelling, first_wrong
from rbpsym.teaching.target import Target

MOST = 8  # wrong values that are kept for one quantity
MOST_IDEAS = 2  # that are named for one wrong value
ANY = ("question", "start")  # targets that may be about all that misconceptions change
MOST_PRODUCTS = 400_000  # products of terms for one wrong value; the library's greatest takes a twentieth of it
LONGEST = 3.0  # times the length of the right formula: a longer one gives itself away


T = TypeVar("T")


def once(memo: dict[Hashable, Any], key: Hashable, make: Callable[[], T]) -> T:
    """What was made for this key, made when it is first asked for."""
    if key not in memo:
        memo[key] = make()
    found: T = memo[key]
    return found


class Wrong(Frozen):
    """A study with a misconception at one site of a problem."""

    misconception: Misconception
    site: Site
    study: Study


class Distractor(Frozen):
    """A wrong value with the slip that makes it; `along` its value as a function of the position alone, if known."""

    slip: Slip
    value: Scalar
    formula: t.Node
    along: Scalar | None
    study: Study


class Pool(Frozen):
    """The wrong studies of a problem, each made once; what a target makes of them."""

    derivation: Derivation
    wrongs: tuple[Wrong, ...]
    memo: dict[Hashable, Any] = field(default_factory=dict)
    given_up: set[int] = field(default_factory=set)

    def of(self, target: Target) -> tuple[Distractor, ...]:
        """Accepted wrong values of a target, the best first."""
        return once(self.memo, target.id, lambda: tuple(_accepted(self, target)))

    def retold(self, place: int) -> Retelling:
        """The derivation with a wrong study, each chapter written once."""
        return once(self.memo, ("retold", place), lambda: Retelling(self.wrongs[place].study))

    def slip(self, place: int) -> Slip:
        """The slip of a wrong study, with the first step that it spoils."""
        return once(self.memo, ("slip", place), lambda: self._slip(self.wrongs[place]))

    def _slip(self, wrong: Wrong) -> Slip:
        own = wrong.misconception
        later = own.about <= {*ANY}  # a blow spoils no step of the first phase
        first = "" if later else first_wrong(self.derivation, wrong.study, own.about)
        return Slip(own.name, wrong.site.slots, first, self.derivation.step(first).statement if first else None)


def pool(derivation: Derivation, names: Iterable[str] = ()) -> Pool:
    """All wrong studies that apply to a problem (those of some misconceptions only, if they are named)."""
    wanted = set(names) or set(MISCONCEPTIONS)
    found: list[Wrong] = []
    for name, misconception in MISCONCEPTIONS.items():
        found += _applied(misconception, derivation.study) if name in wanted else []
    return Pool(derivation, tuple(found))


def in_phase(first: Pool, derivation: Derivation, number: int) -> Pool:
    """That of a later phase: what is wrong in it, and what a wrong statement of the whole motion makes of it."""
    whole, own = first.derivation.study.problem, pool(derivation)
    stated = ((wrong, wrong.study.problem) for wrong in first.wrongs)
    restated = [each for each in stated if each[1] != whole and len(each[1].coordinates) == len(whole.coordinates)]
    begun = [replace(wrong, study=study) for wrong, problem in restated for study in _reached(problem, number)]
    return replace(own, wrongs=(*own.wrongs, *begun))


def _reached(problem: Problem, number: int) -> Iterator[Study]:
    """The mechanics of the phase of that number (from 1), if the motion comes to it."""
    with suppress(RbpsymError, ZeroDivisionError), at_most(MOST_PRODUCTS):
        yield stages(problem)[number - 1].study


def _applied(misconception: Misconception, study: Study) -> Iterator[Wrong]:
    with suppress(RbpsymError, ZeroDivisionError):  # a site that needs what this problem has not
        for site in misconception.sites(study):
            yield from _made(misconception, site) if is_true(misconception.name, study, site) else ()


def _made(misconception: Misconception, site: Site) -> Iterator[Wrong]:
    with suppress(RbpsymError, ZeroDivisionError):
        with at_most(MOST_PRODUCTS):
            made = Wrong(misconception, site, site.wrong())
        yield made


def bounded(pool: Pool, place: int, call: Callable[[], Scalar | None]) -> Scalar | None:
    """A value of a wrong study; None, then and ever after, if the study takes too long to work out."""
    if place in pool.given_up:
        return None
    try:
        with at_most(MOST_PRODUCTS):
            found = call()
            spend(0)  # a target takes a limit for a value that there is not
            return found
    except LimitError:
        pool.given_up.add(place)
        return None


def _accepted(pool: Pool, target: Target) -> Iterator[Distractor]:
    """In order of likeness: those about this kind of quantity, then those that look like the right formula, first."""
    study = pool.derivation.study
    right = target.value(study)
    if right is None:
        return
    kept: list[Distractor] = []
    for place, value, formula in _candidates(pool, target, right):
        twin = next((k for k, other in enumerate(kept) if same(value, other.value)), None)
        if twin is not None:
            kept[twin] = _with_another(kept[twin], pool, place)
        elif len(kept) < MOST and all(is_refuted(value, other, study.assumptions) for other in (right, *(d.value for d in kept))):
            wrong = pool.wrongs[place].study
            along = bounded(pool, place, partial(target.along, wrong, value))
            kept.append(Distractor(pool.slip(place), value, formula, along, wrong))
    yield from kept


def _with_another(found: Distractor, pool: Pool, place: int) -> Distractor:
    """The same wrong value with another idea that leads to it, as long as all are soon read."""
    slip = found.slip
    if len(slip.also) + 1 == MOST_IDEAS:
        return found
    return replace(found, slip=replace(slip, also=(*slip.also, pool.slip(place))))


def is_refuted(a: Scalar, b: Scalar, assumptions: Assumptions) -> bool:
    """Whether two values are REFUTED to be equal: by a witness among the first points, else by the whole decision."""
    if a == b:
        return False
    with suppress(LimitError, Undecided, ZeroDivisionError):
        if find_witness(a, b, assumptions, most=FIRST_POINTS) is not None:
            return True
    return scalars_equal(a, b, assumptions).is_refuted


def _candidates(pool: Pool, target: Target, right: Scalar) -> list[tuple[int, Scalar, t.Node]]:
    study, found = pool.derivation.study, []
    own, moving = length(shown(right, study)), speeds_in(right)
    seen: dict[str, int] = {}
    for place, wrong in enumerate(pool.wrongs):
        if target.kind not in (*wrong.misconception.about, *ANY) or not is_asked_of(wrong.misconception.name, target):
            continue
        value = bounded(pool, place, partial(target.value, wrong.study))
        if value is None or speeds_in(value) - moving:
            continue
        formula = shown(value, study)
        if length(formula) > LONGEST * own + 6 or not fits(formula, study, target.dimension):
            continue
        again = seen[wrong.misconception.name] = seen.get(wrong.misconception.name, -1) + 1
        general = len(wrong.misconception.about)  # what is said of few kinds of quantities says more of each
        found.append(((again, general, abs(length(formula) - own) > own / 2, place), value, formula))
    return [(rank[-1], value, formula) for rank, value, formula in sorted(found, key=lambda item: item[0])]


def shown(value: Scalar, study: Study) -> t.Node:
    """A value as it is printed: right and wrong ones in the same way."""
    return present(neat(value, study.assumptions) if has_roots(value) else value, study.style, factor=True)


def speeds_in(value: Scalar) -> set[str]:
    """Speeds, accelerations and unknown forces that a value holds."""
    named = (atoms.symbol_name(index) for index in value.atoms())
    return {name for name in named if name and name.endswith(("_dot", "_ddot"))}


def fits(formula: t.Node, study: Study, dimension: Dimension) -> bool:
    """Whether a formula is dimensionally sound and of this dimension (zero has every one)."""
    if formula == t.ZERO:
        return True
    with suppress(RbpsymError):
        return dimension_of(formula, study.problem.dimensions) == dimension
    return False


NOISE = 1e-9  # of the largest: less than that is rounding, and stands for zero
NOTHING_AT_ALL = 1e-11  # in SI units: below anything that a class measures


def without_noise(values: Sequence[float]) -> list[float]:
    """The values, with 0 for those that only rounding keeps from being it."""
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    least = max(NOISE * largest, NOTHING_AT_ALL)
    return [0.0 if abs(value) < least else value for value in values]


def apart(a: Measure, b: Measure) -> bool:
    """Whether two printed numbers differ by more than one per cent (so that rounding can't make them equal)."""
    difference = abs(a.value - b.value)
    return difference * 100 > max(abs(a.value), abs(b.value))
