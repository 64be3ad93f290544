"""What stands for Typst's signs, names and functions in LaTeX; those of the package physica too."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

UNBALANCED = r"\unbalanced "
_NUMBERED = re.compile(r"[1-9]")
_SUM = re.compile(r"[-+=<>&]")


def _braced(side: str, mark: str, *given: str) -> str:
    """A brace, perhaps with its name."""
    named = "".join(f"{mark}{{{name}}}" for name in given[1:])
    return rf"\{side}brace{{{given[0]}}}{named}" if len(given) < 3 else UNBALANCED


def _derivative(sign: str, of: str, *by: str) -> str:
    """Of nothing, in front of what it stands for; by several variables, or by one so many times."""
    variables, order = (by[:-1], by[-1]) if len(by) > 1 and _NUMBERED.fullmatch(by[-1]) else (by, "")
    if not variables or (order and len(variables) > 1):
        return UNBALANCED
    power = order or (str(len(variables)) if len(variables) > 1 else "")
    raised = f"^{{{power}}}" if power else ""
    below = " ".join(f"{sign} {variable}" for variable in variables)
    return rf"\frac{{{sign}{raised} {of}}}{{{below}{f'^{{{order}}}' if order else ''}}}"


def _differentials(*of: str) -> str:
    """d x d y; d^3 r."""
    if len(of) == 2 and _NUMBERED.fullmatch(of[1]):
        return rf"\mathrm{{d}}^{{{of[1]}}} {of[0]}"
    return UNBALANCED if any("[" in one for one in of) else " ".join(rf"\mathrm{{d}} {one}" for one in of)


def _in_bold(body: str) -> str:
    """In bold, a letter is a vector; a whole relation is but shown so."""
    return body if _SUM.search(body) else rf"\boldsymbol{{{body}}}"


def _before(sign: str, *of: str) -> str:
    return UNBALANCED if len(of) > 1 or _SUM.search(of[0]) else f"{sign} {of[0]}"


def _state(*of: str) -> str:
    return r"\braket{" + "|".join(of) + "}"


SIGNS = {
    "<=>": r"\Leftrightarrow ", "<==>": r"\Leftrightarrow ", "=>": r"\Rightarrow ", "==>": r"\Rightarrow ", "->": r"\to ",
    "-->": r"\to ", "|->": r"\mapsto ", "<-": r"\leftarrow ", "<--": r"\leftarrow ", "<==": r"\Leftarrow ",
    "<->": r"\leftrightarrow ", "<=": r"\le ", ">=": r"\ge ", "!=": r"\ne ", "<<": r"\ll ", ">>": r"\gg ", "||": r"\|",
    "::=": ":=", "...": r"\dots ", "*": r"\ast ", "{": r"\{", "}": r"\}", "%": r"\%", "#": r"\# ", "~": r"\sim ",
}  # fmt: skip
NAMES = {
    "dot": r"\cdot", "dot.op": r"\cdot", "dot.c": r"\cdot", "times": r"\times", "eq.not": r"\ne", "lt.eq": r"\le",
    "gt.eq": r"\ge", "eq.def": ":=", "plus.minus": r"\pm", "plus": "+", "minus": "-", "minus.plus": r"\mp", "arrow.r": r"\to",
    "arrow.r.double": r"\Rightarrow", "infinity": r"\infty", "oo": r"\infty", "integral": r"\int",
    "partial": r"\partial", "diff": r"\partial", "dif": r"\mathrm{d}", "wide": r"\qquad", "thin": r"\,", "med": r"\:",
    "thick": r"\;", "degree": r"^\circ", "planck.reduce": r"\hbar", "prop": r"\propto", "dots.h": r"\dots",
    "dots.c": r"\cdots", "cross": r"\times", "angle": r"\angle", "tilde.op": r"\sim", "tilde": r"\sim", "bar": "|",
    "bar.v": "|", "bar.v.double": r"\|", "space": r"\ ", "space.quad": r"\quad", "product": r"\prod", "approx.eq": r"\approx",
    "tilde.eq": r"\approx", "tilde.equiv": r"\approx", "arrow.r.long": r"\to", "arrow.r.double.long": r"\Rightarrow",
    "arrow.l.r.double": r"\Leftrightarrow", "arrow.l.r.double.long": r"\Leftrightarrow", "lt.double": r"\ll", "gt.double": r"\gg",
    "integral.double": r"\iint", "integral.triple": r"\iiint", "integral.cont": r"\oint", "compose": r"\circ",
    "angle.l": r"\langle", "angle.r": r"\rangle", "chevron.l": r"\langle", "chevron.r": r"\rangle", "in.not": r"\notin",
    "union": r"\cup", "inter": r"\cap", "subset.eq": r"\subseteq", "and": r"\land", "or": r"\lor", "without": r"\setminus",
    "dots": r"\dots", "dots.v": r"\vdots", "dots.down": r"\ddots", "dotless.i": r"\imath", "dotless.j": r"\jmath",
    "grad": r"\nabla", "curl": r"\nabla \times", "laplacian": r"\nabla^2", "dprod": r"\cdot", "cprod": r"\times",
    "times.o": r"\otimes", "plus.o": r"\oplus", "dot.o": r"\odot", "arrow.l.r": r"\leftrightarrow",
    "arrow.long": r"\to", "union.big": r"\bigcup", "inter.big": r"\bigcap", "div": r"\nabla\cdot",
    "TT": r"\mathsf{T}", "slash": "/",
}  # fmt: skip
CALLS: dict[str, str | Callable[..., str]] = {
    "frac": r"\frac{%s}{%s}", "sqrt": r"\sqrt{%s}", "root": r"\sqrt[%s]{%s}", "dot": r"\dot{%s}",
    "dot.double": r"\ddot{%s}", "dot.triple": r"\dddot{%s}", "arrow": r"\vec{%s}", "hat": r"\hat{%s}",
    "tilde": r"\tilde{%s}", "macron": r"\bar{%s}", "overline": r"\bar{%s}", "bold": _in_bold,
    "cal": r"\mathcal{%s}", "italic": "{%s}", "upright": r"\mathrm{%s}", "abs": r"\left|%s\right|",
    "norm": r"\left\|%s\right\|", "lr": "%s", "display": "%s", "inline": "%s", "cancel": r"\cancel{%s}",
    "op": r"\operatorname{%s}", "diaer": r"\ddot{%s}", "underline": r"\underline{%s}", "bb": r"\mathbb{%s}", "mid": "%s",
    "frak": r"\mathfrak{%s}", "sans": r"\mathsf{%s}", "serif": "%s", "limits": "%s", "scripts": "%s", "binom": r"\binom{%s}{%s}",
    "breve": r"\breve{%s}", "acute": r"\acute{%s}", "circle": r"\mathring{%s}",
    **dict.fromkeys(("underbrace", "underbracket", "underparen"), partial(_braced, "under", "_")),
    **dict.fromkeys(("overbrace", "overbracket", "overparen"), partial(_braced, "over", "^")),
    # what the package physica adds
    "vb": r"\boldsymbol{%s}", "va": r"\vec{%s}", "vu": r"\hat{%s}", "evaluated": r"\left.%s\right|", "order": r"\mathcal{O}(%s)",
    "expval": r"\langle %s\rangle ", "dv": partial(_derivative, r"\mathrm{d}"),
    "pdv": partial(_derivative, r"\partial"), "dd": _differentials, "ket": r"\ket{%s}", "bra": r"\bra{%s}",
    **dict.fromkeys(("ketbra", "braket", "mel"), _state),
    "var": partial(_before, r"\delta"), "difference": partial(_before, r"\Delta"),
}  # fmt: skip
ROWS = {"vec": "pmatrix", "mat": "pmatrix", "cases": "cases"}
