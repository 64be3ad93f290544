"""Formulas of plane motion that every printer must print and every reader read back."""

from fractions import Fraction

from rbpsym.expr.tree import (
    HALF,
    ONE,
    TWO,
    ZERO,
    Abs,
    Add,
    At,
    BodyIntegral,
    Bracket,
    Cross,
    Delta,
    Deriv,
    Div,
    Dot,
    Fn,
    Group,
    Integral,
    Limit,
    Mul,
    Neg,
    Num,
    PathIntegral,
    Pow,
    Relations,
    Sqrt,
    Sum,
    Sym,
    Unit,
    Vec,
    Word,
    equation,
    relation,
)  # fmt: skip

th, th0, m, M, g, ell, R, t = (Sym(n) for n in "theta theta_0 m M g ell R t".split())
omega, omega_0, I_O, tau = (Sym(n) for n in "omega omega_0 I_O tau".split())


def sin(arg):
    return Fn("sin", arg)


def cos(arg):
    return Fn("cos", arg)


def power(base, n):
    return Pow(base, Num(n))


def mul(*factors):
    return Mul(factors)


INERTIA = Add((Div(mul(m, power(ell, 2)), Num(3)), mul(M, power(ell, 2)), Div(mul(M, power(R, 2)), TWO)))
LEVER = Add((Div(m, TWO), M))
POSITION = Add((Vec("r"), Vec("R_cm")))

SCALARS = {
    "ladder": Neg(mul(Div(mul(Num(3), g), mul(Num(4), ell)), cos(th))),
    "inertia": INERTIA,
    "pendulum": Neg(mul(Div(mul(g, ell, Group(LEVER)), INERTIA), sin(th))),
    "change": mul(HALF, I_O, Add((power(omega, 2), Neg(power(omega_0, 2))))),
    "wall": mul(Num(Fraction(3, 4)), M, g, cos(th), Add((mul(Num(3), sin(th)), Neg(mul(TWO, sin(th0)))))),
    "numbers": mul(TWO, Num(3), power(TWO, 2), Div(ONE, TWO), ell),
    "sine before": mul(sin(th), ell),
    "two functions": mul(sin(th), cos(th), ell),
    "square": power(sin(th), 2),
    "double": cos(mul(TWO, th)),
    "frequency": cos(mul(omega, t)),
    "half angle": sin(Div(th, TWO)),
    "difference": sin(Add((Sym("theta_1"), Neg(Sym("theta_2"))))),
    "signs": Add((Neg(Neg(m)), Num(-2), mul(Num(-1), g), Neg(Add((m, M))), mul(Neg(m), Neg(M)))),
    "sum squared": power(LEVER, 2),
    "root power": power(ell, Fraction(3, 2)),
    "inverse": power(m, -1),
    "inverse cosine": power(cos(th), -1),
    "prime": power(Sym("r_prime"), 2),
    "root": Sqrt(Div(mul(Num(3), g), mul(TWO, ell))),
    "root squared": power(Sqrt(ell), 2),
    "tower": power(power(ell, 2), 3),
    "change squared": power(Sym("Delta_x"), 2),
    "magnitude": Abs(Div(m, M)),
    "decay": Fn("exp", Neg(Div(t, tau))),
    "decay power": Pow(Sym("e"), Neg(Div(t, tau))),
    "per square": Div(ONE, power(ell, 2)),
    "ratio squared": power(Div(m, M), 2),
    "sum first": mul(Add((m, M)), g),
    "logarithm": Fn("ln", ell),
    "arc": Fn("asin", Num(Fraction(2, 3))),
    "measured": Num(Fraction(981, 100)),
    "speed": mul(HALF, M, power(Sym("V_cm"), 2)),
    "dots": mul(ell, power(Sym("theta_1_dot"), 2), Sym("theta_2_ddot")),
    "fraction of sums": Div(Add((m, M)), Add((m, Neg(M)))),
    "negative numerator": Add((m, Div(Neg(g), ell))),
    "fraction in fraction": Div(Div(g, ell), Div(m, M)),
    "product in product": mul(m, mul(g, ell)),
    "power of pi": Div(Sym("pi"), TWO),
    "negative power": power(Neg(m), 2),
    "nested sums": Add((m, Add((M, Neg(Add((m, M))))))),
    "group in sine": sin(Group(Add((th, th0)))),
    "empty": Add(()),
    "negative fraction": Num(Fraction(-3, 4)),
    "number times fraction": mul(TWO, Num(Fraction(1, 2)), m),
    "minus inside": mul(m, Neg(g)),
    "minus minus": Neg(mul(Num(-2), m)),
    "quotient times sum": mul(Div(g, ell), Add((m, M))),
    "exponent sum": Pow(ell, Add((TWO, Neg(Sym("n"))))),
    "exponent product": Pow(Sym("e"), mul(Sym("gamma"), t)),
    "exponent quotient": Pow(Sym("e"), Neg(Div(mul(Sym("gamma"), t), mul(TWO, m)))),
    "sine over": Div(sin(th), TWO),
    "tangent cubed": mul(power(Fn("tan", th), 3), m),
    "words": mul(m, Sym("load"), g),
}  # fmt: skip

