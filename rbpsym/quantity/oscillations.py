"""Phrases about equilibria and the oscillations about them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cmp_to_key, partial
from typing import TYPE_CHECKING

from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import PI, Scalar, depends_on, function, is_zero, short
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import orbit, solutions, solved
from rbpsym.mechanics.elimination import determinant
from rbpsym.mechanics.orbit import swing_of
from rbpsym.mechanics.oscillation import Equilibrium, amplitudes, decaying, where_stable
from rbpsym.quantity.bound import Bound, Phrase, number
from rbpsym.statement.source import did_you_mean

if TYPE_CHECKING:
    from rbpsym.quantity.problem import ProblemWorld

ORDINALS = {None: None, "lowest": 0, "second": 1, "third": 2, "highest": -1, "longest": 0, "shortest": -1}


def _equilibria(world: ProblemWorld, name: str, kind: str | None = "stable") -> list[Equilibrium]:
    """Those that are stable (under a condition, if need be), or unstable; of no stated kind: the one or the other."""
    if name not in world.coordinates:
        raise StatementError(f"“{name}” is no coordinate", instead=did_you_mean(name, world.coordinates, "coordinates"))
    if orbit.turns(world.study, name):
        what = f"“{name}” has no rest in this motion: a speed that is kept going drives it, and no steady motion was found"
        raise StatementError(what, instead="give values: “… with NAME = VALUE”; or let the motion start without that speed.")
    known = [item for item in world.study.equilibria if name in item.at]
    stable = [item for item in known if item.stable] or [item for item in map(where_stable, known) if item.stable]
    unstable = [item for item in known if not item.stable and item.where is None]
    found = unstable if kind == "unstable" else stable or (unstable if kind is None else [])
    if not found:
        raise StatementError(f"no {kind or 'stable'} equilibrium of “{name}” is known")
    if kind is None and found is unstable and not world.study.rest.complete:  # a stable one may be where no formula tells it
        what = f"no stable equilibrium of “{name}” was found in closed form, and others than the unstable one are not excluded"
        raise StatementError(what, instead=f"ask for the “unstable equilibria of {name}”.")
    return found


def _about(world: ProblemWorld, name: str, text: str | None) -> Equilibrium:
    """The stable equilibrium about which it swings. Raises StatementError where several have unlike frequencies."""
    found = _equilibria(world, name)
    if text is not None:
        value = scalar(read_infix(text, world.names))
        known = [item for item in map(where_stable, world.study.equilibria) if item.stable and name in item.at]
        found = [item for item in known if is_zero(item.at[name] - value)]
        if not found:
            raise StatementError(f"{name} = {text} is no stable equilibrium", instead=f"ask for “equilibrium of {name}”.")
    if len({item.frequencies_squared for item in found}) > 1:
        raise StatementError(f"“{name}” has {len(found)} stable equilibria", instead=f"write “… of {name} about {name} = VALUE”.")
    return found[0]


def _mode(world: ProblemWorld, item: Equilibrium, ordinal: str | None, name: str) -> Scalar:
    """The square of the frequency of a mode, of all that are coupled to the coordinate."""
    squares, place = _taking_part(world, item, name), ORDINALS[ordinal]
    if not squares:
        raise _damped(name)
    if place is None and len(squares) > 1:
        said = f"write “frequency of {name} in the lowest mode”, or “frequencies of {name}”."
        raise StatementError(f"there are {len(squares)} frequencies", instead=said)
    if place is not None and place >= len(squares):
        raise StatementError(f"there are only {len(squares)} frequencies")
    return _ordered(world, squares)[place or 0]


def _taking_part(world: ProblemWorld, item: Equilibrium, name: str) -> tuple[Scalar, ...]:
    """The squares of the frequencies of the modes in which a coordinate takes part: those of all that are coupled to it."""
    names, (stiff, inert), squares = world.study.system.independent, (item.stiffness, item.inertia), item.frequencies_squared
    group = {k for k, each in enumerate(names) if each == name}
    while more := {k for k in range(len(names)) for j in group if stiff[j][k] or inert[j][k]} - group:
        group |= more
    if len(group) in (0, len(names)):
        return squares
    rows = sorted(group)
    blocks = (tuple(tuple(stiff[j][k] - square * inert[j][k] for k in rows) for j in rows) for square in squares)
    return tuple(square for square, block in zip(squares, blocks, strict=True) if is_zero(determinant(block)))


def _damped(name: str) -> StatementError:
    said = ", ".join(f"“{kind} of {name}”" for kind in DAMPED)
    return StatementError(f"no undamped oscillations of “{name}” are known", instead=f"of a damped motion: {said}.")


def frequency(world: ProblemWorld, ordinal: str | None, name: str, mode: str | None = None, about: str | None = None) -> Bound:
    """An angular frequency of small oscillations about the stable equilibrium; of what is driven, that without the drive."""
    if found := _orbit(world, name, about):
        return number(function("sqrt", found[1].square), f"orbit {name} {found[0]}")
    name = _told_by(world, name)
    try:
        item = _about(world, name if about else _known_by(world, name), about)
    except StatementError:
        if not world.study.system.has_clock:
            raise
        if _one_mode(world, name)[0]:
            raise _damped(name) from None
        return of_mode(world, "undamped frequency", name)
    return number(function("sqrt", _mode(world, item, mode or ordinal, name)), "oscillations")


def _orbit(world: ProblemWorld, name: str, about: str | None) -> tuple[int, orbit.Orbit] | None:
    """The steady motion about which a coordinate swings, with its number among them; None if it is a rest, or there is none, or
    several."""
    study = world.study
    is_rest = any(name in item.at for item in study.equilibria) and not orbit.turns(study, name)
    if name not in study.system.independent or study.system.has_clock or is_rest:
        return None
    place = None if about is None else scalar(read_infix(about, world.names))
    found = [(k, one) for k, one in enumerate(orbit.orbits(world.study, name)) if place is None or is_zero(one.place - place)]
    return found[0] if len(found) == 1 else None


def _told_by(world: ProblemWorld, name: str) -> str:
    """The one free coordinate on which another one depends, which swings with it."""
    value = world.study.system.dependent.get(name)
    led = [] if value is None else [n for n in world.study.system.independent if depends_on(value, n)]
    return led[0] if len(led) == 1 else name


def _known_by(world: ProblemWorld, name: str) -> str:
    """The coordinate by whose places those of rest are told: of what is free to go anywhere, another one's."""
    items, names = world.study.equilibria, world.study.system.independent
    is_free = name in names and items and not any(name in item.at for item in items)
    return next((n for n in names if n in items[0].at), name) if is_free else name


