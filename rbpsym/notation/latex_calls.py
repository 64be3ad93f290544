"""LaTeX tokens -> relations (a = b = c, 0 < x); and what depends on what.

x(t) and V(θ) are no products, and d/dt in front of a product is of all of it. Decided by what the symbols are declared
to be (`SymbolTable.varies`) and by dimensions; else refused.
"""

from __future__ import annotations

from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.latex_grammar import begins_factor, ends_integrand, expression, factor, refuse_number
from rbpsym.notation.latex_names import begins_name, read_name
from rbpsym.notation.symbol_table import Reader, begins

SIGNS = {
    "=": "=", "<": "<", ">": ">", r"\le": "<=", r"\ge": ">=", r"\ne": "!=", r"\approx": "~",
    r"\to": "->",
}  # fmt: skip


def relation(reader: Reader) -> t.Node:
    """A chain, or an expression alone."""
    start = reader.token.start
    return reader.spanned(chained(reader, [expression(reader)], []), start)


def chained(reader: Reader, items: list[t.Node], ops: list[str]) -> t.Node:
    """The chain that goes on with the signs that follow."""
    while reader.sees_sign(*SIGNS):
        ops.append(SIGNS[reader.take().text])
        items.append(expression(reader))
    return t.Chain(tuple(items), tuple(ops)) if ops else items[0]


MOST_ASKED = 6  # of such questions in a formula; behind them, what varies is a function
_CALLED = "is this a product, or a value of a function?"
_WRITE = r"Say in the symbols what all of it means, or write a product without the parenthesis."


@begins("f()")
def called(reader: Reader) -> t.Node:
    """A name; in x(t) and V(θ, φ) it is a function of these, and stands for its value there."""
    name = read_name(reader)
    if not isinstance(name, (t.Sym, t.Vec)) or not reader.sees_sign("("):
        return name
    varies, begin, opening = _varies(reader, name), reader.position, reader.token
    found = _arguments(reader)
    end, reader.position = reader.position, begin
    if found is None or (varies is False and found != [t.ZERO]):
        return name
    if len(found) == 1 and (isinstance(found[0], t.Num) or _varies(reader, found[0]) is False):
        raise reader.error(_CALLED, _WRITE, opening)
    clear = len(found) > 1 or found[0] is _TIME or (varies and len(reader.met) >= MOST_ASKED)
    if clear or reader.decide(_CALLED, _WRITE, yes=int(varies is True)) == (varies is None):
        reader.position = end
    return name


_TIME = t.Sym("t")


def _varies(reader: Reader, node: t.Node) -> bool | None:
    """Is it no constant? None where nothing is known."""
    if node is _TIME or reader.table.varies is None:
        return True if node is _TIME else None
    return any(reader.table.varies(name) for name in t.names(node) - {"pi"})


def _arguments(reader: Reader) -> list[t.Node] | None:
    """Names with commas between them, the time, or a number, in parentheses, which are passed; None for anything else."""
    found: list[t.Node] = []
    while reader.pass_sign(*((",",) if found else ("(",))):
        argument = _argument(reader)
        if argument is None:
            return None
        found.append(argument)
    return found if found and reader.pass_sign(")") else None


def _argument(reader: Reader) -> t.Node | None:
    token, digits = reader.token, ""
    while reader.token.kind == "digit":
        digits += reader.take().text
    if digits:
        return t.Num(int(digits))
    if not begins_name(token):
        return None
    try:
        return read_name(reader)
    except RbpsymError:
        is_time = token.kind == "letter" and token.text == "t" and reader.tokens[reader.position - 1] is token
        return _TIME if is_time else None


def operand(reader: Reader) -> t.Node:
    r"""What \frac{d}{dt} in front stands for: a factor in parentheses, or the whole product side by side.

    Raises ReadError where it matters which of several factors that change is meant.
    """
    start, closed = reader.token, reader.sees_sign("(", "[", "{", r"\{")
    factors = [factor(reader)]
    while not closed and begins_factor(reader):
        refuse_number(reader)
        factors.append(factor(reader))
    several = len([node for node in factors if _varies(reader, node) is not False and t.names(node) - {"pi"}]) > 1
    goes_on = not closed and reader.sees_sign("/", r"\cdot", r"\times", "*") and not ends_integrand(reader)
    if several or goes_on:
        what = "how much of this product does the derivative stand for?"
        raise reader.error(what, r"Write \frac{d}{dt}(a b), or \frac{da}{dt} b.", start)
    return factors[0] if len(factors) == 1 else reader.spanned(t.Mul(tuple(factors)), start.start)
