"""LaTeX tokens -> names: letters with accents, primes, subscripts, looked up in the table."""

from __future__ import annotations

import re
from dataclasses import replace
from difflib import get_close_matches

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.tokens import FUNCTION_WORDS, Token, tokenize
from rbpsym.expr.source import SourceText
from rbpsym.expr.symbol_table import COMMANDS, WORDS, Drawn, LatexReader, SymbolTable, spelling

_DOTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3}
_ACCENTED = ("hat", "bar", "tilde", "check", "breve", "acute", "mathring", "underline", "mathbb", "mathfrak")
_ACCENTS = {rf"\{kind}": kind for kind in _ACCENTED}
_VECTORS = frozenset({r"\vec", r"\boldsymbol"})
_SCRIPTS = frozenset({r"\mathcal", r"\mathpzc"})
_PLAIN = frozenset({r"\mathit", r"\mathnormal"})
_UNITS = {"ı": "x", "i": "x", "ȷ": "y", "j": "y", "k": "z"}
_DOTLESS = {r"\imath": "ı", r"\jmath": "ȷ"}
_HEADS = {*_DOTS, *_ACCENTS, *_VECTORS, *_SCRIPTS, *_PLAIN, *_DOTLESS}
_LONGEST = 24
_MARKED = frozenset("+-*=()/<>|;:.^[]")  # what a label may hold beside letters and digits
_NAMED = frozenset(rf"\{word}" for word in (
    "pm", "mp", "max", "min", "perp", "parallel", "infty", "dagger", "star", "odot", "oplus", "to", "times", "bot", "top", "ne",
    "in", "dots", "sim", "Vert",
))  # fmt: skip


def begins_name(token: Token) -> bool:
    """Can a name (or a word) begin with this token?"""
    return token.kind in ("letter", "text") or (token.kind == "command" and token.text in _HEADS)


def read_name(reader: LatexReader) -> t.Node:
    """A symbol, vector, unit vector or word. Raises ReadError for an unknown name."""
    start = reader.token.start
    spelled = _spelled(reader)
    if spelled:
        return reader.spanned(spelled, start)
    word = reader.token if reader.token.kind == "text" else None
    first = reader.position
    try:
        drawn, vector = _summed(reader)
    except RbpsymError:
        reader.position = first
        return _over_several(reader)
    if drawn.prefix or drawn.base != "Δ":
        return reader.spanned(_known(reader, drawn, vector, word, first), start)
    return _change(reader, drawn, start, first)


def _over_several(reader: LatexReader) -> t.Node:
    """An accent over more than a letter, \\overline{v^2}. Raises ReadError for what begins otherwise."""
    head = reader.take()
    if reader.sees_sign("{") and reader.sees_differential(1) and reader.ahead(2).text == "}":  # as it is seen in a moving frame
        reader.position += 3
        return reader.spanned(t.Formal("seen from", (t.Word(head.text[1:]), t.Word("d"))), head.start)
    if head.text not in _HEADS or not reader.sees_sign("{"):
        reader.position -= 1
        _summed(reader)
    inner = COMMANDS["{"](reader)
    if head.text == r"\underline":  # a result, and no name
        return inner
    return reader.spanned(t.Formal("accented", (t.Word(head.text[1:]), inner)), head.start)


def read_symbol(reader: LatexReader) -> str:
    """The name of a symbol. Raises ReadError if something else stands there."""
    token = reader.token
    braces = reader.pass_sign("{")
    node = read_name(reader) if begins_name(reader.token) else None
    if braces:
        reader.expect("}", token)
    if isinstance(node, (t.Sym, t.Vec)):
        return node.name
    raise reader.error("a symbol is expected here", "", token)


def _spelled(reader: LatexReader) -> t.Node | None:
    """A name by its spelling: the longest that matches the tokens here."""
    if not reader.table.spellings:
        return None
    tokens = reader.tokens[reader.position : reader.position + _LONGEST]
    for count in range(len(tokens), 0, -1):
        name = reader.table.spellings.get(spelling(tokens[:count]))
        if name and reader.ahead(count).text not in ("_", "'"):
            reader.position += count
            kind = t.Vec if tokens[0].text in _VECTORS else t.Sym
            return kind(name)
    return None


