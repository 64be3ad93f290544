"""LaTeX tokens -> fractions, derivatives, integrals, brackets, limits."""

from __future__ import annotations

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.formal import formal, over_an_index, taken_at
from rbpsym.expr.latex.functions import FUNCTIONS, SIGNS, operand
from rbpsym.expr.latex.grammar import argument, atom, begins_factor, between, expression, factor, goes_on, multiplied
from rbpsym.expr.latex.names import begins_name, read_name, read_symbol
from rbpsym.expr.latex.scripts import label_after
from rbpsym.expr.latex.small import is_material, is_small
from rbpsym.expr.latex.tokens import COLUMN, Token, closed
from rbpsym.expr.symbol_table import COMMANDS, Drawn, LatexReader, begins
from rbpsym.frozen import replace

Limits = tuple[t.Node | str | None, t.Node | str | None]


@begins(r"\frac")
def _fraction(reader: LatexReader) -> t.Node:
    """A fraction, or a derivative if d stands above and below."""
    start = reader.take().start
    if reader.table.open and is_material(reader):
        return formal(reader, start, "material", argument(reader), argument(reader))
    num = _with_differential(reader)
    if num is None and (derivative := _derivative(reader, start)):
        return derivative
    num = argument(reader) if num is None else num
    below = _by_index(argument(reader)) if isinstance(num, t.Formal) else argument(reader)
    return reader.spanned(t.Div(num, below), start)


def _with_differential(reader: LatexReader) -> t.Node | None:
    """The numerator {f dx} of an integrand, the differential kept aside; None (and nothing passed) if it is another one."""
    begin = reader.position
    if not reader.integrals or reader.path is not None or not reader.pass_sign("{"):
        return None
    try:
        found: t.Node = t.ONE if reader.sees_differential() else multiplied(reader)
        path = _differential(reader) if reader.sees_differential() else None
    except RbpsymError:
        path = None
    if path is None or not reader.pass_sign("}") or (found is t.ONE and reader.sees_sign("{") and reader.sees_differential(1)):
        reader.position = begin
        return None
    reader.path = path
    return found


def _derivative(reader: LatexReader, start: int) -> t.Node | None:
    """A derivative, if the fraction is one; else nothing is passed."""
    if not (reader.sees_sign("{") and reader.sees_differential(1)):
        return None
    begin = reader.position
    _mark_below(reader)
    reader.take()
    if slashed_derivative(reader) is not None:  # (∂z/∂x)/(∂z/∂y)
        reader.position = begin
        return None
    partial = reader.take().text == "∂"
    order = 0 if reader.sees_sign("_") else _order(reader)
    of = None if reader.sees_sign("}") or not order else expression(reader)
    small = of is not None and any(map(is_small, t.walk(of)))  # dx dy
    if not order or small or not (reader.pass_sign("}") and reader.sees_differential(1)) or reader.ahead(2).text == "(":
        reader.position = begin  # the fraction of a length d, or of a differential
        return None
    place = reader.position
    if (parts := _below(reader, order)) is None and of is None:  # ∂/∂x^μ in front of what it stands for
        reader.position = place
        below = _by_index(argument(reader)) if order == 1 else argument(reader)
        return formal(reader, start, "differential", operand(reader) if begins_factor(reader) else t.Word(""), below)
    if parts is None:
        reader.position = begin
        return None
    if of is None:
        of = _operated(reader, start)
    for wrt, times in reversed(parts):
        of = reader.spanned(t.Deriv(of, wrt, times, partial), start)
    return of


def _mark_below(reader: LatexReader) -> None:
    """The d below a differential is one too, also before a function: dσ/(d cos θ)."""
    place = closed(reader.tokens, reader.position) + 2
    if place < len(reader.tokens) and reader.tokens[place].text == "d" and reader.tokens[place + 1].text in FUNCTIONS:
        reader.tokens = (*reader.tokens[:place], replace(reader.tokens[place], kind="differential"), *reader.tokens[place + 1 :])


def _operated(reader: LatexReader, start: int) -> t.Node:
    """What d/dt in front stands for; the operator alone where nothing follows."""
    return operand(reader) if begins_factor(reader) else t.Formal("operator", span=(start, reader.previous_end))


def _by_index(below: t.Node) -> t.Node:
    """∂x^2 below a ∂: x^2 is a coordinate."""
    if not (isinstance(below, t.Pow) and isinstance(below.base, t.Formal) and below.base.kind == "differential"):
        return below
    return replace(below.base, parts=(t.Formal("raised", (below.base.parts[0], below.exponent)),))


