"""Values as a textbook prints them: each form here was printed worse once."""

from fractions import Fraction

import pytest

from rbpsym.decide.assumptions import positive
from rbpsym.decide.equal import scalars_equal
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT
from rbpsym.field.calculus import function, root
from rbpsym.field.evaluate import Meanings, scalar, value
from rbpsym.field.normal import same
from rbpsym.field.roots import tidied
from rbpsym.field.scalar import Scalar, generator_of, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.present.bars import with_joined_angles
from rbpsym.present.forms import present
from rbpsym.present.grouping import perfect_power
from rbpsym.present.style import COEFFICIENT, Style
from rbpsym.quantities import ACCELERATION, ENERGY, LENGTH, MASS, NUMBER
from rbpsym.typeset.latex import to_latex

DIMENSIONS = {
    **dict.fromkeys(("m", "M"), MASS),
    **dict.fromkeys(("R", "ell", "a", "b", "s"), LENGTH),
    "g": ACCELERATION,
    "kappa": ENERGY,
    "mu": NUMBER,
}
RANKS = {MASS: 1, ENERGY: 2, ACCELERATION: 3, LENGTH: 4, NUMBER: COEFFICIENT}
STYLE = Style(
    {name: (RANKS[dimension], place) for place, (name, dimension) in enumerate(DIMENSIONS.items())},
    frozenset({"theta", "phi", "v_dot", "theta_dot", "N"}),
    DIMENSIONS,
    greater=frozenset({("R", "a"), ("ell", "s")}),
)
m, M, R, ell, a, b, s, g, kappa, mu = (symbol(name) for name in "m M R ell a b s g kappa mu".split())
theta, phi, N, speed, beta = (symbol(name) for name in "theta phi N v_dot beta".split())

FORMS = {
    # one fraction line, not one within and one before the brackets
    r"\frac{3 (2 \kappa - M g \ell)}{2 M \ell^2}": (3 * kappa / (M * ell) - 3 * g / 2) / ell,
    r"-\frac{M g s (\ell - s)^2}{4 \ell^2} \sin\theta": (
        M * g * s * (s / (2 * ell) - Fraction(1, 4) - s**2 / (4 * ell**2)) * sine(theta)
    ),
    r"\frac{M (\ell - s)^3}{12 \ell}": M * (ell - s) ** 3 / (12 * ell),
    r"\frac{1}{2} M \left( 1 + \frac{R^2}{2 b^2} \right) \dot{v}^2": M * (speed**2 / 2 + R**2 * speed**2 / (4 * b**2)),
    r"\left( 1 - \frac{R}{a} \right) \theta": (1 - R / a) * theta,
    r"\frac{N}{7 \mu g} (2 + \theta)": N * (theta + 2) / (7 * mu * g),
    # over a sine, and of a sum with a fixed slope; one sign of a denominator; a tall root behind the bar
    r"\frac{g (m + 2 M)}{2 \sin\beta}": g * (m / 2 + M) / sine(beta),
    r"\frac{2 g (m - 3 M \sin\beta)}{2 m + 5 M}": 2 * g * (m - 3 * M * sine(beta)) / (2 * m + 5 * M),
    r"-\frac{2 m g}{3 (m + M) - 2 m \cos^2\beta} \sin\beta": -2 * m * g * sine(beta) / (3 * (m + M) - 2 * m * cosine(beta) ** 2),
    r"\frac{R}{\ell} \sqrt{\frac{g (a^2 + b^2)}{s}}": R * root(g * (a**2 + b**2) / s) / ell,
    # coefficients first, squares as such, tangents
    r"\frac{5 \mu g}{2 R}": 5 * g * mu / (2 * R),
    r"\frac{\kappa}{2} (\theta^2 - \phi^2)": kappa * (theta - phi) * (theta + phi) / 2,
    r"\ell \sin\theta \tan\theta": ell * sine(theta) ** 2 / cosine(theta),
    r"\ell \cos(\theta - \phi)": ell * (cosine(theta) * cosine(phi) + sine(theta) * sine(phi)),
}


@pytest.mark.parametrize("latex", FORMS)
def test_a_value_is_printed_so(latex):
    shown = present(FORMS[latex], STYLE, factor=True)
    assert to_latex(shown, DEFAULT) == latex
    assert same(scalar(shown), FORMS[latex])


def test_what_stands_above_and_below_is_cancelled():
    above, below = 5 * m * g * (R - a), 7 * m * (R - a) ** 2
    shown = present(above / below, STYLE)
    assert to_latex(shown, DEFAULT) == r"\frac{5 g}{7 (R - a)}"


