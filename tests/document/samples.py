"""Hand-made sketches and a document with every kind of block, for the tests of the writers."""

from __future__ import annotations

import math
from fractions import Fraction

from rbpsym.document.model import (
    Callout,
    Display,
    Document,
    Emph,
    FigureBlock,
    ItemList,
    Math,
    Paragraph,
    Ref,
    Section,
    Strong,
    Table,
    Text,
    words,
)
from rbpsym.document.notes_figures import describe, describe_free_body
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import (
    Add,
    Bracket,
    Cross,
    Deriv,
    Div,
    Fn,
    Integral,
    Mul,
    Neg,
    Node,
    Num,
    Pow,
    Relations,
    Sym,
    Vec,
    equation,
    relation,
)
from rbpsym.pictures.figures.schematic import free_body, schematic
from rbpsym.pictures.figures.sketch import (
    AngleMark,
    LengthMark,
    RadiusMark,
    Sketch,
    SketchBody,
    SketchForce,
    SketchLine,
    SketchLink,
    SketchPoint,
)

DOWN = (0.0, -1.0)


def s(name: str) -> Sym:
    return Sym(name)


def times(*factors: Node) -> Mul:
    return Mul(factors)


def squared(name: str) -> Pow:
    return Pow(s(name), Num(2))


def pendulum(theta: float = 0.6) -> Sketch:
    """A rod from a pivot, a disk at its end."""
    end = (math.sin(theta), -math.cos(theta))
    middle = (end[0] / 2, end[1] / 2)
    axis = theta - math.pi / 2
    return Sketch(
        bodies=(
            SketchBody("rod", "rod", {"length": 1.0}, middle, axis, label=s("m")),
            SketchBody("disk", "disk", {"radius": 0.28}, end, axis, label=s("M")),
        ),
        points=(
            SketchPoint("pivot", (0, 0), s("O"), ("rod",)),
            SketchPoint("pin", end, s("A"), ("rod", "disk")),
        ),
        angles=(AngleMark((0, 0), -math.pi / 2, axis, s("theta")),),
        lengths=(LengthMark((0, 0), end, s("ell")),),
        radii=(RadiusMark(end, 0.28, s("R")),),
        forces=(
            SketchForce("rod", times(s("m"), s("g")), middle, DOWN),
            SketchForce("rod", s("N_x"), (0, 0), (1, 0)),
            SketchForce("rod", s("N_y"), (0, 0), (0, 1)),
            SketchForce("rod", Neg(s("A_x")), end, (-1, 0)),
            SketchForce("rod", Neg(s("A_y")), end, DOWN),
            SketchForce("disk", times(s("M"), s("g")), end, DOWN),
            SketchForce("disk", s("A_x"), end, (1, 0)),
            SketchForce("disk", s("A_y"), end, (0, 1)),
        ),
        gravity_label=s("g"),
    )


def ladder(theta: float = 1.0, *, spring: bool = False) -> Sketch:
    """A rod that leans on a wall, perhaps with a spring from the corner to its foot."""
    foot, top = (2 * math.cos(theta), 0.0), (0.0, 2 * math.sin(theta))
    middle = (foot[0] / 2, top[1] / 2)
    return Sketch(
        bodies=(SketchBody("ladder", "rod", {"length": 2.0}, middle, math.pi - theta, label=s("M")),),
        points=(SketchPoint("fixed", (0, 0), s("O")),),
        lines=(SketchLine(1, 0, 0), SketchLine(0, 1, 0)),
        links=(SketchLink("spring", (0, 0.0), foot, s("k")),) if spring else (),
        angles=(AngleMark(foot, math.pi, math.pi - theta, s("theta")),),
        lengths=(LengthMark(foot, top, times(Num(2), s("ell"))),),
        forces=(
            SketchForce("ladder", times(s("M"), s("g")), middle, DOWN),
            SketchForce("ladder", s("N_w"), top, (1, 0)),
            SketchForce("ladder", s("N_f"), foot, (0, 1)),
            *((SketchForce("ladder", s("F_s"), foot, (-1, 0)),) if spring else ()),
        ),
        gravity_label=s("g"),
    )


SKETCHES = {
    "pendulum": pendulum(),
    "pendulum-left": pendulum(-0.4),
    "pendulum-high": pendulum(2.3),
    "ladder": ladder(),
    "ladder-steep": ladder(1.35),
    "ladder-flat": ladder(0.3),
    "ladder-with-spring": ladder(spring=True),
}

