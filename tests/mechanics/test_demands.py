"""What is left of conditions says the same as they do together: at any numbers both hold, or neither."""

import math
import random
import re
from pathlib import Path

import pytest

import rbpsym
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.factoring import MINUS, PLUS, ZERO
from rbpsym.decide.signs import sign
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import PI, symbol
from rbpsym.mechanics.demands import Demand, assuming, existence, possible, settle
from rbpsym.mechanics.numbers import number

GIVEN = Assumptions(
    dict.fromkeys(("m", "M", "k", "L", "mu"), "positive"),
    {"theta": (-scalar(read_infix("pi", ())), scalar(read_infix("pi", ())))},
)
NAMES = ("m", "M", "k", "L", "mu", "x", "theta")
HOLDS = {">": lambda value: value > 0, ">=": lambda value: value >= 0, "!=": lambda value: value != 0}


def demands(texts) -> list[Demand]:
    """ "m - M > 0" and the like, as demands."""
    parts = [text.split(" ") for text in texts]
    return [Demand(scalar(read_infix(" ".join(words[:-2]), NAMES)), words[-2]) for words in parts]


def samples(count: int = 60):
    source = random.Random(7)
    for _ in range(count):
        found = {name: 9 ** source.uniform(-1, 1) for name in NAMES[:-2]}
        found |= {"x": source.uniform(-3, 3), "theta": source.uniform(-math.pi, math.pi)}
        yield found
        whole = {name: math.ceil(8 * value) / 8 + 1 / 16 for name, value in found.items()}
        yield whole | {"M": whole["m"], "x": 2.0, "theta": found["theta"]}  # where some are equal, without an error of rounding


def hold(items, at) -> bool:
    try:
        return all(HOLDS[item.op](number(item.value, at)) for item in items)
    except (ValueError, ZeroDivisionError):
        return False


SETS = {
    "twice": ["m - M > 0", "2*m - 2*M > 0"],
    "one of the other": ["m - M > 0", "m*k - M*k > 0"],
    "implied": ["m + M > 0", "m - M != 0"],
    "against each other": ["m - M > 0", "M - m > 0"],
    "a difference of products from both sides": ["m*k - M*L > 0", "M*L - m*k >= 0"],
    "never": ["-m > 0"],
    "never or equal": ["-m - M >= 0"],
    "zero": ["m - m != 0"],
    "product": ["(m - M)*(k - L) > 0", "m - M > 0"],
    "both": ["m - M > 0", "m - M != 0"],
    "or equal, but not": ["m - M >= 0", "m - M != 0"],
    "or equal and more": ["m - M >= 0", "m*k - M*k > 0"],
    "or equal from both sides": ["m - M >= 0", "M - m >= 0"],
    "from a number on, but not there": ["x - 2 >= 0", "x - 2 != 0"],
    "a number from both sides": ["x - 2 >= 0", "2 - x >= 0", "m - M > 0"],
    "or equal": ["m - M >= 0", "k - L > 0"],
    "quotient": ["(m - M)/(k + L) > 0"],
    "quotient of either sign": ["(m - M)/(k - L) > 0"],
    "square": ["m**2 - M*k > 0"],
    "squares": ["m**2 - M*k > 0", "m - 2*M > 0", "k - L > 0"],
    "chain": ["m - M > 0", "M - k > 0", "m - k > 0"],
    "product of one sign": ["(5*m - M)*(M - 2*m) > 0"],
    "product or equal": ["(m - 5*M)*(2*M - m) >= 0"],
    "product of either sign": ["(m - M)*(k - L) > 0"],
    "root": ["m - M*sqrt(k) > 0"],
    "root above": ["M*sqrt(k) - m > 0"],
    "root or equal": ["m - sqrt(M**2 + k) >= 0"],
    "root alone": ["2*m*sqrt(M - k) > 0", "m - k > 0"],
    "minus a root": ["-sqrt(M**2 + k) >= 0"],
    "two roots": ["m - L*sqrt(k) > 0", "m - k > 0"],
    "asin": ["asin(mu) - pi/6 > 0", "1 - mu**2 > 0"],
    "minus asin": ["pi/3 - asin(mu) > 0", "1 - mu**2 > 0"],
    "asin beyond": ["asin(mu) + pi > 0", "1 - mu**2 > 0"],
    "asin never": ["asin(mu) - pi > 0", "1 - mu**2 > 0"],
    "acos": ["acos(mu) - pi/3 > 0", "1 - mu**2 > 0"],
    "minus acos": ["pi/4 - acos(mu) > 0", "1 - mu**2 > 0"],
    "asin against what may be beyond": ["asin(sin(theta)/2) - k > 0"],
    "atan": ["2*atan(mu) - pi/2 > 0"],
    "atan beyond": ["pi - atan(mu) > 0"],
    "waves": ["sin(theta) > 0"],
    "falling": ["-sin(theta) > 0", "m > 0"],
    "rising": ["cos(theta) > 0", "1 - mu > 0"],
    "what a sine leaves": ["sin(theta) > 0", "1 - cos(theta) > 0"],
    "with a factor in squares": ["(1 - cos(theta))*(m + M + M*cos(theta)) > 0", "1 - cos(theta) > 0", "m - 2*k > 0"],
    "a factor, or zero": ["(m - M)*(k - L) >= 0", "m - M >= 0", "x - 2 > 0"],
    "the square of what is open": ["x**2*sqrt(m)*(m - M) > 0", "m - M > 0"],
    "a root that is not zero": ["sqrt(m - M)/k != 0"],
    "root and its radicand": ["sqrt(m - M)*(m - M) > 0", "m - M > 0"],
    "a number's root": ["m*sqrt(2) - 2*M + M*sqrt(2) > 0", "m + M - M*sqrt(2) > 0"],
    "a root taken out": ["mu*sqrt(m + M)*k - (m + M)*L >= 0"],
    "no root of one term": ["mu*sqrt(m*M)*k - m*M*L >= 0", "x*sqrt(m*M) - m*M*L > 0"],
    "a tangent": ["2*atan(mu) - pi/4 > 0"],
    "exponentials": ["exp(x/m) - 2 + exp(-x/m) >= 0"],
    "a factor of one term, or zero": ["m - M > 0", "(m - M)*sin(theta) >= 0"],
    "a factor that may be negative": ["(m - M)*x > 0", "m - M > 0"],
    "wave and its square": ["cos(theta) > 0", "cos(theta) - cos(theta)**2 > 0"],
}


