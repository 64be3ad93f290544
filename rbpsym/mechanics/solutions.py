"""The motion of one coordinate as a function of the time, where its acceleration has a form that can be integrated.

q̈ = c - s q - b q̇ - k q̇² + h(t) with constant c, s, b, k: free, damped and harmonically driven oscillations (k = 0), resistance
in proportion to the speed (s = k = 0) and to its square (s = b = 0); and q̈ = f(q̇), a power of the
speed, as of a constant power, or an exponential of it. That it starts as the motion does and solves the equation is proved
(`proof.checks.solutions`). Kleppner & Kolenkow, 11; Goldstein, 6.6; Symon, Mechanics, 2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import root_of
from rbpsym.decide.signs import sign
from rbpsym.errors import NoNumber
from rbpsym.field import NOTHING, UNITY, Scalar, is_zero, short, symbol
from rbpsym.field.calculus import depends_on, derivative, function, names_in, root, substitute
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.forms import AccelerationForm, form_of, gathered, power_law, raised
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.orbit import swinging
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study

TIME = symbol("t")
WEAK, CRITICAL, STRONG = "weak", "critical", "strong"
CASES = (WEAK, CRITICAL, STRONG)
SURE: Mapping[str | None, tuple[str, ...]] = {"positive": (WEAK,), "negative": (STRONG,), "zero": (CRITICAL,)}
STEADY, SMALL = "steady", "small"


class InTime(Frozen):
    """A coordinate as a function of the time since the start, in `letters` that stand for these values; where that is so:
    the demands `valid`, and `where` a parameter has a value. `steady`: a driven motion, which `is_left` at last or goes on beside
    the free one."""

    place: Scalar
    letters: Mapping[str, Scalar] = field(default_factory=dict)
    case: str = ""
    valid: tuple[Demand, ...] = ()
    where: tuple[str, Scalar] | None = None
    is_left: bool = False

    @property
    def whole(self) -> Scalar:
        """The place in the quantities of the problem."""
        return without_even_roots(substitute(self.place, self.letters))

    @property
    def speed(self) -> Scalar:
        """The speed in the quantities of the problem."""
        return without_even_roots(derivative(self.whole, "t"))


class Given(Frozen):
    """What a solution is made of: the form of the acceleration, place and speed at the start, the mechanics, the coordinate;
    what it asks for; a `mark` of its letters. A sum of coordinates has no name."""

    form: AccelerationForm
    place: Scalar
    speed: Scalar
    study: Study
    name: str
    valid: tuple[Demand, ...] = ()
    mark: str = ""

    @property
    def assumptions(self) -> Assumptions:
        """What is declared, with what is asked for."""
        return assuming(self.study.assumptions, self.valid)

    def letter(self, name: str) -> Scalar:
        """A letter that the problem does not use."""
        return symbol(self.study.letters.free(name + self.mark))

    def root(self, value: Scalar) -> Scalar:
        """The square root, with what is declared positive taken out."""
        return root_of(short(value), self.assumptions)

    def sense(self, value: Scalar, *, open_: int = 0) -> int:
        """1, -1 or 0: the declared sign, else `open_` if that is one and the author gives no numbers, else that at the sample
        numbers."""
        known, problem = sign(value, self.assumptions), self.study.problem
        if known.sense or known.kind == "zero":
            return known.sense
        if open_ and not problem.example:
            return open_
        try:
            found = number(value, sample(problem, problem.example))
        except NoNumber:
            return 0
        return (found > 0) - (found < 0)


def given(study: Study, name: str, *, small: bool = False, others: Mapping[str, Scalar] | None = None) -> Given | None:
    """What is known of a coordinate, with its `small` oscillations about a stable equilibrium in place of its motion, with
    what is known of `others`; None where its acceleration has no such form, or the start is not said."""
    start = study.system.scope.start
    if study.at_start or name not in start:
        return None
    item = swinging(study) if small else None
    found = _small(study, name, item) if small else form_along(study, name, others)
    speed = start.get(f"{name}_dot", NOTHING)
    if found is None or (names_in(start[name]) | names_in(speed)) & study.system.scope.rates.keys():
        return None
    return Given(found, start[name], speed, study, name, item.valid if item else ())


def form_along(study: Study, name: str, others: Mapping[str, Scalar] | None = None) -> AccelerationForm | None:
    """The form of the acceleration of a coordinate on the motion, with what is known of `others`; None where it has none."""
    gained = None if study.at_start or study.ties else (study.dynamics.accelerations or {}).get(f"{name}_ddot")
    gained = gained if gained is None or not others else short(substitute(gained, others))
    return None if gained is None else form_of(gained, name, {*study.system.scope.rates, "t"})


def _small(study: Study, name: str, item: Equilibrium | None) -> AccelerationForm | None:
    """The acceleration to first order about a place of rest of one degree of freedom."""
    if item is None or name not in item.at or len(study.system.independent) != 1:
        return None
    [[mass]], [[drag]], [[pull]] = (lambda n: (n.inertia, n.damping, n.stiffness))(item.linear)
    stiffness = short(pull / mass)
    return AccelerationForm(short(stiffness * item.at[name]), stiffness, short(drag / mass))


# --- solutions


def courses(known: Given) -> Iterator[InTime]:
    """All solutions, each for its own case: one where the declared signs tell which. Each with what it asks of the time."""
    return (lasting(known, replace(one, valid=(*one.valid, *known.valid))) for one in _cases(known))


def lasting(known: Given, one: InTime) -> InTime:
    """The course, valid as long as kinetic friction keeps its sense on it; of other coordinates the one course that each has."""
    from rbpsym.mechanics import coupled
    if not known.name or not slips(known.study.system):
        return one
    others = {name: given(known.study, name) for name in known.study.system.independent if name != known.name}
    cases = {name: tuple(_cases(other)) for name, other in others.items() if other is not None}
    alone = {name: found[0] for name, found in cases.items() if len(found) == 1}
    return replace(one, valid=(*one.valid, *coupled.lasting(known, {**alone, known.name: one})))


def driven(known: Given) -> InTime:
    """The motion with the frequency of the drive alone; it is left at last where a damped spring lets the free one die out."""
    dies = all(sign(value, known.assumptions).kind == "positive" for value in (known.form.stiffness, known.form.damping))
    return lasting(known, InTime(steady(known), case=STEADY, is_left=dies))


def _cases(known: Given) -> Iterator[InTime]:
    kind = kind_of(known.form)
    if kind != "damped":
        found = SOLVED[kind](known)
        yield from () if found is None else (found,)
        return
    sure = SURE.get(sign(known.form.gap, known.assumptions).kind, CASES)
    for case in sure:
        found = DAMPED[case](known, known.form.gap)
        if found is not None:
            yield found if len(sure) > 1 else replace(found, valid=())


def course(known: Given, case: str = "") -> InTime | None:
    """The solution in the case that is named, else in that of the author's numbers, or that which swings; None where that case
    can't be."""
    found = list(courses(known))
    if not case and len(found) == 1:
        return found[0]
    case = case or (WEAK if known.sense(known.form.gap, open_=1) > 0 else STRONG)
    return next((one for one in found if one.case == case), None)


