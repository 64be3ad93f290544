"""What drops out of a result; on what it does not depend, why, and which way it goes with what it depends on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, proved, undecided
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Vector, depends_on, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.mechanics.system import Force
from rbpsym.proof.step import BodyRef
from rbpsym.quantities import MASS, NUMBER, Dimension
from rbpsym.remarks.result import CAUSED, Made, Result


def free_of(result: Result) -> Iterator[Made]:
    """The declared parameters that do not stand in it: by their dimensions where these leave no choice."""
    letter = result.name.name if isinstance(result.name, t.Sym) else ""
    own = [name for name in result.declared if letter.startswith(f"{name}_")]  # c_crit is a value of c
    absent = [name for name in result.declared if not depends_on(result.value, name) and name not in own]
    verdict = all_of(_is_free(result.value, name) for name in absent)
    sized = [name for name in absent if result.declared[name].dimension != NUMBER]
    is_number = len(sized) > 1 and _makes_no_number(sized, result)
    alone = sized if is_number else [name for name in absent if _is_only_mass(name, result)]
    rest = [name for name in absent if name not in alone]
    reason = "no_number" if is_number else "only_mass"
    for key, names in ((reason, alone), ("free_of", rest)):
        if names:
            slots = {"quantity": result.name, "names": [t.Sym(name) for name in names]}
            yield Made(f"remark.{key}", slots, verdict, ("free", *names))


def _is_free(value: Scalar, name: str) -> Verdict:
    """Its derivative vanishes, and twice the parameter leaves it what it was."""
    stays = is_zero(substitute(value, {name: symbol(name) * 2}) - value)
    return proved("its derivative vanishes") if is_zero(derivative(value, name)) and stays else undecided("it is not free of it")


def _is_only_mass(name: str, result: Result) -> bool:
    """Is it a mass, while the dimension of no other quantity that is given or moves holds one?"""
    problem = result.study.problem
    known = [*problem.parameters, *(coordinate.quantity for coordinate in problem.coordinates)]
    return result.declared[name].dimension == MASS and not any(q.dimension.mass for q in known if q.name != name)


def _makes_no_number(names: Sequence[str], result: Result) -> bool:
    """Are these all that have a dimension, so that no pure number can be made of them, and the result is one?"""
    problem = result.study.problem
    known = [*problem.parameters, *(coordinate.quantity for coordinate in problem.coordinates)]
    rest = [q for q in known if q.name not in names]
    found = [result.declared[name].dimension for name in names]
    return all(q.dimension == NUMBER for q in rest) and _rank(found) == len(found)


def _rank(dimensions: Sequence[Dimension]) -> int:
    """The number of independent ones, by elimination."""
    rows, rank = [[Fraction(d.mass), Fraction(d.length), Fraction(d.time)] for d in dimensions], 0
    for column in range(3):
        pivot = next((row for row in rows[rank:] if row[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        rows.insert(rank, pivot)
        rank += 1
        for k in range(rank, len(rows)):
            share = rows[k][column] / pivot[column]
            rows[k] = [a - share * b for a, b in zip(rows[k], pivot, strict=True)]
    return rank


def monotone(result: Result) -> Iterator[Made]:
    """With which parameters its size grows for all their values, and with which it falls."""
    ways = {name: _way(result, name) for name, q in result.declared.items() if q.sign == "positive"}
    grow, fall = ([t.Sym(name) for name, way in ways.items() if way == wanted] for wanted in ("positive", "negative"))
    key = {(True, True): "both", (True, False): "grows", (False, True): "falls"}.get((bool(grow), bool(fall)))
    if key:
        slots = {"quantity": result.name, "grow": grow, "fall": fall}
        told = ("monotone", *(f"{name}{way}" for name, way in ways.items() if way))
        yield Made(f"remark.{key}", slots, proved("the sign of its logarithmic derivative"), told)


def _way(result: Result, name: str) -> str:
    """The sign of the logarithmic derivative, "" where it is none for all values."""
    if not depends_on(result.value, name):
        return ""
    slope, start = short(derivative(result.value, name) / result.value), result.study.system.scope.start
    kind = sign(slope, result.given).kind
    begun = [substitute(value, start) for value in (slope, result.value)]
    if is_zero(begun[0]) and not is_zero(begun[1]):  # the range of a coordinate does not hold its start
        return ""
    return kind if kind in ("positive", "negative") else ""


def drops_out(result: Result) -> Iterator[Made]:
    """The forces of ideal constraints, together where they drop out for one reason."""
    study = result.study
    if result.step.rule not in CAUSED or names_in(result.value) & set(study.system.unknowns) or not study.system.independent:
        return  # where nothing is free, the forces themselves are what is found
    ideal = [name for name, is_ideal in study.dynamics.workless.items() if is_ideal and not _is_needed(name, result)]
    found: dict[tuple[str, ...], list[str]] = {}
    for name in ideal:
        found.setdefault(_reason(study.system.named(name), result), []).append(name)
    for reason in sorted(filter(None, found), key=lambda reason: ORDER.index(reason[0])):
        (key, *bodies), names = reason, found[reason]
        slots = {"forces": [t.Sym(name) for name in names], "bodies": [BodyRef(b) for b in bodies], "count": len(names)}
        yield Made(f"remark.{key}", slots, proved("its power vanishes, whatever it is"), ("silent", key, *names))


ORDER = ("pair_turning", "pair", "across", "fixed_point")  # what holds bodies together before what holds them up


def _is_needed(name: str, result: Result) -> bool:
    """Does another force go by it, as sliding friction goes by the normal force?"""
    own = {unknown for force in result.study.system.named(name) for unknown in force.unknowns}
    others = (force for force in result.study.system.forces if force.name != name)
    return any(own & names_in(part) for force in others for part in (force.vector.x, force.vector.y, force.couple))


def _reason(parts: list[Force], result: Result) -> tuple[str, ...]:
    """Why a force does no work: (what is said, its bodies); () where no short reason is found."""
    speeds = [_speed(part, result) for part in parts]
    bodies = [result.study.system.bodies[part.on] for part in parts]
    pushes = [part.vector for part in parts if part.vector]
    if len(parts) == 1 and not is_zero(parts[0].couple):
        return ()
    if len(parts) == 1:
        if speeds[0].vanishes():
            return ("fixed_point",)
        return ("across",) if is_zero(parts[0].vector.dot(speeds[0])) else ()
    if len(parts) != 2 or not is_zero(parts[0].couple + parts[1].couple):
        return ()
    if not pushes:
        return ("pair_turning", *sorted({p.on for p in parts})) if is_zero(bodies[0].omega - bodies[1].omega) else ()
    is_pair = (parts[0].vector + parts[1].vector).vanishes() and is_zero(parts[0].couple)
    return ("pair", *sorted({p.on for p in parts})) if is_pair and (speeds[0] - speeds[1]).vanishes() else ()


def _speed(part: Force, result: Result) -> Vector:
    """The velocity of the point of the body at which it acts."""
    state = result.study.system.bodies[part.on]
    return state.velocity + (part.point - state.center).turned() * state.omega

