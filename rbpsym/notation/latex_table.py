"""The state of a LaTeX reader and the table of what each command begins."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from rbpsym.notation import tree as t
from rbpsym.notation.cursor import Cursor
from rbpsym.notation.latex_tokens import Token
from rbpsym.notation.symbol_table import SymbolTable

Question = tuple[str, str, Token]  # what is asked, what to write instead, at which token


@dataclass(slots=True)
class Reader(Cursor[Token]):
    """A cursor with the symbols; `integrals` counts the integrals that wait for their dx.

    `bars` tells if a plain | would close. `script` says what to choose at the places that can be read in
    two ways (False at those behind its end), `met` their errors, `cost` how unusual what was chosen is.
    """

    table: SymbolTable | None = None
    integrals: int = 0
    bars: bool = False
    script: tuple[bool, ...] = ()
    met: list[Question] = field(default_factory=list)
    cost: int = 0

    def decide(self, what: str, instead: str, *, yes: int = 0, no: int = 0) -> bool:
        """Which of two readings to take here; each costs what it is unusual.

        Raises ReadError with the question if nothing is known by which to choose.
        """
        if self.table.faults is None:
            raise self.error(what, instead)
        chosen = len(self.met) < len(self.script) and self.script[len(self.met)]
        self.met.append((what, instead, self.token))
        self.cost += yes if chosen else no
        return chosen

    def sees_sign(self, *texts: str) -> bool:
        """Is the next token one of these signs or commands?"""
        return self.token.kind in ("sign", "command") and self.token.text in texts

    def pass_sign(self, *texts: str) -> bool:
        """Pass the next token if it is one of these signs or commands; was it?"""
        found = self.sees_sign(*texts)
        self.position += found
        return found

    def sees_differential(self, ahead: int = 0) -> bool:
        """Is the token (`ahead` places on) the d of a differential?"""
        token = self.ahead(ahead)
        italic = token.kind == "letter" and token.text == "d" and not self.table.has_d
        return italic or token.kind == "differential"

    def expect(self, text: str, opening: Token | None = None) -> None:
        """Pass the sign `text`. Raises ReadError if something else stands there."""
        if self.pass_sign(text):
            return
        if self.token.kind == "end" and opening:
            raise self.error(f"this “{opening.text}” is never closed", "", opening)
        raise self.error(f"“{self.token.text or 'the end'}” stands where “{text}” is expected")

    def spanned(self, node: t.Node, start: int) -> t.Node:
        """The node with its span from `start` to here."""
        return replace(node, span=(start, self.previous_end))


Read = Callable[[Reader], t.Node]
COMMANDS: dict[str, Read] = {}


def begins(*texts: str) -> Callable[[Read], Read]:
    """Enter a function that reads an atom which begins with one of these tokens."""

    def enter(function: Read) -> Read:
        COMMANDS.update(dict.fromkeys(texts, function))
        return function

    return enter
