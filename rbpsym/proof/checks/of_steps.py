"""How statements are checked. Every check returns a verdict; none of them makes a step.

The checks of a rule share no code with what made the step: a derivative is integrated, an
integral differentiated, a moment taken over the mass itself, a solution substituted back.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from math import prod
from typing import Any

from rbpsym.decide.equal import compare, scalars_equal
from rbpsym.decide.verdict import PROVED, Verdict, proved, undecided
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Scalar, Space, Value, at_most, atoms, derivative, is_zero, substitute, symbol, total
from rbpsym.field.division import divide, vanishes_on
from rbpsym.field.normal import normal
from rbpsym.proof.context import DECIDED, Context
from rbpsym.proof.mass import angular_momentum, kinetic_energy, mass_moments, moment_about, moments_of, primitive, torque
from rbpsym.proof.step import Step

MOST_PRODUCTS = 250_000  # of a single check: what takes more stays undecided
Check = Callable[[Context, Step], Verdict]
NOT_BY_NUMBERS = undecided("not by numbers")


def weakest(verdicts: Iterable[Verdict]) -> Verdict:
    """The first verdict that is not PROVED, else the last of them."""
    found = undecided("nothing was asserted")
    for found in verdicts:
        if found.kind is not PROVED:
            return found
    return found


def first_proved(verdicts: Iterable[Verdict], otherwise: Verdict) -> Verdict:
    """The first verdict that is PROVED, else the other one."""
    return next((verdict for verdict in verdicts if verdict.is_proved), otherwise)


def each(step: Step, check: Callable[[t.Node, str, t.Node], Verdict]) -> Verdict:
    """The weakest verdict on the relations that a step states; of one that can't be seen UNDECIDED."""
    return weakest(guarded(partial(check, *row)) for row in t.relations(step.statement))


def right_sides(context: Context, step: Step) -> list[Scalar]:
    """The right sides of the relations that a step states."""
    return [context.value(right) for _, _, right in t.relations(step.statement)]


def right_side(context: Context, step: Step) -> Scalar:
    """The right side of the one relation that a step states."""
    [found] = right_sides(context, step)
    return found


def named_sides(context: Context, step: Step) -> list[tuple[str, Scalar]]:
    """The letters at the left of the relations that a step states ("" for what is none), each with the right side."""
    return [(getattr(left, "name", ""), context.value(right)) for left, _, right in t.relations(step.statement)]


def premise_says(context: Context, id: str) -> Scalar:
    """The right side of what a premise states."""
    context.use(id)
    return right_side(context, context.steps[id])


def differences(context: Context, node: t.Node) -> list[Scalar]:
    """The left sides of relations minus their right sides."""
    return [context.value(left) - context.value(right) for left, _, right in t.relations(node)]


def difference(context: Context, node: t.Node) -> Scalar:
    """The left side of one relation minus its right side."""
    [found] = differences(context, node)
    return found


def guarded(check: Callable[[], Verdict]) -> Verdict:
    """An error on the way is UNDECIDED with its reason, never PROVED."""
    try:
        with at_most(MOST_PRODUCTS):
            return check()
    except (RbpsymError, ZeroDivisionError) as error:
        return undecided(str(error))


def _components(found: Value) -> tuple[Scalar, ...]:
    """Components of a vector; the scalar 0 counts as the zero vector."""
    return found.components() if isinstance(found, Space) else (NOTHING, NOTHING, found)


def same(context: Context, a: Scalar, b: Scalar) -> Verdict:
    """Whether two scalars are equal, on the conditions that tie the coordinates if there are any."""
    if context.by_numbers and not _may_be_equal(a - b, context):
        return undecided("not proved at once")
    found = scalars_equal(a, b, context.assumptions)
    if found.kind is not PROVED and _is_unsolved(context, a - b):
        return _by_equations_of_motion(context, a - b)
    ties = [condition.value for condition in context.ties]
    if found.kind is PROVED or not ties:
        return found
    if vanishes_on(a - b, ties):
        return proved("in the ideal of the conditions that tie the coordinates")
    return undecided("the coordinates are tied by conditions that were not solved in closed form")


