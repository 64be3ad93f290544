"""The names in a typed formula: functions, symbols, the sentence for an unknown name; what can be read in two ways."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from types import MappingProxyType

from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.infix_tokens import Token
from rbpsym.notation.source import Cursor


def _fn(name: str) -> Callable[[t.Node], t.Node]:
    return lambda arg: t.Fn(name, arg)


FUNCTIONS: Mapping[str, Callable[[t.Node], t.Node]] = MappingProxyType({
    **{name: _fn(name) for name in ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos",
                                    "atan", "exp", "ln")},
    "log": _fn("ln"), "arcsin": _fn("asin"), "arccos": _fn("acos"), "arctan": _fn("atan"),
    "sen": _fn("sin"), "tg": _fn("tan"), "ctg": _fn("cot"), "cotg": _fn("cot"), "cosec": _fn("csc"),
    "arcsen": _fn("asin"), "arctg": _fn("atan"),
    "sqrt": t.Sqrt, "abs": t.Abs,
})  # fmt: skip


@dataclass(slots=True)
class Reader(Cursor[Token]):
    """A cursor with the symbols, functions and aliases of a problem.

    `script` says what to choose at the places that can be read in two ways (False behind its end; None: the usual
    reading where there is one, else refuse them), `met` their errors, `parted` what was chosen where this changes what
    is multiplied and what divided. `plain`: no other than the usual reading, where there is one. `bars`: a | would close.
    """

    symbols: frozenset[str] = frozenset()
    functions: Mapping[str, Callable[[t.Node], t.Node]] = field(default_factory=lambda: FUNCTIONS)
    aliases: Mapping[str, str] = field(default_factory=dict)
    script: tuple[bool, ...] | None = None
    met: list[RbpsymError] = field(default_factory=list)
    parted: tuple[bool, ...] = ()
    plain: bool = False
    bars: bool = False

    def decide(self, what: str, instead: str, *, changes_value: bool = False, usual: bool = False) -> bool:
        """Which of two readings to take at the next token; `usual`: the first is what one writes. Raises ReadError."""
        error = self.error(what, instead)
        if usual and (self.script is None or self.plain):
            return False
        if self.script is None:
            raise error
        chosen = len(self.met) < len(self.script) and self.script[len(self.met)]
        self.met.append(error)
        self.parted += (chosen,) if changes_value else ()
        return chosen


def symbol_named(token: Token, reader: Reader) -> str | None:
    """The symbol of the problem that a token names, by its own name or an alias."""
    spellings = (*token.names, *_squeezed(token), *_spread(token))
    names = [reader.aliases.get(name, name) for name in spellings]
    return next((name for name in names if name in reader.symbols), None)


def _squeezed(token: Token) -> tuple[str, ...]:
    """ω₁ may also be omega1."""
    return tuple(name.replace("_", "") for name in token.names if name != token.text)


def _spread(token: Token) -> tuple[str, ...]:
    """v0 and theta0 may also be v_0 and theta_0."""
    return tuple(f"{found[1]}_{found[2]}" for name in token.names if (found := _NUMBERED.fullmatch(name)))


_NUMBERED = re.compile(r"([A-Za-z]+)(\d+)")


def function_named(token: Token, reader: Reader) -> str | None:
    """The function that a name calls, its aliases included; None if it is no function."""
    found = token.kind == "name" and token.text in reader.functions
    return token.text if found and token.text not in reader.symbols else None


def unknown(token: Token, reader: Reader) -> RbpsymError:
    """The error for a name that the problem doesn't have."""
    known = sorted(reader.symbols | set(reader.aliases))
    pieces = _pieces(token.names[0], reader.symbols)
    near = get_close_matches(token.names[0], [*known, *(word for word in reader.functions if len(word) > 2)], n=1)
    hint = "The symbols are: " + ", ".join(known) + "."
    if near:
        hint = f"Did you mean “{near[0]}”?"
    if pieces:
        hint = f"If a product is meant, write {'*'.join(pieces)}."
    numbered = _NUMBERED.fullmatch(token.text)
    if numbered and numbered[1] in reader.functions:
        hint = f"Write {numbered[1]}({numbered[2]}*x), or {numbered[1]}(x)^{numbered[2]}."
    elif numbered and numbered[1] in ("e", "E") and reader.position > 1:
        hint = f"Write 10^{numbered[2]} for a power of ten."
    shown = token.text if len(token.text) <= 40 else token.text[:40] + "…"
    return reader.error(f"unknown symbol “{shown}”", hint, token)


def _pieces(word: str, symbols: frozenset[str]) -> list[str]:
    """The symbols that a word is made of (mgell: m, g, ell); empty if it isn't."""
    found: dict[int, list[str]] = {0: []}
    for end in range(1, min(len(word), 40) + 1):
        for start in range(end):
            if start in found and word[start:end] in symbols:
                found[end] = [*found[start], word[start:end]]
                break
    return found.get(len(word), [])


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