CALCULUS = {
    "second derivative": Deriv(th, "t", 2),
    "derivative": Deriv(Add((th, Neg(th0)))),
    "momentum": Deriv(mul(I_O, omega)),
    "derivative squared": power(Deriv(th), 2),
    "partial": Deriv(Sym("T"), "theta_dot", 1, True),
    "work": Neg(Integral(mul(g, ell, LEVER, sin(th)), "theta", th0, th)),
    "integral of sum": Integral(Add((mul(Sym("N_w"), sin(th)), Neg(mul(Sym("N_f"), cos(th))))), "theta", th0, th),
    "integral of one": Integral(ONE, "theta", ZERO, Div(Sym("pi"), TWO)),
    "integral of minus": Integral(Neg(th), "theta", th0, th),
    "integral times": mul(Integral(m, "theta", th0, th), M),
    "times integral": mul(M, Integral(m, "theta", th0, th)),
    "integral plus": Add((Integral(m, "theta", th0, th), M)),
    "double integral": Integral(Integral(m, "phi", ZERO, th), "theta", th0, th),
    "bracket": Bracket(mul(HALF, power(Sym("theta_1_dot"), 2)), "theta", th0, th),
    "bracket between": Bracket(cos(th), "theta", ZERO, Div(Sym("pi"), TWO)),
    "bracket times": mul(m, Bracket(cos(th), "theta", th0, th)),
    "at": At(Sym("N_w"), equation(th, th0)),
    "limit": Limit(mul(omega, ell), "R", ZERO),
    "change": Delta(Sym("E_k")),
    "change of sum": Delta(Add((Sym("E_k"), Sym("E_p")))),
    "inertia": BodyIntegral(power(Sym("r"), 2)),
    "inertia of rod": BodyIntegral(power(Sym("r"), 2), "rod"),
    "torque work": PathIntegral(tau, Sym("varphi"), "times"),
}  # fmt: skip

VECTORS = {
    "momentum": BodyIntegral(Cross(POSITION, Deriv(POSITION))),
    "koenig": Add((Cross(Vec("R_cm"), Vec("P_cm")), mul(Sym("I_cm"), Vec("omega")))),
    "work": PathIntegral(Add((Vec("N_w"), Vec("N_f"))), Vec("R_cm")),
    "power": Dot(Vec("F"), Vec("V_cm")),
    "magnitude": Abs(Vec("F")),
    "components": Add((mul(m, Unit("x")), Neg(mul(M, Unit("y"))))),
    "torque": mul(sin(th), Unit("z")),
    "triple": Cross(Vec("omega"), Cross(Vec("omega"), Vec("r"))),
    "lever": Cross(Vec("R_cm"), mul(M, Vec("V_cm"))),
    "derivative": Deriv(Vec("L")),
    "scaled": mul(M, Cross(Vec("R_cm"), Vec("V_cm"))),
    "particles": Sum(PathIntegral(Vec("F_i"), Vec("r_i")), "i"),
}  # fmt: skip

RELATIONS = {
    "alpha": equation(Sym("alpha"), Deriv(th, "t", 2), SCALARS["ladder"]),
    "split": equation(Sym("cal_W_T"), Add((Sym("cal_w_c"), Neg(mul(M, g, ell, Add((sin(th), Neg(sin(th0))))))))),
    "names": equation(Sym("W_T_N_w"), Sym("L_disk_O"), Sym("F_net"), Sym("cal_W_N_w"), Sym("I_O_prime")),
    "constant": equation(Sym("E"), Word("const")),
    "order": relation(Sym("vartheta_1"), "<", Sym("vartheta_2")),
    "range": relation(sin(th), ">=", mul(Div(TWO, Num(3)), sin(th0))),
    "near": relation(sin(th), "~", th),
    "unequal": relation(omega, "!=", ZERO),
    "system": Relations((equation(Sym("x"), ell, m), relation(Sym("y"), "<=", g))),
}  # fmt: skip

SAMPLES = {
    f"{kind}: {name}": tree
    for kind, table in (("scalar", SCALARS), ("calculus", CALCULUS), ("vector", VECTORS), ("relation", RELATIONS))
    for name, tree in table.items()
}