def test_a_moment_of_inertia_below_a_bar_brings_no_fraction_with_it():
    moment, torque = m * ell**2 / 3 + M * ell**2, g * ell * (m / 2 + M)
    assert to_latex(present(torque / moment, STYLE, factor=True), DEFAULT) == r"\frac{3 g (m + 2 M)}{2 \ell (m + 3 M)}"


def test_the_greater_one_comes_first():
    shown = present(1 / (2 * (R - a) * (R + a) * (R + 3 * a)), STYLE, factor=True)
    assert to_latex(shown, DEFAULT) == r"\frac{1}{2 (R^2 - a^2) (R + 3 a)}"
    assert to_latex(present(m * (a + R), STYLE), DEFAULT) == "m (R + a)"


def _root(radicand):
    return generator_of("root", radicand)


@pytest.mark.parametrize(
    ("value_", "latex"),
    [
        (_root(g * ell) / ell, r"\sqrt{\frac{g}{\ell}}"),
        (_root((R - a) ** 2 + _root(a * (2 * R - a)) ** 2), "R"),
        (_root(4 * g / (R - a) ** 2) * (R - a), r"2 \sqrt{g}"),
        (root(lift(6)) * _root(ell / g) / 3, r"\sqrt{\frac{2 \ell}{3 g}}"),
        (root(lift(2)) / 2 * _root(g * sine(theta) / ell), r"\sqrt{\frac{g}{2 \ell} \sin\theta}"),
        (root(lift(2)) * root(lift(3)) * g / 3, r"\frac{g \sqrt{6}}{3}"),
        (_root(g) * _root(ell), r"\sqrt{g \ell}"),
        (_root(m - M) / (m - M), r"\frac{1}{\sqrt{m - M}}"),
        (_root((R**2 + a**2) ** 2 / (R + a) ** 3), r"\frac{R^2 + a^2}{(R + a) \sqrt{R + a}}"),
        (_root(g * (m - M) ** 2 / ell), r"\sqrt{\frac{g}{\ell}} \lvert m - M \rvert"),
        (_root(g / (m - M) ** 2), r"\frac{\sqrt{g}}{\lvert m - M \rvert}"),
        (_root(g * (m - M) ** 2) / (m - M) ** 2, r"\frac{\sqrt{g}}{\lvert m - M \rvert}"),
        (root(lift(2)) / 4 * _root(g * ell), r"\frac{\sqrt{2 g \ell}}{4}"),
        (_root(g * (R + a) / R) / ell, r"\sqrt{\frac{g (R + a)}{R \ell^2}}"),
        (_root((m - M) ** 2) * g, r"g \lvert m - M \rvert"),
        (_root((m - M) ** 2) ** 2 * g, r"g (m - M)^2"),
        (function("exp", _root((m - M) ** 2)) + function("exp", -_root((m - M) ** 2)), r"\exp(M - m) + \exp(m - M)"),
    ],
)
def test_one_root_stands_in_a_product_and_nothing_squared_in_it(value_, latex):
    known = (R - a, R + a, R**2 + a**2, *map(symbol, ("g", "ell", "R", "a")))
    found = tidied(value_, lambda part: any(same(part, one) for one in known) - any(same(part, -one) for one in known))
    assert to_latex(present(found, STYLE, factor=True), DEFAULT) == latex
    assert same(found * found, value_ * value_) or scalars_equal(found, value_, positive("g", "ell", "R", "a")).is_proved


def test_a_perfect_power_is_told_from_other_sums():
    assert perfect_power(((ell - 2 * s) ** 3).num)[2] == 3
    assert perfect_power((3 * (ell - 2 * s) ** 4).num)[::2] == (3, 4)
    assert perfect_power((ell**3 - 8 * s**3 + ell * s**2 + ell**2 * s).num) is None
    assert perfect_power((ell**2 + ell * s + s**2).num) is None


def test_angles_are_joined_only_where_both_products_are_there():
    assert len(with_joined_angles((2 * cosine(theta) * cosine(phi) + sine(theta) * sine(phi)).num)) == 2
    whole = (cosine(theta) * sine(phi) - sine(theta) * cosine(phi)) * ell + g
    assert same(Scalar(with_joined_angles(whole.num)), whole)
    assert len(with_joined_angles(whole.num)) == 2


def test_a_sum_of_negative_terms_gives_its_sign_away():
    bracket = t.Add((t.Neg(t.Sym("a")), t.Neg(t.Sym("b"))))
    assert t.mul(bracket, t.Unit("z")) == t.Neg(t.Mul((t.Add((t.Sym("a"), t.Sym("b"))), t.Unit("z"))))
    assert t.mul(bracket) == bracket
    assert value(t.mul(bracket, t.Sym("g")), Meanings()) == -(a + b) * g
