"""What the statement says of the coordinates: places and angles of bodies as functions of them.

The coordinates, their speeds and accelerations are recovered from simulated bodies by least
squares through these relations alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from rbpsym.verify.simulation_bodies import Mechanism, Spot, State, placed
from rbpsym.verify.simulation_joints import Entries, Row
from rbpsym.verify.simulation_numbers import Numbers, Stated

MOST_STEPS = 30
CLOSE = 1e-15


@dataclass(frozen=True)
class Link:
    """stated(q) = something of the body, whose value, derivative by X and bias `of` gives."""

    stated: Stated
    of: Callable[[State, State], Row]


def _component(spot: Spot, axis: int) -> Callable[[State, State], Row]:
    direction = (1.0, 0.0) if axis == 0 else (0.0, 1.0)

    def row(where: State, speed: State) -> Row:
        at = placed(spot, where, speed)
        return Row(at.place[axis], at.along(*direction), at.bias[axis])

    return row


def _angle(body: int) -> Callable[[State, State], Row]:
    return lambda where, speed: Row(where[3 * body + 2], [(3 * body + 2, 1.0)], 0.0)


def dotted(entries: Entries, values: State) -> float:
    """Σ entry × value."""
    return sum(entry * values[column] for column, entry in entries)


class Placement:
    """All links of a statement between its coordinates and its bodies."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.names = tuple(c.name for c in mechanism.problem.coordinates)
        self.links = [link for body in mechanism.problem.bodies for link in self._links(body)]

    def _links(self, body) -> list[Link]:
        k, found = self.mechanism.place[body.name], []
        if body.placed is not None:
            point, place = body.placed
            spot = self.mechanism.spot_of(body, point)
            found += [Link(Stated(node, self.names), _component(spot, axis)) for axis, node in enumerate(place)]
        if body.angle is not None:
            found.append(Link(Stated(body.angle, self.names), _angle(k)))
        return found

    def numbers(self, q: State, speeds: State | None = None) -> dict[str, float]:
        """Parameters, coordinates and speeds by name."""
        found = {
            **self.mechanism.numbers,
            **dict(zip(self.names, map(float, q), strict=True)),
            "t": self.mechanism.clock,
        }
        if speeds is not None:
            found |= {f"{name}_dot": float(v) for name, v in zip(self.names, speeds, strict=True)}
        return found

    def slopes(self, known: Numbers) -> np.ndarray:
        """∂stated/∂q, a row a link."""
        return np.array([known.row(link.stated.slopes) for link in self.links]).reshape(
            len(self.links), len(self.names)
        )

    def coordinates(self, where: State, guess: State) -> np.ndarray:
        """q of a pose of the bodies, near the guess, by Gauss-Newton steps."""
        q = np.array(guess, dtype=float)
        seen = [link.of(where, where).value for link in self.links]
        for _ in range(MOST_STEPS):
            known = Numbers(self.numbers(q))
            gap = [value - known.of(link.stated.value) for value, link in zip(seen, self.links, strict=True)]
            step = np.linalg.lstsq(self.slopes(known), np.array(gap), rcond=None)[0]
            q = q + step
            if np.abs(step).max(initial=0.0) < CLOSE * (1 + np.abs(q).max(initial=0.0)):
                break
        return q

    def speeds(self, q: State, where: State, speed: State) -> np.ndarray:
        """q̇ of the velocities of the bodies."""
        known = Numbers(self.numbers(q))
        seen = [dotted(link.of(where, speed).entries, speed) - known.of(link.stated.drift) for link in self.links]
        return np.linalg.lstsq(self.slopes(known), np.array(seen), rcond=None)[0]

    def accelerations(self, q: State, rates: State, where: State, speed: State, gained: State) -> np.ndarray:
        """q̈ of the accelerations `gained` of the bodies."""
        known, seen = Numbers(self.numbers(q, rates)), []
        for link in self.links:
            row = link.of(where, speed)
            seen.append(dotted(row.entries, gained) + row.bias - known.of(link.stated.bend))
        return np.linalg.lstsq(self.slopes(known), np.array(seen), rcond=None)[0]

    def state(self, where: State, speed: State, guess: State) -> tuple[np.ndarray, np.ndarray]:
        """(q, q̇) of a state of the bodies."""
        q = self.coordinates(where, guess)
        return q, self.speeds(q, where, speed)

    def reader(self, start: State) -> Callable[[State, State], Mapping[str, float]]:
        """Names with their numbers at a state; each search starts where the last one ended."""
        last = [np.array(start, dtype=float)]

        def read(where: State, speed: State) -> Mapping[str, float]:
            last[0], rates = self.state(where, speed, last[0])
            return self.numbers(last[0], rates)

        return read
