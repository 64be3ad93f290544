"""LaTeX tokens -> names: letters with accents, primes, subscripts, looked up in the table."""

from __future__ import annotations

import re
from dataclasses import replace
from difflib import get_close_matches

from rbpsym.errors import Incomplete, RbpsymError, UnknownName
from rbpsym.expr import tree as t
from rbpsym.expr.latex.scripts import (
    ACCENTS,
    DOTLESS,
    DOTS,
    HEADS,
    SCRIPTS,
    VECTORS,
    label_above,
    label_after,
    numbered,
    primes_ahead,
)  # fmt: skip
from rbpsym.expr.latex.tokens import SCRIPTED, Token, closed, tokenize
from rbpsym.expr.source import SourceText
from rbpsym.expr.symbol_table import COMMANDS, Drawn, LatexReader, SymbolTable, spelling

_UNITS = {"ı": "x", "i": "x", "ȷ": "y", "j": "y", "k": "z"}
_LONGEST = 24


def begins_name(token: Token) -> bool:
    """Can a name (or a word) begin with this token?"""
    return token.kind in ("letter", "text") or (token.kind == "command" and token.text in HEADS)


_WORDS = re.compile(
    r"(?<![A-Za-z\\])(?:Re|Im|KE|PE|[Tt]r|det|dim|sgn|rot|div|grad|curl|lim|max|min|const|[ck]onstant[e]?|konst)(?![A-Za-z])"
)


def as_words(text: str, tokens: list[Token]) -> list[Token]:
    """The tokens with the letters of a word that nobody means as a product, Re(z) or p = const, as one name or command."""
    for found in _WORDS.finditer(text):
        inside = [k for k, token in enumerate(tokens) if found.start() <= token.start < found.end()]
        if all(tokens[k].kind == "letter" for k in inside) and len(inside) == len(found[0]):
            indexed = tokens[inside[-1] + 1].text == "_" and found[0] in ("Re", "Im")  # the number of Reynolds
            is_command = rf"\{found[0]}" in COMMANDS and not indexed
            kind, word = ("command", rf"\{found[0]}") if is_command else ("letter", found[0])
            kind, word = ("text", found[0]) if SCRIPTED.search(text, 0, found.start()) else (kind, word)
            tokens[inside[0] : inside[-1] + 1] = [Token(kind, word, *found.span())]
    return tokens


def letter_run(reader: LatexReader) -> t.Node | None:
    """Letters side by side of which nothing is known and which may be one word: in front of a bracket, or four.

    None, and nothing passed, for any other, and where one of them is raised, has an index, or may be the d of a differential.
    """
    place, run = reader.position, ""
    while (token := reader.tokens[place + len(run)]).kind == "letter" and token.text.isascii() and len(token.text) == 1:
        if run and token.start > reader.tokens[place + len(run) - 1].end:
            break
        run += token.text
    word, scripts = token.text in ("(", "[") or len(run) > 3, ("^", "'") if len(run) > 3 else ("_", "^", "'")
    closed_in = len(run) > 3 and token.text == ")" and reader.ahead(-1).text == "("  # (poids)
    behind = [one.text for one in reader.tokens[closed(reader.tokens, place + len(run) + 1) + 1 :][:1]]
    titled = len(run) > 2 and run.istitle() and token.text == "_" and behind == ["("]  # Sol_φ(h)
    clear = titled or (run in ("ln", "lg", "log") and token.text in ("_", r"\frac"))
    if len(run) < 2 or not (word or clear) or (token.text in scripts and not clear) or ("d" in run and not closed_in):
        return None
    start = reader.token.start
    return reader.spanned(t.Formal("run", tuple(read_name(reader) for _ in run)), start)


def between_points(reader: LatexReader, factors: list[t.Node]) -> list[t.Node]:
    """With capitals side by side, of which nothing is known, as one: A_1P may be a length, KE a name; the last may be raised."""
    found: list[t.Node] = []
    for one in factors:
        run = found[-1] if found else one
        (_, end), (begin, behind) = run.span or (0, 0), one.span or (0, 0)
        letter = one.base if isinstance(one, t.Pow) else one
        if end == begin and is_capital(reader, run) and is_capital(reader, letter):
            parts = run.parts if isinstance(run, t.Formal) else (run,)
            found[-1:] = [t.Formal("run", (*parts, one), span=((run.span or (0, 0))[0], behind))]
        else:
            found.append(one)
    return found


