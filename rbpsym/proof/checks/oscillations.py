"""Checks of positions of rest and of small motions about them.

The equations of motion are expanded anew, as truncated series in all coordinates and speeds (`expansion`); of the
characteristic polynomial (by permutations) remainders of divisions and Routh's table are taken.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain, permutations, zip_longest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import compare
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, atoms, depends_on, derivative, short, substitute, symbol, total
from rbpsym.mechanics.demands import assuming
from rbpsym.proof.checks.of_steps import (
    difference,
    differences,
    first_proved,
    named_sides,
    right_side,
    right_sides,
    same,
    weakest,
)
from rbpsym.proof.context import Context
from rbpsym.proof.expansion import Nearby, nearby
from rbpsym.proof.step import Step

Matrix = list[list[Scalar]]


def still(context: Context, value: Scalar, at: Mapping[str, Scalar]) -> Scalar:
    """A value at rest in a place."""
    return substitute(substitute(value, dict.fromkeys(context.study.system.speeds, NOTHING)), at)


def _forces_at_rest(context: Context) -> list[Scalar]:
    """Minus the slopes of the potential energy, if there is one."""
    study = context.study
    potential = None if study.system.has_clock or study.system.implicit else study.potential
    names = study.system.independent
    forces = list(study.dynamics.forcing) if potential is None else [-derivative(potential, n) for n in names]
    return [still(context, force, {}) for force in forces]


def forces_at_rest(context: Context, step: Step) -> Verdict:
    """Each row is the generalized force of one coordinate at rest."""
    forces = _forces_at_rest(context)
    rows = ([same(context, stated, force) for force in forces] for stated in differences(context, step.statement))
    return weakest([first_proved(verdicts, verdicts[0]) for verdicts in rows])


def force_vanishes(context: Context, step: Step) -> Verdict:
    """What is said to be equal differs by the force at rest in the named place, but for a factor that does not vanish in
    the range; where the place is not said to be the only one, it is enough that the factor has a value (`data`: "balance").
    """
    item, [force] = step.data["balance"], _forces_at_rest(context)
    stated = -difference(context, step.statement)
    there = substitute(force, {item.name: symbol(item.place)})
    plain = (neat(value, context.assumptions) for value in (there, stated))
    found = same(context, stated, there)
    for above, below in (tuple(plain), (there, stated)):
        factor = short(above / below)
        asked = Scalar(factor.den) if item.stable is None else factor
        if sign(substitute(asked, {item.place: symbol(item.name)}), context.assumptions).is_nonzero:
            return same(context, stated * factor, there)
    return found if found.is_proved else undecided("whether the factor between them vanishes is not decided")


def force_at_ends(context: Context, step: Step) -> Verdict:
    """The rows are the force at rest at the two ends of the range, in their order (`data`: "balance")."""
    item, [force] = step.data["balance"], _forces_at_rest(context)
    coordinate = context.study.problem.coordinate(item.name)
    ends = [{item.name: context.value(bound)} for bound in (coordinate.lower, coordinate.upper) if bound is not None]
    rows = zip(t.relations(step.statement), ends, strict=True)
    return weakest([same(context, context.value(left), substitute(force, end)) for (left, _, _), end in rows])


def series_in_balance(context: Context, step: Step) -> Verdict:
    """The right side vanishes in the place, is linear, and its slopes by place and speed, times the inertia, are those of
    the force there.

    The force vanishes there: the rate of change of the inertia adds nothing (`data`: "balance").
    """
    item, [force] = step.data["balance"], _forces_at_rest(context)
    stated, there = right_side(context, step), {item.name: symbol(item.place)}
    slope = derivative(stated, item.name)
    mass = substitute(context.study.dynamics.mass_matrix[0][0], there)
    pull = substitute(derivative(force, item.name), there)
    [speed] = context.study.system.speeds
    loss, drag = derivative(stated, speed), still(context, derivative(context.study.dynamics.forcing[0], speed), there)
    zeros = [still(context, substitute(stated, there), {}), derivative(slope, item.name), derivative(slope, speed)]
    zeros += [derivative(loss, speed), loss * mass - drag]
    found = [same(context, value, NOTHING) for value in zeros]
    return weakest([*found, same(context, slope * mass, pull)])


def place_stated(context: Context, step: Step) -> Verdict:
    """What is stated is the place that was checked (`data`: "at")."""
    at, stated = step.data["at"], named_sides(context, step)
    if any(name not in at for name, _ in stated):
        return undecided("the step does not name a coordinate")
    return weakest([same(context, value, at[name]) for name, value in stated])


def at_rest(context: Context, step: Step) -> Verdict:
    """With all speeds zero at the stated place, all generalized forces vanish (`data`: "at")."""
    forcing = context.study.dynamics.forcing
    return weakest(same(context, still(context, value, step.data["at"]), NOTHING) for value in forcing)


def series(context: Context, step: Step) -> Verdict:
    """The stated right side is linear, and is the acceleration to first order in all coordinates and speeds.

    `data`: "name", "at".
    """
    [(left, _, right)] = t.relations(step.statement)
    stated = context.value(right)
    study, at, gained = context.study, step.data["at"], symbol(f"{step.data['name']}_ddot")
    apart = nearby((stated - study.on_motion(gained),), (), study.system.independent, at, {})
    found = [same(context, value, NOTHING) for value in (*apart.rest, *apart.drag[0], *apart.pull[0])]
    return weakest([*found, same(context, context.value(left), gained), _is_linear(context, stated, step)])


def _is_linear(context: Context, value: Scalar, step: Step) -> Verdict:
    """Whether a value is its own expansion, in displacements, speeds and accelerations."""
    names, at = context.study.system.independent, step.data["at"]
    [mass], [drag], [pull] = (lambda n: (n.mass, n.drag, n.pull))(nearby((value,), (), names, at, {}))
    parts = [m * symbol(f"{n}_ddot") + c * symbol(f"{n}_dot") for n, m, c in zip(names, mass, drag, strict=True)]
    parts += [k * (symbol(n) - at[n]) for n, k in zip(names, pull, strict=True) if n in at]
    return same(context, value, total(parts))


def near_place(context: Context, step: Step) -> Nearby:
    """The equations of motion to first order (`data`: "at", and "tied" where coordinates are tied)."""
    study, at, tied = context.study, step.data["at"], step.data.get("tied", {})
    return nearby(study.motion_rows, [tie.value for tie in study.ties], study.system.independent, at, tied)


def linear_rows(context: Context, step: Step) -> Verdict:
    """Row by row: what is stated is linear, and is the equation of motion to first order (`data`: "at", "tied")."""
    study, at, near = context.study, step.data["at"], near_place(context, step)
    stated = differences(context, step.statement)
    own = nearby(stated, (), study.system.independent, at, {})
    found = [same(context, value, NOTHING) for value in (*near.rest, *near.ties, *own.rest)]
    for mine, there in ((own.mass, near.mass), (own.drag, near.drag), (own.pull, near.pull)):
        pairs = (pair for a, b in zip(mine, there, strict=True) for pair in zip(a, b, strict=True))
        found += [same(context, a, b) for a, b in pairs]
    return weakest([*found, *(_is_linear(context, value, step) for value in stated)])


def held(context: Context, step: Step, matrix: Matrix) -> Matrix:
    """Over the coordinates that are not arbitrary."""
    kept = [k for k, name in enumerate(context.study.system.independent) if name in step.data["at"]]
    return [[matrix[i][j] for j in kept] for i in kept]


def minors(matrix: Matrix) -> list[Scalar]:
    """The leading minors."""
    return [_leibniz([row[:size] for row in matrix[:size]]) for size in range(1, len(matrix) + 1)]


def positive_minors(context: Context, step: Step) -> Verdict:
    """The stated values are the leading minors of the stiffness, and positive (`data`: "at")."""
    found = []
    expected = minors(held(context, step, near_place(context, step).pull))
    for (left, _, right), minor in zip(t.relations(step.statement), expected, strict=True):
        value = context.value(left)
        found += [same(context, value, minor), positive(context, step, value - context.value(right))]
    return weakest(found)


def given(context: Context, step: Step) -> Assumptions:
    """Declared signs and ranges, and what the place asks of the parameters (`data`: "valid", an obligation)."""
    return assuming(context.assumptions, step.data.get("valid", ()), whole=True)


def positive(context: Context, step: Step, value: Scalar) -> Verdict:
    """Whether it is, for all that is `given`; √(h²) is h where h is positive, which is proved."""
    known = given(context, step)
    plain = neat(value, known)
    return weakest([same(context, plain, value), compare(NOTHING, plain, known, strict=True)])


def _leibniz(matrix: Matrix) -> Scalar:
    """The determinant as the sum over all permutations."""
    found, size = NOTHING, len(matrix)
    for order in permutations(range(size)):
        swaps = sum(a > b for k, a in enumerate(order) for b in order[k + 1 :])
        product = UNITY if swaps % 2 == 0 else -UNITY
        for row, column in enumerate(order):
            product = product * matrix[row][column]
        found = found + product
    return found


def singular(near: Nearby, rate: Scalar) -> Scalar:
    """det(M λ² + C λ + K)."""
    size = range(len(near.mass))
    matrix = [[(near.mass[i][j] * rate + near.drag[i][j]) * rate + near.pull[i][j] for j in size] for i in size]
    return _leibniz(matrix)


def _shifted(near: Nearby, square: Scalar) -> Matrix:
    rows = zip(near.pull, near.mass, strict=True)
    return [[k - square * m for k, m in zip(a, b, strict=True)] for a, b in rows]


def secular(context: Context, step: Step) -> Verdict:
    """The left side is det(K - λ M), by permutations (`data`: "at"; no speeds occur)."""
    near = near_place(context, step)
    undamped = [same(context, value, NOTHING) for row in near.drag for value in row]
    expected = _leibniz(_shifted(near, symbol(step.slots["letter"].name)))
    return weakest([*undamped, same(context, difference(context, step.statement), expected)])


def characteristic(context: Context, step: Step) -> Verdict:
    """Each stated λ makes K - λ M singular (`data`: "at"; no speeds occur)."""
    near = near_place(context, step)
    singular = (_leibniz(_shifted(near, square)) for square in right_sides(context, step))
    return weakest([same(context, value, NOTHING) for value in (*chain.from_iterable(near.drag), *singular)])


def mode_shape(context: Context, step: Step) -> Verdict:
    """(K - λ M) A = 0 for the amplitudes in the stated ratios to that of the first in the order, and A₁² Σ M_ij A_i A_j / A₁² = 1
    (`data`: "at", "square", "order")."""
    order, near = step.data["order"], near_place(context, step)
    told = right_sides(context, step)
    ratios, sizes = dict(zip(order, (UNITY, *told), strict=False)), told[len(order) - 1 :]
    mass = total(near.mass[i][j] * ratios[i] * ratios[j] for i in order for j in order)
    rows = (total(row[k] * ratios[k] for k in order) for row in _shifted(near, step.data["square"]))
    found = [same(context, row, NOTHING) for row in rows]
    return weakest([*found, *(same(context, size * mass, UNITY) for size in sizes)])


# --- motions in which speeds occur

RATE = "rate away"  # λ, a name that no user can write


def coefficients(value: Scalar, letter: str = RATE) -> list[Scalar]:
    """Of a polynomial in λ, that of the highest power first."""
    parts = value.num.by_power(atoms.intern("symbol", letter))
    return [Scalar(parts.get(k, Poly({}))) / Scalar(value.den) for k in range(max(parts), -1, -1)]


def _remainder(whole: Sequence[Scalar], divisor: Sequence[Scalar]) -> list[Scalar]:
    """What long division of polynomials leaves."""
    left = list(whole)
    while len(left) >= len(divisor):
        ratio = left[0] / divisor[0]
        left = [a - ratio * b for a, b in zip_longest(left, divisor, fillvalue=NOTHING)][1:]
    return left


def divides(context: Context, near: Nearby, powers: Sequence[Scalar]) -> Verdict:
    """Whether a polynomial in λ divides det(M λ² + C λ + K)."""
    left = _remainder(coefficients(singular(near, symbol(RATE))), powers)
    return weakest([same(context, value, NOTHING) for value in left])


def polynomial(context: Context, step: Step) -> Verdict:
    """The left side is det(M λ² + C λ + K) but for a factor that does not vanish and is free of λ (`data`: "at")."""
    letter = step.slots["letter"].name
    stated, whole = difference(context, step.statement), singular(near_place(context, step), symbol(letter))
    own, parts = coefficients(stated, letter), coefficients(whole, letter)
    if len(own) != len(parts):
        return same(context, whole, stated)
    factor = short(parts[0] / own[0])  # not of the whole: roots in the coefficients hide what is common to both
    found = weakest(same(context, part, mine * factor) for part, mine in zip(parts, own, strict=True))
    if sign(factor, context.assumptions).is_nonzero or not found.is_proved:
        return found
    return undecided("it is not decided whether a common factor vanishes")


def motion_of_mode(context: Context, step: Step) -> Verdict:
    """λ² + 2γλ + ϑ² divides det(M λ² + C λ + K), for "undamped" data without C; ϑ² and, if it is not zero, γ are
    positive, and it swings or not as is said (`data`: "at", "decay", "square", "swings": surely, never or perhaps)."""
    near = near_place(context, step)
    if step.data.get("undamped"):
        near = replace(near, drag=[[NOTHING] * len(row) for row in near.drag])
    decay, square = step.data["decay"], step.data["square"]
    gap = square - decay * decay
    more = {"surely": [gap], "never": [-gap]}.get(step.data.get("swings", ""), [])
    signs = [positive(context, step, value) for value in (square, *([decay] if decay else []), *more)]
    return weakest([divides(context, near, (UNITY, decay * 2, square)), *signs])


def critical(context: Context, step: Step) -> Verdict:
    """(2γ)² - 4ϑ² = b² (c² - c_crit²) with b free of c, and c_crit > 0: the damping is weak below c_crit and nowhere else
    (`data`: "name" of c, "damping" 2γ, "square" ϑ²)."""
    [(left, _, _)] = list(t.relations(step.statement))
    name, damping, value = step.data["name"], step.data["damping"], context.value(left)
    each = damping / symbol(name)
    if depends_on(each, name) or depends_on(value, name):
        return undecided("the damping is not proportional to the parameter")
    spread = damping * damping - step.data["square"] * 4
    found = same(context, spread, each * each * (symbol(name) * symbol(name) - value * value))
    return weakest([found, positive(context, step, value)])


def rate_of_mode(context: Context, step: Step) -> Verdict:
    """The stated rate is positive, and λ = -(rate) makes M λ² + C λ + K singular (`data`: "at")."""
    value = right_side(context, step)
    found = same(context, singular(near_place(context, step), -value), NOTHING)
    return weakest([found, positive(context, step, value)])


def _routh(powers: Sequence[Scalar]) -> list[Scalar]:
    """Hurwitz's determinants Δ₁, Δ₂, …: products of the first column of Routh's table; zeros from the first that vanishes."""
    above, row = list(powers[::2]), list(powers[1::2])
    found: list[Scalar] = []
    while row:
        found.append(row[0] * (found[-1] if found else UNITY))
        if not row[0]:
            return [short(value) for value in found] + [NOTHING] * (len(powers) - 1 - len(found))
        paired = list(zip_longest(above[1:], row[1:], fillvalue=NOTHING))
        above, row = row, [(row[0] * a - above[0] * b) / row[0] for a, b in paired]
    return [short(value) for value in found]


def routh_conditions(powers: Sequence[Scalar]) -> list[Scalar]:
    """Coefficients and every other determinant from the last but one (Liénard and Chipart)."""
    return [*powers[1:], *_routh(powers)[len(powers) - 3 : 0 : -2]]


def hurwitz(context: Context, step: Step) -> Verdict:
    """What is stated are the conditions for a factor of the polynomial: those that are positive, and by name those that
    are where one of the open "conditions" is, from which it differs by a positive factor (`data`: "at", "powers")."""
    powers, known = step.data["powers"], step.data["conditions"]
    found = [divides(context, near_place(context, step), powers), positive(context, step, powers[0])]
    for (left, op, right), value in zip(t.relations(step.statement), routh_conditions(powers), strict=True):
        found.append(same(context, context.value(right if op == "=" else left), value))
        if op == "=" and not any(positive(context, step, value / condition).is_proved for condition in known):
            found.append(undecided("none of the named conditions says that this is positive"))
    return weakest(found)
