"""Contacts in maximal coordinates, from the directions of their unit forces; and all that is simulated.

Of a constraint force per unit (pushes at places on bodies) the row of the condition is its
generalized force in X: an ideal force does no work, so that row times V vanishes. Its rate along V
is taken by a complex step, exact to rounding (Squire & Trapp, SIAM Review 40 (1998) 110).
Written apart from `mechanics`: numbers only, no formulas are shared. The `rows` of a kind stand in its folder.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.kinds import KindParts
from rbpsym.field.elliptic import FUNCTIONS
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Mechanism, Spot, State
from rbpsym.oracles.simulation_joints import Drag, Entries, Kept, StateRow
from rbpsym.statement.model import Element, PointRef

STEP = 1e-30
H = 1e-3  # of differences of fourth order
NEWTON = 8
Complex = list[complex]
Point = tuple[complex, complex]
GROUND_SPOT = Spot(-1, 0.0, 0.0)
COMPLEX_FUNCTIONS = {kind: getattr(cmath, function.__name__, function) for kind, function in FUNCTIONS.items()}


class Push(Frozen):
    """A unit force (x, y) at a place on body number `body` (-1: the ground, on which nothing is counted)."""

    body: int
    place: Point
    x: complex
    y: complex


Pushes = Callable[[Complex], list[Push]]


def spot_at(spot: Spot, where: Complex) -> Point:
    """Place of a spot."""
    if spot.body < 0:
        return complex(spot.x), complex(spot.y)
    k = 3 * spot.body
    c, s = cmath.cos(where[k + 2]), cmath.sin(where[k + 2])
    return where[k] + c * spot.x - s * spot.y, where[k + 1] + s * spot.x + c * spot.y


def _entries(pushes: list[Push], where: Complex) -> list[tuple[int, complex]]:
    found = []
    for push in pushes:
        if push.body >= 0:
            k = 3 * push.body
            lever = push.place[0] - where[k], push.place[1] - where[k + 1]
            found += [(k, push.x), (k + 1, push.y), (k + 2, lever[0] * push.y - lever[1] * push.x)]
    return found


def kept_by(
    name: str,
    multiplier: str,
    pushes: Pushes,
    value: Callable[[Complex], complex] | None = None,
    drags: tuple[Drag, ...] = (),
) -> Kept:
    """The condition that a unit force keeps; without a value it is one for the speeds alone."""

    def row(where: State, speed: State) -> StateRow:
        shifted = [x + 1j * STEP * v for x, v in zip(where, speed, strict=True)]
        entries = _entries(pushes(shifted), shifted)
        bias = sum(entry.imag / STEP * speed[column] for column, entry in entries)
        gap = 0.0 if value is None else value(shifted).real
        return StateRow(gap, [(column, entry.real) for column, entry in entries], bias)

    return Kept(name, multiplier, row, value is not None, drags)


# --- contacts with lines and circles


class CurveAtState(Frozen):
    """gap and unit normal (towards what touches) of a curve at a state, and the radius of what touches."""

    gap: Callable[[Complex], complex]
    normal: Callable[[Complex], Point]
    touching: Spot
    rim: float
    bearer: int

    def place(self, where: Complex) -> Point:
        """The point of contact."""
        (x, y), (nx, ny) = spot_at(self.touching, where), self.normal(where)
        return x - self.rim * nx, y - self.rim * ny

    def push(self, where: Complex, direction: Point) -> list[Push]:
        """A unit force on what touches, and its opposite on the bearer of the curve."""
        here, (x, y) = self.place(where), direction
        return [Push(self.touching.body, here, x, y), Push(self.bearer, here, -x, -y)]


def _touching(element: Element, mechanism: Mechanism) -> tuple[Spot, float]:
    if "body" in element.values:
        name = element["body"]
        return mechanism.spot(PointRef("", name, "center")), mechanism.number(element["rim"])
    return mechanism.spot(element["point"]), 0.0


def curve(element: Element, mechanism: Mechanism, start: State) -> CurveAtState:
    """The curve of a contact."""
    if element.values.get("curve") is not None:
        return _bent(element, mechanism, start)
    return (_circle if element.values.get("circle") is not None else _line)(element, mechanism, start)


def _bent(element: Element, mechanism: Mechanism, start: State) -> CurveAtState:
    """A curve by its parameter: an axis, or what is nearest to the point, followed from where the point starts."""
    touching, bend = mechanism.spot(element["point"]), element["curve"]
    side, place = -1 if element.values.get("side") == "negative" else 1, (scalar(bend.x), scalar(bend.y))

    def at(u: complex) -> np.ndarray:
        known: dict[str, Any] = {**mechanism.numbers, bend.name: u}  # a complex one: of it derivatives are taken
        return np.array(Values(known, COMPLEX_FUNCTIONS).row(place))

    def along(u: complex) -> np.ndarray:
        return np.asarray((8 * (at(u + H) - at(u - H)) - at(u + 2 * H) + at(u - 2 * H)) / (12 * H))

    def apart(where: Complex, u: complex) -> np.ndarray:
        return np.asarray(np.array(spot_at(touching, where)) - at(u))

    first = list(map(complex, start))
    last = [min(np.linspace(-8.0, 8.0, 1601), key=lambda u: np.nan_to_num(np.linalg.norm(apart(first, u)), nan=np.inf))]

    def parameter(where: Complex) -> complex:
        if bend.axis:
            x, y = spot_at(touching, where)
            return x if bend.axis == "x" else y
        u = complex(last[0])
        for _ in range(NEWTON):
            way = along(u)
            u += complex(way.dot(apart(where, u)) / way.dot(way))
        last[0] = u.real
        return u

    def normal(where: Complex) -> Point:
        x, y = along(parameter(where))
        length = cmath.sqrt(x * x + y * y)
        return -side * y / length, side * x / length

    def gap(where: Complex) -> complex:
        (x, y), (nx, ny) = apart(where, parameter(where)), normal(where)
        return complex(x * nx + y * ny)

    return CurveAtState(gap, normal, touching, 0.0, -1)


def _line(element: Element, mechanism: Mechanism, start: State) -> CurveAtState:
    touching, rim = _touching(element, mechanism)
    line, bearer = element["line"], mechanism.body_number(element["of"])
    a, b, c = (mechanism.number(node) for node in (line.a, line.b, line.c))
    a, b, c = (part / math.hypot(a, b) for part in (a, b, c))
    frame = frame_of(bearer, mechanism)

    def across(where: Complex) -> Point:
        angle = where[3 * bearer + 2] if bearer >= 0 else 0.0
        cos, sin = cmath.cos(angle), cmath.sin(angle)
        return cos * a - sin * b, sin * a + cos * b

    def height(where: Complex, point: Point) -> complex:
        (x, y), (nx, ny) = spot_at(frame, where), across(where)
        return (point[0] - x) * nx + (point[1] - y) * ny - c

    def upward(where: Complex) -> Point:
        x, y = across(where)
        return side * x, side * y

    first = list(map(complex, start))
    side = _side(element, touching, bearer, lambda p: height(first, p).real, across(first)[1].real, start)
    return CurveAtState(
        lambda where: side * height(where, spot_at(touching, where)) - rim,
        upward,
        touching,
        rim,
        bearer,
    )


def _side(
    element: Element, touching: Spot, bearer: int, height: Callable[[tuple[float, float]], float], rise: float, start: State
) -> int:
    stated = element.values.get("side", "positive")
    if stated != "auto":
        return 1 if stated == "positive" else -1
    body, way = (touching.body, 1) if touching.body >= 0 else (bearer, -1)
    here = height((start[3 * body], start[3 * body + 1]))
    if abs(here) <= 1e-9 and way == 1 and bearer >= 0:
        here = -height((start[3 * bearer], start[3 * bearer + 1]))
    found = here if abs(here) > 1e-9 else rise
    return way * (-1 if found < -1e-9 else 1)


def _circle(element: Element, mechanism: Mechanism, start: State) -> CurveAtState:
    touching, rim = _touching(element, mechanism)
    middle, radius = mechanism.spot(element["circle"]), mechanism.number(element["radius"])
    side = _side_of_circle(element, touching, middle, radius, start)
    reach = radius + side * rim

    def apart(where: Complex) -> tuple[complex, complex, complex]:
        (x, y), (cx, cy) = spot_at(touching, where), spot_at(middle, where)
        return x - cx, y - cy, cmath.sqrt((x - cx) ** 2 + (y - cy) ** 2)

    def normal(where: Complex) -> Point:
        x, y, distance = apart(where)
        return side * x / distance, side * y / distance

    return CurveAtState(lambda where: side * (apart(where)[2] - reach), normal, touching, rim, middle.body)


def _side_of_circle(element: Element, touching: Spot, middle: Spot, radius: float, start: State) -> int:
    stated = element.values.get("side", "outside")
    if stated != "auto":
        return 1 if stated == "outside" else -1
    place = list(map(complex, start))
    x, y = (start[3 * touching.body : 3 * touching.body + 2]) if touching.body >= 0 else spot_at(touching, place)
    cx, cy = spot_at(middle, place)
    return -1 if abs(complex(x - cx.real, y - cy.real)) < radius - 1e-6 else 1


def _normal(element: Element, bend: CurveAtState, *drags: Drag) -> Kept:
    return kept_by(element.name, element.name, lambda where: bend.push(where, bend.normal(where)), bend.gap, drags)


def _forward(bend: CurveAtState, sign: int = 1) -> Pushes:
    """A unit force along the tangent: the normal turned clockwise."""

    def pushes(where: Complex) -> list[Push]:
        nx, ny = bend.normal(where)
        return bend.push(where, (sign * ny, -sign * nx))

    return pushes


def sliding(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """N; with kinetic friction μN against the slip."""
    bend, drags = curve(element, mechanism, start), []
    if element.values.get("coefficient") is not None:
        pushes = _forward(bend, -mechanism.slips[element.name])
        share = mechanism.number(element["coefficient"])
        drags = [Drag(element["friction"], lambda where, speed: _real(pushes, where, share))]
    return [_normal(element, bend, *drags)]


def _real(pushes: Pushes, where: State, share: float) -> Entries:
    place = list(map(complex, where))
    return [(column, share * entry.real) for column, entry in _entries(pushes(place), place)]


def holding(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """N and static friction, positive uphill on a fixed line that slopes, else forward."""
    bend = curve(element, mechanism, start)
    sign = 1
    if element["line"] is not None and bend.bearer < 0:
        sign = -1 if -bend.normal(list(map(complex, start)))[0].real < -1e-9 else 1
    return [_normal(element, bend), kept_by(element.name, element["friction"], _forward(bend, sign))]


def meshing(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """The force of the teeth, forward positive, keeps them from slipping."""
    return [slipping(element, mechanism, start)]


def slipping(element: Element, mechanism: Mechanism, start: State) -> Kept:
    """Its row times V is the speed with which what touches slips forward over the curve."""
    return kept_by(element.name, element.name, _forward(curve(element, mechanism, start)))


def frame_of(bearer: int, mechanism: Mechanism) -> Spot:
    """The origin of the frame of a body, or of space."""
    return Spot(bearer, *(-part for part in mechanism.centers[bearer])) if bearer >= 0 else GROUND_SPOT


ROWS: KindParts[Callable[[Element, Mechanism, State], list[Kept]]] = KindParts(CONSTRAINTS, "row", "rows")


def conditions(mechanism: Mechanism, start: State) -> list[Kept]:
    """All conditions of a statement; `start` says where a pivot without a place holds its point."""
    return [kept for element in mechanism.problem.constraints for kept in ROWS[element.kind](element, mechanism, start)]
