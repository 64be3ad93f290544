r"""Typst's math -> LaTeX, for the one reader of formulas; what it does not know becomes a command that is refused there.

Fractions, attachments and calls bind as Typst binds them: `a(b)/c` is (a(b))/c, the parentheses of `(a + b)/c` and `x_(i j)`
are not printed.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from rbpsym.expr.hyperbolic import FUNCTION_WORDS
from rbpsym.expr.letters import LETTERS
from rbpsym.expr.typst_names import CALLS, NAMES, ROWS, SIGNS, UNBALANCED

DEEPEST = 40
_TOKEN = re.compile(
    r"(?P<space>\s+)|(?P<text>\"(?:[^\"\\]|\\.)*+\")|(?P<row>\\(?=\s|\Z))|(?P<escape>\\.)"
    r"|(?P<gap>#h\([^()\n]*+\))|(?P<code>#[A-Za-z][\w-]*+(?:\((?:[^()\n\"]|\"[^\"\n]*+\")*+\)|\[[^\[\]\n]*+\])+)|#<(?P<label>[\w:.-]{1,200})>"
    r"|(?P<name>(?:[A-Za-z]|#(?=[A-Za-z]+(?![\w.(\[-])))[A-Za-z]+(?:\.[A-Za-z]+)*)|(?P<number>\d+(?:\.\d+)?)"
    r"|(?P<sign><==>|<=>|==>|=>|-->|->|\|->|<--|<->|<==|<-|<=|>=|!=|::=|:=|=:|<<|>>|\|\||\.\.\.)|(?P<char>.)",
    re.S,
)
_OPEN = {"(": ")", "[": "]", "{": "}"}
Tokens = list[tuple[str, str]]


def typst_to_latex(text: str, own: Collection[str] = (), given: Sequence[str] = ()) -> str:
    """The LaTeX of a formula between dollar signs; lines stay lines.

    own: names that the text defines; given: those of the arguments of what is defined by the formula, here #1, #2.
    """
    return _Reader([(found.lastgroup or "", found[0]) for found in _TOKEN.finditer(text)], own, given).whole()


class _Reader:
    """One pass over the tokens."""

    def __init__(self, tokens: Tokens, own: Collection[str], given: Sequence[str]) -> None:
        self.tokens, self.place, self.depth = tokens, 0, 0
        self.own, self.given = own, given

    def whole(self) -> str:
        """All of it; a bracket that was never opened stands as it is."""
        made = self._sequence("")
        while self.place < len(self.tokens):
            made += self._take()[1] + self._sequence("")
        return made

    def _take(self) -> tuple[str, str]:
        self.place += 1
        return self.tokens[self.place - 1]

    def _at(self, *texts: str) -> bool:
        return self.place < len(self.tokens) and self.tokens[self.place][1] in texts

    def _sequence(self, ends: str) -> str:
        """What stands up to one of some characters, or a closing bracket."""
        pieces: list[str] = []
        while self.place < len(self.tokens) and not self._at(*ends, ")", "]"):
            kind, text = self.tokens[self.place]
            if kind == "space":
                self.place += 1
                pieces.append(text)
            else:
                pieces.append(self._quotient())
        return "".join(pieces)

    def _spaces(self) -> str:
        start = self.place
        while self.place < len(self.tokens) and self.tokens[self.place][0] == "space":
            self.place += 1
        return "".join(text for _, text in self.tokens[start : self.place])

    def _quotient(self) -> str:
        made, bare = self._attached()
        while True:
            start, gap = self.place, self._spaces()
            if not self._at("/"):
                self.place = start
                return made
            self.place += 1
            gap += self._spaces()
            _, below = self._attached() if self.place < len(self.tokens) else ("", UNBALANCED)
            made = bare = rf"\frac{{{bare}}}{{{below}}}" + "\n" * gap.count("\n")

    def _attached(self, *stops: str) -> tuple[str, str]:
        """A thing with its subscripts, exponents and primes: as it stands, and in a fraction, without parentheses round all.

        What is attached may have things attached itself, up to `stops`: x_a^b_c raises b_c, and x^n! is (xⁿ)!.
        """
        made, bare = self._thing()
        while self._at("_", "^", "'", "!") and not self._at(*stops):
            sign = self._take()[1]
            if sign not in ("'", "!"):
                other = "_" if sign == "^" else "^"
                sign += self._script(other)
                sign += self._take()[1] + self._script("") if self._at(other) else ""
            made = bare = made + sign
        return made, bare

    def _script(self, stop: str) -> str:
        self._spaces()
        self.depth += 1
        made = self._attached(stop, "!")[1] if self.place < len(self.tokens) else UNBALANCED
        self.depth -= 1
        return f"{{{made}}}"

    def _thing(self) -> tuple[str, str]:
        kind, text = self._take()
        self.depth += 1
        if self.depth > DEEPEST:
            self.place = len(self.tokens)
            return UNBALANCED, UNBALANCED
        made = bare = self._named(text) if kind == "name" else _plain(kind, text)
        if kind == "char" and text in _OPEN:
            inner = self._inner(_OPEN[text])
            made, bare = f"{made}{inner}{_plain('char', _OPEN[text])}", inner if text == "(" else f"{made}{inner}{_OPEN[text]}"
        elif (kind == "name" or text.isalpha()) and self._at("("):
            made = bare = made + self._thing()[0]
        self.depth -= 1
        return made, bare

    def _inner(self, end: str) -> str:
        inner = self._sequence(end)
        if not self._at(end):
            return inner + UNBALANCED
        self.place += 1
        return inner

    def _named(self, name: str) -> str:
        """A letter, sign or function by its name, with its arguments if it is a command that takes them."""
        hashed, name = name.startswith("#"), name.removeprefix("#")
        if name in self.given and (hashed or len(name) > 1):
            return f"#{self.given.index(name) + 1} "
        if name in self.own:
            return rf"\{name} "
        if self._at("(") and name in ROWS:
            rows = [" & ".join(row) for row in self._arguments()]
            return rf"\begin{{{ROWS[name]}}}" + r" \\ ".join(rows) + rf"\end{{{ROWS[name]}}}"
        if self._at("(") and (drawn := CALLS.get(name)):
            given = [part for row in self._arguments() for part in row]
            if not isinstance(drawn, str):
                return drawn(*given)
            return drawn % tuple(given) if len(given) == drawn.count("%s") else UNBALANCED
        if name in CALLS and name not in NAMES:
            return UNBALANCED
        if len(name) == 2 and name[0] == name[1] and name.isupper() and name not in NAMES:
            return rf"\mathbb{{{name[0]}}} "
        base, _, changed = name.partition(".")
        if name in FUNCTION_WORDS or (base in LETTERS and changed in ("", "alt")):
            return rf"\{base} "
        return NAMES.get(name, "\\" + name.replace(".", "")) + " "

    def _arguments(self) -> Iterator[list[str]]:
        """The arguments in parentheses; `;` ends a row of a matrix (of a column, each comma does)."""
        column = self.tokens[self.place - 1][1] != "mat"
        self.place += 1
        row: list[str] = []
        while True:
            named = self._passed_name()
            cell = self._sequence(",;").strip(" ")
            row += [] if named else [cell]
            if not self._at(",", ";"):
                break
            if self._take()[1] == ";" or column:
                yield row
                row = []
        closed = self._at(")")
        self.place += closed
        yield row if closed else [*row, UNBALANCED]

    def _passed_name(self) -> bool:
        """Pass `delim:` in front of an argument that tells how something is drawn."""
        self._spaces()
        ahead = self.tokens[self.place : self.place + 2]
        named = len(ahead) == 2 and ahead[0][1].isalpha() and ahead[1][1] == ":"
        self.place += 2 * named
        return named


def _plain(kind: str, text: str) -> str:
    """A string, an escaped character, a gap, a label, the end of a row, or what stands for itself."""
    if kind == "code":
        return r"\drawn{" + re.sub(r"\W+", " ", text).strip() + "}"
    if kind == "gap":
        return r"\quad "
    if kind == "label":
        return rf"\label{{{text[2:-1]}}}"
    if kind == "text":
        return r"\text{" + re.sub(r"[\\{}$%#&_^]", " ", text[1:-1]) + "}"
    if kind == "row":
        return r"\\"
    return SIGNS.get(text, text) if kind != "escape" else {"/": "/", "\\": r"\backslash "}.get(text[1], rf"\{text[1]}")
