"""Checks of values that are asked for: at a moment of the motion, and along it; of steady motions, by the acceleration with the
speeds that kept momenta give.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.decide.equal import compare
from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, PI, UNITY, Scalar, is_zero, symbol, time_derivative
from rbpsym.field.calculus import derivative, function, names_in, root, substitute
from rbpsym.field.roots import without_even_roots
from rbpsym.proof.checks.of_steps import first_proved, named_sides, premise_says, right_side, right_sides, same, weakest
from rbpsym.proof.checks.phases import seen_then
from rbpsym.proof.checks.places import under
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step


def _on_motion(context: Context, step: Step, value: Scalar) -> Scalar:
    """A quantity with accelerations and forces of the motion, and works as the steps before say (`data`: "works")."""
    done = {}
    for name, id in step.data["works"].items():
        if name in names_in(value):
            done[name] = premise_says(context, id)
    found: Scalar = context.on_motion(substitute(value, done))
    return found


def value_then(context: Context, step: Step) -> Verdict:
    """Each stated value is that of a quantity in a state of the motion: the start, or one that is looked at anew (`data`:
    "of": the quantity by its letter, "moment")."""
    moment, found = step.data["moment"], []
    for name, stated in named_sides(context, step):
        value = _on_motion(context, step, step.data["of"][name])
        if moment.how != "start":
            verdict, value = seen_then(context, moment, value)
            found.append(verdict)
        value = value if moment.how == "time" else context.start(value)  # in which the time would be that of the start
        found.append(same(context, value, stated))
    return weakest(found)


def value_along(context: Context, step: Step) -> Verdict:
    """Each stated value is that of a quantity in each state, with the speeds that the motion from the start has, in the
    sense in which it sets out (`data`: "of", "ways", and "speeds" that other steps give)."""
    said = [context.value(node.items[0]) for node in step.obligations]
    found = [_sets_out(context, name, way, said) for name, way in step.data["ways"].items()]
    for name, value in named_sides(context, step):
        stated = substitute(value, context.study.system.dependent)
        if step.data.get("constant"):
            whole = context.study.on_motion(step.data["of"][name])
            rate = context.on_motion(time_derivative(whole, context.study.system.scope))
            found += [same(context, rate, NOTHING), same(context, context.start(whole), stated)]
            continue
        gap = _on_motion(context, step, step.data["of"][name]) - stated
        said_so = {f"{name}_dot": premise_says(context, f"speed_at.{name}") for name in step.data["speeds"]}
        speeds = {f"{n}_dot": root(context.along(symbol(f"{n}_dot") ** 2)) * way for n, way in step.data["ways"].items()}
        gap = substitute(substitute(gap, said_so), speeds)
        gap = substitute(gap, {n: premise_says(context, f"place_at.{n}") for n in step.data.get("places", ())})
        is_seen = not is_zero(gap)
        found.append(same(context, without_even_roots(context.along(gap) if is_seen else gap), NOTHING))
    return weakest(found)


def followed(context: Context, step: Step) -> Verdict:
    """The stated function of another coordinate has the rate that the coordinate has, and begins as it does: by the speed
    that another step gives, or the other one's accelerations and first speeds are in that constant ratio (`data`: "name")."""
    name, value = step.data["name"], right_side(context, step)
    begins = [same(context, context.start(value), context.start(symbol(name)))]
    [other] = names_in(value) & {*context.study.system.independent} or {name}  # one that stays where it is: of itself
    slope, rates = derivative(value, other), [symbol(f"{other}_dot"), symbol(f"{name}_dot")]
    if f"speed_at.{name}" in context.steps:
        return weakest([*begins, same(context, premise_says(context, f"speed_at.{name}"), slope * rates[0])])
    gains = [context.on_motion(symbol(f"{n}_ddot")) for n in (other, name)]
    pairs = [(slope * first, second) for first, second in (gains, map(context.start, rates))]
    constant = same(context, derivative(slope, other), NOTHING)
    return weakest([*begins, constant, *(same(context, *pair) for pair in pairs)])


def kept_speed(context: Context, step: Step) -> Verdict:
    """The stated speed is one of those with which the momenta that other steps say are kept are what they were at the start
    (`data`: "speed", "speeds", "momenta")."""
    found = [same(context, right_side(context, step), step.data["speeds"][step.data["speed"]])]
    for id in step.data["momenta"]:
        momentum = premise_says(context, id)
        found.append(same(context, substitute(momentum, step.data["speeds"]), context.start(momentum)))
    return weakest(found)