MOMENT = Add(
    (
        Div(times(s("m"), squared("ell")), Num(3)),
        times(s("M"), squared("ell")),
        Div(times(s("M"), squared("R")), Num(2)),
    )
)
SIN, COS, COS0 = Fn("sin", s("theta")), Fn("cos", s("theta")), Fn("cos", s("theta_0"))
MASSES = Add((Div(s("m"), Num(2)), s("M")))
ACCELERATION = equation(s("theta_ddot"), Neg(Div(times(s("g"), s("ell"), MASSES, SIN), MOMENT)))
ANGULAR_MOMENTUM = equation(
    Vec("L"),
    Add((Cross(Vec("R_cm"), Vec("P")), times(s("I_cm"), Vec("omega")))),
)
LONG_CHAIN = equation(
    s("W_N"),
    Integral(times(s("N_w"), SIN), "theta", s("theta_0"), s("theta")),
    times(
        Num(Fraction(3, 4)),
        s("M"),
        s("g"),
        s("ell"),
        Bracket(
            times(Add((times(Num(2), Fn("sin", s("theta_0"))), Neg(SIN))), Pow(SIN, Num(2))),
            "theta",
            s("theta_0"),
            s("theta"),
        ),
    ),
    Neg(times(s("k"), squared("ell"), Pow(Add((COS, Neg(COS0))), Num(2)))),
)
LONG_SUM = equation(
    s("E"),
    Add(tuple(Div(times(Num(n), s("M"), squared("ell"), squared(f"theta_{n}_dot")), Num(2)) for n in range(1, 14))),
)
TORQUE = equation(Vec("tau"), Deriv(Vec("L")), times(s("I_O"), Vec("alpha")))
BALANCE = Relations(
    (
        equation(times(s("M"), s("x_ddot")), s("N_w")),
        equation(times(s("M"), s("y_ddot")), Add((s("N_f"), Neg(times(s("M"), s("g")))))),
    )
)
COMPARISON = relation(s("vartheta_1"), "<", s("vartheta_2"))

NASTY = 'a & b < c > d, 50 % of #1 with _x_ and $5 {ok} ~ ^ \\ "q" * @me `tt` [b] = // 1. | $$'


def sample(notation: Notation | None = None, language: str = "en") -> Document:
    """A document with every kind of block and inline."""
    pair = SKETCHES["pendulum"]
    statement = Section(
        words("The problem"),
        (
            Paragraph(
                (
                    Text("A rod of mass "),
                    Math(s("m")),
                    Text(" and length "),
                    Math(s("ell")),
                    Text(" swings about "),
                    Math(s("O")),
                    Text("; see Figure "),
                    Ref("fig:system"),
                    Text(". Its disk "),
                    Emph(words("turns with it")),
                    Text(", so that "),
                    Math(ANGULAR_MOMENTUM),
                    Text(" and "),
                    Strong(words("nothing else")),
                    Text(" counts."),
                )
            ),
            FigureBlock((schematic(pair),), words("The system."), describe(pair), "fig:system"),
            Table(
                (words("Symbol"), words("Meaning"), words("Dimension")),
                (
                    ((Math(s("m")),), words("mass of the rod"), words("mass")),
                    ((Math(s("theta_0")),), words("angle at which it is released, " * 3), words("angle")),
                ),
                words("Symbols and their meaning."),
                "cll",
                "tab:symbols",
            ),
        ),
        "sec:problem",
    )
    motion = Section(
        words("Equation of motion"),
        (
            Paragraph(
                (
                    Text("From "),
                    Ref("eq:momentum"),
                    Text(" we take the time derivative."),
                )
            ),
            Display(ANGULAR_MOMENTUM, "eq:momentum"),
            Display(TORQUE, reason=words("the pivot is at rest")),
            Display(
                LONG_CHAIN,
                "eq:work",
                reason=(
                    Text("we integrate over "),
                    Math(s("theta")),
                    Text(" and use that the rod is released from rest, so that nothing is left at the start"),
                ),
            ),
            Display(LONG_SUM, "eq:sum"),
            Display(BALANCE, "eq:balance"),
            Display(COMPARISON, numbered=False),
            Display(ANGULAR_MOMENTUM, numbered=False, repeats=Ref("eq:momentum")),
            Callout(
                "result",
                (),
                (
                    Paragraph((Text("The angular acceleration is "),)),
                    Display(ACCELERATION, "eq:result", boxed=True),
                ),
            ),
            Callout(
                "why",
                words("Why about the pivot?"),
                (
                    Paragraph(
                        (Text("The force "), Math(s("N_x")), Text(" has no torque about "), Math(s("O")), Text("."))
                    ),
                ),
            ),
            ItemList(
                (
                    (Text("the torque of the weights, "), Math(Neg(times(MASSES, s("g"), s("ell"), SIN)))),
                    words("the spin of the disk"),
                )
            ),
        ),
        "sec:motion",
    )
    forces = Section(
        words("Free-body diagrams"),
        (
            FigureBlock(
                (free_body(pair, "rod"), free_body(pair, "disk")),
                words("Forces on each body."),
                describe_free_body(pair, "rod"),
                "fig:free",
            ),
            Paragraph(words(NASTY)),
            ItemList((words("first"), words("second")), ordered=True),
            Callout("check", (), (Paragraph(words("All steps are proved.")),)),
        ),
        level=2,
    )
    figures = Section(
        words("More systems"),
        tuple(
            FigureBlock((schematic(sketch),), words(f"{name}."), describe(sketch))
            for name, sketch in SKETCHES.items()
            if name != "pendulum"
        )
        + tuple(
            FigureBlock((free_body(SKETCHES[name], "ladder"),), words("Forces."), "forces")
            for name in ("ladder", "ladder-with-spring")
        ),
    )
    return Document(
        words("A pendulum and a ladder"),
        (statement, motion, forces, figures),
        words("Sample of all blocks"),
        words("arXiv:2011.03355, section IV"),
        language,
        notation or Notation(aliases={"alpha": "alpha"}),
    )
