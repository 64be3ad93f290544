"""What the axes of plots count in: SI units where the author gives an example, else groups such as M g ℓ."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen
from rbpsym.mechanics.numbers import angles, floating, sample
from rbpsym.mechanics.phases import followable, known_stages
from rbpsym.mechanics.pushing import begun_numbers
from rbpsym.mechanics.study import Study
from rbpsym.quantities import DIMENSIONS, LENGTH, MASS, NUMBER, Dimension, Quantity
from rbpsym.statement.model import Problem
from rbpsym.statement.references import unused
from rbpsym.statement.units import unit_of, unit_text

CLOCKS = tuple(
    DIMENSIONS[name] for name in ("acceleration", "stiffness", "torsion stiffness", "speed", "angular speed", "force")
)
DEGREE = math.pi / 180


class Scale(Frozen):
    """The unit of an axis: its size in SI units, and how it is printed (None for a pure number)."""

    size: float
    node: t.Node | None = None
    sign: str = ""


class Scales(Frozen):
    """Numbers for all names of a problem, and the unit of each dimension.

    `base` are the parameters whose products make the units; none where the units are those of SI.
    """

    numbers: Mapping[str, float]
    base: tuple[Quantity, ...] = ()

    def of(self, dimension: Dimension, name: str = "") -> Scale:
        """The unit of a dimension (of torques and energies, the one named); angles are counted in degrees."""
        if dimension == NUMBER:
            return Scale(DEGREE, sign="°")
        if not self.base:
            return Scale(1.0, t.Word(unit_text(unit_of(dimension, name))))
        exponents = self.exponents(dimension)
        size = math.prod(abs(self.numbers[name]) ** float(power) for name, power in exponents.items())
        return Scale(size, product(exponents))

    def exponents(self, dimension: Dimension) -> dict[str, Fraction]:
        """The powers of the parameters whose product has a dimension."""
        *mass, first, second = self.base
        one, other, size = first.dimension, second.dimension, _spread(first, second)
        shares = {
            first.name: Fraction(dimension.length * other.time - dimension.time * other.length) / size,
            second.name: Fraction(dimension.time * one.length - dimension.length * one.time) / size,
        }
        rest = dimension / one ** shares[first.name] / other ** shares[second.name]
        found = {**{each.name: Fraction(rest.mass) for each in mass}, second.name: shares[second.name], **shares}
        return {name: power for name, power in found.items() if power}


def scales(study: Study) -> Scales:
    """The author's example where it has all numbers, else generic numbers. Raises NotApplicable without a scale, or where the
    motion does not begin as it is stated with these numbers: a contact would have to pull."""
    problem = study.problem
    declared = [q for q in problem.parameters if q.name not in problem.implicit]
    is_given = bool(declared) and all(q.name in problem.example for q in declared)
    asked = followable(known_stages(problem)[0])
    numbers = sample(problem, problem.example) if is_given else begun_numbers(study, asked, far=True)
    if any(floating(demand.value, numbers) < 0 for demand in asked):
        raise NotApplicable("with these numbers the motion does not begin as it is stated")
    return Scales(numbers) if is_given else Scales(numbers, base(declared, weighs=not problem.unstated))


def base(parameters: list[Quantity], *, weighs: bool = True) -> tuple[Quantity, ...]:
    """A mass if something `weighs`, a length and what sets the pace, or two things that set it, such as a speed and an
    acceleration. Raises NotApplicable if one is missing."""
    positive = [q for q in parameters if q.sign == "positive"]
    ranked = [q for kind in (LENGTH, *CLOCKS) for q in positive if q.dimension == kind]
    mass = [q for q in positive if q.dimension == MASS][:weighs]
    second = next((q for q in ranked if _spread(ranked[0], q)), None)
    if len(mass) < weighs or second is None:
        raise NotApplicable("no mass, length and pace from which units could be made")
    return (*mass, ranked[0], second)


def _spread(first: Quantity, second: Quantity) -> Fraction:
    """Not zero where lengths and times can be made of the two."""
    one, other = first.dimension, second.dimension
    return Fraction(one.length * other.time - one.time * other.length)


def product(exponents: Mapping[str, Fraction]) -> t.Node:
    """The product of powers as one prints it; square roots are drawn together."""
    if any(power.denominator == 2 for power in exponents.values()):
        return t.Sqrt(product({name: power * 2 for name, power in exponents.items()}))
    above = [powered(name, power) for name, power in exponents.items() if power > 0]
    below = [powered(name, -power) for name, power in exponents.items() if power < 0]
    top = t.mul(*above) if above else t.ONE
    return t.div(top, t.mul(*below)) if below else top


def powered(name: str, power: Fraction) -> t.Node:
    """A power of a symbol."""
    return t.power(t.Sym(name), int(power) if power.denominator == 1 else power)


def told_numbers(problem: Problem, found: Scales, decimal: str = ".") -> Iterator[t.Node]:
    """The numbers that were taken: as the author gave them, or as multiples of the base."""
    idle, turned = unused(problem), angles(problem)
    if not found.base:
        yield from (example(name, text, decimal) for name, text in problem.example.items() if name not in idle)
        return
    for quantity in problem.parameters:
        if quantity in found.base or quantity.name not in found.numbers or quantity.name in idle:
            continue
        value = found.numbers[quantity.name]
        if quantity.dimension == NUMBER and quantity.name in turned:
            yield example(quantity.name, f"{value / DEGREE:.3g} deg", decimal)
        else:
            unit = Scale(1.0) if quantity.dimension == NUMBER else found.of(quantity.dimension)
            yield t.equation(t.Sym(quantity.name), t.mul(rounded(value / unit.size), unit.node or t.ONE))


def rounded(value: float) -> t.Num:
    """The value with three digits."""
    digits = 2 - (math.floor(math.log10(abs(value))) if value else 0)
    return t.Num(Fraction(round(value, max(digits, 0))).limit_denominator(10 ** max(digits, 0)))


def example(name: str, text: str, decimal: str = ".") -> t.Node:
    """A number of the author's with its unit: M = 10 kg."""
    value, _, unit = str(text).strip().partition(" ")
    written = unit.replace("^2", "²").replace("^3", "³").replace("*", " ")
    value = value.replace("-", "−").replace(".", decimal)
    return t.equation(t.Sym(name), t.Word(f"{value}°" if unit == "deg" else f"{value} {written}".strip()))
