"""Contacts of points and round bodies with lines and circles, fixed or belonging to a body.

The normal n is the unit vector from the curve to what touches it; N n pushes on the toucher, -N n
on the body that bears the curve. Forward is to the right as seen with the normal upwards: the
tangent is n turned clockwise. Friction that holds is counted positive uphill on a fixed line
that slopes, else forward; kinetic friction μN acts against the slip.
Kleppner & Kolenkow 2.5 and 7.6; Meriam & Kraige, Dynamics, 6/4.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rbpsym.errors import StatementError, there
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, Vector, atoms, cartesian, derivative, is_zero, root, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import tidy
from rbpsym.frozen import Frozen
from rbpsym.mechanics.constraints import Joint, Touch, couples
from rbpsym.mechanics.geometry import Geometry, components, normal
from rbpsym.mechanics.system import Force, opposed, rotated
from rbpsym.statement.curves import curve_body, toucher
from rbpsym.statement.model import Curve, Element, PointRef


class Meeting(Frozen):
    """`place` of contact, `normal` there, `gap` (vanishes while they touch); `on` touches `by`."""

    place: Vector
    normal: Vector
    gap: Scalar
    on: str | None
    by: str | None

    @property
    def forward(self) -> Vector:
        """The tangent: the normal turned clockwise."""
        return -self.normal.turned()


def touching_point(element: Element) -> PointRef:
    """The point that touches, or the centre of the round body that does."""
    is_round = "body" in element.values
    return PointRef(f"{element['body']}.center", element["body"], "center") if is_round else element["point"]


def rim_of(element: Element) -> Scalar:
    """Radius of what touches; 0 for a point."""
    return scalar(element["rim"]) if element.values.get("rim") is not None else NOTHING


def meeting(element: Element, geometry: Geometry) -> Meeting:
    """How the two meet in the given poses."""
    if element.values.get("curve") is not None:
        return _on_curve(element, geometry)
    return (_on_circle if element.values.get("circle") is not None else _on_line)(element, geometry)


# --- lines


def _on_line(element: Element, geometry: Geometry) -> Meeting:
    here, height, across = _line(element, geometry)
    side = _side_of_line(element, geometry, across)
    rim, up = rim_of(element), across * side
    return Meeting(here - up * rim if rim else here, up, height * side - rim, toucher(element), curve_body(element))


def _line(element: Element, geometry: Geometry) -> tuple[Vector, Scalar, Vector]:
    """(what touches, its height over the line, the line's own unit normal)."""
    here = geometry.where(touching_point(element))
    return here, *_height(element, geometry, here)


def _height(element: Element, geometry: Geometry, here: Vector) -> tuple[Scalar, Vector]:
    line, body = element["line"], element["of"]
    a, b, c = components(line)
    if body is None:
        return a * here.x + b * here.y - c, normal(line)
    across = rotated(a, b, geometry.angle(body))
    return across.dot(here - geometry.origin(body)) - c, across


def _side_of_line(element: Element, geometry: Geometry, across: Vector) -> int:
    """Stated; else where the body is; of a particle, where what it touches is not; else upwards on a body."""
    side = element.values.get("side", "positive")
    if side != "auto":
        return 1 if side == "positive" else -1
    on, way = (toucher(element), 1) if toucher(element) else (curve_body(element), -1)
    bearer = curve_body(element)
    away = -_side(element, geometry, bearer) if bearer and way == 1 else 0
    return way * _side(element, geometry, there(on)) or away or way * geometry.sign(across.y) or 1


def _side(element: Element, geometry: Geometry, body: str) -> int:
    """On which side of the line a body's centre of mass is."""
    return geometry.sign(_height(element, geometry, geometry.center(body))[0])


def taken(element: Element, geometry: Geometry) -> tuple[Scalar, ...]:
    """What is positive where a side that is not stated is the one that is taken; of a point that is held to both, nothing."""
    if element.values.get("side") != "auto" or (element.values.get("held") and "point" in element.values):
        return ()
    if element.values.get("circle") is not None:
        found = [_outside(element, geometry, geometry.where(element["circle"]))]
    else:
        bodies = [body for body in (toucher(element), curve_body(element)) if body]
        heights = [_height(element, geometry, geometry.center(body))[0] for body in bodies]
        found = [*heights, _height(element, geometry, geometry.center(bodies[0]))[1].y]
    return next(((value * way,) for value in found if (way := geometry.sign(value))), ())


# --- circles


def _on_circle(element: Element, geometry: Geometry) -> Meeting:
    here, middle = geometry.where(touching_point(element)), geometry.where(element["circle"])
    side = _side_of_circle(element, geometry, middle)
    radius, rim = scalar(element["radius"]), rim_of(element)
    up, gap = _away(here - middle, radius + rim * side, geometry)
    up = up * side
    return Meeting(here - up * rim if rim else here, up, gap, toucher(element), curve_body(element))


def _away(apart: Vector, reach: Scalar, geometry: Geometry) -> tuple[Vector, Scalar]:
    """(unit vector from the middle where the distance is `reach`, what vanishes there)."""
    apart = apart.settled()
    if len(apart.parts) != 1:
        return apart * reach.inverse(), apart.dot(apart) - reach * reach
    [(angle, length)] = apart.parts.items()
    sign = geometry.sign(length) or 1
    return Vector({angle: UNITY * sign}), length * sign - reach


def _side_of_circle(element: Element, geometry: Geometry, middle: Vector) -> int:
    """Stated; else -1 (inside) if the centre of mass of what touches is inside."""
    side = element.values.get("side", "outside")
    if side != "auto":
        return 1 if side == "outside" else -1
    return geometry.sign(_outside(element, geometry, middle)) or 1


def _outside(element: Element, geometry: Geometry, middle: Vector) -> Scalar:
    """Positive where the centre of mass of what touches is outside of the circle."""
    body = toucher(element)
    apart = (geometry.center(body) if body else geometry.where(element["point"])) - middle
    radius = scalar(element["radius"])
    return apart.dot(apart) - radius * radius


def side_taken(element: Element, geometry: Geometry) -> str:
    """The side of a line or a circle on which the body is."""
    if element.values.get("circle") is not None:
        return "outside" if _side_of_circle(element, geometry, geometry.where(element["circle"])) > 0 else "inside"
    return "positive" if _side_of_line(element, geometry, _line(element, geometry)[2]) > 0 else "negative"


# --- curves


def _on_curve(element: Element, geometry: Geometry) -> Meeting:
    """The normal is the tangent turned to its left; the gap is along the other axis than that of the parameter."""
    here, curve = geometry.where(element["point"]), element["curve"]
    rates = [derivative(scalar(node), curve.name) for node in (curve.x, curve.y)]
    factor = _common(rates, curve.name)  # a positive one, as that of a line
    way = cartesian(*(_there(rate * factor, curve, here) for rate in rates))
    side = -1 if element.values.get("side") == "negative" else 1
    up = way.turned() * (root(tidy(way.dot(way))).inverse() * side)
    apart = curve_gaps(element, geometry)
    return Meeting(here, up, apart[-1] if curve.axis == "x" else apart[0], toucher(element), None)


def _common(rates: list[Scalar], name: str) -> Scalar:
    """One over the parameters that all terms have in common."""
    terms = [dict(monomial) for rate in rates for monomial in rate.num.terms]
    kept = [index for index in set().union(*terms) if atoms.symbol_name(index) not in ("", None, name)]
    lowest = {index: min(term.get(index, 0) for term in terms) for index in kept}
    return Scalar(Poly({tuple(sorted((index, -power) for index, power in lowest.items() if power)): 1}))


def curve_gaps(element: Element, geometry: Geometry) -> tuple[Scalar, Scalar]:
    """What vanishes where the point is on the curve, along x and y."""
    here, curve = geometry.where(element["point"]), element["curve"]
    return here.x - _there(scalar(curve.x), curve, here), here.y - _there(scalar(curve.y), curve, here)


def parameter(element: Element, geometry: Geometry) -> Scalar:
    """Where on its curve the point of a constraint is: the value of the curve's parameter."""
    return _there(symbol(element["curve"].name), element["curve"], geometry.where(element["point"]))


def _there(value: Scalar, curve: Curve, here: Vector) -> Scalar:
    """A function of the curve's parameter at the point, for which an axis stands."""
    return substitute(value, {curve.name: getattr(here, curve.axis)}) if curve.axis else value


# --- forces


def _pair(element: Element, name: str, met: Meeting, vector: Vector, unknowns: tuple[str, ...]) -> tuple[Force, ...]:
    """The force on what touches, and the opposite one on the body of the curve."""
    label = touching_point(element).label if "point" in element.values else element["body"]
    return opposed(name, ((body, met.place, label) for body in (met.on, met.by)), vector, unknowns=unknowns)


def normal_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """N along the normal; with kinetic friction against the slip if there is a coefficient."""
    met, name = meeting(element, geometry), element.name
    found = _pair(element, name, met, met.normal * symbol(name), (name,))
    if "couple" in element.values:
        found = (*found, *couples(element["couple"], met.on, met.by, "ground", geometry))
    if element.values.get("coefficient") is None:
        return found
    drag = met.forward * (scalar(element["coefficient"]) * symbol(name) * -slip_sense(element, geometry, met))
    return (*found, *_pair(element, element["friction"], met, drag, (name,)))


def slip_sense(element: Element, geometry: Geometry, met: Meeting) -> int:
    """1 if what touches slips forward over the curve, -1 if backward."""
    if element["slip"] != "auto":
        return 1 if element["slip"] == "forward" else -1
    slip = slip_speed(geometry, met)
    found = geometry.sign(slip)
    if not found:
        raise StatementError(
            f"{element.kind} “{element.name}” has kinetic friction, but at the start nothing slips there",
            instead='say which way it will slip, slip = "forward" or "backward" (forward: to the right, seen with '
            'the normal upwards), or let it roll or stick: type = "rolling".',
            place=element.place,
        )
    return found


def slip_speed(geometry: Geometry, met: Meeting) -> Scalar:
    """Speed of the toucher over the curve at the contact, forward positive."""
    return met.forward.dot(geometry.velocity(met.on, met.place) - geometry.velocity(met.by, met.place))


def holding_forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """N along the normal and static friction along the tangent, both unknown."""
    met, name = meeting(element, geometry), element.name
    along = met.forward * _uphill(element, geometry, met)
    grip = element["friction"]
    return (
        *_pair(element, name, met, met.normal * symbol(name), (name,)),
        *_pair(element, grip, met, along * symbol(grip), (grip,)),
    )


def meshing_force(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    """The unknown force of teeth along the tangent, forward positive."""
    met, name = meeting(element, geometry), element.name
    return _pair(element, name, met, met.forward * symbol(name), (name,))


def _uphill(element: Element, geometry: Geometry, met: Meeting) -> int:
    """-1 if forward is downhill on a fixed line, else 1."""
    if element["line"] is None or met.by is not None or met.on is None:
        return 1
    rise = met.forward.y
    return -1 if not is_zero(rise) and geometry.sign(rise) < 0 else 1


# --- what contacts ask for


def touching(forces: Callable[[Element, Geometry], tuple[Force, ...]], **more: Any) -> Joint:
    """What touches a line, a circle or a curve: `forces` are those by which it does."""
    return Joint(forces, touches=_touches, gaps=_gaps, taken=taken, **more)


def _touches(element: Element) -> tuple[Touch, ...]:
    """A point of a body on a fixed line."""
    if "point" not in element.values or element["line"] is None or element["of"] is not None:
        return ()
    return (Touch(element["point"], element["line"], element.values.get("side", "auto")),)


def _gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    if element.values.get("curve") is not None:
        return tuple((gap, "gap") for gap in curve_gaps(element, geometry))
    return () if _touches(element) else ((meeting(element, geometry).gap, "gap"),)


def no_slip(element: Element, geometry: Geometry) -> tuple[tuple[str, Scalar], ...]:
    """What friction or teeth hold does not slip: the power of that force vanishes."""
    return ((element.values.get("friction", element.name), UNITY),)
