"""Each shape's data give the mass, centre and moment of inertia that textbooks print."""

from __future__ import annotations

from math import pi, sin

import pytest
from pytest import approx

from rbpsym.quantities import DIMENSIONS, LENGTH, NUMBER
from rbpsym.statement import SHAPES, build, load_text
from rbpsym.statement.model import Body
from tests.statement.numeric import moments, value

M, A, B, C = 3.0, 1.5, 2.5, 0.5
PSI = 1.2
VALUES = {"psi": PSI, "M": M, "a": A, "b": B, "c": C, "sigma": 2.0, "J": 7.0}

# kind: sizes, centre of mass in the body frame, moment of inertia about it
TEXTBOOK = {
    "particle": ({}, (0, 0), 0),
    "rod": ({"length": "a"}, (0, 0), M * A**2 / 12),
    "ring": ({"radius": "a"}, (0, 0), M * A**2),
    "disk": ({"radius": "a"}, (0, 0), M * A**2 / 2),
    "annulus": ({"inner": "a", "outer": "b"}, (0, 0), M * (A**2 + B**2) / 2),
    "ball": ({"radius": "a"}, (0, 0), 2 * M * A**2 / 5),
    "shell": ({"radius": "a"}, (0, 0), 2 * M * A**2 / 3),
    "rectangle": ({"width": "a", "height": "b"}, (0, 0), M * (A**2 + B**2) / 12),
    "triangle": (
        {"base": "a", "height": "b", "offset": "c"},
        (C / 3, B / 3),
        M * (A**2 / 24 + B**2 / 18 + C**2 / 18),
    ),
    "half-disk": ({"radius": "a"}, (0, 4 * A / (3 * pi)), M * A**2 * (1 / 2 - (4 / (3 * pi)) ** 2)),
    "half-ring": ({"radius": "a"}, (0, 2 * A / pi), M * A**2 * (1 - (2 / pi) ** 2)),
    "sector": ({"radius": "a", "opening": "psi"}, (4 * A * sin(PSI / 2) / (3 * PSI), 0),
               M * A**2 * (1 / 2 - (4 * sin(PSI / 2) / (3 * PSI)) ** 2)),
    "arc": ({"radius": "a", "opening": "psi"}, (2 * A * sin(PSI / 2) / PSI, 0), M * A**2 * (1 - (2 * sin(PSI / 2) / PSI) ** 2)),
    "hemisphere": ({"radius": "a"}, (0, 3 * A / 8), 83 * M * A**2 / 320),
    "hemispherical-shell": ({"radius": "a"}, (0, A / 2), 5 * M * A**2 / 12),
    "ellipse": ({"half_width": "a", "half_height": "b"}, (0, 0), M * (A**2 + B**2) / 4),
    "polygon": ({"vertices": [["0", "0"], ["a", "0"], ["0", "b"]]}, (A / 3, B / 3), M * (A**2 + B**2) / 18),
    "composite": ({"parts": [build.disk("b"), build.disk("a", at=["c", "0"], removed=True)]}, None, None),
    "given": ({"moment": "J"}, (0, 0), 7.0),
}  # fmt: skip


def body(shape: str, mass: str | None = "M", **keys: object) -> Body:
    """A body of a shape that moves along x."""
    if mass is not None:
        keys["mass"] = mass
    if "density" in keys:
        keys.pop("mass", None)
    problem = build.problem(
        "test",
        parameters={
            "M": "mass",
            "a": "length",
            "b": "length > a",
            "c": "length",
            "J": "moment of inertia",
            "psi": "angle",
            "sigma": "surface density",
            "lam": "linear density",
        },
        coordinates={"x": {"dimension": "length"}},
        bodies={"it": {"shape": shape, "cm": ["x", "0"], **keys}},
    )
    return problem.body("it")