@pytest.mark.parametrize("name", SETS)
def test_what_is_left_says_the_same(name):
    asked = demands(SETS[name])
    left = settle(asked, GIVEN)
    for at in samples():
        assert hold(asked, at) == (left is not None and hold(left, at)), at
    if left is not None:
        assert len(left) <= len(asked) + ("root" in name or "product" in name)


FACTORS = ("x", "sin(theta)", "cos(theta)", "(m - M)", "(k - L)", "(x - 2)", "(1 - mu)", "(x**2 - m)", "(m*k - M*L)", "(x + m)",
           "sqrt(m)", "(M*sqrt(k) - m)", "(1 - cos(theta))", "(cos(theta) - mu)", "(theta - 1)", "(m - M)**2")  # fmt: skip


@pytest.mark.parametrize("seed", range(300))
def test_products_of_the_same_factors_say_together_what_they_said(seed):
    source = random.Random(seed)
    among = source.sample(FACTORS, 3)
    products = ("*".join(source.sample(among, source.choice((1, 1, 2, 2, 3)))) for _ in range(source.choice((2, 2, 3))))
    asked = demands([f"{source.choice(('', '', '-'))}{one} {source.choice(('>', '>='))} 0" for one in products])
    left = settle(asked, GIVEN)
    for at in list(samples())[::2]:  # where nothing is zero
        assert hold(asked, at) == (left is not None and hold(left, at)), at


def test_what_contradicts_itself_is_never_met():
    assert {name for name in SETS if settle(demands(SETS[name]), GIVEN) is None} == {
        "against each other", "a difference of products from both sides", "never", "never or equal", "zero", "asin never",
        "minus a root",
    }  # fmt: skip
    assert settle(demands(SETS["implied"]), GIVEN) == tuple(demands(["m - M != 0"]))
    assert settle(demands(SETS["twice"]), GIVEN) == tuple(demands(["m - M > 0"]))
    assert settle(demands(SETS["product of one sign"]), GIVEN) == tuple(demands(["5*m - M > 0", "M - 2*m > 0"]))


@pytest.mark.parametrize("name", SETS)
def test_ranges_that_follow_hold_where_the_conditions_do(name):
    asked = demands(SETS[name])
    known = assuming(GIVEN, asked)
    for at in samples():
        if hold(asked, at):
            for quantity in NAMES:
                low, high = known.range_of(quantity)
                assert low is None or number(low, at) <= at[quantity] + 1e-12
                assert high is None or number(high, at) >= at[quantity] - 1e-12