def _prescribed(reader: LatexReader) -> t.Node:
    """{}^A v or ^A v^B: a name with a mark before it, and perhaps behind it; {}^A d, a derivative seen from A."""
    start, first, opening = reader.token.start, reader.position, reader.token
    braces = 2 * reader.sees_sign("{")
    reader.position += braces
    mark = reader.token.text + label_after(reader)
    while braces and reader.sees_sign("_", "^"):
        mark += reader.token.text + label_after(reader)
    if not (braces or (mark[1:2].isalpha() and begins_name(reader.token))):
        what = "“^” stands where a number or symbol is expected"
        raise reader.error(what, "Write empty braces before a mark that stands before a name.", opening)
    if not begins_name(reader.token) or reader.sees_differential():
        return reader.spanned(t.Formal("seen from", (t.Word(mark[1:]), COMMANDS["operand"](reader))), start)
    drawn, vector = _scripted(reader)
    behind = [token.text for token in reader.tokens[reader.position + 1 : reader.position + 3]]
    if reader.sees_sign("^") and next(text for text in behind if text != "{") not in (*"0123456789-", "T"):
        drawn = replace(drawn, label=f"{drawn.label}^{label_after(reader)}")
    return reader.spanned(_known(reader, replace(drawn, label=f"{mark} {drawn.label}"), vector, None, first), start)


COMMANDS["{}^"] = COMMANDS["^"] = _prescribed


def _summed(reader: LatexReader) -> tuple[Drawn, bool]:
    """A letter with what is around it, and perhaps a sum sign in front: ΣF_x is one name."""
    if not reader.pass_sign(r"\sum"):
        return _scripted(reader)
    if not begins_name(reader.token):
        raise reader.error("a symbol is expected behind the sum", "Say over which index it goes.")
    drawn, vector = _scripted(reader)
    return replace(drawn, prefix="Σ"), vector


def _scripted(reader: LatexReader) -> tuple[Drawn, bool]:
    """(a letter with its accents, primes and subscripts; has it a vector arrow?)"""
    drawn, vector = _accented(reader)
    while True:
        if reader.sees_sign("'"):
            reader.take()
            drawn = replace(drawn, primes=drawn.primes + 1)
        elif reader.sees_sign("_"):
            drawn = replace(drawn, label=drawn.label + label_after(reader))
        elif reader.sees_sign("^") and (count := _primes_ahead(reader)):
            drawn = replace(drawn, primes=drawn.primes + count)
        elif reader.sees_sign("^") and (label := _label_above(reader)):
            drawn = replace(drawn, label=f"{drawn.label}^{label}")
        elif reader.sees_sign("^") and (numbered := _numbered(reader, drawn)):
            reader.position += 2 + 2 * (reader.ahead().text == "{")
            drawn = numbered
        elif reader.sees_sign("^") and (end := _power_before_subscript(reader)):
            drawn = replace(drawn, label=drawn.label + _label_behind(reader, end))
        else:
            return drawn, vector


def _accented(reader: LatexReader) -> tuple[Drawn, bool]:
    token = reader.take()
    if token.kind in ("letter", "text"):
        return Drawn(token.text), False
    if token.text in _DOTLESS:
        return Drawn(_DOTLESS[token.text]), False
    opening, inside = reader.token, 0
    while reader.pass_sign("{"):
        inside += 1
    if not begins_name(reader.token):
        raise reader.error(f"“{token.text}” stands before something that is no letter")
    with reader.deeper():
        drawn, vector = _scripted(reader) if inside else _accented(reader)
    while inside and (token.text in _VECTORS or token.text == r"\bar") and reader.token.kind == "letter":
        more, _ = _scripted(reader)  # the vector from A to B
        drawn = replace(drawn, base=drawn.base + drawn.label + more.base, label=more.label)
    if inside:
        if token.text in _VECTORS and reader.sees_sign("("):
            _close_before(reader)
        for _ in range(inside):
            reader.expect("}", opening)
    return _with_accent(drawn, token.text), vector or token.text in _VECTORS


def _close_before(reader: LatexReader) -> None:
    r"""Read \mathbf{r(t)} as \mathbf{r}(t): what is closed behind the parenthesis is closed before it."""
    depth, place = 0, reader.position
    while place < len(reader.tokens) - 1:
        text = reader.tokens[place].text
        depth += (text == "(") - (text == ")")
        place += 1
        if not depth:
            break
    if reader.tokens[place].text == "}":
        begin, tokens = reader.position, reader.tokens
        reader.tokens = (*tokens[:begin], tokens[place], *tokens[begin:place], *tokens[place + 1 :])


def _with_accent(drawn: Drawn, command: str) -> Drawn:
    return replace(
        drawn,
        dots=drawn.dots + _DOTS.get(command, 0),
        accent=_ACCENTS.get(command, drawn.accent),
        script=drawn.script or command in _SCRIPTS,
    )