def frequencies(world: ProblemWorld, name: str | None) -> Bound:
    """Those of all modes, the lowest first."""
    name = name and _told_by(world, name)
    item = _about(world, _known_by(world, name or world.study.system.independent[0]), None)
    squares = item.frequencies_squared if name is None else _taking_part(world, item, name)
    if not squares:
        raise _damped(name or world.study.system.independent[0])
    return Bound(told="oscillations", values=tuple(function("sqrt", one) for one in _ordered(world, squares)))


def mode_shape(world: ProblemWorld, first: str, second: str, ordinal: str) -> Bound:
    """The ratio of two amplitudes in a mode of coordinates. Raises StatementError where it is not told by the first of them."""
    names, kept = world.study.system.independent, _known_by(world, second)
    item = _about(world, kept, None)
    if first == second or not {first, second} <= {*names}:
        raise StatementError("the shape of a mode is told of two coordinates", instead=f"of two of {', '.join(names)}.")
    found = amplitudes(item, _mode(world, item, ordinal, kept))
    sizes = dict(zip(names, found or (), strict=False))
    if not sizes or is_zero(sizes[second]):
        raise StatementError(f"“{second}” stays at rest in this mode, or nothing ties the two")
    told = next(name for name in names if not is_zero(sizes[name]))
    if told not in (first, second):
        raise StatementError(f"the shape of this mode is told relative to {told}", instead=f"ask for ratios to {told}.")
    return number(short(sizes[first] / sizes[second]), "oscillations")


def _ordered(world: ProblemWorld, values: Iterable[Scalar]) -> list[Scalar]:
    """From the lowest to the highest, for all parameters. Raises StatementError if that depends on them."""
    order: Callable[[Scalar, Scalar], int] = partial(_compared, world)
    return sorted(values, key=cmp_to_key(order))


def _compared(world: ProblemWorld, a: Scalar, b: Scalar) -> int:
    found = sign(a - b, world.motion.assumptions).sense
    if not found:
        raise StatementError("which of the frequencies is the lower one depends on the parameters, or is not decided")
    return found