@begins("d/")
def slashed_derivative(reader: LatexReader) -> t.Node | None:
    """dω/dt in a line, if it stands here; else nothing is passed."""
    start, token = reader.position, reader.token
    if reader.integrals or not reader.sees_differential():
        return None
    partial = reader.take().text == "∂"
    alone = reader.sees_sign("/")
    of = read_name(reader) if begins_name(reader.token) else None
    if (of is None and not alone) or not reader.pass_sign("/") or not reader.sees_differential():
        reader.position = start
        return None
    reader.take()
    wrt = "t" if _is_time(reader) else read_symbol(reader)
    of = _operated(reader, token.start) if of is None else of
    return reader.spanned(t.Deriv(of, wrt, 1, partial), token.start)


def _order(reader: LatexReader) -> int:
    """The order after the d: 1, or the number that ^ says, 0 for one that is none from 1 to 9."""
    if not reader.pass_sign("^"):
        return 1
    order = argument(reader)
    return order.value if isinstance(order, t.Num) and isinstance(order.value, int) and 1 <= order.value <= 9 else 0


def _below(reader: LatexReader, order: int) -> list[tuple[str, int]] | None:
    """What stands in the denominator dx^m dy^n; None for a vector or an index above. Raises ReadError if it doesn't fit above."""
    opening, found = reader.token, list[tuple[str, int]]()
    reader.expect("{")
    while not found or not reader.sees_sign("}"):
        if not reader.sees_differential():
            raise reader.error("a d is expected here, as in the numerator")
        reader.take()
        token = reader.token
        wrt = "t" if _is_time(reader, "}", "^") else _variable(reader)
        times = _order(reader)
        if not wrt or not times:
            return None
        found.append((wrt, times))
    above = sum(times for _, times in found)
    if above > order == len(found) and found[0][0] != "t":
        return None  # by a coordinate x^2
    if above != order:
        raise reader.error("the orders above and below are different", "", token)
    reader.expect("}", opening)
    return found


def _variable(reader: LatexReader) -> str:
    """The name of a symbol; "" for a vector and what else nothing is derived by."""
    braces = reader.pass_sign("{")
    node = read_name(reader) if begins_name(reader.token) else None
    return node.name if isinstance(node, t.Sym) and (not braces or reader.pass_sign("}")) else ""


def _is_time(reader: LatexReader, *behind: str) -> bool:
    """Pass a plain t (with one of these behind it); was it there?"""
    found = reader.token.kind == "letter" and reader.token.text == "t"
    found = found and (not behind or reader.ahead().text in behind)
    reader.position += found
    return found


@begins(r"\int")
def _integral(reader: LatexReader) -> t.Node:
    """An integral with its differential first or last."""
    start = reader.take()
    limits = _limits(reader)
    if reader.sees_differential():
        path, sign = _differential(reader), ""
        if reader.sees_sign(r"\cdot", r"\times"):
            sign = reader.take().text
        whole = multiplied(reader) if _has_integrand(reader) or goes_on(reader) else t.ONE
        return reader.spanned(_integrated(reader, start, whole, sign, path, limits), start.start)
    begin, around, reader.path = reader.position, reader.path, None
    reader.integrals += 1
    integrand = expression(reader) if reader.sees_sign("-") else multiplied(reader)
    if reader.path is None and reader.sees_sign("+", "-"):
        reader.position = begin
        integrand = expression(reader)
    reader.integrals -= 1
    sign = reader.take().text if reader.sees_sign(r"\cdot", r"\times") else ""
    found, reader.path = reader.path, around
    bare = reader.table.open and not reader.sees_differential() and not reader.sees_sign("+", "-")
    if found is None and (bare or any(map(is_small, t.walk(integrand)))):
        return formal(reader, start.start, "integral", integrand, *(end for end in limits if isinstance(end, t.Node)))
    if found is None and not reader.sees_differential():
        raise reader.error("the integral has no differential", "Write dθ at its end.", start)
    path = _differential(reader) if found is None else found
    if reader.sees_differential() and not reader.integrals:  # of several variables, by one sign
        paths = [path]
        while reader.sees_differential():
            paths.append(_differential(reader))
        ends = (end for end in limits if isinstance(end, t.Node))
        parts = (t.Formal("differential", (one,)) for one in paths)
        return formal(reader, start.start, "integral", t.Mul((integrand, *parts)), *ends)
    return reader.spanned(_integrated(reader, start, integrand, sign, path, limits), start.start)


def _has_integrand(reader: LatexReader) -> bool:
    """Does anything follow dθ?"""
    ends = ("sign", "row", "end", "begin")
    return reader.token.kind not in ends or reader.sees_sign("(", "[", "{", "|")


