"""The equations of a mechanism in maximal coordinates, and its motion.

M A = F + Gᵀ λ with G A = -bias: the conditions are differentiated twice (index one), their
unknown forces are the multipliers λ. Nothing of the symbolic solution is used.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.frozen import Frozen
from rbpsym.numeric.integration import Rate, followed
from rbpsym.oracles.simulation_bodies import Law, Load, Mechanism, State
from rbpsym.oracles.simulation_joints import Kept, StateRow

STATES = 20  # that are looked at along a motion


class Response(Frozen):
    """What the equations say at a state: accelerations of the bodies, multipliers, loads, rows."""

    gained: np.ndarray
    multipliers: np.ndarray
    loads: list[Load]
    rows: list[StateRow]
    where: State
    speed: State


class Equations:
    """Accelerations and multipliers of a mechanism at any state."""

    def __init__(self, mechanism: Mechanism, laws: list[Law], kept: list[Kept], idle: list[int]) -> None:
        self.mechanism, self.laws, self.kept = mechanism, laws, kept
        self.masses = np.array(mechanism.masses)
        self.masses[idle] = 1.0  # the angle of a particle that nothing turns: any number does
        self.size = len(self.masses)
        self.bare = np.diag([*self.masses, *[0.0] * len(kept)]).tolist()  # plain lists: single entries are soon set

    def at(self, where: np.ndarray, speed: np.ndarray) -> Response:
        """Raises NotApplicable where the constraints leave a force undetermined."""
        where, speed = where.tolist(), speed.tolist()
        loads = [load for law in self.laws for load in law(where, speed)]
        rows = [item.at(where, speed) for item in self.kept]
        try:
            found = np.linalg.solve(self._matrix(rows, where, speed), self._right(loads, rows))
        except np.linalg.LinAlgError:
            raise NotApplicable("the simulation can't tell the unknown forces apart at this state") from None
        return Response(found[: self.size], found[self.size :], loads, rows, where, speed)

    def _matrix(self, rows: list[StateRow], where: State, speed: State) -> np.ndarray:
        size = self.size
        matrix = [row[:] for row in self.bare]
        for k, row in enumerate(rows, size):
            for column, entry in row.entries:
                matrix[k][column] += entry
                matrix[column][k] -= entry
        for k, item in enumerate(self.kept, size):
            for column, entry in (part for drag in item.drags for part in drag.at(where, speed)):
                matrix[column][k] -= entry
        return np.array(matrix)

    def _right(self, loads: list[Load], rows: list[StateRow]) -> np.ndarray:
        right = [0.0] * self.size + [-row.bias for row in rows]
        for load in loads:
            k = 3 * load.body
            right[k] += load.x
            right[k + 1] += load.y
            right[k + 2] += load.torque
        return np.array(right)

    def kinetic_energy(self, speed: np.ndarray) -> float:
        """Σ ½ M V² + ½ I_cm ω²."""
        return 0.5 * float(self.masses @ (speed * speed))

    def powers(self, speed: np.ndarray, balance: Response, account: Mapping[tuple[str, str, bool], int]) -> list[float]:
        """Power of every force on every body, F·V_cm and τ_cm ω apart, in the order of `account`."""
        found, names, speeds = [0.0] * len(account), self.mechanism.problem.body_names, speed.tolist()
        for name, column, push in self._pushes(balance) if account else ():
            k = account.get((name, names[column // 3], column % 3 == 2))
            if k is not None:
                found[k] += push * speeds[column]
        return found

    def momentum(self, speed: np.ndarray) -> float:
        """The largest of M |V| and I_cm |ω|: a size to compare momenta with."""
        return float(np.abs(self.masses * speed).max(initial=0.0))

    def torques(self, balance: Response, levers: list[tuple[float, float]]) -> list[float]:
        """Torque of all forces on all bodies about each of the fixed places."""
        net = [0.0] * self.size
        for _, column, push in self._pushes(balance) if levers else ():
            net[column] += push
        bodies = [(*balance.where[k : k + 2], *net[k : k + 3]) for k in range(0, self.size, 3)]
        return [sum((bx - x) * fy - (by - y) * fx + couple for bx, by, fx, fy, couple in bodies) for x, y in levers]

    def _pushes(self, balance: Response) -> Iterator[tuple[str, int, float]]:
        """(force, column of X, its component there)."""
        for load in balance.loads:
            for axis, push in enumerate((load.x, load.y, load.torque)):
                yield load.name, 3 * load.body + axis, push
        for item, row, multiplier in zip(self.kept, balance.rows, balance.multipliers.tolist(), strict=True):
            for column, entry in row.entries:
                yield item.force, column, entry * multiplier
            for drag in item.drags:
                for column, entry in drag.at(balance.where, balance.speed):
                    yield drag.name, column, entry * multiplier


def duration(where_rate: np.ndarray, gained: np.ndarray, reach: float) -> float:
    """A time in which the fastest body turns by about 0.4, or goes as far in terms of `reach`."""
    scale = np.tile([1 / reach, 1 / reach, 1.0], len(gained) // 3)
    speed, gain = (float(np.abs(values * scale).max(initial=0.0)) for values in (where_rate, gained))
    if speed < 1e-9 and gain < 1e-9:
        return 0.1
    return min(2.0, 0.8 / (speed + math.sqrt(speed * speed + 0.8 * gain)))


def trajectory(rate: Rate, start: np.ndarray, time: float) -> list[np.ndarray]:
    """The states at the ends of equal parts of a time, the start first. Raises NotApplicable at a singularity."""
    path = followed(rate, start, time, longest=time / STATES)
    if path.times[-1] < time:
        raise NotApplicable(f"the simulation did not get beyond the time {path.times[-1]:.3g}")
    return list(path.at(np.linspace(0.0, time, STATES + 1)).T)
