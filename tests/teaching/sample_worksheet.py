"""A worksheet with one item of every kind, made by hand: what exports and marks are tested on."""

# ruff: noqa: E501  (a table)

from __future__ import annotations

from fractions import Fraction
from functools import cache

from rbpsym.document.model import Display, FigureBlock, Math, Paragraph, Text, words
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import notation_for
from rbpsym.expr.infix import read_infix, read_relation
from rbpsym.pictures.figures.scene import Label, Polyline, Scene
from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.model import (
    Anticipated,
    AskedQuantity,
    Blank,
    BlanksKey,
    ChoiceKey,
    ComparisonKey,
    Criterion,
    ExplanationKey,
    FollowOn,
    FormulaKey,
    Item,
    LinePiece,
    Measure,
    NumberKey,
    Option,
    OrderKey,
    Part,
    SignRow,
    SignsKey,
    Slip,
    SlipKey,
    Student,
    Worksheet,
    blank,
)  # fmt: skip

NAMES = "m M ell R g theta theta_0 theta_dot theta_ddot".split()
POWERED = "-(m/2 + M)*g*ell*sin(theta)/(m*ell**2/3 + M*ell**2 + M*R**2/2)"
SPINLESS = "-(m/2 + M)*g*ell*sin(theta)/(m*ell**2/3 + M*ell**2)"
SCENE = Scene((Polyline(((0, 0), (2, -1.5)), heads="end"),), (Label(t.Sym("ell"), (1, -0.75)),))
SLIP = Slip("sample-slip", {}, "moment", t.Sym("ell"))


def tree(text: str) -> t.Node:
    return read_infix(text, NAMES)


def relation(text: str) -> t.Chain:
    return read_relation(text, NAMES)


def asked(name: str, dimension: str = "angular acceleration") -> AskedQuantity:
    return AskedQuantity("swing", name, t.Sym(name), DIMENSIONS[dimension])


@cache
def problem():
    return load_problem(find_problem("rod-and-disk-fixed"))


def prompt(text: str, *nodes: t.Node) -> tuple:
    return (Paragraph((Text(text),)), *(Display(node, numbered=False) for node in nodes))


