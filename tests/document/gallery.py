"""Hand-made sketches of systems beyond the paper's: every sign of a drawing at least once."""

from __future__ import annotations

import math

from rbpsym.expr.tree import Mul, Node, Num, Sym
from rbpsym.pictures.figures.sketch import (
    AngleMark,
    LengthMark,
    RadiusMark,
    Sketch,
    SketchBody,
    SketchCoil,
    SketchCouple,
    SketchForce,
    SketchLine,
    SketchLink,
    SketchPart,
    SketchPoint,
)

DOWN = (0.0, -1.0)


def s(name: str) -> Sym:
    return Sym(name)


def weight(mass: str) -> Node:
    return Mul((s(mass), s("g")))


def double_pendulum(one: float = 0.5, two: float = 1.1) -> Sketch:
    a = (math.sin(one), -math.cos(one))
    b = (a[0] + math.sin(two), a[1] - math.cos(two))
    halves = [(a[0] / 2, a[1] / 2), ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)]
    return Sketch(
        bodies=(
            SketchBody("upper", "rod", {"length": 1.0}, halves[0], one - math.pi / 2, label=s("m_1")),
            SketchBody("lower", "rod", {"length": 1.0}, halves[1], two - math.pi / 2, label=s("m_2")),
        ),
        points=(
            SketchPoint("pivot", (0, 0), s("O"), ("upper",)),
            SketchPoint("pin", a, s("A"), ("upper", "lower")),
        ),
        angles=(
            AngleMark((0, 0), -math.pi / 2, one - math.pi / 2, s("theta_1")),
            AngleMark(a, -math.pi / 2, two - math.pi / 2, s("theta_2")),
        ),
        lengths=(LengthMark((0, 0), a, s("ell_1")), LengthMark(a, b, s("ell_2"))),
        forces=(
            SketchForce("lower", weight("m_2"), halves[1], DOWN),
            SketchForce("lower", s("A_x"), a, (1, 0)),
            SketchForce("lower", s("A_y"), a, (0, 1)),
        ),
        gravity_label=s("g"),
    )


def beam_on_spring() -> Sketch:
    return Sketch(
        bodies=(SketchBody("beam", "rod", {"length": 2.0}, (1.0, 0.0), 0.0, label=s("M")),),
        points=(SketchPoint("pivot", (0, 0), s("O"), ("beam",)), SketchPoint("fixed", (2.0, -0.9))),
        links=(
            SketchLink("spring", (2.0, -0.9), (2.0, 0.0), s("k")),
            SketchLink("damper", (1.4, -0.9), (1.4, 0.0), s("c")),
        ),
        lines=(SketchLine(0, 1, -0.9),),
        lengths=(LengthMark((0, 0), (2, 0), Mul((Num(2), s("ell")))),),
        coils=(SketchCoil((0, 0), s("kappa")),),
        forces=(
            SketchForce("beam", s("F"), (2.0, 0), (0.6, 0.8)),
            SketchForce("beam", weight("M"), (1.0, 0), DOWN),
        ),
        couples=(SketchCouple("beam", s("tau_0"), (0, 0), -1), SketchCouple("beam", s("C"), (1.5, 0), 1)),
        gravity_label=s("g"),
    )


def incline(beta: float = 0.5) -> Sketch:
    """A disk on a slope."""
    normal = (-math.sin(beta), math.cos(beta))
    center = (2 * math.cos(beta) + 0.4 * normal[0], -2 * math.sin(beta) + 0.8 + 0.4 * normal[1])
    down = (math.cos(beta), -math.sin(beta))
    touch = (center[0] - 0.4 * math.sin(beta), center[1] - 0.4 * math.cos(beta))
    normal = (math.sin(beta), math.cos(beta))
    line = SketchLine(normal[0], normal[1], touch[0] * normal[0] + touch[1] * normal[1])
    return Sketch(
        bodies=(SketchBody("disk", "disk", {"radius": 0.4}, center, 0.3, label=s("M")),),
        points=(SketchPoint("point", touch, s("P")),),
        lines=(line,),
        radii=(RadiusMark(center, 0.4, s("R")),),
        angles=(AngleMark((touch[0] - 1.2 * down[0], touch[1] - 1.2 * down[1]), 0.0, -beta, s("beta")),),
        forces=(
            SketchForce("disk", weight("M"), center, DOWN),
            SketchForce("disk", s("N"), touch, normal),
            SketchForce("disk", s("f"), touch, (-down[0], -down[1])),
        ),
        gravity_label=s("g"),
    )


def plate_with_hole() -> Sketch:
    parts = (
        SketchPart("rectangle", {"width": 2.0, "height": 1.2}),
        SketchPart("disk", {"radius": 0.35}, (0.45, 0.1), removed=True),
        SketchPart("half-disk", {"radius": 0.6}, (-1.0, 0.0), math.pi / 2),
    )
    return Sketch(
        bodies=(SketchBody("plate", "composite", {}, (0, 0), -0.4, (-0.2, 0.05), s("M"), parts),),
        points=(SketchPoint("pivot", (-0.6, 0.7), s("O"), ("plate",)),),
        radii=(RadiusMark((0.45, -0.08), 0.35, s("a")),),
        forces=(
            SketchForce("plate", weight("M"), (-0.2, 0.05), DOWN),
            SketchForce("plate", s("N_x"), (-0.6, 0.7), (1, 0)),
            SketchForce("plate", s("N_y"), (-0.6, 0.7), (0, 1)),
        ),
        gravity_label=s("g"),
    )


def shapes() -> Sketch:
    sizes = {
        "length": 0.8,
        "radius": 0.4,
        "inner": 0.2,
        "outer": 0.4,
        "width": 0.8,
        "height": 0.5,
        "base": 0.8,
        "offset": 0.1,
    }
    kinds = (
        "particle",
        "rod",
        "ring",
        "disk",
        "annulus",
        "ball",
        "shell",
        "rectangle",
        "triangle",
        "half-disk",
        "half-ring",
        "given",
    )
    return Sketch(
        tuple(
            SketchBody(kind, kind, sizes, (1.1 * (n % 4), -1.1 * (n // 4)), 0.3, label=s(f"m_{n}"))
            for n, kind in enumerate(kinds)
        )
    )


def welded_flag() -> Sketch:
    return Sketch(
        bodies=(
            SketchBody("flag", "triangle", {"base": 0.9, "height": 0.6, "offset": 0.2}, (1.2, 0.1)),
            SketchBody("mast", "rod", {"length": 1.6}, (0.8, 0.0), label=s("m")),
        ),
        points=(SketchPoint("weld", (0, 0), s("W"), ("mast",)), SketchPoint("pin", (1.2, 0.1))),
        lengths=(LengthMark((0, 0), (1.6, 0), s("ell")),),
        forces=(SketchForce("mast", weight("m"), (0.8, 0), DOWN),),
        couples=(SketchCouple("mast", s("W_z"), (0, 0), 1),),
    )


GALLERY = {
    "double-pendulum": double_pendulum(),
    "beam-on-spring": beam_on_spring(),
    "incline": incline(),
    "plate-with-hole": plate_with_hole(),
    "shapes": shapes(),
    "welded-flag": welded_flag(),
}