def _one_mode(world: ProblemWorld, name: str) -> tuple[Scalar, Scalar]:
    """(γ, ϑ²) of the one mode λ² + 2γλ + ϑ² about the stable equilibrium, or of what is driven."""
    if world.study.system.has_clock:
        form = solutions.form_along(world.study, name) if name in world.study.system.independent else None
        modes = [(short(form.damping / 2), form.stiffness)] if form and not form.drag else []
    else:
        modes = [decaying(powers) for powers in _about(world, name, None).linear.factors]
    if len(modes) != 1 or not modes[0][1]:
        raise StatementError(f"the motion of “{name}” is not that of one mode")
    return modes[0]


def of_mode(world: ProblemWorld, kind: str, name: str) -> Bound:
    """γ, or a frequency, of what dies out like e^{-γt} and would swing with ϑ without that."""
    value = OF_MODE[kind](*_one_mode(world, name))
    return number(value, f"course {name} {kind}" if world.study.system.has_clock else "oscillations")


OF_MODE: Mapping[str, Callable[[Scalar, Scalar], Scalar]] = {
    "decay rate": lambda decay, square: decay,
    "damped frequency": lambda decay, square: function("sqrt", square - decay * decay),
    "undamped frequency": lambda decay, square: function("sqrt", square),
}
DAMPED = (*OF_MODE, "damped period", "damping ratio", "logarithmic decrement")


def period(world: ProblemWorld, ordinal: str | None, name: str, mode: str | None = None, about: str | None = None) -> Bound:
    """The period of small oscillations; the longest one is that of the lowest mode."""
    found = frequency(world, ordinal, name, mode, about)
    return number(PI * 2 / found.number, found.told)


def whole_period(world: ProblemWorld, name: str | None, other: str | None = None) -> Bound:
    """The period of a swing of any size, from the start."""
    name = name or other or ""
    form = solutions.form_along(world.study, name) if name in world.study.system.independent else None
    if form and not (form.damping or form.drag or form.drive):
        return period(world, None, name)  # which does not depend on the amplitude
    return number(swing_of(world.study, name).time(world.study, 4), f"swing {name} 4")


def equilibrium(world: ProblemWorld, kind: str | None, name: str) -> Bound:
    """The places of the stable (unstable) equilibria; of the unstable ones where no kind is said and none is stable."""
    if kind != "unstable" and (found := _orbit(world, name, None)):
        return number(found[1].place, f"orbit {name} {found[0]}")
    places = tuple(item.at[name] for item in _equilibria(world, name, kind))
    return number(*places, "oscillations") if len(places) == 1 else Bound(told="oscillations", values=places)


OTHERWISE = {
    "phase": "phase lag",
    "phase angle": "phase lag",
    "total angle": "total way",
    "total change": "total way",
    "largest speed": "greatest speed",
    "maximum speed": "greatest speed",
}


def of_course(world: ProblemWorld, key: str, name: str, small: str | None = None) -> Bound:
    """What is told of the motion of a coordinate as a function of the time."""
    key, is_free = OTHERWISE.get(key, key), name in {*world.study.system.independent} - world.study.resting.keys()
    known = solutions.given(world.study, name, small=bool(small)) if is_free else None
    value = None if known is None else solved.feature(known, key)
    if value is None:
        raise StatementError(f"the motion of “{name}” has no {key} that is known in closed form")
    return number(value, f"course {name} {key}{small or ''}")


_ABOUT = r"(?: in (lowest|second|third|highest) mode)?(?: about \w+ = (.+))?"
_COURSE = "|".join(key for key in (*solved.FEATURES, *OTHERWISE) if key not in OF_MODE)
PHRASES: tuple[Phrase, ...] = (
    (rf"({_COURSE}) of (\w+)( small)?", of_course, "amplitude of COORDINATE"),
    (r"frequencies(?: of (\w+))?", frequencies, "frequencies of COORDINATE"),
    (rf"(?:(lowest|second|third|highest) )?frequency of (\w+){_ABOUT}", frequency, "frequency of COORDINATE"),
    (r"ratio of (\w+) to (\w+) in (lowest|second|third|highest) mode", mode_shape,
     "ratio of theta_2 to theta_1 in the lowest mode"),
    (rf"({'|'.join(OF_MODE)}) of (\w+)", of_mode, "decay rate of COORDINATE"),
    (rf"(?:(longest|shortest) )?period of (\w+){_ABOUT}", period, "period of COORDINATE about COORDINATE = VALUE"),
    (r"(?:exact|whole|true) period of (\w+)|period of large swings of (\w+)", whole_period, "exact period of COORDINATE"),
    (r"(?:((?:un)?stable) )?equilibri(?:um|a) of (\w+)", equilibrium, "equilibrium of COORDINATE"),
)  # fmt: skip
