"""The forms of an acceleration that can be integrated; those that are a power of the speed."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat
from rbpsym.errors import there
from rbpsym.field import NOTHING, UNITY, Scalar, atoms, is_zero, short, symbol
from rbpsym.field.calculus import depends_on, derivative, names_in, root, substitute
from rbpsym.field.integration import definite
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen, replace

if TYPE_CHECKING:
    from rbpsym.mechanics.solutions import Given


class AccelerationForm(Frozen):
    """q̈ = constant - stiffness q - damping q̇ - drag q̇² + drive, where d²(drive)/dt² = -frequency² drive (alone, what is
    `constant` may be any function of the time); or `law`, another function of q̇; or -q̇ times a function of the time, `drawn`,
    as of what is drawn in or let out while it turns."""

    constant: Scalar
    stiffness: Scalar = NOTHING
    damping: Scalar = NOTHING
    drag: Scalar = NOTHING
    drive: Scalar = NOTHING
    frequency: Scalar = NOTHING
    law: Scalar = NOTHING
    drawn: Scalar = NOTHING

    @property
    def rest(self) -> Scalar:
        """Where a spring balances what is constant."""
        return short(self.constant / self.stiffness) if self.stiffness else NOTHING

    def at_speed(self, speed: Scalar) -> Scalar:
        """What does not depend on the place, nor on the time."""
        return self.constant - self.damping * speed - self.drag * speed * speed + self.law

    @property
    def gap(self) -> Scalar:
        """s - b²/4, which is positive where the damping is weak."""
        return short(without_even_roots(self.stiffness - self.damping**2 / 4))


def form_of(value: Scalar, name: str, moving: set[str]) -> AccelerationForm | None:
    """The form of an acceleration; None for another one."""
    speed = f"{name}_dot"
    slope, law = derivative(value, speed), AccelerationForm(NOTHING, law=value) if names_in(value) & moving == {speed} else None
    try:
        parts = (derivative(value, name), substitute(slope, {speed: NOTHING}), derivative(slope, speed) / 2)
    except ZeroDivisionError:  # it grows beyond all bounds where the speed vanishes
        return law
    stiffness, damping, drag = (short(-part) for part in parts)
    left = short(value + stiffness * symbol(name) + damping * symbol(speed) + drag * symbol(speed) ** 2)
    if not (stiffness or drag or left) and names_in(damping) & moving == {"t"}:
        return AccelerationForm(NOTHING, drawn=damping)
    if any(names_in(part) & moving for part in (stiffness, damping, drag)) or names_in(left) & (moving - {"t"}):
        return law
    if drag and (stiffness or damping or depends_on(left, "t")):
        return None
    return driven_form(AccelerationForm(left, stiffness, damping, drag))


def gathered(rate: Scalar) -> Scalar | None:
    """What a function of the time adds up to since t = 0; None where that has no closed form."""
    return definite(rate, "t", NOTHING, symbol("t"))


def driven_form(form: AccelerationForm) -> AccelerationForm | None:
    """The form with what swings taken out of what is constant; as it is where it is a function of the time alone."""
    if not depends_on(form.constant, "t"):
        return form
    swinging = (atoms.atom(index) for index in form.constant.atoms())
    rates = {derivative(Scalar(a.arg), "t") for a in swinging if a.kind in ("cos", "sin") and depends_on(Scalar(a.arg), "t")}
    if len(rates) != 1 or depends_on(next(iter(rates)), "t"):
        return None if form.stiffness or form.damping or form.drag else form
    [frequency] = rates
    drive = short(-derivative(derivative(form.constant, "t"), "t") / frequency**2)
    constant = short(form.constant - drive)
    if not is_zero(derivative(constant, "t")):
        return None if form.stiffness or form.damping or form.drag else form
    return replace(form, constant=substitute(constant, {"t": NOTHING}), drive=drive, frequency=frequency)


Grown = tuple[Scalar, Scalar, Scalar]


class PowerLaw(Frozen):
    """u = |q̇| = way q̇ changes as u̇ = factor u^power, from its `begun` size."""

    power: int | Fraction
    factor: Scalar
    way: int
    begun: Scalar
    assumptions: Assumptions

    def grown(self, exponent: int | Fraction, gone: Scalar, rate: Scalar | None = None) -> Grown | None:
        """(w, w at first, scale) with u = scale w^(1/exponent), where w grows at a `rate`: of the time for exponent 1 - power, of
        the way for 2 - power; None where that takes other roots than square ones."""
        scale = UNITY if isinstance(exponent, int) and exponent > 0 else self.begun  # without roots of the speed at the start
        first = raised(short(self.begun / scale), exponent)
        return None if first is None else (first + (rate or self.rate(exponent)) * gone, first, scale)

    def rate(self, exponent: int | Fraction) -> Scalar:
        """At which w grows."""
        whole = isinstance(exponent, int) and exponent > 0
        return neat(self.factor * exponent * (1 if whole else there(raised(self.begun, -exponent))), self.assumptions)


def power_law(known: Given) -> PowerLaw | None:
    """The power of the speed that its acceleration is; None where it is none."""
    form, speed, name = known.form, f"{known.name}_dot", known.study.letters.free("u")
    is_free = not (form.stiffness or form.drive or form.drawn or depends_on(form.constant, "t"))
    gained = form.at_speed(symbol(speed)) if is_free else NOTHING
    way = known.sense(known.speed or substitute(gained * symbol(speed), {speed: UNITY})) if gained else 0
    if not way:
        return None
    given_ = known.assumptions.with_signs({name: "positive"})
    gained = substitute(gained, {speed: symbol(name) * way}) * way
    power = neat(symbol(name) * derivative(gained, name) / gained, given_).number()
    factor = None if power is None or (not known.speed and power > 0) else raised(symbol(name), -power)
    if power is None or factor is None:
        return None
    return PowerLaw(power, neat(gained * factor, given_), way, known.speed * way, known.assumptions)


def raised(base: Scalar, power: int | Fraction) -> Scalar | None:
    """A power of what is positive, as far as square roots tell it."""
    twice = Fraction(power) * 2
    return None if twice.denominator > 1 else root(base) ** int(twice) if twice % 2 else base ** int(twice / 2)
