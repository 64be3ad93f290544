"""Worlds of small problems for the tests of phrases."""

from __future__ import annotations

from functools import cache

from rbpsym.mechanics.study import Study
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import stated


@cache
def world(name: str) -> ProblemWorld:
    """A world by the name of its maker here."""
    return ProblemWorld(Study(MAKERS[name]()))


def _bowling():
    """A ball slides, slows down by friction, and rolls in the end."""
    return stated(
        "M: mass, R: length, mu: number, g: acceleration",
        coordinates={
            "x": rb.coordinate(dimension="length", start="0", speed="v_0"),
            "phi": rb.coordinate(start="0", speed="0"),
        },
        bodies={"ball": rb.ball("R", mass="M", center=("x", "R"), angle="-phi")},
        constraints={"N": rb.touch("ball", "y = 0", coefficient="mu")},
        phases=[{"name": "rolling", "event": "no slip", "of": "N", "constraints": {"N": {"type": "rolling"}}}],
    )


def _struck():
    """A rod that hangs from a pivot is struck at a distance b."""
    return stated(
        "M: mass, ell: length, b: length, J: impulse, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", speed="0")},
        bodies={"rod": rb.rod("ell", mass="M", start="O", angle="theta - pi/2", points={"mark": ("b - ell/2", "0")})},
        constraints={"P": rb.pivot("rod.start")},
        phases=[{"name": "struck", "impulses": {"B": {"type": "blow", "on": "rod.mark", "impulse": ["J", "0"]}}}],
    )


def _pendulum():
    """A rod let go from theta_0."""
    return stated(
        "m: mass, ell: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", speed="0", range=("-pi", "pi"))},
        bodies={"rod": rb.rod("ell", mass="m", start="O", angle="theta - pi/2")},
        constraints={"F": rb.pivot("rod.start")},
        notation={"theta_dot": "omega"},
    )


def _braked():
    """The same rod with a dashpot, which has no energy."""
    return stated(
        "m: mass, ell: length, c: damping, h: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", speed="0", range=("-pi", "pi"))},
        bodies={"rod": rb.rod("ell", mass="m", start="O", angle="theta - pi/2")},
        interactions={"D": {"type": "damper", "between": [["h", "0"], "rod.end"], "coefficient": "c"}},
        constraints={"F": rb.pivot("rod.start")},
    )


def _falling():
    """A rod stands on its end and is let go, almost upright."""
    return stated(
        "m: mass, ell: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", speed="0", range=("0", "pi/2"))},
        bodies={"rod": rb.rod("ell", mass="m", start="O", angle="pi/2 - theta")},
        constraints={"F": rb.pivot("rod.start")},
    )


def _incline():
    """A disk rolls down a plane."""
    return stated(
        "M: mass, R: length, beta: angle, mu: number, g: acceleration",
        coordinates={
            "s": rb.coordinate(dimension="length", start="0", speed="0"),
            "phi": rb.coordinate(start="0"),
        },
        bodies={
            "disk": rb.disk(
                "R", mass="M", center=("s*cos(beta) + R*sin(beta)", "R*cos(beta) - s*sin(beta)"), angle="-phi"
            )
        },
        constraints={"N": rb.rolling("disk", line="y = -x*tan(beta)", friction="f", limit="mu")},
    )


def _thrown():
    """A block on a floor is slowed down by b."""
    return stated(
        "M: mass, b: acceleration, h: length, v_0: speed",
        coordinates={"s": rb.coordinate(dimension="length", start="0", speed="v_0")},
        bodies={"block": rb.particle(mass="M", center=("s", "0"))},
        interactions={"B": rb.force(on="block.center", force=("-M*b", "0"))},
        constraints={"N": rb.contact("block.center", "y = 0")},
    )


def _twins():
    """Two equal masses on springs, joined by a third."""
    spring = {"natural_length": "0"}
    return stated(
        "m: mass, k: stiffness, c: stiffness",
        coordinates={"x": rb.coordinate(dimension="length"), "y": rb.coordinate(dimension="length")},
        bodies={"p": rb.particle(mass="m", center=("x", "0")), "q": rb.particle(mass="m", center=("y", "0"))},
        interactions={
            "A": rb.spring(("O", "p.center"), stiffness="k", **spring),
            "B": rb.spring(("O", "q.center"), stiffness="k", **spring),
            "C": rb.spring(("p.center", "q.center"), stiffness="c", **spring),
        },
        constraints={"N": rb.contact("p.center", "y = 0"), "P": rb.contact("q.center", "y = 0")},
    )


MAKERS = {
    "thrown": _thrown,
    "twins": _twins,
    "bowling": _bowling,
    "struck": _struck,
    "pendulum": _pendulum,
    "falling": _falling,
    "braked": _braked,
    "incline": _incline,
}
