"""A Typst document as LaTeX with the same lines: its formulas, its files, and what its comments say to us."""

from __future__ import annotations

import re

from rbpsym.claims.papers.marks import Rewriting, blank, comment, display
from rbpsym.expr.typst_reader import typst_to_latex

_LET = (
    r"#let[ \t]++(?P<code_let>[A-Za-z]{2,})\((?P<code_given>[\w ,:]*+)\)[ \t]*+=[ \t]*+"
    r"\{[^{}]{0,400}\n[ \t]*+(?P<shown>\w++)[ \t]*+\n[ \t]*+\}|"
    r"#let[ \t]++(?P<let>[A-Za-z]{2,})(?:\((?P<given>[\w ,]*+)\))?[ \t]*+=[ \t]*+"
    r"(?:(?P<drawn>\[?)\$(?P<body>[^$\n]{1,500})\$\]?|(?:(?:math\.)?op\()?[ \t]*+\"(?P<word>[^\"\\\n{}]{1,40})\"[^\n]*+)"
)
_OPENING = re.compile(
    rf"{_LET}|#import[ \t]++\"(?P<import>[^\"@\n]{{1,200}}\.typ)\"[^\n]*+"
    r"|(?<!:)//(?P<line>[^\n]*+)|(?P<block>/\*)|(?P<code>(?<!`)`++)|\\(?P<escaped>.)"
    r"|#include[ \t]++\"(?P<file>[^\"\n]*+)\"|#\w++\([ \t]*+\"[^\"\n]*+\"|(?P<math>\$)|(?P<sign>%)"
)
_LABEL = re.compile(r"\s*+<([\w:.-]{1,200})>")
_CLOSING = r"(?<!\\)\$"


def of_typst(text: str) -> str:
    """The text as LaTeX."""
    own = frozenset(found["let"] or found["code_let"] for found in re.finditer(_LET, text))
    return Rewriting(text).rewritten(_OPENING, lambda text, found: _piece(text, found, own))


def _piece(text: Rewriting, found: re.Match[str], own: frozenset[str]) -> tuple[str, int]:
    told, start = found.groupdict(), found.end()
    if told["code_let"]:
        given = [name.strip() for name in told["code_given"].split(",") if ":" not in name]
        body = f"#{given.index(told['shown']) + 1}" if told["shown"] in given else ""
        made = rf"\def\{told['code_let']}({','.join(f'#{number}' for number in range(1, len(given) + 1))}){{{body}}}"
        return made + blank(found[0]) if body else blank(found[0]), start
    if told["let"]:
        return _definition(told, own), start
    if told["import"]:
        return rf"\usepackage{{{told['import']}}}", start
    if told["line"] is not None:
        return comment(told["line"]), start
    if told["block"]:
        closed = text.closing(r"\*/", start)
        return (comment(text.text[start : closed[0]]), closed[1]) if closed else ("", start)
    if told["code"]:
        end = text.span(start, len(told["code"]))
        return blank(text.text[start : max(end, start)]), max(end, start) + len(told["code"]) * (end > 0)
    if told["file"] is not None:
        return rf"\input{{{told['file']}}}", start
    if told["math"] and (closed := text.closing(_CLOSING, start)):
        return _formula(text, text.text[start : closed[0]], closed[1], own)
    return rf"\{found[0]}" if found[0] in "$%" else blank(found[0]), start


def _definition(told: dict[str, str | None], own: frozenset[str]) -> str:
    """A #let of a formula or a word, as a macro; its arguments stand in parentheses where it is called."""
    given = [name.strip() for name in (told["given"] or "").split(",") if name.strip()]
    body = typst_to_latex(told["body"], own, given).strip() if told["body"] else rf"\operatorname{{{told['word']}}}"
    places = ",".join(f"#{number}" for number in range(1, len(given) + 1))
    return rf"\def\{told['let']}{f'({places})' if given else ''}{{{body}}}"


def _formula(text: Rewriting, body: str, end: int, own: frozenset[str]) -> tuple[str, int]:
    """A display, which has white ends, perhaps with a label, or a formula in the running text."""
    latex = typst_to_latex(body, own)
    if not (body[:1].isspace() and body[-1:].isspace()):
        return rf"\({latex}\)", end
    label = _LABEL.match(text.text, end)
    made = display(latex, label[1] if label else "", rows=r"\\" in latex)
    return made + (blank(label[0]) if label else ""), label.end() if label else end
