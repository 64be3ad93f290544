"""LaTeX -> tokens. Thin spaces, `\\left`, `\\right` and `\\nonumber` mean nothing and make no token;

every other character makes one, or an error that names it. Gaps make one where rows are laid out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from rbpsym.errors import LimitError
from rbpsym.notation.hyperbolic import HYPERBOLIC
from rbpsym.notation.letters import LETTERS, NAME_OF_LETTER, SAME_LETTER
from rbpsym.notation.source import Source, refused

MAX_LENGTH = 8000

# Names of functions in the languages whose papers are read; behind a backslash, or upright: \\operatorname{sen}.
FUNCTION_WORDS = {
    **{name: name for name in ("sin", "cos", "tan", "cot", "sec", "csc", "exp", "ln")},
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "log": "ln",
    "sen": "sin", "tg": "tan", "ctg": "cot", "cotg": "cot", "cosec": "csc",
    "arcsen": "asin", "arctg": "atan", **{name: name for name in HYPERBOLIC},
}  # fmt: skip
_SILENT = (
    r"\\(?:,|:|!|>)"
    r"|\\(?:nonumber|notag|displaystyle|textstyle|limits|nolimits|thinspace"
    r"|left|right|bigl|bigr|Bigl|Bigr|big|Big|middle)(?![A-Za-z])"
    r"|\\label\s*\{[^{}]*\}"
)
_GAP = r"(?<=[-+=&])\{\}|\{\}(?=\s*[-+=<>&])|\\(?:;| |\n)|~|\\(?:quad|qquad|enspace)(?![A-Za-z])|\\hspace\*?\s*\{[^{}]*\}"
PUNCTUATION = (",", ".", ";")
CONDITION = "if"  # the text of a row token behind which a condition stands
_PATTERNS = re.compile(
    r"(?P<blank>\s+)"
    r"|(?P<empty>\\(?:left|right)\s*\.)"
    r"|(?P<bar>\\(?:left|right|bigl|bigr|big|Big)\s*(?:\\\||\\[lr]?[vV]ert(?![A-Za-z])|\|))"
    rf"|(?P<silent>{_SILENT})"
    rf"|(?P<gap>{_GAP})"
    r"|(?P<differential>\\mathrm\s*\{\s*d\s*\}|\\mathrm\s+d|\\partial(?![A-Za-z]))"
    r"|(?P<text>\\(?:text|textrm|mbox|mathrm|operatorname\*?|rm)\s*\{[^{}]*\}"
    rf"|\{{\s*\\rm\s+(?:{'|'.join(FUNCTION_WORDS)})\s*\}})"
    r"|(?P<begin>\\(?:begin|end)\s*\{[^{}]*\}(?:\[[tbc]\])?(?:\{(?:[lcr|]*|\d+)\})?)"
    r"|(?P<row>\\\\(?:\[[^\]]*\])?)"
    r"|(?P<command>\\(?:[A-Za-z]+|[|{}]))"
    r"|(?P<digit>[0-9])|(?P<mark>\{,\})|(?P<letter>[A-Za-z])"
    r"|(?P<sign>[-+*/=<>()\[\]{}|_^',.;&])"
)
_ALIASES = {
    r"\leq": r"\le", r"\geq": r"\ge", r"\neq": r"\ne", r"\lbrack": "[", r"\rbrack": "]",
    r"\vert": "|", r"\|": r"\Vert", r"\lVert": r"\lvert", r"\rVert": r"\rvert",
    r"\dfrac": r"\frac", r"\tfrac": r"\frac", r"\rightarrow": r"\to",
    r"\hslash": r"\hbar", r"\leqslant": r"\le", r"\geqslant": r"\ge",
    r"\mathbf": r"\boldsymbol", r"\bm": r"\boldsymbol", r"\overline": r"\bar",
    r"\mathscr": r"\mathcal", r"\cal": r"\mathcal", r"\widehat": r"\hat",
    r"\overrightarrow": r"\vec", "−": "-",
}  # fmt: skip
JOINING = frozenset({
    "and", "so that", "so", "hence", "thus", "therefore", "with", "where", "or", "i.e", "that is", "then", "also",
    "y", "de modo que", "luego", "por tanto", "por lo tanto", "con", "donde", "es decir", "entonces", "o sea",
})  # fmt: skip
CONDITIONAL = frozenset({
    "for", "if", "when", "as long as", "provided", "provided that", "para", "si", "cuando", "mientras", "siempre que",
})  # fmt: skip
_ENVIRONMENTS = frozenset({
    "aligned", "align", "align*", "eqnarray", "eqnarray*", "equation", "equation*", "split",
    "gathered", "gather", "gather*", "array", "cases", "alignedat",
})  # fmt: skip


@dataclass(frozen=True, slots=True)
class Token:
    """A token: `kind` is letter (with its character), digit, text, command, sign, row, ..."""

    kind: str
    text: str
    start: int
    end: int


def tokenize(source: Source, *, gaps: bool = False) -> tuple[Token, ...]:
    """The tokens of a LaTeX formula, with an end token; `gaps`: with wide spaces too. Raises ReadError, LimitError."""
    if len(source.text) > MAX_LENGTH:
        raise LimitError(
            f"the formula has {len(source.text)} characters; at most {MAX_LENGTH} are read",
            instead="Split it into smaller parts.",
        )
    found = (token for token in _tokens(source) if gaps or token.kind != "gap")
    return (*found, Token("end", "", len(source.text), len(source.text)))


def _tokens(source: Source) -> Iterator[Token]:
    position = 0
    while position < len(source.text):
        found = _PATTERNS.match(source.text, position)
        if found is None:
            yield _single(source, position)
            position += 1
            continue
        if found.lastgroup not in ("blank", "silent"):
            yield _token(source, found)
        position = found.end()


def _single(source: Source, position: int) -> Token:
    """A character beyond ASCII: a letter. Raises ReadError for others."""
    char = source.text[position]
    letter = SAME_LETTER.get(char, char)
    if char in _ALIASES:
        return Token("sign", _ALIASES[char], position, position + 1)
    if letter in NAME_OF_LETTER:
        return Token("letter", letter, position, position + 1)
    raise refused(source, char, position)


def _token(source: Source, found: re.Match[str]) -> Token:
    return _MAKERS.get(found.lastgroup, _plain)(source, found.lastgroup, found[0], *found.span())


def _plain(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    return Token("sign" if kind == "mark" else kind, text, start, end)


def _text(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    """Upright text; a word such as `and` between relations begins a new one."""
    word = re.search(r"\{(?:\s*\\rm)?([^{}]*)\}", text)[1].strip()
    if word in FUNCTION_WORDS and text.startswith((r"\mathrm", r"\operatorname", r"\rm", "{")):
        return Token("command", rf"\{word}", start, end)
    plain = "" if text.startswith((r"\mathrm", r"\operatorname")) else word.strip(" ,;:.")
    if plain in CONDITIONAL:
        return Token("row", CONDITION, start, end)
    return Token("row" if plain in JOINING else "text", word, start, end)


def _differential(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    return Token(kind, "∂" if "partial" in text else "d", start, end)


def _bar(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    right = text.startswith((r"\right", r"\bigr"))
    return Token("sign", r"\rvert" if right else r"\lvert", start, end)


def _empty(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    return Token("sign", re.sub(r"\s", "", text), start, end)


def _command(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    text = _ALIASES.get(text, text)
    letter = LETTERS.get(text[1:])
    if letter:
        return Token("letter", letter, start, end)
    return Token("command" if text.startswith("\\") else "sign", text, start, end)


def _environment(source: Source, kind: str, text: str, start: int, end: int) -> Token:
    name = re.search(r"\{([^{}]*)\}", text)[1]
    if name not in _ENVIRONMENTS:
        what = f"the environment “{name[:40]}” can't be read"
        raise source.error(what, start, end, "Use aligned, or write one formula.")
    return Token("begin", rf"\{text[1:].partition('{')[0].strip()}{{{name}}}", start, end)


_MAKERS = {
    "text": _text, "differential": _differential, "begin": _environment, "command": _command,
    "bar": _bar, "empty": _empty,
}  # fmt: skip
