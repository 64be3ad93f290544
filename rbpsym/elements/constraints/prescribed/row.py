"""A point driven along a direction of space or of a body; the force is along it."""

import cmath

from rbpsym.oracles.simulation_contacts import Complex, Point, Push, frame_of, kept_by, spot_at
from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, State, driven


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """Its place along the direction."""
    spot, (ax, ay) = mechanism.spot(element["point"]), mechanism.pair(element["along"])
    bearer = mechanism.body_number(element["of"])
    frame = frame_of(bearer, mechanism)

    def along(where: Complex) -> Point:
        angle = where[3 * bearer + 2] if bearer >= 0 else 0.0
        cos, sin = cmath.cos(angle), cmath.sin(angle)
        return cos * ax - sin * ay, sin * ax + cos * ay

    def pushes(where: Complex) -> list[Push]:
        here, (x, y) = spot_at(spot, where), along(where)
        return [Push(spot.body, here, x, y), Push(bearer, here, -x, -y)]

    def place(where: Complex) -> complex:
        here, origin, way = spot_at(spot, where), spot_at(frame, where), along(where)
        return sum((a - b) * c for a, b, c in zip(here, origin, way, strict=True))

    own = kept_by(element.name, element.name, pushes, place)
    return [driven(element.name, element.name, own.at, element["distance"], mechanism)]