def _limits(reader: LatexReader) -> Limits:
    """(lower limit or the name of a region, upper limit); None for what is absent."""
    found: dict[str, t.Node | str] = {}
    while reader.sees_sign("_", "^") and reader.token.text not in found:
        sign = reader.take().text
        found[sign] = (_region(reader) if sign == "_" else None) or _limit_of(reader)
    return found.get("_"), found.get("^")


def _limit_of(reader: LatexReader) -> t.Node:
    """A limit; θ = 0 stays an equation, until it is seen that θ is what is integrated over."""
    start = reader.token.start
    var, value = _end(reader)
    return value if var is None else reader.spanned(t.relation(t.Sym(var), "=", value), start)


def _value_at(reader: LatexReader, limit: t.Node | str | None, path: t.Node) -> t.Node | str | None:
    """The limit's value. Raises ReadError if it is that of another variable."""
    if not isinstance(limit, t.Chain):
        return limit
    if not (isinstance(path, t.Sym) and limit.items[0] == path):
        raise reader.source.error("this limit is that of another variable", *(limit.span or (0, 1)), "Name the one behind d.")
    return limit.items[1]


def _region(reader: LatexReader) -> str | None:
    """The name of a region: Ω, upright, or a capital letter that is no symbol; "path" for 𝒞 or 𝒞_i, the path itself.

    None (and nothing passed) if it is a limit.
    """
    begin, braces = reader.position, reader.pass_sign("{")
    token, texts = reader.token, [reader.ahead(count).text for count in range(3)]
    alone = texts[1] != "^" and (texts[1] != "}" or reader.ahead(2).text != "^")
    free = token.text.isupper() and Drawn(token.text) not in reader.table.names and alone
    is_path = token.text == r"\mathcal" and "C" in texts[1:]
    if not (is_path or token.kind == "text" or (token.kind == "letter" and (free or token.text == "Ω"))):
        reader.position = begin
        return None
    text = {"Ω": "Omega"}.get(token.text, token.text)
    reader.position += 1 if not is_path else 4 if texts[1] == "{" else 2
    label = label_after(reader) if (is_path or token.kind == "text") and reader.sees_sign("_") else ""
    if not braces or reader.pass_sign("}"):
        return "path" if is_path else f"{text}_{label}" if label else text
    reader.position = begin
    return None


def _differential(reader: LatexReader) -> t.Node:
    """What stands after the d: a symbol, a vector, or a parenthesis; `m` for a mass element."""
    start = reader.take().start
    if reader.pass_sign("^"):  # d³r
        order = argument(reader)
        return reader.spanned(t.Formal("differential", (factor(reader), order)), start)
    token = reader.token
    if reader.sees_sign("(", "{"):
        found = between(reader, ")" if reader.sees_sign("(") else "}")
    elif begins_name(token):
        mass = token.text == "m" and reader.ahead().text not in ("_", "'")
        found = reader.spanned(t.Sym("m"), reader.take().start) if mass else read_name(reader)
    elif reader.sees_sign(COLUMN):
        found = atom(reader)
    else:
        raise reader.error("a symbol is expected after d", "", token)
    texts = [reader.ahead(k).text for k in range(4)]
    of_way = texts[0] == "[" and texts[2] == "]" and texts[3] and texts[3] not in SIGNS
    return COMMANDS["called"](reader, found) if of_way else found  # dμ[c] of a way c


def _integrated(reader: LatexReader, start: Token, integrand: t.Node, sign: str, path: t.Node, limits: Limits) -> t.Node:
    """The integral that a sign, a differential and limits make."""
    reader.over = getattr(path, "name", "")
    lower, upper = limits = _value_at(reader, limits[0], path), _value_at(reader, limits[1], path)
    joined = {r"\cdot": t.Dot, r"\times": t.Cross}.get(sign, lambda *factors: t.Mul(factors))
    whole = joined(integrand, t.Formal("differential", (path,)))
    parts = (whole, *(t.Word(end) if isinstance(end, str) else end for end in limits if end is not None))
    product = {r"\cdot": "dot", r"\times": "cross", "": "times"}[sign]
    if isinstance(lower, str) and lower != "path" and (len(lower) > 1 or path == t.Sym("m")):
        return _over_body(integrand, product, path, lower)
    if lower is None or lower == "path":
        if upper is not None:
            return t.Formal("integral", parts)
        return t.PathIntegral(integrand, path, product)
    if upper is None or isinstance(lower, str) or isinstance(upper, str) or not isinstance(path, (t.Sym, t.Vec)):
        return t.Formal("integral", parts)
    if isinstance(path, t.Vec):
        if not _is_angle(reader, path):
            return t.Formal("path", parts)
        integrand = t.Dot(integrand, t.Unit("z"))
    return t.Integral(integrand, path.name, lower, upper)


