"""What two problems can be compared by: small oscillations, accelerations, speeds as functions of position."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on, root
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.present import present, present_ratio
from rbpsym.algebra.scalar import Scalar
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.course import CoursePart


@dataclass(frozen=True, slots=True)
class Compared:
    """One quantity of two problems.

    of: which one; names: its symbols in the two; power: 2 if squares are compared; values: what is
    compared, in common parameters (and the coordinate), and how each is printed.
    """

    of: str
    names: tuple[str, str]
    power: int
    values: tuple[Scalar, Scalar]
    shown: tuple[t.Node, t.Node]

    def letters(self) -> list[t.Node]:
        """The quantities as formulas: ϑ₁², or a₁."""
        return [t.Pow(t.Sym(name), t.TWO) if self.power == 2 else t.Sym(name) for name in self.names]

    def scalars(self) -> dict[str, Scalar]:
        """What the symbols stand for."""
        pairs = zip(self.names, self.values, strict=True)
        return {name: root(value) if self.power == 2 else value for name, value in pairs}


def compared(first: Study, second: Study, part: CoursePart) -> Compared:
    """What the part asks for, or the first that both problems have. Raises StatementError if there is none."""
    wanted = [part.of] if part.of else list(QUANTITIES)
    for of in wanted:
        if found := QUANTITIES[of]((first, second), part):
            return found
    what = "the same " + (" or ".join(SAID[of] for of in wanted))
    raise part.error(
        "of" if part.of else "comparison",
        f"“{first.problem.name}” and “{second.problem.name}” don't both have {what} to compare",
        "of = " + ", ".join(f'"{of}"' for of in QUANTITIES) + "; coordinate says along which.",
    )


def _oscillation(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    places = [_place(study, part.coordinate) for study in studies]
    if None in places:
        return None
    squares = tuple(place.frequencies_squared[0] for place in places)
    shown = tuple(map(_quotient, studies, places, squares))
    return Compared("oscillation", ("vartheta_1", "vartheta_2"), 2, squares, shown)


def _place(study: Study, coordinate: str) -> Equilibrium | None:
    """The first stable position of rest about which the system oscillates with one frequency."""
    stable = (item for item in study.equilibria if item.stable and item.frequencies_squared)
    return next((item for item in stable if not coordinate or coordinate in item.at), None)


def _quotient(study: Study, place: Equilibrium, square: Scalar) -> t.Node:
    """Stiffness over inertia of the coordinate that oscillates, as the equation of motion has them."""
    for row, inertia in zip(place.stiffness, place.inertia, strict=True):
        for k, m in zip(row, inertia, strict=True):
            if k and m and k.den is ONE and m.den is ONE and is_zero(k / m - square):
                return present_ratio(k.num, m.num, study.style, as_ratio=True)
    return present(square, study.style, factor=True)


def _acceleration(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    """Accelerations that are functions of position alone."""
    name = _coordinate(studies, part)
    found = [(study.dynamics.accelerations or {}).get(f"{name}_ddot") for study in studies]
    speeds = {speed for study in studies for speed in study.system.speeds}
    if not all(found) or any(depends_on(value, speed) for value in found for speed in speeds):
        return None
    return _along("acceleration", f"{name}_ddot", 1, studies, found)


def _speed(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    """Squares of speeds as functions of position, from the start."""
    name = _coordinate(studies, part)
    found = [study.squares.get(name) for study in studies]
    return _along("speed", f"{name}_dot", 2, studies, found) if all(found) else None


def _along(of: str, name: str, power: int, studies: tuple[Study, Study], found: list[Scalar]) -> Compared:
    values = tuple(short(value) for value in found)
    shown = tuple(present(value, study.style, factor=True) for study, value in zip(studies, values, strict=True))
    return Compared(of, tuple(_indexed(name, studies[0], k) for k in (1, 2)), power, values, shown)


def _indexed(name: str, study: Study, k: int) -> str:
    """The quantity with the number of the problem: a_1 where the notation says a, else x_1_ddot."""
    if drawn := study.problem.notation.get(name):
        return f"{drawn}_{k}"
    base, _, rate = name.rpartition("_")
    return f"{base}_{k}_{rate}"


def _coordinate(studies: tuple[Study, Study], part: CoursePart) -> str:
    """The coordinate that is named, else the first that both problems have."""
    first, second = ([c.name for c in study.problem.coordinates] for study in studies)
    return part.coordinate or next((name for name in first if name in second), "")


QUANTITIES: Mapping[str, Callable[[tuple[Study, Study], CoursePart], Compared | None]] = {
    "oscillation": _oscillation,
    "acceleration": _acceleration,
    "speed": _speed,
}
SAID = {
    "oscillation": "small oscillation",
    "acceleration": "acceleration (as a function of position)",
    "speed": "speed (as a function of position)",
}
