"""Which way a string runs and on which side a thing touches is taken from sample numbers: where others would tell
otherwise, a condition of the start says so."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.numbers import number, samples
from rbpsym.mechanics.pushing import begins, ways_taken
from rbpsym.mechanics.strings import StringCrosses, segments
from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text
from rbpsym.statement.paths import runs
from tests.library.derived import NAMES, problem

WAYS = [name for name in NAMES if any(e.kind in ("string", "link") for e in problem(name).constraints)]


def draws(study, count=24):
    """Sample numbers of other sizes, the starts that are not declared of either sign."""
    source = random.Random(5)
    for numbers in samples(study.problem, count):
        turned = {name: numbers[name] * source.choice((1, -1)) for name in study.problem.implicit}
        found = numbers | turned
        yield found | {c.name: number(scalar(c.start), found) for c in study.problem.coordinates if c.start is not None}


def directions(study, geometry):
    paths = [e["path"] for e in study.problem.constraints if e.kind in ("string", "link")]
    return [piece.along for path in paths for run in runs(path) for piece in segments(run, geometry)]


@pytest.mark.parametrize("name", WAYS)
def test_where_the_start_is_as_it_asks_strings_run_as_the_formulas_say(name):
    study = Study(problem(name))
    geometry, asked = geometry_of(study.system), [value for _, value in ways_taken(study)]
    taken, seen = directions(study, geometry), 0
    for numbers in draws(study):
        if all(number(value, numbers) > 0 for value in asked):
            try:
                found = directions(study, replace(geometry, numbers=numbers))
            except StringCrosses:
                found = []
            assert len(found) == len(taken), numbers
            assert all(is_zero(a.dot(b.turned())) and number(a.dot(b), numbers) > 0 for a, b in zip(found, taken, strict=True))
            seen += 1
    assert seen


def test_a_start_of_any_sign_leaves_a_condition():
    text = """
[parameters]
m = "mass"
n = "mass"
M = "mass"
R = "length"
g = "acceleration"
x_0 = { dimension = "length", sign = "real" }
[coordinates.x]
dimension = "length"
start = "x_0"
[coordinates.phi]
meaning = "angle"
start = "0"
[bodies.drum]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "-phi"
[bodies.w]
shape = "particle"
mass = "m"
center = ["R", "-x"]
[interactions.W]
type = "gravity"
[constraints.A]
type = "pivot"
point = "drum.center"
[constraints.T]
type = "string"
path = ["cw drum", "w.center"]
"""
    open_, said = Study(load_text(text)), Study(load_text(text.replace('sign = "real"', 'sign = "positive"')))
    [(element, value)] = ways_taken(open_)
    assert element.name == "T" and is_zero(value - scalar(open_.problem.coordinate("x").start))
    assert [demand.op for demand in begins(open_)] == [">"] and begins(said) == ()