def kind_of(form: AccelerationForm) -> str:
    """Which of the solved forms it is: a key of SOLVED, or “damped”."""
    if form.drag or form.law or form.drawn:
        return "dragged" if form.drag else "slowed" if form.law else "drawn"
    if form.stiffness:
        return "damped" if form.damping else "swinging"
    return "resisted" if form.damping else "uniform"


def steady(known: Given) -> Scalar:
    """The driven motion that is left when the free one has died out, or that goes on beside it: α h + β dh/dt."""
    form = known.form
    if not form.drive:
        return form.rest
    gap, drag = form.stiffness - form.frequency**2, form.damping * form.frequency
    whole = gap * gap + drag * drag
    if not form.damping:
        return form.rest + form.drive / short(gap)
    return form.rest + (form.drive * gap - derivative(form.drive, "t") * form.damping) / short(whole)


def _free(known: Given) -> tuple[Scalar, Scalar, Scalar]:
    """What is left, and the place and speed at the start relative to it."""
    left = steady(known)
    begin = (substitute(value, {"t": NOTHING}) for value in (left, derivative(left, "t")))
    place, speed = (short(a - b) for a, b in zip((known.place, known.speed), begin, strict=True))
    return left, place, speed


def _uniform(known: Given) -> InTime | None:
    left, place, speed = _free(known)
    gone = gathered(known.form.constant)
    way = None if gone is None else gathered(gone)
    return None if way is None else InTime(left + place + speed * TIME + way)


