"""Random scalar trees for the laws."""

from fractions import Fraction

from hypothesis import strategies as st

from rbpsym.expr import tree as t

NAMES = ("m", "M", "g", "ell", "theta", "theta_0", "omega", "theta_1_dot", "I_cm", "W_T_N_w", "load", "pi",
         "r_prime", "Delta_x", "cal_w_c", "x_hat", "e", "E", "beta")  # fmt: skip

numbers = st.one_of(st.integers(-3, 12), st.fractions(-3, 3, max_denominator=12), st.just(Fraction(981, 100))).map(
    t.Num
)
symbols = st.sampled_from(NAMES).map(t.Sym)
exponents = st.one_of(st.integers(-3, 4), st.just(Fraction(3, 2)), st.just(Fraction(-1, 2))).map(t.Num)
functions = st.sampled_from(["sin", "cos", "tan", "asin", "atan", "exp", "ln", "cot", "sec", "csc", "acos"])


def _grown(inner):
    several = st.lists(inner, min_size=1, max_size=4).map(tuple)
    return st.one_of(
        several.map(t.Add), several.map(t.Mul), inner.map(t.Neg), inner.map(t.Sqrt), inner.map(t.Abs),
        st.builds(t.Div, inner, inner), st.builds(t.Pow, inner, exponents), st.builds(t.Fn, functions, inner),
        st.builds(t.Group, inner, st.sampled_from("([")), st.builds(t.Pow, symbols, inner.filter(t.names)),
    )  # fmt: skip


scalars = st.recursive(st.one_of(numbers, symbols), _grown, max_leaves=9)