def _is_angle(reader: LatexReader, path: t.Vec) -> bool:
    """Is it a Greek letter, a turn about the normal of the plane; a Latin one is a way in the plane."""
    begin, end = path.span or (0, 0)
    letters = (token.text for token in reader.tokens if begin <= token.start < end and token.kind == "letter")
    return any(not letter.isascii() and letter != "ℓ" for letter in letters)


def _over_body(integrand: t.Node, product: str, path: t.Node, body: str) -> t.Node:
    """∫ f dm, or ∫ a × db = ∫ a × (db/dm) dm."""
    if path == t.Sym("m"):
        return t.BodyIntegral(integrand, body)
    density = t.Deriv(path, "m")
    if product == "cross":
        return t.BodyIntegral(t.Cross(integrand, density), body)
    joined = t.Dot(integrand, density) if product == "dot" else t.mul(integrand, density)
    return t.BodyIntegral(joined, body)


@begins(r"\lim")
def _limit(reader: LatexReader) -> t.Node:
    start, begin = reader.take().start, reader.position
    try:
        reader.expect("_")
        opening = reader.token
        reader.expect("{")
        var = read_symbol(reader)
        if not reader.pass_sign(r"\to"):
            raise reader.error(r"“\to” is expected here")
        to = expression(reader)
        reader.expect("}", opening)
    except RbpsymError:
        reader.position = begin
        return over_an_index(reader, "limit", start)
    return reader.spanned(t.Limit(multiplied(reader), var, to), start)


@begins("[")
def _bracket(reader: LatexReader) -> t.Node:
    """[f] with limits is taken between them; without, it is a parenthesis, or a unit where a name stands alone."""
    before, start = reader.tokens[reader.position - 1], reader.token.start
    node = between(reader, "]")
    alone = all(one.kind in ("row", "end") or one.text in SIGNS for one in (before, reader.token))
    alone = alone or (reader.table.open and not reader.sees_sign("_"))
    if alone and isinstance(node.base if isinstance(node, t.Pow) else node, (t.Sym, t.Vec)):
        return reader.spanned(t.Formal("unit", (node,)), start)
    if isinstance(node, t.Formal) or not reader.sees_sign("_"):
        return node
    place = reader.position
    reader.take()
    try:
        lower_var, lower = _end(reader)
    except RbpsymError:
        lower_var, lower = None, t.ZERO
    if not reader.pass_sign("^"):
        reader.position = place
        taken = lower_var is not None
        return taken_at(reader, node, start) if taken else formal(reader, start, "marked", node, t.Word(label_after(reader)))
    upper_var, upper = _end(reader)
    var = upper_var or lower_var or _taken_over(reader, t.names(node) - {"pi"}, upper)
    if var is None or (lower_var or var) != var:
        return formal(reader, start, "between", node, lower, upper)
    return reader.spanned(t.Bracket(node, var, lower, upper), start)


def _taken_over(reader: LatexReader, inside: set[str], upper: t.Node) -> str | None:
    """Of which name limits are that do not say it: of the integral before, of the upper limit θ, or the only one there is.

    Speeds are functions of where one is: ½ θ̇² may be taken between places.
    """
    varies = reader.table.varies
    above = upper.name if isinstance(upper, t.Sym) and (varies is None or varies(upper.name)) else ""
    sole = filter(varies, inside) if varies and len(inside) == 1 else ()
    moves = {above} if above and any(name.endswith("_dot") for name in inside) else set()
    return next((name for name in (reader.over, above, *sole) if name in inside | moves), None)


def _end(reader: LatexReader) -> tuple[str | None, t.Node]:
    """(variable or None, value) of a limit `θ = 0` or `0`."""
    opening = reader.token
    if not reader.pass_sign("{"):
        return None, argument(reader)
    value, var = expression(reader), None
    if isinstance(value, t.Sym) and reader.pass_sign("="):
        var, value = value.name, expression(reader)
    reader.expect("}", opening)
    return var, value


@begins(r"\left.")
def _at(reader: LatexReader) -> t.Node:
    """\\left. f \\right|_{condition}"""
    start, depth, texts = reader.token.start, 0, iter(reader.tokens[reader.position + 1 :])
    closing = r"\rvert"
    for token in texts:
        depth += (token.text in ("(", "[", "{")) - (token.text in (")", "]", "}"))
        if depth < 0 or (token.text == closing and not depth):
            closing = token.text if token.text in (")", "]") else closing  # \left. f \right)_0
            break
    return taken_at(reader, between(reader, closing), start)
