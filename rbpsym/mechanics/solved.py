"""What is told of a motion that is known as a function of the time: its amplitude, its last speed."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.algebra.calculus import function
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.equality.signs import sign
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.solutions import SENSES, Given, kind_of


def speed_along(known: Given, name: str) -> Scalar | None:
    """The speed as a function of the place, where a resistance tells it, in the sense in which the motion sets out."""
    form, way = known.form, symbol(name) - known.place
    if kind_of(form) == "resisted" and not form.constant:
        return known.speed - form.damping * way
    if not form.drag:
        return None
    dies = function("exp", -form.drag * way)
    if not form.constant:
        return known.speed * dies
    last = short(form.constant / form.drag)
    push = known.speed or form.constant
    way = SENSES.get(sign(push, known.study.assumptions).kind)  # the square tells the speed where its sense is known
    square = last + (known.speed**2 - last) * dies**2
    return None if way is None else function("sqrt", short(square)) * way


def _amplitude(known: Given) -> Scalar | None:
    """Of a free oscillation: √((q - rest)² + q̇²/s)."""
    form = known.form
    if form.damping or form.drag or known.sense(form.stiffness) <= 0:
        return None
    return known.root((known.place - form.rest) ** 2 + known.speed**2 / form.stiffness)


def _terminal(known: Given) -> Scalar | None:
    """The speed at which the resistance balances what is constant."""
    form = known.form
    if form.stiffness or not form.constant:
        return None
    if form.damping:
        return short(form.constant / form.damping)
    if not form.drag or known.sense(form.constant * form.drag) <= 0:
        return None
    return known.root(form.constant / form.drag) * known.sense(form.constant)


def _total(known: Given) -> Scalar | None:
    """The way that it still makes until a resistance in proportion to the speed has stopped it."""
    form = known.form
    return short(known.speed / form.damping) if kind_of(form) == "resisted" and not form.constant else None


# what is asked of a coordinate -> the letter that it gets, and what finds it
FEATURES: Mapping[str, tuple[str, Callable[[Given], Scalar | None]]] = {
    "amplitude": ("A", _amplitude),
    "terminal speed": ("v_end", _terminal),
    "total way": ("s_end", _total),
}
