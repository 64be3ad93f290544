"""What people type, what it means, and what is refused with a sentence."""


import pytest

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError
from rbpsym.expr.infix import read_infix, read_relation, read_ways
from rbpsym.expr.tree import Abs, Fn, Group, Mul, Neg, Num, Pow, Sym, walk
from rbpsym.typeset.machine import to_machine
from tests.effort import at_most

SYMBOLS = """m M g ell theta theta_0 theta_dot omega omega_1 E I N S Q beta gamma lambda x_dot
    varphi k R theta_1_ddot n mu1""".split()  # fmt: skip

MEANINGS = {
    "2 ell": "2*ell",
    "m g ell": "m*g*ell",
    "3(m + 1)": "3*(m + 1)",
    "g(m+M)": "g*(m + M)",
    "½ M ω²": "1/2*M*omega**2",
    "ω₁² + ẋ": "omega_1**2 + x_dot",
    "ω_1": "omega_1",
    "μ₁": "mu1",
    "θ̇²": "theta_dot**2",
    "θ̈₁ + θ₀": "theta_1_ddot + theta_0",
    "φ − π/2": "varphi - pi/2",
    "λ": "lambda_",
    "2·m×g": "2*m*g",
    "1/2 M R²": "1/2*M*R**2",
    "sin^2(theta)": "sin(theta)**2",
    "sin²θ": "sin(theta)**2",
    "sin(theta)^2": "sin(theta)**2",
    "cos 2θ": "cos(2*theta)",
    "sin theta cos theta": "sin(theta)*cos(theta)",
    "cos(theta) m": "cos(theta)*m",
    "-m^2": "-m**2",
    "m^-1": "m**(-1)",
    "m⁻²": "m**(-2)",
    "n²": "n**2",
    "E I N S Q beta gamma lambda": "E*I*N*S*Q*beta*gamma*lambda_",
    "√(2g/ell)": "sqrt(2*g/ell)",
    "√2 g": "sqrt(2)*g",
    "|m - M|": "abs(m - M)",
    "m - -g": "m - (-g)",
    "m g/ell": "m*g/ell",
    "(m/g) ell": "m/g*ell",
    "m/g/ell": "m/g/ell",
    "m*-g": "m*(-g)",
    "[m + g] k": "(m + g)*k",
    "9.81 m": "981/100*m",
    "ln(m/M) + arcsin(1/2)": "log(m/M) + asin(1/2)",
    "2**3**2": None,
    "θ0 + sin θ0": "theta_0 + sin(theta_0)",
    "theta0": "theta_0",
    "ω1 R": "omega_1*R",
    "2*sin θ": "2*sin(theta)",
    "2sinθ cosθ": "2*sin(theta)*cos(theta)",
    "sin^2(θ) + cos²(θ)": "sin(theta)**2 + cos(theta)**2",
    "1,5 m": "3/2*m",
    "m·g×k": "m*g*k",
    "3/4 g/ell": "3/4*g/ell",
    "ℓ": "ell",
    "k**(1/2)": "k**(1/2)",
}


@pytest.mark.parametrize("typed", [typed for typed, meaning in MEANINGS.items() if meaning])
def test_meaning(typed):
    assert to_machine(read_infix(typed, SYMBOLS)) == MEANINGS[typed]


def test_a_symbol_of_the_problem_comes_before_a_function():
    assert read_infix("ln(2)", ["ln"]) == Mul((Sym("ln"), Num(2)))
    assert read_infix("ln(2)", []) == Fn("ln", Num(2))


def test_a_power_binds_more_than_a_sign():
    assert read_infix("-m²", ["m"]) == Neg(Pow(Sym("m"), Num(2)))


def test_parentheses_make_no_node():
    assert not any(isinstance(part, Group) for part in walk(read_infix("((m)) (g)", "mg")))


def test_aliases():
    assert read_infix("ω²", ["theta_dot"], aliases={"omega": "theta_dot"}) == Pow(Sym("theta_dot"), Num(2))


def test_relations():
    assert to_machine(read_relation("0 < θ ≤ π/2", SYMBOLS)) == "0 < theta <= pi/2"
    assert to_machine(read_relation("m == g", SYMBOLS)) == "m = g"


