"""What the formulas presuppose: which way a string runs, on which side a thing touches, that a distance is no negative number.

The sample state tells it where nothing declared does; what is positive then has to be so wherever the formulas are used.
"""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.field import Scalar, substitute
from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.interactions import LAWS
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element


def taken(system: System) -> Iterator[tuple[Element, Scalar]]:
    """What is positive where things are as they were taken to be, in the free coordinates."""
    geometry = geometry_of(system)
    setting = setting_of(system, geometry.where)
    problem = system.problem
    found = [(element, JOINTS[element.kind].taken(element, geometry)) for element in problem.constraints]
    found += [(element, LAWS[element.kind].taken(element, setting)) for element in problem.interactions]
    yield from ((element, substitute(value, system.dependent)) for element, values in found for value in values)