def _may_be_equal(rest: Scalar, context: Context) -> bool:
    """False for what is surely no identity in sines, cosines and symbols."""
    plain = all(atoms.atom(index).kind in ("symbol", "cos", "sin") for index in rest.atoms())
    return not plain or bool(context.ties) or _is_unsolved(context, rest) or is_zero(rest)


def _is_unsolved(context: Context, rest: Scalar) -> bool:
    """Whether accelerations stand in it for which there is no closed formula."""
    return any(derivative(rest, name) for name in context.unsolved)


def _by_equations_of_motion(context: Context, rest: Scalar) -> Verdict:
    """Whether it is one of the equations M q̈ - f = 0, or Σ q̇ (M q̈ - f), in which energy balances hold."""
    study = context.study
    for known in (*study.motion_rows, study.power_balance):
        if is_zero(rest + known) or is_zero(rest - known):
            return proved("one of the equations of motion, or their balance of power")
    return undecided("no closed formula for the accelerations of so many coupled coordinates was found")


def _each(context: Context, step: Step, depth: str) -> Verdict:
    def one(left: t.Node, op: str, right: t.Node) -> Verdict:
        a, b = context.value(left), context.value(right)
        if op == "=":
            is_vector = isinstance(a, Space) or isinstance(b, Space)
            pairs = zip(_components(a), _components(b), strict=True) if is_vector else [(a, b)]
            return weakest([agree(context, x, y, depth) for x, y in pairs])
        a, b = seen(context, a, depth), seen(context, b, depth)
        low, high = (a, b) if op in ("<", "<=") else (b, a)
        return compare(low, high, context.assumptions, strict=op in ("<", ">"))

    return each(step, one)


def seen(context: Context, value: Scalar, depth: str) -> Any:
    """A value in every state ("state"), on the motion ("motion"), or along it from the start ("along")."""
    return context.along(value) if depth == "along" else context.on_motion(value) if depth == "motion" else value


def agree(context: Context, a: Scalar, b: Scalar, depth: str) -> Verdict:
    """Whether two values are equal as seen at that depth."""
    quick = context.agree_by_numbers(a - b, depth) if context.by_numbers else None
    if quick is False or (quick and context.by_numbers == DECIDED):
        return proved("by numbers") if quick else NOT_BY_NUMBERS
    found = same(context, seen(context, a - b, depth), NOTHING)
    if found.is_proved and depth != "state":
        context.reach(a - b)
    return found


def identity(context: Context, step: Step) -> Verdict:
    """Each relation holds for all positions, speeds, accelerations and unknown forces."""
    return _each(context, step, "state")


def on_motion(context: Context, step: Step) -> Verdict:
    """Each relation holds with the accelerations and forces that the free bodies give."""
    return _each(context, step, "motion")


def along_motion(context: Context, step: Step) -> Verdict:
    """Each relation holds with the speeds of the motion from the start as well."""
    return _each(context, step, "along")


def _by_rates(context: Context, step: Step, *depths: str) -> Verdict:
    """Both sides begin alike and grow at the same rate, as seen at one of the depths."""

    def one(left: t.Node, op: str, right: t.Node) -> Verdict:
        if op != "=":
            return undecided("what changes alike is equal; an inequality is not seen from that")
        grown = context.rate(left), context.rate(right)
        for depth in depths:
            rates = agree(context, *grown, depth)
            if rates.kind is PROVED:
                return weakest([rates, same(context, begin(context, left), begin(context, right))])
        return rates

    return each(step, one)


def begin(context: Context, node: t.Node) -> Scalar:
    """The value at the start, where every integral along the motion is zero."""
    match node:
        case t.Integral() | t.PathIntegral() | t.Delta():
            return NOTHING
        case t.Add(terms=terms):
            return total(begin(context, term) for term in terms)
        case t.Sum(term=inner) | t.Group(arg=inner):
            return begin(context, inner)
        case t.Neg(arg=inner):
            return -begin(context, inner)
        case t.Sym(name=name) if name in context.works:
            return NOTHING
        case t.Mul(factors=factors) if grown := [factor for factor in factors if context.grows(factor)]:
            others = (factor for factor in factors if factor not in grown)
            begun = prod((begin(context, factor) for factor in grown), start=UNITY)
            return prod((context.start(context.value(one)) for one in others), start=begun) if begun else NOTHING
        case t.Div(num=above, den=below) if context.grows(above):
            return begin(context, above) / begin(context, below)
    return context.start(context.value(node))