REFUSED = {
    "": "ends too early",
    "m + ": "ends too early",
    "(m": "never closed",
    "m)": "never opened",
    "m = g": "makes a relation",
    "thta": "Did you mean “theta”?",
    "mgell": "write m*g*ell",
    "f(x)": "unknown symbol “f”",
    "3g/4ell": "in two ways",
    "g/4 ell": "in two ways",
    "sin theta R": "in two ways",
    "sin theta/2": "in two ways",
    "sin theta^2": "raised to this power",
    "sin^-1 theta": "Write asin(x)",
    "sin": "needs its argument",
    "2 3": "Write * between",
    "1.5.2": "Write * between",
    "m * / g": "expected before “/”",
    "m,g": "not expected",
    "m!": "exclamation mark",
    "m;g": "semicolon",
    '"m"': "quotation mark",
    "m.real": "full stop",
    "__import__('os')": "is not a name",
    "m__class__": "is not a name",
    "m.__class__": "full stop",
    "lambda: 0": "colon",
    "[m for m in g]": "unknown symbol “for”",
    "eval(m)": "unknown symbol “eval”",
    "m\u200bg": "zero width space",
    "\u202em": "right-to-left override",
    "m\u0000": "control character",
    "а + 1": "cyrillic small letter a",
    "𝜃": "mathematical italic small theta",
    "ｍ": "Type “m” instead",
    "m²²²²²²": "too large",
    "m²^2": "exponent",
    "1,500 m": "decimal mark",
    "1,5,2": "not expected",
    "sin2θ": "Write sin(2*x), or sin(x)^2",
    "2e3": "Write 10^3",
    "30°": "pi/6",
    "{m}": "Use parentheses",
    "\\theta": "looks like LaTeX",
    "m—g": "Type “-” instead",
    "n2": "unknown symbol “n2”",
    "θ0.5": "number can't follow",
}


@pytest.mark.parametrize("typed", REFUSED)
def test_refused_with_a_sentence(typed):
    with pytest.raises(RbpsymError) as caught:
        read_infix(typed, SYMBOLS)
    assert REFUSED[typed] in str(caught.value)
    assert caught.value.place


HOSTILE = {
    "long": "m" * 3000,
    "long name": "m" * 1900,
    "digits": "1" * 500,
    "parentheses": "(" * 900 + "m" + ")" * 900,
    "open": "(" * 1900,
    "signs": "-" * 1900 + "m",
    "roots": "√" * 1900 + "m",
    "functions": "sin" + " sin" * 400,
    "calls": "sin(" * 400 + "m" + ")" * 400,
    "quotients": "m/" * 900 + "m",
    "exponent": "9^99999999",
    "tower": "9^9^9^9^9",
    "towers": "((((((m^60)^60)^60)^60)^60)^60)",
    "numbers": "((((9^60)^60)^60)^60)^60",
    "fraction": "2^(1/99999)",
    "bars": "|" * 1900,
    "exponents": "m" + "^m" * 900,
    "products": "m" + "*m^64" * 300,
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_hostile_input_is_refused_quickly(kind):
    with at_most(), pytest.raises((ReadError, LimitError)) as caught:
        read_infix(HOSTILE[kind], SYMBOLS)
    assert len(caught.value.what) < 200


def test_a_long_sum_is_no_offence():
    assert len(read_infix("+".join(["m"] * 900), SYMBOLS).terms) == 900


def test_the_caret_stands_under_the_word_in_its_file():
    line = 'center = ["ell*cos(thta)", "0"]'
    place = Place("ladder.toml", 7, 12, line)
    with pytest.raises(ReadError) as caught:
        read_infix("ell*cos(thta)", SYMBOLS, place=place)
    assert caught.value.place == Place("ladder.toml", 7, 20, line, 4)
    assert line[19:23] == "thta"


def test_the_caret_of_a_text_with_several_lines():
    with pytest.raises(ReadError) as caught:
        read_infix("m +\n thta", SYMBOLS)
    assert (caught.value.place.line, caught.value.place.column, caught.value.place.text) == (2, 2, " thta")


def test_bars_and_brackets_may_follow_a_factor():
    x, y = Sym("x"), Sym("y")
    assert read_infix("x|y|", {"x", "y"}) == Mul((x, Abs(y)))
    assert read_infix("|x|y", {"x", "y"}) == Mul((Abs(x), y))
    assert read_infix("[x + y]", {"x", "y"}) == read_infix("(x + y)", {"x", "y"})


BESIDE_A_BAR = {"x/y m": True, "x/y sin(m)": False, "x/y (m + 1)": False, "x/y(m + 1)": True}


@pytest.mark.parametrize(("typed", "parts"), BESIDE_A_BAR.items())
def test_what_stands_apart_is_hardly_below_the_bar(typed, parts):
    found = read_ways(typed, {"x", "y", "m"})
    assert len(found.trees) == 2
    assert found.parted == (((False,), (True,)) if parts else ((), ()))


@pytest.mark.parametrize("typed", ["sin(x)**2/(2*y)", "x*sin(y)**2/x", "sin(x)**2*y", "sqrt(x)**3/2"])
def test_a_power_of_a_call_is_closed(typed):
    """What `to_machine` writes is read back: the argument of sin(x)**2 stands in parentheses."""
    assert to_machine(read_infix(typed, {"x", "y"})) == typed