def is_capital(reader: LatexReader, node: t.Node) -> bool:
    """Is it a capital letter, perhaps with a subscript, or does it end with one?"""
    last = node.parts[-1] if isinstance(node, t.Formal) and node.kind == "run" else node
    text = reader.source.text[slice(*(last.span or (0, 0)))]
    return isinstance(last, t.Sym) and text[:1].isupper() and "^" not in text


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
    if head.text not in HEADS or not reader.sees_sign("{"):
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
            kind = t.Vec if tokens[0].text in VECTORS else t.Sym
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
        raise reader.error(what, "Write empty braces before a mark that stands before a name.", opening, Incomplete)
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
        elif reader.sees_sign("^") and (count := primes_ahead(reader)):
            drawn = replace(drawn, primes=drawn.primes + count)
        elif reader.sees_sign("^") and (label := label_above(reader)):
            drawn = replace(drawn, label=f"{drawn.label}^{label}")
        elif reader.sees_sign("^") and (index := numbered(reader, drawn)):
            reader.position += 2 + 2 * (reader.ahead().text == "{")
            drawn = index
        elif reader.sees_sign("^") and (end := _power_before_subscript(reader)):
            drawn = replace(drawn, label=drawn.label + _label_behind(reader, end))
        else:
            return drawn, vector


def _accented(reader: LatexReader) -> tuple[Drawn, bool]:
    token = reader.take()
    if token.kind in ("letter", "text"):
        return Drawn(token.text), False
    if token.text in DOTLESS:
        return Drawn(DOTLESS[token.text]), False
    opening, inside = reader.token, 0
    while reader.pass_sign("{"):
        inside += 1
    if not begins_name(reader.token):
        raise reader.error(f"“{token.text}” stands before something that is no letter", "", token, Incomplete)
    with reader.deeper():
        drawn, vector = _scripted(reader) if inside else _accented(reader)
    joins = inside and (token.text in VECTORS or token.text == r"\bar")
    while joins and reader.token.kind == "letter" and f"{drawn.base}{reader.token.text}".isupper():
        more, _ = _scripted(reader)  # the vector from A to B
        drawn = replace(drawn, base=drawn.base + drawn.label + more.base, label=more.label)
    if inside:
        if token.text in VECTORS and reader.sees_sign("("):
            _close_before(reader)
        for _ in range(inside):
            reader.expect("}", opening)
    return _with_accent(drawn, token.text), vector or token.text in VECTORS


def _close_before(reader: LatexReader) -> None:
    r"""Read \mathbf{r(t)} as \mathbf{r}(t): what is closed behind the parenthesis is closed before it."""
    place = min(closed(reader.tokens, reader.position) + 1, len(reader.tokens) - 1)
    if reader.tokens[place].text == "}":
        begin, tokens = reader.position, reader.tokens
        reader.tokens = (*tokens[:begin], tokens[place], *tokens[begin:place], *tokens[place + 1 :])


def _with_accent(drawn: Drawn, command: str) -> Drawn:
    return replace(
        drawn,
        dots=drawn.dots + DOTS.get(command, 0),
        accent=ACCENTS.get(command, drawn.accent),
        script=drawn.script or command in SCRIPTS,
    )


def _power_before_subscript(reader: LatexReader) -> int:
    """In x^2_1, the position of `_`; 0 if no subscript follows the superscript."""
    position = closed(reader.tokens, reader.position + 1) + 1
    return position if position < len(reader.tokens) and reader.tokens[position].text == "_" else 0


def _label_behind(reader: LatexReader, end: int) -> str:
    """Read the subscript at `end` and put it first, so that the power comes next, and whoever reads it again reads the same."""
    begin, tokens = reader.position, reader.tokens
    reader.position = end
    label = label_after(reader)
    behind = reader.position
    reader.tokens = (*tokens[:begin], *tokens[end:behind], *tokens[begin:end], *tokens[behind:])
    reader.position = begin + behind - end
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
        if (whole := replace(inner, prefix="Δ")) in reader.table.names:
            return reader.spanned(_known(reader, whole, vector, None, first), start)
        reader.position = before
    return reader.spanned(t.Delta(_changed(reader)), start)


def _changed(reader: LatexReader) -> t.Node:
    """What stands after Δ: a name, or something in delimiters."""
    if begins_name(reader.token):
        return read_name(reader)
    if reader.sees_sign("(", "{", "[", r"\lvert", "|", r"\int", r"\sum", r"\frac"):
        return COMMANDS[reader.token.text](reader)
    if reader.table.open:  # the operator, or a quantity called so
        return t.Word("")
    raise reader.error("a symbol or a parenthesis is expected after Δ")


def _known(reader: LatexReader, drawn: Drawn, vector: bool, word: Token | None, first: int) -> t.Node:
    names = reader.table.names.get(drawn, ())
    known = names or reader.table.names.get(replace(drawn, dots=1), ())  # where a rate has a name, others have one too
    still = reader.table.names.get(replace(drawn, dots=0), ()) if drawn.dots and not known and reader.table.varies else ()
    if len(still) == 1 and reader.table.varies and reader.table.varies(still[0]):
        return t.Deriv((t.Vec if vector else t.Sym)(still[0]), "t", drawn.dots)
    if len(names) == 1:
        is_unit = drawn.accent == "hat" and reader.table.directed(names[0])
        return (t.Vec if vector or is_unit else t.Sym)(names[0])
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
    return reader.source.error(f"unknown symbol “{text[:60]}”", begin.start, reader.previous_end, hint, UnknownName)


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