def _swinging(known: Given) -> InTime | None:
    left, place, speed = _free(known)
    stiffness = known.form.stiffness
    way = known.sense(stiffness, open_=1)
    sure = sign(stiffness, known.assumptions).kind in ("positive", "negative")
    valid = () if sure else (Demand(stiffness * way),)
    rate = known.letter("vartheta" if way > 0 else "eta")
    if way > 0:
        moved = place * function("cos", rate * TIME) + speed / rate * function("sin", rate * TIME)
    else:
        grows, dies = function("exp", rate * TIME), function("exp", -rate * TIME)
        moved = (place + speed / rate) / 2 * grows + (place - speed / rate) / 2 * dies
    return InTime(left + moved, _named(rate, root(short(stiffness * way))), valid=valid) if way else None


def _named(*pairs: Scalar) -> dict[str, Scalar]:
    """Letters with their values, which follow each other."""
    return {next(iter(names_in(letter))): value for letter, value in zip(pairs[::2], pairs[1::2], strict=True)}


def _weak(known: Given, gap: Scalar) -> InTime | None:
    left, place, speed = _free(known)
    decay, rate = known.letter("gamma"), known.letter("vartheta_d")
    swung = place * function("cos", rate * TIME) + (speed + decay * place) / rate * function("sin", rate * TIME)
    letters = _named(decay, known.form.damping / 2, rate, root(gap))
    return InTime(left + function("exp", -decay * TIME) * swung, letters, WEAK, (Demand(gap),))


def _strong(known: Given, gap: Scalar) -> InTime | None:
    left, place, speed = _free(known)
    decay, rate = known.letter("gamma"), known.letter("eta")
    slow, fast = (function("exp", (way * rate - decay) * TIME) for way in (1, -1))
    moved = (speed + (decay + rate) * place) * slow - (speed + (decay - rate) * place) * fast
    letters = _named(decay, known.form.damping / 2, rate, root(-gap))
    return InTime(left + moved / rate / 2, letters, STRONG, (Demand(-gap),))


def _critical(known: Given, gap: Scalar) -> InTime | None:
    """Where 4 s = b², or one parameter, to which the damping is proportional, has the value that makes it so."""
    form, where = known.form, None
    for name in (q.name for q in known.study.problem.parameters if not is_zero(gap)):
        each = short(form.damping / symbol(name))
        if depends_on(form.damping, name) and not any(depends_on(value, name) for value in (each, form.stiffness)):
            where = name, short(known.root(form.stiffness) * 2 / each)
            break
    if where is None and not is_zero(gap):
        return None
    left, place, speed = (substitute(part, dict([where] if where else ())) for part in _free(known))
    rate = known.letter("vartheta")
    moved = (place + (speed + rate * place) * TIME) * function("exp", -rate * TIME)
    return InTime(left + moved, _named(rate, root(form.stiffness)), CRITICAL, where=where)


def _resisted(known: Given) -> InTime | None:
    """The speed tends to c/b, at the rate b."""
    if known.form.drive:
        return None
    rate, limit = known.letter("lamda"), known.form.constant / known.form.damping
    last = known.letter("u") if limit else NOTHING
    gone = (UNITY - function("exp", -rate * TIME)) / rate
    letters = _named(rate, known.form.damping, *((last, short(limit)) if limit else ()))
    return InTime(known.place + last * TIME + (known.speed - last) * gone, letters)