def label_after(reader: LatexReader, *, begun: bool = False) -> str:
    """The subscript that follows, as one label; `begun`: behind its sign, or what stands below an accent in it."""
    if not begun:
        reader.take()
    if not reader.sees_sign("{"):
        return _label_part(reader)
    opening, label, depth = reader.take(), "", 1
    while depth:
        if reader.token.kind == "end":
            raise reader.error("this “{” is never closed", "", opening)
        if reader.sees_sign("{", "}"):
            depth += 1 if reader.take().text == "{" else -1
        else:
            label += _label_part(reader)
    if not label:
        raise reader.error("this subscript is empty", "Remove it, or write what belongs there.", opening)
    if any(label.count(one) != label.count(other) for one, other in ("()", "[]")):
        raise reader.error("a bracket opens or ends in this subscript", "Write what the indices in brackets stand for.", opening)
    return label


WORDS["label"] = label_after


def _label_part(reader: LatexReader) -> str:
    """One token of a label. Raises ReadError if it can't be part of one."""
    token = reader.take()
    if token.kind in ("letter", "text", "digit"):
        return token.text
    if token.kind == "differential":
        return token.text
    if token.text in ("'", r"\prime"):
        return "'"
    if token.text in (",", "_", "{,}", r"\it", *_PLAIN):
        return ""
    if token.text in _DOTLESS:
        return token.text[1:]
    if token.text in _MARKED or token.text in _NAMED:
        return token.text.lstrip("\\")
    if token.kind == "command" and token.text in _HEADS:
        return f"{token.text[1:]}({label_after(reader, begun=True)})"
    if token.text == r"\frac":
        return f"{label_after(reader, begun=True)}/{label_after(reader, begun=True)}"
    if token.text[1:] in FUNCTION_WORDS and token.end - token.start > len(token.text):
        return token.text[1:]  # an upright word that is also a function: I_{\mathrm{sec}}
    raise reader.error(f"“{token.text}” can't be part of a subscript", "", token)


def _label_above(reader: LatexReader) -> str:
    """Pass ^{ext}, ^{(1)}, ^{_{rel}}, ^*, ^\\perp, which name and raise nothing; "" if the superscript is something else."""
    tokens = reader.tokens[reader.position + 1 : reader.position + 6]
    braces = tokens[0].text == "{"
    inner = tokens[braces:]
    if braces and inner[0].text == "_" and "letter" in (inner[1].kind, inner[2].kind):
        reader.position += 1
        return label_after(reader, begun=True)
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


def _numbered(reader: LatexReader, drawn: Drawn) -> Drawn | None:
    """With 0 or 1 above it, which nobody writes for a power: x^1 is a name, where such a name is known, and x^2 is beside it."""
    braces = reader.ahead().text == "{"
    number, behind = reader.ahead(1 + braces), reader.ahead(2 + braces)
    closed = behind.text == "}" if braces else behind.kind != "digit" and behind.text not in ("/", ".", "{,}")
    named, letter = replace(drawn, label=f"{drawn.label}^{number.text}"), reader.tokens[reader.position - 1]
    drawn_so = re.escape(reader.source.text[letter.start : letter.end])
    index = number.text in ("0", "1") or re.search(rf"{drawn_so}\s*\^\s*\{{?\s*[01](?![\d/.])", reader.source.text)
    return named if closed and number.kind == "digit" and index and reader.table.names.get(named) else None


_TRANSPOSED = ("T", r"\top", r"\intercal", r"\dagger")


def mark_above(reader: LatexReader, named: bool) -> str:
    r"""Pass ^T, ^\top, ^{\mathrm T} of what is transposed, and behind what is no name ^+, ^*; "" for another superscript."""
    place = reader.position + 1
    while reader.tokens[place].text in ("{", r"\mathrm", *_PLAIN):
        place += 1
    depth = sum(token.text == "{" for token in reader.tokens[reader.position : place])
    mark, behind = reader.tokens[place].text, reader.tokens[place + 1 :][: max(depth, 1)]
    closed = all(token.text == "}" if depth else token.kind not in ("digit", "letter") for token in behind)
    if mark not in _TRANSPOSED and (named or not closed or mark not in ("*", "+", "-", *_NAMED)):
        return ""
    if depth and not closed:
        return ""
    reader.position = place + 1 + depth
    return "transposed" if mark in _TRANSPOSED else mark.lstrip("\\")


WORDS["mark"] = mark_above


def _primes_ahead(reader: LatexReader) -> int:
    """Pass ^', ^{'} or ^\\prime; the number of primes, 0 if the superscript is something else."""
    tokens = reader.tokens[reader.position + 1 :]
    braces = tokens[0].text == "{"
    count = 0
    while tokens[count + braces].text in ("'", r"\prime"):
        count += 1
    if not count:
        return 0
    powered = braces and tokens[count + 1].text != "}"  # t^{\prime 2}: the power stays
    if powered:
        reader.tokens = (*reader.tokens[: reader.position + 2], *tokens[count + 1 :])
    reader.position += 0 if powered else 1 + count + 2 * braces
    return count


