"""The remarks on the results of a derivation: in a fixed order of what matters, each of them once in a text.

What drops out, and because of which pair of forces; what the result does not depend on; what it would be without an
interaction; what it becomes where something is small; which way it goes with its parameters. docs/remarks.md tells the rule.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from rbpsym.ask.finding import checked
from rbpsym.ask.limits import SMALL, leading, squeezed
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import divisors
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, proved, undecided
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import ZERO
from rbpsym.field import NOTHING, Scalar, Vector, at_most, depends_on, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.present.forms import present
from rbpsym.proof.assertions import told
from rbpsym.proof.step import BodyRef, Certificate, Derivation, Step
from rbpsym.quantities import LENGTH, MASS, NUMBER, Dimension, Quantity
from rbpsym.statement.references import unused

STRENGTHS: Mapping[str, str] = {
    "spring": "stiffness",
    "torsion-spring": "stiffness",
    "damper": "coefficient",
    "rotary-damper": "coefficient",
    "pull": "size",
    "contact": "coefficient",
}  # of interactions, and of the friction of a contact: the value with which they disappear


def without(result: BoxedResult) -> Iterator[Made]:
    """What it would be without an interaction or without sliding friction, whose strength goes to zero."""
    elements = (*result.study.problem.interactions, *result.study.problem.constraints)
    strengths = [element.values.get(STRENGTHS.get(element.kind, "")) for element in elements]
    for element, strength in zip(elements, strengths, strict=True):
        name = strength.name if isinstance(strength, t.Sym) else ""
        force = element.values.get("friction") or element.name
        if name in result.declared and _disappears(force, name, result):
            alone = strengths.count(strength) == 1  # else others disappear with it
            yield from _limit(result, name, *(("remark.without", {"force": t.Sym(force)}) if alone else ("remark.small", {})))


def _disappears(force: str, name: str, result: BoxedResult) -> bool:
    """Are all parts of the force zero where its strength is?"""
    parts = (part for f in result.study.system.named(force) for part in (f.vector.x, f.vector.y, f.couple))
    return all(is_zero(substitute(part, {name: NOTHING})) for part in parts)


def small(result: BoxedResult) -> Iterator[Made]:
    """What it becomes where a length or a mass is small against another one in it."""
    kinds = {name: q.dimension for name, q in result.declared.items() if q.sign == "positive" and depends_on(result.value, name)}
    for name, dimension in sorted(kinds.items(), key=lambda pair: pair[1] != LENGTH):  # a body's size before its mass
        others = [other for other, kind in kinds.items() if kind == dimension and other != name]
        if dimension not in (LENGTH, MASS) or not others:
            continue
        if len(others) == 1 and dimension == MASS:
            yield from _limit(result, name, "remark.much", {"great": t.Sym(others[0])})
        else:
            yield from _limit(result, name, "remark.small", {})


def _limit(result: BoxedResult, name: str, key: str, slots: Mapping[str, object]) -> Iterator[Made]:
    """The limit where it is finite and not zero, and still a function of the same coordinates."""
    if not depends_on(result.value, name) or squeezed(result.value, name, NOTHING, result.given):
        return
    if any(depends_on(value, name) and _turns_negative(value, name, result.given) for value in result.kept):
        return  # with a friction couple C no bucket sinks for m -> 0, where m g R > C
    found = leading(result.value, name, NOTHING, result.given)
    moving = {*result.study.system.scope.rates, *(c.name for c in result.study.problem.coordinates)}
    if found is None or found.order != 0 or moving & (names_in(result.value) - names_in(found.coefficient)):
        return
    if any(not sign(one, result.given).is_nonzero for one in {*divisors(found.coefficient)} - {*divisors(result.value)}):
        return  # where this vanishes the limit is another one
    if isinstance(result.name, t.Pow) and sign(found.coefficient, result.given).sense < 0:
        return  # no square has it: what it told of, an oscillation, is none there
    given = result.given.with_signs({SMALL: "positive"})
    data: dict[str, Any] = {"value": found.image, "name": SMALL, "order": 0, "coefficient": found.coefficient, "given": given}
    verdict = checked("limit", **data)["verdict"]
    value = present(neat(found.coefficient, result.given), result.study.style, factor=True)
    yield Made(key, {"quantity": result.name, "name": t.Sym(name), "value": value, **slots}, verdict, (key, name))


def _turns_negative(value: Scalar, name: str, given: Assumptions) -> bool:
    found = leading(value, name, NOTHING, given)
    return found is not None and sign(found.coefficient, given).kind == "negative"


MOST: Mapping[str, int | None] = {"brief": 2, "standard": 3, "full": None}  # remarks on a result
AT_ONE = "remark.free_of"  # without a reason: they say so of one result only, the first
MOST_PRODUCTS = 100_000


def remarks(derivation: Derivation, detail: str) -> list[dict[str, list[Step]]]:
    """The sentences about each result by the id of its step, for each phase; what is refuted or not decided is not said."""
    before: set[object] = set()
    parts = (derivation, *(phase.derivation for phase in derivation.phases))
    return [{found.step.id: list(_chosen(found, detail, before)) for found in results(part)} for part in parts]


def _chosen(result: BoxedResult, detail: str, before: set[object]) -> Iterator[Step]:
    is_short, count = detail != "full", 0
    for kind in KINDS:
        for made in () if kind in before else guarded(kind, result):
            step = made.said()
            if not step.phrase or made.about in before or count == MOST[detail] or (is_short and step.phrase in before):
                continue
            before.add(made.about)
            count += 1
            yield step
            if is_short and kind in ONCE:
                before.add(kind)
                break
            before |= {AT_ONE} & {step.phrase}


def guarded(kind: Callable[[BoxedResult], Iterable[Made]], result: BoxedResult) -> list[Made]:
    """What cannot be decided is not said."""
    try:
        with at_most(MOST_PRODUCTS):
            return list(kind(result))
    except (RbpsymError, ZeroDivisionError):
        return []


# --- result of a derivation as a quantity with its value, for what is to be said of it


class Made(Frozen):
    """key and slots of its phrase; `about`: what it says, so that it is said once in a text."""

    key: str
    slots: Mapping[str, Any]
    verdict: Verdict
    about: tuple[str, ...]

    def said(self) -> Step:
        """As a step with a sentence that is true: none if it is not proved."""
        certificate = Certificate(("remark",), self.verdict)
        return told(Step("remark", "remark", ZERO, "remarks", self.key, self.slots, certificate=certificate))


BALANCES = ("conservation", "work", "asked")  # rules of results that relate quantities, and give none
CAUSED = ("solution", "first_integral")  # those of how the system moves


class BoxedResult(Frozen):
    """A boxed step that gives a quantity: its name as it is printed, its value."""

    step: Step
    study: Study
    name: t.Node
    value: Scalar
    kept: tuple[Scalar, ...] = ()  # what is not negative as long as the derivation holds

    @property
    def given(self) -> Assumptions:
        """What is declared of the letters."""
        return self.study.assumptions

    @cached_property
    def declared(self) -> Mapping[str, Quantity]:
        """The parameters that the author declares and uses, by name; starts are none of them."""
        problem = self.study.problem
        begun = {name for value in self.study.system.scope.start.values() for name in names_in(value)}
        left_out = {*problem.implicit, *begun, *unused(problem)}
        return {q.name: q for q in problem.parameters if q.name not in left_out}


def results(derivation: Derivation) -> Iterator[BoxedResult]:
    """The results of a derivation that give a quantity which is not zero, as a function of the place or of the state."""
    certificates = (step.certificate for step in derivation.steps if step.certificate)
    duties = (duty.relation for certificate in certificates for duty in certificate.verdict.open_obligations)
    chains = (node for node in duties if isinstance(node, t.Chain))
    signs = {node.items[0] for node in chains if node.ops[0] in (">", ">=") and node.items[-1] == ZERO}
    kept = tuple(value for value in map(derivation.letters.value, signs) if isinstance(value, Scalar))
    kept += tuple(one.value for side in derivation.study.sides if side.state in ("asked", "open") for one in side.valid)
    for step in derivation.steps:
        found = result_of(step, derivation)
        if found is not None:
            yield replace(found, kept=kept)


def result_of(step: Step, derivation: Derivation) -> BoxedResult | None:
    """A step as a result; None for what is none."""
    row = step.statement
    if not step.is_result or step.rule in BALANCES or not isinstance(row, t.Chain) or set(row.ops) != {"="}:
        return None
    try:
        value = derivation.letters.value(row.items[-1])
    except RbpsymError:
        return None
    if not isinstance(value, Scalar) or is_zero(value):
        return None
    names, study = names_in(value), derivation.study
    rates = study.system.scope.rates.keys()
    known = rates if step.rule == "solution" else set(study.system.coordinates)
    if names - known - {"pi", "t", *(q.name for q in study.problem.parameters)} or names & (rates - known):
        return None  # unknown forces, a place of rest that an equation tells: these may depend on anything
    found = BoxedResult(step, study, row.items[0], value)
    return None if step.rule == "first_integral" and not names & {*found.declared, *known} else found


# --- what drops out of a result; on what it does not depend, why, and which way it goes with what it depends on


def free_of(result: BoxedResult) -> Iterator[Made]:
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


def _is_only_mass(name: str, result: BoxedResult) -> bool:
    """Is it a mass, while the dimension of no other quantity that is given or moves holds one?"""
    problem = result.study.problem
    known = [*problem.parameters, *(coordinate.quantity for coordinate in problem.coordinates)]
    return result.declared[name].dimension == MASS and not any(q.dimension.mass for q in known if q.name != name)


def _makes_no_number(names: Sequence[str], result: BoxedResult) -> bool:
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


def monotone(result: BoxedResult) -> Iterator[Made]:
    """With which parameters its size grows for all their values, and with which it falls."""
    ways = {name: _way(result, name) for name, q in result.declared.items() if q.sign == "positive"}
    grow, fall = ([t.Sym(name) for name, way in ways.items() if way == wanted] for wanted in ("positive", "negative"))
    key = {(True, True): "both", (True, False): "grows", (False, True): "falls"}.get((bool(grow), bool(fall)))
    if key:
        size = sign(result.value, result.given)
        variant = "plain" if size.kind == "positive" else "size" if size.is_nonzero else "other"
        slots = {"quantity": result.name, "grow": grow, "fall": fall, "variant": variant}
        told = ("monotone", *(f"{name}{way}" for name, way in ways.items() if way))
        yield Made(f"remark.{key}", slots, proved("the sign of its logarithmic derivative"), told)


def _way(result: BoxedResult, name: str) -> str:
    """The sign of the logarithmic derivative, "" where it is none for all values."""
    if not depends_on(result.value, name):
        return ""
    slope, start = short(derivative(result.value, name) / result.value), result.study.system.scope.start
    if short(slope * symbol(name)).number() is not None:  # a mere power of it is seen at a glance
        return ""
    kind = sign(slope, result.given).kind
    begun = [substitute(value, start) for value in (slope, result.value)]
    if is_zero(begun[0]) and not is_zero(begun[1]):  # the range of a coordinate does not hold its start
        return ""
    return kind if kind in ("positive", "negative") else ""


def drops_out(result: BoxedResult) -> Iterator[Made]:
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


ORDER = ("pair_turning", "pair", "across", "straight", "fixed_point")  # what holds bodies together before what holds them up


def _is_needed(name: str, result: BoxedResult) -> bool:
    """Does another force go by it, as sliding friction goes by the normal force?"""
    own = {unknown for force in result.study.system.named(name) for unknown in force.unknowns}
    others = (force for force in result.study.system.forces if force.name != name)
    return any(own & names_in(part) for force in others for part in (force.vector.x, force.vector.y, force.couple))


def _reason(parts: list[Force], result: BoxedResult) -> tuple[str, ...]:
    """Why a force does no work: (what is said, its bodies); () where no short reason is found."""
    speeds = [_speed(part, result) for part in parts]
    bodies = [result.study.system.bodies[part.on] for part in parts]
    pushes = [part.vector for part in parts if part.vector]
    if len(parts) == 1 and not is_zero(parts[0].couple):
        return ()
    if len(parts) == 1:
        if speeds[0].vanishes():
            return ("fixed_point",)
        turning = (parts[0].point - bodies[0].center).turned() * bodies[0].omega
        key = "across" if parts[0].vector.dot(turning) else "straight"  # the force has works that cancel, or none
        return (key,) if is_zero(parts[0].vector.dot(speeds[0])) else ()
    if len(parts) != 2 or not is_zero(parts[0].couple + parts[1].couple):
        return ()
    if not pushes:
        return ("pair_turning", *sorted({p.on for p in parts})) if is_zero(bodies[0].omega - bodies[1].omega) else ()
    is_pair = (parts[0].vector + parts[1].vector).vanishes() and is_zero(parts[0].couple)
    return ("pair", *sorted({p.on for p in parts})) if is_pair and (speeds[0] - speeds[1]).vanishes() else ()


def _speed(part: Force, result: BoxedResult) -> Vector:
    """The velocity of the point of the body at which it acts."""
    state = result.study.system.bodies[part.on]
    return state.velocity + (part.point - state.center).turned() * state.omega


KINDS = (drops_out, free_of, without, small, monotone)  # from what matters most to what matters least
ONCE = (drops_out, without, small, monotone)  # kinds of which shorter notes have one remark in a text
