"""LaTeX tokens -> what stands above and below a letter: labels, primes, marks, numbers that raise nothing."""

from __future__ import annotations

import re
from dataclasses import replace

from rbpsym.errors import Incomplete
from rbpsym.expr.hyperbolic import FUNCTION_WORDS
from rbpsym.expr.latex.spelled import commands
from rbpsym.expr.symbol_table import Drawn, LatexReader

DOTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3}
_ACCENTED = ("hat", "bar", "tilde", "check", "breve", "acute", "mathring", "underline", "uuline", "mathbb", "mathfrak", "slashed")
ACCENTS = {rf"\{kind}": kind for kind in _ACCENTED}
VECTORS = frozenset({r"\vec", r"\boldsymbol"})
SCRIPTS = frozenset({r"\mathcal", r"\mathpzc"})
PLAIN = frozenset({r"\mathit", r"\mathnormal"})
DOTLESS = {r"\imath": "ı", r"\jmath": "ȷ"}
HEADS = {*DOTS, *ACCENTS, *VECTORS, *SCRIPTS, *PLAIN, *DOTLESS}
_MARKED = frozenset("+-*=()/<>|;:.^[]")  # what a label may hold beside letters and digits
_NAMED = frozenset(commands("labels"))


def label_after(reader: LatexReader, *, begun: bool = False) -> str:
    """The subscript that follows, as one label; `begun`: behind its sign, or what stands below an accent in it."""
    if not begun:
        reader.take()
    if reader.sees_sign("=", "<", ">"):
        raise reader.error("this subscript is empty", "Remove it, or write what belongs there.", kind=Incomplete)
    if not reader.sees_sign("{"):
        return _label_part(reader)
    opening, label, depth = reader.take(), "", 1
    while depth:
        if reader.token.kind == "end":
            raise reader.error("this “{” is never closed", "", opening)
        if reader.sees_sign("{", "}"):
            depth += 1 if reader.take().text == "{" else -1
        else:
            label += _label_part(reader) or "," * (not label and reader.tokens[reader.position - 1].text == ",")  # φ_{,x}
    if not label:
        raise reader.error("this subscript is empty", "Remove it, or write what belongs there.", opening)
    if any(label.count(one) != label.count(other) for one, other in ("()", "[]")):
        raise reader.error("a bracket opens or ends in this subscript", "Write what the indices in brackets stand for.", opening)
    return label


def _label_part(reader: LatexReader) -> str:
    """One token of a label. Raises ReadError if it can't be part of one."""
    token = reader.take()
    if token.kind in ("letter", "text", "digit"):
        return token.text
    if token.kind == "differential":
        return token.text
    if token.text in ("'", r"\prime"):
        return "'"
    if token.text in (",", "_", "{,}", r"\it", *PLAIN):
        return ""
    if token.text in DOTLESS:
        return token.text[1:]
    if token.text in _MARKED or token.text in _NAMED:
        return token.text.lstrip("\\")
    if token.kind == "command" and token.text in HEADS:
        return f"{token.text[1:]}({label_after(reader, begun=True)})"
    if token.text == r"\frac":
        return f"{label_after(reader, begun=True)}/{label_after(reader, begun=True)}"
    if token.text[1:] in FUNCTION_WORDS and token.end - token.start != len(token.text):
        return token.text[1:]  # a word that is also a function: I_{\mathrm{sec}}
    raise reader.error(f"“{token.text}” can't be part of a subscript", "", token)


def label_above(reader: LatexReader) -> str:
    """Pass ^{ext}, ^{(1)}, ^{_{rel}}, ^*, ^\\perp, which name and raise nothing; "" if the superscript is something else."""
    tokens = reader.tokens[reader.position + 1 : reader.position + 6]
    braces = tokens[0].text == "{"
    if braces and tokens[1].text == "_":
        return label_after(reader)
    inner = tokens[braces:]
    bracketed = inner[0].text == "(" and inner[1].kind in ("letter", "digit") and inner[2].text == ")"
    marked = inner[0].text in ("*", "+", "-", *_NAMED)
    named = marked or (inner[0].kind == "text" and Drawn(inner[0].text) not in reader.table.names)
    named = named and inner[0].text not in _TRANSPOSED
    leads = braces and inner[1].text == r"\to" and {inner[0].kind, inner[2].kind} <= {"letter", "digit"}  # W^{1→2}
    index = inner[0].text.isupper() or not inner[0].text.isascii()
    digits = braces and inner[0].kind == "letter" and index and inner[1].kind == "digit"  # I^{C1}, F^{μ0}
    length = 3 if leads or (bracketed and braces) else 2 if digits else int(named)
    if not length or (braces and inner[length].text != "}"):
        return ""
    reader.position += 1 + length + 2 * braces
    return "".join(token.text.lstrip("\\") for token in inner[:length])


def numbered(reader: LatexReader, drawn: Drawn) -> Drawn | None:
    """With 0 or 1 above it, which nobody writes for a power: x^1 is a name, where such a name is known, and x^2 is beside it."""
    braces = reader.ahead().text == "{"
    number, behind = reader.ahead(1 + braces), reader.ahead(2 + braces)
    closed = behind.text == "}" if braces else behind.kind != "digit" and behind.text not in ("/", ".", "{,}")
    named, letter = replace(drawn, label=f"{drawn.label}^{number.text}"), reader.tokens[reader.position - 1]
    drawn_so = re.escape(reader.source.text[letter.start : letter.end])
    repeated = re.search(rf"{drawn_so}\s*\^\s*\{{?\s*[01](?![\d/.])", reader.source.text)
    index = drawn.base != "e" and (number.text in ("0", "1") or repeated)
    return named if closed and number.kind == "digit" and index and reader.table.names.get(named) else None


_TRANSPOSED = ("T", r"\top", r"\intercal", r"\dagger")


def mark_above(reader: LatexReader, named: bool) -> str:
    r"""Pass ^T, ^\top, ^{\mathrm T} of what is transposed, and behind what is no name ^+, ^*; "" for another superscript."""
    place = reader.position + 1
    while reader.tokens[place].text in ("{", r"\mathrm", *PLAIN):
        place += 1
    depth = sum(token.text == "{" for token in reader.tokens[reader.position : place])
    mark, behind = reader.tokens[place].text, reader.tokens[place + 1 :][: max(depth, 1)]
    closed = all(token.text == "}" if depth else token.kind != "digit" for token in behind)
    if mark not in _TRANSPOSED and (named or not closed or mark not in ("*", "+", "-", *_NAMED)):
        return ""
    if depth and not closed:
        return ""
    reader.position = place + 1 + depth
    return "transposed" if mark in _TRANSPOSED else mark.lstrip("\\")


def primes_ahead(reader: LatexReader) -> int:
    """Pass ^', ^{'} or ^\\prime; the number of primes, 0 if the superscript is something else."""
    tokens = reader.tokens[reader.position + 1 :]
    braces = tokens[0].text == "{"
    count = 0
    while tokens[count + braces].text in ("'", r"\prime"):
        count += 1
    if not count:
        return 0
    reader.position += 1 + count + 2 * braces
    return count