def items(scale: int = 1) -> tuple[Item, ...]:
    left = t.Sym("theta_ddot")
    given = {"m": Measure(Fraction(scale), "kg"), "M": Measure(Fraction(2), "kg"), "ell": Measure(Fraction(1), "m"),
             "R": Measure(Fraction(25), "cm"), "g": Measure(Fraction("9.81"), "m/s^2"), "theta": Measure(Fraction(30), "deg")}  # fmt: skip
    exact = -(scale / 2 + 2) * 9.81 * 0.5 / (scale / 3 + 2 + 2 * 0.0625 / 2)
    shown = Measure(Fraction(f"{exact:.2f}"), "rad/s^2", 3)
    wrong = Measure(Fraction(f"{-(scale / 2 + 2) * 9.81 * 0.5 / (scale / 3 + 2):.2f}"), "rad/s^2", 3)
    wrong = Measure(Fraction("-4.02"), "rad/s^2", 3) if wrong == shown else wrong
    half = "M*g*ell*(1 - cos(theta))"
    formula = FormulaKey(tree(POWERED), left, tuple(NAMES), (Anticipated(SLIP, tree(SPINLESS), wrong),))
    follow = FollowOn("1", "alpha_own", t.Mul((t.Sym("R"), t.Sym("alpha_own"))))
    return (
        Item("1", "formula", prompt("Find the angular acceleration."), formula, asked("theta_ddot"), Fraction(4)),
        Item("2", "number", prompt("Its value at 30° & <rest>?"), NumberKey(
            shown, exact, tree(POWERED), left, given, units=("rad/s^2",), anticipated=(Anticipated(SLIP, None, wrong),),
        ), asked("theta_ddot"), Fraction(5)),
        Item("3", "number", prompt("The acceleration of the rim along the tangent?"), NumberKey(
            Measure(Fraction(f"{exact / 4:.2f}"), "m/s^2", 3), exact / 4, t.Mul((t.Sym("R"), tree(POWERED))), t.Sym("a"), given,
            units=("m/s^2",), follows=(follow,),
        ), AskedQuantity("swing", "a", t.Sym("a"), DIMENSIONS["acceleration"]), Fraction(2)),
        Item("4", "choose", prompt("Which is the angular acceleration?"), ChoiceKey((
            Option((Math(tree(SPINLESS)),), SLIP, tree(SPINLESS)), Option((Math(tree(POWERED)),), None, tree(POWERED)),
            Option((Math(tree("-g*sin(theta)/ell")),), SLIP, tree("-g*sin(theta)/ell")),
        ), 1), asked("theta_ddot"), Fraction(2)),
        Item("5", "order", prompt("Put the steps in order."), OrderKey((
            LinePiece("c", relation("theta_ddot = " + POWERED)), LinePiece("a", relation("m = m"), words("mass")),
            LinePiece("b", relation("M = M"), words("mass of the disk")),
        ), frozenset({(1, 0), (2, 0)}), (1, 2, 0)), asked("theta_ddot"), Fraction(2)),
        Item("6", "find-the-slip", prompt("Which line is wrong?"), SlipKey((
            LinePiece("a", relation("m = m")), LinePiece("b", relation("theta_ddot = " + SPINLESS)), LinePiece("c", relation("theta_ddot = " + SPINLESS)),
        ), 1, relation("theta_ddot = " + POWERED), SLIP), asked("theta_ddot"), Fraction(2)),
        Item("7", "signs", prompt("The signs of the works."), SignsKey((
            SignRow(t.Sym("N_x"), "rod", words("bearing on the rod"), "+", "-", "N"),
            SignRow(t.Sym("N_x"), "disk", words("bearing on the disk"), "-", "0", "N"),
            SignRow(t.Sym("W"), "rod", words("weight"), "+", "0"),
        )), asked("theta_ddot"), Fraction(3)),
        Item("8", "fill-in", prompt("Complete.", t.equation(t.Sym("theta_dot"), t.add(blank(1), blank(2)))), BlanksKey((
            Blank(1, tree(half), Fraction(1), "", (Anticipated(SLIP, tree("M*g*ell*cos(theta)")),)), Blank(2, tree("M*g*ell")),
        ), tuple(NAMES)), asked("theta_dot"), Fraction(2)),
        Item("9", "compare", prompt("Which is faster?"), ComparisonKey(
            (Option(words("the first")), Option(words("the second"), SLIP), Option(words("neither"))), 0,
        ), asked("theta_dot"), Fraction(2), (Criterion(Fraction(1), words("names the spin")),)),
        Item("10", "explain", prompt("Why does a free disk not spin up?"), ExplanationKey((Paragraph(words("No torque about its centre.")),)),
             asked("theta_dot"), Fraction(3), (Criterion(Fraction(3), words("torque about the centre of mass is zero")),), space=Fraction(5)),
    )  # fmt: skip


def worksheet(student: str = "ana", scale: int = 1, language: str = "en") -> Worksheet:
    stated = problem()
    figure = FigureBlock((SCENE,), words("The pendulum."), "A rod with a disk at its end.")
    statement = (
        Paragraph((Text("A rod with a disk turns about its end; "), Math(t.Sym("theta")), Text(" is its angle."))),
        figure,
    )
    notation = notation_for(NAMES, stated.notation)
    part = Part(
        "swing",
        words("Pendulum & <disk>"),
        statement,
        {},
        items(scale),
        prompt("Take torques.", relation("theta_ddot = " + POWERED)),
    )
    return Worksheet("sample", words("Sample {worksheet} #1"), language, f"sample.{language}.{student.upper()}-0000", (part,),
                     {"swing": stated}, notation, Student(student, student.title()))  # fmt: skip
