"""Small parts of printers and readers, each by what it writes or says: words, thin spaces, limits told with their reason."""

from fractions import Fraction
from unicodedata import numeric

import pytest

from rbpsym.document.writers.word import fitted
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.expr.latex.names import drawn_name
from rbpsym.expr.latex.reader import read_latex
from rbpsym.field.evaluate import scalar
from rbpsym.typeset.algebra_layout import VULGAR, is_function_power
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.machine import to_machine
from rbpsym.typeset.mathml import _SLANTS, to_mathml
from rbpsym.typeset.omml import run
from rbpsym.typeset.speech import to_speech
from rbpsym.typeset.text import to_text

X = t.Sym("x")


@pytest.mark.parametrize(
    ("node", "said"),
    [
        (t.relation(X, "<", t.ONE), "x is less than 1"),
        (t.relation(X, ">", t.ONE), "x is greater than 1"),
        (t.Div(t.TWO, t.Num(3)), "two thirds"),
        (t.Div(t.ONE, t.Num(4)), "one quarter"),
        (t.Div(t.Num(3), t.Num(4)), "three quarters"),
        (t.Sym("x_tilde"), "x tilde"),
        (t.Sym("x_check"), "x check"),
        (t.Sym("x_hat"), "x hat"),
        (t.Sym("x_bar"), "x bar"),
        (t.Pow(X, t.TWO), "x squared"),
        (t.Pow(X, t.Num(3)), "x cubed"),
        (t.Pow(X, t.Num(4)), "x to the power 4"),
    ],
)
def test_words_of_numbers_and_relations(node, said):
    assert to_speech(node) == said


@pytest.mark.parametrize("value", VULGAR)
def test_a_fraction_of_one_character_is_that_character(value):
    assert to_text(t.Div(t.Num(value.numerator), t.Num(value.denominator))) == VULGAR[value]
    assert abs(numeric(VULGAR[value]) - value) < 1e-6


@pytest.mark.parametrize("right", [t.ZERO, t.TWO, t.Pow(t.ZERO, t.TWO)])
def test_two_numbers_do_not_run_together(right):
    assert "·" in to_text(t.Mul((t.TWO, right)))


@pytest.mark.parametrize(("accent", "order"), [(r"\dot", 1), (r"\ddot", 2), (r"\dddot", 3)])
def test_as_many_dots_as_derivatives(accent, order):
    assert drawn_name(rf"{accent}{{x}}")[0].dots == order


def test_what_is_raised_is_moved_off_a_slanted_arm_by_less_than_half_a_letter():
    assert all(0 < room < 0.5 for room in _SLANTS.values())
    assert _SLANTS["V"] == max(_SLANTS.values()) and _SLANTS["M"] > _SLANTS["K"]


@pytest.mark.parametrize("half", [t.Div(t.ONE, t.TWO), t.Num(Fraction(1, 2))])
def test_a_dot_stands_between_a_number_and_a_fraction_of_numbers_only(half):
    assert "·" in to_text(t.Mul((t.Num(3), half)))
    assert "·" not in to_text(t.Mul((t.Num(3), t.Div(X, t.TWO))))


THIN = '<mspace width="0.1667em"/>'


def test_a_function_stands_off_from_what_it_is_of_and_from_factors_but_not_from_a_bracket():
    plain, fenced = to_mathml(t.Fn("sin", X)), to_mathml(t.Fn("sin", t.Group(t.add(X, t.ONE))))
    assert plain.count(THIN) == 1 and THIN not in fenced
    assert '<mo form="prefix" fence="true" stretchy="false">(</mo>' in fenced
    assert to_mathml(t.Mul((X, t.Fn("sin", X)))).count(THIN) == 2 and THIN not in to_mathml(t.Mul((X, t.Sym("y"))))


def test_space_at_an_end_is_kept_in_word():
    assert 'xml:space="preserve"' in run(" a") and 'xml:space="preserve"' in run("a ") and "xml:space" not in run("a b")


@pytest.mark.parametrize("order", [2, 9])
def test_the_order_of_a_derivative_has_one_digit(order):
    assert read_latex(rf"\frac{{d^{order} x}}{{dt^{order}}}", {"x", "t"}).order == order


def told(read, text: str) -> str:
    with pytest.raises(RbpsymError) as error:
        read(text, {"x"})
    return error.value.what


def test_what_is_wrong_with_a_number_is_told():
    assert told(read_latex, "1" * 31) == "a number of more than 30 digits"
    assert told(read_latex, "1.2.3") == "two decimal marks"


def test_of_a_name_that_is_not_known_forty_letters_are_told():
    assert told(read_infix, "q" * 40) == f"unknown symbol “{'q' * 40}”"
    assert told(read_infix, "q" * 41) == f"unknown symbol “{'q' * 40}…”"


@pytest.mark.parametrize(("left", "right", "widths"), [(50, 50, (50, 50)), (60, 50, (33, 67)), (10, 95, (10, 90))])
def test_two_sides_are_made_narrower_only_where_they_do_not_fit(left, right, widths):
    assert fitted(left, right, 100) == widths


OTHER_WORDS = {
    "log": "ln", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "sen": "sin", "tg": "tan", "ctg": "cot", "cotg": "cot",
    "cosec": "csc", "arcsen": "asin", "arctg": "atan",
}  # fmt: skip


@pytest.mark.parametrize(("word", "name"), OTHER_WORDS.items())
def test_other_words_of_functions(word, name):
    assert read_infix(f"{word}(x)", {"x"}) == t.Fn(name, t.Sym("x"))


@pytest.mark.parametrize("text", ["x^{2}_1", "x^{{2}}_1", "x^{a + {b}}_1"])
def test_a_subscript_may_stand_behind_what_is_raised(text):
    found = read_latex(text, {"x_1", "a", "b"})
    assert isinstance(found, t.Pow) and found.base == t.Sym("x_1")


SUM_BELOW_ZERO = t.Neg(t.Add((t.Sym("a"), t.Sym("b"))))


@pytest.mark.parametrize(
    "node",
    [SUM_BELOW_ZERO, t.Neg(SUM_BELOW_ZERO), t.Mul((t.Sym("a"), SUM_BELOW_ZERO)), t.Div(SUM_BELOW_ZERO, t.Sym("a"))],
    ids=to_text,
)
def test_a_minus_before_a_sum_is_that_of_all_of_it(node):
    names = {"a", "b"}
    assert scalar(read_latex(to_latex(node), names)) == scalar(read_infix(to_machine(node), names)) == scalar(node)


@pytest.mark.parametrize(("exponent", "raised"), [(2, True), (3, True), (1, False), (-1, False), (Fraction(1, 2), False)])
def test_which_powers_stand_behind_the_name_of_a_function(exponent, raised):
    assert is_function_power(t.Pow(t.Fn("sin", t.Sym("x")), t.Num(exponent))) is raised
