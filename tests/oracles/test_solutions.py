"""Motions as functions of the time, against the simulation in maximal coordinates, which uses none of the solution."""

from __future__ import annotations

from contextlib import suppress
from itertools import islice

import numpy as np
import pytest

from rbpsym.errors import NoNumber
from rbpsym.mechanics import solutions
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.numeric.integration import followed
from rbpsym.oracles.simulation_phases import _bench
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from tests.ask.lines import on_line
from tests.oracles.sets import drawn

SETS, PERIODS = 20, np.linspace(0.2, 2.0, 5)
AHEAD = 'v_0 = "speed: v_0"'
FORCES = ("-k*x", "-k*x - b*x_dot", "k*x - b*x_dot", "-b*x_dot", "m*g - b*x_dot", "-c*x_dot**2", "m*g - c*x_dot**2",
          "-m*g - c*x_dot**2", "F*cos(Omega*t) - k*x - b*x_dot", "-mu*m*g")  # fmt: skip
LIBRARY = {"torsion-pendulum": ("theta", 2), "plank-on-two-rollers": ("x", 0)}


def _compare(study: Study, name: str, column: int) -> None:
    known, seen = solutions.given(study, name), 0
    cases = [one for one in solutions.courses(known) if one.where is None]
    for numbers in islice(drawn(study, 7), SETS):
        [one] = [one for one in cases if all(number(asked.value, {**numbers, "t": 0.0}) > 0 for asked in one.valid)]
        bench = _bench(study, numbers)
        bench.placement.mechanism.clock = 0.0
        start = bench.declared_start()
        times = PERIODS * bench.usual_time(start)
        path = followed(bench.rate(), np.concatenate([start.where, start.speed, [0.0]]), times[-1])
        for time, simulated in zip(times, path.at(times)[column], strict=True):
            with suppress(NoNumber):  # a resistance that is stated for one sense of the motion drives it, in the other
                assert number(one.whole, {**numbers, "t": time}) == pytest.approx(simulated, rel=1e-5, abs=1e-7)
                seen += 1
    assert seen >= 2 * SETS


@pytest.mark.parametrize("force", FORCES)
def test_solutions_are_what_is_simulated(force: str) -> None:
    _compare(Study(on_line(force, more=AHEAD)), "x", 0)


@pytest.mark.parametrize("name", LIBRARY)
def test_solutions_of_the_library_are_what_is_simulated(name: str) -> None:
    _compare(Study(load_problem(find_problem(name))), *LIBRARY[name])
