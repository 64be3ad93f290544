"""What is told of a motion that is known as a function of the time: its amplitude, its last speed, when it comes somewhere."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import there
from rbpsym.field import NOTHING, PI, UNITY, Poly, Scalar, atoms, generator, is_zero, short, symbol, with_image
from rbpsym.field.calculus import atom_names, depends_on, derivative, function, names_in, root, substitute
from rbpsym.field.exponentials import with_exponentials_joined
from rbpsym.field.integration import with_logarithm
from rbpsym.mechanics.demands import WAYS, Demand, settle
from rbpsym.mechanics.forms import power_law, raised
from rbpsym.mechanics.friction import slips, stops
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solutions import Given, kind_of, steady

Letters = Mapping[str, Scalar]


def speed_along(known: Given, name: str) -> Scalar | None:
    """The speed as a function of the place, where a resistance tells it, in the sense in which the motion sets out."""
    form, way = known.form, symbol(name) - known.place
    if not form.drag:
        law = power_law(known)
        grown = law.grown(2 - law.power, way * law.way) if law and law.power else None
        size = raised(grown[0], 1 / Fraction(2 - law.power)) if law and grown else None
        return size * grown[2] * law.way if law and grown and size is not None else None
    dies = function("exp", -form.drag * way)
    if not form.constant:
        return known.speed * dies
    last = short(form.constant / form.drag)
    square = last + (known.speed**2 - last) * dies**2
    return function("sqrt", short(square)) * known.sense(known.speed or form.constant)


def by_speed(known: Given, letter: str) -> tuple[Scalar, Scalar | None, Scalar | None] | None:
    """The acceleration, where it is a function of the speed alone, which the letter stands for, and as such functions the time
    and the place, as far as their integrals have closed forms; None for another acceleration."""
    form, speed, found = known.form, symbol(letter), list[Scalar | None]()
    gained = short(substitute(form.at_speed(symbol(f"{known.name}_dot")), {f"{known.name}_dot": speed}))
    if form.stiffness or form.drive or form.drawn or depends_on(form.constant, "t") or not gained:
        return None
    for rate, begin in ((UNITY, NOTHING), (speed, known.place)):
        whole, factor, inner = with_logarithm(rate / gained, letter) or (None, NOTHING, UNITY)
        since = None if whole is None else begin + whole - substitute(whole, {letter: known.speed})
        ratio = short(inner / substitute(inner, {letter: known.speed}))
        found.append(since if since is None or not factor else since + factor * function("ln", ratio))
    return gained, found[0], found[1]


def sets_out(known: Given) -> tuple[Demand, ...]:
    """What has to be positive for the sense in which a motion with a resistance sets out, where the square is known alone; and
    for it to go on, where a root tells so."""
    law = None if known.form.drag else power_law(known)
    if law and isinstance(law.power, Fraction):
        return (Demand(there(law.grown(2 - law.power, (symbol(known.name) - known.place) * law.way))[0]),)
    push = known.speed or known.form.constant
    is_sure = not known.form.drag or not known.form.constant or sign(push, known.study.assumptions).kind in WAYS
    return () if is_sure else (Demand(push * known.sense(push)),)


def swings(known: Given, key: str) -> tuple[Demand, ...]:
    """What has to be positive for the motion to swing, or to go on, of which this is told."""
    if key == "terminal speed":
        return tuple(Demand(slip) for slip in last_slips(known, _terminal(known)))
    if key not in ("amplitude", "greatest speed", "phase lag"):
        return ()
    at_last = known.form.drive and key != "amplitude"  # when the free motion has died out
    return (Demand(known.form.stiffness), *([Demand(known.form.damping)] if at_last else []))


def _swing(known: Given) -> Scalar | None:
    """The square of the amplitude: (q - rest)² + q̇²/s of a free oscillation; of a driven one that of what is left at last."""
    form = known.form
    if form.drive and not form.stiffness and not form.damping:
        return None  # what nothing brings back goes on as it began, beside the swing
    if form.drive:
        swing, gap, drag = resonance(known)
        return short(swing * swing / (gap * gap + drag * drag))
    if form.damping or form.drag or known.sense(form.stiffness) <= 0:
        return None
    return short((known.place - form.rest) ** 2 + known.speed**2 / form.stiffness)


def resonance(known: Given) -> tuple[Scalar, Scalar, Scalar]:
    """(H, a, b) with the amplitude H/√(a² + b²) of what is driven, without what stands below in the stiffness."""
    form = known.form
    across = derivative(form.drive, "t") / form.frequency
    swing = known.root(form.drive * form.drive + across * across)
    below = Scalar(form.stiffness.den) * Scalar(Poly({tuple((i, -e) for i, e in form.stiffness.num.content()[1] if e < 0): 1}))
    gap, drag = form.stiffness - form.frequency**2, form.damping * form.frequency
    return short(swing * below), short(gap * below), short(drag * below)


def _amplitude(known: Given) -> Scalar | None:
    square = _swing(known)
    return None if square is None else known.root(square)


def support(known: Given) -> Scalar | None:
    """How a support swings, if the drive is that alone: what of the places of bodies is told to swing."""
    places = (part for state in known.study.system.bodies.values() for part in (state.center.x, state.center.y))
    gained = {short(-derivative(derivative(place, "t"), "t") / known.form.frequency**2) for place in places} - {NOTHING}
    is_given = len(gained) == 1 and not names_in(next(iter(gained))) & {*known.study.system.coordinates}
    return gained.pop() if is_given else None


def _lag(known: Given) -> Scalar | None:
    """By which angle, from 0 to π, what is driven is behind the support that swings, or behind the force, at last."""
    if not known.form.drive:
        return None
    cause = support(known)
    if cause is None:
        _, gap, drag = resonance(known)
        return function("acos", gap / known.root(gap * gap + drag * drag))
    part = steady(known) - known.form.rest
    rate, gain, frequency = derivative(part, "t"), derivative(cause, "t"), known.form.frequency
    across = (rate * cause - part * gain) / frequency  # A H sin δ of p = A cos(Ωt - δ) and the cause H cos Ωt
    if not sign(short(across), known.study.assumptions).is_nonnegative:
        return None
    return PI / 2 - function("atan", short((part * cause + rate * gain / frequency**2) / across))


def _fastest(known: Given) -> Scalar | None:
    """The frequency times the amplitude."""
    square, form = _swing(known), known.form
    return None if square is None else known.root(square * (form.frequency**2 if form.drive else form.stiffness))


def _terminal(known: Given) -> Scalar | None:
    """The speed at which the resistance balances what is constant."""
    form = known.form
    if form.law:
        places = [place for place in zeros(form.law, f"{known.name}_dot") if known.sense(place * known.speed) > 0]
        return places[0] if len(places) == 1 else None
    if form.stiffness or form.drive or not form.constant:
        return None
    if form.damping:
        return short(form.constant / form.damping)
    if not form.drag or known.sense(form.constant * form.drag) <= 0:
        return None
    return known.root(form.constant / form.drag) * known.sense(form.constant)


def _total(known: Given) -> Scalar | None:
    """The way that it still makes until a resistance in proportion to a power of the speed, or a constant one, has stopped it."""
    law = power_law(known) if known.speed else None
    if law is None or law.power >= 2 or known.sense(law.factor) >= 0:
        return None
    gone, first, _ = there(law.grown(2 - law.power, UNITY))
    return short(first / (first - gone) * law.way)


# what is asked of a coordinate -> the letter that it gets, and what finds it
FEATURES: Mapping[str, tuple[str, Callable[[Given], Scalar | None]]] = {
    "amplitude": ("A", _amplitude),
    "phase lag": ("delta", _lag),
    "greatest speed": ("v_max", _fastest),
    "terminal speed": ("v_end", _terminal),
    "total way": ("s_end", _total),
    "time constant": ("tau", lambda known: short(1 / known.form.damping) if kind_of(known.form) == "resisted" else None),
    "decay rate": ("gamma", lambda known: short(known.form.damping / 2)),
    "undamped frequency": ("vartheta", lambda known: function("sqrt", known.form.stiffness)),
    "damped frequency": ("vartheta_d", lambda known: function("sqrt", known.form.gap)),
}


OF_MODE = ("decay rate", "undamped frequency", "damped frequency")


def feature(known: Given, key: str) -> Scalar | None:
    """What is told of the whole motion; None where it never swings so, and where kinetic friction acts, with which it ends when
    the slip stops, as it never does where the last speed is in its sense. Those of a mode hold as long as it lasts."""
    if settle((*known.valid, *swings(known, key)), known.study.assumptions) is None:
        return None
    if key in OF_MODE:
        return FEATURES[key][1](known)
    value = None if key != "terminal speed" and stops(known.study.system) else FEATURES[key][1](known)
    return value if all(known.sense(slip, open_=1) > 0 for slip in last_slips(known, value)) else None


def last_slips(known: Given, speed: Scalar | None) -> list[Scalar]:
    """The slips at a last speed, if there is one, where kinetic friction acts."""
    at = {f"{known.name}_dot": speed or NOTHING}
    return [] if speed is None else [substitute(slip, at) for slip in slips(known.study.system).values()]


# --- when it comes somewhere


def time_to(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """The first t > 0 at which a function of the time vanishes, and what has to be positive for that; None where no formula
    gives it: one is found where the time stands in it as t, as t and t², or once in e^{λt}, in a logarithm or a root, in e^{ηt}
    and e^{-ηt} alone, or in sines and cosines of ϑt. `letters` stand for their values in it, and in the time that is found."""
    ways = (_by_power, _by_square, _by_growth, _by_pair, _by_logarithm, _by_root, _by_wave)
    found = (find(_without_factor(Scalar(gap.num)), known, letters) for find in ways)
    return next((one for one in found if one is not None), None)


def _without_factor(gap: Scalar) -> Scalar:
    """Without what dies out like e^{-γt} and is no more than a factor."""
    for index in (index for index in _moving(gap) if atoms.atom(index).kind == "exp"):
        parts = gap.num.by_power(index)
        gap = Scalar(next(iter(parts.values()))) if len(parts) == 1 else gap
    return gap


def _moving(gap: Scalar) -> list[int]:
    """The atoms in which the time stands."""
    return [index for index in gap.atoms() if "t" in atom_names(index)]


def _linear(gap: Scalar, index: int) -> tuple[Scalar, Scalar] | None:
    """(a, b) of a x + b, for a generator x."""
    parts = {power: Scalar(part) for power, part in gap.num.by_power(index).items()}
    least = min(parts)
    parts = {power - least: part for power, part in parts.items()}
    if set(parts) != {0, 1} or any(depends_on(part, "t") for part in parts.values()):
        return None
    return parts[1], parts[0]


def _by_power(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """t itself, or the one e^{λt} in it."""
    moving = _moving(gap)
    parts = _linear(gap, moving[0]) if len(moving) == 1 else None
    kind = atoms.atom(moving[0]).kind if parts else ""
    if parts is None or kind not in ("symbol", "exp"):
        return None
    value = short(-parts[1] / parts[0])
    whole = substitute(value, letters)
    if kind == "symbol":
        return value, (Demand(whole),)
    rate = derivative(atoms.atom(moving[0]).arg, "t")
    way = known.sense(substitute(rate, letters))
    return function("ln", value**way) / (rate * way), (Demand(whole), Demand((whole - 1) * way))


def _by_square(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a t² + b t + c = 0: where a and c have unlike signs one root is positive; where b has not that of both, the less one is."""
    if any(atoms.atom(index).kind != "symbol" for index in _moving(gap)):
        return None
    slope = derivative(gap, "t")
    c, b = (substitute(part, {"t": NOTHING}) for part in (gap, slope))
    a = derivative(slope, "t") / 2
    way = known.sense(substitute(a, letters))
    side = known.sense(substitute(c, letters)) * way
    if not way or not side or depends_on(a, "t"):
        return None
    spread = short(b * b - a * c * 4)
    asked = (a * way, c * side * way, *((-b * way, *([spread] if spread else [])) if side > 0 else ()))
    if known.sense(substitute(asked[-1], letters)) <= 0:
        return None
    return (root(spread) * -side * way - b) / (a * 2), tuple(Demand(short(substitute(part, letters))) for part in asked)


