"""The known forces of a mechanism as numbers.

Each law of a force is written from its definition, apart from `mechanics.interactions`; a new kind is a new entry of `LAWS`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from rbpsym.errors import NotApplicable
from rbpsym.expr.tree import Node
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles import simulation_resistance
from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism, State, difference, load_at, placed
from rbpsym.statement.model import Element


def _gravity(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    g, (dx, dy) = mechanism.number(element["g"]), mechanism.pair(element["direction"])
    bodies = [mechanism.body_number(name) for name in element["bodies"]]
    weights = [(k, mechanism.masses[3 * k] * g) for k in bodies]
    return lambda where, speed: [Load(element.name, k, weight * dx, weight * dy, 0.0) for k, weight in weights]


def _between(element: Element, mechanism: Mechanism, pull: Callable[[float, float], float]) -> Law:
    """A force along the line of two points: pull(distance, its rate), times the vector between them."""
    spots = [mechanism.spot(ref) for ref in element["between"]]

    def law(where: State, speed: State) -> list[Load]:
        a, b = (placed(spot, where, speed) for spot in spots)
        dx, dy = b.place[0] - a.place[0], b.place[1] - a.place[1]
        vx, vy = b.velocity[0] - a.velocity[0], b.velocity[1] - a.velocity[1]
        share = pull(math.hypot(dx, dy), dx * vx + dy * vy)
        ends = ((a, share), (b, -share))
        return [load_at(element.name, end, f * dx, f * dy) for end, f in ends if end.body >= 0]

    return law


def _spring(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    k, slack = mechanism.number(element["stiffness"]), mechanism.number(element["natural_length"])
    return _between(element, mechanism, lambda d, rate: k if slack == 0 else k * (1 - slack / d))


def _damper(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    c = mechanism.number(element["coefficient"])
    return _between(element, mechanism, lambda d, rate: c * rate / (d * d))


def _pull(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    sizes = _values((element["size"],), mechanism, coordinates)

    def law(where: State, speed: State) -> list[Load]:
        size = sizes(where, speed)[0]
        return _between(element, mechanism, lambda d, rate: size / d)(where, speed)

    return law


def _couples(name: str, first: int, second: int, on_second: float) -> list[Load]:
    pairs = ((second, on_second), (first, -on_second))
    return [Load(name, k, 0.0, 0.0, couple) for k, couple in pairs if k >= 0]


def _torsion(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    k, rest = mechanism.number(element["stiffness"]), mechanism.number(element["rest_angle"])
    a, b = map(mechanism.body_number, element["between"])
    return lambda where, speed: _couples(element.name, a, b, -k * (difference(where, a, b) - rest))


def _rotary_damper(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    c = mechanism.number(element["coefficient"])
    a, b = map(mechanism.body_number, element["between"])
    return lambda where, speed: _couples(element.name, a, b, -c * difference(speed, a, b))


def _values(nodes: tuple[Node, ...], mechanism: Mechanism, coordinates: Coordinates) -> Callable[..., list[float]]:
    """Values of expressions, which may hold coordinates and speeds, at a state."""
    if mechanism.is_constant(*nodes):
        fixed = [mechanism.number(node) for node in nodes]
        return lambda where, speed: fixed
    scalars = [scalar(node) for node in nodes]
    return lambda where, speed: Values(coordinates(where, speed)).row(scalars)


def _force(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    spot, turns = mechanism.spot(element["on"]), element["frame"] == "body"
    components = _values(element["force"], mechanism, coordinates)

    def law(where: State, speed: State) -> list[Load]:
        x, y = components(where, speed)
        angle = where[3 * spot.body + 2] if turns else 0.0
        c, s = math.cos(angle), math.sin(angle)
        return [load_at(element.name, placed(spot, where, speed), c * x - s * y, s * x + c * y)]

    return law


def _couple(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    on, other = mechanism.body_number(element["on"]), mechanism.body_number(element["reaction_on"])
    couple = _values((element["couple"],), mechanism, coordinates)
    return lambda where, speed: _couples(element.name, other, on, couple(where, speed)[0])


LAWS: Mapping[str, Callable[[Element, Mechanism, Coordinates], Law]] = {
    "gravity": _gravity,
    "spring": _spring,
    "torsion-spring": _torsion,
    "pull": _pull,
    "damper": _damper,
    "rotary-damper": _rotary_damper,
    "force": _force,
    "couple": _couple,
    "resistance": simulation_resistance.law,
    "resisting-couple": simulation_resistance.law,
}


def laws(mechanism: Mechanism, coordinates: Coordinates) -> list[Law]:
    """The laws of all interactions; `coordinates` gives the values of q and q̇ at a state."""
    found = []
    for element in mechanism.problem.interactions:
        if element.kind not in LAWS:
            raise NotApplicable(f"the simulation does not know the interaction {element.kind}")
        found.append(LAWS[element.kind](element, mechanism, coordinates))
    return found
