"""What the law of a constraint says: which points and angles it joins, and its unknown forces.

The law of a kind is the `JOINT` of the module `law` in its folder: the forces by which it keeps its conditions, and these.
"""

from __future__ import annotations

from collections.abc import Callable

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.kinds import KindParts
from rbpsym.field import EX, EY, ORIGIN, Scalar, symbol
from rbpsym.frozen import Frozen
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.system import End, Force, opposed
from rbpsym.statement.curves import toucher
from rbpsym.statement.model import Element, Line, PointRef


class AngleJoin(Frozen):
    """angle(second) - angle(first) = offset; first None means the ground; offset None: as it starts."""

    first: str | None
    second: str
    offset: Scalar | None


class Touch(Frozen):
    """A point that lies on a line."""

    point: PointRef
    line: Line
    side: str


def _none(element: Element, geometry: Geometry | None = None) -> tuple[()]:
    return ()


class Joint(Frozen):
    """A kind of constraint: its forces, and what it asks for.

    `joins`: points that coincide; `angles` that are tied; `touches`: points on fixed lines;
    `gaps`: (value, what it is) of further quantities of position that vanish; `rates`: (unknown,
    factor) of unknown forces whose power per unit of force, times the factor, vanishes: a
    condition for the speeds; `taken`: what is positive where the sides and the ways of strings are those that the
    sample state shows. The forces of a one-sided constraint can push (or pull) only.
    """

    forces: Callable[[Element, Geometry], tuple[Force, ...]]
    joins: Callable[[Element], tuple[tuple[PointRef | None, PointRef], ...]] = _none
    angles: Callable[[Element], tuple[AngleJoin, ...]] = _none
    touches: Callable[[Element], tuple[Touch, ...]] = _none
    gaps: Callable[[Element, Geometry], tuple[tuple[Scalar, str], ...]] = _none
    rates: Callable[[Element, Geometry], tuple[tuple[str, Scalar], ...]] = _none
    taken: Callable[[Element, Geometry], tuple[Scalar, ...]] = _none
    is_one_sided: bool = False

    def fixed_lines(self, element: Element) -> tuple[tuple[str | None, Line], ...]:
        """(body, fixed line that it touches); none for other curves and other kinds."""
        if element.values.get("line") is None or element["of"] is not None:
            return ()
        return ((toucher(element), element["line"]),)


JOINTS: KindParts[Joint] = KindParts(CONSTRAINTS, "law", "JOINT")


def joining(element: Element, *ends: End) -> tuple[Force, ...]:
    """The unknown force N_x i + N_y j on the body of the first end, and its opposite on that of the second."""
    x, y = (f"{element.name}_{axis}" for axis in "xy")
    return opposed(element.name, ends, EX * symbol(x) + EY * symbol(y), unknowns=(x, y))


def pair_of_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """The force on the second body, and its reaction on the first if that is a body.

    Each acts at the body's own point: where the condition is not an identity of the poses, the two
    points coincide only on the motions that it allows, and on these the pair does no work by form.
    """
    first, second = element["points"]
    refs = (first, second) if second.body is None else (second, first)
    return joining(element, *((ref.body, geometry.where(ref), ref.label) for ref in refs))


def couples(name: str, on: str | None, by: str | None, outer: str, geometry: Geometry) -> tuple[Force, ...]:
    """The unknown couple `name` on a body and the opposite one on the other; `outer` exerts it where that is none.

    It is an entry of its own: the force that acts beside it has its torque, and its work, for itself.
    """
    ends = ((body, ORIGIN if body is None else geometry.center(body), f"{body}.cm") for body in (on, by))
    return opposed(name, ends, couple=symbol(name), outside=outer, unknowns=(name,))
