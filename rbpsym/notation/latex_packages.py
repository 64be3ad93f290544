"""LaTeX tokens -> what packages write: derivatives of `physics`, numbers of `siunitx`; what has no value is refused by name."""

from __future__ import annotations

from rbpsym.notation import tree as t
from rbpsym.notation.latex_functions import operand, whole_number
from rbpsym.notation.latex_grammar import DEGREE, argument, between
from rbpsym.notation.latex_names import read_symbol
from rbpsym.notation.symbol_table import LatexReader, begins


@begins(r"\dv", r"\pdv")
def _derivative(reader: LatexReader) -> t.Node:
    r"""\dv{f}{x}, \dv[2]{f}{x}, and \dv{t} in front of what it stands for; \pdv{f}{x}{y} too."""
    head = reader.take()
    reader.pass_sign("*")
    order = _option(reader)
    begin = reader.position
    of = argument(reader)
    parts: list[str] = []
    while reader.sees_sign("{") and len(parts) < (1 if order > 1 or head.text == r"\dv" else 3):
        parts.append(_variable(reader))
    if not parts:
        reader.position = begin
        parts.append(_variable(reader))
        of = operand(reader)
    for wrt in reversed(parts):
        of = reader.spanned(t.Deriv(of, wrt, order, head.text == r"\pdv"), head.start)
    return of


def _option(reader: LatexReader) -> int:
    """The order in brackets, 1 without."""
    if not reader.sees_sign("["):
        return 1
    return whole_number(reader, "the order of a derivative", 1, 9)


def _variable(reader: LatexReader) -> str:
    time = [reader.ahead(count).text for count in range(3)] == ["{", "t", "}"]
    reader.position += 3 * time
    return "t" if time else read_symbol(reader)


@begins(r"\abs", r"\norm", r"\vqty")
def _magnitude(reader: LatexReader) -> t.Node:
    start = reader.take().start
    reader.pass_sign("*")
    return reader.spanned(t.Abs(argument(reader)), start)


@begins(r"\num", r"\ang")
def _number(reader: LatexReader) -> t.Node:
    head = reader.take()
    found = argument(reader)
    return reader.spanned(t.mul(found, DEGREE), head.start) if head.text == r"\ang" else found


@begins(r"\overset", r"\underset", r"\stackrel")
def _over_a_sign(reader: LatexReader) -> t.Node:
    raise reader.error("a mark over a sign or symbol can't be read", "Write the sign or symbol alone.")


@begins(r"\underbrace", r"\overbrace")
def _braced(reader: LatexReader) -> t.Node:
    """What stands over or under the brace; its name is in words or another symbol."""
    mark = "_" if reader.take().text == r"\underbrace" else "^"
    opening = reader.token
    reader.expect("{")
    reader.position -= 1
    found = between(reader, "}")
    if reader.pass_sign(mark):
        words = argument(reader)
        if any(not isinstance(part, (t.Word, t.Mul)) for part in t.walk(words)):
            raise reader.error("what is named by this brace is another formula", "Write it alone.", opening)
    return found


_UNITS = "a number with a unit can't be decided", "Claim the formula in symbols."
_DOTS = "dots stand for terms that nobody can compute", "Write all terms, or a sum over an index."
_ONE = "this stands for two formulas", "Write the sign that is meant."
_NONE = "this says nothing that can be computed", "Write an equation."
_PATH = "an integral over a closed path or several variables can't be read", "Write it as one integral, or what it comes to."
REFUSED = {
    **dict.fromkeys((r"\SI", r"\qty", r"\si", r"\unit", r"\SIrange", r"\qtyrange"), _UNITS),
    **dict.fromkeys((r"\ldots", r"\cdots", r"\dots", r"\vdots", r"\ddots", r"\dotsc", r"\dotsb"), _DOTS),
    **dict.fromkeys((r"\pm", r"\mp"), _ONE),
    **dict.fromkeys((r"\propto", r"\sim", r"\ll", r"\gg", r"\in", r"\forall", r"\exists", r"\lesssim", r"\gtrsim"), _NONE),
    **dict.fromkeys((r"\oint", r"\iint", r"\iiint", r"\prod"), _PATH),
    r"\infty": ("infinity is no value", r"Write a limit, \lim_{x \to ...}, or a number."),
    r"\langle": ("a mean value can't be read", "Give it a symbol of its own."),
    r"\nabla": ("a gradient can't be computed", "Write its components."),
    r"\grad": ("a gradient can't be computed", "Write its components."),
    r"\cancel": ("what is crossed out can't be read", "Leave it out."),
}


@begins(*REFUSED)
def _refused(reader: LatexReader) -> t.Node:
    what, instead = REFUSED[reader.token.text]
    raise reader.error(f"“{reader.token.text}”: {what}", instead)
