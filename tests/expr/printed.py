"""What every format makes of the sample formulas, as it was when it was last looked at.

    python -m tests.expr.printed     # writes printed.json anew, after what changed has been looked at
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path

from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Add, Div, Fn, Group, Mul, Node, Num, Pow, Relations, Sqrt, Sym, Vec, equation
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.machine import to_machine
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.omml import to_omml
from rbpsym.typeset.speech import to_speech
from rbpsym.typeset.text import to_text
from rbpsym.typeset.typst import to_typst
from tests.expr.samples import SAMPLES

KEPT = Path(__file__).parent / "printed.json"
x, y, a = Sym("x"), Sym("y"), Sym("a")
MORE: Mapping[str, Node] = {
    **{f"share {k}/{n}": Num(Fraction(k, n)) for k, n in ((1, 2), (2, 3), (1, 3), (1, 4), (3, 4), (5, 6), (7, 25), (-2, 5))},
    **{f"power {k}": Pow(x, Num(k)) for k in (1, 2, 3, 4, 5, -1, -2, Fraction(1, 2), Fraction(3, 2))},
    **{f"function {name}": Fn(name, x) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "ln", "exp")},
    "function of a sum": Fn("sin", Add((x, y))),
    "function of a product": Fn("cos", Mul((Num(2), x, y))),
    "function of a negative product": Fn("cos", Mul((Num(-2), x))),
    "function of nothing": Fn("cos", Num(0)),
    "function times letter": Mul((Fn("sin", x), y)),
    "letter times function": Mul((y, Fn("sin", x))),
    "square of a function": Pow(Fn("sin", x), Num(2)),
    "function of a fraction": Fn("ln", Div(x, y)),
    "decimal": Num(Fraction(981, 100)),
    "large": Num(123456),
    "root of a sum": Sqrt(Add((Pow(x, Num(2)), Pow(y, Num(2))))),
    "bracket": Mul((a, Group(Add((x, y))))),
    "tall bracket": Mul((a, Group(Add((Div(x, y), y))))),
    "rates": equation(Sym("x_dot"), Sym("x_ddot"), Sym("theta_dot"), Sym("omega_1"), Sym("theta_ddot")),
    "scripts": Pow(Sym("v_0"), Num(2)),
    "long index": Sym("I_cm"),
    "vector with index": Vec("R_cm"),
    "fraction of fractions": Div(Div(x, y), Add((Div(a, x), y))),
}
OTHER = Notation(vector="bold", differential="upright", decimal=",")
FORMATS: Mapping[str, Callable[..., str]] = {
    "latex": to_latex, "typst": to_typst, "mathml": to_mathml, "omml": to_omml, "text": to_text, "speech": to_speech,
    "machine": to_machine,
}  # fmt: skip
ALIGNED = ("latex", "typst", "mathml", "omml")


def printed(kind: str) -> dict[str, str]:
    """By name of the formula, in one format."""
    found: dict[str, str] = {}
    for name, node in {**SAMPLES, **MORE}.items():
        found |= _ways(kind, FORMATS[kind], name, node)
    return found


def _ways(kind: str, write: Callable[..., str], name: str, node: Node) -> dict[str, str]:
    """As it is; in another notation, and aligned, where that differs."""
    plain = write(node)
    others = {} if kind in ("machine", "speech") else {"other notation": write(node, OTHER)}
    others |= {"aligned": write(Relations((node,)))} if kind in ALIGNED else {}
    return {name: plain} | {f"{name}, {how}": text for how, text in others.items() if text != plain}


if __name__ == "__main__":
    KEPT.write_text(json.dumps({kind: printed(kind) for kind in FORMATS}, ensure_ascii=False, indent=0) + "\n", encoding="utf-8")
