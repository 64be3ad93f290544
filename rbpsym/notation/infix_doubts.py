"""Where typed infix can be read in two ways: which factor a bar or a function takes in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rbpsym.notation import tree as t
from rbpsym.notation.infix_names import Reader, function_named


def stands_apart(reader: Reader) -> bool:
    """Does a function follow, or a parenthesis behind a blank, which one hardly takes for a part of a denominator?"""
    return is_call(reader) or (reader.sees("(") and reader.token.spaced)


def is_settled(node: t.Div, reader: Reader) -> bool:
    """Was the quotient, or what stands below its bar, written in parentheses?"""
    text, (start, end) = reader.source.text, node.den.span or (0, 0)
    below = text[:start].rstrip().endswith(("(", "[")) and text[end:].lstrip().startswith((")", "]"))
    return _is_closed(node, reader) or below or text[start : start + 1] in ("(", "[")


def _is_closed(node: t.Node, reader: Reader) -> bool:
    """Was the node written in parentheses?"""
    return bool(node.span) and reader.source.text[node.span[1] :].lstrip().startswith((")", "]"))


def is_bare_call(node: t.Node, reader: Reader) -> bool:
    """Does the node end with a function whose argument has no parentheses?"""
    if isinstance(node, (t.Mul, t.Neg)):
        return is_bare_call(node.factors[-1] if isinstance(node, t.Mul) else node.arg, reader)
    node, end = (node.base, node.base.span) if isinstance(node, t.Pow) else (node, None)
    text = reader.source.text[: end[1] if end else reader.previous_end].rstrip()
    return isinstance(node, t.Fn) and not text.endswith((")", "]", "|"))


def in_last_argument(node: t.Node, change: Callable[[t.Node], t.Node]) -> t.Node:
    """The node with the argument of the function changed that it ends with."""
    if isinstance(node, t.Mul):
        return replace(node, factors=(*node.factors[:-1], in_last_argument(node.factors[-1], change)))
    if isinstance(node, t.Pow):
        return replace(node, base=in_last_argument(node.base, change))
    if isinstance(node, t.Neg):
        return replace(node, arg=in_last_argument(node.arg, change))
    return replace(node, arg=change(node.arg))


def is_call(reader: Reader) -> bool:
    """Does the name of a function follow?"""
    return function_named(reader.token, reader) is not None
