"""The oracle's integrator against motions that are known exactly, and against scipy's."""

import math

import numpy as np
import pytest

from rbpsym.errors import NotApplicable
from rbpsym.verify.simulation_motion import over


def test_an_oscillation_is_followed_to_rounding() -> None:
    state = over(lambda t, y: np.array([y[1], -y[0]]), 0.0, np.array([1.0, 0.0]), 2.0)
    assert state == pytest.approx([math.cos(2), -math.sin(2)], abs=1e-12)


def test_a_rate_that_depends_on_the_time() -> None:
    assert over(lambda t, y: np.array([math.exp(t)]), 1.0, np.array([math.e]), 1.5) == pytest.approx([math.exp(2.5)])


def test_a_pendulum_agrees_with_scipy() -> None:
    from scipy.integrate import solve_ivp

    def rate(t, y):
        return np.array([y[1], -9.81 * math.sin(y[0])])

    start, now = np.array([2.5, 0.3]), np.array([2.5, 0.3])
    for k in range(20):
        now = over(rate, k * 0.1, now, 0.1)
    other = solve_ivp(rate, (0, 2.0), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    assert now == pytest.approx(other, rel=1e-9)


def test_a_stiff_part_is_halved_and_a_singularity_is_told() -> None:
    assert over(lambda t, y: -200 * y, 0.0, np.array([1.0]), 1.0) == pytest.approx([math.exp(-200)], abs=1e-12)
    with pytest.raises(NotApplicable, match="did not get beyond"):
        over(lambda t, y: y * y, 0.0, np.array([1.0]), 1.5)
