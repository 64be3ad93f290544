"""Checks of motions as functions of the time: by differentiation, and by what is kept along the motion.

Nothing is integrated here. A function of the time whose second derivative is the acceleration that the laws give with it
and its first derivative, and that starts as the motion does, is the motion (Picard and Lindelöf).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import compare
from rbpsym.decide.rooted import neat, rooted
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, proved, undecided
from rbpsym.expr import tree as t
from rbpsym.field import atoms, generator, has_roots, is_zero, short, time_derivative, without_roots_below
from rbpsym.field.calculus import atom_names, depends_on, derivative, function, names_in, root, substitute
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, symbol
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.proof.checks.of_steps import first_proved, named_sides, premise_says, right_side, same, weakest
from rbpsym.proof.checks.phases import said_of
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step


def _gained(context: Context, step: Step) -> Scalar:
    """The acceleration of the coordinate by the laws, or by the linear equation that is named (`data`: "name", "law")."""
    name, law = step.data["name"], step.data.get("law")
    return premise_says(context, law) if law else context.on_motion(symbol(f"{name}_ddot"))


def _with(value: Scalar, name: str, place: Scalar, speed: Scalar) -> Scalar:
    return substitute(value, {name: place, f"{name}_dot": speed})


def course(context: Context, step: Step) -> Verdict:
    """The stated function of the time solves the equation of motion, and starts as the motion does unless it is what is left
    at last (`data`: "name", "law", "steady"; "beside": all coordinates that the law ties), where a parameter has the value
    that the sentence says (`slots`: "where")."""
    [(letter, place)] = named_sides(context, step)
    name, at, tied = step.data["name"], {}, _tied(context, step, place)
    gained = NOTHING if tied else _gained(context, step)
    if step.slots.get("where") is not None:
        parameter, stated = step.slots["where"].items
        at = {parameter.name: context.value(stated)}
    speed = derivative(place, "t")
    follows = substitute(_with(gained, name, place, speed), at)
    if letter != name or names_in(follows) & {*context.study.system.coordinates, *context.study.system.speeds}:
        return undecided("the acceleration is no function of the time with this")
    follows = neat(follows, _given(context, step)) if has_roots(follows) else follows
    found = tied or [same(context, derivative(speed, "t"), follows)]
    if not step.data["steady"]:
        begins = [(place, name), (speed, f"{name}_dot")]
        found += [same(context, substitute(a, {"t": NOTHING}), substitute(context.start(symbol(b)), at)) for a, b in begins]
    return weakest(found)


def _tied(context: Context, step: Step, stated: Scalar) -> list[Verdict]:
    """Where the law is a system of rows, or other coordinates stand in the acceleration: each row holds with all coordinates,
    of which the stated one is as said."""
    law, moved = context.steps.get(step.data.get("law") or ""), step.data.get("beside", {})
    if law is None:
        gains = {name: context.on_motion(symbol(f"{name}_ddot")) for name in moved}
        others = {key for name in moved if name != step.data["name"] for key in (name, f"{name}_dot")}
        if not names_in(gains.get(step.data["name"], NOTHING)) & others:
            return []
        rules = [(symbol(f"{name}_ddot"), gain) for name, gain in gains.items()]
    elif law.rule == "linear_system":
        context.use(law.id)
        rules = [(context.value(left), context.value(right)) for left, _, right in t.relations(law.statement)]
    else:
        return []
    speeds = {f"{name}_dot": derivative(place, "t") for name, place in moved.items()}
    at = {**moved, **speeds, **{f"{speed.removesuffix('_dot')}_ddot": derivative(v, "t") for speed, v in speeds.items()}}
    rows = (substitute(left - right, at) for left, right in rules)
    begun = {} if step.data["steady"] else {**moved, **speeds}
    begins = ((substitute(value, {"t": NOTHING}), context.start(symbol(name))) for name, value in begun.items())
    solves = [same(context, stated, moved[step.data["name"]]), *(same(context, row, NOTHING) for row in rows)]
    return [*solves, *(same(context, *pair) for pair in begins)]


def reached(context: Context, step: Step) -> Verdict:
    """At the stated time the coordinate or speed has the value, and at none before (`data`: "subject", "value")."""
    subject, time = step.data["subject"], neat(right_side(context, step), context.assumptions)
    name = subject.removesuffix("_dot")
    system = context.study.system
    moving = system.dependent.get(name, symbol(name))
    moving = moving if name == subject else time_derivative(moving, system.scope)
    moving = context.on_motion(symbol(name)) if name in system.unknowns else moving
    whole = moving - substitute(step.data["value"], system.dependent)
    used = [n for n in system.independent if names_in(whole) & {n, f"{n}_dot"}]
    said = {n: place for n in used if (place := said_of(context, n)) is not None}
    at = said | {f"{n}_dot": derivative(place, "t") for n, place in said.items()}
    gap = substitute(whole, at)
    left = neat(substitute(gap, {"t": time}), context.assumptions)
    there = same(context, left, NOTHING)
    there = there if there.is_proved else same(context, _without_logarithms(left), NOTHING)
    return weakest([there, _lies_ahead(context, step, time), _is_first(context, step, gap, time)])


def _without_logarithms(value: Scalar) -> Scalar:
    """f gⁿ e^{c/a} - 1 for a (ln f + n ln g) + c, which vanishes with it; else the value."""
    logs = [index for index in value.atoms() if atoms.atom(index).kind == "ln"]
    parts = [value.num.by_power(index) for index in logs]
    slopes = [Scalar(part[1]) / Scalar(value.den) for part in parts if 1 in part]
    counts = [short(slope / slopes[0]).number() for slope in slopes]
    if not logs or len(slopes) < len(logs) or not all(isinstance(count, int) for count in counts):
        return value
    rest = value - sum((slope * Scalar(generator(i)) for slope, i in zip(slopes, logs, strict=True)), NOTHING)
    powers = (atoms.atom(index).arg ** count for index, count in zip(logs, counts, strict=True))
    return math.prod(powers, start=function("exp", short(rest / slopes[0]))) - 1


def _lies_ahead(context: Context, step: Step, time: Scalar) -> Verdict:
    """It is not negative by itself, or since a condition says so of the argument of its logarithm."""
    found = positive(context, step, time)
    logs = [atoms.atom(index).arg for index in time.atoms() if atoms.atom(index).kind == "ln"]
    if found.is_proved or len(logs) != 1:
        return found
    said = [context.value(node.items[0]) for node in step.obligations]
    alike = [UNITY, *said, *(a * b for a in said for b in said)]
    grows = compare(NOTHING, time / function("ln", logs[0]), _given(context, step))
    beyond = (compare(NOTHING, without_roots_below((logs[0] - 1) / value), _given(context, step)) for value in alike)
    return next((weakest([grows, verdict]) for verdict in beyond if verdict.is_proved), found)


def _given(context: Context, step: Step) -> Assumptions:
    """Declared signs and ranges, and the conditions of the step."""
    said = [Demand(context.value(node.items[0]), node.ops[0]) for node in step.obligations]
    alone = {next(iter(names_in(one.value))): "positive" for one in said if one.op == ">" and len(names_in(one.value)) == 1}
    alone = {name: sign for name, sign in alone.items() if any(one.value == symbol(name) for one in said)}
    return assuming(context.assumptions.with_signs(alone), said, whole=True)


def positive(context: Context, step: Step, value: Scalar) -> Verdict:
    """It is not negative by the declared signs, or is positive where a condition of the step is."""
    found = compare(NOTHING, value, _given(context, step), strict=False)
    ratios = (without_roots_below(value / context.value(node.items[0])) for node in step.obligations)
    alike = (compare(NOTHING, ratio, _given(context, step)) for ratio in ratios)
    return found if found.is_proved else first_proved(alike, found)


def _is_first(context: Context, step: Step, gap: Scalar, time: Scalar) -> Verdict:
    """What vanishes then grows all the time, or falls, from rest ever faster too; or it bends to one side all the time, towards
    zero from where it begins, or begins with zero; or it is a cos ϑt + b sin ϑt + c, with c = 0
    or b = 0 in the first half of the period, else in its first quarter. What dies out is taken off as a factor."""
    slope = derivative(gap, "t")
    dying = [function("exp", atoms.atom(i).arg) for i in gap.atoms() if atoms.atom(i).kind == "exp" and "t" in atom_names(i)]
    steady = [slope, *(short(slope / factor) for factor in dying)]
    given_, alike = _given(context, step).with_signs({"t": "positive"}), [gap, *(short(gap / factor) for factor in dying)]
    slopes = (sign(derivative(value, "t"), given_) for value in alike)
    if any(one.is_nonzero for one in slopes) or any(value and not depends_on(value, "t") for value in steady):
        return proved("it changes in one sense all the time")
    begins, bends = sign(substitute(slope, {"t": NOTHING}), given_), sign(derivative(slope, "t"), given_)
    if bends.is_nonzero and bends.sense and (begins.kind == "zero" or begins.sense == bends.sense):
        return proved("it changes in one sense, ever faster")
    if bends.is_nonzero and bends.sense * sign(substitute(gap, {"t": NOTHING}), given_).sense < 0:
        return proved("it bends towards zero all the time")
    last = sign(rooted(substitute(slope, {"t": time}), given_), given_)
    if bends.is_nonzero and begins.is_nonzero and last.kind in (begins.kind, "zero"):
        return proved("it changes in one sense until then")
    if bends.is_nonzero and is_zero(substitute(gap, {"t": NOTHING})):
        return proved("it bends to one side all the time, and begins with zero")
    for value in alike:
        rates = {derivative(Scalar(atoms.atom(i).arg), "t") for i in value.atoms() if atoms.atom(i).kind in ("cos", "sin")}
        rates = {rate for rate in rates if rate and not depends_on(rate, "t")}
        bent = derivative(derivative(value, "t"), "t")
        for rate in rates:
            constant = value + bent / rate**2
            if depends_on(short(constant), "t"):
                continue
            half = is_zero(constant) or is_zero(substitute(derivative(value, "t"), {"t": NOTHING}))
            return compare(time * rate, PI if half else PI / 2, _given(context, step), strict=False)
    return undecided("whether it has the value before is not decided")


def speed_along(context: Context, step: Step) -> Verdict:
    """dq̇/dq q̇ = q̈ with the stated q̇(q), which starts as the motion does, in that sense (`data`: "name", "way")."""
    name, value = step.data["name"], right_side(context, step)
    gained = _with(_gained(context, step), name, symbol(name), value)
    begin = substitute(value, {name: context.start(symbol(name))})
    first = context.start(symbol(f"{name}_dot"))
    push = first or context.start(_gained(context, step))
    found = [same(context, derivative(value, name) * value, neat(gained, _given(context, step)))]
    plain = same(context, begin, first)
    if first and plain.is_proved:
        return weakest([*found, plain])
    return weakest([*found, same(context, begin * begin, first * first), positive(context, step, push * step.data["way"])])


def by_speed(context: Context, step: Step) -> Verdict:
    """dt/du a(u) = 1 and dx/du a(u) = u with the acceleration a(u) at the speed u; both begin as the motion does, and are stated
    for one speed, up to which a(u) changes to one side and keeps its sign (`data`: "name", "value", "letter", "time",
    "place")."""
    name, letter, value = step.data["name"], step.data["letter"], step.data["value"]
    gained = substitute(context.on_motion(symbol(f"{name}_ddot")), {f"{name}_dot": symbol(letter)})
    first, given = context.start(symbol(f"{name}_dot")), _given(context, step)
    if names_in(gained) & {*context.study.system.coordinates, *context.study.system.speeds, "t"}:
        return undecided("the acceleration is no function of the speed alone")
    kinds = {sign(end, given).kind or "" for end in (first, value)} - {"zero"}
    if kinds not in ({"positive"}, {"negative"}):  # where it is zero the acceleration of a constant power has no value
        return undecided("whether the speed vanishes on the way is not decided")
    given = given.with_signs({letter: kinds.pop()})
    ways = (sign(part, given).is_nonzero for part in (derivative(Scalar(gained.num), letter), Scalar(gained.den)))
    found = [] if all(ways) else [undecided("whether the acceleration keeps its sign is not decided")]
    parts = (step.data["time"], UNITY, NOTHING), (step.data["place"], symbol(letter), context.start(symbol(name)))
    told = [row for row in parts if row[0] is not None]
    for (part, rate, begin), (_, stated) in zip(told, named_sides(context, step), strict=True):
        found.append(same(context, derivative(part, letter) * gained, rate))
        found += [same(context, substitute(part, {letter: at}), to) for at, to in ((first, begin), (value, stated))]
    ends = [substitute(Scalar(gained.num), {letter: at}) for at in (first, value)]
    return weakest([*found, positive(context, step, ends[0] * ends[1]), positive(context, step, (value - first) * ends[1])])


def swing(context: Context, step: Step) -> Verdict:
    """The place goes to and fro as q = q* + (2/n) asin(k s) with s = sin u, where (ds/dt)² = ϑ²(1 - s²)(1 - k² s²): that is
    q̇² with the stated k, ϑ and q*, and the time from s = 0 to 1 is K(k)/ϑ, which is to be a quarter of the period (`data`:
    "name", "quarters"). It begins at rest there or on its way."""
    if step.data["height"] is not None:
        return _isochrone(context, step, step.data["height"])
    name, value, rest, part = step.data["name"], right_side(context, step), context.value(step.slots["rest"]), step.data["part"]
    [index] = [index for index in value.atoms() if atoms.atom(index).kind == "elliptic_k"]
    modulus, rate = atoms.atom(index).arg, Scalar(generator(index)) * step.data["quarters"] / value
    letter = context.study.letters.free("s")
    s = symbol(letter)
    place = rest + function("asin", root(modulus) * s) * part
    square = substitute(context.along(symbol(f"{name}_dot") ** 2), {name: place})
    moved = derivative(place, letter)
    found = [same(context, square, moved * moved * rate * rate * (1 - s * s) * (1 - modulus * s * s))]
    found.append(compare(NOTHING, value, _given(context, step)))  # the square does not tell a time from its opposite
    if step.data["quarters"] < WHOLE:
        away, end = context.start(symbol(name)) - rest, PI * part / 2
        found.append(same(context, context.start(symbol(f"{name}_dot")), NOTHING))
        found += [compare(way * away, end, _given(context, step)) for way in (1, -1)]
    return weakest(found)


UNSAID = undecided("not every force has a potential energy")


def _isochrone(context: Context, step: Step, height: Scalar) -> Verdict:
    """V is V_0 cos² ϑt: V'² q̇² = 4 ϑ² V (V_0 - V), with the potential energy V over its value at rest, which grows to both sides,
    and is the same there."""
    name, value, rest = step.data["name"], right_side(context, step), context.value(step.slots["rest"])
    rate, place, slope = PI / 2 * step.data["quarters"] / value, symbol(name), derivative(height, name)
    begun, square = context.start(place), context.along(symbol(f"{name}_dot") ** 2)
    left = substitute(height, {name: begun}) - height
    found = [same(context, slope * slope * square, rate * rate * height * left * 4)]
    found += [same(context, substitute(height, {name: at}), to) for at, to in ((rest, NOTHING), (rest * 2 - place, height))]
    found.append(same(context, context.start(symbol(f"{name}_dot")), NOTHING))
    potential = context.study.potential  # of which the sentence speaks: twice as much would swing in the same time
    found.append(UNSAID if potential is None else same(context, derivative(potential, name), slope))
    low, high = context.assumptions.range_of(name)
    for way, ends in ((1, (rest, high)), (-1, (low, rest))):
        found.append(compare(NOTHING, slope * way, context.assumptions.with_range(name, *ends)))
    moved = any(is_zero(context.value(node.items[0]) - (begun - rest)) for node in step.obligations if node.ops[0] == "!=")
    found.append(proved("it begins elsewhere") if moved else compare(NOTHING, (begun - rest) ** 2, _given(context, step)))
    return weakest([*found, compare(NOTHING, value, _given(context, step))])


WHOLE = 4  # quarters of a period


def feature(context: Context, step: Step) -> Verdict:
    """What is stated of the solution follows from the equation of motion (`data`: "name", "key", "law", "form",
    "steady")."""
    form, name = step.data["form"], step.data["name"]
    place, speed = symbol(name), symbol(f"{name}_dot")
    found = same(context, _gained(context, step), form.at_speed(speed) - form.stiffness * place + form.drive)
    return weakest([found, *FEATURES[step.data["key"]](context, step, right_side(context, step))])


def _positive(context: Context, *values: Scalar) -> list[Verdict]:
    return [compare(NOTHING, value, context.assumptions) for value in values]


def _swing(context: Context, step: Step) -> tuple[Scalar, list[Verdict]]:
    """The square of the amplitude: of the free oscillation (q - rest)² + q̇²/s at the start, which is kept; of what is left
    of a driven one p² + (dp/dt)²/Ω²; and what has to be so for that."""
    form, name, steady = step.data["form"], step.data["name"], step.data["steady"]
    if not form.drive:
        away = context.start(symbol(name)) - form.constant / form.stiffness
        plain = [same(context, value, NOTHING) for value in (form.damping, form.drag)]
        square = away * away + context.start(symbol(f"{name}_dot")) ** 2 / form.stiffness
        return square, [*plain, positive(context, step, form.stiffness)]
    part = steady - form.constant / form.stiffness
    rate, gained = derivative(steady, "t"), context.on_motion(symbol(f"{name}_ddot"))
    found = [same(context, derivative(rate, "t"), _with(gained, name, steady, rate))]
    found.append(same(context, derivative(rate, "t"), -part * form.frequency**2))
    return part * part + (rate / form.frequency) ** 2, [*found, positive(context, step, form.stiffness)]


def _amplitude(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    square, found = _swing(context, step)
    return [*found, same(context, value * value, square), compare(NOTHING, value, context.assumptions, strict=False)]


def _lag(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """With p = A cos(Ωt - δ) for the drive D = H cos Ωt, or the support D (`slots`: "cause"), which is the part of a place
    that swings: p D + p' D'/Ω² = A H cos δ, and p' D - p D' = A H Ω sin δ ≥ 0."""
    form, [_, found] = step.data["form"], _swing(context, step)
    part, force = step.data["steady"] - form.constant / form.stiffness, form.drive
    if step.slots.get("cause") is not None:
        force = context.value(step.slots["cause"])
        centres = [state.center for state in context.study.system.bodies.values()]
        gaps = [short(place - force) for centre in centres for place in (centre.x, centre.y)]
        found.append(same(context, derivative(derivative(force, "t"), "t"), -force * form.frequency**2))
        if all(depends_on(gap, "t") for gap in gaps):
            return [undecided("no body is driven so")]
    rate, gain = derivative(part, "t"), derivative(force, "t")
    along, across = part * force + rate * gain / form.frequency**2, (rate * force - part * gain) / form.frequency
    cosine = function("cos", value)
    found.append(same(context, cosine * cosine * (along * along + across * across), along * along))
    signs = (across, cosine * along, value, PI - value)
    return [*found, *(compare(NOTHING, one, context.assumptions, strict=False) for one in signs)]


def _fastest(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    square, found = _swing(context, step)
    form = step.data["form"]
    rate = form.frequency**2 if form.drive else form.stiffness
    return [*found, same(context, value * value, square * rate), compare(NOTHING, value, context.assumptions, strict=False)]


def _terminal(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """There the acceleration vanishes, beside it it drives back; no other such speed lies between it and the start."""
    form, speed = step.data["form"], f"{step.data['name']}_dot"
    gained = context.on_motion(symbol(f"{step.data['name']}_ddot"))
    found = [same(context, substitute(gained, {speed: value}), NOTHING)]
    found += _positive(context, -substitute(derivative(gained, speed), {speed: value}))
    begin = context.start(symbol(speed))
    if form.drag:  # a (u - v)(u + v) goes towards u from where u + v has its sign
        return [*found, *_positive(context, (begin + value) * value)]
    return [*found, positive(context, step, (value - begin) * context.start(gained))]


def _total(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """q - q̇²/((2 - n) f) is kept where f, the acceleration, goes as q̇ⁿ with n < 2 and drives back: q̇ dies out."""
    form, name = step.data["form"], f"{step.data['name']}_dot"
    speed, begin = symbol(name), context.start(symbol(name))
    gained = form.at_speed(speed)
    sense = sign(begin, context.assumptions).kind
    given = context.assumptions.with_signs({name: sense} if sense in ("positive", "negative") else {})
    power, pushed = neat(speed * derivative(gained, name) / gained, given).number(), substitute(gained, {name: begin})
    if power is None or power >= 2:
        return [undecided("the acceleration is no such power of the speed")]
    others = [same(context, part, NOTHING) for part in (form.stiffness, form.drive)]
    return [*others, *_positive(context, -short(pushed / begin)), same(context, value * pushed * (2 - power), -(begin * begin))]


def _lasting(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    form = step.data["form"]
    others = [same(context, part, NOTHING) for part in (form.stiffness, form.drag)]
    return [*others, *_positive(context, form.damping), same(context, value * form.damping, UNITY)]


def _mode(context: Context, step: Step, value: Scalar) -> list[Verdict]:
    """The squares of γ = b/2, ϑ = √s, ϑ_d = √(s - b²/4), by the slopes -s and -b of the acceleration."""
    gained, name = context.on_motion(symbol(f"{step.data['name']}_ddot")), step.data["name"]
    square, rate = -derivative(gained, name), (derivative(gained, f"{name}_dot") / 2) ** 2
    known = {"decay rate": rate, "undamped frequency": square, "damped frequency": square - rate}
    return [same(context, value * value, known[step.data["key"]]), compare(NOTHING, value, context.assumptions, strict=False)]


FEATURES: Mapping[str, Callable[[Context, Step, Scalar], list[Verdict]]] = {
    "amplitude": _amplitude,
    "phase lag": _lag,
    "greatest speed": _fastest,
    "terminal speed": _terminal,
    "total way": _total,
    "time constant": _lasting,
    **dict.fromkeys(("decay rate", "undamped frequency", "damped frequency"), _mode),
}
