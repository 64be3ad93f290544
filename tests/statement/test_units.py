"""Units of the numbers in a problem file."""

from __future__ import annotations

import math

import pytest

from rbpsym.errors import StatementError
from rbpsym.mechanics.numbers import sample
from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.units import unit_named


@pytest.mark.parametrize(
    ("text", "dimension", "size"),
    [
        ("cm", "length", 0.01),
        ("km/h", "speed", 1 / 3.6),
        ("m/s^2", "acceleration", 1.0),
        ("m s⁻²", "acceleration", 1.0),
        ("g cm^2", "moment of inertia", 1e-7),
        ("N m/rad", "torsion stiffness", 1.0),
        ("kg·m²", "moment of inertia", 1.0),
        ("N*s/m", "damping", 1.0),
        ("1/s", "angular speed", 1.0),
        ("deg", "number", math.pi / 180),
        ("rpm", "angular speed", math.pi / 30),
    ],
)
def test_a_unit_is_read(text: str, dimension: str, size: float) -> None:
    found = unit_named(text)
    assert found is not None
    assert found[0] == DIMENSIONS[dimension]
    assert found[1] == pytest.approx(size)


@pytest.mark.parametrize("text", ["furlong", "kgs", "m/foo", "cmm", "1 2", "kdeg"])
def test_what_is_no_unit_is_refused(text: str) -> None:
    assert unit_named(text) is None


def example(tmp_path, line: str):
    text = problem_files()["sliding-ladder"].read_text(encoding="utf-8").replace('ell     = "2 m"', line)
    file = tmp_path / "ladder.toml"
    file.write_text(text, encoding="utf-8")
    return load_problem(file)


def test_centimetres_become_metres(tmp_path) -> None:
    problem = example(tmp_path, 'ell = "25 cm"')
    assert sample(problem, problem.example)["ell"] == pytest.approx(0.25)


@pytest.mark.parametrize("unit", ["kg", "furlong", "m/s"])
def test_a_wrong_unit_gets_a_sentence(tmp_path, unit: str) -> None:
    with pytest.raises(StatementError, match="is no length"):
        example(tmp_path, f'ell = "25 {unit}"')
