"""A consistent state to start from: bodies and coordinates that satisfy every condition."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.verify.simulation_bodies import Mechanism
from rbpsym.verify.simulation_joints import Kept
from rbpsym.verify.simulation_numbers import Numbers
from rbpsym.verify.simulation_placement import MOST_STEPS, Placement

RANK = 1e-9


@dataclass(frozen=True)
class Start:
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
        known, values, rows, drifts = Numbers(self.placement.numbers(q)), [], [], []
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

    def _row(self, entries, slopes) -> list[float]:
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
        z[free] -= np.linalg.lstsq(slopes[np.ix_(places, free)], values[places], rcond=None)[0]
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
