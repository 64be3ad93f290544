"""What the statement says of the coordinates: places and angles of bodies as functions of them; a state to start from.

The coordinates, their speeds and accelerations are recovered from simulated bodies by least
squares through these relations alone. A state to start from satisfies every condition.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cached_property

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.expr.tree import Node
from rbpsym.field import Scalar, derivative, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Mechanism, State
from rbpsym.oracles.simulation_joints import Condition, Entries, Kept, component, turn
from rbpsym.statement.model import Body

MOST_STEPS = 30
CLOSE = 1e-15


class Stated:
    """An expression of the statement as a function of the coordinates and t, with two derivatives.

    `slopes` are ∂/∂q for every coordinate; `drift` is ∂/∂t; `bend` the part of d²/dt² without q̈.
    """

    def __init__(self, node: Node, coordinates: tuple[str, ...]) -> None:
        self.value, self.coordinates = scalar(node), coordinates

    @cached_property
    def slopes(self) -> tuple[Scalar, ...]:
        """∂/∂q by coordinate."""
        return tuple(derivative(self.value, name) for name in self.coordinates)

    @cached_property
    def drift(self) -> Scalar:
        """∂/∂t."""
        return derivative(self.value, "t")

    @cached_property
    def bend(self) -> Scalar:
        """Σ ∂²/∂q∂q' q̇ q̇' + 2 Σ ∂²/∂q∂t q̇ + ∂²/∂t²."""
        total = derivative(self.drift, "t")
        for name, slope in zip(self.coordinates, self.slopes, strict=True):
            total = total + derivative(slope, "t") * symbol(f"{name}_dot") * 2
            for other in self.coordinates:
                total = total + derivative(slope, other) * symbol(f"{name}_dot") * symbol(f"{other}_dot")
        return total


class Placing(Frozen):
    """stated(q) = something of the body, whose value, derivative by X and bias `of` gives."""

    stated: Stated
    of: Condition


def dotted(entries: Entries, values: State) -> float:
    """Σ entry × value."""
    return sum((entry * float(values[column]) for column, entry in entries), 0.0)


def nearest(slopes: np.ndarray, values: State) -> np.ndarray:
    """The least x by which slopes · x comes nearest to the values."""
    return np.asarray(np.linalg.lstsq(slopes, np.array(values), rcond=None)[0])


class Placement:
    """All links of a statement between its coordinates and its bodies."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.names = tuple(c.name for c in mechanism.problem.coordinates)
        self.links = [link for body in mechanism.problem.bodies for link in self._links(body)]

    def _links(self, body: Body) -> list[Placing]:
        k, found = self.mechanism.place[body.name], []
        if body.placed is not None:
            point, place = body.placed
            spot = self.mechanism.spot_of(body, point)
            ways = zip(place, ((1.0, 0.0), (0.0, 1.0)), strict=True)
            found += [Placing(Stated(node, self.names), component(spot, *way)) for node, way in ways]
        if body.angle is not None:
            found.append(Placing(Stated(body.angle, self.names), turn(-1, k)))
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

    def slopes(self, known: Values) -> np.ndarray:
        """∂stated/∂q, a row a link."""
        return np.array([known.row(link.stated.slopes) for link in self.links]).reshape(
            len(self.links), len(self.names)
        )

    def coordinates(self, where: State, guess: State) -> np.ndarray:
        """q of a pose of the bodies, near the guess, by Gauss-Newton steps."""
        q = np.array(guess, dtype=float)
        seen = [link.of(where, where).value for link in self.links]
        for _ in range(MOST_STEPS):
            known = Values(self.numbers(q))
            gap = [value - known.of(link.stated.value) for value, link in zip(seen, self.links, strict=True)]
            step = nearest(self.slopes(known), gap)
            q = q + step
            if np.abs(step).max(initial=0.0) < CLOSE * (1 + np.abs(q).max(initial=0.0)):
                break
        return q

    def speeds(self, q: State, where: State, speed: State) -> np.ndarray:
        """q̇ of the velocities of the bodies."""
        known = Values(self.numbers(q))
        seen = [dotted(link.of(where, speed).entries, speed) - known.of(link.stated.drift) for link in self.links]
        return nearest(self.slopes(known), seen)

    def accelerations(self, q: State, rates: State, where: State, speed: State, gained: State) -> np.ndarray:
        """q̈ of the accelerations `gained` of the bodies."""
        known, seen = Values(self.numbers(q, rates)), []
        for link in self.links:
            row = link.of(where, speed)
            seen.append(dotted(row.entries, gained) + row.bias - known.of(link.stated.bend))
        return nearest(self.slopes(known), seen)

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


