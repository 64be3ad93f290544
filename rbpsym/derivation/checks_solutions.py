"""Checks of motions as functions of the time: by differentiation, and by what is kept along the motion.

Nothing is integrated here. A function of the time whose second derivative is the acceleration that the laws give with it
and its first derivative, and that starts as the motion does, is the motion (Picard and Lindelöf).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.algebra.calculus import derivative, names_in, substitute
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.derivation.checks import relations, same, weakest
from rbpsym.derivation.context import Context
from rbpsym.derivation.step import Step
from rbpsym.equality.decide import compare
from rbpsym.equality.verdict import UNDECIDED, Verdict


def _gained(context: Context, step: Step) -> Scalar:
    """The acceleration of the coordinate by the laws, or by the linear equation that is named (`data`: "name", "law")."""
    name, law = step.data["name"], step.data.get("law")
    if not law:
        return context.on_motion(symbol(f"{name}_ddot"))
    context.use(law)
    [(_, _, right)] = relations(context.steps[law].statement)
    return context.value(right)


def _with(value: Scalar, name: str, place: Scalar, speed: Scalar) -> Scalar:
    return substitute(value, {name: place, f"{name}_dot": speed})


def course(context: Context, step: Step) -> Verdict:
    """The stated function of the time solves the equation of motion, and starts as the motion does (`data`: "name",
    "law"), where a parameter has the value that the sentence says (`slots`: "where")."""
    [(left, _, right)] = relations(step.statement)
    name, gained, at = step.data["name"], _gained(context, step), {}
    if step.slots.get("where") is not None:
        [(parameter, _, stated)] = relations(step.slots["where"])
        at = {parameter.name: context.value(stated)}
    place = context.value(right)
    speed = derivative(place, "t")
    follows = substitute(_with(gained, name, place, speed), at)
    if left.name != name or names_in(follows) & {*context.study.system.coordinates, *context.study.system.speeds}:
        return Verdict(UNDECIDED, reason="the acceleration is no function of the time with this")
    found = [same(context, derivative(speed, "t"), follows)]
    begins = [(place, name), (speed, f"{name}_dot")]
    found += [same(context, substitute(a, {"t": NOTHING}), substitute(context.start(symbol(b)), at)) for a, b in begins]
    return weakest(found)


def speed_along(context: Context, step: Step) -> Verdict:
    """dq̇/dq q̇ = q̈ with the stated q̇(q), which starts as the motion does, in that sense (`data`: "name", "way")."""
    [(_, _, right)] = relations(step.statement)
    name, value = step.data["name"], context.value(right)
    gained = _with(_gained(context, step), name, symbol(name), value)
    begin = substitute(value, {name: context.start(symbol(name))})
    first = context.start(symbol(f"{name}_dot"))
    push = context.start(_gained(context, step))
    found = [same(context, derivative(value, name) * value, gained), same(context, begin, first)]
    return weakest([*found, *([] if first else _positive(context, push * step.data["way"]))])


def feature(context: Context, step: Step) -> Verdict:
    """What is stated of the solution follows from the equation of motion (`data`: "name", "key", "form")."""
    [(_, _, right)] = relations(step.statement)
    form, name = step.data["form"], step.data["name"]
    place, speed = symbol(name), symbol(f"{name}_dot")
    stated = form.constant - form.stiffness * place - form.damping * speed - form.drag * speed * speed
    found = same(context, context.on_motion(symbol(f"{name}_ddot")), stated)
    return weakest([found, *FEATURES[step.data["key"]](context, step, context.value(right))])


def _positive(context: Context, *values: Scalar) -> list[Verdict]:
    return [compare(NOTHING, value, context.assumptions) for value in values]


def _amplitude(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """(q - rest)² + q̇²/s, which is kept, is its square at the start."""
    form, name = step.data["form"], step.data["name"]
    away = context.start(symbol(name)) - form.constant / form.stiffness
    square = away * away + context.start(symbol(f"{name}_dot")) ** 2 / form.stiffness
    plain = [same(context, part, NOTHING) for part in (form.damping, form.drag)]
    found = [*plain, *_positive(context, form.stiffness), same(context, value * value, square)]
    return [*found, compare(NOTHING, value, context.assumptions, strict=False)]


def _terminal(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """There the acceleration vanishes, beside it it drives back; no other such speed lies between it and the start."""
    form, speed = step.data["form"], f"{step.data['name']}_dot"
    gained = context.on_motion(symbol(f"{step.data['name']}_ddot"))
    found = [same(context, substitute(gained, {speed: value}), NOTHING)]
    found += _positive(context, -substitute(derivative(gained, speed), {speed: value}))
    other = context.start(symbol(speed)) + value
    return [*found, *(_positive(context, other * value) if form.drag else ())]


def _total(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """q + q̇/b is kept, and q̇ dies out."""
    form = step.data["form"]
    others = [same(context, part, NOTHING) for part in (form.constant, form.stiffness, form.drag)]
    begin = context.start(symbol(f"{step.data['name']}_dot"))
    return [*others, *_positive(context, form.damping), same(context, value * form.damping, begin)]


FEATURES: Mapping[str, Callable[[Context, Step, Scalar], list[Verdict]]] = {
    "amplitude": _amplitude,
    "terminal speed": _terminal,
    "total way": _total,
}
