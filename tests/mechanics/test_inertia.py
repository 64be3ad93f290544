"""Mass, centre and moment of every body are those of its shape's elements."""

from types import SimpleNamespace as Told

import pytest

from rbpsym.chapters import inertia as chapter
from rbpsym.chapters.places import FreeGeometry
from rbpsym.field.normal import same
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.inertia import inertia, mass_moments
from tests.golden.semantic import examples
from tests.library.derived import NAMES, problem, stated

SHAPES = {name: path for name, path in examples().items() if name.startswith("shapes/")}


def bodies(found):
    return [body for body in found.bodies if body.shape is not None]


@pytest.mark.parametrize("name", [*SHAPES, *NAMES])
def test_moments_of_the_mass_are_those_of_the_inertia(name):
    for body in bodies(stated(SHAPES[name]) if name in SHAPES else problem(name)):
        own = inertia(body)
        found = mass_moments(body.shape, own)
        assert same(found.zeroth, own.mass)
        assert same(found.x, own.mass * own.x) and same(found.y, own.mass * own.y)
        assert same(found.second, own.moment + own.mass * (own.x * own.x + own.y * own.y))


SPREAD = [(("line",), "line"), (("surface",), "surface"), (("point",), "pieces"), (("line",) * 2, "pieces")]


@pytest.mark.parametrize(("kinds", "variant"), SPREAD)
def test_how_a_mass_is_spread(kinds, variant, monkeypatch):
    monkeypatch.setattr(chapter, "_tidied", lambda draft, density: density)
    found = chapter._spread(None, tuple(Told(kind=kind, density=kind) for kind in kinds))
    assert found == ({"variant": variant} if variant == "pieces" else {"variant": variant, "density": variant})


def test_of_what_was_said_nothing_there_is_no_spin():
    states = {name: Told(omega=symbol(f"{name}_dot")) for name in "ab"}
    given = FreeGeometry(Told(states=states), frozenset(), frozenset("a"))
    assert given.spin(None) is None and given.spin("a") is None
    assert given.spin("b") == symbol("b_dot")
