"""Phrases about equilibria and the oscillations about them."""

from __future__ import annotations

from functools import cmp_to_key
from typing import TYPE_CHECKING

from rbpsym.algebra.calculus import function
from rbpsym.algebra.scalar import PI, Scalar
from rbpsym.equality.signs import sign
from rbpsym.errors import StatementError
from rbpsym.mechanics import solutions, solved
from rbpsym.mechanics.oscillation import decaying
from rbpsym.quantity.bound import Bound, Phrase, number
from rbpsym.quantity.path import SENSES

if TYPE_CHECKING:
    from rbpsym.quantity.problem import ProblemWorld

ORDINALS = {None: None, "lowest ": 0, "second ": 1, "third ": 2, "highest ": -1}


def _equilibria(world: ProblemWorld, name: str, stable: bool) -> list:
    found = [item for item in world.study.equilibria if bool(item.stable) is stable and name in item.at]
    if not found:
        raise StatementError(f"no {'' if stable else 'un'}stable equilibrium of “{name}” is known")
    return found


def frequency(world: ProblemWorld, ordinal: str | None, name: str) -> Bound:
    """An angular frequency of small oscillations about the stable equilibrium."""
    squares = [s for item in _equilibria(world, name, True)[:1] for s in item.frequencies_squared]
    place = ORDINALS[ordinal]
    if not squares:
        said = ", ".join(f"“{kind} of {name}”" for kind in OF_MODE)
        raise StatementError(f"no undamped oscillations of “{name}” are known", instead=f"of a damped motion: {said}.")
    if place is None and len(squares) > 1:
        raise StatementError(f"there are {len(squares)} frequencies", instead=f"write “lowest frequency of {name}”.")
    if place is not None and place >= len(squares):
        raise StatementError(f"there are only {len(squares)} frequencies")
    return number(function("sqrt", _ordered(world, squares)[place or 0]), "oscillations")


def _ordered(world: ProblemWorld, values: list[Scalar]) -> list[Scalar]:
    """From the lowest to the highest, for all parameters. Raises StatementError if that depends on them."""
    return sorted(values, key=cmp_to_key(lambda a, b: _compared(world, a, b)))


def _compared(world: ProblemWorld, a: Scalar, b: Scalar) -> int:
    found = SENSES.get(sign(a - b, world.motion.assumptions).kind)
    if found is None:
        raise StatementError("which of the frequencies is the lower one depends on the parameters, or is not decided")
    return found


def of_mode(world: ProblemWorld, kind: str, name: str) -> Bound:
    """γ, or a frequency, of the one mode λ² + 2γλ + ϑ² about the stable equilibrium."""
    modes = [decaying(powers) for item in _equilibria(world, name, True)[:1] for powers in item.linear.factors]
    if len(modes) != 1 or not modes[0][1]:
        raise StatementError(f"the motion of “{name}” is not that of one mode")
    return number(OF_MODE[kind](*modes[0]), "oscillations")


OF_MODE = {
    "decay rate": lambda decay, square: decay,
    "damped frequency": lambda decay, square: function("sqrt", square - decay * decay),
    "undamped frequency": lambda decay, square: function("sqrt", square),
}


def period(world: ProblemWorld, name: str) -> Bound:
    """The period of small oscillations."""
    return number(PI * 2 / frequency(world, None, name).scalar, "oscillations")


def equilibrium(world: ProblemWorld, unstable: str | None, name: str) -> Bound:
    """The place of the one stable (unstable) equilibrium."""
    found = _equilibria(world, name, not unstable)
    if len(found) > 1:
        raise StatementError(f"“{name}” has {len(found)} such equilibria")
    return number(found[0].at[name], "oscillations")


OTHERWISE = {
    "total angle": "total way",
    "total change": "total way",
    "largest speed": "greatest speed",
    "maximum speed": "greatest speed",
}


def of_course(world: ProblemWorld, key: str, name: str) -> Bound:
    """What is told of the motion of a coordinate as a function of the time."""
    key = OTHERWISE.get(key, key)
    known = solutions.given(world.study, name) if name in world.study.system.independent else None
    value = None if known is None else solved.FEATURES[key][1](known)
    if value is None:
        raise StatementError(f"the motion of “{name}” has no {key} that is known in closed form")
    return number(value, f"course {name} {key}")


PHRASES: tuple[Phrase, ...] = (
    (rf"({'|'.join((*solved.FEATURES, *OTHERWISE))}) of (\w+)", of_course, "amplitude of COORDINATE"),
    (r"(lowest |second |third |highest )?frequency of (\w+)", frequency, "frequency of COORDINATE"),
    (rf"({'|'.join(OF_MODE)}) of (\w+)", of_mode, "decay rate of COORDINATE"),
    (r"period of (\w+)", period, "period of COORDINATE"),
    (r"(unstable )?equilibrium of (\w+)", equilibrium, "equilibrium of COORDINATE"),
)  # fmt: skip
