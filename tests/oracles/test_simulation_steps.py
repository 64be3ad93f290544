"""The integrator against motions that are known exactly, and against another of scipy's methods."""

import math

import numpy as np
import pytest

from rbpsym.errors import NotApplicable
from rbpsym.numeric.integration import Event, followed
from rbpsym.oracles.simulation_motion import trajectory


def test_an_oscillation_is_followed_to_rounding() -> None:
    path = followed(lambda t, y: np.array([y[1], -y[0]]), [1.0, 0.0], 2.0, longest=0.2)
    assert path.at(2.0) == pytest.approx([math.cos(2), -math.sin(2)], abs=1e-12)
    assert path.at(1.234) == pytest.approx([math.cos(1.234), -math.sin(1.234)], abs=1e-11)


def test_a_rate_that_depends_on_the_time() -> None:
    path = followed(lambda t, y: np.array([math.exp(t)]), [1.0], 1.5)
    assert path.at(1.5) == pytest.approx([math.exp(1.5)])


def test_a_pendulum_agrees_with_another_method() -> None:
    from scipy.integrate import solve_ivp

    def rate(t, y):
        return np.array([y[1], -9.81 * math.sin(y[0])])

    now = trajectory(rate, np.array([2.5, 0.3]), 2.0)[-1]
    other = solve_ivp(rate, (0, 2.0), [2.5, 0.3], method="Radau", rtol=1e-10, atol=1e-12).y[:, -1]
    assert now == pytest.approx(other, rel=1e-7)


def test_events_are_found_between_the_steps_and_end_the_motion_when_they_are_enough() -> None:
    """sin t vanishes at kπ; it begins at nothing, which is no event."""
    sine, other = Event(lambda t, y: y[0], most=3), Event(lambda t, y: y[0] - 0.5, most=math.inf)
    path = followed(lambda t, y: np.array([y[1], -y[0]]), [0.0, 1.0], 100.0, events=(sine, other))
    assert path.seen[0] == pytest.approx([math.pi, 2 * math.pi, 3 * math.pi], abs=1e-11)
    assert path.seen[1] == pytest.approx([math.pi * k / 6 for k in (1, 5, 13, 17)], abs=1e-11)
    assert path.times[-1] == path.seen[0][-1]


def test_a_stiff_part_takes_short_steps_and_a_singularity_is_told() -> None:
    assert trajectory(lambda t, y: -200 * y, np.array([1.0]), 1.0)[-1] == pytest.approx([math.exp(-200)], abs=1e-12)
    with pytest.raises(NotApplicable, match="did not get beyond"):
        trajectory(lambda t, y: y * y, np.array([1.0]), 1.5)
    with pytest.raises(NotApplicable, match="beyond the time 0"):
        followed(lambda t, y: 1 / y, [0.0], 1.0)