def rates(context: Context, step: Step) -> Verdict:
    """Both sides are zero at the start (or equal there) and grow at the same rate, identically."""
    return _by_rates(context, step, "state")


def rates_on_motion(context: Context, step: Step) -> Verdict:
    """The same, with the accelerations and forces of the motion (and the speeds, where they are needed)."""
    return _by_rates(context, step, "motion", "along")


def power_of_works(context: Context, step: Step) -> Verdict:
    """The rate of the works is as stated, whatever the unknown forces; an inequality holds for every state."""

    def seen(node: t.Node) -> Any:
        return context.rate(node.of) if isinstance(node, t.Deriv) else context.value(node)

    def one(left: t.Node, op: str, right: t.Node) -> Verdict:
        a, b = seen(left), seen(right)
        return same(context, a, b) if op == "=" else compare(a, b, context.assumptions, strict=op == "<")

    return each(step, one)


def integrals_by_differentiation(context: Context, step: Step) -> Verdict:
    """Each integral: its antiderivative is differentiated and compared with the integrand."""
    found = [node for node in t.walk(step.statement) if isinstance(node, t.Integral)]
    return weakest(guarded(partial(_undone, context, node)) for node in found) if found else _nothing()


def _undone(context: Context, node: t.Integral) -> Verdict:
    integrand = context.value(node.integrand)
    found = primitive(integrand, node.var)
    ends = [substitute(found, {node.var: context.value(end)}) for end in (node.upper, node.lower)]
    return same(context, ends[0] - ends[1], context.value(node))


def _nothing() -> Verdict:
    return proved("nothing of this kind occurs")


def derivatives_by_integration(context: Context, step: Step) -> Verdict:
    """A rate of change of position is integrated back over each coordinate.

    `data`: "of" (a Scalar or Vector of positions) and "rate" (what was found, linear in speeds).
    """
    pairs = step.data.get("pairs", ())
    return weakest(guarded(partial(_integrated, context, *pair)) for pair in pairs) if pairs else _nothing()


def _integrated(context: Context, of: Scalar, found: Scalar) -> Verdict:
    """Each partial derivative is integrated back; their sum with the speeds is the rate."""
    system, total = context.study.system, NOTHING
    for name in system.coordinates:
        slope = derivative(of, name)
        gained, moved = _gained((primitive(slope, name), of), name)
        if not is_zero(gained - moved):
            return same(context, gained, moved)
        total = total + slope * system.scope.rates[name]
    return same(context, found, total + derivative(of, "t"))


def _gained(values: Sequence[Scalar], name: str) -> list[Scalar]:
    """By how much they grow from 0 on; from a place of any name on, where one of them has no value at 0."""
    try:
        return [value - substitute(value, {name: NOTHING}) for value in values]
    except ZeroDivisionError:
        return [value - substitute(value, {name: symbol(f"{name}_A")}) for value in values]


def momentum_over_mass(context: Context, step: Step) -> Verdict:
    """L as ∫ r × v dm over the mass itself (`data`: "origin" Vector, "bodies", "value" Scalar)."""
    total = sum((angular_momentum(context.study.system, b, step.data["origin"]) for b in step.data["bodies"]), NOTHING)
    return same(context, total, step.data["value"])


def energy_over_mass(context: Context, step: Step) -> Verdict:
    """T as ½∫ v² dm over the mass itself (`data`: "bodies", "value")."""
    total = sum((kinetic_energy(context.study.system, b) for b in step.data["bodies"]), NOTHING)
    return same(context, total, step.data["value"])


def moment_over_mass(context: Context, step: Step) -> Verdict:
    """I about a point as ∫ |r - p|² dm (`data`: "body", or the "elements" of a part of one, "point" local (x, y), "value")."""
    found = moments_of(step.data["elements"]) if step.data.get("elements") else _moments(context, step)
    return same(context, moment_about(found, step.data["point"]), step.data["value"])