RANK = 1e-9


class Start(Frozen):
    """q, q̇, X, V; `freedom` is the number of independent speeds that the conditions leave."""

    q: np.ndarray
    rates: np.ndarray
    where: np.ndarray
    speed: np.ndarray
    freedom: int


class Conditions:
    """The relations and constraints as functions of z = (q, X)."""

    def __init__(self, placement: Placement, kept: list[Kept], idle: list[int]) -> None:
        self.placement, self.kept, self.idle = placement, kept, idle
        self.count = len(placement.names)
        places = [item.is_place for item in kept]
        self.places = np.array([True] * len(placement.links) + places + [True] * len(idle), dtype=bool)

    def at(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(values, derivative by z, derivative by t)."""
        q, where = z[: self.count], z[self.count :].tolist()
        known, values, rows, drifts = Values(self.placement.numbers(q)), [], [], []
        still = [0.0] * len(where)
        for link in self.placement.links:
            row = link.of(where, still)
            values.append(row.value - known.of(link.stated.value))
            drifts.append(-known.of(link.stated.drift))
            rows.append(self._row(row.entries, known.row(link.stated.slopes)))
        for item in self.kept:
            row = item.at(where, still)
            values.append(row.value)
            drifts.append(row.drift)
            rows.append(self._row(row.entries, None))
        for column in self.idle:
            values.append(where[column])
            drifts.append(0.0)
            rows.append(self._row([(column, 1.0)], None))
        return np.array(values), np.array(rows).reshape(-1, len(z)), np.array(drifts)

    def _row(self, entries: Entries, slopes: Sequence[float] | None) -> list[float]:
        row = [0.0] * (self.count + 3 * len(self.placement.mechanism.centers))
        if slopes is not None:
            row[: self.count] = [-slope for slope in slopes]
        for column, entry in entries:
            row[self.count + column] += entry
        return row


def _settled(conditions: Conditions, guess: np.ndarray, held: Collection[int]) -> np.ndarray:
    """The nearest z that satisfies the conditions; the columns `held` stay as they are."""
    z, free = guess.copy(), [k for k in range(len(guess)) if k not in held]
    for _ in range(MOST_STEPS):
        values, slopes, _ = conditions.at(z)
        if np.abs(values).max(initial=0.0) < 1e-14:
            return z
        places = conditions.places
        z[free] -= nearest(slopes[places][:, free], values[places])
    if np.abs(conditions.at(z)[0][conditions.places]).max(initial=0.0) > 1e-10:
        raise NotApplicable("no state of the bodies that satisfies all constraints was found near the sample state")
    return z


def _allowed(slopes: np.ndarray) -> np.ndarray:
    """Columns that span the velocities ż with slopes · ż = 0."""
    if not len(slopes):
        return np.eye(slopes.shape[1])
    _, sizes, rows = np.linalg.svd(slopes)
    return rows[int((sizes > RANK * max(sizes[0], 1.0)).sum()) :].T


def start_state(
    conditions: Conditions, q: Mapping[str, float], rates: Mapping[str, float], where: np.ndarray, held: Collection[str]
) -> Start:
    """The state near (q, X) at which the named coordinates in `held` keep their values, with speeds
    as near as the conditions allow to the wanted ones."""
    names = conditions.placement.names
    guess = np.concatenate([[q[name] for name in names], where])
    z = _settled(conditions, guess, [k for k, name in enumerate(names) if name in held])
    _, slopes, drifts = conditions.at(z)
    span, carried = (
        _allowed(slopes),
        -np.linalg.lstsq(slopes, drifts, rcond=None)[0] if len(slopes) else np.zeros(len(z)),
    )
    wanted = [(k, rates[name] - carried[k]) for k, name in enumerate(names) if name in rates]
    share = np.linalg.lstsq(span[[k for k, _ in wanted]], np.array([v for _, v in wanted]), rcond=None)[0]
    z_dot, count = carried + span @ share, len(names)
    return Start(z[:count], z_dot[:count], z[count:], z_dot[count:], span.shape[1])


def idle_angles(mechanism: Mechanism) -> list[int]:
    """Columns of the angles of particles that nothing turns."""
    welded = {
        ref.body for element in mechanism.problem.constraints if element.kind == "weld" for ref in element["points"]
    }
    return [
        3 * k + 2
        for k, body in enumerate(mechanism.problem.bodies)
        if body.shape.kind == "particle" and body.name not in welded
    ]
