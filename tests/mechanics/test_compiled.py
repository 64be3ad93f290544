"""Compiled accelerations against the equations in maximal coordinates, which share nothing with them."""

import numpy as np
import pytest

from rbpsym.errors import StatementError
from rbpsym.mechanics.compiled import compiled_accelerations
from rbpsym.mechanics.study import Study
from rbpsym.oracles.simulation import Bench, Derived
from rbpsym.statement.loader import load_text


def chain(n: int) -> str:
    """n unlike rods pinned end to end, in absolute angles."""
    lines = ["[parameters]", 'g = "acceleration"']
    lines += [f'm_{k} = "mass"\nl_{k} = "length"' for k in range(1, n + 1)]
    for k in range(1, n + 1):
        lines += [f"[coordinates.q_{k}]", f"[bodies.r_{k}]", 'shape = "rod"', f'mass = "m_{k}"']
        lines += [f'length = "l_{k}"', f'angle = "q_{k} - pi/2"']
    lines += ["[interactions.W]", 'type = "gravity"', "[constraints.P_1]", 'type = "pivot"']
    lines += ['point = "r_1.start"', 'at = "O"']
    for k in range(2, n + 1):
        lines += [f"[constraints.P_{k}]", 'type = "pin"', f'points = ["r_{k - 1}.end", "r_{k}.start"]']
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("n", [3, 6])
def test_chain_of_unlike_rods(n: int) -> None:
    study = Study(load_text(chain(n)))
    numbers = {q.name: 0.7 + 0.1 * k for k, q in enumerate(study.problem.parameters)}
    bench = Bench(Derived(study.system, study.dynamics, None, {}, {}, {}), numbers)
    rates = compiled_accelerations(study, numbers)
    mechanism, equations = bench.placement.mechanism, bench.equations
    generator = np.random.default_rng(7)
    for _ in range(5):
        q, u = generator.uniform(-2, 2, n), generator.uniform(-3, 3, n)
        where, speed = np.zeros(3 * n), np.zeros(3 * n)
        joint, velocity = np.zeros(2), np.zeros(2)
        for k in range(n):
            along, turned = np.array([np.sin(q[k]), -np.cos(q[k])]), np.array([np.cos(q[k]), np.sin(q[k])])
            length = numbers[f"l_{k + 1}"]
            where[3 * k : 3 * k + 3] = [*(joint + along * length / 2), q[k] - np.pi / 2]
            speed[3 * k : 3 * k + 3] = [*(velocity + turned * u[k] * length / 2), u[k]]
            joint, velocity = joint + along * length, velocity + turned * u[k] * length
        assert mechanism.problem.body_names == study.problem.body_names
        np.testing.assert_allclose(rates(0.0, q, u), equations.at(where, speed).gained[2::3], rtol=1e-9)


def test_a_parameter_without_a_number() -> None:
    with pytest.raises(StatementError, match="need a number for l_3"):
        study = Study(load_text(chain(3)))
        compiled_accelerations(study, {q.name: 1.0 for q in study.problem.parameters if q.name != "l_3"})