FORMULAS = ("sqrt(x - 1)", "asin(x)", "ln(x)/(x - 2)", "acos(x/m)*sqrt(1 - x**2)", "m/x", "atan(x) + 1/(x - mu)")


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_has_a_value_where_its_conditions_hold(text):
    value = scalar(read_infix(text, NAMES))
    asked = existence(value)
    for at in samples():
        try:
            found = math.isfinite(number(value, at))
        except (ValueError, ZeroDivisionError):
            found = False
        assert hold(asked, at) == found


SAID = [
    ("2*x", ">", (0, None), "positive"), ("-x", ">", (None, 0), "negative"), ("6 - 2*x", ">", (None, 3), None),
    ("x", ">=", (0, None), "nonnegative"), ("-x", ">=", (None, 0), "nonpositive"), ("x - 3", ">=", (3, None), "positive"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "op", "ends", "kind"), SAID)
def test_what_a_condition_says_of_one_quantity_is_a_bound_of_it(text, op, ends, kind):
    """An end that x ≥ 0 lets x have belongs to the range, so that x is not positive there."""
    found = assuming(GIVEN, [Demand(scalar(read_infix(text, NAMES)), op)])
    assert tuple(None if end is None else end.number() for end in found.range_of("x")) == ends
    assert sign(scalar(read_infix("x", NAMES)), found).kind == kind


ANGLE_NAMES, MASSES = ("m", "theta"), (0.5, 1.0, math.pi / 3, 2.0, 3.0)
ANGLES = Assumptions({"m": "positive"}, {"theta": (-PI, PI)})
WEAK = ("sin(theta)", "-sin(theta)", "cos(theta)", "theta - m", "m - theta", "theta", "2*theta - pi", "1 - m", "m**2 - 4")
ASKED = (*WEAK, "cos(theta) + 1", "sin(theta - m)", "m - 1", "1 - sin(theta)", "theta*(m - 2)", "sin(2*theta)")


@pytest.mark.parametrize("text", WEAK)
def test_where_a_weak_condition_holds_as_an_equality_signs_allow_for_it(text):
    """At each place, the ends with it, at which `text` ≥ 0, a formula has a sign that was said to be possible."""
    known = assuming(ANGLES, [Demand(scalar(read_infix(text, ANGLE_NAMES)), ">=")])
    weak = scalar(read_infix(text, ANGLE_NAMES))
    twelfths = [k * math.pi / 12 for k in range(-11, 12)]
    places = [{"theta": t, "m": m} for t in (*twelfths, *MASSES) for m in MASSES if -math.pi < t < math.pi]
    held = [at for at in places if number(weak, at) >= -1e-12]
    assert any(abs(number(weak, at)) < 1e-12 for at in held)
    for formula in ASKED:
        value = scalar(read_infix(formula, ANGLE_NAMES))
        mask = sign(value, known).mask
        for at in held:
            seen = number(value, at)
            assert mask & (ZERO if abs(seen) < 1e-12 else PLUS if seen > 0 else MINUS), (formula, at, seen)


def test_a_factor_of_what_is_positive_is_not_asked_for_beside_it() -> None:
    a, b, c = map(symbol, "abc")
    assert settle([Demand(a - b, "!="), Demand((a - b) * (a - c))], Assumptions()) == (Demand((a - b) * (a - c)),)


def test_what_is_neither_zero_nor_negative_is_positive() -> None:
    a, b = map(symbol, "ab")
    assert settle([Demand(b - a, "!="), Demand(a - b, ">=")], Assumptions()) == (Demand(a - b),)


def test_what_is_never_met_is_no_empty_condition() -> None:
    """“Never” is told by `possible`, and nobody takes it for “nothing is asked”."""
    asked = [[Demand(symbol("m"))], demands(["m - M > 0"]), demands(["m - M > 0", "M - m > 0"])]
    assert possible(asked[0], GIVEN, StatementError("never")) == () and possible(asked[1], GIVEN, StatementError("never"))
    with pytest.raises(StatementError, match="never"):
        possible(asked[2], GIVEN, StatementError("never"))
    files = Path(rbpsym.__file__).parent.rglob("*.py")
    assert not [file for file in files if re.search(r"\bsettle\(.*\) or ", file.read_text(encoding="utf-8"))]
