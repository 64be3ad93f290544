"""Checks of positions of rest and of small motions about them: everything is differentiated and put in anew."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import permutations

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar, symbol
from rbpsym.derivation.checks import relations, same, weakest
from rbpsym.derivation.context import Context
from rbpsym.derivation.step import Step
from rbpsym.equality.decide import compare
from rbpsym.equality.signs import sign
from rbpsym.equality.verdict import UNDECIDED, Verdict
from rbpsym.mechanics.elimination import short

Matrix = list[list[Scalar]]


def _still(context: Context, value: Scalar, at: Mapping[str, Scalar]) -> Scalar:
    """A value at rest in a place."""
    return substitute(substitute(value, dict.fromkeys(context.study.system.speeds, NOTHING)), at)


def _forces_at_rest(context: Context) -> list[Scalar]:
    """Minus the slopes of the potential energy, if there is one."""
    study = context.study
    conservative = study.potential is not None and not study.system.has_clock and not study.system.implicit
    names = study.system.independent
    forces = [-derivative(study.potential, n) for n in names] if conservative else list(study.dynamics.forcing)
    return [_still(context, force, {}) for force in forces]


def forces_at_rest(context: Context, step: Step) -> Verdict:
    """Each row is the generalized force of one coordinate at rest."""
    forces, found = _forces_at_rest(context), []
    for left, _, right in relations(step.statement):
        stated = context.value(left) - context.value(right)
        verdicts = [same(context, stated, force) for force in forces]
        found.append(next((v for v in verdicts if v.is_proved), verdicts[0]))
    return weakest(found)


def force_vanishes(context: Context, step: Step) -> Verdict:
    """What is said to be equal differs by the force at rest in the named place, but for a factor that does not vanish.

    `data`: "balance". The factor has a sign and does not depend on the place.
    """
    item, [force] = step.data["balance"], _forces_at_rest(context)
    [(left, _, right)] = list(relations(step.statement))
    stated = context.value(right) - context.value(left)
    there = substitute(force, {item.name: symbol(item.place)})
    factor = short(there / stated)
    if depends_on(factor, item.place) or not sign(factor, context.assumptions).is_nonzero:
        return same(context, stated, there)
    return same(context, stated * factor, there)


def force_at_ends(context: Context, step: Step) -> Verdict:
    """The rows are the force at rest at the two ends of the range, in their order (`data`: "balance")."""
    item, [force] = step.data["balance"], _forces_at_rest(context)
    coordinate = context.study.problem.coordinate(item.name)
    found = []
    for (left, _, _), bound in zip(relations(step.statement), (coordinate.lower, coordinate.upper), strict=True):
        found.append(same(context, context.value(left), substitute(force, {item.name: context.value(bound)})))
    return weakest(found)


def series_in_balance(context: Context, step: Step) -> Verdict:
    """The right side vanishes in the place, is linear, its slope times the inertia is that of the force there,
    and the force does not change with the speed.

    The force vanishes there: the rate of change of the inertia adds nothing (`data`: "balance").
    """
    item, [force] = step.data["balance"], _forces_at_rest(context)
    [(_, _, right)] = list(relations(step.statement))
    stated, there = context.value(right), {item.name: symbol(item.place)}
    slope = derivative(stated, item.name)
    [[mass]] = _inertia(context, there)
    pull = substitute(derivative(force, item.name), there)
    zeros = [substitute(stated, there), derivative(slope, item.name)]
    zeros += [
        _still(context, derivative(context.study.dynamics.forcing[0], s), there) for s in context.study.system.speeds
    ]
    found = [same(context, value, NOTHING) for value in zeros]
    return weakest([*found, same(context, slope * mass, pull)])


def place_stated(context: Context, step: Step) -> Verdict:
    """What is stated is the place that was checked (`data`: "at")."""
    found = []
    for left, _, right in relations(step.statement):
        name = getattr(left, "name", None)
        if name not in step.data["at"]:
            return Verdict(UNDECIDED, reason="the step does not name a coordinate")
        found.append(same(context, context.value(right), step.data["at"][name]))
    return weakest(found)


def at_rest(context: Context, step: Step) -> Verdict:
    """With all speeds zero at the stated place, all generalized forces vanish (`data`: "at")."""
    forcing = context.study.dynamics.forcing
    return weakest(same(context, _still(context, value, step.data["at"]), NOTHING) for value in forcing)


def series(context: Context, step: Step) -> Verdict:
    """The stated right side is linear in q and q̇, and has the value and the slopes of the acceleration there.

    `data`: "value" (the acceleration), "name", "at".
    """
    [(_, _, right)] = list(relations(step.statement))
    stated, at, name = context.value(right), step.data["at"], step.data["name"]
    found = [same(context, _still(context, value, at), NOTHING) for value in (stated, step.data["value"])]
    for variable in (name, f"{name}_dot"):
        slope = derivative(stated, variable)
        found.append(same(context, slope, _still(context, derivative(step.data["value"], variable), at)))
    return weakest(found)


def _stiffness(context: Context, at: Mapping[str, Scalar]) -> Matrix:
    """-∂Q_i/∂q_j at a place."""
    names, forces = context.study.system.independent, context.study.dynamics.forcing
    return [[_still(context, -derivative(force, name), at) for name in names] for force in forces]


def _inertia(context: Context, at: Mapping[str, Scalar]) -> Matrix:
    return [[substitute(entry, at) for entry in row] for row in context.study.dynamics.mass_matrix]


def linear_rows(context: Context, step: Step) -> Verdict:
    """Row by row: the coefficients of the accelerations and of the displacements are those at the place (`data`: "at")."""
    names, at = context.study.system.independent, step.data["at"]
    found = []
    rows = zip(relations(step.statement), _inertia(context, at), _stiffness(context, at), strict=True)
    for (left, _, right), masses, springs in rows:
        a, b = context.value(left), context.value(right)
        found.append(same(context, substitute(b, at), NOTHING))
        for name, mass, spring in zip(names, masses, springs, strict=True):
            found += [same(context, derivative(a, f"{name}_ddot"), mass), same(context, derivative(b, name), -spring)]
        found.append(same(context, substitute(a, dict.fromkeys(context.study.system.accelerations, NOTHING)), NOTHING))
    return weakest(found)


def positive_minors(context: Context, step: Step) -> Verdict:
    """The stated values are the leading minors of the stiffness, and positive (`data`: "at")."""
    kept = [k for k, name in enumerate(context.study.system.independent) if name in step.data["at"]]
    whole = _stiffness(context, step.data["at"])
    found = []
    for size, (left, _, right) in enumerate(relations(step.statement), 1):
        minor = _leibniz([[whole[i][j] for j in kept[:size]] for i in kept[:size]])
        value = context.value(left)
        found += [same(context, value, minor), compare(context.value(right), value, context.assumptions, strict=True)]
    return weakest(found)


def _leibniz(matrix: Matrix) -> Scalar:
    """The determinant as the sum over all permutations."""
    total, size = NOTHING, len(matrix)
    for order in permutations(range(size)):
        swaps = sum(a > b for k, a in enumerate(order) for b in order[k + 1 :])
        product = UNITY if swaps % 2 == 0 else -UNITY
        for row, column in enumerate(order):
            product = product * matrix[row][column]
        total = total + product
    return total


def _shifted(context: Context, at: Mapping[str, Scalar], square: Scalar) -> Matrix:
    rows = zip(_stiffness(context, at), _inertia(context, at), strict=True)
    return [[k - square * m for k, m in zip(a, b, strict=True)] for a, b in rows]


def secular(context: Context, step: Step) -> Verdict:
    """The left side is det(K - λ M), by permutations (`data`: "at")."""
    [(left, _, right)] = list(relations(step.statement))
    expected = _leibniz(_shifted(context, step.data["at"], symbol("lamda")))
    return same(context, context.value(left) - context.value(right), expected)


def characteristic(context: Context, step: Step) -> Verdict:
    """Each stated λ makes K - λ M singular (`data`: "item")."""
    found = []
    for _, _, right in relations(step.statement):
        found.append(same(context, _leibniz(_shifted(context, step.data["item"].at, context.value(right))), NOTHING))
    return weakest(found)


def mode_shape(context: Context, step: Step) -> Verdict:
    """(K - λ M) A = 0 for the amplitudes in the stated ratio (`data`: "at", "square")."""
    [(_, _, right)] = list(relations(step.statement))
    ratio = context.value(right)
    rows = _shifted(context, step.data["at"], step.data["square"])
    return weakest(same(context, row[0] + row[1] * ratio, NOTHING) for row in rows)