@pytest.mark.parametrize("kind", SHAPES)
def test_textbook(kind: str) -> None:
    sizes, centre, moment = TEXTBOOK[kind]
    shape = body(kind, **sizes).shape
    assert shape.kind == kind
    if kind == "given":
        assert value(shape.given_moment, VALUES) == moment
    elif kind != "composite":
        mass, x, y, second = moments(shape.elements, VALUES)
        assert (mass, x, y, second) == (approx(M), *(approx(c, abs=1e-9) for c in centre), approx(moment, abs=1e-9))


@pytest.mark.parametrize("kind", SHAPES)
def test_points_lie_in_the_frame(kind: str) -> None:
    shape = body(kind, **TEXTBOOK[kind][0]).shape
    assert [name for name, _ in shape.points.items()] == list(SHAPES[kind].point_names)
    assert any((value(x, VALUES), value(y, VALUES)) == (0, 0) for x, y in shape.points.values())
    assert "cm" not in shape.points


@pytest.mark.parametrize("name", [name for name in SHAPES if name != "composite"])
def test_every_size_is_a_field_with_a_dimension(name: str) -> None:
    assert all(field.dimension in (LENGTH, NUMBER, DIMENSIONS["moment of inertia"]) for field in SHAPES[name].fields)


def test_disk_with_a_round_hole() -> None:
    shape = body("composite", **TEXTBOOK["composite"][0]).shape
    mass, x, _, second = moments(shape.elements, VALUES)
    area = B**2 - A**2
    hole, whole = M * A**2 / area, M * B**2 / area
    assert mass == approx(M)
    assert x == approx(-hole * C / M)
    assert second == approx(whole * B**2 / 2 - hole * (A**2 / 2 + C**2) - hole**2 * C**2 / M)


def test_parts_with_masses_of_their_own() -> None:
    stick = build.part(build.rod("a", mass="M"), at=["a/2", "0"], angle="pi/2")
    found = body("composite", mass=None, parts=[stick, build.ring("b", mass="2*M")])
    assert value(found.mass, VALUES) == 3 * M
    mass, x, y, _ = moments(found.shape.elements, VALUES)
    assert (mass, x, y) == (approx(3 * M), approx(A / 6), approx(0, abs=1e-12))


def test_composite_of_composites() -> None:
    inner = build.composite(parts=[build.rod("a", mass="M"), build.particle(mass="M", at=["a/2", "0"])])
    shape = body("composite", mass=None, parts=[{**inner, "at": ["b", "0"], "angle": "pi"}]).shape
    mass, x, _, _ = moments(shape.elements, VALUES)
    assert (mass, x) == (approx(2 * M), approx(B - A / 4))


def test_density_of_a_rod() -> None:
    found = body("rod", length="a", density="lam*s/a")
    assert found.mass is None
    mass, x, _, _ = moments(found.shape.elements, {**VALUES, "lam": 4.0})
    assert (mass, x) == (approx(4 * A / 2), approx(A / 6))


@pytest.mark.parametrize("density", ["sigma*r/a", "sigma*sqrt(x**2 + y**2)/a"])
def test_density_of_a_disk(density: str) -> None:
    found = body("disk", radius="a", density=density)
    mass, _, _, second = moments(found.shape.elements, VALUES)
    assert mass == approx(2 * 2 * pi * A**2 / 3, rel=1e-3)
    assert second == approx(2 * 2 * pi * A**4 / 5, rel=1e-3)


def test_variables_of_integration_give_way_to_the_problems_own() -> None:
    (element,) = body("rectangle", width="a", height="b").shape.elements
    assert [row.variable for row in element.ranges] == ["xi", "y"]


def test_own_points() -> None:
    found = body("rod", length="2*a", points={"knot": ["a/4", "0"]}).points
    assert value(found["knot"][0], VALUES) == A / 4
    assert {"start", "center", "end", "knot"} == set(found)


def test_density_in_a_file() -> None:
    text = """
    [parameters]
    lam = "linear density"
    a = "length"
    [coordinates.theta]
    [bodies.rod]
    shape = "rod"
    length = "a"
    density = "lam*(1 + s/a)"
    start = "O"
    angle = "theta"
    """
    assert load_text(text).body("rod").mass is None
