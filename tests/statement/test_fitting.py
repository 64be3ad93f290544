"""A coordinate whose dimension is not said has the one that fits."""

import tomllib

import pytest

from rbpsym.errors import DimensionError
from rbpsym.quantities import LENGTH, NUMBER
from rbpsym.statement.completing import fitting
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

BLOCK = """
parameters = {m = "mass", g = "acceleration", beta = "acute", v_0 = "velocity"}
coordinates.s = {start = "0", speed = "v_0"}
bodies.block = {shape = "particle", mass = "m", center = ["s*cos(beta)", "s*sin(beta)"]}
interactions.W = {type = "gravity"}
"""


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_what_the_library_says_is_what_fits(name: str) -> None:
    problem, data = load_problem(problem_files()[name]), tomllib.loads(problem_files()[name].read_text("utf-8"))
    said = {one.name: one.quantity.dimension for one in problem.coordinates}
    assert set(said.values()) <= {LENGTH, NUMBER}
    known = {one.name: one.dimension for one in problem.parameters}
    assert fitting(data, known, [*said]) == said


def test_it_may_be_left_out(tmp_path) -> None:
    path = tmp_path / "block.toml"
    path.write_text(BLOCK)
    assert load_problem(path).coordinates[0].quantity.dimension == LENGTH
    path.write_text(BLOCK.replace('"s*sin(beta)"', '"m*s"'))  # fits no way: told as of an angle
    with pytest.raises(DimensionError):
        load_problem(path)
