"""A formula in words, for alternative text. One function a node type.

The English words stand in `WORDS`; another language is another table with the same keys, `Notation.words`. What
a place is filled with is called a, b, c, d. Names of letters may be told under “letters.”: `letters.phi`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction as Rational
from types import MappingProxyType
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Glyph, Notation, letter_name
from rbpsym.frozen import Frozen, field
from rbpsym.typeset.setting import plain_fraction, signed

WORDS: Mapping[str, str] = MappingProxyType({
    "plus": "plus", "minus": "minus", "times": "times", "over": "over", "end": "end fraction",
    "power": "{a} to the power {b}", "squared": "{a} squared", "cubed": "{a} cubed",
    "sqrt": "the square root of {a}", "of": "{a} of {b}", "open": "open parenthesis",
    "close": "close parenthesis", "abs": "the magnitude of {a}", "cross": "cross", "dot": "dot",
    "deriv": "the derivative of {a} with respect to {b}",
    "second": "the second derivative of {a} with respect to {b}",
    "nth": "the derivative of order {c} of {a} with respect to {b}",
    "partial": "the partial derivative of {a} with respect to {b}",
    "integral": "the integral from {a} to {b} of {c} d {d}",
    "body": "the integral over {a} of {b} d m", "path": "the path integral of {a} {b} d {c}",
    "against": "the integral over {a} of {b} {c} d {d}",
    "sum": "the sum over {a} of {b}",
    "bracket": "the change of {a} from {b} equals {c} to {d}", "delta": "the change of {a}",
    "at": "{a} when {b}", "limit": "the limit as {a} tends to {b} of {c}", "vector": "vector {a}",
    "unit": "unit vector {a}", "and": "; and ", "sub": "{a} sub {b}", "prime": "{a} prime",
    "script": "script {a}", "capital": "capital {a}", "hat": "{a} hat", "bar": "{a} bar",
    "tilde": "{a} tilde", "check": "{a} check", "dot1": "{a} dot", "dot2": "{a} double dot",
    "dot3": "{a} triple dot", "change": "delta {a}",
    "=": "equals", "<": "is less than", ">": "is greater than", "<=": "is at most",
    ">=": "is at least", "!=": "is not equal to", "~": "is approximately", "->": "tends to",
    "sin": "sine", "cos": "cosine", "tan": "tangent", "cot": "cotangent", "sec": "secant",
    "csc": "cosecant", "asin": "arc sine", "acos": "arc cosine", "atan": "arc tangent",
    "elliptic_k": "the complete elliptic integral of the first kind of the square of the modulus,",
    "elliptic_e": "the complete elliptic integral of the second kind of the square of the modulus,",
    "exp": "the exponential", "ln": "the natural logarithm",
    "1/2": "one half", "1/3": "one third", "2/3": "two thirds", "1/4": "one quarter",
    "3/4": "three quarters",
})  # fmt: skip


class Voice(Frozen):
    """The notation and the words of a language."""

    notation: Notation = DEFAULT
    words: Mapping[str, str] = field(default_factory=lambda: WORDS)

    def say(self, key: str, *parts: object) -> str:
        """The phrase of `key` with its parts."""
        return self.words[key].format(**dict(zip("abcd", parts, strict=False)))


def to_speech(node: t.Node, notation: Notation = DEFAULT) -> str:
    """The formula in words, those of the notation or English ones."""
    return spoken(node, Voice(notation, notation.words or WORDS))


def spoken(node: t.Node, voice: Voice) -> str:
    """The words of a formula."""
    if type(node) not in PHRASES:
        return TABLE[type(node)](node, voice)
    key, fills = PHRASES[type(node)]
    return voice.say(key, *(fill(getattr(node, name), voice) for name, fill in fills.items()))


def _closed(node: t.Node, voice: Voice) -> str:
    """The words of a part, between spoken parentheses if it is a sum."""
    text = spoken(node, voice)
    if isinstance(node, (t.Add, t.Neg, t.Cross, t.Dot, t.Chain)):
        return f"{voice.say('open')} {text} {voice.say('close')}"
    return text


def _num(node: t.Num, voice: Voice) -> str:
    value = Rational(node.value)
    text = str(abs(value))
    over = f" {voice.say('over')} "
    text = voice.words.get(text) or text.replace("/", over)
    return f"{voice.say('minus')} {text}" if value < 0 else text


def glyph_words(glyph: Glyph, voice: Voice) -> str:
    """The words of a drawn name: "theta sub 1 double dot"."""
    text = letter_name(glyph.base)
    text = voice.words.get(f"letters.{text}", text)
    if len(glyph.base) == 1 and glyph.base.isupper():
        text = voice.say("capital", text.lower())
    text = voice.say("script", text) if glyph.style == "script" else text
    for sub in glyph.subs:
        text = voice.say("sub", text, glyph_words(sub, voice))
    for mark in (glyph.accent, f"dot{glyph.dots}", *["prime"] * glyph.primes):
        text = voice.say(mark, text) if mark in voice.words else text
    return voice.say("change", text) if glyph.prefix else text


def _add(node: t.Add, voice: Voice) -> str:
    texts: list[str] = []
    for term in node.terms:
        negative, body = signed(term)
        texts += [voice.say("minus")] if negative else [voice.say("plus")] if texts else []
        texts.append(_closed(body, voice))
    return " ".join(texts) or "0"


def _neg(node: t.Neg, voice: Voice) -> str:
    negative, body = signed(node)
    return f"{voice.say('minus')} {_closed(body, voice)}" if negative else spoken(body, voice)


def _mul(node: t.Mul, voice: Voice) -> str:
    negative, body = signed(node)
    if not isinstance(body, t.Mul):
        return spoken(t.Neg(body) if negative else body, voice)
    text = f" {voice.say('times')} ".join(_closed(factor, voice) for factor in body.factors)
    return f"{voice.say('minus')} {text}" if negative else text


def _div(node: t.Div, voice: Voice) -> str:
    if isinstance(node.num, t.Num) and isinstance(node.den, t.Num):
        known = voice.words.get(f"{node.num.value}/{node.den.value}")
        if known:
            return known
    text = f"{_closed(node.num, voice)} {voice.say('over')} {_closed(node.den, voice)}"
    short = all(isinstance(part, (t.Sym, t.Num)) for part in (node.num, node.den))
    return text if short else f"{text} {voice.say('end')}"


def _pow(node: t.Pow, voice: Voice) -> str:
    base = _closed(node.base, voice)
    if plain_fraction(node.base) or isinstance(node.base, t.Mul):
        base = f"{voice.say('open')} {spoken(node.base, voice)} {voice.say('close')}"
    powers: dict[t.Node, str] = {t.Num(2): "squared", t.Num(3): "cubed"}
    key = powers.get(node.exponent, "power")
    return voice.say(key, base, spoken(node.exponent, voice))


def _group(node: t.Group, voice: Voice) -> str:
    return f"{voice.say('open')} {spoken(node.arg, voice)} {voice.say('close')}"


def _product(node: t.Cross | t.Dot, key: str, voice: Voice) -> str:
    return f"{_closed(node.left, voice)} {voice.say(key)} {_closed(node.right, voice)}"


def _deriv(node: t.Deriv, voice: Voice) -> str:
    key = "partial" if node.partial else {1: "deriv", 2: "second"}.get(node.order, "nth")
    wrt = glyph_words(voice.notation.glyph(node.wrt), voice)
    return voice.say(key, _closed(node.of, voice), wrt, node.order)


def _body_integral(node: t.BodyIntegral, voice: Voice) -> str:
    body = glyph_words(voice.notation.glyph(node.body), voice)
    spread = t.spread(node.integrand)
    if spread is None:
        return voice.say("body", body, _closed(node.integrand, voice))
    arm, product, of = spread
    return voice.say("against", body, _closed(arm, voice), voice.say(product), spoken(of, voice))


def _path_integral(node: t.PathIntegral, voice: Voice) -> str:
    sign = {"dot": "dot", "cross": "cross"}.get(node.product, "times")
    return voice.say("path", _closed(node.integrand, voice), voice.say(sign), spoken(node.path, voice))


def _chain(node: t.Chain, voice: Voice) -> str:
    texts = [spoken(node.items[0], voice)]
    for op, item in zip(node.ops, node.items[1:], strict=True):
        texts += [voice.say(op), spoken(item, voice)]
    return " ".join(texts)


def _system(node: t.Relations, voice: Voice) -> str:
    return voice.say("and").join(spoken(row, voice) for row in node.rows)


# what a node is in words: the key of a phrase and how each of its places is filled
Fill = Callable[[Any, Voice], str]
PLAIN: Fill = spoken
CLOSED: Fill = _closed


def named(name: str, voice: Voice) -> str:
    """The words of a name."""
    return glyph_words(voice.notation.glyph(name), voice)


PHRASES: Mapping[type, tuple[str, Mapping[str, Fill]]] = {
    t.Integral: ("integral", {"lower": PLAIN, "upper": PLAIN, "integrand": CLOSED, "var": named}),
    t.Sum: ("sum", {"index": named, "term": CLOSED}),
    t.Bracket: ("bracket", {"arg": CLOSED, "var": named, "lower": PLAIN, "upper": PLAIN}),
    t.Limit: ("limit", {"var": named, "to": PLAIN, "arg": CLOSED}),
    t.At: ("at", {"arg": CLOSED, "condition": PLAIN}),
    t.Fn: ("of", {"name": lambda name, voice: voice.say(name), "arg": CLOSED}),
    t.Vec: ("vector", {"name": named}),
    t.Unit: ("unit", {"axis": lambda axis, voice: {"x": "i", "y": "j", "z": "k"}[axis]}),
    **{kind: (key, {"arg": CLOSED}) for kind, key in ((t.Sqrt, "sqrt"), (t.Abs, "abs"), (t.Delta, "delta"))},
}

TABLE: dict[type, Callable[..., str]] = {
    t.Num: _num, t.Sym: lambda node, voice: named(node.name, voice), t.Add: _add, t.Neg: _neg,
    t.Mul: _mul, t.Div: _div, t.Pow: _pow, t.Group: _group, t.Deriv: _deriv,
    t.Cross: lambda node, voice: _product(node, "cross", voice), t.Dot: lambda node, voice: _product(node, "dot", voice),
    t.BodyIntegral: _body_integral, t.PathIntegral: _path_integral, t.Chain: _chain, t.Relations: _system,
    t.Word: lambda node, voice: node.text,
}  # fmt: skip
