"""Statements of constraints that can't be meant: each gets a sentence with its cure."""

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.mechanics.study import Study
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import stated

X = {"x": rb.coordinate(dimension="length", start="0")}
DISK = rb.disk("R", mass="M", center=("x", "R"))
BOB = rb.particle(mass="M", center=("x", "0"))
TURNED = {**DISK, "angle": "0"}


def row(says, cure, constraint, bodies=None, coordinates=X, **sections):
    return pytest.param(says, cure, {"N": constraint}, bodies or {"disk": DISK}, coordinates, sections, id=says)


ROWS = [
    row("touches nothing", "line =", rb.rolling("disk")),
    row("has both a circle and a line", "write line", rb.rolling("disk", "y = 0", circle="O", radius="R")),
    row("does not say how large the circle", 'radius = "R"', rb.rolling("disk", circle="O")),
    row("has a radius, but touches a line", "“rim”", rb.rolling("disk", "y = 0", radius="R")),
    row("has the side “inside”, which a line hasn't", "positive", rb.rolling("disk", "y = 0", side="inside")),
    row(
        "has the side “positive”, which a circle hasn't",
        "outside",
        rb.rolling("disk", circle="O", radius="R", side="positive"),
    ),
    row(
        "needs a round body, but “bob” (particle) has no radius",
        "disk, ring, ball",
        rb.rolling("bob", "y = 0"),
        {"bob": BOB},
    ),
    row("can't turn “bob”, a particle", "disk, ring or ball", rb.rolling("bob", "y = 0", rim="R"), {"bob": BOB}),
    row(
        "needs a round body, but “rod” (rod) has no radius",
        "rim =",
        rb.rolling("rod", "y = 0"),
        {"rod": rb.rod("R", mass="M", center=("x", "0"), angle="0")},
    ),
    row("lets “disk” touch itself", "another", rb.rolling("disk", "y = 0", of="disk")),
    row("has no room", "outside", rb.rolling("disk", circle="O", radius="R", side="inside")),
    row(
        "does not touch the curve",
        "change the place",
        rb.rolling("disk", "y = 0"),
        {"disk": {**DISK, "center": ("x", "2*R")}},
    ),
    row("joins a fixed point to a fixed curve", "name the point of one body", rb.contact("O", "y = 0")),
    row(
        "says which way it slips, but has no friction",
        "coefficient",
        rb.contact("bob.center", "y = 0", slip="forward"),
        {"bob": BOB},
    ),
    row(
        "has kinetic friction, but at the start nothing slips",
        "slip =",
        rb.contact("bob.center", "y = 0", coefficient="mu"),
        {"bob": BOB},
    ),
    row("must lead a point of a body that has an angle", "contact", rb.slider("bob.center", "y = 0"), {"bob": BOB}),
    row("nothing says how the body “disk” is turned", "let it roll", rb.touch("disk", "y = 0")),
    row("nothing says where the body “rod” is", "the place of one of its points", rb.touch("disk", "y = 0"), {
        "disk": TURNED, "rod": rb.rod("R", mass="M", angle="x/R"),
    }),
    row("in which sense does the string run round “disk”", "cw disk", rb.string(["O", "disk"])),
    row("there is no round body “wheel”", "disk", rb.string(["O", "cw wheel"])),
    row("“bob” is no round body", "give the radius", rb.string(["O", "cw bob"]), {"bob": BOB}),
    row("joins only fixed places", "a body", rb.string(["O", ["0", "R"]]), {"disk": TURNED}),
    row("runs from “disk.center” to itself", "next body", rb.string(["disk.center", "cw disk"])),
    row("a list of two places or more, not only 1", "path =", rb.string(["disk.center"])),
    row("has a length, but is no straight piece", "remove the length", rb.string(["O", "cw disk"], "R")),
    row(
        "are not at the distance of the string's length",
        "change the place",
        rb.string(["O", "bob.center"], "2*R"),
        {"bob": rb.particle(mass="M", center=("R*cos(x/R)", "R*sin(x/R)"))},
    ),
    row(
        "the pose of the body “bob” says more than its constraints hold",
        "the constraint that does it",
        rb.prescribed("bob.center", "g*t**2"),
        {"bob": rb.particle(mass="M", center=("R*cos(x/R)", "R*sin(x/R)"))},
    ),
    row("acts on “O”, a fixed place", "point of a body", rb.prescribed("O", "R"), {"disk": TURNED}),
    row("acts on “bob”, a particle", "can turn", rb.prescribed_angle("bob", "sqrt(g/R)*t"), {"bob": BOB}),
    row("must not depend on “x”", "parameters and the time t", rb.prescribed("disk.center", "x + R"), {"disk": TURNED}),
    row("must not depend on “x_dot”", "made of", rb.string(["O", "disk.center"], "R*x_dot"), {"disk": TURNED}),
    row(
        "the phase “late” begins with an unknown event “later”",
        "at once",
        rb.rolling("disk", "y = 0"),
        phases=[{"name": "late", "event": "later"}],
    ),
    row("there is no constraint or interaction “P”", "N", rb.rolling("disk", "y = 0"), phases=[{"without": ["P"]}]),
    row(
        "the phase “late” has no “of”",
        "stops slipping",
        rb.rolling("disk", "y = 0"),
        phases=[{"name": "late", "event": "no slip"}],
    ),
    row(
        "blow “B” strikes a fixed place",
        "name a point",
        rb.rolling("disk", "y = 0"),
        phases=[{"impulses": {"B": {"type": "blow", "on": "O", "impulse": ["J", "0"]}}}],
    ),
    row(
        "is between points of one body",
        "two bodies",
        rb.rolling("disk", "y = 0"),
        phases=[{"impulses": {"B": {"type": "collision", "points": ["disk.center", "disk.cm"], "along": ["1", "0"]}}}],
    ),
]


@pytest.mark.parametrize(("says", "cure", "constraints", "bodies", "coordinates", "sections"), ROWS)
def test_sentence(says, cure, constraints, bodies, coordinates, sections):
    with pytest.raises(RbpsymError) as found:
        Study(
            stated(
                "M: mass, R: length, g: acceleration, mu: number, J: impulse",
                constraints=constraints,
                bodies=bodies,
                coordinates=coordinates,
                **sections,
            )
        ).dynamics
    assert says in found.value.what
    assert cure in found.value.instead
    assert found.value.place is not None


def test_start_speeds_that_contradict_rolling():
    coordinates = {
        "x": rb.coordinate(dimension="length", start="0", speed="v_0"),
        "phi": rb.coordinate(start="0", speed="omega_0"),
    }
    with pytest.raises(RbpsymError, match=r"start speed of .* contradicts"):
        Study(
            stated(
                "M: mass, R: length, g: acceleration",
                coordinates=coordinates,
                bodies={"disk": {**DISK, "angle": "-phi"}},
                constraints={"N": rb.rolling("disk", "y = 0")},
            )
        ).dynamics