def _sets_out(context: Context, name: str, way: int, said: list[Scalar]) -> Verdict:
    """The speed at the start, or the acceleration from rest, is not against that sense; or it is as is said to be positive."""
    speed = context.start(symbol(f"{name}_dot"))
    push = speed if not is_zero(speed) else context.start(context.on_motion(symbol(f"{name}_ddot")))
    found = compare(NOTHING, push * way, context.assumptions, strict=False)
    alike = (compare(NOTHING, push * way / value, context.assumptions) for value in said)
    return found if found.is_proved else first_proved(alike, found)


def direction(context: Context, step: Step) -> Verdict:
    """The stated angle is that of the vector which another step states: atan(y/x), half a turn more where x is negative, as
    the step asks for (`data`: "of", the id of that step)."""
    context.use(step.data["of"])
    x, y = right_sides(context, context.steps[step.data["of"]])
    [(_, _, right)] = t.relations(step.statement)
    if is_zero(x):
        side = context.value(right) * 2 / PI
        return weakest([same(context, side * side, UNITY), compare(NOTHING, y * side, context.assumptions)])
    said = [context.value(node.items[0]) for node in step.obligations]
    for way, turn in ((1, NOTHING), (-1, PI)):
        if any(compare(NOTHING, x * way / value, context.assumptions).is_proved for value in (UNITY, *said)):
            inner = [node.arg for node in t.walk(right) if isinstance(node, t.Fn) and node.name == "atan"]
            slope = context.value(inner[0]) if inner else y / x
            told = context.value(right) - turn
            ends = ((slope * side, function("atan", slope) * side) for side in (1, -1))
            found = [weakest([same(context, end, y / x), same(context, told, angle)]) for end, angle in ends]
            return first_proved(found, found[0])
    return undecided("on which side the vector points is not decided")


# how what is asked for is made of what a step says
TURNED: Mapping[str, Callable[[Scalar], Scalar]] = {
    "itself": lambda value: value,
    "its opposite": lambda value: -value,
    "its magnitude": lambda value: value,
    "its reciprocal": lambda value: 1 / value,
    "its square": lambda value: value * value,
    "its frequency": lambda value: PI * 2 / value,
    "the square of its frequency": lambda value: (PI * 2 / value) ** 2,
}


def told_as(said: Scalar, turned: str) -> Scalar:
    """What a step says, as it is compared: its magnitude, where that of it is asked for."""
    return root(said * said) if turned == "its magnitude" else said


def value_told(context: Context, step: Step) -> Verdict:
    """Each value is that of the quantity (`data`: "of"), and, as it stands or turned, what another step says (`data`: "told", the
    ids of these steps, "turned")."""
    rows = named_sides(context, step)
    meant = [same(context, value, step.data["of"][name]) for name, value in rows]
    told = zip(rows, step.data["told"], step.data["turned"], strict=True)
    return weakest((*meant, *(_is_told(context, value, id, turned) for (_, value), id, turned in told)))


def _is_told(context: Context, value: Scalar, id: str, turned: str) -> Verdict:
    if not id:
        return undecided("no step of the derivation says this")
    context.use(id)
    rows = list(t.relations(context.steps[id].statement))
    sides = [*(row[0] for row in rows if isinstance(row[0], t.Num)), *(row[2] for row in rows)]  # 0 = F says that F vanishes
    said = [told_as(context.value(side), turned) for side in sides]
    found = [same(context, TURNED[turned](value), each) for each in said]
    return first_proved(found, found[-1])


def steady_place(context: Context, step: Step) -> Verdict:
    """At the stated place, and at rest there, the acceleration vanishes (`data`: "name", "speeds", the steps that give the
    speeds of the others, "place")."""
    place = right_side(context, step)
    there = substitute(_gain(context, step), {step.data["name"]: place})
    return weakest([same(context, there, NOTHING), same(context, place, step.data["place"])])


def steady_frequency(context: Context, step: Step) -> Verdict:
    """What is stated is minus the slope of the acceleration at the place, and positive; the speed itself has no part in first
    order (`data`: the same)."""
    stated, name = right_side(context, step), step.data["name"]
    still = {f"{name}_dot": NOTHING}
    drag = derivative(context.on_motion(symbol(f"{name}_ddot")), f"{name}_dot") if not step.data["speeds"] else NOTHING
    slope = derivative(_gain(context, step), name)
    found = same(context, stated, -substitute(slope, {name: step.data["place"]}))
    found = weakest([found, same(context, substitute(drag, {**still, name: step.data["place"]}), NOTHING)])
    return weakest([found, compare(NOTHING, stated, under(context, step, ">").assumptions)])


def _gain(context: Context, step: Step) -> Scalar:
    """The acceleration at rest with what the other steps say of the other speeds, as a function of the place."""
    said = {f"{id.removeprefix('speed_at.')}_dot": premise_says(context, id) for id in step.data["speeds"]}
    name = step.data["name"]
    gained = substitute(context.on_motion(symbol(f"{name}_ddot")), said)
    return substitute(gained, {f"{name}_dot": NOTHING})
