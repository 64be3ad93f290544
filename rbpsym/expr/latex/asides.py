"""What stands in parentheses beside a formula: its number written by hand, which says nothing, or when it holds."""

from __future__ import annotations

import re
from dataclasses import replace

from rbpsym.expr.latex.tokens import COLUMN, CONDITION, CONDITIONS, PUNCTUATION, Token

_NUMBER = re.compile(r"\d{1,2}(?:[.-]\d{1,3}){0,2}[a-z]?'?|\*{1,3}|[a-zA-Z]'{0,2}|[A-Z]\.\d{1,2}")
_WIDE = re.compile(r"\\q?quad|\\hspace|\\hfil")
_ARROWS = frozenset((r"\to", r"\gets", r"\uparrow", r"\downarrow"))  # (→): which way, said beside a number
Span = tuple[int, int]


def without_asides(tokens: tuple[Token, ...], relations: frozenset[str]) -> tuple[Token, ...]:
    """The tokens without hand-written numbers, and with (x > 0) behind a gap at the end of a row as a condition."""
    tokens = _labelled(_unnumbered(tokens), relations)
    if COLUMN not in {token.text for token in tokens}:
        tokens = _unremarked(tokens, relations)
    found = list(tokens)
    for begin, end in reversed(_pairs(tokens)):
        inner = tokens[begin + 1 : end]
        before, behind = _gap_before(tokens, begin), _gap_behind(tokens, end + 1)
        said = len(inner) == 1 and (inner[0].text in _ARROWS or (inner[0].kind == "text" and before < begin))
        if said and _ends(tokens, end + 1) and not _begins(tokens, before):
            found[before : end + 1] = [replace(inner[0], kind="row", text=""), replace(inner[0], kind="text")]
        elif _NUMBER.fullmatch("".join(token.text for token in inner)):
            if before < begin and _wide(tokens[before:begin]) and _ends(tokens, end + 1):
                del found[before : end + 1]
            elif behind > end + 1 and _wide(tokens[end + 1 : behind]) and _begins(tokens, begin):
                del found[begin:behind]
        elif before < begin and _ends(tokens, end + 1) and not _begins(tokens, before) and _relates(inner, relations):
            found[begin : end + 1] = _conditions(tokens[begin], inner, relations)
    return tuple(found)


def _unremarked(tokens: tuple[Token, ...], relations: frozenset[str]) -> tuple[Token, ...]:
    """Without words in parentheses at the end of a row; those that may be a condition have a row of their own."""
    found = list[Token]()
    for k, token in enumerate(tokens):
        bracketed = token.kind == "text" and token.text[:1] + token.text[-1:] == "()" and _ends(tokens, k + 1)
        aside = bracketed and not _begins(tokens, k) and not _relates(tokens[k - 1 : k], relations)
        if not aside:
            found.append(token)
        elif CONDITIONS.search(token.text):
            found += [replace(token, kind="row", text=""), token]
    return tuple(found)


def _unnumbered(tokens: tuple[Token, ...]) -> tuple[Token, ...]:
    """Without its number in a list in front of a formula: 1. \\quad v = a t."""
    apart = len(tokens) > 2 and tokens[0].kind == "digit" and tokens[1].text in (".", ")") and _wide(tokens[2:3])
    return tokens[3:] if apart else tokens


def _labelled(tokens: tuple[Token, ...], relations: frozenset[str]) -> tuple[Token, ...]:
    """With what a row is about, in front of a colon (ΣF_x: or words, or anything with a gap behind it), as a row of words."""
    found: list[Token] = []
    for place, token in enumerate(tokens):
        if token.text != ":":
            found.append(token)
            begins = _begins(tokens, place) or tokens[place - 1].kind == "gap"
            if token.kind == "text" and token.text.endswith(":") and begins:  # vector form: a = b
                found.append(replace(token, kind="row", text=""))
            continue
        row = next((k for k in range(len(found), 0, -1) if found[k - 1].kind in ("row", "begin")), 0)
        about = [one for one in found[row:] if one.kind != "gap" and one.text != "&"]
        gap = tokens[min(place + 1, len(tokens) - 1)]
        clear = gap.kind in ("gap", "begin") or gap.text == "&" or "".join(one.text for one in about[:1]) == r"\sum"
        clear |= bool(about) and about[0].kind == "text"
        relates = _relates(tuple(about), relations)
        if not about or relates or not clear:
            depth = sum((one.text in "([{") - (one.text in ")]}") for one in about if relates and one.kind == "sign")
            parts = relates and gap.kind == "gap" and _wide((gap,)) and not depth
            found.append(replace(token, kind="row", text="") if parts else token)
            continue
        words = " ".join(one.text for one in about)
        found[row:] = [replace(about[0], kind="text", text=words, end=token.end), replace(token, kind="row", text="")]
    return tuple(found)


def _pairs(tokens: tuple[Token, ...]) -> list[Span]:
    """Where parentheses open and close that stand in no brackets or braces."""
    pairs, depth, begin = [], 0, 0
    for place, token in enumerate(tokens):
        if token.kind != "sign":
            continue
        if token.text == "(" and depth == 0:
            begin = place
        depth += (token.text in "([{") - (token.text in ")]}") if len(token.text) == 1 else 0
        if token.text == ")" and depth == 0 and tokens[begin].text == "(":
            pairs.append((begin, place))
    return pairs


def _gap_before(tokens: tuple[Token, ...], place: int) -> int:
    while place and tokens[place - 1].kind == "gap":
        place -= 1
    return place


def _gap_behind(tokens: tuple[Token, ...], place: int) -> int:
    while tokens[place].kind == "gap":
        place += 1
    return place


def _wide(gaps: tuple[Token, ...]) -> bool:
    return len(gaps) > 2 or any(_WIDE.match(gap.text) for gap in gaps)


def _begins(tokens: tuple[Token, ...], place: int) -> bool:
    """Does a row begin here, but for an alignment?"""
    while place and (tokens[place - 1].kind in ("begin", "gap") or tokens[place - 1].text == "&"):
        place -= 1
    return place == 0 or tokens[place - 1].kind == "row"


def _ends(tokens: tuple[Token, ...], place: int) -> bool:
    """Does a row end here, but for a mark?"""
    while tokens[place].kind == "gap" or (tokens[place].text in PUNCTUATION and tokens[place].kind == "sign"):
        place += 1
    return tokens[place].kind in ("end", "row") or tokens[place].text.startswith(r"\end")


def _relates(tokens: tuple[Token, ...], relations: frozenset[str]) -> bool:
    return any(token.text in relations and token.kind in ("sign", "command") for token in tokens)


def _conditions(opening: Token, inner: tuple[Token, ...], relations: frozenset[str]) -> list[Token]:
    """Each of them behind an “if”."""
    found = [replace(opening, kind="row", text=CONDITION)]
    for place, token in enumerate(inner):
        parts = token.text in (",", ";") and _relates(inner[:place], relations) and _relates(inner[place + 1 :], relations)
        found.append(replace(token, kind="row", text=CONDITION) if parts else token)
    return found
