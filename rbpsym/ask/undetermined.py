"""What statics does not tell apart: friction of several contacts that all hold.

A body rests if some of the forces that keep it in balance stay within the limits of friction, each of which is linear in what is
left open: each lower bound of that is at most each upper one (Fourier's and Motzkin's elimination).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import permutations

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.errors import Indistinct, Undecided, there
from rbpsym.field import NOTHING, Poly, Scalar, depends_on, derivative, names_in, short, substitute, symbol
from rbpsym.frozen import replace
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.stability import essential
from rbpsym.mechanics.study import Study

MOST, HALF = 60, Fraction(1, 2)  # inequalities


def opened(study: Study, error: Indistinct) -> Study:
    """The same with forces of static friction left open until the equations of rest tell all others. Raises the error where
    these are not what they do not tell apart, or something moves."""
    system = study.system
    rough = [element["friction"] for element in system.problem.constraints if "limit" in element.values]
    name = next((name for name in reversed(rough) if name in error.free and name in system.unknowns), None)
    if name is None or system.independent:
        raise error
    forces = (replace(force, unknowns=tuple(n for n in force.unknowns if n != name)) for force in system.forces)
    other = study.of(replace(system, forces=tuple(forces)))
    try:
        known = other.dynamics
    except Indistinct as more:
        return opened(other, more)
    vars(other)["_dynamics"] = replace(known, reactions={**known.reactions, name: symbol(name)})
    return other


def left_open(study: Study) -> frozenset[str]:
    """The forces of static friction that are left open."""
    return frozenset(() if study.at_start else study.dynamics.reactions.keys() - {*study.system.unknowns})


def bearable(
    study: Study, held: Iterable[FrictionNeed], given: Assumptions, asked_for: str
) -> tuple[tuple[Scalar, ...], Assumptions, tuple[Demand, ...]]:
    """What must not be negative for the forces to be such as contacts and friction (`held`) can bear, with what is known and the
    case that is told, if there are several: that of the sample numbers, as far as it does not depend on what is asked for.
    Raises Undecided where it is not decided by conditions that all have to hold."""
    cases = dict[Scalar, Demand]()
    force = study.dynamics.reactions.__getitem__
    rows = [force(name) for element in study.problem.constraints for name in pushes(element)]
    for need in held:
        most = sum(map(force, need.normals), NOTHING) * there(need.limit)
        rows += [most + force(need.friction) * side for side in (-1, 1)]
    for name in left_open(study):
        lines = [(short(derivative(row, name)), short(substitute(row, {name: NOTHING}))) for row in rows]
        try:
            rows = _eliminated(lines, given)
        except Undecided:
            for a in (a for a, _ in lines if a and not sign(a, given).sense and not depends_on(a, asked_for)):
                way = 1 if floating(a, sample(study.problem, study.problem.example)) > 0 else -1
                cases.setdefault(essential(a, given), Demand(a * way))
            given = assuming(given, cases.values(), tighter=True, whole=True)
            rows = _eliminated(lines, given)
    return tuple(rows), given, tuple(cases.values())


def _eliminated(lines: Sequence[tuple[Scalar, Scalar]], given: Assumptions) -> list[Scalar]:
    rows = list(dict.fromkeys(row for row in _without(lines, given) if not sign(row, given).is_nonnegative))
    if len(rows) > MOST:
        raise Undecided(OPEN)
    return rows


OPEN = "whether forces that friction can bear keep it at rest is not decided by one condition"


def _without(lines: Sequence[tuple[Scalar, Scalar]], given: Assumptions) -> Iterator[Scalar]:
    """What a x + b ≥ 0 of all (a, b) ask for there to be such an x."""
    yield from (b for a, b in lines if not a)
    for (a, b), (c, d) in permutations([line for line in lines if line[0]], 2):
        signs = [sign(part, given).sense for part in (a, -c)]
        if -1 in signs:
            continue  # not a lower and an upper bound
        gap, open_ = short(a * d - c * b), [part for part, way in zip((a, -c), signs, strict=True) if not way]
        if _follows(gap, open_, given):
            continue
        if not all(_follows(gap, [-part], given) for part in open_):
            raise Undecided(OPEN)  # it is asked for in some cases only
        yield gap


def _follows(value: Scalar, known: Sequence[Scalar], given: Assumptions) -> bool:
    """Whether a value is sure not to be negative where what is known is not: at both ends to which that bounds a quantity in
    which the value is linear; or as a sum of multiples of what is known, and of what is positive."""
    if sign(value, given).is_nonnegative:
        return True
    for k, fact in enumerate(known):
        others = [*known[:k], *known[k + 1 :]]
        for name in sorted(names_in(fact)):
            gain, slope = short(derivative(value, name)), short(derivative(fact, name))
            way = 0 if depends_on(gain, name) or depends_on(slope, name) else sign(slope, given).sense
            ends = list(given.range_of(name)) if way else []
            ends = [NOTHING, *ends[1:]] if ends[:1] == [None] and given.sign_of(name) == "positive" else ends
            for side in {1: (0,), -1: (1,)}.get(way, ()):
                ends[side] = -substitute(fact, {name: NOTHING}) / slope
            turns = zip(ends, (-gain, gain), strict=bool(way))
            if way and all(_at_end(value, gone, name, end, others, given) for end, gone in turns):
                return True
        for m, c in value.num.terms.items():
            for n, e in fact.num.terms.items():
                share = short(Scalar(Poly({m: c})) / Scalar(Poly({n: e})) * Scalar(fact.den) / Scalar(value.den))
                parts = (1, HALF) if sign(share, given).sense > 0 else ()
                if any(_follows(short(value - fact * share * part), known[k + 1 :], given) for part in parts):
                    return True
    return False


def _at_end(value: Scalar, gain: Scalar, name: str, end: Scalar | None, known: Sequence[Scalar], given: Assumptions) -> bool:
    """The same at one end of the range of a name; where it has none, by what it gains on the way there."""
    if end is None:
        return _follows(gain, known, given)
    return _follows(short(substitute(value, {name: end})), [short(substitute(fact, {name: end})) for fact in known], given)