def _by_growth(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a e^{ηt} + b e^{-ηt} + c = 0 where a and b have one sign, and c the other one: after the least value between."""
    moving = _moving(gap)
    rates = {index: derivative(atoms.atom(index).arg, "t") for index in moving if atoms.atom(index).kind == "exp"}
    if len(moving) != 2 or rates.keys() != set(moving) or not is_zero(sum(rates.values(), NOTHING)):
        return None
    first, second = sorted(rates, key=lambda index: -known.sense(substitute(rates[index], letters)))
    a, b = (Scalar(gap.num.by_power(index).get(1, Poly({}))) for index in (first, second))
    c = short(gap - a * Scalar(generator(first)) - b * Scalar(generator(second)))
    way = known.sense(substitute(a, letters))
    if not way or any(depends_on(part, "t") for part in (a, b, c)):
        return None
    value = (root(short(c * c - a * b * 4)) * way - c) / (a * 2)
    asked = tuple(Demand(short(substitute(part * way, letters))) for part in (a, b, -(a + b + c)))
    return function("ln", value) / rates[first], asked


def _by_pair(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a e^{ηt} + b e^{ζt} = 0 as e^{(η-ζ)t} = -b/a, where that is greater than one for a rate that is positive."""
    moving = _moving(gap)
    if len(moving) != 2 or any(atoms.atom(index).kind != "exp" for index in moving):
        return None
    parts = [Scalar(gap.num.by_power(index).get(1, Poly({}))) for index in moving]
    rest = sum((part * -Scalar(generator(index)) for part, index in zip(parts, moving, strict=True)), gap)
    rate = short(derivative(atoms.atom(moving[0]).arg - atoms.atom(moving[1]).arg, "t"))
    if not is_zero(rest) or any(depends_on(part, "t") for part in (*parts, rate)):
        return None
    way = known.sense(substitute(rate, letters))
    value = short(-parts[1] / parts[0]) ** way
    return function("ln", value) / (rate * way), (Demand(substitute(value - 1, letters)),)


def _by_logarithm(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a ln f(t) + b + c t = 0 as f(t) e^{ct/a} = e^{-b/a}."""
    logs = [index for index in _moving(gap) if atoms.atom(index).kind == "ln"]
    if logs and len(_moving(gap)) > 1:  # the time beside it is joined with exponentials in it
        gap = neat(substitute(gap, letters), known.assumptions)
        logs = [index for index in _moving(gap) if atoms.atom(index).kind == "ln"]
    parts = {power: Scalar(part) for power, part in gap.num.by_power(logs[0]).items()} if len(logs) == 1 else {}
    parts = {0: NOTHING, **parts}
    slope = neat(derivative(parts[0], "t") / parts[1], known.assumptions) if parts.keys() == {0, 1} else symbol("t")
    if depends_on(slope, "t") or depends_on(parts[1], "t"):
        return None
    left = function("exp", short(-substitute(parts[0], {"t": NOTHING}) / parts[1]))
    grown = with_exponentials_joined(atoms.atom(logs[0]).arg * function("exp", slope * symbol("t")))
    return time_to(grown - left, known, letters)


def _by_root(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a √f(t) + b = 0 as f(t) = (b/a)², where -b/a is not negative."""
    moving = _moving(gap)
    parts = _linear(gap, moving[0]) if len(moving) == 1 and atoms.atom(moving[0]).kind == "root" else None
    value = short(-parts[1] / parts[0]) if parts else NOTHING
    found = time_to(atoms.atom(moving[0]).arg - value**2, known, letters) if parts else None
    return None if found is None else (found[0], (*found[1], Demand(substitute(value, letters), ">=")))


def _by_wave(gap: Scalar, known: Given, letters: Letters) -> tuple[Scalar, tuple[Demand, ...]] | None:
    """a cos ϑt + b sin ϑt + c = 0, one of a, b and c being zero."""
    moving = {atoms.atom(index).kind: index for index in _moving(gap)}
    if not moving or not moving.keys() <= {"cos", "sin"} or len(moving) != len(_moving(gap)):
        return None
    angle = atoms.atom(next(iter(moving.values()))).arg
    rate = derivative(Scalar(angle), "t")
    parts = {kind: gap.num.by_power(index) for kind, index in moving.items()}
    if any(set(powers) - {0, 1} for powers in parts.values()) or Scalar(angle) != rate * symbol("t"):
        return None
    a, b = (Scalar(parts[kind].get(1, Poly({}))) if kind in parts else NOTHING for kind in ("cos", "sin"))
    c = short(gap - a * function("cos", Scalar(angle)) - b * function("sin", Scalar(angle)))
    if depends_on(c, "t") or depends_on(a, "t") or depends_on(b, "t"):
        return None
    value = short(-(a if a and b else c) / (b or a))
    whole = neat(substitute(value, letters), known.study.assumptions)
    if not b:
        return function("acos", value) / rate, () if is_zero(whole + 1) else (Demand(UNITY - whole * whole),)
    if not a:
        top = () if is_zero(whole - 1) else (Demand(whole), Demand(UNITY - whole))
        return (function("asin", value) / rate, top) if c else (PI / rate, ())
    if c:
        return None
    push = substitute(-a * b, letters)
    way = known.sense(push)
    return (function("atan", value) + (PI if way < 0 else NOTHING)) / rate, (Demand(push * way),)


def without_logarithms(value: Scalar) -> Scalar:
    """e^{n ln x} as xⁿ for whole n."""
    for index in value.atoms():
        found = atoms.atom(index)
        logs = [i for i in found.arg.atoms() if atoms.atom(i).kind == "ln"] if found.kind == "exp" else []
        power = (found.arg / Scalar(generator(logs[0]))).number() if len(logs) == 1 else None
        if isinstance(power, int):
            image = atoms.atom(logs[0]).arg ** power
            value = with_image(value.num, index, image) / with_image(value.den, index, image)
    return value