def center_over_mass(context: Context, step: Step) -> Verdict:
    """M times the place of the centre of mass is ∫ r dm in the frame of the body (`data`: "body", "point" local (x, y))."""
    zeroth, *first, _ = _moments(context, step)
    return weakest(same(context, zeroth * x, moment) for x, moment in zip(step.data["point"], first, strict=True))


def _moments(context: Context, step: Step) -> tuple[Scalar, ...]:
    return mass_moments(context.study.system, step.data["body"])


def torque_by_components(context: Context, step: Step) -> Verdict:
    """Σ (x F_y - y F_x) + couples (`data`: "forces", "origin" Vector, "value")."""
    _use_forces(context, step)
    return same(context, torque(step.data["forces"], step.data["origin"]), step.data["value"])


def _use_forces(context: Context, step: Step) -> None:
    """The forces are those that other steps told of."""
    for force in step.data["forces"]:
        id = f"force.{force.name}.{force.on}"
        if id != step.id and id in context.steps:
            context.use(id)


def combination(context: Context, step: Step) -> Verdict:
    """left - right is the stated combination of the premises' (`data`: "terms": (factor, step) pairs)."""
    total = difference(context, step.statement)
    for factor, premise in step.data["terms"]:
        context.use(premise.id)
        total = total - difference(context, premise.statement) * factor
    return same(context, total, NOTHING)


def constant(context: Context, step: Step) -> Verdict:
    """d/dt of the first item vanishes on the motion (`data`: "value")."""
    return agree(context, context.rate_of(step.data["value"]), NOTHING, "motion")


def vanishing(context: Context, step: Step) -> Verdict:
    """The force vanishes at the stated place (`data`: "force", "at"), or where the stated factor does ("factor")."""
    value = context.along(symbol(step.data["force"]))
    if not step.data["at"]:
        return divides(step.data["factor"], value)
    return same(context, substitute(value, step.data["at"]), NOTHING)


def value_there(context: Context, step: Step) -> Verdict:
    """What is stated is the value of a quantity at a place that another step found (`data`: "of", "at", "place")."""
    context.use(step.data["place"])
    there = substitute(context.along(symbol(step.data["of"])), step.data["at"])
    return weakest(same(context, value, there) for value in right_sides(context, step))


def conservative(context: Context, step: Step) -> Verdict:
    """The forces do the work -dU: Σ F·V + τ ω + dU/dt = 0 (`data`: "forces", "value")."""
    from rbpsym.proof.mass import power

    _use_forces(context, step)
    total = power(context.study.system, step.data["forces"]) + context.rate_of(step.data["value"])
    return same(context, total, NOTHING)


def first_integral(context: Context, step: Step) -> Verdict:
    """What is stated of q̇² follows from what is conserved; or it is so at the start, and 2 q̈ = d(q̇²)/dq (`data`: "name")."""
    found = along_motion(context, step)
    if found.is_proved:
        return found
    name, square = step.data["name"], right_side(context, step)
    speed = f"{name}_dot"
    begin = context.start(square) - context.start(symbol(speed)) ** 2
    growth = context.rate_of(square) - symbol(speed) * symbol(f"{name}_ddot") * 2
    return weakest([same(context, begin, NOTHING), agree(context, growth, NOTHING, "along")])


def divides(factor: Scalar, value: Scalar) -> Verdict:
    """PROVED if the factor divides the numerator, so that both vanish together."""
    num, by = normal(value.num), normal(factor.num)
    common = dict(num.content()[1])
    is_there = all(common.get(index, 0) >= power for index, power in by.content()[1] if power > 0)
    if not is_there or divide(num, by) is None:  # x/y is no reason why x should vanish with y
        return undecided("the factor was not found in the force again")
    return proved("the factor divides the force")


def holds_there(context: Context, step: Step) -> Verdict:
    """The stated relation holds at the place (`data`: "at"); without one, it is the factor (`data`: "factor")."""

    def one(left: t.Node, op: str, right: t.Node) -> Verdict:
        difference = context.value(left) - context.value(right)
        if step.data["at"]:
            return same(context, substitute(difference, step.data["at"]), NOTHING)
        return same(context, context.along(difference), step.data["factor"])

    return each(step, one)
