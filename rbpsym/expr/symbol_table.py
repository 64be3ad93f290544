"""The symbols that a LaTeX formula may contain: drawn form -> name; the state of a reader, what each command begins."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any, TypeVar

from rbpsym.errors import ReadError, UnknownName
from rbpsym.expr.glyphs import DEFAULT, Glyph, Notation, glyph
from rbpsym.expr.latex.tokens import Token, tokenize
from rbpsym.expr.source import Cursor, SourceText
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, field


class Drawn(Frozen):
    """What a reader sees of a name; subscripts are one label without commas and braces."""

    base: str
    script: bool = False
    accent: str = ""
    dots: int = 0
    primes: int = 0
    label: str = ""
    prefix: str = ""


class SymbolTable(Frozen):
    """Names by their drawn form, and names by a row of tokens (`spellings`).

    `faults` counts where the dimensions of a formula do not fit; by it a reader chooses between two readings
    (None: it refuses what can be read in two ways). `varies` says whether a name is no constant, and so may be a
    function: in x(t), V(θ) (None: nothing is known). `directed`: is a name that of a vector, printed without an arrow?
    `comma`: in 1{,}470 it is declared to be the decimal mark. `open`: any letter is a name, and nothing is known of it; what
    stands in brackets behind it or is raised is then no factor or power, no pair a vector, no operator's reach known.
    `has_length`: the text itself uses a plain d as a symbol.
    """

    names: Mapping[Drawn, tuple[str, ...]]
    spellings: Mapping[tuple[str, ...], str] = field(default_factory=lambda: MappingProxyType({}))
    faults: Callable[[Node], int] | None = None
    varies: Callable[[str], bool] | None = None
    directed: Callable[[str], bool] = lambda name: False
    comma: bool = False
    open: bool = False
    has_length: bool = False

    @property
    def has_d(self) -> bool:
        """Is a plain d a symbol, so that only an upright d is a differential?"""
        return self.has_length or any(drawn.base == "d" for drawn in self.names)

    @property
    def has_e(self) -> bool:
        """Is e a symbol, so that it is not the base of the exponential function?"""
        return any(drawn.base == "e" for drawn in self.names) or any("e" in row[:1] for row in self.spellings)

def equally(node: Node) -> int:
    """Faults that prefer no reading: for one who wants to see them all."""
    return 0


def drawn_glyph(drawing: Glyph) -> Drawn:
    """What a reader sees of a glyph."""
    label = "".join(_label(sub) for sub in drawing.subs)
    return Drawn(
        drawing.base, drawing.style == "script", drawing.accent, drawing.dots, drawing.primes,
        label, drawing.prefix,
    )  # fmt: skip


def _label(sub: Glyph) -> str:
    return sub.base + "".join(_label(part) for part in sub.subs) + "'" * sub.primes


def symbol_table(
    names: Iterable[str] | Mapping[str, str],
    notation: Notation = DEFAULT,
    spellings: Mapping[str, str] = MappingProxyType({}),
    faults: Callable[[Node], int] | None = None,
) -> SymbolTable:
    """The table of some names as `notation` draws them; `pi` is always known.

    `spellings` adds other LaTeX for a name, read exactly as written (spaces apart):
    `{r"\\mathcal{W}^{nc}_T": "W_T_nc"}`; `faults` is that of the table. A mapping in place of `names` gives only spellings.
    Raises ReadError if a spelling can't be split into tokens.
    """
    if isinstance(names, Mapping):
        spellings = {**names, **spellings}
        names = tuple(names.values())
    found: dict[Drawn, tuple[str, ...]] = {}
    for name in dict.fromkeys((*names, "pi")):
        for drawing in dict.fromkeys((notation.glyph(name), glyph(name))):
            _enter(found, drawn_glyph(drawing), name, notation.aliases)
    spelled = {spelling(tokenize(SourceText(latex))[:-1]): name for latex, name in spellings.items()}
    return SymbolTable(MappingProxyType(found), MappingProxyType(spelled), faults, comma=notation.decimal == ",")


def _enter(found: dict[Drawn, tuple[str, ...]], drawn: Drawn, name: str, aliases: Mapping[str, str]) -> None:
    """Enter a name; the own print of a name that has an alias gives way to others."""
    others = found.get(drawn, ())
    if name in others or (others and name in aliases and drawn != drawn_glyph(glyph(aliases[name]))):
        return
    found[drawn] = (*others, name)


def spelling(tokens: Iterable[Token]) -> tuple[str, ...]:
    """The tokens as they are compared, without needless braces around one token."""
    texts = [token.text for token in tokens]
    kept: list[str] = []
    while texts:
        single = texts[0] == "{" and len(texts) > 2 and texts[2] == "}"
        kept.append(texts[1] if single else texts[0])
        texts = texts[3:] if single else texts[1:]
    return tuple(kept)


Question = tuple[str, str, Token]  # what is asked, what to write instead, at which token


class LatexReader(Cursor[Token]):
    """A cursor with the symbols; `integrals` counts the integrals that wait for their dx; `path` is what
    stood behind the d in a numerator, `over` the variable of the last integral.

    `bars` tells if a plain | would close. `script` says what to choose at the places that can be read in
    two ways (False at those behind its end), `met` their errors, `cost` how unusual what was chosen is.
    """

    table: SymbolTable = field(default_factory=lambda: SymbolTable({}))
    integrals: int = 0
    bars: bool = False
    script: tuple[bool, ...] = ()
    met: list[Question] = field(default_factory=list)
    cost: int = 0
    path: Node | None = None
    over: str = ""

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
        token = self.token
        return token.kind in ("sign", "command") and token.text in texts

    def pass_sign(self, *texts: str) -> bool:
        """Pass the next token if it is one of these signs or commands; was it?"""
        found = self.sees_sign(*texts)
        self.position += found
        return found

    def sees_differential(self, ahead: int = 0) -> bool:
        """Is the token (`ahead` places on) the d of a differential?"""
        token = self.ahead(ahead)
        if token.kind != "letter" or token.text != "d" or self.table.has_d:
            return token.kind == "differential"
        behind = self.ahead(ahead + 1)
        if behind.text == "/" and self.ahead(ahead + 2).kind != "end":  # d/dt
            return self.sees_differential(ahead + 2)
        return behind.kind in ("letter", "text") or behind.text in _DIFFERENTIATED

    def expect(self, text: str, opening: Token | None = None) -> None:
        """Pass the sign `text`. Raises ReadError if something else stands there."""
        if self.pass_sign(text):
            return
        if self.token.kind == "end" and opening:
            raise self.error(f"this “{opening.text}” is never closed", "", opening)
        kind = UnknownName if self.token.kind == "command" else ReadError
        raise self.error(f"“{self.token.text or 'the end'}” stands where “{text}” is expected", kind=kind)


_ACCENTED = (r"\vec", r"\boldsymbol", r"\dot", r"\ddot", r"\hat", r"\bar", r"\tilde", r"\mathcal", r"\mathfrak")
_DIFFERENTIATED = frozenset(("(", "^", "{", "}", *_ACCENTED))  # what a differential d may stand before
F = TypeVar("F", bound=Callable[..., Any])
COMMANDS: dict[str, Callable[..., Node]] = {}  # what begins so, read from there; some say None where it does not stand there


def begins(*texts: str) -> Callable[[F], F]:
    """Enter a function that reads an atom which begins with one of these tokens."""

    def enter(function: F) -> F:
        COMMANDS.update(dict.fromkeys(texts, function))
        return function

    return enter