def _power_before_subscript(reader: LatexReader) -> int:
    """In x^2_1, the position of `_`; 0 if no subscript follows the superscript."""
    position, depth = reader.position + 1, 0
    while position < len(reader.tokens) - 1:
        text = reader.tokens[position].text
        depth += (text == "{") - (text == "}")
        position += 1
        if depth <= 0:
            break
    return position if reader.tokens[position].text == "_" else 0


def _label_behind(reader: LatexReader, end: int) -> str:
    """Read the subscript at `end` and take it out, so that the power comes next."""
    begin = reader.position
    reader.position = end
    label = label_after(reader)
    rest = reader.tokens[reader.position :]
    reader.tokens = (*reader.tokens[:begin], *reader.tokens[begin:end], *rest)
    reader.position = begin
    return label


def _change(reader: LatexReader, drawn: Drawn, start: int, first: int) -> t.Node:
    """A Δ: alone a name, or part of one (Delta_x), or the change of what follows."""
    if reader.table.names.get(drawn):
        return reader.spanned(_known(reader, drawn, False, None, first), start)
    if drawn != Drawn("Δ"):
        raise _unknown(reader, drawn, first)
    before = reader.position
    if begins_name(reader.token):
        inner, vector = _scripted(reader)
        if reader.table.draws_prefix(inner):
            whole = replace(inner, prefix="Δ")
            return reader.spanned(_known(reader, whole, vector, None, first), start)
        reader.position = before
    return reader.spanned(t.Delta(_changed(reader)), start)


def _changed(reader: LatexReader) -> t.Node:
    """What stands after Δ: a name, or something in delimiters."""
    if begins_name(reader.token):
        return read_name(reader)
    if reader.sees_sign("(", "{", "[", r"\lvert", "|", r"\int", r"\sum", r"\frac"):
        return COMMANDS[reader.token.text](reader)
    raise reader.error("a symbol or a parenthesis is expected after Δ")


def _known(reader: LatexReader, drawn: Drawn, vector: bool, word: Token | None, first: int) -> t.Node:
    names = reader.table.names.get(drawn, ())
    known = names or reader.table.names.get(replace(drawn, dots=1), ())  # where a rate has a name, others have one too
    still = reader.table.names.get(replace(drawn, dots=0), ()) if drawn.dots and not known and reader.table.varies else ()
    if len(still) == 1 and reader.table.varies and reader.table.varies(still[0]):
        return t.Deriv((t.Vec if vector else t.Sym)(still[0]), "t", drawn.dots)
    if len(names) == 1:
        return (t.Vec if vector else t.Sym)(names[0])
    if names:
        what = f"the symbols {' and '.join(names)} are printed alike"
        raise reader.error(what, "Give one of them another notation.", reader.tokens[first])
    if drawn.accent == "hat" and replace(drawn, accent="") in _UNIT_DRAWN:
        return t.Unit(_UNITS[drawn.base])
    if word and drawn == Drawn(word.text):
        return t.Word(word.text)
    raise _unknown(reader, drawn, first)


_UNIT_DRAWN = frozenset(Drawn(base) for base in _UNITS)


def _unknown(reader: LatexReader, drawn: Drawn, first: int) -> RbpsymError:
    begin = reader.tokens[first]
    text = reader.source.text[begin.start : reader.previous_end]
    known = {_shown(key): names[0] for key, names in reader.table.names.items()}
    near = get_close_matches(_shown(drawn), known, n=1)
    hint = f"Did you mean “{known[near[0]]}”?" if near else (
        "The symbols are: " + ", ".join(sorted(set(known.values()))) + "."
    )  # fmt: skip
    return reader.source.error(f"unknown symbol “{text[:60]}”", begin.start, reader.previous_end,
                               hint)  # fmt: skip


def _shown(drawn: Drawn) -> str:
    return drawn.prefix + drawn.base + "˙" * drawn.dots + "'" * drawn.primes + "_" + drawn.label


def drawn_name(text: str) -> tuple[Drawn, bool] | None:
    """(what a reader sees of a printed name such as `\\vec{R}_{cm}`; has it an arrow?), None if it is no name."""
    source = SourceText(text)
    reader = LatexReader(source, tokenize(source), table=SymbolTable({}))
    if not (begins_name(reader.token) or reader.sees_sign(r"\sum")):
        return None
    try:
        drawn, vector = _summed(reader)
        if drawn == Drawn("Δ") and begins_name(reader.token):
            inner, vector = _scripted(reader)
            drawn = replace(inner, prefix="Δ")
    except RbpsymError:
        return None
    return (drawn, vector) if reader.token.kind == "end" else None