def _dragged(known: Given) -> InTime | None:
    """(ln of a sum of exponentials, or of sines and cosines)/k."""
    form, speed = known.form, known.speed
    if not form.constant:
        ahead = (Demand(form.drag * speed),)
        valid = () if sign(ahead[0].value, known.study.assumptions).is_nonnegative else ahead
        return InTime(known.place + function("ln", 1 + form.drag * speed * TIME) / form.drag, valid=valid)
    way = known.sense(form.constant * form.drag)
    sure = sign(form.constant * form.drag, known.study.assumptions).kind in ("positive", "negative")
    valid = () if sure else (Demand(form.constant * form.drag * way),)
    rate = known.letter("eta")
    letters = _named(rate, root(short(form.constant * form.drag * way)))
    if way < 0:
        swung = function("cos", rate * TIME) - speed * rate / form.constant * function("sin", rate * TIME)
        return InTime(known.place + function("ln", swung) / form.drag, letters, valid=valid)
    last = known.letter("u")
    letters |= _named(last, short(form.constant / letters[next(iter(letters))]))
    gone = function("exp", -rate * TIME * 2)
    part = (last + speed + (last - speed) * gone) / last / 2
    return InTime(known.place + last * TIME + function("ln", part) / form.drag, letters, valid=valid) if way else None


def _slowed(known: Given) -> InTime | None:
    """Where u̇ = k uⁿ, u^(1 - n) grows at the rate (1 - n) k; where q̈ = k e^{c q̇}, e^{-c q̇} at the rate -c k."""
    speed, rate, law = f"{known.name}_dot", known.letter("lamda"), power_law(known)
    if law is None:
        slope = short(derivative(known.form.law, speed) / known.form.law)
        if depends_on(slope, speed):
            return None
        begun = function("exp", -slope * known.speed)
        letters = _named(rate, short(-slope * substitute(known.form.law, {speed: NOTHING})))
        grown = begun + rate * TIME
        moved = grown * (1 - function("ln", grown)) - begun * (slope * known.speed + 1)
        return InTime(known.place + moved / slope / rate, letters, valid=(Demand(substitute(grown, letters)),))
    first, second = 1 - law.power, 2 - law.power
    since = law.grown(first, TIME, rate) if first and second else None
    now, then = (raised(one, Fraction(second) / first) for one in since[:2]) if since else (None, None)
    if since is None or now is None or then is None:
        return None
    letters, size = _named(rate, law.rate(first)), since[2] * law.way * first / second
    going = Demand(substitute(since[0], letters), ">=" if 0 < law.power < 1 else ">")  # with the place at which it rests
    return InTime(known.place + (now - then) * size / rate, letters, valid=(going,))


def _drawn(known: Given) -> InTime | None:
    """q̇ fⁿ stays what it is, where q̈ = -n (f'/f) q̇: with a linear function f of the time, or with n = 1 and a quadratic one
    that has no zero, as the moment of inertia of an arm along which a mass is moved steadily."""
    lever = Scalar(known.form.drawn.den)
    rate, begun = derivative(lever, "t"), substitute(lever, {"t": NOTHING})
    power = short(known.form.drawn * lever / rate).number() if rate else None
    bend = derivative(rate, "t")
    if power == 1 and bend and not depends_on(bend, "t"):
        first = substitute(rate, {"t": NOTHING})
        gap = short(begun * bend * 2 - first * first)
        if known.sense(gap) <= 0:
            return None
        size = known.root(gap)
        turned = function("atan", rate / size) - function("atan", first / size)
        return InTime(known.place + known.speed * begun * 2 / size * turned, valid=(Demand(gap),))
    if not isinstance(power, int) or power < 2 or bend:
        return None
    place = known.place + known.speed * begun / rate / (power - 1) * (1 - (begun / lever) ** (power - 1))
    return InTime(short(place), valid=(Demand(short(lever * begun)),))


SOLVED: Mapping[str, Callable[[Given], InTime | None]] = {
    "uniform": _uniform,
    "swinging": _swinging,
    "resisted": _resisted,
    "dragged": _dragged,
    "slowed": _slowed,
    "drawn": _drawn,
}
DAMPED: Mapping[str, Callable[[Given, Scalar], InTime | None]] = {WEAK: _weak, CRITICAL: _critical, STRONG: _strong}
